"""Shapes of drawing programs as lines: rectangles, ellipses, polygons, curves through points, turned and moved."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from sketch2shape.model import Floats, VectorLine

ROUND = 96
"""Chords of a whole turn."""
BETWEEN = 12
"""Chords from one point of a smooth curve to the next."""


def closed(corners: ArrayLike) -> VectorLine:
    """The polygon with these corners."""
    ring = np.asarray(corners, np.float64)
    return VectorLine(np.concatenate([ring, ring[:1]]))


def rectangle(width: float, height: float, radius: float = 0.0) -> list[VectorLine]:
    """From (0, 0) to (width, height), with round corners where the radius is not 0."""
    if radius <= 0:
        return [closed(np.array([[0, 0], [width, 0], [width, height], [0, height]]))]
    lines, r = [], radius
    quarter = np.linspace(0, np.pi / 2, ROUND // 4 + 1)
    corners = ((width - r, r, -np.pi / 2), (width - r, height - r, 0.0), (r, height - r, np.pi / 2), (r, r, np.pi))
    arcs = [np.c_[x + r * np.cos(quarter + a), y + r * np.sin(quarter + a)] for x, y, a in corners]
    for k, arc in enumerate(arcs):
        lines.append(VectorLine(np.array([arcs[k - 1][-1], arc[0]])))
        lines.append(VectorLine(arc, curved=True))
    return lines


def ellipse(width: float, height: float) -> VectorLine:
    """The one that fits into a rectangle from (0, 0) to (width, height)."""
    turn = np.linspace(0, 2 * np.pi, ROUND + 1)
    return VectorLine(np.c_[width / 2 * (1 + np.cos(turn)), height / 2 * (1 + np.sin(turn))], curved=True)


def smooth(points: Floats) -> VectorLine:
    """A curve through points (Catmull and Rom 1974)."""
    if len(points) < 3:
        return VectorLine(points)
    before, after = np.concatenate([points[:1], points[:-1]]), np.concatenate([points[1:], points[-1:]])
    slope = (after - before) / 2
    t = (np.arange(BETWEEN) / BETWEEN)[:, None]
    h = 2 * t**3 - 3 * t**2 + 1, t**3 - 2 * t**2 + t, -2 * t**3 + 3 * t**2, t**3 - t**2
    pieces = [
        h[0] * points[k] + h[1] * slope[k] + h[2] * points[k + 1] + h[3] * slope[k + 1] for k in range(len(points) - 1)
    ]
    return VectorLine(np.concatenate([*pieces, points[-1:]]), curved=True)


def turned(line: VectorLine, angle: float, about: ArrayLike, dashed: bool | None = None) -> VectorLine:
    """Turned by an angle, radians from x towards y, about a point."""
    centre = np.asarray(about, np.float64)
    c, s = np.cos(angle), np.sin(angle)
    points = (line.points - centre) @ np.array([[c, s], [-s, c]]) + centre
    return VectorLine(points, line.dashed if dashed is None else dashed, line.curved)


def moved(line: VectorLine, by: ArrayLike) -> VectorLine:
    """Moved by a vector."""
    return VectorLine(line.points + np.asarray(by, np.float64), line.dashed, line.curved)
