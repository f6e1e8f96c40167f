"""Hatching: a face shaded with parallel lines keeps its outline only.

A hatched face is an area that closes under a small box; inside it nearly all gradients point the same way, and a walk
across the lines meets many of them at short, even distances. Lines of other directions through it are edges.
"""

from __future__ import annotations

from collections.abc import Iterator

import cv2
import numpy as np

from sketch2shape.ink.kernels import square
from sketch2shape.ink.pen_width import rough_pen_width
from sketch2shape.model import Bools, Floats, Gray

SPACING = 0.018
"""Lines of a hatching are at most this share of the picture's diagonal apart."""
EXTENTS = (0.05, 0.03)
"""A hatched face holds a square of such a share of the diagonal: a narrow one a small square."""
LINES = 10
"""Least number of lines that a walk across a hatching meets."""
COHERENCE = 0.6
"""Least share of the gradients' energy across the lines, less that along them."""
UNEVEN = 0.35
"""Greatest standard deviation of the distances between the lines over their mean."""
LEAVING = 1.0
"""Greatest number of lines that leave a hatched face, edges at its corners, by that of the lines of the hatching."""
TURNS = 36
"""Directions that are tried for the edges through a hatching."""
ALONG = np.radians(12.5)
"""Angle up to which a line runs along a hatching, radians."""
ROOM = 6
"""Pixels around an area in which it is looked at, more than what asks for neighbours sees."""
CROSSED = 1.5
"""Length of the lines that tell the directions of a cross-hatching, over the greatest distance of hatch lines."""
CELLS, MOSTLY_CELLS = 40, 0.7
"""Small cells between the lines of a cross-hatching, at least, and the part of what is bare that they cover."""


def without_hatching(mask: Bools, diagonal: float) -> Bools:
    """The ink without hatch lines.

    mask     : (h, w) ink
    diagonal : of the picture of which this is a part, pixels
    returns  : (h, w); the same array where nothing is hatched
    """
    pen_width = rough_pen_width(mask)
    if pen_width > 0.6 * SPACING * diagonal:
        return mask
    for extent in EXTENTS:
        mask = _without_areas(mask, pen_width, diagonal, extent * diagonal)
    return mask


def _without_areas(mask: Bools, pen_width: float, diagonal: float, extent: float) -> Bools:
    """The ink without the lines of hatched areas that hold a square with sides of `extent` pixels."""
    ink = np.asarray(mask, np.bool_).view(np.uint8)
    box = square(extent)
    if not _may_be_dense(ink, SPACING * diagonal, extent):
        return mask
    closed = cv2.morphologyEx(ink, cv2.MORPH_CLOSE, square(SPACING * diagonal))
    core = cv2.erode(closed, box)
    if not core.any():
        return mask
    _, labels = cv2.connectedComponents(core, connectivity=8)
    result = mask
    for label in range(1, min(int(labels.max()), 8) + 1):
        area = _grown(np.asarray(labels == label, dtype=np.uint8), np.asarray(closed, dtype=np.uint8), box)
        x, y, w, h = cv2.boundingRect(area)
        frame = slice(max(y - ROOM, 0), y + h + ROOM), slice(max(x - ROOM, 0), x + w + ROOM)
        here, area = ink[frame], area[frame]
        inner = cv2.erode(area, square(2.0 * pen_width + 5.0)) > 0
        angles, lines = _hatched(here, area, inner, SPACING * diagonal)
        if not lines or _leaving(here, area) > LEAVING * lines:
            continue
        x, y, w, h = cv2.boundingRect(area)
        edges = np.zeros_like(inner)
        edges[y : y + h, x : x + w] = _other_lines(here[y : y + h, x : x + w], angles, 2.5 * SPACING * diagonal)
        result = result.copy()
        result[frame] &= ~inner | edges
    return result


def _may_be_dense(ink: Gray, spacing: float, extent: float) -> bool:
    """Whether anything closes into an area, seen at a quarter of the size, where gaps are no wider than they are."""
    coarse = cv2.dilate(ink, np.ones((4, 4), np.uint8))[::4, ::4]
    closed = cv2.morphologyEx(coarse, cv2.MORPH_CLOSE, square(spacing / 4 + 2.0))
    return bool(cv2.erode(closed, np.ones((max(1, int(extent / 4) - 1),) * 2, np.uint8)).any())


