"""A worksheet: the drawing with its dimensions and what to find out, then the same with the answers."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from sketch2shape.export.parameters import Rounding
from sketch2shape.export.worksheet_drawing import LAYERS as DRAWING_LAYERS
from sketch2shape.export.worksheet_drawing import drawing_items
from sketch2shape.geometry import signed_area
from sketch2shape.model import Solid
from sketch2shape.sheets import PAPERS, Document, Item, Label, Layer, Paper, Sheet, Stroke
from sketch2shape.solids import Extrusion, extrusion_of, shape_name

LAYERS = (*DRAWING_LAYERS, Layer("text", "#000000", 0.2), Layer("solution", "#c01c28", 0.2))

#: millimetres left white at the edge, and height of the drawing
_MARGIN, _DRAWING = 18.0, 105.0

#: millimetres between lines of text, and to the lines that are written on
_LINE, _WRITE = 9.0, 10.0

#: height of text, millimetres
_TEXT = 3.4


@dataclass(frozen=True)
class Question:
    """A question, its answer in lines, and how many lines there are to write on."""

    text: str
    answer: tuple[str, ...]
    lines: int


def worksheet_document(solids: Sequence[Solid], paper: str = "a4") -> tuple[Document, str | None]:
    """Two sheets for each solid, without and with the answers; what is said of the scale, if there is no real size."""
    page = PAPERS[paper]
    sheets = []
    for number, solid in enumerate(solids, 1):
        name = f" {number}" if len(solids) > 1 else ""
        questions = _questions(solid)
        for solved in (False, True):
            title = f"{'Solution' if solved else 'Worksheet'}{name}"
            sheets.append(Sheet(tuple(_page(solid, page, title, questions, solved))))
    note = "no real size is known: the worksheet counts in pixels of the drawing (--width 40mm gives a size)"
    return Document("Worksheet with solution", page, LAYERS, tuple(sheets)), note if solids[0].unit == "px" else None


def _page(solid: Solid, paper: Paper, title: str, questions: list[Question], solved: bool) -> Iterator[Item]:
    left, right = _MARGIN, paper.width - _MARGIN
    yield Label("text", title, np.array([left, _MARGIN + 5.0]), 5.0)
    if not solved:
        yield Label(
            "text", "Name ______________________   Date ______________", np.array([right, _MARGIN + 5.0]), _TEXT, "end"
        )
    box = np.array([[left, _MARGIN + 12.0], [right, _MARGIN + 12.0 + _DRAWING]])
    yield from drawing_items(solid, box)
    y = float(box[1, 1]) + _LINE
    unit = _unit(solid)
    yield Label("text", f"Given: {_given(solid, unit)}.", np.array([left, y]), _TEXT)
    y += 0.65 * _LINE
    yield Label("text", f"All lengths are in {unit}. The drawing is not to scale.", np.array([left, y]), _TEXT)
    y += 0.35 * _LINE
    for number, question in enumerate(questions, 1):
        y += _LINE
        yield Label("text", f"{number}.  {question.text}", np.array([left, y]), _TEXT)
        for k in range(question.lines):
            y += _WRITE if not solved else 0.65 * _LINE
            if solved and k < len(question.answer):
                yield Label("solution", question.answer[k], np.array([left + 8.0, y]), _TEXT)
            elif not solved:
                yield Stroke("text", np.array([[left + 8.0, y], [right, y]]))


def _unit(solid: Solid) -> str:
    """What lengths are told in; pixels of a drawing are no length of a solid."""
    return "units" if solid.unit == "px" else solid.unit


def _given(solid: Solid, unit: str) -> str:
    """The sizes, in words."""
    number = Rounding(max(solid.dimensions), 1)
    extrusion = extrusion_of(solid)
    if extrusion is not None and extrusion.outlines[0].circle is not None:
        return f"diameter {number(float(extrusion.extents[0]))} {unit}, length {number(extrusion.length)} {unit}"
    width, height, depth = map(number, solid.dimensions)
    return f"width {width} {unit}, height {height} {unit}, depth {depth} {unit}"


def _questions(solid: Solid) -> list[Question]:
    b = solid.boundary
    counts = f"{_many(len(b.faces), 'face')}, {_many(len(b.edges), 'edge')}, {_many(len(b.vertices), 'corner')}"
    return [
        Question("What is this solid called?", (shape_name(solid).capitalize(),), 1),
        Question("How many faces, edges and corners does it have?", (counts,), 1),
        Question("What is its volume?", _volume(solid), 3),
        Question("What is its surface?", _surface(solid), 3),
    ]


def _many(count: int, word: str) -> str:
    return f"{count} {word}{'' if count == 1 else 's'}"


def _volume(solid: Solid) -> tuple[str, ...]:
    """The volume and how it is found."""
    unit = _unit(solid)
    result = f"V = {_rounded(solid.volume)} {unit}³"
    extrusion = extrusion_of(solid)
    if extrusion is None:
        return (result,)
    area = _base_area(extrusion)
    base, length = f"A = {_rounded(area)} {unit}²", f"h = {_rounded(extrusion.length)} {unit}"
    if extrusion.scale == 1.0:
        return (f"Base {base}, length {length}", f"V = A · h = {result[4:]}")
    if extrusion.scale == 0.0:
        return (f"Base {base}, height {length}", f"V = A · h / 3 = {result[4:]}")
    far = f"a = {_rounded(area * extrusion.scale**2)} {unit}²"
    return (f"Ends {base} and {far}, height {length}", f"V = h / 3 · (A + a + root of A · a) = {result[4:]}")


def _surface(solid: Solid) -> tuple[str, ...]:
    """The surface and how it is found."""
    unit = _unit(solid)
    result = f"{_rounded(solid.area)} {unit}²"
    extrusion = extrusion_of(solid)
    if extrusion is None:
        return (f"S = {result}",)
    base = _base_area(extrusion)
    far = base * extrusion.scale**2
    sides = f"sides M = {_rounded(solid.area - base - far)} {unit}²"
    if extrusion.scale == 1.0:
        return (f"Base A = {_rounded(base)} {unit}², {sides}", f"S = 2 · A + M = {result}")
    if extrusion.scale == 0.0:
        return (f"Base A = {_rounded(base)} {unit}², {sides}", f"S = A + M = {result}")
    return (f"Ends A = {_rounded(base)} {unit}² and a = {_rounded(far)} {unit}², {sides}", f"S = A + a + M = {result}")


def _base_area(extrusion: Extrusion) -> float:
    """Area of the near end: exact for arcs."""
    total = 0.0
    for k, ring in enumerate(extrusion.outlines):
        if ring.circle is not None:
            area = np.pi * ring.circle[1] ** 2
        else:
            arcs = (ring.arc(i) for i, bulge in enumerate(ring.bulges.tolist()) if bulge)
            segments = sum(arc.radius**2 * (arc.sweep - np.sin(arc.sweep)) / 2 for arc in arcs)
            area = abs(signed_area(ring.points) + segments)
        total += float(area) if k == 0 else -float(area)
    return total


def _rounded(value: float) -> str:
    """A number of four digits, or whole."""
    return f"{value:.0f}" if abs(value) >= 1000.0 else Rounding(abs(value), 1)(value)
