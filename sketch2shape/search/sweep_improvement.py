"""Improving a sweep: moved to the ink, given its holes, in perspective, and rid of needless vertices."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from itertools import chain
from typing import NamedTuple

import cv2
import numpy as np

from sketch2shape.fit import polished
from sketch2shape.geometry import cross
from sketch2shape.model import Floats
from sketch2shape.search.found_sweep import FoundSweep, cheapest, moved, priced
from sketch2shape.search.scene import ALIKE, Scene, are_close
from sketch2shape.search.small_holes import small_holes
from sketch2shape.search.sweep_pairs import WITHIN, evenly
from sketch2shape.sweeps import Outline, Sweep, Way, coherent_loops, cut_ring, in_one_frame, rounded, rung_ends

HOPEFUL, HOPEFUL_NOTCH = 12.0, 60.0
"""Nats that may be gained where a simpler object is moved to the ink, and one without a notch, whose ends lie apart."""
MUCH, MANY = 0.1, 24
"""Part of the ink that a sweep leaves, and vertices of its outlines, beyond which it is not worth improving."""
LEAST_NEAR, NEAR_PENS = 3.0, 0.5
"""Pixels, and pens, within which a hole's ink lies on ink when it is moved to the back face."""
MOST_MOVES, LEAST_GAIN = 4, 2.0
"""Times that an object is moved to the ink once it has its holes, and nats that are worth one more."""
SHORT, MOST_OF_A_NOTCH = 0.06, 3
"""Length over the drawing's size of edges that may be a notch, and how many there are at most."""
NEAR_RUNG = 3.0
"""How far a vertex may lie from the end of the line between the faces that shows it, over the reach of a line's ink."""
AFAR, LEFT_OVER = 20.0, 10.0
"""Distance of a centre, over the way to the back face, from where it is looked for, and nats of lines that are missing
or left from which on it is."""
FAR_OFF = 2.0
"""How far off the ink of a hole's rims may lie in perspective, over the reach of a line's ink."""
FLAT = 0.12
"""Bulge of an arc up to which it may be a bent line."""
BEND = 0.5
"""Angle, radians, up to which a vertex may be none."""


class Begun(NamedTuple):
    """A sweep to be improved.

    found   : it, priced
    others  : other ways to cut its outline
    leaning : more of them, with arcs as in perspective
    """

    found: FoundSweep
    others: Iterator[Sweep] = iter(())
    leaning: Iterator[Sweep] = iter(())


def improved(begun: Begun, scene: Scene) -> FoundSweep:
    """The best cut moved to the ink, with its holes and without needless vertices."""
    found = cheapest([moved(f, scene) for f in (begun.found, *(priced(scene, s) for s in begun.others))])
    if _leaves_some(found):
        leaning = [_in_perspective(priced(scene, s), scene) for s in begun.leaning]
        best = cheapest([found, *leaning])
        # arcs that are needless in the end were none that lean
        if best is not found and (done := _completed(best, scene)).sweep.has_arcs:
            return done
    return _completed(found, scene)


def _completed(found: FoundSweep, scene: Scene) -> FoundSweep:
    """With its holes and without needless vertices."""
    found = _at_rungs(found, scene)
    if found.sweep.way.centre is not None:
        found = _in_perspective(found, scene)
    if found.unexplained > MUCH and sum(len(ring.vertices) for ring in found.sweep.rings) > MANY:
        return found  # hatching, a scribble: so many vertices that explain so little are none
    return finished(with_holes(found, scene, [*small_holes(found, scene), *_closed_lines(found.sweep, scene)]), scene)


def _at_rungs(found: FoundSweep, scene: Scene) -> FoundSweep:
    """With vertices of a wireframe where lines between the faces end near them, if that is cheaper.

    A line and an arc that run into each other do so anywhere, as far as they themselves tell.
    """
    way = found.sweep.way
    if found.energy.lines == "removed" or way.centre is not None or not len(scene.joints):
        return found
    ends = rung_ends(scene.skeleton, scene.joints, way.shift, scene.size)
    if not len(ends):
        return found
    put = replace(found.sweep, rings=tuple(_put_at(ring, ends, NEAR_RUNG * scene.reach) for ring in found.sweep.rings))
    return cheapest((found, moved(priced(scene, put), scene)))


def _put_at(ring: Outline, places: Floats, near: float) -> Outline:
    """The ring with its vertices at the nearest of some places (k, 2), where that is so many pixels away at most."""
    if ring.circle is not None:
        return ring
    apart = np.hypot(*(ring.vertices[:, None] - places).transpose(2, 0, 1))
    nearest = apart.argmin(axis=1)
    own = (apart.min(axis=1) < near) & (apart[:, nearest].argmin(axis=0) == np.arange(len(ring.vertices)))
    return replace(ring, vertices=np.where(own[:, None], places[nearest], ring.vertices))


