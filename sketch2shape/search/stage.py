"""Face separation as a stage of its own: which corners are f1's and which f2's, all readings that the drawing allows.

The main job (`search`) keeps one answer; here every verified hypothesis is given, the best first. A wireframe box, for
instance, has three: any two opposite sides may be called the faces.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import chain, islice
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from sketch2shape.connectors import as_points
from sketch2shape.evidence import Evidence, sheet_for
from sketch2shape.hypotheses import Rings, caps, coincide, enclosed_regions
from sketch2shape.ink import Group, split_groups
from sketch2shape.lifting import choose_front
from sketch2shape.model import FacePair, Floats, Ink, TwoFaceObject, checked_count
from sketch2shape.search.attempts import GOOD, wire_hypotheses
from sketch2shape.search.shortlist import LEAST, MOST_HYPOTHESES, verified
from sketch2shape.search.tolerances import LEAST_INK, Round, corner_graph, rounds_for, vertex_candidates
from sketch2shape.strokes import DetectedCorners, Skeleton, ink_of, join_ends, thin, trace_skeleton


def separate_faces(
    source: Any, *, corners: ArrayLike | DetectedCorners | None = None, most: int = 8
) -> tuple[TwoFaceObject, ...]:
    """Hypotheses of the front and back faces of what is drawn, best first.

    source  : path, bytes, PIL image, array (gray, RGB, RGBA), `Picture`, or the `Ink` of one
    corners : (k, 2) float, picture pixels, k >= 6: all vertices of the object, in any order, if they are known, or
              what `detect_corners` returns; they are used as they are. None: the corners where strokes meet, at
              growing tolerance until one explains the drawing
    most    : how many hypotheses are given at most

    Returns objects in picture pixels, not yet refined; their confidence is how well each explains its part of the
    drawing, 0..1. Drawings of several objects give the hypotheses of all. Each pair of faces is given once. Empty if
    there are none. Raises PointsError for corners that are no points, UnreadableError or LimitError for a picture that
    cannot be read.
    """
    most = checked_count("most", most)
    ink = ink_of(source)
    if isinstance(corners, DetectedCorners):
        corners = corners.vertices
    known = None if corners is None else ink.to_working(as_points(corners, minimum=6))
    found = []
    for group in split_groups(ink):
        own = known if known is None else known - group.offset
        found += [
            as_object(rings.shifted(group.offset), evidence, ink)
            for rings, evidence in _verified(group, own)
            if evidence.score >= LEAST
        ]
    kept: list[TwoFaceObject] = []
    for obj in sorted(found, key=lambda o: -o.confidence):
        if len(kept) < most and not any(_alike(obj, other) for other in kept):
            kept.append(obj)
    return tuple(choose_front(o) for o in kept)


def _verified(group: Group, corners: Floats | None) -> Iterator[tuple[Rings, Evidence]]:
    """Hypotheses for one group of ink, round by round until one explains it."""
    skeleton = thin(group.ink)
    if len(skeleton.points) < LEAST_INK:
        return
    size = float(np.linalg.norm(np.ptp(skeleton.points, axis=0)))
    for tolerant in rounds_for(size, group.ink.pen_width):
        sheet = sheet_for(group, skeleton, tolerant.reach)
        best = 0.0
        for rings, evidence in verified(_hypotheses(group, skeleton, tolerant, corners), sheet):
            best = max(best, evidence.score)
            yield rings, evidence
        if best >= GOOD:
            return


def _hypotheses(group: Group, skeleton: Skeleton, tolerant: Round, corners: Floats | None) -> Iterator[Rings]:
    """From both separators: where all edges are drawn, and where the back is dashed or missing."""
    pen = group.ink.pen_width
    strokes = trace_skeleton(skeleton, tolerant.trace, group.solid)
    points = vertex_candidates(strokes, join_ends(strokes, pen), tolerant, pen) if corners is None else corners
    graph = corner_graph(skeleton, points, tolerant.reach)
    regions = enclosed_regions(group.ink.mask, pen, tolerant.trace)
    both: Iterable[Iterator[Rings]] = (wire_hypotheses(graph), caps(graph, regions, pen))
    return chain.from_iterable(islice(one, MOST_HYPOTHESES) for one in both)


def _alike(a: TwoFaceObject, b: TwoFaceObject) -> bool:
    """Whether two objects have the same pair of faces, to within a few pixels, whichever is called the front."""
    near = 4.0 + 0.01 * float(np.linalg.norm(np.ptp(a.vertices, axis=0)))
    return any(
        coincide(a.f1, f1, near) and coincide(a.f2, f2, near) and len(a.holes) == len(b.holes)
        for f1, f2 in ((b.f1, b.f2), (b.f2, b.f1))
    )


def as_object(rings: Rings, evidence: Evidence, ink: Ink) -> TwoFaceObject:
    """A hypothesis of the whole sheet in picture pixels; its confidence is how well it explains the drawing."""
    pairs = [FacePair(ink.to_picture(a), ink.to_picture(b)) for a, b in zip(rings.front, rings.back, strict=True)]
    return TwoFaceObject(
        pairs[0].f1,
        pairs[0].f2,
        tuple(pairs[1:]),
        confidence=float(np.clip(evidence.score, 0.0, 1.0)),
        lines=evidence.lines,
        f2_drawn=evidence.drawn,
        page=ink.page,
    )
