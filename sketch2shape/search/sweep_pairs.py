"""Pairs: outlines and ways to the back face that a glance at a drawing supports, and how their outlines are cut."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, NamedTuple

import cv2
import numpy as np

from sketch2shape.model import Floats
from sketch2shape.search.scene import ALIKE, Scene
from sketch2shape.sweeps import (
    Cells,
    Frame,
    Loop,
    Sweep,
    Way,
    coherent_loops,
    cut_ring,
    ellipse_through,
    eroded_outline,
    in_one_frame,
    retraced,
    settled,
    settled_wire,
    ways_along,
    ways_towards,
)

if TYPE_CHECKING:
    pass

MOST_OUTLINES = 14
"""Outlines that are probed."""
TAPERS = 2
"""Ways that taper which are tried with one outline."""
ENOUGH = 0.8
"""Value of a pair from which on it may be the right one: hidden lines are not counted as explained."""
MOSTLY = 0.6
"""The same of wireframes that are asked for alone: lines that crossings draw aside are not counted as explained."""
MOST_HINTS = 2
"""Holes whose ellipses tell the shape of an outline's arcs, the largest."""
WIDELY, CLOSELY = (4.0, 0.5), (2.0, 0.3)
"""Pixels, and pens, within which moved ink lies on ink: by a shift roughly known, and by one well known."""
WHOLE = 0.9
"""Part of an outline's area from which on a line told more closely is still that outline."""
ALONG = 0.2
"""Part of an ellipse along an outline from which on its arc may be one of the outline."""
WITHIN = 2.0
"""Pixels by which a hole lies inside an outline at least."""
MOST_PRICED = 10
"""Pairs of a batch, those that explain most at a glance."""
WORSE = 0.2
"""Part of the ink that a pair may explain less than the best of its batch."""
SHALLOW_PENS, SHALLOW = 2.0, 0.015
"""Pens, and fraction of the drawing's size, below which there is no depth: two lines side by side are one pen apart."""
BARELY = 0.06
"""Fraction of the drawing's size by which a point lies outside its round base at least."""
LEAST_SCALE = 0.12
"""Scale of a smaller face, below which it is a point."""


class Pair(NamedTuple):
    """An outline with a way to the back face.

    loop     : the outline
    way      : to the back face
    is_near  : whether the outline is that of the nearer face
    is_whole : whether all of the outline has an image on ink, hidden or not
    holes    : closed lines inside the outline, if it is whole
    value    : see `Cells.value`; None before it is looked up
    """

    loop: Loop
    way: Way
    is_near: bool = True
    is_whole: bool = False
    holes: tuple[Loop, ...] = ()
    value: float | None = None

    def valued(self, cells: Cells) -> Pair:
        """With its value, looked up once."""
        if self.value is not None:
            return self
        if self.is_whole:
            return self._replace(value=cells.value_of_wire((self.loop, *self.holes), self.way))
        return self._replace(value=cells.value(self.loop, self.way, is_near=self.is_near))

    @property
    def places(self) -> Floats:
        """(6,) float, pixels: extent and middle of the outline, middle of its image."""
        middle = self.loop.line.mean(axis=0)
        return np.concatenate([np.ptp(self.loop.line, axis=0), middle, middle + self.way.of(middle[None])[0]])


def pairs_of(scene: Scene, *, bowed: bool) -> Iterator[list[Pair]]:
    """Outlines and ways that a glance at the ink supports, those that explain most of it first.

    bowed : whether some lines bow: else only wireframes are looked for, whose holes may be too narrow to bow

    The sources are asked in turn. A batch ends where a pair explains about all that lines without hidden ones can:
    whoever is content with it need not ask for more.
    """
    ranked: list[Pair] = []
    sources = (_coherent, _moved, _drawn_together) if bowed else (_coherent,)
    for source in sources:
        every = (p for p in _distinct(source(scene), scene.size) if not is_flat(p.way, p.loop.line, scene))
        ranked += [p.valued(scene.cells) for p in every]
        ranked.sort(key=_worth, reverse=True)
        enough = ENOUGH if bowed else MOSTLY
        if ranked and (_worth(ranked[0]) >= enough or (bowed and source is sources[-1])):
            good = [p for p in ranked[:MOST_PRICED] if _worth(p) >= _worth(ranked[0]) - WORSE]
            ranked = ranked[len(good) :]
            yield good


