"""Making exact what the drawing makes nearly so: parallels, right angles, equal lengths, regular polygons.

A face is replaced by the nearest one that is exactly regular, "near" measured in the drawing; if a vertex would have to
move further than the drawing's own noise, less is asked for, and in the end nothing.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from sketch2shape.lift.face import edge_vectors, ring_area, ring_ends
from sketch2shape.lift.regularity import parallel_classes
from sketch2shape.lift.shape import Shape
from sketch2shape.model import Floats, Ints

#: a vertex may move this many standard deviations of the drawing's noise
_REACH = 2.5

#: an angle or a length counts as nearly exact within this many of its standard deviations
_NEAR = 2.5

#: part of an edge, and of the area, that must be left
_KEPT = 0.5

#: angles that are rounded, degrees: these between any two directions, the others only to the main one
_STEP, _OTHERS = 90.0, (45.0, 30.0, 60.0)


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


def beautified(shape: Shape, noise: float) -> Shape:
    """The shape with its face made regular; noise is the standard deviation of a drawn vertex, pixels."""
    to_drawing = np.linalg.inv(shape.map)
    reach = _REACH * noise
    for name, face in _candidates(shape, noise):
        moved = float(np.linalg.norm((face - shape.flat) @ to_drawing, axis=1).max())
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


def _candidates(shape: Shape, noise: float) -> list[tuple[str, Floats]]:
    """Regular faces near the shape's, the most regular one first."""
    found = []
    sizes = shape.sizes
    if len(sizes) == 1 and sizes[0] >= 3:
        found.append(("regular polygon", _regular_polygon(shape.flat)))
    edges = _sorted_edges(shape, noise)
    targets = _rounded(edges)
    level = _level(targets, edges) if np.allclose(shape.pose[:2], np.eye(3)[:2]) else targets
    for name, directions in (("directions and lengths", level), ("directions and lengths", targets)):
        rows = _direction_rows(shape, edges, directions)
        found.append((name, _nearest(shape, rows + _length_rows(shape, edges, directions, noise))))
        found.append(("directions", _nearest(shape, rows)))
    return found


def _regular_polygon(flat: Floats) -> Floats:
    """The nearest regular polygon with these vertices, by least squares over centre, size and turn."""
    n = len(flat)
    z = flat[:, 0] + 1j * flat[:, 1]
    options = []
    for way in (1.0, -1.0):
        unit = np.exp(2j * np.pi * way * np.arange(n) / n)
        fit = z.mean() + unit * (z * unit.conj()).mean()
        options.append(np.c_[fit.real, fit.imag])
    best: Floats = min(options, key=lambda p: float(((p - flat) ** 2).sum()))
    return best


def _sorted_edges(shape: Shape, noise: float) -> _Edges:
    vectors = edge_vectors(shape.flat, shape.sizes)
    drawn = np.linalg.norm(vectors @ np.linalg.inv(shape.map), axis=1)
    label, sign = parallel_classes(vectors, drawn, noise)
    k = int(label.max()) + 1
    sums = np.zeros((k, 2))
    np.add.at(sums, label, sign[:, None] * vectors)
    angle = np.arctan2(sums[:, 1], sums[:, 0])
    number = np.bincount(label, minlength=k)
    across = np.c_[-np.sin(angle), np.cos(angle)]
    wide = noise * np.sqrt(2.0 * number) * np.linalg.norm(across @ shape.map.T, axis=1)
    spread = wide / np.maximum(np.linalg.norm(sums, axis=1), 1e-12)
    return _Edges(label, sign, angle, spread, number)


def _rounded(edges: _Edges) -> Floats:
    """(k,) directions with right angles, then other simple angles to the main direction, made exact."""
    main = int((edges.number / np.maximum(edges.spread, 1e-9)).argmax())
    step = np.deg2rad(_STEP)
    off = (edges.angle - edges.angle[main] + step / 2) % step - step / 2
    square = np.abs(off) <= _NEAR * np.hypot(edges.spread, edges.spread[main])
    weight = square / np.maximum(edges.spread, 1e-9) ** 2
    lean = edges.angle[main] + float((weight * off).sum() / weight.sum())
    target = edges.angle.copy()
    for step_deg in (_STEP, *_OTHERS):
        step = np.deg2rad(step_deg)
        off = (edges.angle - lean + step / 2) % step - step / 2
        near = (np.abs(off) <= _NEAR * edges.spread) & (target == edges.angle)
        target[near] = (edges.angle - off)[near]
    return target


