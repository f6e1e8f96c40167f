"""Sweeping: the search for objects with arcs, and for pyramids and cones.

Outlines and ways to the back face are probed quickly; what explains most of the ink is cut into lines and arcs, held
against the drawing in nats like all other hypotheses, moved to the ink, rid of needless vertices, and given its holes.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import chain, islice
from typing import TypeAlias

import cv2
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
from sketch2shape.geometry import cross
from sketch2shape.model import Floats
from sketch2shape.search.search import Observed
from sketch2shape.search.sweep_pairs import ALIKE, WITHIN, Pair, Scene, are_close, cut, evenly, is_flat, pairs_of
from sketch2shape.sweeps import (
    Outline,
    Sweep,
    coherent_loops,
    cut_ring,
    in_one_frame,
    redraw,
    rounded,
)

NOISE_OF_MEDIAN = 1.5
"""Standard deviation over the median distance, of a normal distribution."""
SIDE = 0.02
"""Part of the ink that one more side of a base has to explain: about what its corner costs in nats."""
MOST_PYRAMIDS = 16
"""Pyramids that are priced."""
SLIGHT = 0.03
"""Part of the ink up to which nothing is left to explain."""
CLOSE = 40.0
"""Nats by which a sweep not yet improved may be worse than the best one where that explains all."""
HOPEFUL, HOPEFUL_NOTCH = 12.0, 60.0
"""Nats that may be gained where a simpler object is moved to the ink, and one without a notch, whose ends lie apart."""
MOST_IMPROVED = 3
"""Sweeps that are moved to the ink, the best of those that were begun."""
MOST_GAINED = 150.0
"""Nats that a sweep gains at most by being moved to the ink; some 120 were seen where its holes were known."""
APART = 1.5
"""Pens from the nearest solid line beyond which a line is none."""
LEANS, PLUMB = 6.0, 0.03
"""Nats for a point that is not above the middle of its base, and radians by which one that is may be drawn off."""
LEAST_BEHIND, BESIDE = 0.08, 0.02
"""Length of what is seen behind a near front face, over that of its outline, at least; and fraction of the drawing's
size within which it is beside that outline."""
LEAST_NEAR, NEAR_PENS = 3.0, 0.5
"""Pixels, and pens, within which a hole's ink lies on ink when it is moved to the back face."""
SHORT, MOST_OF_A_NOTCH = 0.06, 3
"""Length over the drawing's size of edges that may be a notch, and how many there are at most."""
FLAT = 0.12
"""Bulge of an arc up to which it may be a bent line."""
BEND = 0.5
"""Angle, radians, up to which a vertex may be none."""


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

    def shifted(self, by: Floats) -> FoundSweep:
        """The same elsewhere on the sheet."""
        return replace(self, sweep=self.sweep.shifted(by))

    def against(self, gap: float) -> FoundSweep:
        """With a rival so many nats away, and the confidence that follows."""
        gap = min(gap, self.gap)
        told = sweep_witnesses(self.sweep, self.energy, self.compared, gap, _leaning(self.sweep))
        return replace(self, gap=gap, witnesses=told, confidence=sweep_confidence(told))


def priced(scene: Scene, sweep: Sweep) -> FoundSweep:
    """A sweep held against the drawing, with lines at smooth joints if that is cheaper."""
    ways = [sweep]
    if any(ring.smooth.any() for ring in sweep.rings):
        ways = [replace(sweep, tangents=drawn) for drawn in (False, True)]
    every = [compare_sweep(way, scene.view, scene.margin, scene.solid) for way in ways]
    found = [FoundSweep(way, c, c.energy(_hand(c))) for way, c in zip(ways, every, strict=True)]
    return min(found, key=lambda f: f.nats)


def _hand(compared: Comparison) -> float:
    """Noise of the hand that drew, pixels, by the median distance of ink from a line: letters lie apart."""
    distance, _ = compared.every
    return NOISE_OF_MEDIAN * float(np.median(distance))


