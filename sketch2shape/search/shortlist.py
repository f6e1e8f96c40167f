"""Shortlist: the best few of many hypotheses.

Hypotheses come best first and without end; they are looked at in growing batches, so that a good early one costs little
and many cost little each.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from itertools import chain, islice

import numpy as np

from sketch2shape.evidence import PERFECT, Evidence, Sheet, judge_stack, most_possible
from sketch2shape.hypotheses import Rings, stack, which_plausible

SHORTLIST = 5
"""Hypotheses of a round that are kept."""
ENOUGH = 4
"""Nearly perfect hypotheses that end the search."""
MOST_HYPOTHESES = 160
"""Hypotheses of one source that are looked at."""
FIRST = 4
"""Hypotheses of the first batch for each that is enough."""
FIRST_KNOWN = 2
"""Hypotheses of the first batch where lines are known: corners are in their places, and the best come first."""
PLAIN = 1.0
"""How much connecting edges may differ, as a part of the reach, where the back face is the front face moved."""
LARGEST_BATCH = 24
"""Hypotheses that are judged together."""
SHALLOWEST = 2.5
"""Length of the longest connecting edge over the reach of a line: less deep, both faces would be the same ink."""
VAIN, HOPE = 88, 0.4
"""So many hypotheses are looked at if none of them scores as much: the best come early."""
LEAST = 0.5
"""Score below which a hypothesis is none; such as cannot reach it are not judged: refinement would not save them."""
ALIKE = 1e-3
"""Difference of scores up to which hypotheses explain a drawing alike: of those the one thought of first is kept."""

Judged = tuple[Rings, Evidence]


def shortlist(hypotheses: Iterable[Rings], sheet: Sheet, known: list[Judged], enough: int = ENOUGH) -> list[Judged]:
    """The best few of the hypotheses and those already known; enough nearly perfect ones end the search.

    One is enough if its faces are alike: no other explains a drawing in a plainer way.
    """
    fresh: list[Judged] = []
    perfect = 0
    first = FIRST_KNOWN if sheet.skeleton.is_known else FIRST * enough

    def least() -> float:
        """Score below which no hypothesis would be kept."""
        every = sorted((evidence.score for _, evidence in (*known, *fresh)), reverse=True)
        return max(LEAST, every[SHORTLIST - 1] - ALIKE) if len(every) >= SHORTLIST else LEAST

    for looked_at, batch in _batches(islice(hypotheses, MOST_HYPOTHESES), sheet, first, least):
        fresh += batch
        best = [rings for rings, evidence in batch if evidence.score > PERFECT]
        perfect += len(best)
        if perfect >= enough or any(_is_plain(rings, PLAIN * sheet.reach) for rings in best):
            break
        if looked_at >= VAIN and not any(evidence.score >= HOPE for _, evidence in fresh):
            break
    # of those that explain the drawing alike, the one thought of first
    return sorted([*known, *fresh], key=lambda j: -round(j[1].score, 3))[:SHORTLIST]


def _is_plain(rings: Rings, slack: float) -> bool:
    """Whether the back face is the front face moved, to within slack pixels."""
    way = np.concatenate(rings.back) - np.concatenate(rings.front)
    return bool(np.ptp(way, axis=0).max() <= slack)


def verified(hypotheses: Iterable[Rings], sheet: Sheet) -> Iterator[Judged]:
    """Those of the hypotheses that could be an object, judged, in their order."""
    return chain.from_iterable(batch for _, batch in _batches(hypotheses, sheet, LARGEST_BATCH))


def _batches(
    hypotheses: Iterable[Rings], sheet: Sheet, first: int, least: Callable[[], float] = lambda: LEAST
) -> Iterator[tuple[int, list[Judged]]]:
    """How many hypotheses have been looked at, and those of the last batch that could be an object, judged.

    first : size of the first batch; each is twice as large as the one before
    least : those that cannot reach this score are not judged
    """
    source, seen = iter(hypotheses), set[bytes]()
    size, looked_at = min(first, LARGEST_BATCH), 0
    while batch := list(islice(source, size)):
        looked_at += len(batch)
        size = min(2 * size, LARGEST_BATCH)
        fresh: list[Rings] = []
        for rings in batch:
            vertices = rings.vertices
            key = np.rint(vertices / 2).tobytes()
            if key not in seen and np.isfinite(vertices).all():
                seen.add(key)
                fresh.append(rings)
        yield looked_at, _judged(fresh, sheet, least())


def _judged(batch: list[Rings], sheet: Sheet, least: float) -> list[Judged]:
    found: dict[int, Evidence] = {}
    for sizes in {r.sizes for r in batch}:
        index = [k for k, r in enumerate(batch) if r.sizes == sizes]
        alike = stack([batch[k] for k in index])
        apart = alike.faces[:, 1] - alike.faces[:, 0]
        deep = np.hypot(apart[..., 0], apart[..., 1]).max(axis=1) >= SHALLOWEST * sheet.reach
        ok = np.flatnonzero(which_plausible(alike, 1.5 * sheet.pen) & deep)
        if len(ok):
            ok = ok[most_possible(alike.some(ok), sheet) >= least]
        if len(ok):
            found.update(zip([index[k] for k in ok], judge_stack(alike.some(ok), sheet), strict=True))
    return [(batch[k], found[k]) for k in sorted(found)]
