"""Lines of an SVG: svgelements knows groups, transforms, styles and curves; here they become polylines."""

from __future__ import annotations

import io
import math
import re
from typing import Any
from xml.etree.ElementTree import Element, tostring

import numpy as np

from sketch2shape.errors import LimitError
from sketch2shape.model import Floats, VectorLine
from sketch2shape.reading.guarded_xml import local, parsed
from sketch2shape.reading.painted import Colour, OutlinedStrokesError, Shape

CHORDS, FEWEST, CURVES = 24, 4, 1000
"""Chords of a quarter turn or a Bezier curve: off by a thousandth of its radius; fewer where there are many curves."""
MOST_NUMBERS = 60_000
"""Numbers in the data of all paths together, those that <use> repeats included."""
MOST_STYLE, LONGEST_CLASS = 50_000, 1_000
"""Characters of style sheets, and of the classes of an element: each is looked up in the sheets."""
MOST_LOOKED_UP = 50_000_000
"""Characters of style sheets times elements: each element is held against each rule."""
OPAQUE = 0.95
"""Opacity from which on a filling hides what is under it."""
LEFT_OUT = frozenset(
    (
        *("text", "image", "foreignObject", "marker", "pattern", "clipPath", "mask", "filter", "metadata", "script"),
        *("title", "desc", "linearGradient", "radialGradient", "animate", "animateTransform", "namedview"),
    )
)
"""What is no line."""
_DECLARED = re.compile(r"^\s*<\?xml[^>]*\?>")
_NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
_NUMBERS_OF_AN_ELEMENT = 4
_HREF = ("href", "{http://www.w3.org/1999/xlink}href")


def svg_shapes(text: str, size: tuple[float, float]) -> list[Shape]:
    """The shapes of an SVG, in the order they are painted, in pixels of a page of this size, at 96 dpi.

    Raises OutlinedStrokesError where only a renderer can tell, UnreadableError, LimitError.
    """
    import svgelements

    root = parsed(_DECLARED.sub("", text, count=1).encode("utf-8", "surrogatepass"))
    _strip(root)
    _check_styles(root)
    _check_repeats(root)
    root.set("width", f"{size[0]}px")
    root.set("height", f"{size[1]}px")
    try:
        drawing = svgelements.SVG.parse(io.BytesIO(tostring(root)), reify=True, ppi=96.0)
    except Exception:  # what the library stumbles over, a renderer may still draw
        raise OutlinedStrokesError from None
    painted, segments = [], 0
    for element in drawing.elements():
        if isinstance(element, svgelements.Shape) and element.values.get("visibility") not in ("hidden", "collapse"):
            path = abs(element if isinstance(element, svgelements.Path) else svgelements.Path(element))
            painted.append((path, element))
            segments += len(path)
    chords = CHORDS if segments <= CURVES else FEWEST
    return [_shape(path, element, chords) for path, element in painted]


def _strip(element: Element) -> None:
    """Take out what is no line."""
    for child in list(element):
        style = len(child.text or "") if local(child.tag) == "style" else 0
        if style > MOST_STYLE or len(child.get("class", "")) > LONGEST_CLASS:
            raise LimitError("its style sheet is too long", remedy="save it as plain SVG")
        if local(child.tag) in LEFT_OUT or (local(child.tag) == "path" and not child.get("d")):
            element.remove(child)
        else:
            _strip(child)


def _check_styles(root: Element) -> None:
    """Raise LimitError if looking up all styles would take long."""
    every = list(root.iter())
    if sum(len(e.text or "") for e in every if local(e.tag) == "style") * len(every) > MOST_LOOKED_UP:
        raise LimitError("its style sheet is too long", remedy="save it as plain SVG")


