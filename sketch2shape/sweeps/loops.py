"""Loops: closed lines of a drawing that may be the outlines of faces, as they are drawn, straight or not.

Three sources. What the ink encloses; ellipses that bowed lines belong to, wherever other lines cross or hide parts of
them; and, where all edges are drawn, the ink that lies again on ink when it is moved to the back face.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import cv2
import numpy as np

from sketch2shape.geometry import cross
from sketch2shape.model import Bools, Floats, Gray, Ints, as_gray
from sketch2shape.strokes import Skeleton
from sketch2shape.sweeps.insides import Inside
from sketch2shape.sweeps.linked import linked

PROBES = 64
"""Points that stand for a loop where it is moved."""
CORNER, STRAY = 0.5, 0.012
"""Angle of a corner, radians, and fraction of a loop's size by which the chords that tell it stray from the line."""
LEAST_AREA = 2e-4
"""Part of the square of the drawing's size that a loop encloses at least."""
MOST_LOOPS = 24
"""Loops of one source, the largest."""
LEAST_BOW = 0.06
"""Height of a bowed line over its chord from which it can be an arc of some turn."""
LEAST_PATH = 0.05
"""Length over the drawing's size from which a line may be an arc."""
LEAST_COHERENT = 0.025
"""Extent of a line that lies on ink when it is moved, over the drawing's size: a small hole."""
MOST_ELLIPSES = 10
"""Ellipses that are looked at, those with the most ink."""
ELLIPSE_POINTS = 320
"""Points that stand for an ellipse."""
JOINT_GAPS = (3.0, 10.0)
"""Half the gap, pixels, that is closed where other lines meet the one that is followed: one that runs into it at a
small angle draws the thinned line aside."""
LEAST_COVERED = 0.42
"""Part of an ellipse that lies on ink: about half may be hidden."""


@dataclass(frozen=True, eq=False)
class Loop:
    """A closed line, with what is asked of it again and again.

    line : (k, 2) float, pixels
    """

    line: Floats

    @cached_property
    def inside(self) -> Inside:
        """What it encloses."""
        return Inside.of([self.line])

    @property
    def area(self) -> float:
        """Square pixels that it encloses."""
        return float(cv2.contourArea(self.line.astype(np.float32)))

    @cached_property
    def probes(self) -> Floats:
        """(PROBES, 2) of its points."""
        return np.asarray(self.line[np.linspace(0, len(self.line), PROBES, endpoint=False).astype(np.intp)])

    @cached_property
    def corners(self) -> Ints:
        """(c,) int, the points at which it turns sharply."""
        return _corners(self.line, is_closed=True)


def _corners(line: Floats, *, is_closed: bool) -> Ints:
    """(c,) int, the points (k, 2) of a line at which it turns sharply."""
    stray = STRAY * float(np.hypot(*np.ptp(line, axis=0)))
    chords = cv2.approxPolyDP(line.astype(np.float32)[:, None], stray, is_closed)
    bends = np.asarray(chords[:, 0], float)
    before, after = bends - np.roll(bends, 1, axis=0), np.roll(bends, -1, axis=0) - bends
    turn = np.abs(np.arctan2(cross(before, after), (before * after).sum(axis=1)))
    if not is_closed:
        turn[[0, -1]] = 0.0
    sharp = bends[turn > CORNER]
    return np.asarray([int(np.hypot(*(line - b).T).argmin()) for b in sharp], np.intp)


