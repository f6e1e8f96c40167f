"""Draw solids as people do, lift the drawings, and fit how sure the lifting may be of its proportions.

    python scripts/calibrate_lifting.py                  2000 drawings: what is meant, per view, on either half
    python scripts/calibrate_lifting.py --fit            also the coefficients of `Solid.confidence`, from the even half

Each drawing is a prism that people draw (boxes, cubes, letters, houses, wedges, polygons) in a view that they use, its
vertices shaken as a hand shakes them. The lifting is told half of the shaking at most, as a reader of ink sees less
of it than there is.
"""

from __future__ import annotations

import argparse
import collections
import time
from dataclasses import dataclass

import numpy as np
from scipy.optimize import minimize

from sketch2shape.lifting import lift
from sketch2shape.lifting.decision import all_readings
from sketch2shape.lifting.projection import prepare
from sketch2shape.lifting.trust import Option, belief, cues, options_of
from sketch2shape.model import Bools, Floats, Lines, Solid, TwoFaceObject

VIEWS = (
    "cabinet",
    "cavalier",
    "isometric",
    "dimetric",
    "trimetric",
    "standing",
    "one-point",
    "two-point",
    "three-point",
    "tapered",
)
#: how often each view is drawn
SHARES = np.array([0.2, 0.08, 0.2, 0.1, 0.12, 0.1, 0.05, 0.07, 0.04, 0.04])

#: what a proportion may be off to be what was meant: of the face, of the depth; all of it in perspective
FACE, DEPTH, PERSPECTIVE = 0.12, 0.15, 0.25

#: depths over the drawn receding length that are as good as one another in an oblique drawing
FREE_DEPTH = (0.9, 2.3)

#: confidence from which on one is sure
SURE = 0.9

#: width of the drawings, pixels, and the shaking, pixels
SIZE, SHAKING = 340.0, (0.0, 1.5, 3.0, 4.5, 7.0)


@dataclass(frozen=True)
class Case:
    """One drawing and what it shows.

    obj    : the drawn object
    view   : one of `VIEWS`
    face   : (n, 2) true front face
    depth  : true distance between the faces
    shaken : standard deviation of the drawn vertices, pixels
    """

    obj: TwoFaceObject
    view: str
    face: Floats
    depth: float
    shaken: float


def draw(rng: np.random.Generator) -> Case:
    """A drawing as someone might make it."""
    view = str(rng.choice(VIEWS, p=SHARES))
    face = _face(rng)
    extent = float(np.ptp(face, axis=0).mean())
    depth = float(rng.choice([1.0, 0.5, 2.0, rng.uniform(0.5, 2.0)])) * (extent if rng.random() < 0.6 else _side(face))
    depth = float(np.clip(depth, 0.35 * extent, 2.5 * extent))
    flat, scale = _seen(view, face, depth, rng)
    careless = 1.0
    if view in ("cabinet", "cavalier") and rng.random() < 0.4:
        careless = float(rng.uniform(0.95, 1.04))
    half = len(flat) // 2
    middle = flat[half:].mean(axis=0)
    flat[half:] = middle + careless * (flat[half:] - middle)
    flat *= SIZE * rng.uniform(0.8, 1.3) / float(np.ptp(flat, axis=0).max())
    shaken = float(rng.choice(SHAKING))
    flat += rng.normal(0.0, shaken, flat.shape)
    lines: Lines = "wire" if rng.random() < 0.5 else "removed"
    noise = max(0.3, shaken * rng.uniform(0.3, 0.6))
    obj = TwoFaceObject(flat[:half] + 300.0, flat[half:] + 300.0, lines=lines, noise=noise)
    return Case(obj, view, face * scale, depth * scale, shaken)


def _side(face: Floats) -> float:
    edges = np.linalg.norm(np.roll(face, -1, axis=0) - face, axis=1)
    return float(edges[0])


