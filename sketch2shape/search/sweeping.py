"""Sweeping: the search for objects with arcs, and for pyramids and cones.

Outlines and ways to the back face are probed quickly; what explains most of the ink is cut into lines and arcs, held
against the drawing in nats like all other hypotheses, moved to the ink, rid of needless vertices, and given its holes.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterator
from dataclasses import replace
from itertools import chain, islice, repeat

import numpy as np

from sketch2shape.evidence import BESIDE, EVEN_ODDS, is_crowded
from sketch2shape.geometry import are_simple
from sketch2shape.model import TRUSTED
from sketch2shape.search.found_sweep import FoundSweep, cheapest, priced
from sketch2shape.search.observed import Observed
from sketch2shape.search.scene import ALIKE, Scene, are_close
from sketch2shape.search.sweep_improvement import Begun, improved
from sketch2shape.search.sweep_pairs import ENOUGH, Pair, cut, pairs_of, pairs_of_rungs
from sketch2shape.strokes import interpolated
from sketch2shape.sweeps import Loop, Redrawn, Sweep, joined, redraw, round_pairs, turning_points

SIDE = 0.02
"""Part of the ink that one more side of a base has to explain: about what its corner costs in nats."""
MOST_PYRAMIDS, MOST_ROUNDS = 16, 4
"""Pyramids, and round objects in perspective, that are priced."""
SLIGHT = 0.03
"""Part of the ink up to which nothing is left to explain."""
CLOSE = 40.0
"""Nats by which a sweep not yet improved may be worse than the best one where that explains all."""
MOST_IMPROVED = 3
"""Sweeps that are moved to the ink, the best of those that were begun."""
MOST_GAINED = 150.0
"""Nats that a sweep gains at most by being moved to the ink; some 120 were seen where its holes were known."""
VAIN = 0.45
"""Part of the ink that a sweep leaves which is not yet improved, and whose holes are not known, at most: of 263 right
answers one left 0.41, all others 0.33 at most."""
SIDE_DRAWN = 0.5
"""Part of the sides that are seen of round faces, apart from their rims, that has ink at least."""
MISSED = 100.0
"""Nats of missing lines from which on an outline that explains nearly all may have been cut in a wrong way."""
APART = 1.5
"""Pens from the nearest solid line beyond which a line is none."""
LEAST_BEHIND = 0.08
"""Length of what is seen behind a near front face, over that of its outline, at least."""


def find_sweep(seen: Observed, *, arcs: bool = True, below: float = np.inf) -> FoundSweep | None:
    """The best sweep for the ink of one object, or None.

    arcs  : whether some lines bow; else only wireframes with holes, and pyramids, are looked for
    below : nats of the best straight object: what cannot come below is not looked at closely
    """
    scene = Scene(seen.drawn, seen.skeleton, seen.view)
    some: list[Begun] = []
    done: dict[FoundSweep, FoundSweep] = {}
    for begun, enough in zip(_batches(scene, arcs=arcs), chain((TRUSTED,), repeat(EVEN_ODDS)), strict=False):
        deep = [b for b in begun if _shows_depth(b.found, scene)]
        some = _unlike(sorted([*some, *deep], key=lambda b: b.found.nats), scene.size)
        hopeful = [b for b in some[:MOST_IMPROVED] if b.found.nats < below + MOST_GAINED and not _is_vain(b.found)]
        _improve(hopeful, done, scene, enough)
        if any(_stands(f, enough) for f in done.values()):
            break
    return _best(done, some, scene)


def _best(done: dict[FoundSweep, FoundSweep], some: list[Begun], scene: Scene) -> FoundSweep | None:
    """The cheapest of those that were improved, held against those that were begun."""
    found = [f for f in done.values() if _shows_depth(f, scene) and _is_possible(f, scene)]
    if not found:
        return None
    best = cheapest(found)
    rivals = [f.under(best.hand) for f in (*found, *(b.found for b in some)) if not _is_same(f, best, scene.size)]
    return _dashed(best, scene).against(min(rivals, default=np.inf) - best.nats)


def _is_possible(found: FoundSweep, scene: Scene) -> bool:
    """Whether no outline crosses itself, it would not explain any ink, and the sides of round faces are drawn."""
    drawn = redraw(found.sweep, scene.size / 100, scene.margin)
    if all(ring.circle is not None for ring in found.sweep.rings) and not _has_sides(found.sweep, drawn, scene):
        return False
    span = drawn.length[:, None] * drawn.along
    crowded = is_crowded(drawn.points - 0.5 * span, span, found.noise)
    return not crowded and all(are_simple(ring.line) for ring in found.sweep.rings)


def _has_sides(sweep: Sweep, drawn: Redrawn, scene: Scene) -> bool:
    """Whether most of its outer silhouettes lies near ink, apart from the rims: ellipses alone are flat."""
    from scipy.spatial import cKDTree  # slow to load, and not needed for straight drawings

    outer = sweep.rings[0]
    side = drawn.edge - (int(drawn.edge.max()) + 1 - len(drawn.silhouettes))
    of_outer = (side >= 0) & (side < len(turning_points(outer, sweep.way.of(outer.line))))
    sides = drawn.points[of_outer & (drawn.depth < 2)]
    if not len(sides):
        return True
    apart = sides[cKDTree(drawn.points[side < 0]).query(sides)[0] > scene.reach]
    return not len(apart) or float((interpolated(scene.skeleton.distance, apart) <= scene.reach).mean()) > SIDE_DRAWN


def find_pyramid(seen: Observed, below: float) -> FoundSweep | None:
    """The best pyramid or cone with straight lines for the ink of one object, or None.

    below : nats of the best other object: what cannot come below is not looked at closely
    """
    scene = Scene(seen.drawn, seen.skeleton, seen.view)
    some: list[Begun] = [Begun(priced(scene, s)) for s in _likely_pyramids(scene)]
    some.sort(key=lambda b: b.found.nats)
    done: dict[FoundSweep, FoundSweep] = {}
    _improve([b for b in some[:MOST_IMPROVED] if b.found.nats < below], done, scene, TRUSTED)
    return _best(done, some, scene)


def _batches(scene: Scene, *, arcs: bool) -> Iterator[list[Begun]]:
    """Sweeps to start from, the likeliest sources first."""
    batches = pairs_of(scene, bowed=arcs)
    for pairs in islice(batches, 1):
        yield _begun(pairs, scene, arcs=arcs)
    put = joined(scene.skeleton, scene.joints, scene.wire_shifts, scene.size)
    together: list[Begun] = [Begun(priced(scene, s)) for s in put if arcs or s.has_arcs]
    together += [Begun(priced(scene, s)) for s in (_likely_rounds(scene) if arcs else ())]
    covered = _begun(pairs_of_rungs(scene), scene, arcs=True)
    yield [*together, *(b for b in covered if arcs or b.found.sweep.has_arcs)]
    for pairs in batches:
        yield _begun(pairs, scene, arcs=arcs)
    yield [Begun(priced(scene, s)) for s in _likely_pyramids(scene)]


def _begun(pairs: list[Pair], scene: Scene, *, arcs: bool) -> list[Begun]:
    """Pairs with their outlines cut; without arcs those with holes alone."""
    return [b for pair in pairs if arcs or pair.holes for b in _outlined(pair, scene)]


def _outlined(pair: Pair, scene: Scene) -> list[Begun]:
    """The first way to cut its outline; of an ellipse the first two, and all where a likely pair lacks lines so."""
    cuts = cut(pair, scene)
    first = [priced(scene, s) for s in islice(cuts, 1)]
    if first and first[0].sweep.rings[0].circle is not None:
        first += [priced(scene, s) for s in islice(cuts, 1)]
    elif first and first[0].energy.missing > MISSED and (pair.value or 0.0) > ENOUGH:
        first += [priced(scene, s) for s in cuts]
    return [Begun(f, cuts, cut(pair, scene, leaning=True)) for f in first]


def _improve(begun: list[Begun], done: dict[FoundSweep, FoundSweep], scene: Scene, enough: float) -> None:
    """Improve the best, and others if they are nearly as good or none stands."""
    for one in begun:
        found = one.found
        stands = any(_stands(f, enough) for f in done.values())
        if found not in done and (not stands or found.nats < min(f.nats for f in done) + CLOSE):
            done[found] = improved(one, scene)


def _is_vain(found: FoundSweep) -> bool:
    """Whether it leaves so much ink that no closer fit would make it an answer."""
    return found.unexplained > VAIN


def _stands(found: FoundSweep, enough: float) -> bool:
    """Whether it explains all ink, with enough confidence unless another explains it too."""
    return found.unexplained <= SLIGHT and found.against(np.inf).confidence >= enough


def _likely_pyramids(scene: Scene) -> list[Sweep]:
    """The pyramids whose edges explain most of the ink at a glance: in a busy drawing there are thousands."""
    distinct = {_places(p, ALIKE * scene.size): p for p in scene.pyramids}

    def worth(pyramid: Sweep) -> float:
        return scene.cells.value_of_lines(pyramid.edges) - SIDE * len(pyramid.rings[0].vertices)

    return sorted(distinct.values(), key=worth, reverse=True)[:MOST_PYRAMIDS]


def _likely_rounds(scene: Scene) -> list[Sweep]:
    """The round objects in perspective that explain most of the ink at a glance."""
    loops = {s: Loop(s.rings[0].line) for s in round_pairs(scene.rounds)}

    def worth(s: Sweep) -> float:
        return max(scene.cells.value_of_wire([loops[s]], s.way), scene.cells.value(loops[s], s.way))

    return sorted(loops, key=worth, reverse=True)[:MOST_ROUNDS]


def _places(pyramid: Sweep, near: float) -> Hashable:
    """Which face is near, and where apex and corners lie, in squares with sides of so many pixels."""
    base = pyramid.rings[0].vertices
    apex, *corners = np.rint(np.concatenate([base[:1] + pyramid.way.of(base[:1]), base]) / near).tolist()
    return pyramid.is_near, tuple(apex), frozenset(map(tuple, corners))


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


def _unlike(found: list[Begun], size: float) -> list[Begun]:
    """The best of each object."""
    kept: list[Begun] = []
    for one in found:
        if not any(_is_same(one.found, k.found, size) for k in kept):
            kept.append(one)
    return kept


def _is_same(a: FoundSweep, b: FoundSweep, size: float) -> bool:
    """Whether both are the same faces, cut in other ways or the one seen from the other side."""
    ends = [(s.rings[0].line, s.rings[0].line + s.way.of(s.rings[0].line)) for s in (a.sweep, b.sweep)]
    near = ALIKE * size
    (p, q), (r, s) = ends
    return (are_close(p, r, near) and are_close(q, s, near)) or (are_close(p, s, near) and are_close(q, r, near))
