"""Named dimensions of an extrusion, and its outlines in terms of them: what programs that make the solid begin with.

Width, height and depth come first, or the diameter. A coordinate in between is half a size if it lies in the middle; a
dimension of its own, a step in from one side or the other, where a level or upright edge ends at it; else a part of the
size. So the object follows when a number at the top is changed. OpenSCAD and Python read these expressions alike.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np

from sketch2shape.model import Floats
from sketch2shape.solids import Extrusion
from sketch2shape.solids.front import FlatArc, FlatRing

#: significant digits of the largest size that are written: a drawing is never known better
_DIGITS = 5

#: most steps that get a name; an outline with more is no easier to read with names for all
_MOST_STEPS = 8

#: cosine from which a size runs along an axis of space
_ALONG = 0.999

#: how sizes run, for the remarks beside them
_RUNS = {"width": "from left to right", "height": "upward", "depth": "from front to back"}


@dataclass(frozen=True)
class Parameter:
    """A named number.

    name   : of the variable
    value  : as it is written
    remark : what it is, in words
    """

    name: str
    value: str
    remark: str


Point = tuple[str, str]
"""Expressions for both coordinates."""

Place = tuple[str, str, str]
"""Expressions for the coordinates in space."""


@dataclass(frozen=True)
class ArcText:
    """An arc in terms of named dimensions.

    center : of its circle
    radius : of its circle
    begin  : angle at which it begins, degrees anticlockwise from the right
    end    : angle at which it ends; less than `begin` where it turns clockwise
    rise   : distance of its middle from the chord, positive to the left of it
    """

    center: Point
    radius: str
    begin: str
    end: str
    rise: str


@dataclass(frozen=True)
class Path:
    """An outline in terms of named dimensions.

    points : its vertices
    arcs   : for each vertex the arc to the next one, None where that is a straight edge
    circle : centre and diameter, of an outline that is a whole circle and has no vertices
    """

    points: tuple[Point, ...] = ()
    arcs: tuple[ArcText | None, ...] = ()
    circle: tuple[Point, str] | None = None

    @property
    def is_straight(self) -> bool:
        """Whether it has no arc."""
        return self.circle is None and not any(self.arcs)


@dataclass(frozen=True)
class Design:
    """An extrusion in terms of named dimensions.

    parameters : in the order to write them
    outlines   : the outer one first, from its lower left corner
    length     : of the axis, the name of a dimension
    scale      : of the far end: "1", "0", or the name of the taper
    foot       : the point of the outline's plane from which the far end is scaled
    origin     : where in space the outline's lower left corner lies
    foot_origin : where in space the foot lies
    axes       : (3, 3) as in `Extrusion`
    """

    parameters: tuple[Parameter, ...]
    outlines: tuple[Path, ...]
    length: str
    scale: str
    foot: Point
    origin: Place
    foot_origin: Place
    axes: Floats

    @property
    def is_straight(self) -> bool:
        """Whether no outline has an arc."""
        return all(path.is_straight for path in self.outlines)


class Rounding:
    """Numbers as they are written: in steps of a power of ten that the largest size tells."""

    def __init__(self, largest: float, fewer: int = 0) -> None:
        """Take the largest size, and by how many digits it is written shorter."""
        self.decimals = _DIGITS - fewer - 1 - math.floor(math.log10(largest)) if largest > 0 else 0

    @property
    def half_step(self) -> float:
        """Numbers no farther apart are the same."""
        return float(0.5 * 10.0**-self.decimals)

    def same(self, a: float, b: float) -> bool:
        """Whether two numbers are written alike, give or take the last digit."""
        return abs(a - b) <= self.half_step

    def __call__(self, value: float) -> str:
        """The number without needless zeros."""
        return plain_number(round(value, self.decimals), max(self.decimals, 0))


def plain_number(value: float, decimals: int) -> str:
    """A decimal number without an exponent or needless zeros: "12.5", "-3"."""
    text = f"{value:.{decimals}f}"
    text = text.rstrip("0").rstrip(".") if "." in text else text
    return "0" if text == "-0" else text


def design_of(extrusion: Extrusion, ending: str = "") -> Design:
    """The extrusion in terms of named dimensions; `ending` is put behind each name, to tell several objects apart."""
    largest = max(extrusion.length, *extrusion.extents.tolist())
    names = _Names(extrusion, Rounding(largest), ending)
    foot = extrusion.foot
    return Design(
        names.parameters(),
        tuple(map(names.path, extrusion.outlines)),
        names.called[2],
        names.scale,
        names.point(foot),
        names.place(extrusion.origin),
        names.place(extrusion.origin + foot @ extrusion.axes[:2]),
        extrusion.axes,
    )


@dataclass
class _Step:
    """A distance in from sides of the outline that several coordinates share.

    value : the distance
    hole  : do only holes have it?
    sides : the sides it is measured from, in words
    axes  : 0 across, 1 up
    """

    value: float
    hole: bool
    sides: list[str] = field(default_factory=list)
    axes: set[int] = field(default_factory=set)
    name: str = ""

    @property
    def kind(self) -> str:
        """A wall if it is as thick across as up, or on both sides of a hole; else a step, or the inset of a hole."""
        around = len(self.axes) > 1 if not self.hole else len(self.sides) > 2
        return "wall" if around else "inset" if self.hole else "step"

    @property
    def remark(self) -> str:
        """What it is, in words."""
        return ("to the hole, " if self.kind == "inset" else "") + "in from the " + _listed(self.sides)


@dataclass
class _Round:
    """A diameter, or the radius of arcs, that several curves share.

    value  : of all of them
    kind   : what the dimension is called
    remark : what it is, in words
    """

    value: float
    kind: str
    remark: str
    name: str = ""


class _Names:
    """The dimensions' names, and expressions in them."""

    def __init__(self, extrusion: Extrusion, rounding: Rounding, ending: str) -> None:
        self._e, self._round = extrusion, rounding
        names: Sequence[str] = extrusion.names
        if extrusion.outlines[0].circle is not None:
            names = ("diameter", "diameter", names[2])
        self.called = tuple(name + ending for name in names)
        self.scale = {0.0: "0", 1.0: "1"}.get(extrusion.scale, "taper" + ending)
        self._sizes = [*extrusion.extents.tolist(), extrusion.length]
        self._curved = any(outline.circle is not None or outline.bulges.any() for outline in extrusion.outlines)
        self._rounds: list[_Round] = []
        self._steps: list[_Step] = []
        for hole, outline in enumerate(extrusion.outlines):
            self._add_rounds(outline, bool(hole))
        for hole, outline in enumerate(extrusion.outlines):
            for axis in (0, 1):
                for value in _edge_levels(outline, axis, rounding):
                    self._add_step(axis, value, bool(hole))
        del self._steps[_MOST_STEPS:]
        _number([*self._rounds, *self._steps], ending)

    def _add_rounds(self, outline: FlatRing, hole: bool) -> None:
        """Note the diameter of a hole, or the radii of arcs, that follow from no size."""
        if outline.circle is not None:
            found = [_Round(2 * outline.circle[1], "hole_diameter", "of the hole")] if hole else []
        else:
            radii = [outline.radius(k) for k, bulge in enumerate(outline.bulges.tolist()) if bulge]
            found = [_Round(radius, "radius", "of the arcs") for radius in radii if self._half_size(radius) is None]
        for new in found:
            if not any(r.kind == new.kind and self._round.same(r.value, new.value) for r in self._rounds):
                self._rounds.append(new)

    def _half_size(self, value: float) -> str | None:
        """The expression for half of a size, or all of it, across or up."""
        for name, size in zip(self.called[:2], self._sizes[:2], strict=True):
            for text, part in ((f"{name} / 2", 0.5), (name, 1.0)):
                if self._round.same(part * size, value):
                    return text
        return None

    def _add_step(self, axis: int, value: float, hole: bool) -> None:
        """Note a coordinate that a level or upright edge ends at."""
        size = self._sizes[axis]
        inset = min(value, size - value)
        side = self._e.sides[axis][int(value > size / 2)]
        step = next((s for s in self._steps if self._round.same(s.value, inset)), None)
        if step is None:
            if self._known(axis, value) is not None:
                return
            self._steps.append(step := _Step(inset, hole))
        step.axes.add(axis)
        if side not in step.sides:
            step.sides.append(side)

    def parameters(self) -> tuple[Parameter, ...]:
        """Sizes, radii and diameters, steps, taper."""
        tapered = self.scale not in ("0", "1")
        sizes: dict[str, Parameter] = {}
        for k in sorted(range(3), key=lambda k: list(_RUNS).index(self._e.names[k])):
            remark = "across" if "diameter" in self.called[k] else _RUNS[self._e.names[k]]
            remark += ", at the larger end" if tapered and k < 2 else ""
            sizes[self.called[k]] = Parameter(self.called[k], self._round(self._sizes[k]), remark)
        named: list[_Round | _Step] = [*self._rounds, *self._steps]
        others = [Parameter(item.name, self._round(item.value), item.remark) for item in named]
        taper = [Parameter(self.scale, f"{self._e.scale:.6g}", "size of the other end over that of the larger end")]
        return (*sizes.values(), *others, *(taper if tapered else []))

    def path(self, outline: FlatRing) -> Path:
        """An outline."""
        if outline.circle is not None:
            center, radius = outline.circle
            return Path(circle=(self.point(center), self._diameter(2 * radius)))
        arcs = tuple(self._arc(outline.arc(k)) if b else None for k, b in enumerate(outline.bulges.tolist()))
        return Path(tuple(map(self.point, outline.points)), arcs)

    def _diameter(self, value: float) -> str:
        for item in self._rounds:
            if item.kind == "hole_diameter" and self._round.same(item.value, value):
                return item.name
        return self.called[0]

    def _arc(self, arc: FlatArc) -> ArcText:
        radius = self._half_size(arc.radius)
        if radius is None:
            radius = next(r.name for r in self._rounds if r.kind == "radius" and self._round.same(r.value, arc.radius))
        part = 1.0 - math.cos(arc.sweep / 2)
        rise = radius if abs(part - 1.0) < 1e-6 else f"{part:.6f} * {radius}"
        begin, turn = math.degrees(arc.begin), math.degrees(arc.sweep)
        ends = (plain_number(begin, _DIGITS), plain_number(begin + turn, _DIGITS))
        return ArcText(self.point(arc.center), radius, *ends, f"-{rise}" if turn > 0 else rise)

    def point(self, point: Floats) -> Point:
        """The expressions for a point (2,) of the outline's plane."""
        x, y = point.tolist()
        return self._inside(0, x), self._inside(1, y)

    def place(self, point: Floats) -> Place:
        """The expressions for a point (3,) in space."""
        x, y, z = (self._anywhere(value, along) for along, value in enumerate(point.tolist()))
        return x, y, z

    def _anywhere(self, value: float, along: int) -> str:
        """The expression for a coordinate in space: part of the size along it where it is so, else a number."""
        for name, size, axis in zip(self.called, self._sizes, self._e.axes, strict=True):
            for text, part in ((name, 1.0), (f"{name} / 2", 0.5)):
                if abs(axis[along]) > _ALONG and self._round.same(abs(value), part * size):
                    return text if value > 0 else f"-{text}"
        return self._round(value)

    def _inside(self, axis: int, value: float) -> str:
        known = self._known(axis, value)
        return known if known is not None else f"{plain_number(value / self._sizes[axis], 6)} * {self.called[axis]}"

    def _known(self, axis: int, value: float) -> str | None:
        """The expression for a coordinate of the outline's plane in dimensions that have a name so far."""
        name, size = self.called[axis], self._sizes[axis]
        named: list[tuple[float, str]] = [(0.0, "0"), (size, name), (size / 2, f"{name} / 2")]
        insets = [(item.value, item.name) for item in self._steps]
        if self._curved:
            insets.append((self._sizes[1 - axis] / 2, f"{self.called[1 - axis]} / 2"))
            insets += [(item.value, item.name) for item in self._rounds if item.kind == "radius"]
        for inset, text in insets:
            named += [(inset, text), (size - inset, f"{name} - {text}")]
        return next((text for known, text in named if self._round.same(known, value)), None)


