"""Drilled: straight objects with round holes.

The straight search tells the outline; what ink it leaves within a face, and again where that is moved to the back face,
are holes. Which two faces they join is open: any two opposite sides of a box may be drilled.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import cv2
import numpy as np
from numpy.typing import NDArray

from sketch2shape.evidence import faces_of, nearest_edges
from sketch2shape.hypotheses import Rings, split
from sketch2shape.lifting import OTHER_PAIRS
from sketch2shape.model import Floats
from sketch2shape.search.found import Found
from sketch2shape.search.found_sweep import FoundSweep, priced
from sketch2shape.search.observed import Observed
from sketch2shape.search.scene import Scene
from sketch2shape.search.sweep_improvement import finished, with_holes
from sketch2shape.strokes import Skeleton
from sketch2shape.sweeps import LEAST_COHERENT, Frame, Outline, Sweep, Way, coherent_loops

SPREAD = 0.05
"""Fraction of a face's size by which its vertices are moved unlike each other at most: more is perspective."""
STRAYS, OWN_PENS, BLUR = 4.0, 0.5, 1.0
"""Standard deviations of the hand, or pens if that is more, and pixels more, within which ink belongs to the straight
edges."""
INSIDE = -1.5
"""Pixels by which a hole lies inside its face at least: one may come close to the face's edge."""
LEAST_RIM = 2 * LEAST_COHERENT
"""Length of the rim of the smallest hole, in each face, over the drawing's size: twice its extent at least."""
LEAST_NEAR, NEAR_PENS = 2.0, 0.5
"""Pixels, and pens, within which the ink of a hole lies on ink when it is moved to the back face."""


def find_drilled(seen: Observed, straight: Found) -> FoundSweep | None:
    """A straight answer with round holes in it, or None if there are none."""
    scene = Scene(seen.drawn, seen.skeleton, seen.view)
    left = _left(seen.skeleton, straight, 2 * LEAST_RIM * seen.view.size)
    if left is None:
        return None
    found: list[FoundSweep] = []
    for sweep in _sides(straight.rings):
        whole = priced(scene, sweep)
        holed = with_holes(whole, scene, _loops(left, sweep, scene), INSIDE)
        if holed.sweep.has_arcs:
            found.append(finished(holed, scene).against(np.inf))
    return min(found, key=lambda f: f.nats, default=None)


def _sides(rings: Rings) -> Iterator[Sweep]:
    """The object as a front face moved to the back, either face in front, of a box in each of three ways."""
    ways = [rings]
    if rings.sizes == (4,):
        ways += [split(rings.vertices[order], (4,)) for order in OTHER_PAIRS]
    for way in ways:
        sweep = _as_sweep(way)
        if sweep is not None:
            yield from (sweep, sweep.reversed())


def _as_sweep(rings: Rings) -> Sweep | None:
    """The mean of both faces, moved from one to the other; None in perspective and where the object tapers."""
    front, back = np.concatenate(rings.front), np.concatenate(rings.back)
    shift = (back - front).mean(axis=0)
    size = float(np.hypot(*np.ptp(front, axis=0)))
    if np.abs(back - front - shift).max() > SPREAD * size:
        return None
    along = shift / (np.hypot(*shift) + 1e-9)
    middle = [0.5 * (f + b - shift) for f, b in zip(rings.front, rings.back, strict=True)]
    outlines = tuple(
        Outline(Frame(along, 1.0), ring, np.zeros(len(ring)), np.zeros(len(ring), np.bool_)) for ring in middle
    )
    return Sweep(outlines, Way(shift))


def _left(skeleton: Skeleton, straight: Found, least: float) -> Skeleton | None:
    """The skeleton within the object without the ink of its edges; None if there are fewer than `least` pixels.

    A hole lies within two faces: dimensions, letters and arrows around the object are none.
    """
    reach = max(STRAYS * straight.noise, OWN_PENS * skeleton.pen_width) + BLUR
    distance, _ = nearest_edges(skeleton.points, *straight.rings.segments)
    mask = skeleton.mask & _covered(straight.rings, skeleton.mask.shape)
    x, y = np.rint(skeleton.points[distance <= reach]).astype(np.intp).T
    mask[y, x] = 0
    x, y = np.rint(skeleton.points).astype(np.intp).T
    points = skeleton.points[mask[y, x] > 0]
    return Skeleton(mask, points, (), skeleton.pen_width) if len(points) >= least else None


def _covered(rings: Rings, shape: tuple[int, ...]) -> NDArray[np.uint8]:
    """(h, w) 1 on all faces of the object, and as far beyond them as a hole may lie."""
    drawn = np.zeros(shape, np.uint8)
    for face in faces_of(rings.front[0], rings.back[0]):
        outline = np.rint(face).astype(np.int32)
        cv2.fillPoly(drawn, [outline], 1)
        cv2.polylines(drawn, [outline], True, 1, 2 * math.ceil(-INSIDE) + 1)
    return drawn


def _loops(left: Skeleton, sweep: Sweep, scene: Scene) -> list[Floats]:
    """Closed lines of the front face: of ink that is left and lies on such ink on the back face, then of any ink."""
    reach, shift = max(LEAST_NEAR, NEAR_PENS * left.pen_width), sweep.way.shift
    coherent = [
        loop - by
        for skeleton in (left, scene.skeleton)
        for way, by in ((shift, np.zeros(2)), (-shift, shift))
        for loop in coherent_loops(skeleton, way, reach, scene.size)
    ]
    return [*coherent, *(e.line for e in scene.ellipses)]