def _worth(pair: Pair) -> float:
    return -np.inf if pair.value is None else pair.value


def _distinct(pairs: Iterable[Pair], size: float) -> Iterator[Pair]:
    """Pairs without those that say what another says."""
    kept: dict[tuple[bool, bool, bool], list[Floats]] = {}
    for pair in pairs:
        places = pair.places
        alike = kept.setdefault((pair.is_near, pair.is_whole, pair.way.is_pointed), [])
        if not alike or (np.abs(np.array(alike) - places).max(axis=1) >= ALIKE * size).all():
            alike.append(places)
            yield pair


def _moved(scene: Scene) -> Iterator[Pair]:
    """Prisms and cylinders."""
    for loop in scene.loops[:MOST_OUTLINES]:
        for way in ways_along(loop, scene.skeleton, scene.along, scene.size):
            yield Pair(loop, way)


def _drawn_together(scene: Scene) -> Iterator[Pair]:
    """Tapered objects and cones."""
    for k, loop in enumerate(scene.loops[:MOST_OUTLINES]):
        # a base behind is whole on paper too where its hidden half is drawn or dashed
        sides = (True, False) if k < len(scene.ellipses) else (True,)
        ways = ways_towards(loop, scene.skeleton, scene.meeting, scene.size)
        tapered = [Pair(loop, way, near).valued(scene.cells) for way in ways for near in sides]
        yield from sorted(tapered, key=_worth, reverse=True)[:TAPERS]
    for loop in scene.ellipses:
        for centre in scene.meeting:
            point = Way(np.zeros(2), centre, 0.0)
            for is_near in (True, False):
                yield Pair(loop, point, is_near)


def _coherent(scene: Scene) -> Iterator[Pair]:
    """Wireframes: ink that lies on ink again when it is moved."""
    yield from _coherent_by(scene.shifts, scene)


def pairs_of_rungs(scene: Scene) -> list[Pair]:
    """The same by shifts that rungs tell, if they are others, and what the drawing covers eroded by each of these."""
    near = ALIKE * scene.size
    others = [s for s in scene.wire_shifts if all(np.hypot(*(s - t)) > near for t in (*scene.shifts, *-scene.shifts))]
    every = (*_coherent_by(others, scene), *_eroded(scene))
    return [p.valued(scene.cells) for p in every if not is_flat(p.way, p.loop.line, scene)]


def _eroded(scene: Scene) -> Iterator[Pair]:
    """The front faces of thin wireframes, whose lines run into each other."""
    for shift in scene.wire_shifts:
        line = eroded_outline(scene.skeleton.mask, shift)
        if line is not None:
            yield Pair(Loop(line), Way(shift), is_whole=True)


def _coherent_by(some: Iterable[Floats], scene: Scene) -> Iterator[Pair]:
    for shift in some:
        rough = _moved_to_ink(shift, WIDELY, scene)
        if not rough:
            continue
        line = np.concatenate([loop.line for loop in rough])
        way = settled_wire(shift, line, scene.tree, scene.reach)
        # lines between the faces lie on themselves for a little while
        close = _moved_to_ink(way.of(scene.skeleton.points), CLOSELY, scene)
        loops = close if close and close[0].area > WHOLE * rough[0].area else rough
        holes = [h for h in loops[1:] if loops[0].inside.holds(h.probes, WITHIN).all()]
        yield Pair(loops[0], way, is_whole=True, holes=tuple(holes))


