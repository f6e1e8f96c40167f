"""What a solid is called, in words."""

from __future__ import annotations

import numpy as np

from sketch2shape.model import Arc, Cone, Floats, Plane, Solid

#: sides and right angles of a box, and the sides of a regular polygon, are exact to this part of its size
_EXACT = 1e-3

#: a number of sides -> what the base is called
_SIDED = {3: "triangular", 4: "four-sided", 5: "pentagonal", 6: "hexagonal", 7: "heptagonal", 8: "octagonal"}


def shape_name(solid: Solid) -> str:
    """As in "box", "hexagonal prism", "prism with 11 sides", "cylinder", "tube", "truncated cone", "square pyramid"."""
    sizes = solid.ring_sizes
    pointed = is_pointed(solid)
    name = _round_name(solid, pointed) if _is_bent(solid) else _straight_name(solid, pointed)
    holes = len(sizes) - 1
    if name == "cylinder" and holes == 1 and _is_tube(solid):
        return "tube"
    if not holes:
        return name
    whole = "round " if all(size == 0 for size in sizes[1:]) else ""
    return f"{name} with {'a' if holes == 1 else holes} {whole}hole{'s' * (holes > 1)}"


def is_pointed(solid: Solid) -> bool:
    """Do all sides of a two-face solid meet in its last vertex?"""
    sides = len(solid.faces) - 1
    return sides == sum(len(loop) for loop in solid.faces[0].loops)


def _is_bent(solid: Solid) -> bool:
    """Has the outer ring an arc?"""
    return any(solid.boundary.arc(solid.edges[number]) is not None for number, _ in solid.faces[0].loops[0])


def _is_tube(solid: Solid) -> bool:
    """Have a cylinder and its one hole the same axis?"""
    first, second = (solid.boundary.arc(solid.edges[loop[0].edge]) for loop in solid.faces[0].loops)
    if first is None or second is None:
        return False
    apart = float(np.linalg.norm(first.circle.center - second.circle.center))
    return apart <= 0.02 * first.circle.radius


def _round_name(solid: Solid, pointed: bool) -> str:
    loop = solid.faces[0].loops[0]
    arcs = [solid.boundary.arc(solid.edges[number]) for number, _ in loop]
    tapered = any(isinstance(face.surface, Cone) for face in solid.faces)
    if len(loop) == 1:
        return "cone" if pointed else "truncated cone" if tapered else "cylinder"
    profile = _profile(solid, arcs)
    if pointed:
        return f"pointed {profile}" if profile != "half disc" else "half cone"
    if tapered:
        return f"tapered {profile}"
    return {"half disc": "half cylinder", "quarter disc": "quarter cylinder"}.get(profile, f"{profile} prism")


def _profile(solid: Solid, arcs: list[Arc | None]) -> str:
    """What the front face is called: by its arcs, how far they turn, and which way."""
    out = solid.faces[0].surface
    normal = out.normal if isinstance(out, Plane) else np.zeros(3)
    loop = solid.faces[0].loops[0]
    sweeps: list[float] = []
    before: Arc | None = None
    for arc, (_, forward) in zip(arcs, loop, strict=True):
        outward = 1.0 if arc is None or forward == (arc.circle.normal @ normal > 0) else -1.0
        turn = 0.0 if arc is None else outward * float(np.degrees(arc.sweep))
        if before is not None and arc is not None and _is_one(before, arc):
            sweeps[-1] += turn  # one arc in two pieces
        else:
            sweeps.append(turn)
        before = arc
    bent = [s for s in sweeps if s]
    n = len(sweeps)
    halves, quarters = sum(abs(s - 180) < 2 for s in bent), sum(abs(s - 90) < 2 for s in bent)
    if n == 2 and len(bent) == 1:
        return "half disc" if halves else "segment"
    if n == 3 and len(bent) == 1 and bent[0] > 0:
        return "quarter disc" if quarters else "sector"
    if n == 4 and halves == 2 == len(bent):
        return "slot"
    if n == 4 and halves == 1 == len(bent):
        return "round-ended"
    if n == 8 and quarters == 4 == len(bent):
        return "rounded rectangle"
    return "arched" if len(bent) == 1 and bent[0] < -100 else "round-edged"


def _is_one(one: Arc, other: Arc) -> bool:
    """Are two arcs pieces of one circle?"""
    apart = float(np.linalg.norm(one.circle.center - other.circle.center))
    return max(apart, abs(one.circle.radius - other.circle.radius)) <= 0.02 * one.circle.radius


def _straight_name(solid: Solid, pointed: bool) -> str:
    n = solid.ring_sizes[0]
    ring = solid.vertices[list(solid.rings(solid.faces[0])[0])]
    if pointed:
        return f"{_base(ring)} pyramid" if n in _SIDED else f"pyramid with {n} sides"
    half = sum(solid.ring_sizes)
    front, back = solid.vertices[:n], solid.vertices[half : half + n]
    joins = back - front
    size = float(np.linalg.norm(np.ptp(solid.vertices, axis=0)))
    straight = bool(np.ptp(joins, axis=0).max() <= _EXACT * size)
    holes = len(solid.ring_sizes) - 1
    if straight and n == 4 and _is_square(np.array([front[1] - front[0], front[3] - front[0], joins[0]])):
        return "plate" if holes else "box"
    if n in _SIDED and n != 4 and _is_convex(ring):
        return f"{_SIDED[n]} prism" if straight else f"tapered {_SIDED[n]} prism"
    return f"{'prism' if straight else 'tapered object'} with {n} sides"


def _base(ring: Floats) -> str:
    """What the base of a pyramid is called."""
    n = len(ring)
    if n != 4:
        return _SIDED[n]
    a, b = ring[1] - ring[0], ring[3] - ring[0]
    long, wide = float(np.linalg.norm(a)), float(np.linalg.norm(b))
    right = abs(float(a @ b)) <= _EXACT * long * wide
    if not right or float(np.linalg.norm(ring[2] - ring[1] - b)) > _EXACT * long:
        return "four-sided"
    return "square" if abs(long - wide) <= 0.02 * max(long, wide) else "rectangular"


def _is_convex(ring: Floats) -> bool:
    before, after = ring - np.roll(ring, 1, axis=0), np.roll(ring, -1, axis=0) - ring
    turns = np.cross(before, after)
    return bool((turns @ turns.sum(axis=0) > 0).all())


def _is_square(edges: Floats) -> bool:
    """Whether three edges (3, 3) stand at right angles."""
    unit = edges / np.maximum(np.linalg.norm(edges, axis=1, keepdims=True), 1e-300)
    return bool(np.abs(unit @ unit.T - np.eye(3)).max() <= _EXACT)