def finished(found: FoundSweep, scene: Scene) -> FoundSweep:
    """In perspective, without needless vertices, and seen from the other side, if that is cheaper."""
    found = _settled(_in_perspective(found, scene), scene)
    found = _simpler(found, scene)
    sweep = found.sweep
    if not sweep.way.is_pointed:
        other = sweep.reversed() if sweep.way.centre is None else replace(sweep, is_near=not sweep.is_near)
        found = cheapest((found, priced(scene, other)))
    return found


def _settled(found: FoundSweep, scene: Scene) -> FoundSweep:
    """Moved to the ink as long as that gains something."""
    for _ in range(MOST_MOVES):
        there = moved(found, scene)
        if found.under(there.hand) - there.nats < LEAST_GAIN:
            break
        found = there
    return found


def _in_perspective(found: FoundSweep, scene: Scene) -> FoundSweep:
    """With a way that grows over the face, to a centre too where lines are left, if that tells the drawing better."""
    way = found.sweep.way
    if way.is_pointed or way.slope is not None:
        return found
    begun = [_sloped(found.sweep)]
    if way.centre is None and _leaves_some(found):
        middle = found.sweep.rings[0].middle
        afar = Way(np.zeros(2), middle + AFAR * way.shift, 1.0 - 1.0 / AFAR)
        begun.append(polished(_sloped(replace(found.sweep, way=afar)), scene.tree, FAR_OFF * scene.reach))
    return cheapest((found, *(priced(scene, polished(s, scene.tree, scene.reach)) for s in begun)))


def _leaves_some(found: FoundSweep) -> bool:
    """Whether lines are missing or left."""
    return found.energy.missing + found.energy.foreign > LEFT_OVER


def with_holes(found: FoundSweep, scene: Scene, loops: Iterable[Floats], within: float = WITHIN) -> FoundSweep:
    """With those closed lines inside the outer ring, by so many pixels, as holes that make it cheaper to tell."""
    if found.sweep.way.is_pointed:
        return found
    for loop in _inner(loops, found.sweep, within):
        outer, *holes = found.sweep.rings
        # one that is there already may have been told by a worse line
        others = [hole for hole in holes if not are_close(loop, hole.line, ALIKE * scene.size)]
        begun = replace(found.sweep, rings=(outer, *others))
        for hole in _cut_holes(loop, begun, scene.skeleton.pen_width):
            holed = priced(scene, replace(begun, rings=in_one_frame((*begun.rings, hole))))
            if holed.nats < found.nats + HOPEFUL:
                found = cheapest((found, moved(holed, scene)))
            elif hole.circle is not None and begun.way.centre is not None:
                found = cheapest((found, _from_afar(holed, scene)))
    return found


def _from_afar(found: FoundSweep, scene: Scene) -> FoundSweep:
    """In perspective, and moved to ink farther off: the rims of a hole tell what half of an outer rim does not."""
    begun = _sloped(found.sweep)
    return moved(priced(scene, polished(begun, scene.tree, FAR_OFF * scene.reach)), scene)


def _sloped(sweep: Sweep) -> Sweep:
    """With a way that may grow over the face."""
    if sweep.way.slope is not None:
        return sweep
    return replace(sweep, way=replace(sweep.way, slope=np.zeros(2), origin=sweep.rings[0].middle))


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
    """The same with fewer holes, vertices or arcs, if that is cheaper."""
    for rings, hopeful in _fewer(found.sweep.rings, SHORT * scene.size):
        way = priced(scene, replace(found.sweep, rings=rings))
        if way.nats < found.nats + hopeful:
            way = moved(way, scene)
        if cheapest((found, way)) is way:
            yield way


def _fewer(rings: tuple[Outline, ...], short: float) -> Iterator[tuple[tuple[Outline, ...], float]]:
    """The rings without a hole, or with fewer vertices or arcs, and how many nats that may gain by being moved."""
    for k, ring in enumerate(rings):
        before, after = rings[:k], rings[k + 1 :]
        if k:
            # the far rim of a hole may have been taken for another hole
            yield (*before, *after), HOPEFUL
        less = ((other, HOPEFUL) for other in _with_one_less(ring))
        without = ((other, HOPEFUL_NOTCH) for other in _without_notches(ring, short))
        for other, hopeful in chain(less, without):
            yield (*before, other, *after), hopeful


def _without_notches(ring: Outline, short: float) -> Iterator[Outline]:
    """The ring with some edges of at most so many pixels in all drawn together to a vertex, a smooth one or a corner.

    Where lines cross at a small angle, an outline that is followed has notches. Of arcs alone it may be a circle.
    """
    if len(ring.vertices) and ring.curved.all():
        yield rounded(evenly(ring.line), ring.frame)
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
