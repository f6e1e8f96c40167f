"""The dimensioned drawing: front, top and side view at one scale, in third or first angle."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from functools import lru_cache
from itertools import pairwise

import numpy as np

from sketch2shape.export.dimensions import FIRST, LAYER, NEXT, around, chain
from sketch2shape.export.parameters import Rounding
from sketch2shape.export.plan_options import Angle
from sketch2shape.export.scale import Scale, fitting_scales, usual_scales
from sketch2shape.model import Floats, Solid
from sketch2shape.sheets import PAPERS, Document, Item, Label, Layer, Paper, Round, Sheet, Stroke
from sketch2shape.solids import shape_name
from sketch2shape.solids.views import View, view_of

LAYERS = (
    Layer("visible", "#000000", 0.5),
    Layer("hidden", "#000000", 0.25, (2.0, 1.0)),
    Layer("center", "#5b6470", 0.18, (5.0, 0.8, 0.6, 0.8)),
    Layer(LAYER, "#0057b8", 0.18),
    Layer("text", "#000000", 0.25),
)

#: millimetres left white at the paper's edge, and for the words at the foot
_MARGIN, _FOOT = 10.0, 12.0

#: millimetres for dimensions to the left of the front view, between views, below, and for what stands out elsewhere
_LEFT, _GAP, _BELOW, _ELSE = 22.0, 24.0, 20.0, 14.0

#: an axis with more levels than this gets its whole size alone: the chain could not be read
_MOST_LEVELS = 8

#: millimetres by which centre lines stand out
_OUT = 2.5

#: leaders of circles point to them in directions so far apart, radians
_FAN = np.radians(35.0)

#: numbers have one digit less than those of programs
_FEWER = 1


def views_document(solids: Sequence[Solid], paper: str = "a4", angle: Angle = "third") -> tuple[Document, str | None]:
    """A sheet for each solid, and what had to be assumed about the scale; None at a usual scale."""
    document, scale = laid_views(tuple(solids), PAPERS[paper].turned, angle)
    return document, scale.note


@lru_cache(maxsize=1)  # the sheets and the word about them are asked for one after the other
def laid_views(solids: tuple[Solid, ...], paper: Paper, angle: Angle) -> tuple[Document, Scale]:
    """The sheets, at the largest scale that all solids have room at."""
    sets = [_views(solid, angle) for solid in solids]
    unit, room = solids[0].unit, (paper.width - 2 * _MARGIN, paper.height - 2 * _MARGIN - _FOOT)
    largest = max(max(solid.dimensions) for solid in solids)
    for scale in fitting_scales(room[0] / largest) if unit == "px" else usual_scales(unit):
        if all(_fits(views, scale.factor, room) for views in sets):
            break
    title = f"Front, top and side view, {scale.told}"
    sheets = [
        Sheet((*_drawing(views, scale.factor, room, angle), *_foot(solid, paper, scale, angle)))
        for views, solid in zip(sets, solids, strict=True)
    ]
    return Document(title, paper, LAYERS, tuple(sheets)), scale


def _views(solid: Solid, angle: Angle) -> tuple[View, View, View]:
    return view_of(solid, "front"), view_of(solid, "top"), view_of(solid, "right" if angle == "third" else "left")


def _fits(views: tuple[View, View, View], factor: float, room: tuple[float, float]) -> bool:
    front, top, side = (factor * view.size for view in views)
    wide = _LEFT + front[0] + _GAP + side[0] + _ELSE
    return bool(wide <= room[0] and front[1] + top[1] + _GAP + _BELOW + _ELSE <= room[1])


def _drawing(views: tuple[View, View, View], factor: float, room: tuple[float, float], angle: Angle) -> Iterator[Item]:
    """The three views in their places."""
    front, top, side = views
    wide = factor * (front.size[0] + side.size[0]) + _GAP
    high = factor * (front.size[1] + top.size[1]) + _GAP
    left = _MARGIN + _LEFT + max(room[0] - _LEFT - _ELSE - wide, 0.0) / 2
    upper = _MARGIN + _ELSE + max(room[1] - _BELOW - _ELSE - high, 0.0) / 2
    first, second = (top, front) if angle == "third" else (front, top)
    corners = {first.name: upper + factor * first.size[1], second.name: upper + high}
    known: dict[str, set[str]] = {"width": set(), "height": set(), "depth": set()}
    number = Rounding(max(*front.size.tolist(), float(side.size[0])), _FEWER)
    beside = left + factor * front.size[0] + _GAP
    for view, x in ((front, left), (top, left), (side, beside)):
        corner = np.array([x, corners["front" if view is side else view.name]])
        yield from _placed(view, factor, corner)
        yield from _dimensions(view, factor, corner, number, known)


def _placed(view: View, factor: float, corner: Floats) -> Iterator[Item]:
    """The lines of a view, whose lower left corner lies at a point of the sheet."""
    for layer, lines in (("visible", view.visible), ("hidden", view.hidden)):
        for line in lines:
            yield Stroke(layer, _at(line, factor, corner))
    for center, radius, turn, _ in view.circles:
        if turn < np.pi - 1e-3:
            continue
        low, high = np.maximum(center - radius, 0.0), np.minimum(center + radius, view.size)
        (x, y), (left, lower), (right, upper) = _at(np.array([center, low, high]), factor, corner)
        yield Stroke("center", np.array([[left - _OUT, y], [right + _OUT, y]]))
        yield Stroke("center", np.array([[x, upper - _OUT], [x, lower + _OUT]]))


def _at(points: Floats, factor: float, corner: Floats) -> Floats:
    return np.asarray(corner + factor * points * [1.0, -1.0])


def _dimensions(
    view: View, factor: float, corner: Floats, number: Rounding, known: dict[str, set[str]]
) -> Iterator[Item]:
    """Levels and sizes that no other view has told, and the circles.

    known : for each of width, height and depth the levels that were told; receives this view's
    """
    for axis, name in enumerate(view.sizes):
        size = float(view.size[axis])
        levels = _levels(view.corners[:, axis], size, number)
        new = [level for level in levels if number(level) not in known[name]]
        whole = not known[name]
        known[name] |= {number(level) for level in (0.0, *levels, size)}
        rows = [[0.0, *levels, size]] if new and len(levels) <= _MOST_LEVELS else []
        rows += [[0.0, size]] if whole else []
        for k, row in enumerate(rows):
            texts = [number(b - a) for a, b in pairwise(row)]
            away = FIRST + NEXT * k
            if axis == 0:
                places = [corner[0] + factor * level for level in row]
                yield from chain(places, texts, corner[1] + away, corner[1], level=True)
            else:
                places = [corner[1] - factor * level for level in row]
                yield from chain(places, texts, corner[0] - away, corner[0], level=False)
    yield from _round_dimensions(view, factor, corner, number)


def _levels(values: Floats, size: float, number: Rounding) -> list[float]:
    """The levels between the ends, those written alike once."""
    levels: list[float] = []
    for value in sorted(values.tolist()):
        apart = not levels or not number.same(value, levels[-1])
        if apart and not number.same(value, 0.0) and not number.same(value, size):
            levels.append(value)
    return levels


def _round_dimensions(view: View, factor: float, corner: Floats, number: Rounding) -> Iterator[Item]:
    """One leader for circles, and for arcs, of the same radius."""
    texts = [f"Ø{number(2 * r)}" if turn > 2 * np.pi - 1e-3 else f"R{number(r)}" for _, r, turn, _ in view.circles]
    counts, leaders = Counter(texts), 0
    for (center, radius, turn, middle), text in zip(view.circles, texts, strict=True):
        if counts[text] == 0:
            continue
        told = text if counts[text] == 1 else f"{counts[text]} × {text}"
        counts[text] = 0
        whole = turn > 2 * np.pi - 1e-3
        middle = np.pi / 4 - leaders * _FAN if whole else middle + min(turn / 4, np.pi / 4)
        leaders += whole
        beyond = max(r for other, r, *_ in view.circles if np.abs(other - center).max() < 1e-6 * view.size.max())
        yield from around(
            _at(center[None], factor, corner)[0], factor * radius, middle, told, factor * (beyond - radius)
        )


def _foot(solid: Solid, paper: Paper, scale: Scale, angle: Angle) -> Iterator[Item]:
    """Frame, name, scale, unit and the sign of the angle."""
    left, right, low = _MARGIN, paper.width - _MARGIN, paper.height - _MARGIN
    high = low - _FOOT
    yield Stroke("text", np.array([[left, _MARGIN], [right, _MARGIN], [right, low], [left, low]]), closed=True)
    yield Stroke("text", np.array([[left, high], [right, high]]))
    number = Rounding(max(solid.dimensions), _FEWER)
    unit = "pixels of the drawing" if solid.unit == "px" else solid.unit
    size = " × ".join(map(number, solid.dimensions))
    yield Label("text", f"{shape_name(solid)}, {size}".capitalize(), np.array([left + 3, low - 6.6]), 3.0)
    yield Label(
        "text", f"Dimensions in {unit}; {scale.told}".replace("; s", ". S"), np.array([left + 3, low - 2.2]), 2.4
    )
    yield Label("text", f"{angle}-angle projection", np.array([right - 30, low - 4.8]), 2.4, "end")
    yield from _sign(np.array([right - 15.0, low - _FOOT / 2]), angle)


def _sign(middle: Floats, angle: Angle) -> Iterator[Item]:
    """The sign of ISO 5456-2: a truncated cone from the side, and from its small end."""
    cone, rings = (middle + [5.5, 0], middle - [5.5, 0]) if angle == "third" else (middle - [5.5, 0], middle + [5.5, 0])
    yield Stroke("text", cone + np.array([[-4.0, -1.6], [4.0, -3.2], [4.0, 3.2], [-4.0, 1.6]]), closed=True)
    yield Round("text", rings, 1.6)
    yield Round("text", rings, 3.2)
    yield Stroke("center", np.array([middle - [11.0, 0], middle + [11.0, 0]]))
    yield Stroke("center", np.array([rings - [0, 4.4], rings + [0, 4.4]]))
