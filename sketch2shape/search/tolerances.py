"""Rounds: one drawing, looked at with growing tolerance.

Nobody knows beforehand how straight a drawing's lines are. A round says how far strokes may stray; with it come the
strokes, the regions, the corners with ink between them, and the sheet that hypotheses are compared with.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import cv2
import numpy as np

from sketch2shape.geometry import project, thinned
from sketch2shape.hypotheses import CornerGraph, Region, enclosed_regions
from sketch2shape.ink import Group
from sketch2shape.model import Floats
from sketch2shape.strokes import Corners, Skeleton, Strokes, are_covered, crossings, join_ends, trace_skeleton
from sketch2shape.strokes.loose_ends import without_loose_ends

LEAST_INK = 30
"""Pixels of the skeleton below which ink is no drawing of an object."""
LEAST_TRACE, PEN_TRACE = 1.5, 0.08
"""How far a ruled stroke may stray from its line, pixels at least, and in pens."""
MOST_CORNERS = 120
"""Corners of a drawing that are looked at, the surest first."""
MOST_OF_A_WIREFRAME = 420
"""The same where strokes meet in threes: then there is no doubt which they are."""
MOST_POINTS = 1500
"""Pixels of the skeleton that tell how much a hand wobbles."""
MOST_KNOWN = 400
"""The same of lines that are known, which no thinning has roughened."""
AS_MUCH = 0.9
"""Part of the area enclosed by all ink that larger pieces enclose if dashes are none of the outlines."""
COVERED, ROUGHLY = 0.9, 0.75
"""Part of the way between two corners that an edge inks, and one of a careless hand, whose corners lie off its ends."""
IN_THREES = 0.75
"""Part of all stroke ends that meet in threes from which on a drawing is a wireframe; in a scribble it is a tenth."""


@dataclass(frozen=True)
class Round:
    """How tolerant one round of the search is, pixels.

    trace : how far a stroke may stray from its line before it counts as bent
    reach : how far ink may lie from the straight line between two corners
    loose : whether to try the shapes of regions alone, without corners
    crossings : whether the crossing of two strokes may be a vertex too (two vertices may coincide)
    last_resort : whether it is for drawings that no other round explains
    """

    trace: float
    reach: float
    loose: bool = False
    crossings: bool = False
    last_resort: bool = False


CLOSE = Round(1.0, 3.0)
"""A close look at ruled lines: polygons with slight bends, on long lines that other rounds take for straight."""


def rounds_for(size: float, pen: float) -> list[Round]:
    """From ruled lines to a heavy wobble. A wobbling stroke still ends in a sharp corner: fine tracing, wide reach.

    A thick pen rounds corners and bends the skeleton near them in proportion to its width.
    """
    return [
        Round(max(LEAST_TRACE, PEN_TRACE * pen), max(2.0, 0.15 * pen)),
        Round(max(LEAST_TRACE, PEN_TRACE * pen), max(3.0, 0.2 * pen), crossings=True),
        Round(max(LEAST_TRACE, PEN_TRACE * pen), max(4.0, 0.011 * size, 0.3 * pen)),
        Round(max(2.5, 0.006 * size, 0.15 * pen), max(4.0, 0.014 * size, 0.4 * pen), True),
        Round(max(4.0, 0.012 * size, 0.25 * pen), max(6.0, 0.02 * size, 0.5 * pen), True),
        Round(max(6.0, 0.02 * size, 0.3 * pen), max(9.0, 0.033 * size, 0.6 * pen), True, last_resort=True),
    ]


def vertex_candidates(strokes: Strokes, corners: Corners, tolerant: Round, pen: float) -> Floats:
    """(k, 2) float, pixels: corners that can be vertices, the strokes' own and those where strokes cross."""
    across = crossings(strokes, tolerant.trace + 0.5 * pen, 2 if tolerant.crossings else 3)
    most = MOST_OF_A_WIREFRAME if is_wireframe(corners) else MOST_CORNERS
    return np.concatenate([corners.points[(corners.degree >= 2) | corners.on], across])[:most]