def find_sweep(seen: Observed, *, arcs: bool = True, below: float = np.inf) -> FoundSweep | None:
    """The best sweep for the ink of one object, or None.

    arcs  : whether some lines bow; else only wireframes with holes, and pyramids, are looked for
    below : nats of the best straight object: what cannot come below is not looked at closely
    """
    scene = Scene(seen.drawn, seen.skeleton, seen.view)
    some: list[_Begun] = []
    improved: dict[FoundSweep, FoundSweep] = {}
    for begun in _batches(scene, arcs=arcs):
        deep = [b for b in begun if _shows_depth(b[0], scene)]
        some = _unlike(sorted([*some, *deep], key=lambda b: b[0].nats), scene.size)
        hopeful = [b for b in some[:MOST_IMPROVED] if b[0].nats < below + MOST_GAINED]
        _improve(hopeful, improved, scene)
        if any(f.unexplained <= SLIGHT for f in improved.values()):
            break
    found = sorted((f for f in improved.values() if _shows_depth(f, scene)), key=lambda f: f.nats)
    if not found:
        return None
    best = found[0]
    rivals = [f.nats for f in (*found[1:], *(f for f, _ in some)) if not _is_same(f, best, scene.size)]
    return _dashed(best, scene).against(min(rivals, default=np.inf) - best.nats)


def _batches(scene: Scene, *, arcs: bool) -> Iterator[list[_Begun]]:
    """Sweeps to start from, the likeliest sources first."""
    for pairs in pairs_of(scene, bowed=arcs):
        yield [b for pair in pairs if arcs or pair.holes for b in _outlined(pair, scene)]
    yield [(priced(scene, s), iter(())) for s in _likely_pyramids(scene)]


def _outlined(pair: Pair, scene: Scene) -> list[_Begun]:
    """The first way to cut its outline, of an ellipse the first two."""
    cuts = cut(pair, scene)
    first = [priced(scene, s) for s in islice(cuts, 1)]
    if first and first[0].sweep.rings[0].circle is not None:
        first += [priced(scene, s) for s in islice(cuts, 1)]
    return [(f, cuts) for f in first]


def _improve(begun: list[_Begun], improved: dict[FoundSweep, FoundSweep], scene: Scene) -> None:
    """Improve the best, and others if they are nearly as good or too much is left unexplained."""
    for found, rest in begun:
        explained = any(f.unexplained <= SLIGHT for f in improved.values())
        if found not in improved and (not explained or found.nats < min(f.nats for f in improved) + CLOSE):
            improved[found] = _improved(found, rest, scene)


def _likely_pyramids(scene: Scene) -> list[Sweep]:
    """The pyramids whose edges explain most of the ink at a glance: in a busy drawing there are thousands."""
    distinct = {_places(p, ALIKE * scene.size): p for p in scene.pyramids}

    def worth(pyramid: Sweep) -> float:
        return scene.cells.value_of_lines(pyramid.edges) - SIDE * len(pyramid.rings[0].vertices)

    return sorted(distinct.values(), key=worth, reverse=True)[:MOST_PYRAMIDS]


def _places(pyramid: Sweep, near: float) -> Hashable:
    """Which face is near, and where apex and corners lie, in squares with sides of so many pixels."""
    base = pyramid.rings[0].vertices
    apex, *corners = np.rint(np.concatenate([base[:1] + pyramid.way.of(base[:1]), base]) / near).tolist()
    return pyramid.is_near, tuple(apex), frozenset(map(tuple, corners))


def _leaning(sweep: Sweep) -> float:
    """Nats for a pyramid or a cone that does not stand plumb on its base, and for a rare number of sides."""
    if sweep.way.centre is None or not sweep.way.is_pointed:
        return 0.0
    x, y = sweep.way.centre - sweep.rings[0].middle
    rare = sweep.regular or 0.0
    if y > 0:
        return LEANS + rare
    return rare + float(min(0.5 * (np.arctan2(abs(x), -y) / PLUMB) ** 2, LEANS))


def _shows_depth(found: FoundSweep, scene: Scene) -> bool:
    """Whether enough is to be seen of it beside its front face."""
    from scipy.spatial import cKDTree  # slow to load, and not needed for straight drawings

    if not found.sweep.is_near:
        return True
    front = sum(len(ring.line) for ring in found.sweep.rings)
    drawn = redraw(found.sweep, scene.size / 100, scene.margin)
    behind = np.arange(len(drawn.points)) >= front
    seen = np.flatnonzero(behind & (drawn.depth == 0))
    if not len(seen):
        return False
    apart = cKDTree(drawn.points[:front]).query(drawn.points[seen])[0] > BESIDE * scene.size
    return float(drawn.length[seen[apart]].sum()) > LEAST_BEHIND * float(drawn.length[:front].sum())


