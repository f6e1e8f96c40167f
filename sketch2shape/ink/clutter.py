"""Clutter: specks, letters and digits that do not belong to the drawing, told from dashes and dots, which do.

Small components are measured by their second moments. A dash has another dash, or the drawing itself, straight
ahead; a dot lies in a row of dots; where dashes meet at a hidden corner, two of them point at the small component.
Whatever else is much smaller than the drawing and touches nothing is clutter.
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from sketch2shape.ink.components import Pieces, connected_pieces
from sketch2shape.ink.histogram import percentile
from sketch2shape.ink.pen_width import rough_pen_width
from sketch2shape.model import Bools, Floats, Gray, Ints

SMALL = 0.14
"""Components up to this share of the largest one's diagonal are looked at."""
LETTER = 0.11
"""Letters and lone dashes above this share are kept: they may be a small hole or a short edge."""
FAINT = 0.4
"""Short components with less than this share of the usual contrast are noise."""
HOLLOW = 0.62
"""A ring has ink on less than this share of the area within its outline."""
NEIGHBOURS = 8
"""A dot's row is looked for among this many of the closest dots."""
MOST = 700
"""Small components that are compared with each other, the largest first; further ones are specks."""


@dataclass(frozen=True)
class Parts:
    """Small components of the ink, working pixels.

    labels : (n,) label of each in the label image
    centre : (n, 2) x, y
    axis   : (n, 2) unit vector along it
    length, width : (n,) extent along and across the axis
    area   : (n,) pixels
    peak   : (n,) strongest contrast
    """

    labels: Ints
    centre: Floats
    axis: Floats
    length: Floats
    width: Floats
    area: Floats
    peak: Floats

    def are_dashes(self, pen_width: float) -> Bools:
        """(n,) clearly longer than wide, and about as wide as the pen."""
        return np.asarray((self.length > 1.5 * self.width) & (self.width < 2.0 * pen_width + 1.5))

    @property
    def is_disc(self) -> Bools:
        """(n,) round and full."""
        return np.asarray((self.length < 1.3 * self.width) & (self.area > 0.7 * self.length * self.width))

    def only(self, chosen: Bools) -> Parts:
        """Some of the components."""
        return Parts(**{name: values[chosen] for name, values in vars(self).items()})


def without_clutter(mask: Bools, contrast: Gray, *, noisy: bool = False) -> Bools:
    """The ink without small components that are neither dash nor dot of a line.

    mask     : (h, w) ink
    contrast : (h, w) uint8, how dark the ink is
    noisy    : short pale components are noise
    returns  : (h, w), the same array where there is nothing to take away
    """
    ink = np.asarray(mask, np.bool_).view(np.uint8)
    pieces = connected_pieces(ink)
    extent = pieces.extent
    largest = float(extent.max())
    small = extent < SMALL * largest
    small[0] = False
    if not small.any():
        return mask
    chosen = np.flatnonzero(small)
    chosen = chosen[np.argsort(-np.bincount(pieces.piece)[chosen], kind="stable")[:MOST]]
    large = pieces.only(~small)
    pen_width = rough_pen_width(large)
    parts = _measure(pieces, chosen, contrast)
    if noisy:
        usual = percentile(contrast[large], 75)
        parts = parts.only((parts.peak > FAINT * usual) | (parts.length > 2.5 * pen_width))
    keep = ~small
    keep[parts.labels] = _belongs(parts, pieces, large, pen_width, LETTER * largest, noisy)
    return pieces.only(keep)


def _pixels(pieces: Pieces, chosen: Ints) -> tuple[Ints, Ints, Ints]:
    """Row and column of the pixels of the chosen components, and which of these each belongs to, from 0; (m,) each."""
    index = np.full(len(pieces.low), -1)
    index[chosen] = np.arange(len(chosen))
    which = index[pieces.piece]
    ys, xs = np.divmod(pieces.where[which >= 0], pieces.mask.shape[1])
    return ys, xs, which[which >= 0]


def _measure(pieces: Pieces, chosen: Ints, contrast: Gray) -> Parts:
    """Moments of the chosen components; a stroke of length l and width w has variances l^2 / 12 and w^2 / 12."""
    ys, xs, which = _pixels(pieces, chosen)
    area = np.bincount(which, minlength=len(chosen)).astype(np.float64)

    def mean(values: Floats) -> Floats:
        return np.bincount(which, weights=values, minlength=len(chosen)) / area

    centre = np.stack([mean(xs.astype(np.float64)), mean(ys.astype(np.float64))], axis=1)
    dx, dy = xs - centre[which, 0], ys - centre[which, 1]
    xx, yy, xy = mean(dx * dx) + 1 / 12, mean(dy * dy) + 1 / 12, mean(dx * dy)
    peak = np.zeros(len(chosen))
    np.maximum.at(peak, which, contrast[ys, xs])
    half, root = (xx + yy) / 2, np.hypot((xx - yy) / 2, xy)
    angle = 0.5 * np.arctan2(2 * xy, xx - yy)
    return Parts(
        labels=chosen,
        centre=centre,
        axis=np.stack([np.cos(angle), np.sin(angle)], axis=1),
        length=np.sqrt(12 * (half + root)),
        width=np.sqrt(12 * np.maximum(half - root, 1 / 12)),
        area=area,
        peak=peak,
    )


