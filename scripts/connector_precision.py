"""How often each connector finds the whole order of a face."""

from __future__ import annotations

import json
import sys
import time
from collections import defaultdict
from pathlib import Path
from typing import Any

import numpy as np
import repository  # noqa: F401 - for `evaluation`

sys.path.insert(0, str(Path(__file__).parent))
from connector_faces import SETS, Face, face_set, with_a_vertex_missing, with_an_extra_vertex

from evaluation.markdown import table
from sketch2shape.connectors import connect, connect_detailed, split_walk_preconditions
from sketch2shape.connectors.polygon import canonical
from sketch2shape.errors import Sketch2ShapeError

NOISE = (0.0, 0.5, 1.0, 2.0)
SWEEPS: dict[str, tuple[str, tuple[float, ...]]] = {
    "park-oh": ("N", (0.7, 0.9, 1.1, 1.3, 1.5, 2.0)),
    "park-oh-all": ("N", (0.7, 0.9, 1.1, 1.3, 1.5, 2.0)),
    "concave-hull": ("concavity", (0.6, 0.8, 1.0, 1.2, 1.5, 2.0)),
    "chi-shape": ("ratio", (0.0, 0.1, 0.2, 0.3, 0.5)),
    "chi-shape-shapely": ("ratio", (0.0, 0.1, 0.2, 0.3, 0.5)),
    "ec-shape": ("v", (0.8, 1.0, 1.2, 1.5)),
    "moreira-santos": ("k", (3, 4, 5)),
}


def percent(value: float) -> str:
    return f"{100 * value:.0f}"


def is_right(face: Face, method: str, parameters: dict[str, Any]) -> bool:
    try:
        return canonical(connect(face.points, method, **parameters)) == face.order
    except Sketch2ShapeError:
        return False


def precision(found: list[Face], method: str, parameters: dict[str, Any]) -> float:
    """Part of the faces whose whole order is right: TP / (TP + FP) of the paper."""
    return float(np.mean([is_right(face, method, parameters) for face in found]))


def best_parameters(found: list[Face], method: str) -> dict[str, Any]:
    """The best value of a sweep, or the defaults where they are no worse."""
    if method not in SWEEPS:
        return {}
    name, values = SWEEPS[method]
    choices: list[dict[str, Any]] = [{}, *({name: value} for value in values)]
    scores = [precision(found, method, choice) for choice in choices]
    return choices[int(np.argmax(scores))]


def exactness(parameters: dict[str, dict[str, Any]], count: int, seed: int) -> tuple[str, dict[str, float]]:
    """Exact orders of each method on each set."""
    sets = {name: face_set(name, count, 0.0, seed) for name in SETS}
    rows, frontal = [], {}
    for method, chosen in parameters.items():
        scores = [precision(found, method, chosen) for found in sets.values()]
        frontal[method] = scores[0]
        took = time.perf_counter()
        for face in sets["frontal"][:40]:
            is_right(face, method, chosen)
        took = (time.perf_counter() - took) / 40
        value = ", ".join(f"{k}={v:g}" for k, v in chosen.items()) or "-"
        rows.append([f"`{method}`", value, *(percent(score) for score in scores), f"{1e6 * took:.0f}"])
    head = ["method", "parameter", *(f"{name} ({len(found)})" for name, found in sets.items()), "us a face"]
    return table(head, rows), frontal


def under_noise(parameters: dict[str, dict[str, Any]], count: int, seed: int) -> str:
    """Exact orders with moved, missing and extra vertices, over the frontal, affine and rectilinear sets together."""
    conditions: dict[str, list[Face]] = {}
    for noise in NOISE:
        conditions[f"{noise:g} px"] = [
            face
            for name in ("frontal", "affine", "rectilinear")
            for face in face_set(name, max(count // 2, 1), noise, seed)
        ]
    clean, rng = conditions["0 px"], np.random.default_rng(seed)
    conditions["one missing"] = [with_a_vertex_missing(face, rng) for face in clean if len(face.points) > 4]
    conditions["one extra"] = [with_an_extra_vertex(face, rng) for face in clean]
    rows = [
        [f"`{method}`", *(percent(precision(found, method, chosen)) for found in conditions.values())]
        for method, chosen in parameters.items()
    ]
    return table(["method", *(f"{name} ({len(found)})" for name, found in conditions.items())], rows)


def where_the_walk_is_right(count: int, seed: int) -> str:
    """For each profile: faces the walk gets right, and faces that meet its preconditions."""
    right: dict[str, list[bool]] = defaultdict(list)
    held: dict[str, list[bool]] = defaultdict(list)
    rivals: dict[str, list[bool]] = defaultdict(list)
    for name in ("frontal", "affine", "rectilinear", "random", "simple"):
        for face in face_set(name, count, 0.0, seed):
            order = np.array(face.order)
            right[face.profile].append(is_right(face, "split-walk", {}))
            held[face.profile].append(split_walk_preconditions(face.points, order).hold)
            rivals[face.profile].append(is_right(face, "auto", {}))
    rows = [
        [
            name,
            str(len(right[name])),
            percent(np.mean(right[name])),
            percent(np.mean(held[name])),
            percent(np.mean(rivals[name])),
        ]
        for name in right
    ]
    return table(["profile", "faces", "`split-walk` exact %", "preconditions hold %", "`auto` exact %"], rows)


def sureness(count: int, seed: int) -> str:
    """How often `auto` is right, by how sure it says it is."""
    answers = []
    for name in SETS:
        for noise in (0.0, 1.0):
            for face in face_set(name, count, noise, seed + 7):
                found = connect_detailed(face.points)
                answers.append((found.sureness or 0.0, canonical(found.order) == face.order))
    got = np.array(answers)
    rows = []
    for low, high in ((0, 0.3), (0.3, 0.5), (0.5, 0.7), (0.7, 0.9), (0.9, 0.98), (0.98, 1.01)):
        here = (got[:, 0] >= low) & (got[:, 0] < high)
        if here.any():
            rows.append([f"{low:g} to {min(high, 1):g}", str(int(here.sum())), percent(got[here, 1].mean())])
    return table(["sureness", "answers", "right %"], rows)


def given_points(file: Path, parameters: dict[str, dict[str, Any]]) -> str:
    by_profile: dict[str, list[Face]] = defaultdict(list)
    for row in json.loads(file.read_text()):
        by_profile[row["profile"]].append(
            Face(row["profile"], np.array(row["points"]), canonical(np.array(row["order"])))
        )
    shown = list(parameters)
    rows = []
    for profile, found in by_profile.items():
        rows.append([profile, str(len(found)), *(percent(precision(found, m, parameters[m])) for m in shown)])
    every = [face for found in by_profile.values() for face in found]
    rows.append(["all", str(len(every)), *(percent(precision(every, m, parameters[m])) for m in shown)])
    return table(["profile", "faces", *shown], rows)
