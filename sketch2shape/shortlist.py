"""Shortlist: the best few of many hypotheses.

Hypotheses come best first and without end; they are looked at in growing batches, so that a good early one costs little
and many cost little each.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import islice

import numpy as np

from sketch2shape.rings import Rings, stack, which_plausible
from sketch2shape.verify import Evidence, Sheet, judge_stack, most_possible

SHORTLIST = 5
"""Hypotheses of a round that are kept."""
MOST_HYPOTHESES = 160
"""Hypotheses of one source that are looked at."""
PERFECT = 0.995
"""Score that leaves nothing to be found."""
LARGEST_BATCH = 24
"""Hypotheses that are judged together."""
SHALLOWEST = 2.5
"""Length of the longest connecting edge over the reach of a line: less deep, both faces would be the same ink."""
LEAST = 0.5
"""Hypotheses that cannot reach this score are not judged: refinement would not save them."""

Judged = tuple[Rings, Evidence]


def shortlist(hypotheses: Iterable[Rings], sheet: Sheet, known: list[Judged], enough: int = SHORTLIST) -> list[Judged]:
    """The best few of the hypotheses and those already known; enough nearly perfect ones end the search."""
    judged, perfect = list(known), 0
    for fresh in verified(islice(hypotheses, MOST_HYPOTHESES), sheet, 4 * enough):
        judged.append(fresh)
        perfect += fresh[1].score > PERFECT
        if perfect >= enough:
            break
    return sorted(judged, key=lambda j: -j[1].score)[:SHORTLIST]


def verified(hypotheses: Iterable[Rings], sheet: Sheet, first: int = LARGEST_BATCH) -> Iterator[Judged]:
    """Those of the hypotheses that could be an object, judged, in their order.

    first : size of the first batch; each is twice as large as the one before
    """
    source, seen = iter(hypotheses), set[bytes]()
    size = min(first, LARGEST_BATCH)
    while batch := list(islice(source, size)):
        size = min(2 * size, LARGEST_BATCH)
        fresh: list[Rings] = []
        for rings in batch:
            vertices = rings.vertices
            key = np.rint(vertices / 2).tobytes()
            if key not in seen and np.isfinite(vertices).all():
                seen.add(key)
                fresh.append(rings)
        yield from _judged(fresh, sheet)


def _judged(batch: list[Rings], sheet: Sheet) -> list[Judged]:
    found: dict[int, Evidence] = {}
    for sizes in {r.sizes for r in batch}:
        index = [k for k, r in enumerate(batch) if r.sizes == sizes]
        alike = stack([batch[k] for k in index])
        apart = alike.faces[:, 1] - alike.faces[:, 0]
        deep = np.hypot(apart[..., 0], apart[..., 1]).max(axis=1) >= SHALLOWEST * sheet.reach
        ok = np.flatnonzero(which_plausible(alike, 1.5 * sheet.pen) & deep)
        ok = ok[most_possible(alike.some(ok), sheet) >= LEAST]
        found.update(zip([index[k] for k in ok], judge_stack(alike.some(ok), sheet), strict=True))
    return [(batch[k], found[k]) for k in sorted(found)]