def _check_repeats(root: Element) -> None:
    """Raise LimitError if <use> makes too many elements, or refers to itself."""
    named = {element.get("id"): element for element in root.iter() if element.get("id")}
    known: dict[Element, int] = {}
    open_now: set[Element] = set()

    def weight(element: Element) -> int:
        if element in open_now:
            raise LimitError("its parts repeat themselves without end", remedy="save it as plain SVG")
        if element not in known:
            open_now.add(element)
            total = _NUMBERS_OF_AN_ELEMENT + _numbers(element) + sum(weight(child) for child in element)
            if local(element.tag) == "use":
                target = named.get(next((element.get(key, "") for key in _HREF if element.get(key)), "").lstrip("#"))
                total += 0 if target is None else weight(target)
            open_now.remove(element)
            known[element] = total
        return known[element]

    if weight(root) > MOST_NUMBERS:
        raise LimitError("its lines have too many points", remedy="a drawing, not a map or a traced photo")


def _numbers(element: Element) -> int:
    return sum(len(_NUMBER.findall(element.get(key, ""))) for key in ("d", "points"))


def _shape(path: Any, element: Any, chords: int) -> Shape:
    parts: list[VectorLine] = []
    rings: list[Floats] = []
    for subpath in path.as_subpaths():
        runs = _runs(subpath, chords)
        parts += runs
        rings += [np.concatenate([run.points for run in runs])] if runs else []
    opacity = _number(element.values.get("opacity"), 1.0)
    stroke = _colour(element.stroke, opacity * _number(element.values.get("stroke-opacity"), 1.0), 0.1)
    if _number(element.values.get("stroke-width"), 1.0) <= 0:
        stroke = None
    fill = _colour(element.fill, opacity * _number(element.values.get("fill-opacity"), 1.0), OPAQUE)
    dashed = _is_dashed(element.values.get("stroke-dasharray"))
    return Shape(tuple(parts), tuple(rings), stroke, dashed, fill)


def _runs(subpath: Any, chords: int) -> list[VectorLine]:
    """A subpath as lines, each straight from point to point or curved throughout."""
    import svgelements

    runs: list[tuple[bool, list[list[float]]]] = []
    for segment in subpath:
        if isinstance(segment, svgelements.Move) or segment.end is None or segment.start == segment.end:
            continue
        curved = not isinstance(segment, svgelements.Line | svgelements.Close)
        if not runs or runs[-1][0] != curved:
            runs.append((curved, [[segment.start.x, segment.start.y]]))
        runs[-1][1].extend(_curve(segment, chords) if curved else [[segment.end.x, segment.end.y]])
    lines = [VectorLine(np.array(points, np.float64), curved=curved) for curved, points in runs]
    return [line for line in lines if np.isfinite(line.points).all()]


def _curve(segment: Any, chords: int) -> list[list[float]]:
    """Points along a curve, but for its start."""
    import svgelements

    turns = abs(segment.sweep) / (math.pi / 2) if isinstance(segment, svgelements.Arc) else 1.0
    count = max(2, math.ceil(chords * turns))
    along = segment.npoint(np.arange(1, count + 1) / count)
    points: list[list[float]] = np.asarray(along, np.float64).reshape(-1, 2).tolist()
    return points


def _colour(given: Any, opacity: float, least: float) -> Colour | None:
    """Red, green and blue where the colour is there and at least that opaque."""
    if given is None or given.value is None:
        return None
    if float(given.opacity if given.opacity is not None else 1.0) * opacity < least:
        return None
    return int(given.red), int(given.green), int(given.blue)


def _number(given: Any, otherwise: float) -> float:
    try:
        return float(str(given).strip().removesuffix("px")) if given is not None else otherwise
    except ValueError:
        return otherwise


def _is_dashed(given: Any) -> bool:
    """Whether the pattern has gaps: pairs of drawn and left out, and an odd one is repeated."""
    if given is None or str(given).strip().lower() in ("", "none"):
        return False
    lengths = [_number(word, 0.0) for word in str(given).replace(",", " ").split()]
    gaps = lengths[1::2] if len(lengths) % 2 == 0 else lengths
    return bool(lengths) and max(gaps, default=0.0) > 0.0
