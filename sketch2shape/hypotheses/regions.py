"""Regions: what the ink encloses, as polygons.

A region of a line drawing is one visible face, or a piece of it. Its border is followed and simplified; a thick or
hurried pen rounds corners and cuts off tips, so sides are fitted as lines and vertices are where these meet, and each
polygon comes in a few degrees of simplicity: how many vertices it has, only the whole object can tell.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np

from sketch2shape.model import Bools, Floats, Gray, as_gray

BORDER = 2
"""Empty pixels that are added around the ink, so that it is enclosed itself."""
MOST_LABELS = 250
"""Regions that are looked at, the largest: each has a level of a byte for its name."""
SMALL = 9
"""Radius of a disc, pixels, up to which OpenCV is the fastest to grow an area by it."""


@dataclass(frozen=True)
class Region:
    """A region that the ink encloses.

    outline : (n, 2) float, pixels, its border along the middle of the strokes
    islands : borders of what lies inside it: holes, letters
    """

    outline: Floats
    islands: tuple[Floats, ...] = ()


def enclosed_regions(mask: Bools, pen: float, tolerance: float, most: int = 40) -> list[Region]:
    """Regions that the ink encloses, the largest first.

    mask : (h, w) bool, the ink
    """
    grown = as_gray(cv2.copyMakeBorder(mask.view(np.uint8), BORDER, BORDER, BORDER, BORDER, cv2.BORDER_CONSTANT))
    close = max(1, int(tolerance))
    if close > 1:
        grown = grown_area(grown, close - 1)
    least = max(3 * pen * pen, 1e-4 * float(mask.shape[0] ** 2 + mask.shape[1] ** 2))
    label = grown.copy()
    found = []
    for k, seed in enumerate(_seeds(grown, least), start=2):
        area, _, _, box = cv2.floodFill(label, None, seed, k, flags=4)
        found.append((area, box, k))
    found = sorted((f for f in found if f[0] >= least), key=lambda f: -f[0])[:most]
    regions = (_region(label, box, k, pen + 2 * (close - 1), tolerance) for _, box, k in found)
    return [region for region in regions if region is not None]


def _seeds(ink: Gray, least: float) -> list[tuple[int, int]]:
    """x and y of the first pixel of every area of some size that the ink encloses, row by row."""
    contours, tree = cv2.findContours(ink, cv2.RETR_CCOMP, cv2.CHAIN_APPROX_NONE)
    if not contours:
        return []
    holes = [(cv2.contourArea(c), c) for c, above in zip(contours, tree[0, :, 3].tolist(), strict=True) if above >= 0]
    large = sorted((h for h in holes if h[0] >= least), key=lambda h: -h[0])[:MOST_LABELS]
    # the border of a hole is followed from the ink on the left of its first pixel
    return sorted(((int(c[0, 0, 0]) + 1, int(c[0, 0, 1])) for _, c in large), key=lambda seed: seed[::-1])


def grown_area(part: Gray, radius: int) -> Gray:
    """An area (0 or 1) grown by a disc: what `cv2.dilate` gives, whose time goes with the square of the radius."""
    disc = as_gray(cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * radius + 1, 2 * radius + 1)))
    if radius <= SMALL:
        return as_gray(cv2.dilate(part, disc))
    # each pixel of the rim covers a run in each row of the disc: count where runs begin and end
    h, w = part.shape
    rim = part - as_gray(cv2.erode(part, cv2.getStructuringElement(cv2.MORPH_CROSS, (3, 3))))
    y, x = np.divmod(np.flatnonzero(rim), w)
    half = disc.sum(axis=1, dtype=np.intp)[:, None] // 2
    row = (y + np.arange(2 * radius + 1)[:, None]) * (w + 1)
    size = (h + 2 * radius) * (w + 1)
    runs = np.bincount((row + np.maximum(x - half, 0)).ravel(), minlength=size)
    runs -= np.bincount((row + np.minimum(x + half + 1, w)).ravel(), minlength=size)
    covered = runs.reshape(-1, w + 1)[radius:-radius].cumsum(axis=1)[:, :w] > 0
    return as_gray((covered | (part > 0)).view(np.uint8))


def _region(label: Gray, box: Sequence[int], k: int, pen: float, tolerance: float) -> Region | None:
    """One region's polygons, their borders moved to the middle of the strokes, thin intrusions closed."""
    out, back = max(1, round(1.5 * pen)), max(0, round(1.0 * pen))
    margin = out + 1
    x, y, w, h = box
    part = np.zeros((h + 2 * margin, w + 2 * margin), np.uint8)
    np.equal(label[y : y + h, x : x + w], k, out=part[margin:-margin, margin:-margin].view(np.bool_))
    part = grown_area(part, out)
    if back:
        part = 1 - grown_area(1 - part, back)
    contours, tree = cv2.findContours(part, cv2.RETR_CCOMP, cv2.CHAIN_APPROX_NONE)
    shift = np.array([x - margin - BORDER, y - margin - BORDER], float)
    areas = [cv2.contourArea(c) for c in contours]
    outer = max((i for i in range(len(contours)) if tree[0, i, 3] < 0), key=lambda i: areas[i])
    inner = [i for i in range(len(contours)) if tree[0, i, 3] == outer and areas[i] > 0.004 * areas[outer]]
    polygons = [cv2.approxPolyDP(contours[i], tolerance + 0.35 * pen, True)[:, 0] + shift for i in [outer, *inner[:8]]]
    if not 3 <= len(polygons[0]) <= 64:
        return None
    return Region(polygons[0], tuple(p for p in polygons[1:] if 3 <= len(p) <= 64))


