"""How well an answer agrees with the truth of a drawing, by the measures of the field.

Truth and answers are plain dictionaries, as in the JSON beside a test drawing and in a report: `f1`, `f2`, `holes`
(each with `f1`, `f2`), and for answers `confidence` and `solid.vertices`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import product
from typing import Any

import numpy as np

from sketch2shape.model import Floats, Ints, ring_edges

Thing = dict[str, Any]

#: part of the object's diagonal by which a vertex may be off, for media in which the truth itself is not exact
LOOSE = {
    "clean": 0.015,
    "thin": 0.015,
    "annotated": 0.02,
    "blueprint": 0.02,
    "cad": 0.02,
    "noisy": 0.02,
    "marker": 0.025,
}
LOOSE |= {"photo": 0.035, "real": 0.04, "handheavy": 0.045, "freehand": 0.06}
ORDINARY = 0.03


@dataclass(frozen=True)
class Verdict:
    """An answer compared with the truth.

    exact : the vertices match one to one and the edges are the same
    cause : what is wrong, in a few words; empty if exact
    error : largest distance of a vertex from its place, pixels (nan unless exact)
    match : (2m,) truth index of each answered vertex, or None unless exact
    """

    exact: bool
    cause: str = ""
    error: float = float("nan")
    match: Ints | None = None


def wireframe(thing: Thing) -> tuple[Floats, Ints]:
    """(2m, 2) vertices f1, holes' f1, f2, holes' f2, and (3m, 2) edges into them."""
    if len(thing["f1"]) != len(thing["f2"]):
        return _pointed(thing)
    pairs = [thing, *(thing.get("holes") or [])]
    rings = [p["f1"] for p in pairs] + [p["f2"] for p in pairs]
    return np.array([v for r in rings for v in r], float).reshape(-1, 2), ring_edges([len(p["f1"]) for p in pairs])


def _pointed(thing: Thing) -> tuple[Floats, Ints]:
    """The same for a face and an apex: the ring, and its edges to the one vertex of f2."""
    n = len(thing["f1"])
    ring = np.arange(n)
    edges = np.vstack([np.c_[ring, np.roll(ring, -1)], np.c_[ring, np.full(n, n)]])
    return np.array([*thing["f1"], *thing["f2"][:1]], float).reshape(-1, 2), edges.astype(np.intp)


def family(truth: Thing) -> str:
    """Projection family of a truth, which is a word or a dictionary."""
    projection = truth["projection"]
    return str(projection if isinstance(projection, str) else projection["family"])


def tolerance(truth: Thing) -> Floats:
    """(2m,) pixels: how far each vertex of the answer may be from its place.

    Larger where a hand drew, where hidden lines are left out (the back face is inferred), and in perspective, where a
    small change of slope moves the vanishing point far.
    """
    vertices, _ = wireframe(truth)
    part = LOOSE.get(truth.get("medium", ""), ORDINARY)
    part *= 1.5 if truth["lines"] == "removed" else 1.0
    part *= 1.6 if family(truth) == "perspective" else 1.0
    outer = np.array(truth["f1"] + truth["f2"], float)
    limit = max(3.0 if truth.get("medium") == "clean" else 4.0, part * float(np.linalg.norm(np.ptp(outer, axis=0))))
    allowed = np.full(len(vertices), limit)
    drawn = np.array(truth.get("f2_drawn") or [True] * len(truth["f2"]), bool)
    back = len(vertices) // 2 + np.arange(len(drawn))
    allowed[back[~drawn]] *= 2.5
    return allowed


def compare(truth: Thing, answer: Thing) -> Verdict:
    """Exactness of one answered object against one true object, whichever faces are called f1 and f2."""
    from scipy.optimize import linear_sum_assignment

    (want, want_edges), (got, got_edges) = wireframe(truth), wireframe(answer)
    if len(want) != len(got):
        return Verdict(False, f"{len(got) // 2} vertices a face instead of {len(want) // 2}")
    distance = np.linalg.norm(want[:, None] - got[None], axis=2)
    rows, columns = linear_sum_assignment(np.minimum(distance, 1e4) ** 2)
    off, limit = distance[rows, columns], tolerance(truth)[rows]
    if (off > limit).any():
        worst = int((off / limit).argmax())
        return Verdict(False, f"a vertex is off by {off[worst]:.0f} px (allowed {limit[worst]:.0f})")
    match = np.empty(len(got), np.intp)
    match[columns] = rows
    for twin in _same_places(match, want, float(limit.min())):
        if _edge_set(twin[got_edges]) == _edge_set(want_edges):
            return Verdict(True, "", float(off.max()), twin)
    return Verdict(False, "vertices right, edges wrong")


def _same_places(match: Ints, want: Floats, limit: float) -> Iterator[Ints]:
    """The match, then those with vertices exchanged that lie in one place, as in an isometric cube."""
    close = np.linalg.norm(want[:, None] - want[None], axis=2) < limit
    pairs = [(int(i), int(j)) for i, j in np.argwhere(np.triu(close, 1))][:6]
    for choice in product((False, True), repeat=len(pairs)):
        swap = np.arange(len(want))
        for (i, j), chosen in zip(pairs, choice, strict=True):
            if chosen:
                swap[[i, j]] = swap[[j, i]]
        yield swap[match]


def judge(truth: Thing, answers: Sequence[Thing]) -> Verdict:
    """Exactness of everything reported for a picture: one object, a sheet of several, or none."""
    if "objects" not in truth:
        if len(answers) != 1:
            return Verdict(False, f"{len(answers)} objects reported")
        return compare(truth, answers[0])
    wanted = truth["objects"]
    found = sum(any(compare(w, a).exact for a in answers) for w in wanted)
    if found == len(wanted) == len(answers):
        return Verdict(True, error=0.0)
    return Verdict(False, f"{found} of {len(wanted)} objects right, {len(answers)} reported")


def _edge_set(edges: Ints) -> set[frozenset[int]]:
    return {frozenset((int(a), int(b))) for a, b in edges}


def objects_of(truth: Thing) -> list[Thing]:
    """The true objects of a picture: none, one or several."""
    return list(truth["objects"]) if "objects" in truth else [truth]


def junction_counts(truth: Thing, answers: Sequence[Thing], radius: float = 2.0) -> tuple[int, int, int]:
    """(right, reported, true) vertices, matched one to one within `radius` at 128 x 128 pixels."""
    from scipy.optimize import linear_sum_assignment

    want, got = (_at_128(truth, [wireframe(t)[0] for t in things]) for things in (objects_of(truth), answers))
    if not len(want) or not len(got):
        return 0, len(got), len(want)
    distance = np.linalg.norm(want[:, None] - got[None], axis=2)
    rows, columns = linear_sum_assignment(distance > radius)
    return int((distance[rows, columns] <= radius).sum()), len(got), len(want)


def structural_ap(
    cases: Sequence[tuple[Thing, Sequence[Thing]]], thresholds: Sequence[float] = (5, 10, 15)
) -> list[float]:
    """sAP (Zhou, Qi, Ma 2019) of the edges, hidden ones included, one value a threshold.

    An answered edge is right if the sum of its ends' squared distances from a true edge not yet taken is below the
    threshold at 128 x 128 pixels; edges are ranked over all pictures by their object's confidence.
    """
    scores: list[float] = []
    hits: list[list[bool]] = [[] for _ in thresholds]
    total = 0
    for truth, answers in cases:
        want = _edges_at_128(truth, objects_of(truth))
        total += len(want)
        ranked = sorted(answers, key=lambda a: -float(a["confidence"]))
        got = _edges_at_128(truth, ranked)
        scores += [float(a["confidence"]) for a in ranked for _ in wireframe(a)[1]]
        for right, threshold in zip(hits, thresholds, strict=True):
            right += _hits(want, got, threshold)
    order = np.argsort(-np.array(scores), kind="stable") if scores else np.zeros(0, np.intp)
    return [_average_precision(np.array(right, bool)[order], total) for right in hits]


def _at_128(truth: Thing, vertices: Sequence[Floats]) -> Floats:
    scale = np.array([128 / truth["width"], 128 / truth["height"]])
    stacked: Floats = np.concatenate([np.zeros((0, 2)), *vertices]) * scale
    return stacked


def _edges_at_128(truth: Thing, things: Sequence[Thing]) -> Floats:
    frames = [wireframe(t) for t in things]
    return np.concatenate([np.zeros((0, 2, 2)), *(_at_128(truth, [v])[e] for v, e in frames)])


def _hits(want: Floats, got: Floats, threshold: float) -> list[bool]:
    taken, out = np.zeros(len(want), bool), []
    for edge in got:
        if not len(want):
            out.append(False)
            continue
        error = np.minimum(((want - edge) ** 2).sum((1, 2)), ((want - edge[::-1]) ** 2).sum((1, 2)))
        best = int(error.argmin())
        out.append(bool(error[best] < threshold and not taken[best]))
        taken[best] |= out[-1]
    return out


def _average_precision(right: np.ndarray[Any, np.dtype[np.bool_]], total: int) -> float:
    """Area under the precision-recall curve, precision made monotone."""
    if not total:
        return float("nan")
    hits = np.cumsum(right)
    recall = np.r_[0, hits / total]
    precision = np.r_[1, hits / np.arange(1, len(right) + 1)]
    envelope = np.maximum.accumulate(precision[::-1])[::-1]
    return float((np.diff(recall) * envelope[1:]).sum())


def true_solid(truth: Thing) -> Floats | None:
    """(2n, 3) vertices of the outer rings of the true solid, or None where the truth holds none."""
    solid = truth.get("solid")
    if not solid:
        return None
    if "f1_xyz" in solid:
        return np.array(solid["f1_xyz"] + solid["f2_xyz"], float)
    front, back = np.array(solid["profile"]), np.array(solid.get("back", solid["profile"]))
    return np.vstack([np.c_[front, np.zeros(len(front))], np.c_[back, np.full(len(back), solid["depth"])]])


def outer_vertices(truth: Thing, answer: Thing, match: Ints) -> Floats:
    """(2n, 3) answered 3-D vertices of the outer rings, in the order of `true_solid`."""
    got = np.array(answer["solid"]["vertices"], float)
    ordered = np.empty_like(got)
    ordered[match] = got
    n, half = len(truth["f1"]), len(got) // 2
    stacked: Floats = np.vstack([ordered[:n], ordered[half : half + n]])
    return stacked


def aligned(points: Floats, target: Floats) -> Floats:
    """The points (k, 3) after the similarity (no mirror) that brings them nearest to the target (k, 3).

    Umeyama 1991.
    """
    p, q = points - points.mean(0), target - target.mean(0)
    u, s, vt = np.linalg.svd(p.T @ q)
    sign = np.array([1.0, 1.0, float(np.sign(np.linalg.det(u @ vt)))])
    scale = float((s * sign).sum() / (p**2).sum())
    moved: Floats = scale * p @ (u * sign) @ vt + target.mean(0)
    return moved


def solid_error(truth: Thing, answer: Thing, match: Ints) -> float:
    """Relative RMS distance of the answered from the true solid after the best similarity; nan without a true solid.

    For oblique drawings and tapered objects only the front face counts: the drawing does not fix the depth. A
    wireframe may be answered with its mirror image in depth, which looks the same.
    """
    want = true_solid(truth)
    if want is None:
        return float("nan")
    got = outer_vertices(truth, answer, match)
    if family(truth) == "oblique" or str(truth.get("category", "")).startswith("taper"):
        n = len(truth["f1"])
        return _relative(got[:n], want[:n])
    return min(_relative(reading, want) for reading in _readings(truth, got))


def nearest_reading(truth: Thing, got: Floats, want: Floats) -> Floats:
    """The answered vertices (k, 3) aligned with the true ones, mirrored in depth if the drawing allows and it helps."""
    best = min(_readings(truth, got), key=lambda reading: _relative(reading, want))
    return aligned(best, want)


def _readings(truth: Thing, got: Floats) -> list[Floats]:
    """The answer, and its mirror image in depth where the drawing shows both alike."""
    alike = "f1_xyz" in truth["solid"] or truth["lines"] == "wire"
    return [got, got * [1, 1, -1]] if alike else [got]


def _relative(got: Floats, want: Floats) -> float:
    off = ((aligned(got, want) - want) ** 2).sum()
    return float(np.sqrt(off / ((want - want.mean(0)) ** 2).sum()))


def solid_limit(truth: Thing) -> float:
    """Largest `solid_error` that counts as right: 5 % for exact drawings, 10 % by hand, 12 % in perspective."""
    if family(truth) == "perspective":
        return 0.12
    return 0.05 if truth.get("medium") in ("clean", "thin", "blueprint", "cad") else 0.10