def _dashed(found: FoundSweep, scene: Scene) -> FoundSweep:
    """With hidden lines told as dashed if most of them lie on no solid line."""
    if scene.solid is None or found.energy.lines != "wire":
        return found
    drawn = redraw(found.sweep, scene.size / 100, scene.margin)
    hidden = drawn.depth == 2
    x, y = np.rint(drawn.points[hidden]).astype(np.intp).T
    h, w = scene.solid.shape
    apart = scene.solid[np.clip(y, 0, h - 1), np.clip(x, 0, w - 1)] > APART * scene.skeleton.pen_width
    if not len(apart) or np.average(apart, weights=drawn.length[hidden]) < 0.5:
        return found
    return replace(found, energy=found.energy._replace(lines="dashed"))


_Begun: TypeAlias = tuple[FoundSweep, Iterator[Sweep]]
"""A sweep, and other ways to cut its outline."""


def _unlike(found: list[_Begun], size: float) -> list[_Begun]:
    """The best of each object."""
    kept: list[_Begun] = []
    for f, rest in found:
        if not any(_is_same(f, k, size) for k, _ in kept):
            kept.append((f, rest))
    return kept


def _is_same(a: FoundSweep, b: FoundSweep, size: float) -> bool:
    """Whether both are the same faces, cut in other ways or the one seen from the other side."""
    ends = [(s.rings[0].line, s.rings[0].line + s.way.of(s.rings[0].line)) for s in (a.sweep, b.sweep)]
    near = ALIKE * size
    (p, q), (r, s) = ends
    return (are_close(p, r, near) and are_close(q, s, near)) or (are_close(p, s, near) and are_close(q, r, near))


def _improved(found: FoundSweep, others: Iterator[Sweep], scene: Scene) -> FoundSweep:
    """The best cut moved to the ink, with its holes and without needless vertices."""
    found = min((_moved(f, scene) for f in (found, *(priced(scene, s) for s in others))), key=lambda f: f.nats)
    return finished(with_holes(found, scene, _closed_lines(found.sweep, scene)), scene)


def finished(found: FoundSweep, scene: Scene) -> FoundSweep:
    """In perspective, without needless vertices, and seen from the other side, if that is cheaper."""
    found = _in_perspective(found, scene)
    found = _simpler(found, scene)
    if found.sweep.way.centre is None:
        other = priced(scene, found.sweep.reversed())
        found = min(found, other, key=lambda f: f.nats)
    return found


def _moved(found: FoundSweep, scene: Scene) -> FoundSweep:
    """Moved to the ink, if it is cheaper there."""
    moved = polished(found.sweep, scene.tree, scene.reach)
    if moved.has_arcs and is_flat(moved.way, moved.rings[0].line, scene):
        return found
    return min(found, priced(scene, moved), key=lambda f: f.nats)


def _in_perspective(found: FoundSweep, scene: Scene) -> FoundSweep:
    """With a shift that grows over the face, if that explains more than it costs."""
    way = found.sweep.way
    if way.centre is not None:
        return found
    sloped = replace(way, slope=np.zeros(2), origin=found.sweep.rings[0].middle)
    begun = replace(found, sweep=replace(found.sweep, way=sloped))
    moved = _moved(begun, scene)
    return found if moved is begun else moved


def with_holes(found: FoundSweep, scene: Scene, loops: Iterable[Floats], within: float = WITHIN) -> FoundSweep:
    """With those closed lines inside the outer ring, by so many pixels, as holes that make it cheaper to tell."""
    if found.sweep.way.is_pointed:
        return found
    for loop in _inner(loops, found.sweep, within):
        rings = found.sweep.rings
        if any(are_close(loop, ring.line, ALIKE * scene.size) for ring in rings):
            continue
        for hole in _cut_holes(loop, found.sweep, scene.skeleton.pen_width):
            holed = priced(scene, replace(found.sweep, rings=in_one_frame((*rings, hole))))
            if holed.nats < found.nats + HOPEFUL:
                found = min(found, _moved(holed, scene), key=lambda f: f.nats)
    return found


def _cut_holes(loop: Floats, sweep: Sweep, pen: float) -> Iterator[Outline]:
    """What hole a closed line may be: cut into lines and arcs, and a circle of the frame that other arcs tell."""
    frame = sweep.frame
    if not sweep.has_arcs:
        axis = sweep.way.shift if sweep.way.centre is None else sweep.way.of(loop).mean(axis=0)
        yield next(cut_ring(evenly(loop), axis / (np.hypot(*axis) + 1e-9), pen)).outline
        return
    told = next(cut_ring(evenly(loop), frame.along, pen, (frame.ratio,))).outline
    yield told
    if told.circle is None:
        yield rounded(evenly(loop), frame)


