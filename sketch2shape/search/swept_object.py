"""A sweep as the object in the picture: vertices, arcs, silhouettes in picture pixels."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

import numpy as np

from sketch2shape.model import Bools, DrawnArc, Ellipse, FacePair, Floats, Ink, Lines, Side, TwoFaceObject
from sketch2shape.search.found_sweep import FoundSweep
from sketch2shape.sweeps import Outline, Redrawn, Sweep, redraw, seen_vertices
from sketch2shape.sweeps.outlines import STEPS

SPACING, MARGIN = 4.0, 3.0
"""Pixels between samples, and within which a line may lie on the border of sight."""
PLUMB = 0.1
"""Sine of the angle off the plumb up to which a point stands above its base."""


def sweep_as_object(found: FoundSweep, ink: Ink) -> TwoFaceObject:
    """The object of a sweep found on a sheet.

    found : in the sheet's working pixels
    """
    sweep = found.sweep
    back = _back(sweep)
    pairs = [FacePair(ink.to_picture(f.vertices), ink.to_picture(b)) for f, b in zip(sweep.rings, back, strict=True)]
    arcs = tuple(arc for hole, ring in enumerate(sweep.rings) for arc in _arcs_of(sweep, ring, hole, ink))
    drawn = redraw(sweep, SPACING, MARGIN)
    return TwoFaceObject(
        pairs[0].f1,
        pairs[0].f2,
        tuple(pairs[1:]),
        confidence=found.confidence,
        lines=found.energy.lines,
        f2_drawn=_drawn(sweep, found.energy.lines),
        noise=found.noise / ink.scale,
        page=ink.page,
        arcs=arcs,
        silhouettes=ink.to_picture(drawn.silhouettes),
        front=_front(found, drawn),
    )


def _front(found: FoundSweep, drawn: Redrawn) -> Side | None:
    """The nearer face, where hidden lines tell it, or where a base hides nothing that would have to be drawn."""
    sweep = found.sweep
    if found.energy.lines != "wire":
        return "f1" if sweep.is_near else "f2"
    if not sweep.is_near or not sweep.way.is_pointed or sweep.way.centre is None or (drawn.depth == 2).any():
        return None
    right, down = (sweep.way.centre - sweep.rings[0].middle).tolist()
    stands = down < 0.0 and abs(right) < PLUMB * float(np.hypot(right, down))
    return None if stands else "f1"


def _back(sweep: Sweep) -> list[Floats]:
    """(n, 2) float of each ring on the back face, (1, 2) where it is a point."""
    if sweep.way.is_pointed and sweep.way.centre is not None:
        return [sweep.way.centre[None]]
    return [ring.vertices + sweep.way.of(ring.vertices) for ring in sweep.rings]


def _drawn(sweep: Sweep, lines: Lines) -> Bools:
    """(m,) bool, which vertices of the back face the drawing shows."""
    if sweep.way.is_pointed:
        return np.ones(1, np.bool_)
    m = sum(len(ring.vertices) for ring in sweep.rings)
    if lines != "removed" or not m:
        return np.ones(m, np.bool_)
    return seen_vertices(sweep, MARGIN)


def _arcs_of(sweep: Sweep, ring: Outline, number: int, ink: Ink) -> Iterator[DrawnArc]:
    hole = None if number == 0 else number - 1
    line = ring.line
    faces: list[tuple[Literal["f1", "f2"], Outline, Floats]] = [("f1", ring, line)]
    if not sweep.way.is_pointed:
        # the same points in the same order on both faces, which in perspective are no even ones on the second
        faces.append(("f2", sweep.image(ring), line + sweep.way.of(line)))
    for face, outline, line in faces:
        n = len(outline.vertices)
        for i, ellipse in outline.ellipses():
            own = line if outline.circle is not None else line[(i * STEPS + np.arange(STEPS + 1)) % len(line)]
            start, end = (None, None) if outline.circle is not None else (i, (i + 1) % n)
            centre, axes, angle = ellipse
            told = Ellipse(ink.to_picture(centre), (axes[0] / ink.scale, axes[1] / ink.scale), angle)
            yield DrawnArc(face, hole, start, end, told, ink.to_picture(own))