def enclosed_loops(ink: Bools, pen: float) -> list[Floats]:
    """Borders (k, 2) of what the ink encloses, along the middle of its lines, a pixel apart, the largest first."""
    grown = cv2.copyMakeBorder(ink.view(np.uint8), 2, 2, 2, 2, cv2.BORDER_CONSTANT)
    _, labels, stats, _ = cv2.connectedComponentsWithStats(1 - grown, connectivity=4)
    h, w = ink.shape
    least = max(LEAST_AREA * (h * h + w * w), 4 * pen * pen)
    order = [k for k in np.argsort(-stats[1:, cv2.CC_STAT_AREA]) + 1 if stats[k, cv2.CC_STAT_AREA] >= least]
    outside = labels[0, 0]
    loops = []
    for k in [k for k in order if k != outside][:MOST_LOOPS]:
        x, y, wide, high = stats[k, :4]
        part = as_gray(np.pad(labels[y : y + high, x : x + wide] == k, int(pen) + 3).astype(np.uint8))
        loops.append(border(_grown(part, 0.5 * pen)) + [x - int(pen) - 5, y - int(pen) - 5])
    # what lies between an outline and a hole has a small area, and the outline for its border
    return sorted((p for p in loops if len(p) >= 12), key=lambda p: -cv2.contourArea(p.astype(np.float32)))


def _grown(part: Gray, by: float) -> Gray:
    return as_gray((cv2.distanceTransform(1 - part, cv2.DIST_L2, cv2.DIST_MASK_5) <= by).astype(np.uint8))


