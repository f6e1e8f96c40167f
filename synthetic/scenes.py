"""Random two-face objects seen in a random view, placed on the sheet, with a check that a person could draw them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from shapely.geometry import Polygon

from sketch2shape.model import Floats, ring_edges
from synthetic.profiles import CONVEX, EVERYDAY, LARGE, chamfered, profile, regular
from synthetic.projecting import View, axonometric, oblique, random_view
from synthetic.visibility import Interval, seen_intervals

FINE = (0.025, 0.06)
"""Size of small chamfers, fraction of the profile's longer side."""
FAR_APART = 8.0
"""Distance of two vertices, pixels, above which nothing of a drawing is fine."""
SHALLOW = (2.5, 7.0)
"""Length at which a shallow object's depth is drawn, pen widths."""


@dataclass(frozen=True)
class Wish:
    """What kind of object is wanted.

    views   : projection families to choose from
    shapes  : "everyday", "convex", "large", or the name of one profile family
    lines   : "wire", "dashed", "removed"
    taper   : back face smaller than the front face (or larger)
    holes   : number of through-holes at most (at least one if > 0)
    accident: name of an accidental alignment, see `ACCIDENTS`
    shallow : the depth is drawn only a few pen widths long
    fine    : small chamfers, whose ends lie a few pixels apart
    room    : factor on the distances that details keep from each other
    """

    views: tuple[str, ...] = ("oblique", "axonometric")
    shapes: str = "everyday"
    lines: str = "wire"
    taper: bool = False
    holes: int = 0
    accident: str | None = None
    shallow: bool = False
    fine: bool = False
    room: float = 1.0


@dataclass(frozen=True)
class Scene:
    """One object on the sheet.

    name    : profile family
    solid   : (2m, 3) vertices: front rings, then back rings (outer ring first)
    sizes   : vertices of each ring of one face
    depth   : distance between the faces, profile units
    points  : (2m, 2) picture positions, pixels
    key     : (2m,) depth keys, smaller is nearer
    edges   : for each edge (a, b, seen intervals of 0..1)
    facts   : projection, for the truth
    """

    name: str
    solid: Floats
    sizes: list[int]
    depth: float
    points: Floats
    key: Floats
    edges: list[tuple[int, int, list[Interval]]]
    facts: dict[str, Any]

    @property
    def half(self) -> int:
        """Vertices of one face, holes included."""
        return sum(self.sizes)

    def truth(self, lines: str, points: Floats | None = None) -> dict[str, Any]:
        """The drawing's truth for JSON; `points` where the strokes' ends moved the vertices."""
        p = np.round(self.points if points is None else points, 3)
        n, half = self.sizes[0], self.half
        holes, start = [], n
        for k in self.sizes[1:]:
            f1, f2 = p[start : start + k], p[half + start : half + start + k]
            holes.append({"f1": f1.tolist(), "f2": f2.tolist()})
            start += k
        flat = np.round(self.solid[:, :2], 6)
        solid = {"profile": flat[:n].tolist(), "back": flat[half : half + n].tolist(), "depth": round(self.depth, 6)}
        return {
            "profile": self.name,
            "n": n,
            "projection": self.facts,
            "lines": lines,
            "f1": p[:n].tolist(),
            "f2": p[half : half + n].tolist(),
            "holes": holes,
            "solid": solid,
        }


def scene(wish: Wish, size: tuple[int, int], pen: float, rng: np.random.Generator, fill: float = 0.8) -> Scene:
    """A random object as wished, inside a sheet of `size` (w, h) pixels drawn with a pen `pen` pixels wide."""
    for attempt in range(4000):
        made = _attempt(wish, size, pen, rng, fill)
        # After many vain attempts (a 24-gon with a broad pen) details may come somewhat closer to each other.
        slack = wish.room * (1.0 if attempt < 400 else 0.6)
        if made is not None and _drawable(made, wish, pen, slack):
            return made
    raise ValueError(f"no drawable object found for {wish} on {size} with a pen of {pen} px")


def _attempt(wish: Wish, size: tuple[int, int], pen: float, rng: np.random.Generator, fill: float) -> Scene | None:
    name = _pick(wish, rng)
    ring = profile(name, rng)
    if wish.fine:
        ring = chamfered(ring, FINE, rng)
    holes = _holes(ring, wish.holes, rng) if wish.holes else []
    if wish.holes and not holes:
        return None
    depth = float(rng.uniform(0.45, 1.3))
    view = random_view(str(rng.choice(list(wish.views))), rng)
    if wish.accident:
        planned = ACCIDENTS[wish.accident](ring, depth, rng)
        if planned is None:
            return None
        name, ring, depth, view = planned[0] or name, planned[1], planned[2], planned[3]
    if wish.shallow:
        depth = _shallow(view, ring, size, fill) * pen * float(rng.uniform(*SHALLOW))
    scale = float(rng.uniform(0.4, 0.8)) if wish.taper else 1.0
    front = [ring, *holes]
    back = [r * scale for r in front]
    if wish.taper and rng.random() < 0.25:
        front, back = back, front
    solid = np.vstack([np.c_[r, np.zeros(len(r))] for r in front] + [np.c_[r, np.full(len(r), depth)] for r in back])
    return _placed(name, solid, [len(r) for r in front], depth, view, size, rng, fill)


