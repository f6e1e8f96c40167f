"""Exactness of answers to drawings with arcs or an apex: every ring's line, its sharp vertices, its arcs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.optimize import linear_sum_assignment
from scipy.spatial import cKDTree

from evaluation import metrics
from evaluation.metrics import Thing, Verdict
from sketch2shape.model import Floats

LOOSE = {"clean": 0.02, "thin": 0.02, "blueprint": 0.02, "annotated": 0.02}
"""Largest distance of the ring's line, fraction of the object's diagonal, for media drawn exactly."""
ORDINARY = 0.03
"""The same for the others."""
LEAST = 4.0
"""Never asked to be nearer than this, pixels."""
CORNER = 1.3
"""Times as far a sharp vertex may be off: along the line it is known less well than across."""
STEPS = 400
"""Points that stand for a ring's line."""


@dataclass(frozen=True)
class Ring:
    """One ring as drawn.

    line     : (k, 2) closed, sampled
    vertices : (n, 2)
    sharp    : (s, 2) those at which the line turns
    arcs     : number of curved edges
    """

    line: Floats
    vertices: Floats
    sharp: Floats
    arcs: int


def has_curves(truth: Thing) -> bool:
    """Whether a truth is told by lines and arcs."""
    return "arcs" in truth


def judge(truth: Thing, answers: Sequence[Thing]) -> Verdict:
    """Exactness of what was reported for a drawing of one object with arcs or an apex.

    Either face may be called f1. But dashes and hidden lines left out tell which face is in front, and then it must be
    the same; a wireframe does not tell. Truths without `front` call the faces as an answer has to.
    """
    if len(answers) != 1:
        return Verdict(False, f"{len(answers)} objects reported")
    answer, other = answers[0], _exchanged(answers[0])
    if truth["lines"] == "wire":
        verdicts = [_as_named(truth, answer), _as_named(truth, other)]
        return next((v for v in verdicts if v.exact), verdicts[0])
    seen = truth.get("front") and answer.get("solid", {}).get("camera")
    if seen and front_of(answer) != truth["front"]:
        verdict = _as_named(truth, other)
        mirrored = not verdict.exact and _as_named(truth, answer).exact
        return Verdict(False, "the face behind is taken for the one in front") if mirrored else verdict
    return _as_named(truth, answer)


def front_of(answer: Thing) -> str:
    """The name of the face that lies nearer to the viewer in the answered solid."""
    camera = np.array(answer["solid"]["camera"], float)
    faces = [_in_space(answer, face) for face in ("f1", "f2")]
    h = camera @ np.r_[np.vstack(faces).mean(0), 1]
    # How the middle of the solid moves in the picture. Right, down and the way into the picture are right-handed.
    right, down = (camera[:2, :3] - np.outer(h[:2] / h[2], camera[2, :3])) / h[2]
    inwards = np.cross(right, down)
    depths = [points.mean(0) @ inwards for points in faces]
    return "f1" if depths[0] < depths[1] else "f2"


def _in_space(answer: Thing, face: str) -> Floats:
    """(k, 3) points of the outer ring of a face of the answered solid: its vertices and those along its arcs."""
    solid, holes = answer["solid"], answer.get("holes") or []
    start = 0 if face == "f1" else len(answer["f1"]) + sum(len(hole["f1"]) for hole in holes)
    vertices = np.array(solid["vertices"][start : start + len(answer[face])], float).reshape(-1, 3)
    along = [np.array(a["points"], float) for a in solid.get("arcs") or [] if (a["face"], a["hole"]) == (face, None)]
    return np.vstack([vertices, *along])


def _exchanged(thing: Thing) -> Thing:
    """The same object, its faces called by each other's names."""
    holes = [{"f1": hole["f2"], "f2": hole["f1"]} for hole in thing.get("holes") or []]
    arcs = [a | {"face": "f1" if a["face"] == "f2" else "f2"} for a in _arcs(thing)]
    return thing | {"f1": thing["f2"], "f2": thing["f1"], "holes": holes, "arcs": arcs}


def _as_named(truth: Thing, answer: Thing) -> Verdict:
    """Exactness where f1 and f2 of the answer stand for those of the truth."""
    if len(answer.get("holes") or []) != len(truth["holes"]):
        return Verdict(False, f"{len(answer.get('holes') or [])} holes instead of {len(truth['holes'])}")
    worst = 0.0
    for face in ("f1", "f2"):
        for hole in (None, *range(len(truth["holes"]))):
            if hole is not None and _is_apex(truth, face):
                continue
            limit = _limit(truth) * (1.5 if face == "f2" and truth["lines"] == "removed" else 1.0)
            places = [None] if hole is None else list(range(len(truth["holes"])))
            pairs = [_compared(truth, answer, face, hole, place, limit) for place in places]
            cause, off = min(pairs, key=lambda pair: (bool(pair[0]), pair[1]))
            if cause:
                return Verdict(False, f"{face}{'' if hole is None else f' of hole {hole}'}: {cause}")
            worst = max(worst, off)
    return Verdict(True, error=worst)


