"""How often drawings with arcs, and those that come to a point, are lifted to the right solid.

    python scripts/evaluate_round_lifting.py             a table for each kind of solid, as Markdown
    python scripts/evaluate_round_lifting.py -n 50       with so many of each kind

Objects and views come from the generator of drawings; their truth, with noise on vertices and arcs, is what is lifted.
`scripts/evaluate_lifting.py` puts the table into the page.
"""

from __future__ import annotations

import argparse
import json
from dataclasses import dataclass
from typing import Any

import numpy as np
import repository  # noqa: F401  (finds the package)

from evaluation.markdown import share
from sketch2shape.lifting import lift
from sketch2shape.model import DrawnArc, Ellipse, FacePair, Floats, Plane, Side, Solid, TwoFaceObject
from sketch2shape.solids import tessellated
from synthetic.outlines import Outline
from synthetic.scenes import Wish
from synthetic.turned_scenes import KINDS, Turned, turned_scene, turned_truth

NOISES = (0.0, 1.0, 2.0)
WISH = Wish(("oblique", "axonometric"), lines="dashed")
SHEET, PEN = (640, 480), 2.0

#: most that area over perimeter squared, and depth over the root of the area, may be off for a right solid
LIMIT = 0.05


@dataclass(frozen=True)
class Case:
    """One lifted drawing: are its proportions right, is it sure of them, is its mesh closed and outward?"""

    right: bool
    sure: bool
    mesh: bool


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-n", type=int, default=40, help="drawings of each kind (default 40)")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    print(table(options.n, options.seed))


def table(n: int, seed: int) -> str:
    """The Markdown table: rows are kinds, columns noises."""
    head = " | ".join(f"{noise:g} px" for noise in NOISES)
    lines = [f"| proportions right, at noise of | drawings | {head} |", "|---|---|" + "---|" * len(NOISES)]
    every: list[list[Case]] = [[] for _ in NOISES]
    for kind in KINDS:
        made = [turned_scene(kind, WISH, SHEET, PEN, np.random.default_rng([seed, k])) for k in range(n)]
        rows = [[_case(m, noise, np.random.default_rng([seed, k, 1])) for k, m in enumerate(made)] for noise in NOISES]
        for kept, row in zip(every, rows, strict=True):
            kept += row
        lines.append(f"| {kind} | {n} | {' | '.join(share([c.right for c in row]) for row in rows)} |")
    lines.append(f"| **all** | {n * len(KINDS)} | {' | '.join(share([c.right for c in row]) for row in every)} |")
    sure = [share([c.right for c in row if c.sure]) for row in every]
    lines.append(f"| of those at 0.9 or more | | {' | '.join(sure)} |")
    lines.append(f"| mesh closed and outward | | {' | '.join(share([c.mesh for c in row]) for row in every)} |")
    return "\n".join(lines) + "\n"


def _case(made: Turned, noise: float, rng: np.random.Generator) -> Case:
    truth = json.loads(json.dumps(turned_truth(made, WISH.lines)))
    solid = lift(drawn_object(truth, noise, rng))
    form = tessellated(solid.boundary)
    walked = [(a, b) for a, b in form.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2).tolist()]
    closed = len(set(walked)) == len(walked) and {(b, a) for a, b in walked} == set(walked)
    return Case(_error(made, solid) < LIMIT, solid.confidence >= 0.9, closed and solid.volume > 0)


def _error(made: Turned, solid: Solid) -> float:
    """How far the outer ring's form, and the depth unless it is free, are off."""
    area, around = _measures(made.rings[0])
    face = solid.faces[0]
    form = tessellated(solid.boundary, 1e-4 * max(solid.dimensions))
    ring = form.vertices[list(form.ring(face.loops[0]))]
    steps = np.roll(ring, -1, axis=0) - ring
    own_around = float(np.linalg.norm(steps, axis=1).sum())
    own_area = 0.5 * float(np.linalg.norm(np.cross(ring - ring[0], ring + steps - ring[0]).sum(axis=0)))
    off = abs(own_area / own_around**2 / (area / around**2) - 1.0)
    if made.view.facts["family"] == "oblique":
        return off
    normal = face.surface.normal if isinstance(face.surface, Plane) else np.zeros(3)
    depth = float(np.ptp(form.vertices @ normal))
    return max(off, abs(depth / own_area**0.5 / (made.depth / area**0.5) - 1.0))


def _measures(ring: Outline) -> tuple[float, float]:
    """Area and perimeter of an outline, by many chords."""
    if ring.circle:
        return np.pi * ring.circle.radius**2, 2 * np.pi * ring.circle.radius
    arcs = ring.arcs()
    pieces = [arcs[i].at(np.arange(500) / 500) if i in arcs else p[None] for i, p in enumerate(ring.points)]
    points = np.vstack(pieces)
    after = np.roll(points, -1, axis=0)
    area = 0.5 * abs(float((points[:, 0] * after[:, 1] - points[:, 1] * after[:, 0]).sum()))
    return area, float(np.linalg.norm(after - points, axis=1).sum())


def drawn_object(truth: dict[str, Any], noise: float, rng: np.random.Generator) -> TwoFaceObject:
    """The truth as an object found in a drawing, with noise on its vertices and along its arcs, pixels."""
    pairs, arcs = [], []
    for hole, pair in enumerate([truth, *truth["holes"]], -1):
        rings: list[Floats] = []
        faces: tuple[Side, Side] = ("f1", "f2")
        for face in faces:
            points = np.array(pair[face], float).reshape(-1, 2)
            rings.append(points + noise * rng.normal(size=points.shape))
            own = [a for a in truth["arcs"] if a["face"] == face and a["hole"] == (None if hole < 0 else hole)]
            arcs += [_arc(a, rings[-1], noise, rng) for a in own]
        pairs.append(FacePair(*rings))
    told = truth["lines"], max(noise, 0.3)
    return TwoFaceObject(pairs[0].f1, pairs[0].f2, tuple(pairs[1:]), lines=told[0], noise=told[1], arcs=tuple(arcs))


def _arc(data: dict[str, Any], ring: Floats, noise: float, rng: np.random.Generator) -> DrawnArc:
    """An arc that ends at the shaken vertices and bends a little off its course between."""
    shape, points = data["ellipse"], np.array(data["points"], float)
    axes = np.array(shape["axes"]) + 0.7 * noise * rng.normal(size=2)
    center = np.array(shape["center"]) + 0.7 * noise * rng.normal(size=2)
    ellipse = Ellipse(center, (float(axes.max()), float(axes.min())), float(shape["angle"]))
    start, end = data["from"], data["to"]
    if start is not None:
        part = np.linspace(0, 1, len(points))[:, None]
        points += (1 - part) * (ring[start] - points[0]) + part * (ring[end] - points[-1])
        points += noise * np.sin(np.pi * part) * rng.normal(size=2)
    return DrawnArc(data["face"], data["hole"], start, end, ellipse, points)


if __name__ == "__main__":
    main()