def _shallow(view: View, ring: Floats, size: tuple[int, int], fill: float) -> float:
    """Depth, in profile units, that is drawn about a pixel long where the front face fills the sheet."""
    flat = view(np.c_[ring, np.zeros(len(ring))])[:, :2]
    scale = float((np.array(size) * fill / np.ptp(flat, axis=0)).min())
    back = view(np.c_[ring, np.full(len(ring), 0.1)])[:, :2]
    return 0.1 / max(scale * float(np.linalg.norm(back - flat, axis=1).mean()), 1e-9)


def _placed(
    name: str,
    solid: Floats,
    sizes: list[int],
    depth: float,
    view: View,
    size: tuple[int, int],
    rng: np.random.Generator,
    fill: float,
) -> Scene | None:
    """Scale and shift the picture into the sheet; None if the front face looks away from the viewer."""
    centred = solid - [0, 0, depth / 2] if view.facts["family"] == "perspective" else solid
    flat = view(centred)[:, :2]
    sheet = np.array(size, float)
    low, high = flat.min(0), flat.max(0)
    scale = float((sheet * rng.uniform(0.75, 1.0) * fill / (high - low)).min())
    room = (sheet - scale * (high - low)) / 2
    shift = sheet / 2 - scale * (low + high) / 2 + rng.uniform(-0.6, 0.6, 2) * np.maximum(room - 0.04 * sheet, 0)
    projected = view.placed(scale, shift)(centred)
    n = sizes[0]
    if _area(projected[:n, :2]) * _area(solid[:n, :2]) <= 0:
        return None
    return Scene(
        name, solid, sizes, depth, projected[:, :2], projected[:, 2], seen_intervals(projected, sizes), view.facts
    )