def _belongs(parts: Parts, pieces: Pieces, large: Bools, pen_width: float, letter: float, noisy: bool) -> Bools:
    """(n,) whether each small component is part of a line or too large to be a letter."""
    dash = parts.are_dashes(pen_width)
    near_large = _grown(large, 3)
    sides = _ahead(parts, dash, pen_width)
    met = _reaches(parts, near_large, pen_width)
    ahead = sides[0] | sides[1]
    paired = (ahead & ahead.T).any(axis=1)
    between = (sides.any(axis=2) | met).all(axis=0)
    long = parts.length > 4.0 * np.maximum(parts.width, pen_width)
    linked = dash & (paired | between | (long & (met[0] | met[1])))
    pointed_at = (ahead & linked[:, None]).sum(axis=0)
    full = parts.area > 0.7 * parts.length * parts.width  # an o or n is not
    dot = full & (parts.length < 3.0 * pen_width + 2.0) & (parts.area > 0.15 * pen_width**2)
    in_row = _in_row(parts, dot, near_large, pen_width)
    if np.count_nonzero(in_row & dot) > 0.5 * np.count_nonzero(dot):
        in_row |= dot & (not noisy)  # dotted lines on clean paper: the other dots are theirs too
    pointed = (pointed_at >= 2) | ((dot | parts.is_disc) & (pointed_at >= 1))
    joined = (linked | pointed) & ~_in_words(parts, dash | dot | pointed)
    if noisy:
        joined |= _nearly_joined(parts, pieces, large, pen_width)
    rings = _rings(parts, pieces, large, 0.5 * letter)
    return np.asarray(
        joined | in_row | rings | _vertex_dots(parts, pen_width) | (parts.length > letter), dtype=np.bool_
    )


def _grown(mask: Bools, side: int) -> Bools:
    return np.asarray(cv2.dilate(mask.view(np.uint8), np.ones((side, side), np.uint8)), np.uint8).view(np.bool_)


def _nearly_joined(parts: Parts, pieces: Pieces, large: Bools, pen_width: float) -> Bools:
    """(n,) longer than a few widths, and all but touching the drawing at places far apart: a stroke with weak spots."""
    ys, xs, which = _pixels(pieces, parts.labels)
    close = _grown(large, 2 * int(pen_width + 2.0) + 1)[ys, xs]
    points = np.stack([xs, ys], axis=1)[close]
    low, high = np.full((len(parts.labels), 2), np.inf), np.full((len(parts.labels), 2), -np.inf)
    np.minimum.at(low, which[close], points)
    np.maximum.at(high, which[close], points)
    span = np.linalg.norm(np.maximum(high - low, 0.0), axis=1)
    return np.asarray((span > 0.5 * parts.length) & (parts.length > 4.0 * pen_width), dtype=np.bool_)


def _in_words(parts: Parts, plain: Bools) -> Bools:
    """(n,) at least two letters of like size stand close by; `plain` ones are no letters, but may be in a word."""
    offset = parts.centre[None, :, :] - parts.centre[:, None, :]
    near = np.hypot(offset[..., 0], offset[..., 1]) < 2.2 * parts.length[:, None]
    alike = np.abs(np.log(parts.length[None, :] / parts.length[:, None])) < 0.6
    letters = near & alike & ~plain[None, :] & ~parts.is_disc[None, :]
    np.fill_diagonal(letters, False)
    return np.asarray(letters.sum(axis=1) >= 2, dtype=np.bool_)


