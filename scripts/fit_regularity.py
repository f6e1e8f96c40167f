"""Fit the weights of `sketch2shape.connectors.ring_regularity` to random faces.

    python scripts/fit_regularity.py [--faces N] [--rounds R] [--seed S]

A mixture of conditional logits: among the simple rings through a face's points, each round takes the most probable
ones under the current weights and the true one, and moves the weights of all kinds of face together to make the true
ones most likely. Writes sketch2shape/connectors/weights.py.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize

sys.path.insert(0, str(Path(__file__).parent))
from connector_profiles import PROFILES, VIEWS, faces

from sketch2shape.connectors import auto
from sketch2shape.connectors.graham import convex_hull
from sketch2shape.connectors.polygon import ring_is_simple
from sketch2shape.connectors.ring_regularity import CROSSING, EDGE_CUES, PAIR_CUES, edge_cues, edges_between, pair_cues
from sketch2shape.connectors.ring_search import EXHAUSTIVE, canonical_rows, edge_index, neighbours
from sketch2shape.connectors.whole_ring import RING_CUES, ring_cues

Array = NDArray[np.float64]
NOISE = (0.0, 0.0, 0.6, 1.5)
KEPT = 120
#: profiles without regularity are drawn three times as often: they are few
RANDOM = ("star-shaped", "blob", "simple")


def training_faces(count: int, seed: int) -> list[tuple[str, Array, NDArray[np.intp]]]:
    """(profile, shuffled points, true order)."""
    rng = np.random.default_rng(seed)
    found = []
    while len(found) < count:
        names = (*PROFILES, *RANDOM, *RANDOM)
        for name, _, ring in faces(rng, names, views=(str(rng.choice(VIEWS)),), noise=float(rng.choice(NOISE))):
            if len(ring) < 4 or len(ring) > 16 or not ring_is_simple(ring):
                continue
            shuffled = rng.permutation(len(ring))
            points = np.empty_like(ring)
            points[shuffled] = ring
            found.append((name, points, shuffled))
    return found[:count]


def cue_sums(points: Array, orders: NDArray[np.intp]) -> Array:
    """(k, cues + 2) sums of all cues over rings (k, n), cues of whole rings, then 1 and n."""
    ends, at = edge_index(len(points))
    edges = edges_between(points, ends)
    used = at[orders, np.roll(orders, -1, axis=1)]
    single = edge_cues(edges, convex_hull(points))[used].sum(axis=1)
    every = np.array(pair_cues(edges))
    every[:, np.arange(len(ends)), np.arange(len(ends))] = 0.0
    pairs = every[:, used[:, :, None], used[:, None, :]].sum(axis=(2, 3)).T / 2
    parallel, loosely = (every[PAIR_CUES.index(name)] for name in ("parallel", "parallel_loose"))
    whole = ring_cues(edges, parallel, loosely, at, orders)
    constant = np.tile([1.0, len(points)], (len(orders), 1))
    return np.concatenate((single, pairs, whole, constant), axis=1)


def candidates(points: Array, truth: NDArray[np.intp]) -> NDArray[np.intp]:
    """Rings to tell apart, the true one first."""
    model = auto.build(points)
    orders, energies = auto.rank_improved(points, model)
    true_ring = canonical_rows(truth[None])
    near = canonical_rows(neighbours(model.kinds[0], truth)[0]) if len(points) > EXHAUSTIVE else orders[:0]
    rest = np.unique(np.concatenate((orders[energies < energies[0] + 30][:KEPT], near)), axis=0)
    energies = model.of(rest)
    keep = (energies < CROSSING / 2) & (rest != true_ring).any(axis=1)
    return np.concatenate((true_ring, rest[keep][np.argsort(energies[keep])[:KEPT]]))


def fit(pools: list[Array], importance: Array, start: Array, strength: float) -> Array:
    """Weights (cues + 2, kinds) that make the first row of each pool most likely."""
    every = np.concatenate(pools)
    owner = np.repeat(np.arange(len(pools)), [len(p) for p in pools])
    first = np.cumsum([0] + [len(p) for p in pools[:-1]])

    def loss(flat: Array) -> tuple[float, Array]:
        w = flat.reshape(start.shape)
        energies = every @ w
        least = energies.min(axis=1)
        share = np.exp(least[:, None] - energies)
        score = -least + np.log(share.sum(axis=1))
        share /= share.sum(axis=1, keepdims=True)
        top = np.maximum.reduceat(score, first)
        chance = np.exp(score - top[owner])
        total = np.add.reduceat(chance, first)
        value = float((importance * (np.log(total) + top - score[first])).sum()) + strength * float((w[:-2] ** 2).sum())
        pull = -chance / total[owner] * importance[owner]
        pull[first] += importance
        slope = every.T @ (pull[:, None] * share)
        slope[:-2] += 2 * strength * w[:-2]
        return value, slope.ravel()

    found = minimize(loss, start.ravel(), jac=True, method="L-BFGS-B", options={"maxiter": 400})
    return np.asarray(found.x.reshape(start.shape))


NAMES = (*EDGE_CUES, *PAIR_CUES, *RING_CUES, "face", "vertex")


def weights() -> Array:
    return np.array([[kind[name] for kind in auto.KINDS] for name in NAMES])


def install(w: Array) -> None:
    auto.KINDS = tuple({name: float(v) for name, v in zip(NAMES, column, strict=True)} for column in w.T)


def write(w: Array, path: Path) -> None:
    rows = [
        '"""Weights of the cues of `regularity` for each kind of face, log odds: negative makes a ring more probable.',
        "",
        "Fitted and written by scripts/fit_regularity.py.",
        '"""',
        "",
        "KINDS: tuple[dict[str, float], ...] = (",
    ]
    for column in w.T:
        rows += ["    {", *(f'        "{name}": {v:.3f},' for name, v in zip(NAMES, column, strict=True)), "    },"]
    path.write_text("\n".join([*rows, ")", ""]))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--faces", type=int, default=1500)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--kinds", type=int, default=len(auto.KINDS), help="kinds of face in the mixture")
    args = parser.parse_args()
    while len(auto.KINDS) < args.kinds:  # a new kind starts beside the last one
        rng = np.random.default_rng(len(auto.KINDS))
        auto.KINDS = (*auto.KINDS, {name: w + float(rng.normal(0, 0.3)) for name, w in auto.KINDS[-1].items()})
    data = training_faces(args.faces, args.seed)
    importance = np.ones(len(data))
    known: list[dict[bytes, NDArray[np.intp]]] = [{} for _ in data]
    for round_ in range(args.rounds):
        pools = []
        for (_, points, truth), seen in zip(data, known, strict=True):
            rings = candidates(points, truth)
            seen.update({r.tobytes(): r for r in rings})
            first = rings[0].tobytes()
            pools.append(cue_sums(points, np.array([rings[0]] + [r for k, r in seen.items() if k != first])))
        install(fit(pools, importance, weights(), strength=0.02))
        scores = [auto.mixed((pool @ weights()).T) for pool in pools]
        right = [bool((s[0] < s[1:] - 1e-9).all()) for s in scores]
        for name in RANDOM:
            of_name = [r for r, (profile, _, _) in zip(right, data, strict=True) if profile == name]
            print(f"  {name}: {np.mean(of_name):.3f} of {len(of_name)}")
        print(f"round {round_}: {np.mean(right):.3f} of the true rings are the most probable", flush=True)
    target = Path(__file__).parent.parent / "sketch2shape" / "connect" / "weights.py"
    write(weights(), target)
    print(f"wrote {target.name}")


if __name__ == "__main__":
    main()