def _area(ring: Floats) -> float:
    x, y = ring.T
    return float(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2


def _pick(wish: Wish, rng: np.random.Generator) -> str:
    pools: dict[str, tuple[str, ...]] = {"everyday": EVERYDAY, "convex": CONVEX, "large": LARGE}
    return str(rng.choice(pools.get(wish.shapes, (wish.shapes,))))


def _holes(ring: Floats, most: int, rng: np.random.Generator) -> list[Floats]:
    """Up to `most` disjoint hole rings well inside the ring; none if no room is found."""
    room = Polygon(ring)
    found: list[Floats] = []
    for _ in range(40):
        if len(found) == most or (found and rng.random() < 0.04):
            break
        k, r = int(rng.choice([3, 4, 4, 5, 6, 8])), rng.uniform(0.12, 0.22)
        centre = rng.uniform(ring.min(0), ring.max(0))
        turn = rng.choice([np.pi / 4, rng.uniform(0, np.pi)])
        hole = (regular(k, turn) * r * [1, rng.uniform(0.7, 1.2)]) + centre
        if room.contains(Polygon(hole).buffer(0.09)):
            found.append(hole[::-1].copy())
            room = room.difference(Polygon(hole).buffer(0.1))
    return found


def _drawable(made: Scene, wish: Wish, pen: float, slack: float) -> bool:
    """Whether each detail is large enough for the pen, and what must be inferred can be."""
    p, edges = made.points, ring_edges(made.sizes)
    short = max(3.2 * pen, 11.0) * slack
    length = np.linalg.norm(p[edges[:, 0]] - p[edges[:, 1]], axis=1)
    if length.min() < short or (wish.fine and length.min() > FAR_APART):
        return False
    if not wish.accident and not _apart(p, edges, max(2.2 * pen, 5.0) * slack, short):
        return False
    return wish.lines != "removed" or _inferable(made)


def _apart(p: Floats, edges: np.ndarray, gap: float, short: float) -> bool:
    """No vertex near another vertex or a foreign edge, no two edges leaving a vertex almost alike."""
    off = np.linalg.norm(p[:, None] - p[None], axis=2) + np.eye(len(p)) * 1e9
    if off.min() < short:
        return False
    a, d = p[edges[:, 0]], p[edges[:, 1]] - p[edges[:, 0]]
    t = np.clip(((p[:, None] - a) * d).sum(2) / (d**2).sum(1), 0, 1)
    away = np.linalg.norm(p[:, None] - (a + t[..., None] * d), axis=2)
    away[edges[:, 0], np.arange(len(edges))] = away[edges[:, 1], np.arange(len(edges))] = 1e9
    if away.min() < gap:
        return False
    unit = d / np.linalg.norm(d, axis=1)[:, None]
    for v in range(len(p)):
        out = np.vstack([unit[edges[:, 0] == v], -unit[edges[:, 1] == v]])
        cosine = out @ out.T - 2 * np.eye(len(out))
        if cosine.max() > np.cos(np.radians(9)):
            return False
    return True


def _inferable(made: Scene) -> bool:
    """With hidden lines removed: the front face is drawn whole and enough of the back face is to complete it."""
    n, half = made.sizes[0], made.half
    whole = {i: any(t1 > 1 - 1e-6 for _, t1 in s) for i, (_, _, s) in enumerate(made.edges)}
    front, back_drawn = [], set()
    for i, (a, b, seen) in enumerate(made.edges):
        if a < half and b < half:
            front.append(len(seen) == 1 and seen[0][0] < 1e-6 and whole[i])
        elif a < n <= half <= b and whole[i]:
            back_drawn.add(b)
    perspective = made.facts["family"] == "perspective" and made.facts["kind"] != "one-point"
    need = 3 if perspective else 2
    return all(front) and len(back_drawn) >= need


Plan = tuple[str | None, Floats, float, View]


def _isometric_cube(_ring: Floats, _depth: float, rng: np.random.Generator) -> Plan:
    """A true isometric cube or box: a back vertex falls on a front one."""
    half = np.array([[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]])
    view = axonometric("isometric", float(rng.choice([-1, 1])) * np.pi / 4, float(np.arcsin(np.tan(np.pi / 6))))
    return "square", half, 1.0, view


def _vertex_on_edge(ring: Floats, depth: float, rng: np.random.Generator) -> Plan | None:
    """A back vertex falls on a front edge."""
    n = len(ring)
    i, j = int(rng.integers(n)), int(rng.integers(n))
    if i in (j, (j + 1) % n):
        return None
    target = ring[j] + rng.uniform(0.3, 0.7) * (ring[(j + 1) % n] - ring[j])
    return _oblique_by(ring, depth, target - ring[i])


def _collinear(ring: Floats, depth: float, rng: np.random.Generator) -> Plan | None:
    """A back edge runs along a parallel front edge."""
    d = np.roll(ring, -1, 0) - ring
    cross = np.abs(d[:, None, 0] * d[None, :, 1] - d[:, None, 1] * d[None, :, 0]) + np.eye(len(ring))
    pairs = np.argwhere(cross < 1e-9)
    if not len(pairs):
        return None
    i, j = pairs[int(rng.integers(len(pairs)))]
    along = d[j] / np.linalg.norm(d[j])
    gap = ring[j] - ring[i]
    gap = gap - (gap @ along) * along
    return _oblique_by(ring, depth, gap + along * rng.choice([-1, 1]) * rng.uniform(0.15, 0.4))


def _parallel(ring: Floats, depth: float, rng: np.random.Generator) -> Plan | None:
    """Connecting edges run in the direction of a face edge: that side face is seen edge-on."""
    i = int(rng.integers(len(ring)))
    d = ring[(i + 1) % len(ring)] - ring[i]
    factor = rng.choice([-1, 1]) * rng.choice([rng.uniform(0.35, 0.75), rng.uniform(1.3, 1.8)])
    return _oblique_by(ring, depth, d * factor, edge_on=1)


def _coincident(ring: Floats, depth: float, rng: np.random.Generator) -> Plan | None:
    """A back vertex falls on a front vertex that is not its neighbour."""
    n = len(ring)
    i, j = int(rng.integers(n)), int(rng.integers(n))
    if (i - j) % n in (0, 1, n - 1):
        return None
    return _oblique_by(ring, depth, ring[j] - ring[i])


def _oblique_by(ring: Floats, depth: float, d: Floats, edge_on: int = 0) -> Plan | None:
    size = float(np.linalg.norm(d))
    if not 0.15 < size < 1.2:
        return None
    view = oblique("free", size / depth, float(np.arctan2(-d[1], d[0])))
    turn = np.roll(ring, -1, 0) - ring
    sine = np.abs(turn[:, 0] * d[1] - turn[:, 1] * d[0]) / np.linalg.norm(turn, axis=1) / size
    # One side face seen edge-on is an accident, several make a flat figure that nobody can read.
    return (None, ring, depth, view) if np.count_nonzero(sine < 0.12) == edge_on else None


ACCIDENTS: dict[str, Callable[[Floats, float, np.random.Generator], Plan | None]] = {
    "isometric_cube": _isometric_cube,
    "vertex_on_edge": _vertex_on_edge,
    "collinear": _collinear,
    "parallel": _parallel,
    "coincident": _coincident,
}