def in_threes(corners: Corners) -> float:
    """Part of all stroke ends that meet in threes, as at the vertices of a prism with all edges drawn."""
    return 3 * int(np.count_nonzero(corners.degree == 3)) / max(int(corners.degree.sum()), 1)


def is_wireframe(corners: Corners) -> bool:
    """Whether there is no doubt that all edges are drawn."""
    return in_threes(corners) > IN_THREES


def corner_graph(skeleton: Skeleton, points: Floats, reach: float, least: float = COVERED) -> CornerGraph:
    """Vertex candidates (k, 2), and which of them have ink between them, at most reach pixels off.

    least : 0..1, how much of the way between two has to be inked
    """
    k = len(points)
    i, j = np.triu_indices(k, 1)
    covered = are_covered(skeleton.near(reach), points[i], points[j], least)
    apart = np.linalg.norm(points[i] - points[j], axis=1) > 2 * skeleton.pen_width
    inked = np.zeros((k, k), bool)
    inked[i, j] = inked[j, i] = covered & apart
    return CornerGraph(points, inked, 0.75 * skeleton.pen_width + 1.5 * reach + 1.5)


@dataclass(frozen=True)
class Traced:
    """What a drawing looks like at one tolerance, pixels."""

    group: Group
    skeleton: Skeleton
    tolerance: float

    @property
    def strokes(self) -> Strokes:
        """The straight strokes of all ink that is neither letters nor dashes."""
        return self._joined[0]

    @property
    def corners(self) -> Corners:
        """Where strokes end, meet or turn."""
        return self._joined[1]

    @cached_property
    def _joined(self) -> tuple[Strokes, Corners]:
        pen = self.skeleton.pen_width
        traced = trace_skeleton(self.skeleton, self.tolerance, self.group.solid)
        corners = join_ends(traced, pen)
        strokes = without_loose_ends(traced, corners, self.skeleton)
        return strokes, corners if strokes is traced else join_ends(strokes, pen)

    @cached_property
    def wobble(self) -> float:
        """Rms distance of the ink from the strokes it belongs to, pixels."""
        ends, lengths = self.strokes.ends, self.strokes.lengths + 1e-9
        if not len(ends):
            return 0.0
        most = MOST_KNOWN if self.skeleton.is_known else MOST_POINTS
        points = self.skeleton.points[thinned(len(self.skeleton.points), most)]
        along, across = project(points, ends[:, 0], (ends[:, 1] - ends[:, 0]) / lengths[:, None])
        own = across[(across <= 2 * self.tolerance) & (along > 0) & (along < lengths)]
        return float(np.sqrt((own**2).mean())) if len(own) else 0.0

    @cached_property
    def regions(self) -> list[Region]:
        """What the ink encloses.

        Of larger pieces alone where these enclose as much: dashes, their gaps closed, would cut a face in two.
        """
        pen, ink = self.skeleton.pen_width, self.group.ink.mask
        solid = enclosed_regions(self.group.solid, pen, self.tolerance)
        if np.count_nonzero(self.group.solid) == np.count_nonzero(ink):
            return solid
        # nothing encloses more than what lies within its hull
        hull = cv2.contourArea(cv2.convexHull(self.skeleton.points.astype(np.float32)))
        if _area(solid) > AS_MUCH * hull:
            return solid
        every = enclosed_regions(ink, pen, self.tolerance)
        return solid if _area(solid) > AS_MUCH * _area(every) else every

    @cached_property
    def dash_ends(self) -> Floats:
        """(k, 2) float, pixels: where strokes of small pieces of ink, such as dashes, end or meet."""
        at = np.rint(self.skeleton.points).astype(np.intp)
        if self.group.solid[at[:, 1], at[:, 0]].all():
            return np.zeros((0, 2))
        strokes = trace_skeleton(self.skeleton, self.tolerance, self.group.ink.mask & ~self.group.solid)
        long = strokes.lengths > 4 * self.skeleton.pen_width
        some = replace(strokes, ends=strokes.ends[long][:60], inked=strokes.inked[long][:60])
        return join_ends(some, self.skeleton.pen_width).points


def _area(regions: list[Region]) -> float:
    """What they cover in all, pixels."""
    return sum(float(cv2.contourArea(r.outline.astype(np.float32))) for r in regions)
