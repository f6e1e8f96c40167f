"""Curved and pointed objects in a random view, with their truth in the report's words.

The front face is an outline of lines and arcs; the back face is the same moved, or drawn together, or a point.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from shapely.geometry import LineString, Point, Polygon

from sketch2shape.model import Floats
from synthetic.bodies import Body, Line, drawn_lines, silhouettes
from synthetic.outlines import MIXED, PLATES, ROUND, Arc, Outline, outline, pyramid_base, round_holes
from synthetic.projecting import View, axonometric, random_view
from synthetic.scenes import Wish

KINDS = ("cylinder", "tube", "plate", "mixed", "cone", "frustum", "pyramid")
SAMPLES = 17
"""Points of each arc in the truth, first and last included."""
SHORT_AXIS = 0.22
"""Least length of the axis in the picture, part of the front face's extent, and of a point's distance from its base:
nobody looks along the axis."""


@dataclass(frozen=True)
class Turned:
    """One object on the sheet.

    shape    : in words
    rings    : outlines of the front face, the outer one first
    scale    : size of the back face: 1 a prism, 0 a point
    depth    : distance of the faces, front face's units
    view     : solid to sheet
    lines    : what is drawn, seen and hidden
    outlines : (k, 2, 2) ends of the outline edges of curved sides, pixels
    """

    shape: str
    rings: tuple[Outline, ...]
    scale: float
    depth: float
    view: View
    lines: tuple[Line, ...]
    outlines: Floats


def turned_scene(
    kind: str, wish: Wish, size: tuple[int, int], pen: float, rng: np.random.Generator, fill: float = 0.8
) -> Turned:
    """A random object of a kind on a sheet of `size` (w, h), drawn with a pen `pen` pixels wide.

    wish : its views; its shapes name an outline for the kinds that have a choice
    """
    for _ in range(400):
        shape, rings, scale = _faces(kind, wish.shapes, rng)
        depth = float(rng.uniform(0.4, 1.4) if scale == 1 else rng.uniform(0.7, 1.5))
        body = _body(rings, scale, depth)
        view = _placed(body, _view(kind, wish.views, rng), size, fill, rng)
        ends = [view(body.vertices[list(e)])[:, :2] for e in silhouettes(body, view)]
        outlines = np.array(ends).reshape(-1, 2, 2)
        if _drawable(rings, scale, depth, view, outlines, pen):
            lines = drawn_lines(body, view, wire=wish.lines == "wire")
            return Turned(shape, rings, scale, depth, view, tuple(lines), outlines)
    raise ValueError(f"no drawable {kind} found on {size} with a pen of {pen} px")


def _faces(kind: str, wished: str, rng: np.random.Generator) -> tuple[str, tuple[Outline, ...], float]:
    """Words for the shape, outlines of the front face, and the size of the back face."""
    if kind in ("cylinder", "tube"):
        front = outline("circle", rng)
        return kind, (front, *(round_holes(front, 1, rng) if kind == "tube" else [])), 1.0
    if kind == "plate":
        name = _named(wished, PLATES, rng)
        holes: list[Outline] = []
        while not holes:
            front = outline(name, rng)
            holes = round_holes(front, int(rng.integers(1, 4)), rng)
        return f"{name} plate with holes", (front, *holes), 1.0
    if kind == "mixed":
        name = _named(wished, MIXED, rng)
        return f"{name} prism", (outline(name, rng),), 1.0
    if kind == "pyramid":
        base = pyramid_base(int(wished) if wished.isdigit() else None, rng)
        return f"{len(base.points)}-sided pyramid", (base,), 0.0
    scale = 0.0 if kind == "cone" else float(rng.uniform(0.3, 0.75))
    round_base = kind == "cone" or (wished not in ROUND and rng.random() < 0.7)
    name = "circle" if round_base else _named(wished, MIXED, rng)
    words = kind if kind == "cone" else "truncated cone" if name == "circle" else f"tapered {name}"
    return words, (outline(name, rng),), scale


def _named(wished: str, known: tuple[str, ...], rng: np.random.Generator) -> str:
    """The outline wished for if it is the name of one, else one of those known."""
    return wished if wished in ROUND or wished in PLATES else str(rng.choice(known))


def _view(kind: str, families: tuple[str, ...], rng: np.random.Generator) -> View:
    """Pointed objects stand with the base below as a rule; the others as prisms do."""
    if families in (("perspective",), ("below",)):
        return random_view(families[0], rng)
    if kind in ("cone", "frustum", "pyramid") and rng.random() < 0.85:
        elevation = float(np.radians(rng.uniform(12, 40)))
        return axonometric("trimetric", float(np.radians(rng.uniform(-80, 80))), elevation, lying=True)
    return random_view(str(rng.choice(list(families))), rng)


def _body(rings: tuple[Outline, ...], scale: float, depth: float) -> Body:
    """The surface as flat faces; connecting edges within arcs and at smooth joints count as smooth."""
    front: list[tuple[int, ...]] = []
    points, smooth_at = [], []
    for ring in rings:
        chords, names = ring.chords()
        joints = ring.smooth()
        start = sum(len(r) for r in front)
        front.append(tuple(range(start, start + len(chords))))
        points.append(chords)
        smooth_at += [n < 0 or joints[n] for n in names]
    flat = np.vstack(points)
    m = len(flat)
    near = np.c_[flat, np.zeros(m)]
    if scale == 0:
        vertices = np.vstack([near, [[0, 0, depth]]])
        sides = [((b, a, m),) for ring in front for a, b in zip(ring, ring[1:] + ring[:1], strict=True)]
        smooth = {(i, m) for i in range(m) if smooth_at[i]}
        return Body(vertices, (tuple(front), *sides), frozenset(smooth))
    vertices = np.vstack([near, np.c_[scale * flat, np.full(m, depth)]])
    back = tuple(tuple(i + m for i in ring[::-1]) for ring in front)
    quads = [((b, a, a + m, b + m),) for ring in front for a, b in zip(ring, ring[1:] + ring[:1], strict=True)]
    return Body(vertices, (tuple(front), back, *quads), frozenset((i, i + m) for i in range(m) if smooth_at[i]))


def _placed(body: Body, view: View, size: tuple[int, int], fill: float, rng: np.random.Generator) -> View:
    flat = view(body.vertices)[:, :2]
    sheet, low, high = np.array(size, float), flat.min(0), flat.max(0)
    scale = float((sheet * rng.uniform(0.75, 1.0) * fill / (high - low)).min())
    room = np.maximum((sheet - scale * (high - low)) / 2 - 0.04 * sheet, 0)
    return view.placed(scale, sheet / 2 - scale * (low + high) / 2 + rng.uniform(-0.6, 0.6, 2) * room)


def _drawable(rings: tuple[Outline, ...], scale: float, depth: float, view: View, outlines: Floats, pen: float) -> bool:
    """Whether every ring is large and open enough for the pen, a cone has its outline, and all lines have a length."""
    for ring in rings:
        seen = view(np.c_[ring.chords()[0], np.zeros(len(ring.chords()[0]))])[:, :2]
        if np.linalg.svd(seen - seen.mean(0), compute_uv=False)[1] / np.sqrt(len(seen)) < max(2.2 * pen, 5):
            return False
        corners = ring.points
        if len(corners) > 1:
            edges = view(np.c_[corners, np.zeros(len(corners))])[:, :2]
            if np.linalg.norm(edges - np.roll(edges, -1, 0), axis=1).min() < max(3.2 * pen, 11):
                return False
    axis = view(np.array([[0, 0, 0], [0, 0, depth]], float))[:, :2]
    outer = view(np.c_[rings[0].chords()[0], np.zeros(len(rings[0].chords()[0]))])[:, :2]
    least = max(8 * pen, SHORT_AXIS * float(np.ptp(outer, axis=0).max()))
    if scale == 0 and not rings[0].circle and not _spread(outer, axis[1], max(2.2 * pen, 5)):
        return False
    needs_outline = rings[0].circle is not None
    return bool(np.linalg.norm(axis[1] - axis[0]) > least and (len(outlines) >= 2 or not needs_outline))


def _spread(base: Floats, apex: Floats, gap: float) -> bool:
    """Whether a pyramid shows more than its base, and no corner falls on a side edge of another one."""
    if Polygon(base).distance(Point(*apex)) < SHORT_AXIS * float(np.ptp(base, axis=0).max()):
        return False
    sides = [LineString([apex, corner]) for corner in base]
    return all(s.distance(Point(*c)) > gap for i, s in enumerate(sides) for j, c in enumerate(base) if i != j)


def turned_truth(made: Turned, lines: str) -> dict[str, Any]:
    """The drawing's truth for JSON, in the report's words; an edge with an arc is curved, all others are straight."""
    f1, f2, holes, smooth, arcs, solid_arcs = [], [], [], [], [], []
    for k, ring in enumerate(made.rings):
        pair = {}
        for face, scale, z in (("f1", 1.0, 0.0), ("f2", made.scale, made.depth)):
            pointed = scale == 0
            flat = ring.scaled(scale)
            corners = np.zeros((1, 2)) if pointed else flat.points
            pair[face] = np.round(made.view(np.c_[corners, np.full(len(corners), z)])[:, :2], 3).tolist()
            for i, arc in {} if pointed else flat.arcs().items():
                place = _place(face, k, i, len(ring.points))
                arcs.append(place | _seen_arc(arc, z, made.view))
                solid_arcs.append(place | _solid_arc(arc, z))
        if k == 0:
            f1, f2, smooth = pair["f1"], pair["f2"], ring.smooth()
        else:
            holes.append(pair)
    return {
        "shape": made.shape,
        "profile": made.shape,
        "n": len(f1),
        "projection": made.view.facts,
        "lines": lines,
        "f1": f1,
        "f2": f2,
        "holes": holes,
        "smooth": smooth,
        "arcs": arcs,
        "silhouettes": np.round(made.outlines, 3).tolist(),
        "front": _front(made),
        "solid": {"arcs": solid_arcs, "depth": made.depth, "scale": made.scale, "vertices": _solid_vertices(made)},
    }


def _front(made: Turned) -> str:
    """The face whose middle lies nearer to the viewer."""
    keys = made.view(np.array([[0, 0, 0], [0, 0, made.depth]], float))[:, 2]
    return "f1" if keys[0] < keys[1] else "f2"


def _place(face: str, ring: int, start: int, n: int) -> dict[str, Any]:
    whole = start < 0
    ends = {"from": None if whole else start, "to": None if whole else (start + 1) % n}
    return {"face": face, "hole": None if ring == 0 else ring - 1} | ends


def _seen_arc(arc: Arc, z: float, view: View) -> dict[str, Any]:
    """The arc in the picture: samples, and the ellipse it lies on (half axes, angle of the longer one in degrees)."""
    circle = {"center": arc.centre, "axes": [arc.radius, arc.radius], "angle": 0.0}
    flat = view.matrix[[0, 1, 3]]
    ellipse = moved_ellipse(circle, np.c_[flat[:, :2], z * flat[:, 2] + flat[:, 3]])
    return {"ellipse": ellipse, "points": np.round(view(_in_space(arc, z))[:, :2], 3).tolist()}


def _solid_arc(arc: Arc, z: float) -> dict[str, Any]:
    return {
        "center": [*np.round(arc.centre, 6).tolist(), z],
        "normal": [0.0, 0.0, 1.0],
        "radius": round(arc.radius, 6),
        "points": np.round(_in_space(arc, z), 6).tolist(),
    }


def _in_space(arc: Arc, z: float) -> Floats:
    points: Floats = np.c_[arc.at(np.linspace(0, 1, SAMPLES)), np.full(SAMPLES, z)]
    return points


def _solid_vertices(made: Turned) -> list[list[float]]:
    """The rings' vertices in space: f1, holes' f1, f2, holes' f2; the apex is one vertex."""
    near = np.vstack([ring.points for ring in made.rings])
    far = np.zeros((1, 2)) if made.scale == 0 else made.scale * near
    out = np.vstack([np.c_[near, np.zeros(len(near))], np.c_[far, np.full(len(far), made.depth)]])
    rounded: list[list[float]] = np.round(out, 6).tolist()
    return rounded


