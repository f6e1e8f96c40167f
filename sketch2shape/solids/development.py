"""The faces of a solid laid flat, each by itself: flat ones as they are, cylinders and cones unrolled."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sketch2shape.model import Arc, Boundary, Brief, Cone, DirectedEdge, Face, Floats, Loop, Plane

#: chords that stand for a whole circle
_CHORDS = 180

#: steps in which a chord's length along a curved side is added up
_FINE = 8


@dataclass(frozen=True, eq=False, repr=False)
class FlatEdge(Brief):
    """An edge of a face laid flat.

    points  : (k, 2) along it, as the face's loop walks; (2, 2) if it is straight
    edge    : number of the solid's edge; None for the seam along which a closed curved side was cut open
    rolled  : is it the rim of a curved side?
    """

    points: Floats
    edge: int | None
    rolled: bool = False

    @property
    def is_straight(self) -> bool:
        """Whether the edge runs straight on the paper and on the solid."""
        return len(self.points) == 2 and not self.rolled

    @property
    def length(self) -> float:
        """Its length."""
        return float(np.linalg.norm(np.diff(self.points, axis=0), axis=1).sum())


@dataclass(frozen=True)
class FlatFace:
    """A face laid flat, as seen from outside the solid, y up.

    number : of the solid's face
    loops  : the outer one first, turning anticlockwise, holes the other way
    """

    number: int
    loops: tuple[tuple[FlatEdge, ...], ...]

    def moved(self, turn: complex, by: complex) -> FlatFace:
        """The face turned by a unit complex number, then shifted."""
        loops = tuple(
            tuple(FlatEdge(_moved(e.points, turn, by), e.edge, e.rolled) for e in loop) for loop in self.loops
        )
        return FlatFace(self.number, loops)

    def ring(self, loop: int = 0) -> Floats:
        """(k, 2) the points once round a loop."""
        return np.concatenate([edge.points[:-1] for edge in self.loops[loop]])


def _moved(points: Floats, turn: complex, by: complex) -> Floats:
    z = (points[:, 0] + 1j * points[:, 1]) * turn + by
    return np.asarray(np.c_[z.real, z.imag])


def developed(boundary: Boundary) -> list[FlatFace]:
    """All faces laid flat, in their order."""
    return [FlatFace(number, _loops(boundary, face)) for number, face in enumerate(boundary.faces)]


def _loops(boundary: Boundary, face: Face) -> tuple[tuple[FlatEdge, ...], ...]:
    surface = face.surface
    if isinstance(surface, Plane):
        side = np.eye(3)[int(np.abs(surface.normal).argmin())]
        across = np.cross(surface.normal, side)
        across = across / (np.linalg.norm(across) or 1.0)
        plane = np.array([across, np.cross(surface.normal, across)])
        return tuple(tuple(_flat_edge(boundary, step, plane) for step in loop) for loop in face.loops)
    return (_unrolled(boundary, face),)


def _flat_edge(boundary: Boundary, step: DirectedEdge, plane: Floats) -> FlatEdge:
    arc = boundary.arc(boundary.edges[step.edge])
    points = _ends(boundary, step) if arc is None else _walked(arc, step.forward, 1)
    return FlatEdge(points @ plane.T, step.edge)


def _ends(boundary: Boundary, step: DirectedEdge) -> Floats:
    edge = boundary.edges[step.edge]
    ends = [i for i in (edge.start, edge.end) if i is not None]
    return np.asarray(boundary.vertices[ends if step.forward else ends[::-1]])


def _walked(arc: Arc, forward: bool, fine: int) -> Floats:
    """(k, 3) points along an arc, `fine` steps to a chord."""
    chords = max(int(np.ceil(_CHORDS * arc.sweep / (2 * np.pi))), 2)
    points = arc.at(np.arange(chords * fine + 1) / (chords * fine))
    return np.asarray(points if forward else points[::-1])


def _unrolled(boundary: Boundary, face: Face) -> tuple[FlatEdge, ...]:
    """The border of a curved side laid flat: its rim, then on around."""
    walk = _from_a_rim(boundary, face)
    rim = walk[0]
    near = _rim(boundary, rim)
    others = [step for step in walk[1:] if step is not None and boundary.arc(boundary.edges[step.edge]) is not None]
    far = _rim(boundary, others[0])[::-1] if others else None
    first, second = _laid(face, near, far)
    first, second = first[::_FINE], second[::_FINE]
    numbers = [None if step is None else step.edge for step in walk]
    turns = [FlatEdge(first, numbers[0], rolled=True), FlatEdge(np.array([first[-1], second[-1]]), numbers[1])]
    if others:
        turns.append(FlatEdge(second[::-1], numbers[2], rolled=True))
    return (*turns, FlatEdge(np.array([second[0], first[0]]), numbers[-1]))


def _rim(boundary: Boundary, step: DirectedEdge | None) -> Floats:
    arc = None if step is None else boundary.arc(boundary.edges[step.edge])
    if step is None or arc is None:
        raise ValueError("a curved side begins at one of its rims")
    return _walked(arc, step.forward, _FINE)


def _from_a_rim(boundary: Boundary, face: Face) -> list[DirectedEdge | None]:
    """The edges around a curved side from a rim on; None for the seam where it is closed."""
    if boundary.edges[face.loops[0][0].edge].start is None:
        near, *far = (loop[0] for loop in face.loops)
        return [near, None, *far, None]
    loop: Loop = face.loops[0]
    at = next(k for k, step in enumerate(loop) if boundary.arc(boundary.edges[step.edge]) is not None)
    return [*loop[at:], *loop[:at]]


def _laid(face: Face, near: Floats, far: Floats | None) -> tuple[Floats, Floats]:
    """Both rims (k, 2) laid flat, the far one running the same way as the near one; the side lies to its left."""
    if isinstance(face.surface, Cone):
        to = near - face.surface.apex
        size = np.linalg.norm(to, axis=1)
        cosine = (to[1:] * to[:-1]).sum(axis=1) / (size[1:] * size[:-1])
        sine = np.linalg.norm(np.cross(to[1:], to[:-1]), axis=1) / (size[1:] * size[:-1])
        part = 0.0 if far is None else float(np.linalg.norm(far[0] - face.surface.apex) / size[0])
        angle = np.append(0.0, np.cumsum(np.arctan2(sine, cosine))) * (1.0 if part < 1.0 else -1.0)
        first = size[:, None] * np.c_[np.cos(angle), np.sin(angle)]
        return first, part * first
    if far is None:
        raise ValueError("a cylinder has two rims")
    through = far[0] - near[0]
    height = float(np.linalg.norm(through))
    steps = np.diff(near, axis=0)
    along = steps @ (through / height)
    across = np.linalg.norm(steps - along[:, None] * (through / height), axis=1)
    first = np.c_[np.append(0.0, np.cumsum(across)), np.append(0.0, np.cumsum(along))]
    return first, first + [0.0, height]