def _grown(core: Gray, closed: Gray, box: Gray) -> Gray:
    """The dense area around a core, with the corners that a box does not reach."""
    area = np.asarray(cv2.dilate(core, box), dtype=np.uint8) & closed
    for _ in range(len(box) // 3):
        area = np.asarray(cv2.dilate(area, np.ones((5, 5), np.uint8)), dtype=np.uint8) & closed
    return area


def _hatched(ink: Gray, area: Gray, inner: Bools, spacing: float) -> tuple[list[float], int]:
    """Directions of the lines that hatch an area, one or two, radians, and about how many they are; 0 if none do.

    inner : (h, w) the area without its outline, of which a narrow one is mostly made
    """
    inside = cv2.erode(area, np.ones((7, 7), np.uint8)) > 0
    soft = cv2.GaussianBlur(ink * np.uint8(255), (3, 3), 0)
    gradients = [np.asarray(cv2.Sobel(soft, cv2.CV_32F, i, 1 - i), dtype=np.float64) for i in (1, 0)]
    for part in (inside, inner):
        angle = _direction(*(plane[part] for plane in gradients))
        if angle is not None:
            return [angle], _even_lines(ink, area, angle, spacing)
    lines = _lines_of_cells(ink, inside, spacing)
    return (_two_directions(ink, inside, CROSSED * spacing), lines) if lines else ([], 0)


def _direction(gx: Floats, gy: Floats) -> float | None:
    """Angle of the lines in an area, radians, from the structure tensor; None if they have no common direction.

    gx, gy : (k,) gradients of the ink at its pixels
    """
    xx, yy, xy = float(gx @ gx), float(gy @ gy), float(gx @ gy)
    if np.hypot(xx - yy, 2 * xy) < COHERENCE * (xx + yy) or xx + yy == 0.0:
        return None
    return 0.5 * float(np.arctan2(2 * xy, xx - yy)) + np.pi / 2


def _two_directions(ink: Gray, inside: Bools, length: float) -> list[float]:
    """Angles of the lines that cross each other all over an area, radians: most ink lies on lines of such a length."""
    x, y, w, h = cv2.boundingRect(inside.view(np.uint8))
    part = np.where(inside, ink, 0).astype(np.uint8)[y : y + h, x : x + w]
    ways = np.arange(TURNS) * np.pi / TURNS
    held = np.array([np.count_nonzero(cv2.morphologyEx(part, cv2.MORPH_OPEN, _line(way, length))) for way in ways])
    first = int(held.argmax())
    second = int(np.where(_between(ways, ways[first]) > 2.0 * ALONG, held, -1).argmax())
    return [float(ways[first]), float(ways[second])]


def _between(ways: Floats, way: float) -> Floats:
    """Angles between lines, radians, 0 to pi / 2."""
    return np.asarray(np.abs((ways - way + np.pi / 2) % np.pi - np.pi / 2))


def _lines_of_cells(ink: Gray, inside: Bools, spacing: float) -> int:
    """About how many lines cross each other in an area, by the cells between them; 0 if cells are few or large."""
    stats = cv2.connectedComponentsWithStats((inside & (ink == 0)).view(np.uint8), connectivity=4)[2]
    sizes = stats[1:, cv2.CC_STAT_AREA]
    small = sizes < spacing * spacing
    many = np.count_nonzero(small) >= CELLS and sizes[small].sum() >= MOSTLY_CELLS * sizes.sum()
    return int(2.0 * np.sqrt(np.count_nonzero(small))) if many else 0


def _leaving(ink: Gray, area: Gray) -> int:
    """How many lines leave the area; edges that happen to run close together do so at both ends."""
    near, far = (cv2.dilate(area, np.ones((n, n), np.uint8)) for n in (5, 9))
    ring = (far > 0) & (near == 0)
    return int(cv2.connectedComponents((ring & (ink > 0)).view(np.uint8), connectivity=8)[0]) - 1


def _even_lines(ink: Gray, area: Gray, angle: float, spacing: float) -> int:
    """How many lines the straight walk meets that meets most at short and even distances; 0 if they are few."""
    mask = cv2.dilate(ink, np.ones((2, 2), np.uint8)) > 0  # else a walk slips through diagonal lines
    ys, xs = np.nonzero(area)
    centre = np.array([xs.mean(), ys.mean()])
    reach = 0.5 * float(np.hypot(np.ptp(xs), np.ptp(ys)))
    most = 0
    for turn in (0.5, 0.25, 0.37, 0.63, 0.75):
        way = angle + turn * np.pi
        step, aside = np.array([np.cos(way), np.sin(way)]), np.array([-np.sin(way), np.cos(way)])
        # a walk across a dented face may leave it on the way; another one does not
        starts = centre + np.linspace(-0.75, 0.75, 9)[:, None] * reach * aside
        for gaps in _gaps(mask, area, starts, step, reach):
            gaps = gaps * np.sin(turn * np.pi)
            if len(gaps) > max(most, LINES - 2) and np.median(gaps) < spacing and np.std(gaps) < UNEVEN * np.mean(gaps):
                most = len(gaps)
    return most + 1 if most else 0


def _gaps(mask: Bools, area: Gray, starts: Floats, step: Floats, reach: float) -> Iterator[Floats]:
    """Distances between the lines met on each way from start - reach to start + reach, within the area, if many are."""
    x, y = np.round(starts[:, None] + np.arange(-reach, reach, 0.5)[:, None] * step).astype(int).transpose(2, 0, 1)
    h, w = mask.shape
    inside = (x >= 0) & (x < w) & (y >= 0) & (y < h)
    x, y = np.where(inside, x, 0), np.where(inside, y, 0)
    inside &= area[y, x] > 0
    met = mask[y, x]
    # no more than if a line began wherever the way comes back into the area
    lines = np.count_nonzero(np.diff((met & inside).view(np.int8), axis=1) == 1, axis=1)
    for k in np.flatnonzero(lines >= LINES):
        own = met[k, inside[k]].view(np.int8)
        yield 0.5 * np.diff(np.flatnonzero(np.diff(own) == 1)).astype(np.float64)


def _other_lines(ink: Gray, angles: list[float], length: float) -> Bools:
    """(h, w) ink on straight lines of some length that do not run along the hatching."""
    kept = np.zeros_like(ink)
    for way in angles[0] + np.arange(TURNS) * np.pi / TURNS:
        if _between(np.array(angles), way).min() > ALONG:
            kept |= np.asarray(cv2.morphologyEx(ink, cv2.MORPH_OPEN, _line(way, length)), dtype=np.uint8)
    return kept > 0


def _line(angle: float, length: float) -> Gray:
    half = int(length / 2)
    kernel = np.zeros((2 * half + 1, 2 * half + 1), np.uint8)
    tip = (round(half * float(np.cos(angle))), round(half * float(np.sin(angle))))
    cv2.line(kernel, (half - tip[0], half - tip[1]), (half + tip[0], half + tip[1]), 1)
    return kernel
