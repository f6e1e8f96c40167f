"""Making exact what the drawing makes nearly so: parallels, right angles, equal lengths, regular polygons.

A face is replaced by the nearest one that is exactly regular, "near" measured in the drawing; if a vertex would have to
move further than the drawing's own noise, less is asked for, and in the end nothing.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from sketch2shape.lifting.classes import parallel_classes
from sketch2shape.lifting.face import edge_vectors, ring_area, ring_ends
from sketch2shape.lifting.mirror import find_mirror, mirror_rows
from sketch2shape.lifting.shape import Shape
from sketch2shape.model import Bools, Floats, Ints

#: a vertex may move this many standard deviations of the drawing's noise
_REACH = 3.5

#: an angle or a length counts as nearly exact within this many of its standard deviations
_NEAR = 3.5

#: part of an edge, and of the area, that must be left
_KEPT = 0.5

#: prior odds that two lengths of an object are equal, and the range of the logarithm of their ratio if they are not
_ALIKE, _RANGE = 0.05, 3.0


#: damping of the constraints, part of their mean square
_DAMPING = 1e-10

#: angles to the main direction that are rounded, the likeliest first, and the prior odds that one was meant
_STEPS = np.deg2rad([[90.0], [45.0], [30.0], [60.0]])
_BELIEFS = np.array([[0.45], [0.05], [0.05], [0.05]])


@dataclass(frozen=True)
class _Edges:
    """The edges of a face, sorted into classes of direction.

    label  : (m,) class of each edge
    sign   : (m,) +1 if the edge runs along its class
    angle  : (k,) direction of each class, radians
    spread : (k,) its standard deviation
    number : (k,) edges in each class
    """

    label: Ints
    sign: Floats
    angle: Floats
    spread: Floats
    number: Ints


def beautified(shape: Shape) -> Shape:
    """The shape with its face made regular."""
    to_drawing, noise = shape.to_drawing, shape.noise
    reach = _REACH * noise
    for name, face in _candidates(shape, noise):
        moved = float(np.hypot(*((face - shape.flat) @ to_drawing).T).max())
        if moved <= reach and _alike(face, shape):
            evidence = {**shape.evidence, "beautified": {"by": name, "moved_px": round(moved, 3)}}
            shape = replace(shape, flat=face, evidence=evidence)
            break
    return _even_depth(shape, noise)


def _alike(face: Floats, shape: Shape) -> bool:
    """Has no edge of the new face shrunk to little or turned about, and no area gone?"""
    old, new = edge_vectors(shape.flat, shape.sizes), edge_vectors(face, shape.sizes)
    kept = (old * new).sum(axis=1) >= _KEPT * (old**2).sum(axis=1)
    n = shape.sizes[0]
    return bool(kept.all()) and ring_area(face[:n]) >= _KEPT * ring_area(shape.flat[:n])


def _candidates(shape: Shape, noise: float) -> Iterator[tuple[str, Floats]]:
    """Regular faces near the shape's, the most regular one first."""
    sizes = shape.sizes
    if len(sizes) == 1 and sizes[0] >= 3:
        yield "regular polygon", _regular_polygon(shape.flat)
    mates = find_mirror(shape, noise)
    if mates is not None:
        # every vertex and its image tell of each other
        even = replace(shape, flat=_nearest(shape, mirror_rows(shape.flat, mates)))
        for name, face in _straight(even, math.sqrt(0.5) * noise, mates):
            yield f"{name} and symmetry", face
    yield from _straight(shape, noise, None)


