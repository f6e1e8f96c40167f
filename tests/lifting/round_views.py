"""Drawn objects with arcs, made from solids in space: ellipses follow from the view, noise is that of a hand."""

from __future__ import annotations

import cv2
import numpy as np

from sketch2shape.model import DrawnArc, Ellipse, FacePair, TwoFaceObject


def axonometric(azimuth=35.0, elevation=30.0):
    """(2, 3) the picture of right, down and away."""
    a, e = np.radians([azimuth, elevation])
    right = np.array([np.cos(a), 0, np.sin(a)])
    away = np.array([-np.sin(a) * np.cos(e), -np.sin(e), np.cos(a) * np.cos(e)])
    return np.array([right, np.cross(away, right)])


def oblique(ratio=0.5, angle=-45.0):
    return np.array([[1, 0, ratio * np.cos(np.radians(angle))], [0, 1, ratio * np.sin(np.radians(angle))]])


class Drawer:
    """Draws prisms, frusta and pointed objects over rings of lines and arcs; `flat` (n, 2) to space by the frame."""

    def __init__(self, view, frame=None, scale=100.0, noise=0.0, seed=0):
        self.view, self.frame, self.noise = scale * view, np.eye(3) if frame is None else frame, noise
        self.rng = np.random.default_rng(seed)

    def at(self, flat, z):
        space = np.c_[flat, np.full(len(flat), z)] @ self.frame
        return space @ self.view.T + [320, 240]

    def shaken(self, points):
        return points + self.noise * self.rng.normal(size=np.shape(points))

    def ellipse(self, center, radius, z):
        square = np.array([center, np.add(center, [radius, 0]), np.add(center, [0, radius])])
        middle, across, down = self.at(square, z)
        turns, axes, _ = np.linalg.svd(np.c_[across - middle, down - middle])
        angle = float(np.degrees(np.arctan2(turns[1, 0], turns[0, 0])) % 180)
        a, b = axes + self.noise * 0.7 * self.rng.normal(size=2)
        return Ellipse(self.shaken(middle), (max(a, b), min(a, b)), angle)

    def round(self, ellipse, _center, _radius, _z):
        """(32, 2) points of an ellipse."""
        turn, lean = np.linspace(0, 2 * np.pi, 32, endpoint=False), np.radians(ellipse.angle)
        (a, b), axes = ellipse.axes, np.array([[np.cos(lean), np.sin(lean)], [-np.sin(lean), np.cos(lean)]])
        return ellipse.center + np.c_[a * np.cos(turn), b * np.sin(turn)] @ axes

    def ring(self, face, hole, points, arcs, z, scale):
        """Arcs: start -> (centre, turn in radians), or None -> (centre, radius)."""
        points = np.array(points, float).reshape(-1, 2)
        drawn = self.shaken(self.at(points * scale, z))
        found = []
        for start, (center, value) in arcs.items():
            if start is None:
                ellipse = self.ellipse(np.multiply(center, scale), value * scale, z)
                path = self.round(ellipse, np.multiply(center, scale), value * scale, z)
                found.append(DrawnArc(face, hole, None, None, ellipse, path))
                continue
            end = (start + 1) % len(points)
            away, turn = points[start] - center, np.linspace(0, value, 17)[:, None]
            path = center + np.cos(turn) * away + np.sin(turn) * np.array([-away[1], away[0]])
            path = self.at(path * scale, z)
            part = np.linspace(0, 1, 17)[:, None]
            path += (1 - part) * (drawn[start] - path[0]) + part * (drawn[end] - path[-1])
            path[1:-1] += self.noise * np.sin(np.pi * part[1:-1]) * self.rng.normal(size=2)
            ellipse = self.ellipse(np.multiply(center, scale), float(np.hypot(*away)) * scale, z)
            found.append(DrawnArc(face, hole, start, end, ellipse, path))
        return drawn, found

    def draw(self, rings, depth=1.0, scale=1.0, lines="dashed"):
        """rings: (points, arcs) of the outer ring and of the holes; scale 0 makes a point."""
        pairs, arcs = [], []
        for hole, (points, bent) in enumerate(rings, -1):
            number = None if hole < 0 else hole
            f1, near = self.ring("f1", number, points, bent, 0.0, 1.0)
            if scale:
                f2, far = self.ring("f2", number, points, bent, depth, scale)
            else:
                f2, far = self.shaken(self.at(np.zeros((1, 2)), depth)), []
            pairs.append(FacePair(f1, f2))
            arcs += near + far
        outer, *holes = pairs
        noise = max(self.noise, 0.3)
        return TwoFaceObject(outer.f1, outer.f2, tuple(holes), lines=lines, noise=noise, arcs=tuple(arcs))


class Photographer(Drawer):
    """The same in perspective, from so far away, without noise; the points of a circle are the same on both faces."""

    def __init__(self, view, frame=None, away=5.0):
        super().__init__(view, frame)
        self.away = away

    def at(self, flat, z):
        space = np.c_[flat, np.full(len(flat), z)] @ self.frame
        right, down = self.view / 100.0
        depth = 1.0 + space @ np.cross(right, down) / self.away
        return space @ self.view.T / depth[:, None] + [320, 240]

    def round(self, _ellipse, center, radius, z):
        turn = np.linspace(0, 2 * np.pi, 32, endpoint=False)
        return self.at(center + radius * np.c_[np.cos(turn), np.sin(turn)], z)

    def ellipse(self, center, radius, z):
        (x, y), (a, b), angle = cv2.fitEllipseDirect(self.round(None, center, radius, z).astype(np.float32))
        return Ellipse(np.array([x, y]), (0.5 * max(a, b), 0.5 * min(a, b)), (angle + 90.0 * (a < b)) % 180.0)


#: face coordinates of a standing object: the face is level, seen from above, its normal down
STANDING = np.array([[1.0, 0, 0], [0, 0, 1.0], [0, 1.0, 0]])

CIRCLE = ([], {None: ((0, 0), 0.8)})
HOLE = ([], {None: ((0, 0), 0.4)})
HALF = ([[1, 0], [-1, 0]], {0: ((0, 0), np.pi)})
SLOT = ([[-1, -0.5], [1, -0.5], [1, 0.5], [-1, 0.5]], {1: ((1, 0), np.pi), 3: ((-1, 0), np.pi)})
SQUARE = ([[-1, -1], [1, -1], [1, 1], [-1, 1]], {})
ROUNDED = (
    [[-0.6, -0.7], [0.6, -0.7], [1, -0.3], [1, 0.3], [0.6, 0.7], [-0.6, 0.7], [-1, 0.3], [-1, -0.3]],
    {1: ((0.6, -0.3), np.pi / 2), 3: ((0.6, 0.3), np.pi / 2), 5: ((-0.6, 0.3), np.pi / 2),
     7: ((-0.6, -0.3), np.pi / 2)},
)  # fmt: skip
GROOVE = ([[-1, 0], [-0.4, 0], [0.4, 0], [1, 0], [1, 1], [-1, 1]], {1: ((0, 0), -np.pi)})
