"""Ink of a vector drawing: its lines are known, so nothing has to be found; a mask of them is drawn once."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import replace

import cv2
import numpy as np

from sketch2shape.model import Bools, Floats, Ink, VectorDrawing, VectorLine, as_gray

RULED, BY_HAND = 560.0, 330.0
"""Working pixels along the diagonal of what is drawn: as on the sheets with which all tolerances were chosen; fewer for
lines of a hand, whose wobble then is as many pixels wide as those tolerances."""
STRAIGHT, LONG, MOSTLY = 2e-4, 0.05, 0.8
"""Lines are ruled if they are straight, to within this part of the diagonal, for this part of it at a stretch, in this
part of their length."""
PEN = 2.0
"""Working pixels of the pen with which the mask is drawn: a fine one."""
MARGIN = 12
"""Empty working pixels around what is drawn."""
DASH, GAP = 10.0, 7.0
"""Working pixels drawn and left out of a dashed line, whatever the file's own dashes are: pieces no one overlooks."""
SPECK = 0.5
"""Working pixels up to which a line is a dot."""
_SHIFT = 4
"""Binary digits of a pixel to which OpenCV draws."""


def ink_of_lines(drawing: VectorDrawing) -> Ink:
    """The ink of a vector drawing; its lines in an order and a direction that depend on where they lie alone."""
    points = np.concatenate([line.points for line in drawing.lines] or [np.zeros((0, 2))])
    if not len(points):
        return Ink(np.zeros((1, 1), np.bool_), np.zeros((1, 1), np.uint8), 1.0, lines=())
    low, span = points.min(axis=0), np.ptp(points, axis=0)
    diagonal = max(float(np.hypot(*span)), 1e-9)
    scale = (RULED if is_ruled(drawing.lines, diagonal) else BY_HAND) / diagonal
    origin = low - MARGIN / scale
    lines = [line.mapped(origin, scale) for line in drawing.lines]
    settled = sorted((_settled(line) for line in lines), key=lambda line: line.points[[0, -1]].ravel().tolist())
    width, height = (int(n) for n in np.ceil(span * scale) + 2 * MARGIN + 1)
    mask = np.asarray(drawn([p for line in settled for p in strokes_of(line)], (height, width)), np.bool_)
    at = (float(origin[0] - 0.5 / scale), float(origin[1] - 0.5 / scale))
    return Ink(mask, as_gray(mask.view(np.uint8) * 255), PEN, scale, origin=at, lines=tuple(settled))


def is_ruled(lines: Iterable[VectorLine], diagonal: float) -> bool:
    """Whether most of what is drawn, on a sheet of this diagonal, is straight, or a curve of a program."""
    ruled = every = 0.0
    for line in lines:
        length = _length(line.points)
        if length < LONG * diagonal:
            continue  # a dash, which tells nothing
        every += length
        if line.curved or len(line.points) == 2:
            ruled += length
            continue
        placed = ((line.points - line.points[0]) / diagonal).astype(np.float32)
        chords = cv2.approxPolyDP(placed[:, None], STRAIGHT, False)[:, 0]
        lengths = np.hypot(*np.diff(chords, axis=0).T)
        ruled += diagonal * float(lengths[lengths > LONG].sum())
    return ruled >= MOSTLY * every


def _length(points: Floats) -> float:
    if len(points) == 2:
        return math.hypot(*(points[1] - points[0]).tolist())
    return float(np.hypot(*np.diff(points, axis=0).T).sum())


def _settled(line: VectorLine) -> VectorLine:
    """The line from its lesser end to its greater one: a pen may have drawn it either way."""
    ends = line.points[[0, -1]].tolist()
    return line if ends[0] <= ends[1] else replace(line, points=line.points[::-1])


def strokes_of(line: VectorLine) -> list[Floats]:
    """What the pen draws of a line: all of it, or its dashes, the last of which reaches the end."""
    if not line.dashed:
        return [line.points]
    steps = np.append(0.0, np.cumsum(np.hypot(*np.diff(line.points, axis=0).T)))
    total = float(steps[-1])
    count = max(1, round((total + GAP) / (DASH + GAP)))
    stretch = total / (count * (DASH + GAP) - GAP)
    starts = np.arange(count) * (DASH + GAP) * stretch
    return [_part(line.points, steps, start, start + DASH * stretch) for start in starts.tolist()]


def _part(points: Floats, steps: Floats, start: float, end: float) -> Floats:
    """The part of a polyline between two lengths along it."""
    inside = steps[(steps > start) & (steps < end)]
    at = np.concatenate([[start], inside, [end]])
    return np.stack([np.interp(at, steps, points[:, 0]), np.interp(at, steps, points[:, 1])], axis=1)


def drawn(paths: list[Floats], shape: tuple[int, int], pen: int = int(PEN)) -> Bools:
    """(h, w) bool, polylines drawn with a pen so many pixels wide."""
    canvas = np.zeros(shape, np.uint8)
    fixed = [np.rint(path * 2**_SHIFT).astype(np.int32) for path in paths]
    cv2.polylines(canvas, fixed, False, 1, pen, cv2.LINE_8, _SHIFT)
    return canvas.view(np.bool_)
