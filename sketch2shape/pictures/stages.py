"""One sheet that shows how the answer came about, panel by panel, in the order of the paper's results table.

Input, vertices and regions, f1, f2, both faces, each face connected, complete object, and the solid.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from sketch2shape.model import Answer, Floats, Side, Solid, TwoFaceObject
from sketch2shape.pictures.canvas import Canvas, Pixels, fit
from sketch2shape.pictures.overlay import draw_object
from sketch2shape.pictures.palette import BACK, BACKDROP, FRONT, INK, MUTED, PAPER, RULE, Colour, mix
from sketch2shape.pictures.preview import preview_of

_SIDES: tuple[tuple[Side, Colour], ...] = (("f1", FRONT), ("f2", BACK))
_WIDTH, _HEIGHT, _GAP, _CAPTION, _COLUMNS = 440, 340, 20, 40, 4


@dataclass(frozen=True)
class Stage:
    """One panel: a short title, a sentence that explains it, and its picture ((h, w, 3) uint8 RGB)."""

    title: str
    sentence: str
    pixels: Pixels


def stages(result: Answer) -> Pixels:
    """All panels on one sheet, four in a row, numbered; (h, w, 3) uint8 RGB."""
    panels = stage_panels(result)
    rows = -(-len(panels) // _COLUMNS)
    w = _GAP + _COLUMNS * (_WIDTH + _GAP)
    h = _GAP + rows * (_HEIGHT + _CAPTION + _GAP)
    canvas = Canvas(w, h, BACKDROP)
    for k, panel in enumerate(panels):
        left = _GAP + (k % _COLUMNS) * (_WIDTH + _GAP)
        top = _GAP + (k // _COLUMNS) * (_HEIGHT + _CAPTION + _GAP)
        canvas.box(left - 1, top - 1, _WIDTH + 2, _HEIGHT + 2, RULE)
        canvas.paste(panel.pixels, left, top)
        canvas.words((left, top + _HEIGHT + 10), f"{k + 1}", 16, FRONT, bold=True)
        canvas.words((left + 18, top + _HEIGHT + 10), panel.title, 16, INK)
    return canvas.finish()


def stage_panels(result: Answer, size: tuple[int, int] = (_WIDTH, _HEIGHT)) -> list[Stage]:
    """The panels one by one, each `size` (width, height) pixels; the first only, where nothing was found."""
    frame = _Frame.around(result, size)
    panels = [Stage("Input", "The drawing as it was read.", frame.input())]
    if not result.objects:
        return panels
    drawings: list[tuple[str, str, Callable[[Canvas, TwoFaceObject, Solid], None]]] = [
        (
            "Vertices and regions",
            "The object's corners; the centroid line splits each face into an upper (full) and a lower (open) region.",
            lambda c, o, _: _regions(c, o),
        ),
        ("Face f1", "The vertices of the front face.", lambda c, o, _: _numbered(c, o, front=True)),
        (
            "Face f2",
            "The vertices of the back face, in the same order.",
            lambda c, o, _: _numbered(c, o, front=False),
        ),
        ("Both faces", "Each front vertex and the back vertex it belongs to.", lambda c, o, _: _pairs(c, o)),
        ("Each face connected", "The order of the vertices makes each face a polygon.", lambda c, o, _: _faces(c, o)),
        ("Complete object", "The connecting edges join the faces; hidden edges are dashed.", draw_object),
    ]
    for title, sentence, draw in drawings:
        panels.append(Stage(title, sentence, frame.draw(draw)))
    family = result.solids[0].projection.family if result.solids else ""
    words = (
        f"Lifted to three dimensions, read as an {family} drawing."
        if family[:1] in "ao"
        else "Lifted from perspective."
    )
    panels.append(Stage("Solid", words, preview_of(result, size)))
    return panels


@dataclass(frozen=True)
class _Frame:
    """Where the picture lies in a panel, and where drawings over it go."""

    result: Answer
    size: tuple[int, int]
    picture: Pixels
    scale: float
    offset: Floats

    @classmethod
    def around(cls, result: Answer, size: tuple[int, int]) -> _Frame:
        picture, scale = fit(result.picture.pixels, size[0], size[1])
        scale /= result.picture.reduction
        h, w = picture.shape[:2]
        return cls(result, size, picture, scale, np.array([(size[0] - w) // 2, (size[1] - h) // 2], float))

    def input(self) -> Pixels:
        canvas = Canvas(*self.size, PAPER)
        canvas.paste(self.picture, int(self.offset[0]), int(self.offset[1]))
        return canvas.finish()

    def draw(self, draw: Callable[[Canvas, TwoFaceObject, Solid], None]) -> Pixels:
        canvas = Canvas(*self.size, PAPER)
        canvas.view(self.scale, self.offset + self.scale / 2 - 0.5)
        for obj, solid in zip(self.result.objects, self.result.solids, strict=True):
            draw(canvas, obj, solid)
        return canvas.finish()


def _regions(canvas: Canvas, obj: TwoFaceObject) -> None:
    _arcs(canvas, obj)
    for rings, colour in (([r.f1 for r in obj.rings], FRONT), ([r.f2 for r in obj.rings], BACK)):
        points = np.concatenate(rings)
        if not len(points):
            continue
        middle = points[:, 1].mean()
        left, right = points[:, 0].min(), points[:, 0].max()
        ends = np.array([[left, middle], [right, middle]]) + np.array([[-0.06], [0.06]]) * [right - left, 0]
        canvas.line(ends[0], ends[1], mix(colour, PAPER, 0.45), 1.2, dash=(5, 4))
        for p in points:
            _vertex(canvas, p, colour, full=bool(p[1] <= middle))


def _arcs(canvas: Canvas, obj: TwoFaceObject) -> None:
    """The arcs, pale: they have no vertices inside."""
    for side, colour in _SIDES:
        for arc in obj.arcs:
            if arc.face == side:
                canvas.path(arc.path, mix(colour, PAPER, 0.6), 1.6)


def _numbered(canvas: Canvas, obj: TwoFaceObject, *, front: bool) -> None:
    for p in obj.vertices:
        canvas.dot(p, 2, RULE, rim=None)
    side, colour = _SIDES[0] if front else _SIDES[1]
    for outline in obj.outlines(side) if obj.is_round else []:
        canvas.path(np.concatenate([outline, outline[:1]]), mix(colour, PAPER, 0.6), 1.6)
    rings = [ring for r in obj.rings if len(ring := r.f1 if front else r.f2)]
    label = 0
    for ring in rings:
        outward = ring - ring.mean(axis=0)
        outward = outward / np.maximum(np.linalg.norm(outward, axis=1, keepdims=True), 1e-9)
        for p, out in zip(ring, outward, strict=True):
            label += 1
            _vertex(canvas, p, colour, full=True)
            at = canvas.place(p) + 13 * out
            canvas.words((float(at[0]), float(at[1])), str(label), 12, mix(colour, INK, 0.3), "mm")


def _pairs(canvas: Canvas, obj: TwoFaceObject) -> None:
    _arcs(canvas, obj)
    for ring in obj.rings:
        for k, a in enumerate(ring.f1):
            b = ring.f2[0 if obj.is_pointed else k]
            canvas.line(a, b, mix(MUTED, PAPER, 0.35), 1.1, dash=(2, 4))
            _vertex(canvas, a, FRONT, full=True)
            _vertex(canvas, b, BACK, full=True)


def _faces(canvas: Canvas, obj: TwoFaceObject) -> None:
    for side, colour in reversed(_SIDES):
        outlines = obj.outlines(side)
        if outlines:
            canvas.fill(outlines, colour, 0.10)
        for outline in outlines:
            for a, b in zip(outline, np.roll(outline, -1, axis=0), strict=True):
                canvas.line(a, b, colour, 2.2)
        for ring in (r.f1 if side == "f1" else r.f2 for r in obj.rings):
            for p in ring:
                _vertex(canvas, p, colour, full=True)


def _vertex(canvas: Canvas, at: Floats, colour: Colour, *, full: bool) -> None:
    canvas.dot(at, 4.2, colour)
    if not full:
        canvas.dot(at, 2.2, PAPER, rim=None)
