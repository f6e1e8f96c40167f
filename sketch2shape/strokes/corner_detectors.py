"""Proposals: the places that the classic detectors take for corners.

Shi-Tomasi (J. Shi and C. Tomasi, "Good features to track", CVPR 1994) and Harris (C. Harris and M. Stephens, "A
combined corner and edge detector", Alvey 1988), both by OpenCV. In line drawings they fire at every vertex, and at much
else: so they decide nothing, but a vertex that neither of them has seen is doubtful.
"""

from __future__ import annotations

from typing import Any, Literal

import cv2
import numpy as np

from sketch2shape.errors import UsageError
from sketch2shape.model import Bools, Floats, Ink

Detector = Literal["auto", "both", "shi-tomasi", "goodFeaturesToTrack", "harris"]
DETECTORS: tuple[str, ...] = ("both", "shi-tomasi", "harris")
#: other names: OpenCV's function is Shi-Tomasi unless it is told otherwise
OTHER_NAMES = {"auto": "both", "goodfeaturestotrack": "shi-tomasi", "shitomasi": "shi-tomasi", "cornerharris": "harris"}
PEN = 2.5
"""Pen width, pixels, at which the detectors look: wider lines would be seen as two edges each."""
MOST = 600
QUALITY = {"shi-tomasi": 0.05, "harris": 0.004}
"""Least response as a part of the strongest. Harris' grows with the square of Shi-Tomasi's."""
MARK = 32
"""Side of the square beside the picture that holds a right angle for comparison, pixels."""


def detector_named(name: str) -> str:
    """The one of `DETECTORS` that a name means: itself, "goodFeaturesToTrack", ... Raises UsageError."""
    plain = str(name).lower().replace("_", "-")
    known = OTHER_NAMES.get(plain.replace("-", ""), plain)
    if known not in DETECTORS:
        listed = ", ".join(("auto", *DETECTORS, "goodFeaturesToTrack"))
        raise UsageError(f"no corner detector is called {name!r}", remedy=f"detector= one of {listed}")
    return known


def reach_of(ink: Ink, tolerance: float) -> float:
    """Working pixels between a corner and what a detector sees of it: a blunt pen moves it inwards."""
    return 3.0 + 1.5 * ink.pen_width + 2.0 * tolerance


def propose(ink: Ink, detector: str) -> Floats:
    """Places that "shi-tomasi", "harris" or "both" take for corners, strongest first: (k, 2) float, working pixels.

    Looked for around the ink only, in a picture so small that the pen is a few pixels wide.
    """
    if detector == "both":
        return np.concatenate([propose(ink, name) for name in DETECTORS[1:]])
    box = cv2.boundingRect(ink.mask.view(np.uint8))
    if not box[2]:
        return np.zeros((0, 2))
    margin = int(2 * ink.pen_width) + 4
    x, y = max(box[0] - margin, 0), max(box[1] - margin, 0)
    window = slice(y, box[1] + box[3] + margin), slice(x, box[0] + box[2] + margin)
    part: Any = ink.strength[window] * ink.mask[window]
    scale = min(1.0, PEN / ink.pen_width)
    if scale < 1.0:
        part = cv2.resize(part, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA)
    marked = cv2.copyMakeBorder(part, 0, max(0, MARK - part.shape[0]), 0, MARK, cv2.BORDER_CONSTANT)
    _mark(marked[:MARK, -MARK:], max(1, round(scale * ink.pen_width)))
    found = cv2.goodFeaturesToTrack(
        marked, MOST, QUALITY[detector], 4, blockSize=5, useHarrisDetector=detector == "harris", k=0.04
    )
    points = np.zeros((0, 2)) if found is None else found[:, 0].astype(float)
    points = points[points[:, 0] < part.shape[1]]
    return np.asarray((points + 0.5) / scale - 0.5 + [x, y])


def _mark(corner: Any, pen: int) -> None:
    """Draw a right angle with the same pen: what a corner is worth, in drawings that have none."""
    size = corner.shape[0]
    ends = np.array([[size // 2, size - 6], [size // 2, size // 2], [size - 6, size // 2]], np.int32)
    cv2.polylines(corner, [ends], False, 255, pen, cv2.LINE_AA)


def near(points: Floats, proposals: Floats, reach: float) -> Bools:
    """Whether each point has a proposal within reach."""
    if not len(proposals) or not len(points):
        return np.zeros(len(points), bool)
    gap = np.linalg.norm(points[:, None] - proposals[None], axis=2)
    return np.asarray(gap.min(axis=1) <= reach)
