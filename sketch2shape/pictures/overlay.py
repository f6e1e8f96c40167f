"""The object drawn over the drawing: says at a glance whether the answer is right."""

from __future__ import annotations

import cv2
import numpy as np

from sketch2shape.evidence import unexplained_strokes
from sketch2shape.ink import find_ink
from sketch2shape.model import Answer, Solid, TwoFaceObject
from sketch2shape.pictures.canvas import Canvas, Pixels, fit, text_width
from sketch2shape.pictures.palette import BACK, BACKDROP, FAILED, FRONT, INK, JOIN, MUTED, PAPER, RULE, Colour
from sketch2shape.solids import DrawnLine, drawn_lines

_SMALLEST, _LARGEST = 720, 2400  # longer side of the overlay, pixels: small drawings are enlarged, huge ones reduced


def overlay(result: Answer, *, legend: bool = True) -> Pixels:
    """The picture, paled, with each object's faces and edges in their colours and a line of words below.

    The strokes that a guess, which is not trusted (`NoObjectError.guess`), leaves out are marked.

    legend : leave the words out if False, as for a thumbnail

    Returns (h, w, 3) uint8 RGB; the longer side is kept between 720 and 2400 pixels.
    """
    w, h = result.picture.size
    scale = np.clip(max(h, w), _SMALLEST, _LARGEST) / max(h, w)
    paled, _ = fit(pale(result.picture.pixels), round(w * scale), round(h * scale))
    h, w = paled.shape[:2]
    unit = max(1.0, max(h, w) / 1000)
    strip = round(34 * unit)
    rows = max(1, len(result.objects)) if legend else 0
    canvas = Canvas(w, h + strip * rows, BACKDROP)
    canvas.paste(paled, 0, 0)
    canvas.view(float(scale), (scale / 2 - 0.5, scale / 2 - 0.5))
    for obj, solid in zip(result.objects, result.solids, strict=True):
        draw_object(canvas, obj, solid, unit)
    if result.error is not None:
        for a, b in unexplained_strokes(find_ink(result.picture), result.objects):
            canvas.line(a, b, FAILED, 9 * unit, alpha=0.45)
    canvas.view()
    if legend:
        _legend(canvas, result, h, strip, unit)
    return canvas.finish()


def draw_object(canvas: Canvas, obj: TwoFaceObject, solid: Solid, unit: float = 1.0) -> None:
    """Draw an object, lifted to this solid, in the canvas's view; `unit` scales line widths."""
    front = sum(len(pair.f1) for pair in obj.rings)
    canvas.fill(obj.outlines("f1"), FRONT, 0.16)
    lines = [(_colour(line, solid, front), line) for line in drawn_lines(obj, solid)]
    for colour, line in sorted(lines, key=lambda pair: pair[0] == FRONT):
        _draw_line(canvas, line, colour, unit)
    for v, at in enumerate(obj.vertices):
        canvas.dot(at, 3.6 * unit, FRONT if v < front else BACK, rim_width=1.3 * unit)


def pale(pixels: Pixels, part: float = 0.45) -> Pixels:
    """The picture, mixed with white so that coloured lines stand out; dark pictures are turned negative first."""
    if float(pixels.mean()) < 110:
        gray = cv2.cvtColor(pixels, cv2.COLOR_RGB2GRAY)
        pixels = cv2.cvtColor(255 - gray, cv2.COLOR_GRAY2RGB).astype(np.uint8)
    return cv2.addWeighted(pixels, 1 - part, np.full_like(pixels, 255), part, 0).astype(np.uint8)


def _colour(line: DrawnLine, solid: Solid, front: int) -> Colour:
    """Of an edge of the front face, of the back face, or of one that joins them, as outlines of curved sides do."""
    if line.edge is None:
        return JOIN
    edge = solid.edges[line.edge]
    if edge.start is None or edge.end is None:
        inside = any(line.edge == step.edge for loop in solid.faces[0].loops for step in loop)
        return FRONT if inside else BACK
    if edge.start >= front:
        return BACK
    return JOIN if edge.end >= front else FRONT


def _draw_line(canvas: Canvas, line: DrawnLine, colour: Colour, unit: float) -> None:
    if line.visible:
        canvas.path(line.points, PAPER, 4.6 * unit, alpha=0.7)
        canvas.path(line.points, colour, 2.6 * unit)
    else:
        canvas.path(line.points, PAPER, 4.6 * unit, alpha=0.55)
        canvas.path(line.points, colour, 1.9 * unit, dash=(6.5 * unit, 5 * unit))


def _legend(canvas: Canvas, result: Answer, top: int, height: int, unit: float) -> None:
    """A line of words for each object under the picture."""
    canvas.box(0, top, canvas.width, unit, RULE)
    for row, (solid, confidence) in enumerate(zip(result.solids, result.confidences, strict=True)):
        name = solid.projection.family if result.error is None else "a guess"
        _legend_row(canvas, f"{name}, confidence {confidence:.2f}", top + height * (row + 0.5), unit)
    if not result.objects:
        canvas.words((17 * unit, top + height / 2), "no two-face object found", 14 * unit, MUTED, "lm")


def _legend_row(canvas: Canvas, words: str, y: float, unit: float) -> None:
    size, x = 14 * unit, 17 * unit
    for label, colour in (("front f1", FRONT), ("back f2", BACK), ("connecting", JOIN)):
        canvas.box(x, y - 1.5 * unit, 18 * unit, 3 * unit, colour)
        canvas.words((x + 24 * unit, y), label, size, INK, "lm")
        x += 24 * unit + text_width(label, size) + 20 * unit
    if x + text_width(words, size) < canvas.width - 17 * unit:
        canvas.words((canvas.width - 17 * unit, y), words, size, MUTED, "rm")