def _face(rng: np.random.Generator) -> Floats:
    """A profile, y down, that people draw."""
    kind = str(
        rng.choice(["square", "box", "box", "L", "T", "U", "stairs", "house", "wedge", "arrow", "polygon", "lean"])
    )
    a, b = (float(x) for x in rng.choice([1.0, 1.5, 2.0, 3.0], 2))
    t, s = (float(x) for x in rng.uniform(0.3, 0.6, 2))
    rings: dict[str, list[list[float]]] = {
        "square": [[0, 0], [1, 0], [1, 1], [0, 1]],
        "box": [[0, 0], [a, 0], [a, b], [0, b]],
        "L": [[0, 0], [2, 0], [2, 2 * t], [2 * s, 2 * t], [2 * s, 1 + a / 2], [0, 1 + a / 2]],
        "T": [[1 - s, 0], [1 + s, 0], [1 + s, 1], [2, 1], [2, 1 + 2 * t], [0, 1 + 2 * t], [0, 1], [1 - s, 1]],
        "U": [[0, 0], [2, 0], [2, 1.6], [1 + s, 1.6], [1 + s, t], [1 - s, t], [1 - s, 1.6], [0, 1.6]],
        "stairs": [[0, 0], [3, 0], [3, 1], [2, 1], [2, 2], [1, 2], [1, 3], [0, 3]],
        "house": [[0, 0], [1.6, 0], [1.6, 1 + t / 2], [0.8, 1.5 + s], [0, 1 + t / 2]],
        "wedge": [[0, 0], [1.8, 0], [1.8, 0.6 + t], [0, 2.5 * t * t]],
        "lean": [[0, 0], [a, 0], [a + t, b], [t, b]],
        "arrow": [[0, 0.3], [a, 0.3], [a, 0], [a + 1, 0.6], [a, 1.2], [a, 0.9], [0, 0.9]],
    }
    if kind == "polygon":
        n = int(rng.choice([3, 5, 6, 6, 8]))
        turn = 2 * np.pi * (np.arange(n) + (0.0 if n % 2 or rng.random() < 0.5 else 0.5)) / n - 0.5 * np.pi
        polygon: Floats = np.c_[np.cos(turn), np.sin(turn)]
        return polygon
    face = np.array(rings[kind], float) * [1.0, -1.0]
    return face * [rng.choice([-1.0, 1.0]), 1.0] if kind in ("L", "stairs", "wedge") else face


def _seen(view: str, face: Floats, depth: float, rng: np.random.Generator) -> tuple[Floats, float]:
    """(2n, 2) the drawing, y down, front face first, and how large it is drawn where that is known (oblique)."""
    solid = np.concatenate([np.c_[face, np.zeros(len(face))], np.c_[face, np.full(len(face), depth)]])
    solid -= solid.mean(axis=0)
    side = float(rng.choice([-1.0, 1.0]))
    if view in ("cabinet", "cavalier"):
        rise = np.deg2rad(rng.choice([30.0, 45.0, 60.0] if view == "cabinet" else [30.0, 45.0]))
        reach = (0.5 if view == "cabinet" else 1.0) * solid[:, 2]
        return solid[:, :2] + np.c_[side * np.cos(rise) * reach, -np.sin(rise) * reach], 1.0
    if view == "tapered":
        n = len(face)
        solid[n:, :2] *= rng.uniform(0.3, 0.7)
    if view == "standing" or (view == "isometric" and rng.random() < 0.25):
        # the face lies on the ground, seen from above
        solid = solid[:, [0, 2, 1]] * [1.0, 1.0, -1.0]
    azimuth, elevation = _held(view, rng)
    solid = _turned(solid, side * azimuth, elevation)
    if view not in ("one-point", "two-point", "three-point"):
        return solid[:, :2], 1.0
    size = float(np.linalg.norm(np.ptp(solid, axis=0)))
    away = size * rng.uniform(1.6, 3.5)
    if view != "three-point":
        solid += [side * size * rng.uniform(0.1, 0.5) * (view == "one-point"), size * rng.uniform(0.25, 0.7), 0.0]
    return solid[:, :2] / (solid[:, 2:] + away) * away, 1.0


def _held(view: str, rng: np.random.Generator) -> tuple[float, float]:
    """Azimuth and elevation of a view, degrees."""
    if view == "isometric":
        return 45.0, float(np.rad2deg(np.arcsin(1.0 / np.sqrt(3.0))))
    if view == "dimetric":
        return float(rng.choice([20.705, 69.295])), 19.471
    if view == "standing":
        return float(rng.uniform(15.0, 75.0)), float(rng.uniform(18.0, 45.0))
    if view in ("one-point", "two-point"):
        return float(rng.uniform(25.0, 65.0)) * (view == "two-point"), 0.0
    return float(rng.uniform(20.0, 70.0)), float(rng.uniform(15.0, 42.0))


