"""Exact answers: a vector drawing of ruled lines that one object explains to the last line is read without a search.

Its corners are known, so the hypotheses are few, and one that fits is no better or worse for any tolerance. Whatever
else there is in a drawing (a hand's wobble, arcs, arrows, a second object), the search by rounds looks at it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import islice
from typing import TypeVar

import numpy as np

from sketch2shape.evidence import WITNESSES, Evidence, against_rivals, confidence, exactly_drawn
from sketch2shape.hypotheses import Rings, coincide, ruled_caps, ruled_graph
from sketch2shape.model import Floats, Ink
from sketch2shape.search.attempts import wire_hypotheses
from sketch2shape.strokes import MEET, RuledLines, ruled_lines

MOST_STEPS = 2000
"""Steps of the search for cycles; a drawing that is read at once takes a few dozen."""
MOST_TRIED = 12
"""Hypotheses that are verified: the right one is among the first few."""
IN_THREES = 3
"""Ways that lead from each vertex along edges that are all drawn."""

Some = TypeVar("Some", bound="Verified")


@dataclass(frozen=True)
class Verified:
    """An answer without arcs.

    rings      : in working pixels
    evidence   : how well it agrees with the ink
    noise      : rms distance between model and ink, pixels
    confidence : 0..1, how often such answers are right
    """

    rings: Rings
    evidence: Evidence
    noise: float = 0.0
    confidence: float = 0.0

    @property
    def size(self) -> float:
        """Diagonal of the object's bounding box, pixels."""
        return float(np.linalg.norm(np.ptp(self.rings.vertices, axis=0)))

    def shifted(self: Some, by: Floats) -> Some:
        """The same elsewhere on the sheet."""
        return replace(self, rings=self.rings.shifted(by))


def find_exact(ink: Ink) -> Verified | None:
    """The object that ruled, known lines show exactly, with nothing else on the sheet; None if there is none such."""
    lines = None if ink.lines is None else ruled_lines(ink.lines)
    if lines is None:
        return None
    if (lines.ways >= IN_THREES).all():
        whole = next(_verified(_wires(lines), lines), None)
        if whole is not None:
            return whole
    return None if lines.dashed.any() else _only(list(_verified(ruled_caps(lines), lines)))


def _wires(lines: RuledLines) -> Iterator[Rings]:
    """Pairs of faces that use all corners; dashes tell which is in front."""
    dashed = lines.pieces[lines.dashed].reshape(-1, 1, 2)

    def dashes(rings: Rings) -> int:
        """Ends of dashed lines at the front."""
        gap = np.concatenate(rings.front) - dashed
        return int(np.count_nonzero(gap[..., 0] ** 2 + gap[..., 1] ** 2 <= MEET**2))

    for rings in wire_hypotheses(ruled_graph(lines), range(MOST_STEPS)):
        if len(rings.vertices) >= len(lines.corners):
            yield from sorted((rings, rings.swapped()), key=dashes) if lines.dashed.any() else (rings,)


def _verified(hypotheses: Iterator[Rings], lines: RuledLines) -> Iterator[Verified]:
    for rings in islice(hypotheses, MOST_TRIED):
        told = exactly_drawn(rings, lines.pieces, lines.dashed)
        if told is not None:
            yield Verified(rings, *told, against_rivals(confidence(np.zeros(len(WITNESSES))), 0.0))


def _only(found: list[Verified]) -> Verified | None:
    """The first, if all have the same vertices; else what is hidden is not told by the lines alone."""
    if any(not coincide(found[0].rings.vertices, other.rings.vertices, 2 * MEET) for other in found[1:]):
        return None
    return found[0] if found else None