def ring_lines(thing: Thing) -> list[Floats]:
    """(k, 2) the closed line of every ring of a truth or an answer with arcs."""
    holes = range(len(thing.get("holes") or []))
    rings = [_true_ring(thing, face, hole).line for face in ("f1", "f2") for hole in (None, *holes)]
    return [line for line in rings if np.ptp(line, axis=0).any()]


def _is_apex(truth: Thing, face: str) -> bool:
    return face == "f2" and len(truth["f2"]) == 1 and not any(a["face"] == "f2" for a in _arcs(truth))


def _arcs(thing: Thing) -> list[dict[str, Any]]:
    arcs = thing.get("arcs")
    return arcs if isinstance(arcs, list) else []


def _limit(truth: Thing) -> float:
    every = np.vstack([_true_ring(truth, face, None).line for face in ("f1", "f2")])
    part = LOOSE.get(truth["medium"], ORDINARY) * (1.6 if metrics.family(truth) == "perspective" else 1.0)
    return max(LEAST, part * float(np.linalg.norm(np.ptp(every, axis=0))))


def _compared(
    truth: Thing, answer: Thing, face: str, hole: int | None, place: int | None, limit: float
) -> tuple[str, float]:
    """What sets a true ring and an answered one apart, and how far off its line is, pixels."""
    want, got = _true_ring(truth, face, hole), _answered_ring(answer, face, place)
    if _is_apex(truth, face):
        if len(got.vertices) != 1:
            return f"no apex but {len(got.vertices)} vertices", float("inf")
        off = float(np.linalg.norm(got.vertices[0] - want.vertices[0]))
        return ("" if off <= limit else f"the apex is off by {off:.0f} px (allowed {limit:.0f})"), off
    if len(got.line) < 3:
        return "missing", float("inf")
    off = _apart(want.line, got.line)
    if off > limit:
        return f"its line is off by {off:.0f} px (allowed {limit:.0f})", off
    if not len(want.vertices):
        return ("" if got.arcs else "chords for an ellipse"), off
    if (len(got.vertices), got.arcs) != (len(want.vertices), want.arcs):
        had, asked = (f"{len(r.vertices)} vertices and {r.arcs} arcs" for r in (got, want))
        return f"{had} instead of {asked}", off
    if len(want.sharp):
        distance = np.linalg.norm(want.sharp[:, None] - got.vertices[None], axis=2)
        corner = float(distance[linear_sum_assignment(distance)].max())
        if corner > CORNER * limit:
            return f"a vertex is off by {corner:.0f} px (allowed {CORNER * limit:.0f})", off
    return "", off


def _true_ring(truth: Thing, face: str, hole: int | None) -> Ring:
    """A ring of a truth, in the report's words or with its sampled outline beside it."""
    pair = truth if hole is None else truth["holes"][hole]
    smooth = pair.get("smooth") or [True] * len(pair[face]) if hole is not None else truth.get("smooth") or []
    vertices = np.array(pair[face], float).reshape(-1, 2)
    sharp = np.array([not s for s in smooth], bool)[: len(vertices)]
    if f"{face}_outline" not in pair:
        ring = _answered_ring(truth, face, hole)
        return Ring(ring.line, vertices, vertices[sharp] if len(sharp) == len(vertices) else vertices, ring.arcs)
    line = np.array(pair[f"{face}_outline"], float)
    return Ring(line, vertices, vertices[sharp] if len(sharp) == len(vertices) else vertices, int(pair["arcs"]))


def _answered_ring(thing: Thing, face: str, hole: int | None) -> Ring:
    """A ring told by vertices and arcs, an edge with an arc along it."""
    pair = thing if hole is None else thing["holes"][hole]
    vertices = np.array(pair.get(face) or [], float).reshape(-1, 2)
    arcs = [a for a in _arcs(thing) if a["face"] == face and a.get("hole") == hole]
    whole = [a for a in arcs if a.get("from") is None]
    if whole:
        return Ring(np.array(whole[0]["points"], float), vertices, vertices, len(arcs))
    along = {(a["from"], a["to"]): np.array(a["points"], float) for a in arcs}
    pieces, n = [], len(vertices)
    for i in range(n):
        j = (i + 1) % n
        # A ring of two vertices has an edge each way, so that only a longer one may tell its arcs backwards.
        backwards = along[(j, i)][::-1] if n > 2 and (j, i) in along else vertices[[i, j]]
        pieces.append(along.get((i, j), backwards))
    return Ring(np.vstack(pieces) if pieces else vertices, vertices, vertices, len(arcs))


def _apart(one: Floats, other: Floats) -> float:
    """Largest distance of a point of one closed line from the other, both ways."""
    a, b = _dense(one), _dense(other)
    return float(max(cKDTree(a).query(b)[0].max(), cKDTree(b).query(a)[0].max()))


def _dense(line: Floats) -> Floats:
    closed = np.vstack([line, line[:1]])
    steps = np.r_[0, np.cumsum(np.linalg.norm(np.diff(closed, axis=0), axis=1))]
    at = np.linspace(0, steps[-1], STEPS)
    points: Floats = np.c_[np.interp(at, steps, closed[:, 0]), np.interp(at, steps, closed[:, 1])]
    return points