def _turned(points: Floats, azimuth: float, elevation: float) -> Floats:
    """Points turned about the upright axis, then seen from above; degrees."""
    a, e = np.deg2rad([azimuth, elevation])
    yaw = np.array([[np.cos(a), 0, np.sin(a)], [0, 1, 0], [-np.sin(a), 0, np.cos(a)]])
    pitch = np.array([[1, 0, 0], [0, np.cos(e), np.sin(e)], [0, -np.sin(e), np.cos(e)]])
    turned: Floats = points @ yaw.T @ pitch
    return turned


def readings_of(obj: TwoFaceObject) -> list[Option]:
    """The solids that a drawing may be of."""
    return options_of(all_readings(prepare(obj)), wire=obj.lines == "wire")


def is_meant(case: Case, solid: Solid) -> bool:
    """Has the solid the proportions that were drawn?"""
    n = len(case.face)
    front, back = solid.vertices[:n], solid.vertices[n:]
    got = np.linalg.norm(np.roll(front, -1, axis=0) - front, axis=1)
    want = np.linalg.norm(np.roll(case.face, -1, axis=0) - case.face, axis=1)
    scale = got.sum() / want.sum()
    wide = case.view.endswith("point")
    if np.abs(got / scale / want - 1.0).max() > (PERSPECTIVE if wide else FACE):
        return False
    if case.view == "tapered":
        return True
    depth = float(np.linalg.norm(back.mean(axis=0) - front.mean(axis=0))) / scale
    if case.view in ("cabinet", "cavalier"):
        drawn = case.depth * (0.5 if case.view == "cabinet" else 1.0)
        return bool(FREE_DEPTH[0] * drawn <= depth <= FREE_DEPTH[1] * drawn)
    if case.view == "one-point":
        return bool(0.4 < depth / case.depth < 2.5)
    return bool(abs(depth / case.depth - 1.0) < (PERSPECTIVE if wide else DEPTH))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cases", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--fit", action="store_true", help="fit the weights of the cues to the even half")
    args = parser.parse_args()
    rows: dict[str, list[bool]] = collections.defaultdict(list)
    told, good, sure = [], [], []
    start = time.process_time()
    for k in range(args.cases):
        case = draw(np.random.default_rng([args.seed, k]))
        solid = lift(case.obj, picture_size=(640, 560))
        good.append(is_meant(case, solid))
        sure.append(solid.confidence)
        for key in (case.view, f"shaken {case.shaken:g}", ("even half", "odd half")[k % 2], "all"):
            rows[key].append(good[-1])
        if args.fit:
            options = readings_of(case.obj)
            told.append([belief(options, 0), *cues(options[0].shape)])
    for key, goods in sorted(rows.items()):
        print(f"{key:14s} {len(goods):5d} {np.mean(goods):7.1%}")
    right, confidence = np.array(good), np.array(sure)
    if args.fit:
        cases = np.array(told)
        weights = _fitted(cases[::2], right[::2])
        print("weights", np.round(weights, 3).tolist())
        confidence = cases[:, 0] / (1.0 + np.exp(-cases[:, 1:] @ weights))
    for name, half in (("even", slice(0, None, 2)), ("odd", slice(1, None, 2))):
        above = confidence[half] >= SURE
        print(f"sure, {name} half: {above.mean():.1%} of the cases, {right[half][above].mean():.1%} of them meant")
    for low in np.arange(0.0, 1.0, 0.1):
        among = (confidence[1::2] >= low) & (confidence[1::2] < low + 0.1)
        if among.any():
            print(f"confidence {low:.1f} to {low + 0.1:.1f}: {among.sum():4d}, meant {right[1::2][among].mean():.1%}")
    print(f"{1000 * (time.process_time() - start) / args.cases:.1f} ms each")


def _fitted(cases: Floats, right: Bools) -> Floats:
    """Weights of the cues by maximum likelihood; cases (n, 1 + k): the belief, then the cues."""

    def unlikely(weights: Floats) -> float:
        p = np.clip(cases[:, 0] / (1.0 + np.exp(-cases[:, 1:] @ weights)), 1e-6, 1.0 - 1e-6)
        return -float(np.log(np.where(right, p, 1.0 - p)).sum())

    start = np.append(4.0, np.zeros(cases.shape[1] - 2))
    return np.asarray(minimize(unlikely, start, method="Nelder-Mead", options={"maxiter": 4000}).x)


if __name__ == "__main__":
    main()
