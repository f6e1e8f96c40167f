"""Page: the sheet of paper in a photo, the table around it, and the map that takes the tilt away.

The paper map of the ground knows neither strokes nor texture; where it is smooth lies one surface, and a step is the
edge of the page, of the table or of a shadow. The page is made of the surfaces that carry the ink.
"""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from sketch2shape.geometry import signed_area
from sketch2shape.ink.resampling import averaged
from sketch2shape.model import Bools, Floats, Gray, as_gray

MAP_SIDE = 256
"""Long side of the map on which surfaces are told apart, pixels."""
STEP = 0.045
"""Relative step of brightness between neighbouring map pixels that parts two surfaces."""
INK_SHARE = 0.1
"""A surface with this share of the ink of the main one belongs to the page: a shadow parts them."""
FAINTEST = 0.1
"""Share of ink from which a map pixel belongs to a stroke."""
LEAST_SHARED = 4
"""Map pixels that a stroke has on each of two surfaces that it joins."""
SAME_COLOUR = 1.25
"""Greatest ratio between the channels' losses of light in a shadow."""
TEXTURE = 0.25
"""Share of ink above which a surface is textured, not drawn on."""


def find_page(paper: Gray, mask: Bools) -> tuple[Bools | None, Floats | None]:
    """Find the surface that was drawn on.

    paper   : (height, width, 3) colours of the ground without ink, any size
    mask    : (h, w) ink, working size
    returns : (h, w) bool, True on the page, and its corners as (4, 2) working pixels (clockwise, from the top left one)
              where all four sides of a page are in view; None for what does not exist
    """
    h, w = mask.shape
    factor = MAP_SIDE / max(h, w)
    size = (max(8, round(w * factor)), max(8, round(h * factor)))
    surface = _surface(as_gray(cv2.resize(paper, size, interpolation=cv2.INTER_LINEAR)), mask)
    if surface is None:
        return None, None
    inside = cv2.erode(surface, np.ones((7, 7), np.uint8), borderType=cv2.BORDER_CONSTANT, borderValue=0)
    on_page = cv2.resize(inside, (w, h), interpolation=cv2.INTER_NEAREST)
    corners = _quadrilateral(surface)
    if corners is not None:
        corners = (corners + 0.5) * np.array([w / size[0], h / size[1]]) - 0.5
    return np.asarray(on_page > 0, dtype=np.bool_), corners


