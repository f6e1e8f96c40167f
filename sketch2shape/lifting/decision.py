"""All the ways to read a drawing, each with its log odds: what the drawing shows and what people draw.

Every reading is rated in one currency: how well the relation of the two faces that it needs explains them (`evidence`),
how regular the true face then is, how usual the view (`reading`, `perspective`), and a prior of the kind of drawing.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from sketch2shape.lifting.box import lean, receding, standing_pairs
from sketch2shape.lifting.evidence import (
    Relation,
    converging_odds,
    facing_odds,
    of_alike_faces,
    of_scaled_faces,
    parallels_odds,
    tapered_odds,
)
from sketch2shape.lifting.face import edge_vectors
from sketch2shape.lifting.face_relation import relate_faces
from sketch2shape.lifting.parallel import (
    CABINET,
    CAVALIER,
    axonometric_maps,
    axonometric_shape,
    cavalier_odds,
    oblique_shape,
)
from sketch2shape.lifting.perspective import facing_shape, perspective_shape, relations_of, seen_by_cameras
from sketch2shape.lifting.poses import Pose
from sketch2shape.lifting.projection import Drawing
from sketch2shape.lifting.reading import ParallelReading, read_parallel, refined_pose
from sketch2shape.lifting.shape import Shape
from sketch2shape.lifting.standing import standing_odds, standing_shape
from sketch2shape.model import Floats, Ints

#: log odds of kinds of drawing against an axonometric one of a prism, before anything is seen
_TAPERED, _PERSPECTIVE = -2.3, -1.5

#: how likely a four-sided face is a parallelogram
_BOX = 0.9

#: part of a drawing's diagonal by which four corners that are no parallelogram miss one, about
_BEND = 0.4

#: log odds that the sides given are the face drawn in its true shape, against another pair of a box's sides
_GIVEN = 1.0

#: log odds that a degree of lean costs a prism over a parallelogram
_LEAN = 0.06

#: log odds of a pyramid drawn with its base facing the viewer
_FACING_BASE = -4.0

#: faces whose relation is this much less likely than the best cannot win by being regular, log odds
_HOPELESS = 7.0

#: log odds that a perspective reading may gain on others by being regular, as far as it is worth trying
_HOPED = 1.0

#: the back face of a drawing with hidden lines is not the larger one by more than this
_LARGER = 1.02

#: a vertex is never taken as shakier than this part of the object's diagonal
_SHAKIEST = 0.03


@dataclass(frozen=True)
class Reading:
    """One way to read the drawing.

    name   : "cabinet", "cavalier", "isometric", "dimetric", "axonometric", "perspective", "one-point", or a tapered one
    family : of the projection
    odds   : log odds
    held   : how much of its likelihood is in solids with the same proportions
    make   : builds the shape; None if there is none after all
    """

    name: str
    family: str
    odds: float
    held: float
    make: Callable[[], Shape | None]


@dataclass(frozen=True)
class _Faces:
    """Two faces alike but for their size, as what their relation explains of them leaves them.

    drawing : as told, with the noise as these faces show it
    noise   : standard deviation of a vertex of the face, pixels
    order   : number of each vertex in the object, None if these are the faces given
    face, d : (m, 2) the front face, (2,) the vector between the faces' middles, pixels
    taper   : the back face over the front face, 1 for a prism
    loose   : its standard deviation
    odds    : log odds
    straight: was the face made a parallelogram?
    upright : may it be an axonometric view (of these of a box's sides)?
    """

    drawing: Drawing
    noise: float
    order: Ints | None
    face: Floats
    d: Floats
    taper: float
    loose: float
    odds: float
    straight: bool = False
    upright: bool = True

    @property
    def tapered(self) -> float:
        """Log odds of a tapered object besides `odds`."""
        if self.drawing.pointed:
            return 0.0
        return _TAPERED + tapered_odds(self.taper, self.loose)

    @property
    def facing(self) -> float:
        """Log odds of a prism that faces the viewer in perspective besides `odds`."""
        bent = self.drawing.bent is not None or self.drawing.pointed
        if bent or self.taper == 1.0 or (self.drawing.hidden and self.taper > _LARGER):
            return -math.inf
        return _PERSPECTIVE + facing_odds(self.taper, self.loose)

    @property
    def hoped(self) -> float:
        """Log odds before anything is known of how regular they are."""
        return self.odds if self.taper == 1.0 else self.odds + max(self.tapered, self.facing)

    def placed(self, shape: Shape) -> Shape:
        """A shape made from these faces."""
        drawing = self.drawing
        return replace(
            shape, order=self.order, noise=self.noise, taper=self.taper, bent=drawing.bent, pointed=drawing.pointed
        )


def all_readings(given: Drawing, ratio: float | None = None) -> list[Reading]:
    """Every reading that may matter, the likeliest first; ratio is that of an oblique drawing, if it is known."""
    pairs = [_placed(pair, order, given.relation.d) for pair, order in given.pairs]
    faces = [f for k, (drawing, order) in enumerate(pairs) for f in _faces(drawing, order, given=k == 0)]
    best = max(f.hoped for f in faces)
    found: list[Reading] = []
    for f in sorted(faces, key=lambda f: -f.hoped):
        if found and f.hoped < best - _HOPELESS:
            break  # not before anything is found: faces told apart from parallelograms may turn out to be some
        found += _of_parallel(f, ratio, aslant=f.upright and (f.taper == 1.0 or f.odds + f.tapered >= best - _HOPELESS))
    if given.pointed or (given.bent is not None and not given.bent.in_perspective):
        return sorted(found, key=lambda r: -r.odds)
    parallel = max(of_alike_faces(drawing.relation, drawing.noise).odds for drawing, _ in pairs)
    for drawing, order in pairs:
        found += _of_perspective(drawing, order, parallel)
    return sorted(found, key=lambda r: -r.odds)


def _placed(pair: Drawing, order: Ints | None, toward: Floats) -> tuple[Drawing, Ints | None]:
    """Another pair of a box's sides with the nearer one in front; `toward` joins the faces given."""
    if order is None:
        return pair, None
    chosen, swapped = receding(pair, toward)
    return chosen, np.roll(order, 4) if swapped else order


def _faces(drawing: Drawing, order: Ints | None, *, given: bool) -> Iterator[_Faces]:
    """What this pair of faces may be: alike or of two sizes; and if they have four sides, parallelograms or not."""
    if drawing.pointed:
        yield from _pyramids(drawing)
        return
    skews = [None, _skew(drawing)] if drawing.is_box else [None]
    for skew in skews:
        alike = of_alike_faces(drawing.relation, drawing.noise, skew)
        if skew is None:
            yield _explained(drawing, order, alike, 1.0, skew)
        elif given:
            yield from _boxes(_explained(drawing, order, alike, 1.0, skew))
        if drawing.relation.scale > 0.0:
            scaled = of_scaled_faces(drawing.relation, drawing.noise, skew)
            yield _explained(drawing, order, scaled, drawing.relation.scale, skew)


def _pyramids(drawing: Drawing) -> Iterator[_Faces]:
    """A face and a point over its middle; one with four sides also as the parallelogram that it mostly is."""
    face = drawing.first
    d = drawing.second[0] - drawing.middle(face)
    four = drawing.sizes == [4] and drawing.bent is None
    yield _Faces(drawing, drawing.noise, None, face, d, 0.0, 0.0, math.log(1.0 - _BOX) if four else 0.0)
    if four:
        bend = float(((face[0] - face[1] + face[2] - face[3]) ** 2).sum())
        usual = 2.0 * math.log(max(0.5 * _BEND * drawing.diagonal / drawing.noise, 1.0))
        odds = math.log(_BOX) + usual - 0.125 * bend / drawing.noise**2
        yield _Faces(drawing, drawing.noise, None, _straightened(face), d, 0.0, 0.0, odds, straight=True)


def _skew(drawing: Drawing) -> tuple[float, float]:
    """How far the mean face is from a parallelogram, squared, and that over a vertex's variance if it is one."""
    known = drawing.known[:, None]
    p = drawing.first + 0.5 * known * (drawing.second - drawing.relation.d - drawing.first)
    bend = p[0] - p[1] + p[2] - p[3]
    return float(bend @ bend), 4.0 - 0.5 * float(known.sum())


def _explained(
    drawing: Drawing, order: Ints | None, told: Relation, taper: float, skew: tuple[float, float] | None
) -> _Faces:
    noise = max(drawing.noise, min(told.noise, _SHAKIEST * drawing.diagonal))
    shaken = replace(drawing, noise=noise)
    face, d = _mean_face(shaken, told.scale)
    odds = told.odds
    if skew is not None:
        face = _straightened(face)
        odds += math.log(_BOX) + 2.0 * math.log(max(_BEND * drawing.diagonal / (noise * math.sqrt(skew[1])), 1.0))
    elif drawing.is_box:
        odds += math.log(1.0 - _BOX)
    known = int(drawing.known.sum())
    own = noise * (math.sqrt(0.5) if known == len(face) else 1.0)
    return _Faces(shaken, own, order, face, d, taper, told.loose, odds, skew is not None)


def _boxes(faces: _Faces) -> Iterator[_Faces]:
    """A prism over a parallelogram by each pair of its sides; its edges have three directions, each told four times."""
    face, d = faces.face, faces.d
    every = np.ones(4, bool)
    box = replace(faces.drawing, first=face, second=face + d, relation=relate_faces(face, face + d), known=every)
    standing = standing_pairs(box)
    for number, (pair, order) in enumerate(box.pairs):
        drawing, turned = _placed(pair, order, d)
        yield replace(
            faces,
            drawing=drawing,
            order=turned,
            face=drawing.first,
            d=drawing.relation.d,
            upright=number in standing,
        )


def _straightened(face: Floats) -> Floats:
    """(4, 2) the parallelogram nearest to a face."""
    across, down = 0.25 * (face[1] - face[0] + face[2] - face[3]), 0.25 * (face[3] - face[0] + face[2] - face[1])
    straight: Floats = face.mean(axis=0) + np.array([-across - down, across - down, across + down, down - across])
    return straight


def _of_parallel(faces: _Faces, ratio: float | None, *, aslant: bool) -> Iterator[Reading]:
    """Prisms and tapered objects in parallel drawings, and prisms that face the viewer in perspective.

    aslant : may the face be foreshortened?
    """
    drawing = faces.drawing
    known = int(drawing.known.sum())
    wobble = drawing.noise * math.sqrt(2.0 / max(known, 1)) / math.hypot(*faces.d.tolist())
    relations = relations_of(drawing, faces.face, faces.face, faces.noise)
    fit = faces.odds
    if not faces.straight:
        if drawing.is_box and len(relations.edges) == 2:
            return  # that is a parallelogram
        fit += parallels_odds(relations, faces.noise)
    kind = fit if faces.taper == 1.0 else fit + faces.tapered
    bent = drawing.bent
    arcs = [faces.face[arc.rows] for arc in bent.arcs] if bent else []
    base = drawing.pointed and bent is None
    if base and faces.straight:
        yield from _standing(faces, kind, ratio)
    for found in read_parallel(
        faces.face, faces.d, relations, faces.noise, wobble, aslant=aslant, arcs=arcs, pyramid=base
    ):
        if found.pose is not None:
            yield _axonometric(faces, replace(found, odds=kind + found.odds))
            continue
        given = found.odds - _leaning(faces, faces.face) + (_GIVEN if faces.straight and faces.order is None else 0.0)
        if base:
            given += _FACING_BASE
        yield from _oblique(faces, kind + given, ratio)
        if faces.facing > -math.inf:
            yield Reading("one-point", "perspective", fit + faces.facing + given, 1.0, lambda: _facing(faces))


def _facing(faces: _Faces) -> Shape:
    return replace(facing_shape(faces.drawing, faces.face), order=faces.order, noise=faces.noise)


def _oblique(faces: _Faces, odds: float, ratio: float | None) -> Iterator[Reading]:
    """The face in its true shape, once for each depth that such a drawing may mean."""
    sizes, d, bent = faces.drawing.sizes, faces.d, faces.drawing.bent
    edges = bent.lengths(faces.face) if bent else np.hypot(*edge_vectors(faces.face, sizes).T)
    cavalier = cavalier_odds(edges, math.hypot(*d.tolist()), faces.noise)
    depths = {"oblique": (ratio or CABINET, 0.0)}
    if ratio is None:
        depths = {
            "cabinet": (CABINET, -float(np.logaddexp(0.0, cavalier))),
            "cavalier": (CAVALIER, -float(np.logaddexp(0.0, -cavalier))),
        }

    for name, (used, part) in depths.items():
        make = partial(oblique_shape, faces.face, sizes, d, used, free=ratio is None)
        yield Reading(_named(name, faces), "oblique", odds + part, 1.0, partial(_made, faces, make))


def _standing(faces: _Faces, kind: float, ratio: float | None) -> Iterator[Reading]:
    """A pyramid that stands in an oblique drawing."""
    told = standing_odds(faces.face, faces.d, faces.noise)
    if told is None:
        return
    odds, level = told
    ratios = {"oblique": (ratio, 1.0)} if ratio else {"cabinet": (CABINET, 0.7), "cavalier": (CAVALIER, 0.3)}
    for name, (used, part) in ratios.items():
        make = partial(standing_shape, faces.face, faces.d, level, used or CABINET, free=ratio is None)
        yield Reading(f"standing, {name}", "oblique", kind + odds + math.log(part), 1.0, partial(_made, faces, make))


def _made(faces: _Faces, make: Callable[[], Shape]) -> Shape:
    return faces.placed(make())


def _axonometric(faces: _Faces, found: ParallelReading) -> Reading:
    face, d, pose = faces.face, faces.d, found.pose or Pose(0.0, 0.0)
    odds = found.odds - _leaning(faces, face @ axonometric_maps(np.array([pose.slant]), d)[0])

    def make() -> Shape:
        fine = refined_pose(found.view, pose) if found.name == "axonometric" else pose
        return faces.placed(axonometric_shape(face, faces.drawing.sizes, fine.turned(d), fine.slant))

    return Reading(_named(found.name, faces), "axonometric", odds, found.held, make)


def _leaning(faces: _Faces, true: Floats) -> float:
    """Log odds that a true face (m, 2) costs for being a parallelogram that leans."""
    return _LEAN * lean(true) if faces.straight and faces.taper in (0.0, 1.0) else 0.0


def _named(name: str, faces: _Faces) -> str:
    return name if faces.taper == 1.0 else f"tapered, {name}"


def _of_perspective(drawing: Drawing, order: Ints | None, parallel: float) -> Iterator[Reading]:
    """The prism that cameras see, if the faces may converge at all; parallel: log odds of their being alike."""
    relation = drawing.relation

    def hopeless(rss: float) -> bool:
        return _PERSPECTIVE + float(converging_odds(rss, relation, drawing.noise)) + _HOPED < parallel

    # most drawings need not be asked how well their lines meet
    if hopeless(0.0) or hopeless(relation.centre_rms**2 * max(len(relation.first) - 2, 0)):
        return
    seen = seen_by_cameras(drawing)
    if seen.relations is None or not np.isfinite(seen.odds.max()):
        return
    odds = _PERSPECTIVE + seen.whole + parallels_odds(seen.relations, drawing.noise)
    if drawing.is_box:
        odds += math.log(_BOX if len(seen.relations.edges) == 2 else 1.0 - _BOX)

    def make() -> Shape | None:
        shape = perspective_shape(drawing, seen)
        return shape and replace(shape, order=order, noise=math.sqrt(0.5) * drawing.noise, bent=drawing.bent)

    yield Reading("perspective", "perspective", odds, 1.0, make)


def _mean_face(drawing: Drawing, scale: float) -> tuple[Floats, Floats]:
    """(m, 2) the face as both drawn ones have it, and (2,) the vector between their middles, pixels."""
    first, second, known = drawing.first, drawing.second, drawing.known
    if scale == 1.0:
        d = drawing.relation.d
        weight = 0.5 * known[:, None]
        return first + weight * (second - d - first), d
    back = (second - drawing.relation.shift) / scale
    weight = scale**2 / (1.0 + scale**2) * known[:, None]
    face = first + weight * (back - first)
    middle = drawing.middle(face)
    return face, scale * middle + drawing.relation.shift - middle