def _level(targets: Floats, edges: _Edges) -> Floats:
    """Directions turned together so that the main one is exactly level or upright, if it nearly is."""
    main = int((edges.number / np.maximum(edges.spread, 1e-9)).argmax())
    off = (targets[main] + np.pi / 4) % (np.pi / 2) - np.pi / 4
    return targets - off if abs(off) <= _NEAR * edges.spread[main] + np.deg2rad(0.1) else targets


def _direction_rows(shape: Shape, edges: _Edges, directions: Floats) -> list[Floats]:
    """A linear constraint (2m,) for each edge that shall have its class's direction."""
    first, last = ring_ends(shape.sizes)
    kept = (edges.number > 1) | (directions != edges.angle)
    rows = []
    for e in np.flatnonzero(kept[edges.label]):
        a = directions[edges.label[e]]
        rows.append(_row(len(first), first[e], last[e], np.array([-np.sin(a), np.cos(a)])))
    return rows


def _length_rows(shape: Shape, edges: _Edges, directions: Floats, noise: float) -> list[Floats]:
    """A linear constraint for each two edges of known direction whose lengths shall be equal."""
    first, last = ring_ends(shape.sizes)
    kept = np.flatnonzero(((edges.number > 1) | (directions != edges.angle))[edges.label])
    angle = directions[edges.label]
    unit = edges.sign[:, None] * np.c_[np.cos(angle), np.sin(angle)]
    long = (edge_vectors(shape.flat, shape.sizes) * unit).sum(axis=1)
    spread = noise * np.sqrt(2.0) * np.linalg.norm(unit @ shape.map.T, axis=1)
    rows = []
    previous = None
    start = 0.0
    for e in kept[np.argsort(long[kept], kind="stable")]:
        if previous is not None and long[e] - start <= _NEAR * np.hypot(spread[e], spread[previous]):
            one = _row(len(first), first[e], last[e], unit[e])
            other = _row(len(first), first[previous], last[previous], unit[previous])
            rows.append(one - other)
        else:
            start = float(long[e])
        previous = e
    return rows


def _row(m: int, i: int, j: int, unit: Floats) -> Floats:
    """(2m,) the component of vertex j minus vertex i along a unit vector."""
    row = np.zeros((m, 2))
    row[j] += unit
    row[i] -= unit
    return row.ravel()


def _nearest(shape: Shape, rows: list[Floats]) -> Floats:
    """The face that obeys the constraints (row . face = 0) and moves least in the drawing."""
    if not rows:
        return shape.flat
    system = np.array(rows)
    m = len(shape.flat)
    in_drawing = np.einsum("cmi,ji->cmj", system.reshape(-1, m, 2), shape.map).reshape(-1, 2 * m)
    step = np.linalg.lstsq(in_drawing, -system @ shape.flat.ravel(), rcond=1e-9)[0]
    face: Floats = shape.flat + step.reshape(m, 2) @ shape.map
    return face


def _even_depth(shape: Shape, noise: float) -> Shape:
    """The depth made equal to an edge's length, where it nearly is: a cube is a cube."""
    if shape.family != "axonometric" or shape.taper != 1.0:
        return shape
    lengths = np.linalg.norm(edge_vectors(shape.flat, shape.sizes), axis=1)
    off = lengths / abs(shape.depth) - 1.0
    best = int(np.abs(off).argmin())
    drawn = abs(shape.depth) * float(np.hypot(*shape.pose[2][:2]))
    if abs(off[best]) * drawn > _NEAR * noise:
        return shape
    return replace(shape, depth=float(np.sign(shape.depth) * lengths[best]))