def _straight(shape: Shape, noise: float, mates: Ints | None) -> Iterator[tuple[str, Floats]]:
    """Faces with exact directions and lengths, the most exact one first; mates: those of a mirror symmetry to keep."""
    edges = _sorted_edges(shape, noise)
    targets = _rounded(edges)
    level = _level(targets, edges) if np.array_equal(shape.pose, np.eye(3)) else targets
    for directions in [targets] if level is targets else [level, targets]:
        rows = _direction_rows(shape, edges, directions)
        if mates is not None:
            rows = np.concatenate([rows, mirror_rows(shape.flat, mates, directions[edges.label])])
        lengths = _length_rows(shape, edges, directions, noise)
        yield "directions and lengths", _nearest(shape, np.concatenate([rows, lengths]))
        yield "directions", _nearest(shape, rows)


def _regular_polygon(flat: Floats) -> Floats:
    """The nearest regular polygon with these vertices, by least squares over centre, size and turn."""
    n = len(flat)
    z = np.ascontiguousarray(flat).view(complex)[:, 0]
    units = _unit_polygons(n)
    # the better fit is the one with the larger polygon: what it does not explain is what is left over
    sizes = units.conj() @ z / n
    best = int(np.abs(sizes).argmax())
    fit = z.sum() / n + units[best] * sizes[best]
    polygon: Floats = fit.view(float).reshape(n, 2)
    return polygon


@lru_cache(maxsize=256)
def _unit_polygons(n: int) -> NDArray[np.complex128]:
    """(2, n) vertices of the regular polygon on the unit circle, in either sense."""
    turns = 2j * np.pi * np.arange(n) / n
    return np.exp([turns, -turns])


def _sorted_edges(shape: Shape, noise: float) -> _Edges:
    vectors = edge_vectors(shape.flat, shape.sizes)
    drawn = np.hypot(*(vectors @ shape.to_drawing).T)
    label, sign = parallel_classes(vectors, drawn, noise)
    x, y = (np.bincount(label, sign * way) for way in vectors.T)
    angle, number = np.arctan2(y, x), np.bincount(label)
    wide = noise * np.sqrt(2.0 * number) * np.hypot(*(shape.map @ [-np.sin(angle), np.cos(angle)]))
    return _Edges(label, sign, angle, wide / np.maximum(np.hypot(x, y), 1e-12), number)


def _rounded(edges: _Edges) -> Floats:
    """(k,) directions with right angles, then other simple angles to the main direction, made exact."""
    main = int((edges.number / np.maximum(edges.spread, 1e-9)).argmax())
    step = _STEPS[0, 0]
    off = (edges.angle - edges.angle[main] + step / 2) % step - step / 2
    square = np.abs(off) <= _NEAR * np.hypot(edges.spread, edges.spread[main])
    weight = square / np.maximum(edges.spread, 1e-9) ** 2
    lean = edges.angle[main] + float((weight * off).sum() / weight.sum())
    apart = (edges.angle - lean + _STEPS / 2) % _STEPS - _STEPS / 2
    near = np.abs(apart) <= _slack(edges.spread, _BELIEFS, _STEPS)
    # the first of the angles that is near
    first = near.argmax(axis=0), np.arange(len(edges.angle))
    return np.where(near[first], edges.angle - apart[first], edges.angle)


def _level(targets: Floats, edges: _Edges) -> Floats:
    """Directions turned together so that the main one is exactly level or upright, if it nearly is."""
    main = int((edges.number / np.maximum(edges.spread, 1e-9)).argmax())
    off = (targets[main] + np.pi / 4) % (np.pi / 2) - np.pi / 4
    return targets - off if abs(off) <= _NEAR * edges.spread[main] + np.deg2rad(0.1) else targets


def _direction_rows(shape: Shape, edges: _Edges, directions: Floats) -> Floats:
    """(c, m, 2) a linear constraint for each edge that shall have its class's direction."""
    kept = np.flatnonzero(_fixed(edges, directions))
    angle = directions[edges.label[kept]]
    return _components(shape, kept, np.stack([-np.sin(angle), np.cos(angle)], axis=1))


