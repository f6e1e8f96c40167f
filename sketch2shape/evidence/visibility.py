"""Visibility: which parts of a hypothesis lie behind it.

No depth is needed: the object is the front face swept along the connecting lines, so a point of a side or of the back
face is hidden exactly if the way back along its connecting line to the front face crosses the front face's interior.
The way is looked up at a few samples; a connecting edge, whose samples share one way, at many.
"""

from __future__ import annotations

from functools import lru_cache

import cv2
import numpy as np
from numpy.typing import NDArray

from sketch2shape.hypotheses import Rings, Stack, stack
from sketch2shape.model import Bools, Floats, Ints

SAMPLES = 32
"""Samples of an edge."""
WAY_BACK = 20
"""Steps on the way back to the front face."""
RASTER = 300.0
"""Largest side of the raster in which the front face is looked up, pixels."""

FINE = 5
"""Fine samples of a connecting edge for each of its samples."""
AT_LEAST = 3.0
"""Pixels of the raster from its vertex before a connecting edge can be behind anything."""

_FINE = (np.arange(SAMPLES * FINE) + 0.5) / (SAMPLES * FINE)
_EVERY = np.arange(SAMPLES) * FINE + FINE // 2
_ALONG = ((np.arange(SAMPLES) + 0.5) / SAMPLES)[:, None]
_STEPS = np.linspace(0.0, 1.0, WAY_BACK, dtype=np.float32)[:, None, None, None]


def edge_samples(stacked: Stack) -> Floats:
    """Points along every edge, (b, 3m, SAMPLES, 2) pixels."""
    edges, v = stacked.frame.edges, stacked.vertices
    a = v[:, edges[:, 0], None]
    return np.asarray(a + _ALONG * (v[:, edges[:, 1], None] - a))


def hidden_samples(rings: Rings, margin: float) -> tuple[Bools, Bools]:
    """Which edge samples lie behind the object, surely and perhaps: both (3m, SAMPLES) bool (see `hidden_depth`)."""
    one = stack([rings])
    depth = hidden_depth(one, margin)[0]
    return depth == 2, depth >= 1


def hidden_depth(stacked: Stack, margin: float) -> NDArray[np.uint8]:
    """(b, 3m, SAMPLES) uint8: 2 for edge samples that surely lie behind the object, 1 for those that perhaps do.

    margin : pixels. What lies deeper than this behind the outline is surely hidden; what is shallower may be a matter
             of the pen
    """
    if len(stacked) > 1:
        return _depth(stacked, margin)
    # the answer of a search is judged, and then held against the drawing
    return _depth_of_one(stacked.vertices.tobytes(), stacked.sizes, margin)


@lru_cache(maxsize=4)
def _depth_of_one(vertices: bytes, sizes: tuple[int, ...], margin: float) -> NDArray[np.uint8]:
    """`hidden_depth` of one hypothesis; read-only."""
    one = Stack(np.frombuffer(vertices).reshape(1, -1, 2), sizes)
    depth = _depth(one, margin)
    depth.flags.writeable = False
    return depth


def _depth(stacked: Stack, margin: float) -> NDArray[np.uint8]:
    """See `hidden_depth`."""
    points = edge_samples(stacked)
    v, fronts, backs = stacked.vertices, stacked.frame.fronts, stacked.frame.backs
    low = np.floor(v.min(axis=1)) - 3
    high = np.ceil(v.max(axis=1)) + 3
    factor = np.minimum(1.0, RASTER / np.maximum((high - low).max(axis=1), 1.0))[:, None, None]
    # a point of an edge of the back comes from the same point of the front's
    start = ((points[:, fronts] - low[:, None, None]) * factor[..., None]).astype(np.float32)
    way = ((points[:, backs] - points[:, fronts]) * factor[..., None]).astype(np.float32)
    vertices = (v - low[:, None]) * factor
    m = len(backs)
    outlines = np.rint(vertices[:, :m]).astype(np.int32)
    deep = vertices[:, m:] - vertices[:, :m]
    rungs = (vertices[:, :m, None] + _FINE[:, None] * deep[:, :, None]).astype(np.float32)
    rims = np.maximum(1, np.rint(margin * factor[:, 0, 0])).astype(int).tolist()
    sizes = (((high - low) * factor[:, 0]).astype(int) + 1).tolist()
    near = _FINE * np.hypot(deep[..., 0], deep[..., 1])[..., None] < AT_LEAST
    depth = np.zeros(points.shape[:3], np.uint8)
    met = np.empty((len(v), m, SAMPLES * FINE), np.uint8)
    for k, outline in enumerate(outlines):
        inside, thin = _interior([outline[a:b] for a, b in stacked.frame.spans], sizes[k], rims[k])
        # the near end of the way back lies on the outline itself, the far end is the point: its own cap counts too
        ways = (start[k] + _STEPS * way[k]).reshape(len(_STEPS), -1, 2)
        depth[k, backs] = looked_up(inside, ways).max(axis=0).reshape(m, -1)
        met[k] = looked_up(thin, rungs[k])
    met[near] = 0
    depth[:, stacked.frame.rungs] = np.maximum.accumulate(met, axis=2)[..., _EVERY]
    return depth


def in_picture(points: Floats, cut: Floats) -> Bools:
    """Whether points (..., 2) lie in the picture; cut (2, 2): its least and greatest x and y, pixels."""
    return np.asarray(((points >= cut[0]) & (points <= cut[1])).all(axis=-1))


def looked_up(raster: NDArray[np.uint8], at: NDArray[np.float32]) -> NDArray[np.uint8]:
    """Values of the raster at points (r, c, 2), (r, c); 0 outside."""
    # the second map may be None, whatever OpenCV's type hints say
    seen = cv2.remap(raster, at, None, cv2.INTER_NEAREST, borderMode=cv2.BORDER_CONSTANT)  # type: ignore[call-overload]
    return np.asarray(seen, np.uint8)


def _interior(outlines: list[Ints], size: list[int], rim: int) -> tuple[NDArray[np.uint8], NDArray[np.uint8]]:
    """The front face, rasterised: 0 outside, 1 within rim pixels of its outline, 2 deeper inside.

    outlines : (n, 2) int32, pixels of the raster
    size     : width and height of the raster

    First with an outline that is 0 and 3 pixels wide, then with one as thin as can be.
    """
    filled = np.zeros(size[::-1], np.uint8)
    for k, outline in enumerate(outlines):
        cv2.fillPoly(filled, [outline], 0 if k else 2)
    inside = filled.copy()
    cv2.polylines(inside, outlines, True, 1, 2 * rim + 1)
    cv2.min(inside, filled, dst=inside)
    thin = inside.copy()
    cv2.polylines(thin, outlines, True, 0, 1)
    cv2.polylines(inside, outlines, True, 0, 3)
    return inside, thin