def moved_arc(arc: dict[str, Any], homography: Floats) -> dict[str, Any]:
    """A true arc after the picture was moved by a homography."""
    h = np.c_[arc["points"], np.ones(len(arc["points"]))] @ homography.T
    points = h[:, :2] / h[:, 2:]
    return arc | {"points": np.round(points, 3).tolist(), "ellipse": moved_ellipse(arc["ellipse"], homography)}


def moved_ellipse(ellipse: dict[str, Any], homography: Floats) -> dict[str, Any]:
    """The ellipse that a homography makes of another: C' = H^-T C H^-1."""
    a, b = ellipse["axes"]
    c, s = np.cos(np.radians(ellipse["angle"])), np.sin(np.radians(ellipse["angle"]))
    frame = np.array([[c * a, -s * b, ellipse["center"][0]], [s * a, c * b, ellipse["center"][1]], [0, 0, 1]])
    # The unit circle in the frame's coordinates; frame and homography together carry it to the picture.
    inverse = np.linalg.inv(homography @ frame)
    conic = inverse.T @ np.diag([1.0, 1.0, -1.0]) @ inverse
    centre = np.linalg.solve(conic[:2, :2], -conic[:2, 2])
    level = float(centre @ conic[:2, 2] + conic[2, 2])
    values, vectors = np.linalg.eigh(conic[:2, :2] / -level)  # the longer axis first
    axes = 1 / np.sqrt(values)
    return {
        "center": np.round(centre, 3).tolist(),
        "axes": np.round(axes, 3).tolist(),
        "angle": round(float(np.degrees(np.arctan2(vectors[1, 0], vectors[0, 0])) % 180), 3),
    }