def border(part: Gray) -> Floats:
    """(k, 2) the outermost pixels of the largest region of a mask, in order."""
    contours, _ = cv2.findContours(part, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    return np.asarray(max(contours, key=len)[:, 0], float)


def ellipses(skeleton: Skeleton, size: float) -> list[Floats]:
    """Ellipses (k, 2) that bowed lines of the drawing lie on, those with the most ink first.

    What lines tell that are put together from pieces counts where none of the pieces tells the same.
    """
    found: list[tuple[float, Floats, tuple[float, ...]]] = []
    least = LEAST_PATH * size
    for lines in (skeleton.paths, linked(skeleton.paths, size, skeleton.pen_width)):
        bowed = [run for line in lines for run in _windows(line, least) if _is_bowed(run, least)]
        for path in sorted(bowed, key=len, reverse=True)[: 6 * MOST_ELLIPSES]:
            grown = _grown_ellipse(path.astype(float), skeleton, size)
            if grown is None:
                continue
            line, covered, told = grown
            if covered >= LEAST_COVERED and all(_differ(told, t, size) for _, _, t in found):
                found.append((covered * len(path), line, told))
    found.sort(key=lambda f: -f[0])
    return [line for _, line, _ in found[:MOST_ELLIPSES]]


def _windows(path: np.ndarray, least: float) -> Iterator[np.ndarray]:
    """A line, and parts of it: an arc may run on into straight lines, round a corner or smoothly."""
    yield path
    corners = np.sort(_corners(path, is_closed=False))
    if len(corners):
        yield from np.split(path, corners)
    for part in (2, 4):
        long = len(path) // part
        if long < 2 * least:
            return
        for start in range(0, len(path) - long + 1, max(long // 2, 1)):
            yield path[start : start + long]


def _is_bowed(path: np.ndarray, least: float) -> bool:
    if len(path) < max(least, 8):
        return False
    a, b = path[0].astype(float), path[-1].astype(float)
    chord = b - a
    long = float(np.hypot(*chord))
    off = np.abs((path[:, 0] - a[0]) * chord[1] - (path[:, 1] - a[1]) * chord[0]) / max(long, 1e-9)
    return long < 0.3 * len(path) or float(off.max()) > LEAST_BOW * long


def _grown_ellipse(points: Floats, skeleton: Skeleton, size: float) -> tuple[Floats, float, tuple[float, ...]] | None:
    """The ellipse through a bowed line and all the ink that lies along it, and the part of it that has ink."""
    near = max(2.0, 0.006 * size, 0.5 * skeleton.pen_width)
    told: tuple[float, ...] | None = None
    for reach in (near, 1.5 * near, near):
        fitted = _fitted(points)
        if fitted is None or max(fitted[2:4]) > size or min(fitted[2:4]) < 0.01 * size:
            return None
        told = fitted
        off = _off_ellipse(skeleton.points, told)
        points = skeleton.points[np.abs(off) <= reach]
        if len(points) < 8:
            return None
    if told is None:
        return None
    line = ellipse_line(told)
    x, y = np.round(line).astype(np.intp).T
    h, w = skeleton.distance.shape
    inside = (x >= 0) & (y >= 0) & (x < w) & (y < h)
    covered = inside & (skeleton.distance[np.clip(y, 0, h - 1), np.clip(x, 0, w - 1)] <= near)
    return line, float(covered.mean()), told


def _fitted(points: Floats) -> tuple[float, ...] | None:
    """Centre, half axes and angle (radians) of the ellipse through points (A. Fitzgibbon and others, TPAMI 1999)."""
    if len(points) < 8:
        return None
    (cx, cy), (a, b), angle = cv2.fitEllipseDirect(points[:: max(1, len(points) // 400)].astype(np.float32))
    told = (float(cx), float(cy), 0.5 * float(a), 0.5 * float(b), float(np.radians(angle)))
    return told if np.isfinite(told).all() and min(told[2:4]) > 1.0 else None


def _off_ellipse(points: Floats, told: tuple[float, ...]) -> Floats:
    """About how far points lie outside an ellipse, pixels."""
    cx, cy, a, b, angle = told
    c, s = np.cos(angle), np.sin(angle)
    x, y = (points - [cx, cy]).T
    u, v = (c * x + s * y), (-s * x + c * y)
    level = (u / a) ** 2 + (v / b) ** 2
    slope = 2 * np.sqrt((u / a**2) ** 2 + (v / b**2) ** 2) + 1e-9
    return np.asarray((level - 1) / slope)


def ellipse_line(told: tuple[float, ...]) -> Floats:
    """(ELLIPSE_POINTS, 2) points of an ellipse."""
    cx, cy, a, b, angle = told
    t = np.linspace(0, 2 * np.pi, ELLIPSE_POINTS, endpoint=False)
    c, s = np.cos(angle), np.sin(angle)
    u, v = a * np.cos(t), b * np.sin(t)
    return np.stack([cx + c * u - s * v, cy + s * u + c * v], axis=1)


def _differ(a: tuple[float, ...], b: tuple[float, ...], size: float) -> bool:
    return float(np.hypot(a[0] - b[0], a[1] - b[1])) + abs(a[2] - b[2]) + abs(a[3] - b[3]) > 0.02 * size


def coherent_loops(skeleton: Skeleton, shift: Floats, reach: float, size: float) -> list[Floats]:
    """Closed lines of the ink that lies on ink again when it is moved, the largest first.

    shift : (2,) float, pixels, or (k, 2), of each point of ink
    reach : pixels
    size  : of the drawing, pixels
    """
    h, w = skeleton.mask.shape
    own = skeleton.points.astype(np.intp)
    at = np.rint(skeleton.points + shift).astype(np.intp)
    inside = (at >= 0).all(axis=1) & (at[:, 0] < w) & (at[:, 1] < h)
    at[~inside] = 0
    on = inside & (skeleton.distance[at[:, 1], at[:, 0]] <= reach)
    kept = np.zeros((h, w), np.uint8)
    kept[own[on, 1], own[on, 0]] = 1
    for gap in JOINT_GAPS:
        loops = _closed_loops(kept, gap + 0.5 * skeleton.pen_width, LEAST_COHERENT * size)
        if loops:
            return loops
    return []


def _closed_loops(kept: Gray, gap: float, least: float) -> list[Floats]:
    """Closed lines of pixels of a skeleton, gaps of twice so many pixels closed, pieces shorter than least left out."""
    side = 2 * int(gap) + 1
    # with room around: what is closed at the border of a picture runs on to it
    roomy = cv2.copyMakeBorder(kept, side, side, side, side, cv2.BORDER_CONSTANT)
    closed = cv2.morphologyEx(roomy, cv2.MORPH_CLOSE, np.ones((side, side), np.uint8))
    _, labels, stats, _ = cv2.connectedComponentsWithStats(closed, connectivity=8)
    # lines that only cross others stay on ink for a moment
    long = np.hypot(stats[:, cv2.CC_STAT_WIDTH], stats[:, cv2.CC_STAT_HEIGHT]) > least
    long[0] = False
    return [loop - side for loop in enclosed_loops(long[labels], 1.0)]
