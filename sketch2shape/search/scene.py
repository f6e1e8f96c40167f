"""A scene: what of a drawing the search for sweeps looks at: strokes, closed lines, ellipses, where long lines meet."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import cv2
import numpy as np
from numpy.typing import NDArray

from sketch2shape.evidence import View
from sketch2shape.ink import Group
from sketch2shape.model import Floats
from sketch2shape.search.tolerances import LEAST_TRACE, PEN_TRACE
from sketch2shape.strokes import Skeleton, Strokes, trace_skeleton
from sketch2shape.sweeps import (
    Cells,
    Loop,
    Sweep,
    centres,
    directions,
    distinct_centres,
    distinct_directions,
    ellipse_through,
    ellipses,
    enclosed_loops,
    joints,
    pyramids,
    shifts,
    wire_shifts,
)

if TYPE_CHECKING:
    from scipy.spatial import cKDTree

LEAST_REACH, REACH = 4.0, 0.012
"""Pixels, and fraction of the drawing's size, from a line from which ink is that of another."""
LEAST_STRAY, STRAY = 2.0, 0.006
"""Pixels, and fraction of the drawing's size, by which a line that may be an ellipse strays from one."""
ALIKE = 0.02
"""Fraction of the drawing's size within which two outlines, or their images, are one."""
COARSE = 0.01
"""Fraction of the drawing's size by which a hand's straight line may stray."""


@dataclass(frozen=True, eq=False)
class Scene:
    """A drawing as this search sees it.

    group    : the ink
    skeleton : of it, gaps at corners bridged
    view     : what hypotheses are held against
    """

    group: Group
    skeleton: Skeleton
    view: View

    @property
    def size(self) -> float:
        """Diagonal of the ink, pixels."""
        return self.view.size

    @cached_property
    def margin(self) -> float:
        """Pixels within which a line may lie on the border of sight."""
        return max(3.0, 0.008 * self.size)

    @property
    def reach(self) -> float:
        """Pixels from a line within which ink may be its own."""
        return max(LEAST_REACH, REACH * self.size)

    @cached_property
    def solid(self) -> NDArray[np.float32] | None:
        """(h, w) pixels to the nearest solid line, where there are dashes."""
        if np.count_nonzero(self.group.solid) == np.count_nonzero(self.group.ink.mask):
            return None
        lines = self.skeleton.mask.astype(bool) & self.group.solid
        return np.asarray(cv2.distanceTransform((~lines).astype(np.uint8), cv2.DIST_L2, cv2.DIST_MASK_5), np.float32)

    @cached_property
    def tree(self) -> cKDTree:
        """Of the skeleton's pixels."""
        from scipy.spatial import cKDTree  # slow to load, and not needed for straight drawings

        return cKDTree(self.skeleton.points)

    @cached_property
    def strokes(self) -> list[Strokes]:
        """Straight strokes, finely and coarsely traced."""
        fine = max(LEAST_TRACE, PEN_TRACE * self.skeleton.pen_width)
        coarse = max(COARSE * self.size, 1.5 * fine)
        return [trace_skeleton(self.skeleton, t, self.group.solid) for t in (fine, coarse)]

    @cached_property
    def every_stroke(self) -> list[Strokes]:
        """Those of dashes too."""
        return [trace_skeleton(self.skeleton, s.tolerance) for s in self.strokes]

    @cached_property
    def meeting(self) -> Floats:
        """(c, 2) float, pixels, where long strokes meet."""
        every = np.concatenate([centres(s, self.size) for s in self.strokes])
        return distinct_centres(every, self.skeleton.points.mean(axis=0), self.size)

    @cached_property
    def along(self) -> Floats:
        """(d, 2) directions of long strokes."""
        return distinct_directions(np.concatenate([directions(s, self.size) for s in self.strokes]))

    @cached_property
    def ellipses(self) -> list[Loop]:
        """Ellipses that bowed lines lie on."""
        return [Loop(line) for line in ellipses(self.skeleton, self.size)]

    @cached_property
    def loops(self) -> list[Loop]:
        """Closed lines: ellipses, and what solid lines enclose."""
        enclosed = enclosed_loops(self.group.solid, self.skeleton.pen_width)
        near = ALIKE * self.size
        # what other lines cross is enclosed in pieces, and roughly: an ellipse is the better line
        others = [e for e in enclosed if not any(_runs_along(loop.line, e, near) for loop in self.ellipses)]
        return [*self.ellipses, *map(Loop, others)]

    @property
    def rounds(self) -> list[Floats]:
        """Ellipses, those too that are so thin that their lines hardly bow."""
        near = max(LEAST_STRAY, STRAY * self.size)
        others = self.loops[len(self.ellipses) :]
        return [loop.line for loop in (*self.ellipses, *(loop for loop in others if _off_round(loop) < near))]

    @cached_property
    def joints(self) -> Floats:
        """(k, 2) float, pixels, where lines meet or end."""
        return joints(self.skeleton)

    @cached_property
    def wire_shifts(self) -> list[Floats]:
        """Shifts (2,) to the back face that nearly all ink of a wireframe tells."""
        return wire_shifts(self.skeleton, self.joints, self.shifts, self.size)

    @cached_property
    def shifts(self) -> Floats:
        """(k, 2) by which much of the ink comes to lie on ink."""
        return shifts(self.skeleton, self.size)

    @cached_property
    def cells(self) -> Cells:
        """The drawing at a glance."""
        return Cells.of(self.skeleton, self.size, self.group.solid)

    @property
    def pyramids(self) -> Iterator[Sweep]:
        """Those that corners of the drawing may show."""
        return pyramids(self.every_stroke, self.meeting, self.skeleton, self.size)


def _off_round(loop: Loop) -> float:
    """Pixels by which a closed line is off an ellipse at most."""
    ellipse = ellipse_through(loop.line).line.astype(np.float32)
    return max(abs(cv2.pointPolygonTest(ellipse, (float(x), float(y)), True)) for x, y in loop.probes)


def _runs_along(p: Floats, q: Floats, near: float) -> bool:
    """Whether a closed line (k, 2) is another all around, to so many pixels."""
    if not are_close(p, q, near):
        return False
    apart = np.hypot(p[:, 0, None] - q[:, 0], p[:, 1, None] - q[:, 1])
    return bool(apart.min(axis=1).max() < near)


def are_close(p: Floats, q: Floats, near: float) -> bool:
    """Whether two closed lines have one bounding box, to so many pixels."""
    boxes = np.abs(np.concatenate([p.min(axis=0) - q.min(axis=0), p.max(axis=0) - q.max(axis=0)]))
    return bool(boxes.max() < near)
