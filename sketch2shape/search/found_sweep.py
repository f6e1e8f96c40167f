"""A sweep held against a drawing, in the same nats as all other hypotheses, and moved to its ink."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from sketch2shape.evidence import (
    SWEEP_WITNESSES,
    Comparison,
    Energy,
    compare_sweep,
    sweep_confidence,
    sweep_witnesses,
    unexplained_part,
)
from sketch2shape.fit import polished
from sketch2shape.model import Floats
from sketch2shape.search.scene import Scene
from sketch2shape.search.sweep_pairs import is_flat
from sketch2shape.sweeps import Outline, Sweep

NOISE_OF_MEDIAN = 1.5
"""Standard deviation over the median distance, of a normal distribution."""
LEANS, PLUMB = 6.0, 0.03
"""Nats for a point that is not above the middle of its base, and radians by which one that is may be drawn off."""
NEARLY_SMOOTH, PLAINLY = 0.5, 12.0
"""Angle, radians, up to which an arc may run on smoothly for a hand that left out the line between the faces there, and
nats that this has to save."""


@dataclass(frozen=True, eq=False)
class FoundSweep:
    """A sweep held against a drawing.

    sweep    : in the working pixels of its group
    compared : with the drawing
    energy   : nats
    gap      : nats to the best that is another object
    witnesses : what speaks for and against it
    confidence: 0..1, how often such answers are right
    """

    sweep: Sweep
    compared: Comparison
    energy: Energy
    gap: float = np.inf
    witnesses: Floats | None = None
    confidence: float = 0.0

    @property
    def size(self) -> float:
        """Diagonal of the object's bounding box, pixels."""
        line = self.sweep.rings[0].line
        return float(np.hypot(*np.ptp(np.concatenate([line, line + self.sweep.way.of(line)]), axis=0)))

    @property
    def nats(self) -> float:
        """What the object and the drawing cost, and how it stands."""
        return self.energy.total + _leaning(self.sweep)

    @property
    def unexplained(self) -> float:
        """Part of the ink that lies on none of its lines, 0..1."""
        return unexplained_part(self.energy, self.compared)

    @property
    def is_lone(self) -> bool:
        """Whether few of its lines have ink: a flat figure may look the same."""
        return self.witnesses is not None and bool(self.witnesses[SWEEP_WITNESSES.index("lone")])

    @property
    def noise(self) -> float:
        """How far lines stray, pixels."""
        return self.energy.noise

    @property
    def hand(self) -> float:
        """Noise of the hand that drew, pixels, if these are its lines."""
        return _hand(self.compared)

    def under(self, hand: float) -> float:
        """Nats if the hand had this noise, pixels."""
        return self.compared.energy(hand).total + _leaning(self.sweep)

    def shifted(self, by: Floats) -> FoundSweep:
        """The same elsewhere on the sheet."""
        return replace(self, sweep=self.sweep.shifted(by))

    def against(self, gap: float) -> FoundSweep:
        """With a rival so many nats away, and the confidence that follows."""
        gap = min(gap, self.gap)
        told = sweep_witnesses(self.sweep, self.energy, self.compared, gap, _leaning(self.sweep))
        return replace(self, gap=gap, witnesses=told, confidence=sweep_confidence(told))


def priced(scene: Scene, sweep: Sweep) -> FoundSweep:
    """A sweep held against the drawing, with lines at smooth joints, or more of these, if that is cheaper."""
    best = min((_compared(scene, way) for way in _manners(sweep)), key=lambda f: f.nats)
    rings = tuple(_smoothed(ring) for ring in sweep.rings)
    if best.energy.missing < PLAINLY or all(r is ring for r, ring in zip(rings, sweep.rings, strict=True)):
        return best
    smooth = _compared(scene, replace(sweep, rings=rings, tangents=False))
    return smooth if smooth.nats < best.nats - PLAINLY else best


def _compared(scene: Scene, sweep: Sweep) -> FoundSweep:
    compared = compare_sweep(sweep, scene.view, scene.margin, scene.solid)
    return FoundSweep(sweep, compared, compared.energy(_hand(compared)))


def _smoothed(ring: Outline) -> Outline:
    """The ring without corners where an arc turns but a little: a hand's lines seldom run on exactly."""
    if not len(ring.vertices):
        return ring
    more = (ring.turns < NEARLY_SMOOTH) & (ring.curved | np.roll(ring.curved, 1)) & ~ring.smooth
    return replace(ring, smooth=ring.smooth | more) if more.any() else ring


def cheapest(found: Sequence[FoundSweep]) -> FoundSweep:
    """The one that tells the drawing most briefly, all under the hand of the closest: a careless fit excuses itself."""
    hand = min(f.hand for f in found)
    return min(found, key=lambda f: f.under(hand))


def _manners(sweep: Sweep) -> list[Sweep]:
    """Without lines at smooth joints, and with them if there are any."""
    if not any(ring.smooth.any() for ring in sweep.rings):
        return [sweep]
    return [replace(sweep, tangents=drawn) for drawn in (False, True)]


def _hand(compared: Comparison) -> float:
    """Noise of the hand that drew, pixels, by the median distance of ink from a line: letters lie apart."""
    distance, _ = compared.every
    return NOISE_OF_MEDIAN * float(np.median(distance))


def _leaning(sweep: Sweep) -> float:
    """Nats for a pyramid or a cone that does not stand plumb on its base, and for a rare number of sides."""
    if sweep.way.centre is None or not sweep.way.is_pointed:
        return 0.0
    x, y = sweep.way.centre - sweep.rings[0].middle
    rare = sweep.regular or 0.0
    if y > 0:
        return LEANS + rare
    return rare + float(min(0.5 * (np.arctan2(abs(x), -y) / PLUMB) ** 2, LEANS))


def moved(found: FoundSweep, scene: Scene) -> FoundSweep:
    """Moved to the ink, if it is cheaper there."""
    there = polished(found.sweep, scene.tree, scene.reach)
    if there.has_arcs and is_flat(there.way, there.rings[0].line, scene):
        return found
    return cheapest((found, priced(scene, there)))