def _rings(parts: Parts, pieces: Pieces, large: Bools, least: float) -> Bools:
    """(n,) a closed outline within the drawing that is mostly hollow: a small hole, though an O or D passes for one."""
    result = np.zeros(len(parts.area), dtype=np.bool_)
    candidates = np.flatnonzero((parts.length > least) & (parts.area < 0.5 * parts.length * parts.width))
    if len(candidates) == 0:
        return result
    hull = cv2.convexHull(cv2.findNonZero(large.view(np.uint8)))
    ys, xs, which = _pixels(pieces, parts.labels)
    for i in candidates:
        x, y = parts.centre[i]
        if cv2.pointPolygonTest(hull, (float(x), float(y)), False) <= 0:
            continue
        (left, top), (right, bottom) = pieces.low[parts.labels[i]], pieces.high[parts.labels[i]]
        part = np.zeros((bottom - top + 1, right - left + 1), np.uint8)
        part[ys[which == i] - top, xs[which == i] - left] = 1
        contours, _ = cv2.findContours(part, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
        filled = np.count_nonzero(cv2.drawContours(np.zeros_like(part), contours, -1, 1, cv2.FILLED))
        result[i] = parts.area[i] < HOLLOW * filled
    return result


def _vertex_dots(parts: Parts, pen_width: float) -> Bools:
    """(n,) one of at least four equal discs, clearly wider than the pen."""
    disc = parts.is_disc & (parts.width > 2.5 * pen_width)
    equal = np.abs(np.log(parts.area[None, :] / parts.area[:, None])) < 0.4
    return np.asarray(disc & ((equal & disc[None, :]).sum(axis=1) >= 4), dtype=np.bool_)


def _ahead(parts: Parts, dash: Bools, pen_width: float) -> Bools:
    """(2, n, n) True where j lies ahead of a dash i on either side of it, at most a few of its lengths away."""
    length, (x, y), (u, v) = parts.length, parts.centre.T, parts.axis.T
    dx, dy = x - x[:, None], y - y[:, None]
    forward = dx * u[:, None] + dy * v[:, None]
    along = np.stack([-forward, forward])
    across = np.abs(dy * u[:, None] - dx * v[:, None])
    gap = along - 0.5 * (length[:, None] + length)
    reach = np.maximum(2.5 * length, 5.0 * pen_width)[:, None]
    sway = 0.12 * along + (0.7 * pen_width + 0.5 + np.where(dash, 0.0, 0.5 * length))
    similar = dash <= (parts.width < 2.5 * parts.width[:, None] + pen_width)
    size = np.log(length)
    alike = dash & (np.abs(size - size[:, None]) < 1.0)
    wobbly = alike & (gap < 1.3 * length[:, None]) & (across < 0.3 * along)
    near = dash[:, None] & (along > 0) & (gap > -0.6 * length) & (gap < reach) & ((across < sway) | wobbly)
    return np.asarray(near & similar, dtype=np.bool_)


def _reaches(parts: Parts, near_large: Bools, pen_width: float) -> Bools:
    """(2, n) a large component lies straight ahead on either side, at most about a length away."""
    reach = np.maximum(1.6 * parts.length, 4.0 * pen_width)[:, None]
    distance = 0.5 * parts.length[:, None] + 1.0 + np.linspace(0.0, 1.0, 16) * reach
    way = distance[..., None] * parts.axis[:, None]
    return np.asarray(_hit(near_large, parts.centre[:, None] + np.stack([-way, way])).any(axis=2), dtype=np.bool_)


def _hit(mask: Bools, points: Floats) -> Bools:
    """(...) whether the mask is set at points (..., 2); outside of the picture it is not."""
    h, w = mask.shape
    xs, ys = np.rint(points[..., 0]), np.rint(points[..., 1])
    inside = (xs >= 0) & (xs < w) & (ys >= 0) & (ys < h)
    return np.asarray(inside & mask.ravel().take(np.where(inside, ys * w + xs, 0.0).astype(np.intp)), dtype=np.bool_)


def _in_row(parts: Parts, dot: Bools, near_large: Bools, pen_width: float) -> Bools:
    """(n,) the dot lies in a row: two alike dots, and beyond either one the next dot or the drawing itself."""
    result = np.zeros(len(dot), dtype=np.bool_)
    if np.count_nonzero(dot) > 1:
        result[dot] = _dots_in_row(parts.only(dot), near_large, pen_width)
    return result


def _dots_in_row(parts: Parts, near_large: Bools, pen_width: float) -> Bools:
    """(n,) the same of dots alone."""
    n, (x, y) = len(parts.area), parts.centre.T
    dx, dy = x - x[:, None], y - y[:, None]
    distance = np.hypot(dx, dy)
    alike = parts.area < 3.0 * parts.area[:, None]
    near = alike & alike.T & (distance > 0) & (distance < 3.5 * parts.length[:, None] + 1.5 * pen_width + 2.0)
    result = np.zeros(n, dtype=np.bool_)
    if not near.any():
        return result
    closest = np.argsort(np.where(near, distance, np.inf), axis=1)[:, :NEIGHBOURS]
    rows = np.arange(n)[:, None]
    valid = near[rows, closest]
    step = np.stack([dx[rows, closest], dy[rows, closest]], axis=2)  # from a dot to each of its neighbours
    error = np.hypot(*(step[:, :, None, :] + step[:, None, :, :]).transpose(3, 0, 1, 2))
    opposite = valid[:, :, None] & valid[:, None, :] & (error < 0.35 * distance[rows, closest][:, :, None])
    on = parts.centre[:, None, None, :] - np.array([0.5, 0.75, 1.0, 1.25])[None, None, :, None] * step[:, :, None, :]
    goes_on = valid & (opposite.any(axis=2) | _hit(near_large, on).any(axis=2))
    chain = np.zeros((n, n), dtype=np.bool_)
    chain[np.broadcast_to(rows, closest.shape)[goes_on], closest[goes_on]] = True
    chain &= chain.T
    result |= chain.any(axis=1)
    ends = (opposite & chain[rows, closest][:, :, None]).any(axis=1)  # beyond a dot of a chain
    result[closest[ends]] = True
    return result