def _moved_to_ink(shift: Floats, within: tuple[float, float], scene: Scene) -> list[Loop]:
    """Closed lines of ink that comes to lie within so many pixels, or pens, of ink by a shift (2,), or one a point."""
    reach = max(within[0], within[1] * scene.skeleton.pen_width)
    return [Loop(line) for line in coherent_loops(scene.skeleton, shift, reach, scene.size)]


def cut(pair: Pair, scene: Scene, *, leaning: bool = False) -> Iterator[Sweep]:
    """The sweeps that a pair may mean: its outline cut into lines and arcs.

    leaning : whether its arcs lean away from the way to the back, as in perspective
    """
    if not pair.way.is_pointed and not pair.is_whole:
        pair = pair._replace(way=settled(pair.way, pair.loop, scene.skeleton, scene.size))
    if is_flat(pair.way, pair.loop.line, scene):
        return
    pair = _larger_first(pair, scene)
    way, line = pair.way, pair.loop.line
    frame = _frame_along(line, scene) if leaning else None
    if leaning and frame is None:
        return
    axis = way.shift if way.centre is None else way.centre - line.mean(axis=0)
    axis = axis / (np.hypot(*axis) + 1e-9)
    pen = scene.skeleton.pen_width
    ring, inner = evenly(line), [evenly(h.line) for h in pair.holes]
    if pair.is_whole:
        ring, *inner = [retraced(r, way, scene.skeleton) for r in (ring, *inner)]
    holes = [next(cut_ring(r, axis, pen)).outline for r in inner]
    hints = tuple(hole.frame.ratio for hole in holes if hole.circle is not None)[:MOST_HINTS]
    if frame is not None:
        axis, hints = frame.along, (frame.ratio,)
    for made in cut_ring(ring, axis, pen, hints):
        yield Sweep(in_one_frame((made.outline, *holes)), way, pair.is_near)


def _frame_along(line: Floats, scene: Scene) -> Frame | None:
    """The frame of the ellipse that a closed line (k, 2), pixels, follows the most of: in perspective it leans."""
    near, best, most = ALIKE * scene.size, None, ALONG
    outline = line.astype(np.float32)
    for loop in scene.ellipses:
        apart = [abs(cv2.pointPolygonTest(outline, (float(x), float(y)), True)) for x, y in loop.probes]
        along = float(np.mean(np.array(apart) < near))
        if most < along < WHOLE:
            best, most = loop, along
    return None if best is None else ellipse_through(best.line).frame


def _larger_first(pair: Pair, scene: Scene) -> Pair:
    """The pair with the larger face as its front, as a base is: what is small of the other is seen on it."""
    way, loop = pair.way, pair.loop
    if way.centre is None or way.scale <= 1.0:
        return pair
    image = evenly(loop.line + way.of(loop.line))
    on_ink = retraced(image, Way(np.zeros(2)), scene.skeleton)
    return Pair(Loop(on_ink), Way(way.shift, way.centre, 1.0 / way.scale), not pair.is_near)


def evenly(loop: Floats) -> Floats:
    """(k, 2) points of a closed line, a pixel apart."""
    closed = np.concatenate([loop, loop[:1]])
    run = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(closed, axis=0).T))])
    at = np.linspace(0, run[-1], max(int(run[-1]), 12), endpoint=False)
    return np.stack([np.interp(at, run, closed[:, 0]), np.interp(at, run, closed[:, 1])], axis=1)


def is_flat(way: Way, line: Floats, scene: Scene) -> bool:
    """Whether a way leads an outline hardly anywhere: any outline is its own image.

    So is a round one with its point inside it, or hardly outside: the lines of a cone's side would lie on its rim.
    """
    if way.is_pointed and way.centre is not None:
        x, y = way.centre.tolist()
        return cv2.pointPolygonTest(line.astype(np.float32), (x, y), True) > -BARELY * scene.size
    if way.centre is not None and not LEAST_SCALE < way.scale < 1 / LEAST_SCALE:
        return True
    return float(np.median(np.hypot(*way.of(line).T))) < max(
        SHALLOW_PENS * scene.skeleton.pen_width, SHALLOW * scene.size
    )
