"""Fit the weights of `sketch2shape.connect.regularity` to random faces.

    python scripts/fit_regularity.py [--faces N] [--rounds R] [--seed S]

Conditional logit: among the simple rings through a face's points, each round takes the most probable ones under
the current weights and the true one, and moves the weights to make the true ones most likely. Prints the weights to
paste.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize

sys.path.insert(0, str(Path(__file__).parent))
from connector_profiles import VIEWS, faces

from sketch2shape.connect import auto
from sketch2shape.connect.geometry import ring_is_simple
from sketch2shape.connect.graham import convex_hull
from sketch2shape.connect.regularity import CROSSING, EDGE_CUES, PAIR_CUES, edge_cues, edges_between, pair_cues
from sketch2shape.connect.search import canonical_rows, edge_index, neighbours

Array = NDArray[np.float64]
NOISE = (0.0, 0.0, 0.6, 1.5)
KEPT = 120


def training_faces(count: int, seed: int) -> list[tuple[str, Array, NDArray[np.intp]]]:
    """(profile, shuffled points, true order)."""
    rng = np.random.default_rng(seed)
    found = []
    while len(found) < count:
        for name, _, ring in faces(rng, views=(str(rng.choice(VIEWS)),), noise=float(rng.choice(NOISE))):
            if len(ring) < 4 or len(ring) > 16 or not ring_is_simple(ring):
                continue
            shuffled = rng.permutation(len(ring))
            points = np.empty_like(ring)
            points[shuffled] = ring
            found.append((name, points, shuffled))
    return found[:count]


def cue_sums(points: Array, orders: NDArray[np.intp]) -> Array:
    """(k, cues) sums of all cues over rings (k, n)."""
    ends, at = edge_index(len(points))
    edges = edges_between(points, ends)
    used = at[orders, np.roll(orders, -1, axis=1)]
    single = edge_cues(edges, convex_hull(points))[used].sum(axis=1)
    pairs = pair_cues(edges)[:, used[:, :, None], used[:, None, :]].sum(axis=(2, 3)).T / 2
    return np.concatenate((single, pairs), axis=1)


def candidates(points: Array, truth: NDArray[np.intp]) -> NDArray[np.intp]:
    """Rings to tell apart, the true one first."""
    model = auto.build(points)
    orders, energies = auto.rank_improved(points, model)
    true_ring = canonical_rows(truth[None])
    near = canonical_rows(neighbours(truth)) if len(points) > 8 else orders[:0]
    rest = np.unique(np.concatenate((orders[energies < energies[0] + 30][:KEPT], near)), axis=0)
    rest = rest[(model.of(rest) < CROSSING / 2) & (rest != true_ring).any(axis=1)]
    rest = rest[np.argsort(model.of(rest))[:KEPT]]
    return np.concatenate((true_ring, rest))


def fit(pools: list[Array], start: Array, strength: float) -> Array:
    """Weights that make the first row of each pool most likely."""

    def loss(w: Array) -> tuple[float, Array]:
        value, slope = strength * float(w @ w), 2 * strength * w
        for pool in pools:
            score = -(pool @ w)
            score -= score.max()
            chance = np.exp(score)
            chance /= chance.sum()
            value -= float(np.log(max(chance[0], 1e-12)))
            slope = slope + pool[0] - chance @ pool
        return value, slope

    return np.asarray(minimize(loss, start, jac=True, method="L-BFGS-B", options={"maxiter": 300}).x)


def weights() -> Array:
    return np.array([auto.EDGE_WEIGHTS[c] for c in EDGE_CUES] + [auto.PAIR_WEIGHTS[c] for c in PAIR_CUES])


def install(w: Array) -> None:
    auto.EDGE_WEIGHTS.update(zip(EDGE_CUES, w.tolist(), strict=False))
    auto.PAIR_WEIGHTS.update(zip(PAIR_CUES, w[len(EDGE_CUES) :].tolist(), strict=True))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--faces", type=int, default=1500)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--seed", type=int, default=1)
    args = parser.parse_args()
    pools_of: dict[int, dict[bytes, NDArray[np.intp]]] = {}
    data = training_faces(args.faces, args.seed)
    for round_ in range(args.rounds):
        pools = []
        for i, (_, points, truth) in enumerate(data):
            rings = candidates(points, truth)
            known = pools_of.setdefault(i, {})
            known.update({r.tobytes(): r for r in rings})
            first = rings[0].tobytes()
            pools.append(cue_sums(points, np.array([rings[0]] + [r for k, r in known.items() if k != first])))
        new = fit(pools, weights(), strength=0.05)
        right = np.mean([bool(((p @ new)[0] < (p @ new)[1:] - 1e-9).all()) for p in pools])
        install(new)
        print(f"round {round_}: {right:.3f} of the true rings are the most probable", flush=True)
    for name, w in zip((*EDGE_CUES, *PAIR_CUES), weights(), strict=True):
        print(f'    "{name}": {w:.3f},')


if __name__ == "__main__":
    main()
