"""What stands on sheets of paper. Coordinates are millimetres from the upper left corner, x to the right, y down."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, TypeAlias

from sketch2shape.model import Brief, Floats

Anchor = Literal["start", "middle", "end"]
"""Which point of a text lies at its place."""


@dataclass(frozen=True)
class Paper:
    """A size of paper, millimetres, upright."""

    name: str
    width: float
    height: float

    @property
    def turned(self) -> Paper:
        """The same paper lying on its long side, or set upright again."""
        return Paper(self.name, self.height, self.width)


#: the papers that can be asked for
PAPERS = {"a4": Paper("A4", 210.0, 297.0), "letter": Paper("Letter", 215.9, 279.4)}


@dataclass(frozen=True)
class Layer:
    """What is drawn alike, and can be shown or cut apart from the rest.

    name  : in lower case
    color : as "#1f2328"
    width : of lines, millimetres
    dash  : lengths of strokes and gaps in turn, millimetres; none for a full line
    """

    name: str
    color: str
    width: float
    dash: tuple[float, ...] = ()


@dataclass(frozen=True, eq=False, repr=False)
class Stroke(Brief):
    """A line through points (n, 2); filled: what it goes round, with no line."""

    layer: str
    points: Floats
    closed: bool = False
    filled: bool = False


@dataclass(frozen=True, eq=False, repr=False)
class Round(Brief):
    """A whole circle: centre (2,) and radius."""

    layer: str
    center: Floats
    radius: float


@dataclass(frozen=True, eq=False, repr=False)
class Label(Brief):
    """A text on one line.

    at     : (2,) point of its base line
    height : of capitals, millimetres
    anchor : which end of the text lies there
    angle  : the way it runs, degrees anticlockwise from the right
    """

    layer: str
    text: str
    at: Floats
    height: float = 3.0
    anchor: Anchor = "start"
    angle: float = 0.0


Item: TypeAlias = Stroke | Round | Label


@dataclass(frozen=True)
class Sheet:
    """One side of paper."""

    items: tuple[Item, ...]


@dataclass(frozen=True)
class Document:
    """Sheets of one paper.

    title  : in a line
    layers : in the order they are drawn
    """

    title: str
    paper: Paper
    layers: tuple[Layer, ...]
    sheets: tuple[Sheet, ...]

    def of_layer(self, sheet: Sheet, layer: Layer) -> list[Item]:
        """The items of a sheet on a layer."""
        return [item for item in sheet.items if item.layer == layer.name]


#: height of capitals over the size of the type, of Helvetica and those like it
CAPITALS = 0.718


def decimal(value: float, decimals: int = 4) -> str:
    """A number without needless zeros."""
    text = f"{value:.{decimals}f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text