def _meet(a: tuple[Floats, Floats], b: tuple[Floats, Floats]) -> Floats | None:
    """Intersection of two lines (point, direction), unless they are nearly parallel."""
    (p, u), (q, v) = a, b
    det = float(u[0] * v[1] - u[1] * v[0])
    if abs(det) < 0.12 * float(np.linalg.norm(u) * np.linalg.norm(v)):
        return None
    w = q - p
    return np.asarray(p + u * float(w[0] * v[1] - w[1] * v[0]) / det)


def sharpened(polygon: Floats, short: float) -> Floats:
    """The polygon with rounded corners made sharp: its short edges give way to where their neighbours' lines meet."""
    while len(polygon) > 3:
        after = np.roll(polygon, -1, axis=0)
        length = np.linalg.norm(after - polygon, axis=1)
        for k in np.argsort(length):
            if length[k] >= short:
                return polygon
            tip = _tip(polygon, int(k), 2.5 * short)
            if tip is not None:
                polygon = polygon.copy()
                polygon[k] = tip
                polygon = np.delete(polygon, (k + 1) % len(polygon), axis=0)
                break
        else:
            return polygon
    return polygon


def _tip(polygon: Floats, k: int, far: float) -> Floats | None:
    """Where the edges before and after edge k meet, if they do so beyond it and not too far away."""
    n = len(polygon)
    a, b, c, d = polygon[k - 1], polygon[k], polygon[(k + 1) % n], polygon[(k + 2) % n]
    u, v = b - a, c - d
    tip = _meet((a, u), (d, v))
    if tip is None:
        return (b + c) / 2 if np.linalg.norm(c - b) < 0.3 * far else None
    beyond = (tip - b) @ u >= 0 and (tip - c) @ v >= 0
    return np.asarray(tip) if beyond and np.linalg.norm(tip - (b + c) / 2) <= far else None


def reductions(polygon: Floats, worst: float = 0.1) -> list[Floats]:
    """The polygon with ever fewer vertices, the full one first, as long as little of its area is given or taken.

    Each step drops the vertex, or replaces the edge by the point where its neighbours meet, that costs least.
    worst : part of the area that may be lost or added in all
    """
    total = float(cv2.contourArea(polygon.astype(np.float32)))
    found, spent = [polygon], 0.0
    while len(polygon) > 3:
        cost, simpler = min((_without_edge(polygon, k) for k in range(len(polygon))), key=lambda c: c[0])
        other, dropped = min((_without_vertex(polygon, k) for k in range(len(polygon))), key=lambda c: c[0])
        if other <= cost:
            cost, simpler = other, dropped
        spent += cost
        if spent > worst * total:
            break
        polygon = simpler
        found.append(polygon)
    return found


def _without_vertex(polygon: Floats, k: int) -> tuple[float, Floats]:
    n = len(polygon)
    return _triangle(polygon[k - 1], polygon[k], polygon[(k + 1) % n]), np.delete(polygon, k, axis=0)


def _without_edge(polygon: Floats, k: int) -> tuple[float, Floats]:
    n = len(polygon)
    b, c = polygon[k], polygon[(k + 1) % n]
    tip = _tip(polygon, k, 2.5 * float(np.linalg.norm(c - b)) + 4.0)
    if tip is None:
        return np.inf, polygon
    return _triangle(b, tip, c), _collapsed(polygon, k, tip)


def without_edge(polygon: Floats, k: int) -> Floats:
    """The polygon with its k-th edge drawn together to where its neighbours meet, or to its middle."""
    b, c = polygon[k], polygon[(k + 1) % len(polygon)]
    tip = _tip(polygon, k, 2.5 * float(np.linalg.norm(c - b)) + 4.0)
    return _collapsed(polygon, k, (b + c) / 2 if tip is None else tip)


def _collapsed(polygon: Floats, k: int, tip: Floats) -> Floats:
    fewer = polygon.copy()
    fewer[k] = tip
    return np.delete(fewer, (k + 1) % len(polygon), axis=0)


def _triangle(a: Floats, b: Floats, c: Floats) -> float:
    u, v = b - a, c - a
    return 0.5 * abs(float(u[0] * v[1] - u[1] * v[0]))
