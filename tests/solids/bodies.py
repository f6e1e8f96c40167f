"""Solids made by hand, of kinds that no drawing is read as yet."""

from __future__ import annotations

import numpy as np

from sketch2shape.model import Projection, Solid, polyhedron

PROJECTION = Projection("oblique")


def pyramid() -> Solid:
    """A square pyramid: base 2 x 2, height 3; volume 4."""
    points = np.array([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0], [1, 1, 3.0]])
    faces = [[(0, 3, 2, 1)], [(0, 1, 4)], [(1, 2, 4)], [(2, 3, 4)], [(3, 0, 4)]]
    return Solid(polyhedron(points, faces), PROJECTION)


def hip_roof() -> Solid:
    """A roof of five sides: base 6 x 4, ridge 2 long and 3 high; volume 28."""
    points = np.array([[0, 0, 0], [6, 0, 0], [6, 4, 0], [0, 4, 0], [2, 2, 3], [4, 2, 3.0]])
    faces = [[(0, 3, 2, 1)], [(0, 1, 5, 4)], [(2, 3, 4, 5)], [(1, 2, 5)], [(3, 0, 4)]]
    return Solid(polyhedron(points, faces), PROJECTION)


def block_with_boss() -> Solid:
    """A block 4 x 4 x 1 with a block 2 x 2 x 1 on its top: eleven faces, three of them across z; volume 20."""
    square = np.array([[0, 0], [4, 0], [4, 4], [0, 4.0]])
    small = square / 2 + 1
    levels = [(square, 0), (square, 1), (small, 1), (small, 2)]
    points = np.concatenate([np.c_[ring, np.full(4, float(z))] for ring, z in levels])
    sides = [[(i, (i + 1) % 4, 4 + (i + 1) % 4, 4 + i)] for i in range(4)]
    upper = [[tuple(8 + k for k in ring) for ring in face] for face in sides]
    faces = [[(3, 2, 1, 0)], [(4, 5, 6, 7), (11, 10, 9, 8)], [(12, 13, 14, 15)], *sides, *upper]
    return Solid(polyhedron(points, faces), PROJECTION)


#: name -> the solid, its volume, its faces
BODIES = {"pyramid": (pyramid(), 4.0, 5), "hip roof": (hip_roof(), 28.0, 5), "boss": (block_with_boss(), 20.0, 11)}