def _closed_lines(sweep: Sweep, scene: Scene) -> list[Floats]:
    """Closed lines of the drawing, the largest first."""
    loops = [loop.line for loop in scene.loops]
    if sweep.way.centre is None:
        reach = max(LEAST_NEAR, NEAR_PENS * scene.skeleton.pen_width)
        loops = [*coherent_loops(scene.skeleton, sweep.way.shift, reach, scene.size)[1:], *loops]
    return loops


def _inner(loops: Iterable[Floats], sweep: Sweep, within: float) -> Iterator[Floats]:
    """Those inside the outer ring of the front face."""
    outer = sweep.rings[0].line.astype(np.float32)
    for loop in loops:
        some = loop[:: max(1, len(loop) // 24)]
        if min(cv2.pointPolygonTest(outer, (float(x), float(y)), True) for x, y in some) > within:
            yield loop


def _simpler(found: FoundSweep, scene: Scene) -> FoundSweep:
    """Without vertices that cost more than the ink they explain."""
    while (simpler := next(_cheaper(found, scene), None)) is not None:
        found = simpler
    return found


def _cheaper(found: FoundSweep, scene: Scene) -> Iterator[FoundSweep]:
    """The same with fewer vertices or arcs, if that is cheaper."""
    short = SHORT * scene.size
    for k, ring in enumerate(found.sweep.rings):
        less = ((other, HOPEFUL) for other in _with_one_less(ring))
        without = ((other, HOPEFUL_NOTCH) for other in _without_notches(ring, short))
        for other, hopeful in chain(less, without):
            rings = tuple(other if m == k else r for m, r in enumerate(found.sweep.rings))
            way = priced(scene, replace(found.sweep, rings=rings))
            if way.nats < found.nats + hopeful:
                way = _moved(way, scene)
            if way.nats < found.nats:
                yield way


def _without_notches(ring: Outline, short: float) -> Iterator[Outline]:
    """The ring with some edges of at most so many pixels in all drawn together to a vertex, a smooth one or a corner.

    Where lines cross at a small angle, an outline that is followed has notches.
    """
    v, n = ring.vertices, len(ring.vertices)
    own = np.arange(n)
    for m in range(1, min(MOST_OF_A_NOTCH, n - 3) + 1):
        last = (own + m) % n
        run = sum(np.hypot(*(v[(own + k + 1) % n] - v[(own + k) % n]).T) for k in range(m))
        for i in np.flatnonzero(run <= short):
            keep = np.ones(n, np.bool_)
            keep[(i + 1 + np.arange(m)) % n] = False
            vertices, bulges = v.copy(), ring.bulges.copy()
            vertices[i], bulges[i] = 0.5 * (v[i] + v[last[i]]), bulges[last[i]]
            for is_smooth in (True, False):
                smooth = ring.smooth.copy()
                smooth[i] = is_smooth
                yield Outline(ring.frame, vertices[keep], bulges[keep], smooth[keep])


def _with_one_less(ring: Outline) -> Iterator[Outline]:
    """The ring without one of the vertices at which it hardly turns, or with a flat arc made straight."""
    n = len(ring.vertices)
    if n < 3:
        return
    flat = ring.frame.flat(ring.vertices)
    for i in np.argsort(ring.turns):
        if ring.turns[i] > BEND or (n == 3 and not ring.curved.any()):
            break
        a, v, c = flat[i - 1], flat[i], flat[(i + 1) % n]
        u, w = a - v, c - v
        inner = float(np.arctan2(abs(cross(u, w)), u @ w))
        bulge = -float(np.sign(cross(c - a, v - a))) * float(np.tan(0.5 * (np.pi - inner)))
        bends = ring.curved[i - 1] or ring.curved[i]
        bulges = ring.bulges.copy()
        bulges[i - 1] = -bulge if bends else 0.0
        keep = np.arange(n) != i
        yield Outline(ring.frame, ring.vertices[keep], bulges[keep], ring.smooth[keep])
    for i in np.flatnonzero(ring.curved & (np.abs(ring.bulges) < FLAT)):
        bulges = ring.bulges.copy()
        bulges[i] = 0.0
        yield replace(ring, bulges=bulges)