def _length_rows(shape: Shape, edges: _Edges, directions: Floats, noise: float) -> Floats:
    """(c, m, 2) a linear constraint for each two edges of known direction whose lengths shall be equal."""
    kept = np.flatnonzero(_fixed(edges, directions))
    angle = directions[edges.label[kept]]
    unit = edges.sign[kept, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    long = (edge_vectors(shape.flat, shape.sizes)[kept] * unit).sum(axis=1)
    spread = noise * np.sqrt(2.0) * np.hypot(*(unit @ shape.map.T).T)
    order = np.argsort(long, kind="stable")
    long, spread = long[order], spread[order]
    vague = np.hypot(spread[1:], spread[:-1]) / np.maximum(long[1:], 1e-9)
    slack = (long[1:] * _slack(vague, _ALIKE, _RANGE)).tolist()
    alike: list[tuple[int, int]] = []
    sizes, start = long.tolist(), 0
    for k, (before, here) in enumerate(pairwise(order.tolist())):
        start = start if alike and alike[-1][1] == before else k
        if sizes[k + 1] - sizes[start] <= slack[k]:
            alike.append((before, here))
    one, other = np.array(alike, np.intp).reshape(-1, 2).T
    return _components(shape, kept[other], unit[other]) - _components(shape, kept[one], unit[one])


def _slack(spread: Floats | float, belief: Floats | float, span: Floats | float) -> Floats:
    """How far two angles, or the logarithms of two lengths, may differ to be likelier meant to be equal than not.

    spread : standard deviation of their difference
    belief : prior odds that they are equal
    span   : range of the difference if they are not

    The vaguer they are, the less it says that they are near each other.
    """
    odds = belief / (1.0 - belief) * span / (np.sqrt(2.0 * np.pi) * np.maximum(spread, 1e-9))
    slack: Floats = spread * np.minimum(np.sqrt(2.0 * np.log(np.maximum(odds, 1.0))), _NEAR)
    return slack


def _fixed(edges: _Edges, directions: Floats) -> Bools:
    """(m,) edges whose direction is shared or was rounded."""
    known: Bools = ((edges.number > 1) | (directions != edges.angle))[edges.label]
    return known


def _components(shape: Shape, chosen: Ints, units: Floats) -> Floats:
    """(c, m, 2) coefficients that take the components of chosen edges along unit vectors (c, 2) from a face."""
    first, last = ring_ends(shape.sizes)
    rows = np.zeros((len(chosen), len(first), 2))
    at = np.arange(len(chosen))
    rows[at, last[chosen]] = units
    rows[at, first[chosen]] = -units
    return rows


def _nearest(shape: Shape, rows: Floats) -> Floats:
    """The face that obeys the constraints (rows . face = 0) and moves least in the drawing.

    Many constraints repeat others, so a trace of damping is added, whose effect one correction removes.
    """
    if not len(rows):
        return shape.flat
    flat, moved = rows.reshape(len(rows), -1), (rows @ shape.map.T).reshape(len(rows), -1)
    square = moved @ moved.T
    square[np.diag_indices_from(square)] += _DAMPING * square.trace() / len(rows)
    face = shape.flat
    for _ in range(2):
        step = moved.T @ np.linalg.solve(square, -flat @ face.ravel())
        face = face + step.reshape(face.shape) @ shape.map
    return face


def _even_depth(shape: Shape, noise: float) -> Shape:
    """The depth made equal to an edge's length, where it nearly is: a cube is a cube."""
    if shape.family != "axonometric" or shape.taper != 1.0:
        return shape
    lengths = np.hypot(*edge_vectors(shape.flat, shape.sizes).T)
    off = lengths / abs(shape.depth) - 1.0
    best = int(np.abs(off).argmin())
    drawn = abs(shape.depth) * float(np.hypot(*shape.pose[2][:2]))
    spread = noise / max(drawn, 1e-9)
    if abs(off[best]) > _slack(spread, _ALIKE, _RANGE):
        return shape
    return replace(shape, depth=float(np.sign(shape.depth) * lengths[best]))
