"""Visibility: which parts of a hypothesis lie behind it.

No depth is needed: the object is the front face swept along the connecting lines, so a point of a side or of the back
face is hidden exactly if the way back along its connecting line to the front face crosses the front face's interior.
The way is looked up at a few samples; a connecting edge, whose samples share one way, at many.
"""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from sketch2shape.model import Bools, Floats
from sketch2shape.rings import Rings, Stack, stack

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
_STEPS = np.linspace(0.0, 1.0, WAY_BACK, dtype=np.float32)[:, None, None]


def edge_samples(stacked: Stack) -> tuple[Floats, Floats]:
    """Points along every edge and the points of the front face they come from: both (b, 3m, SAMPLES, 2)."""
    edges, half = stacked.frame.edges, stacked.vertices.shape[1] // 2
    v = stacked.vertices
    a, base = v[:, edges[:, 0], None], v[:, edges[:, 0] % half, None]
    points = a + _ALONG * (v[:, edges[:, 1], None] - a)
    return points, base + _ALONG * (v[:, edges[:, 1] % half, None] - base)


def hidden_samples(rings: Rings, margin: float) -> tuple[Bools, Bools]:
    """Which edge samples lie behind the object, surely and perhaps: both (3m, SAMPLES) bool (see `hidden_depth`)."""
    one = stack([rings])
    depth = hidden_depth(one, *edge_samples(one), margin)[0]
    return depth == 2, depth >= 1


def hidden_depth(stacked: Stack, points: Floats, base: Floats, margin: float) -> NDArray[np.uint8]:
    """(b, 3m, SAMPLES) uint8: 2 for edge samples that surely lie behind the object, 1 for those that perhaps do.

    points, base : of `edge_samples`
    margin       : pixels. What lies deeper than this behind the outline is surely hidden; what is shallower may be a
                   matter of the pen
    """
    v = stacked.vertices
    low = np.floor(v.min(axis=1)) - 3
    high = np.ceil(v.max(axis=1)) + 3
    factor = np.minimum(1.0, RASTER / np.maximum((high - low).max(axis=1), 1.0))
    behind = stacked.frame.behind
    start = ((base[:, behind] - low[:, None, None]) * factor[:, None, None, None] + 0.5).astype(np.float32)
    way = ((points - base)[:, behind] * factor[:, None, None, None]).astype(np.float32)
    depth = np.zeros(points.shape[:3], np.uint8)
    rungs = stacked.frame.rungs
    for k in range(len(v)):
        inside, grazed = _interior(v[k], stacked, low[k], high[k], float(factor[k]), margin)
        # the near end of the way back lies on the outline itself, the far end is the point: its own cap counts too
        x = (start[k, ..., 0] + _STEPS * way[k, ..., 0]).astype(np.intp)
        y = (start[k, ..., 1] + _STEPS * way[k, ..., 1]).astype(np.intp)
        depth[k, behind] = inside.ravel().take(y * inside.shape[1] + x, mode="clip").max(axis=0)
        m = len(rungs)
        tips = _behind_a_tip((v[k, :m] - low[k]) * factor[k], (v[k, m:] - low[k]) * factor[k], grazed)
        depth[k, rungs] = np.maximum(depth[k, rungs], tips)
    return depth


def _behind_a_tip(front: Floats, back: Floats, inside: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """(m, SAMPLES) 1 where a connecting edge has run behind as little as a tip of the front face, by its fine samples.

    front, back : (m, 2) float, its ends in pixels of the raster `inside`, 1 in the front face but for its outline
    """
    way = back - front
    length = np.hypot(way[:, 0], way[:, 1])[:, None]
    at = front[:, None] + 0.5 + _FINE[:, None] * way[:, None]
    x, y = at[..., 0].astype(np.intp), at[..., 1].astype(np.intp)
    met = inside.ravel().take(y * inside.shape[1] + x, mode="clip")
    met[_FINE * length < AT_LEAST] = 0
    return np.asarray(np.maximum.accumulate(met, axis=1)[:, _EVERY], np.uint8)


def _interior(
    vertices: Floats, stacked: Stack, low: Floats, high: Floats, factor: float, margin: float
) -> tuple[NDArray[np.uint8], NDArray[np.uint8]]:
    """The front face, rasterised: 0 outside, 1 within margin pixels of its outline, 2 deeper inside.

    And once more, 1 inside, with an outline as thin as can be.
    """
    w, h = (((high - low) * factor).astype(int) + 1).tolist()
    canvas = np.zeros((h, w), np.uint8)
    pixels = ((vertices[: len(vertices) // 2] - low) * factor).round().astype(np.int32)
    outlines = [pixels[a:b] for a, b in stacked.frame.spans]
    for k, outline in enumerate(outlines):
        cv2.fillPoly(canvas, [outline], 0 if k else 2)
    grazed = canvas // 2
    cv2.polylines(grazed, outlines, True, 0, 1)
    # the rim is 1, as wide as the margin, but for the outline itself
    rim = np.zeros((h, w), np.uint8)
    cv2.polylines(rim, outlines, True, 1, 2 * max(1, round(margin * factor)) + 1)
    canvas -= np.minimum(canvas, rim)
    cv2.polylines(canvas, outlines, True, 0, 3)
    return canvas, grazed