def _number(items: Sequence[_Round | _Step], ending: str) -> None:
    """Give each its name, with a number where several are of one kind."""
    kinds = [item.kind for item in items]
    for number, item in enumerate(items):
        count = f"_{kinds[: number + 1].count(item.kind)}" if kinds.count(item.kind) > 1 else ""
        item.name = item.kind + count + ending


def _edge_levels(outline: FlatRing, axis: int, rounding: Rounding) -> list[float]:
    """The coordinates at which level or upright edges end; of a circle that of its centre."""
    if outline.circle is not None:
        return [float(outline.circle[0][axis])]
    steps = np.abs(np.roll(outline.points, -1, axis=0) - outline.points)
    straight = (steps <= rounding.half_step).any(axis=1) & (outline.bulges == 0)
    return list(dict.fromkeys(outline.points[straight | np.roll(straight, 1), axis].tolist()))


def _listed(words: list[str]) -> str:
    return words[0] if len(words) == 1 else f"{', '.join(words[:-1])} and {words[-1]}"


def parameter_lines(parameters: tuple[Parameter, ...], mark: str, assign: Callable[[Parameter], str]) -> list[str]:
    """Lines such as "width = 60;  // from left to right", with the remarks below each other."""
    told = [assign(parameter) for parameter in parameters]
    width = max(map(len, told), default=0)
    return [f"{text:<{width}}  {mark} {p.remark}" for text, p in zip(told, parameters, strict=True)]
