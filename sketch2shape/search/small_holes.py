"""Small holes: round holes whose rims are hardly more than the corners and dots of their drawing.

No closed line can be followed there. But what a wireframe leaves of a hole reaches as far across the way to the back
face as the hole is wide, and along it as far as that is seen, and the way besides.
"""

from __future__ import annotations

from collections.abc import Iterator

import cv2
import numpy as np

from sketch2shape.evidence import near_line
from sketch2shape.model import Floats
from sketch2shape.search.found_sweep import FoundSweep
from sketch2shape.search.scene import Scene
from sketch2shape.search.sweep_pairs import SHALLOW_PENS
from sketch2shape.sweeps import Circle, Outline


def small_holes(found: FoundSweep, scene: Scene) -> Iterator[Floats]:
    """Ellipses (k, 2), of circles in its front face, that pieces of the ink which a sweep leaves may be holes of."""
    sweep, view = found.sweep, found.compared.view
    if found.energy.lines == "removed" or sweep.way.centre is not None or not sweep.has_arcs:
        return
    left = view.points[found.compared.every[0] > near_line(found.noise)]
    shift, frame = sweep.frame.flat(sweep.way.shift), sweep.frame
    none = np.zeros(0)
    for piece in _pieces(left, scene):
        at = frame.flat(piece)
        low, high = at.min(axis=0), at.max(axis=0)
        along, wide = (high - low).tolist()
        # a seam, which programs draw between the faces, is a lone line
        is_wide = wide > SHALLOW_PENS * scene.skeleton.pen_width
        if is_wide and abs(along - wide - abs(shift[0])) * frame.ratio < 2 * scene.reach:
            circle = Circle(0.5 * (low + high - shift), 0.5 * wide)
            yield Outline(frame, np.zeros((0, 2)), none, none.astype(np.bool_), circle).line


def _pieces(points: Floats, scene: Scene) -> Iterator[Floats]:
    """Pixels (k, 2) of lines in groups that lie apart."""
    mask = np.zeros(scene.skeleton.mask.shape, np.uint8)
    x, y = np.rint(points).astype(np.intp).T
    mask[y, x] = 1
    side = int(2 * scene.reach) | 1
    _, labels = cv2.connectedComponents(cv2.dilate(mask, np.ones((side, side), np.uint8)))
    own = labels[y, x]
    for k in np.unique(own).tolist():
        yield points[own == k]
