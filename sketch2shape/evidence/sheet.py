"""What a hypothesis is compared with: the observation model of a drawing."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from sketch2shape.evidence.visibility import looked_up
from sketch2shape.geometry import thinned
from sketch2shape.ink import Group
from sketch2shape.model import Bools, Floats, Ints
from sketch2shape.strokes import Skeleton

MOST_POINTS = 2000
"""Skeleton pixels that are compared, at most."""


@dataclass(frozen=True)
class Sheet:
    """What a hypothesis is compared with.

    skeleton : of the drawing
    points   : (k, 2) float, skeleton pixels that must be explained
    weights  : (k,) float, weight of each
    reach    : pixels a drawn line may be away from the predicted one
    pen      : pen width, pixels
    step     : skeleton pixels for each of the points
    cut      : (2, 2) float, pixels: least and greatest x and y of the picture where it cuts ink off, or None
    """

    skeleton: Skeleton
    points: Floats
    weights: Floats
    reach: float
    pen: float
    step: float = 1.0
    cut: Floats | None = None

    @cached_property
    def size(self) -> float:
        """Diagonal of the ink's bounding box, pixels."""
        return float(np.linalg.norm(np.ptp(self.points, axis=0))) if len(self.points) else 1.0

    @cached_property
    def ink(self) -> float:
        """Length of all ink, pixels, what may be letters counted for little."""
        return float(self.weights.sum()) * self.step + 1e-9

    @cached_property
    def near(self) -> NDArray[np.uint8]:
        """(h, w) uint8, 1 within reach of the skeleton."""
        return self.skeleton.near(self.reach)

    @cached_property
    def places(self) -> Ints:
        """(k,) int, where in the flattened picture the points are."""
        at = np.rint(self.points).astype(np.intp)
        return np.asarray(at[:, 1] * self.skeleton.mask.shape[1] + at[:, 0])

    def inked(self, points: Floats) -> Bools:
        """Whether points (..., k, 2) are within reach of the ink, (..., k) bool; nothing is outside the picture."""
        at = points.reshape(-1, *points.shape[-2:]).astype(np.float32)
        return looked_up(self.near, at).view(np.bool_).reshape(points.shape[:-1])


def skeleton_sheet(skeleton: Skeleton, weights: Floats, reach: float, cut: Floats | None = None) -> Sheet:
    """A sheet with at most MOST_POINTS of the skeleton's points, which have these weights (k,)."""
    some = thinned(len(weights), MOST_POINTS)
    step = len(weights) / max(len(some), 1)
    return Sheet(skeleton, skeleton.points[some], weights[some], reach, skeleton.pen_width, step, cut)


def sheet_for(group: Group, skeleton: Skeleton, reach: float) -> Sheet:
    """What hypotheses are compared with. Small pieces may be letters: explaining them counts for little.

    Blots are explained by any line, so they count for nothing.
    """
    at = np.rint(skeleton.points).astype(np.intp)
    weights = np.where(group.solid[at[:, 1], at[:, 0]], 1.0, 0.2)
    weights[skeleton.slack(skeleton.points) > 0] = 0.0
    return skeleton_sheet(skeleton, weights, reach + 0.5, group.cut)