def _surface(paper: Gray, mask: Bools) -> Gray | None:
    """0/1 map of the surfaces that carry the ink, holes filled; None where there is but one surface."""
    step = cv2.morphologyEx(paper, cv2.MORPH_GRADIENT, np.ones((3, 3), np.uint8))
    limit = np.maximum(as_gray(cv2.convertScaleAbs(paper, alpha=2 * STEP)), np.uint8(3))
    over = as_gray(step > limit)
    edge = cv2.transform(over, np.ones((1, 3), np.float32)) > 0
    drawn = averaged(mask * np.uint8(255), (paper.shape[1], paper.shape[0]))
    ink = drawn * np.float32(1 / 255)
    smooth = as_gray(~edge & (cv2.blur(ink, (9, 9)) <= 1.4 * TEXTURE))
    count, found = cv2.connectedComponents(smooth, connectivity=4)
    labels = found.astype(np.intp)
    sizes = np.bincount(labels.ravel(), minlength=count)
    if count < 2 or sizes[1:].max() > 0.97 * ink.size:
        return None
    inner = labels * cv2.erode(smooth, np.ones((5, 5), np.uint8))  # the rim holds what is left of the step
    held = np.bincount(inner.ravel(), weights=ink.ravel(), minlength=count)
    area = np.bincount(inner.ravel(), minlength=count).astype(np.float64)
    empty = held < TEXTURE * area  # a page is mostly empty, a wooden table is not
    empty[0] = False
    if not empty.any():
        return None
    rim = np.bincount(np.r_[labels[0], labels[-1], labels[:, 0], labels[:, -1]], minlength=count)
    whole = empty & (rim == 0) & (area > 0.08 * ink.size) & (held > 0.5 * held[empty].sum())
    main = int(np.argmax(np.where(whole if whole.any() else empty, area, 0.0)))
    strip = rim**2 > 9.0 * sizes  # table along the picture's frame
    carries = ~strip & (held >= INK_SHARE * max(held[main], 1.0))
    wide = empty & (area > 0.02 * ink.size)
    kept = (wide & carries) | _shaded(paper, ink, inner, main, wide & ~carries)
    kept[main] = True
    region = cv2.morphologyEx(kept[labels].astype(np.uint8), cv2.MORPH_CLOSE, np.ones((7, 7)))
    contours, _ = cv2.findContours(region, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    contours = [c for c in contours if cv2.contourArea(c) > 0.02 * ink.size]
    if len(contours) > 1:  # parted by a shadow; a page is convex
        contours = [cv2.convexHull(np.concatenate(contours))]
    filled = np.zeros(ink.shape, np.uint8)
    cv2.drawContours(filled, contours, -1, 1, cv2.FILLED)
    return filled if 0.1 * ink.size < np.count_nonzero(filled) < 0.97 * ink.size else None


def _shaded(paper: Gray, ink: NDArray[Any], inner: NDArray[Any], main: int, others: Bools) -> Bools:
    """(n,) surfaces of `others` into which strokes run from the main one, with its colour under other light."""
    result = np.zeros(len(others), dtype=np.bool_)
    if not others.any():
        return result
    pieces, piece = cv2.connectedComponents(as_gray(ink > FAINTEST), connectivity=8)
    shared = np.bincount(piece[inner == main], minlength=pieces) >= LEAST_SHARED
    shared[0] = False
    strokes = shared[piece]
    colour = np.array(cv2.mean(paper, as_gray(inner == main))[:3])
    for other in np.flatnonzero(others):
        here = inner == other
        if np.count_nonzero(strokes & here) >= LEAST_SHARED:
            light = np.array(cv2.mean(paper, as_gray(here))[:3]) / np.maximum(colour, 1.0)
            result[other] = light.max() < SAME_COLOUR * light.min()
    return result


def _quadrilateral(region: Gray) -> Floats | None:
    """(4, 2) corners of a four-sided region, clockwise from the top left; they may lie outside the picture."""
    contours, _ = cv2.findContours(region, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    outline = np.concatenate(contours).reshape(-1, 2).astype(np.float64)
    last = np.array(region.shape[::-1]) - 1.0
    outline = outline[np.all((outline > 1.5) & (outline < last - 1.5), axis=1)]
    if len(outline) < region.shape[0]:
        return None
    hull = cv2.convexHull(np.concatenate(contours))
    polygon = cv2.approxPolyDP(hull, 0.012 * cv2.arcLength(hull, True), True).reshape(-1, 2).astype(np.float64)
    lines = [line for a, b in zip(polygon, np.roll(polygon, -1, axis=0), strict=True) if (line := _side(outline, a, b))]
    if len(lines) != 4:
        return None
    crossings = np.cross(np.roll(lines, 1, axis=0), lines)
    if np.any(np.abs(crossings[:, 2]) < 0.5):
        return None
    corners = crossings[:, :2] / crossings[:, 2:]
    if not cv2.isContourConvex(corners.astype(np.float32)):
        return None
    corners = np.roll(corners, -int(np.argmin(corners.sum(axis=1))), axis=0)
    clockwise = signed_area(corners) > 0  # as seen: y runs down
    return np.asarray(corners if clockwise else np.roll(corners[::-1], 1, axis=0), dtype=np.float64)


def _side(outline: Floats, a: Floats, b: Floats) -> tuple[float, float, float] | None:
    """Homogeneous line through the outline's points near the segment a-b; None if the outline is not there."""
    along = b - a
    length = float(np.hypot(*along))
    if length < 0.12 * MAP_SIDE:
        return None
    x, y = (outline - a) @ along / length, np.abs((outline - a) @ np.array([-along[1], along[0]])) / length
    near = outline[(y < 4.0) & (x > 0.04 * length) & (x < 0.96 * length)]
    if len(near) < 0.3 * length:
        return None
    ux, uy, px, py = (float(v) for v in cv2.fitLine(near.astype(np.float32), cv2.DIST_HUBER, 0, 0.01, 0.01).ravel())
    return -uy, ux, uy * px - ux * py


def page_homography(corners: Floats, centre: Floats) -> Floats:
    """(3, 3) map from picture pixels to the page seen straight on, at about the page's size in the picture.

    corners : (4, 2) pixels, clockwise from the top left
    centre  : (2,) pixels, where the optical axis meets the picture (its middle)

    The aspect ratio comes from the two vanishing points and square pixels (Zhang and He, "Whiteboard scanning and image
    enhancement", 2007); where the tilt is too small for that, from the mean lengths of opposite sides.
    """
    a, b, c, d = corners
    across = 0.5 * (np.linalg.norm(b - a) + np.linalg.norm(c - d))
    down = 0.5 * (np.linalg.norm(d - a) + np.linalg.norm(c - b))
    ratio = _aspect(corners - centre) or across / down
    width = float(np.sqrt(across * down * ratio))
    height = width / ratio
    target = np.array([[0.0, 0.0], [width, 0.0], [width, height], [0.0, height]])
    target += corners.mean(axis=0) - target.mean(axis=0)
    matrix = cv2.getPerspectiveTransform(corners.astype(np.float32), target.astype(np.float32))
    return np.asarray(matrix, dtype=np.float64)


def _aspect(corners: Floats) -> float | None:
    """Width over height of the rectangle seen as these corners (origin on the optical axis); None if undecidable."""
    a, b, c, d = np.c_[corners, np.ones(4)]
    size = float(np.abs(corners).max())
    k2 = np.dot(np.cross(a, c), d) / np.dot(np.cross(b, c), d)
    k3 = np.dot(np.cross(a, c), b) / np.dot(np.cross(d, c), b)
    n2, n3 = k2 * b - a, k3 * d - a
    if abs(n2[2]) < 0.03 or abs(n3[2]) < 0.03:
        return None
    focal2 = -(n2[0] * n3[0] + n2[1] * n3[1]) / (n2[2] * n3[2])
    if not (0.5 * size) ** 2 < focal2 < (12 * size) ** 2:
        return None
    across, down = (np.sqrt((n[0] ** 2 + n[1] ** 2) / focal2 + n[2] ** 2) for n in (n2, n3))
    ratio = float(across / down)
    return ratio if 0.3 < ratio < 3.4 else None
