"""The paper net on sheets: cut and fold lines on layers, glue tabs, and the numbers of the faces."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache

import numpy as np

from sketch2shape.export.net_layout import Cut, largest_factor, packed
from sketch2shape.export.scale import fitting_scales, reductions
from sketch2shape.model import Solid
from sketch2shape.sheets import PAPERS, Document, Item, Label, Layer, Paper, Sheet, Stroke

LAYERS = (
    Layer("cut", "#000000", 0.35),
    Layer("fold", "#0057b8", 0.25, (3.0, 1.5)),
    Layer("fold_back", "#c01c28", 0.25, (4.0, 1.2, 0.6, 1.2)),
    Layer("text", "#5b6470", 0.2),
)

#: millimetres that printers leave white, and that the words below take
MARGIN, FOOT = 10.0, 9.0

#: most sheets a net may take at true scale; a larger solid is drawn smaller
_MOST_SHEETS = 40

#: length of the rule that shows whether a printer kept the scale, millimetres
_RULE = 50.0

_HOW = "Cut full lines, fold dashed ones back, dash-dotted ones forward. Tabs show which face they are glued to."


def net_document(solids: Sequence[Solid], paper: str = "a4") -> tuple[Document, str | None]:
    """The nets of all solids, and what had to be assumed about the scale; None where it is true."""
    return _laid(tuple(solids), PAPERS[paper])


@lru_cache(maxsize=1)  # the sheets and the word about them are asked for one after the other
def _laid(solids: tuple[Solid, ...], paper: Paper) -> tuple[Document, str | None]:
    """The sheets, at the largest scale that fits: a true one if the solids have a real size."""
    room = (paper.width - 2 * MARGIN, paper.height - 2 * MARGIN - FOOT)
    unit = solids[0].unit
    allowed = len(solids) if unit == "px" else _MOST_SHEETS
    scales = reductions(unit)
    if unit == "px":
        scales = fitting_scales(min(largest_factor(solid.boundary, room) for solid in solids))
    for scale in scales:
        sheets = [sheet for solid in solids for sheet in packed(solid.boundary.scaled(scale.factor), room, allowed)]
        if len(sheets) <= allowed:
            break
    title = f"Paper net, {scale.told}"
    made = [
        Sheet((*(item for cut in sheet for item in _drawn(cut, room[1])), *_foot(paper, title, k, len(sheets))))
        for k, sheet in enumerate(sheets, 1)
    ]
    return Document(title, paper, LAYERS, tuple(made)), scale.note


def _drawn(cut: Cut, high: float) -> Iterator[Item]:
    """A line or a number, from the room's lower left corner into the sheet."""
    points = np.c_[MARGIN + cut.points[:, 0], MARGIN + high - cut.points[:, 1]]
    if cut.text:
        lower = points[0] + [0.0, cut.height / 2]
        yield Label(cut.layer, cut.text, lower, cut.height, "middle")
    else:
        yield Stroke(cut.layer, points)


def _foot(paper: Paper, title: str, number: int, count: int) -> Iterator[Item]:
    """The words below, and a rule to check the printer by."""
    left, right, low = MARGIN, paper.width - MARGIN, paper.height - MARGIN
    yield Label("text", f"{title}. Sheet {number} of {count}.", np.array([left, low - 3.6]), 2.2)
    yield Label("text", _HOW, np.array([left, low]), 1.9)
    ends = np.array([[right - _RULE, low - 3.0], [right, low - 3.0]])
    yield Stroke("text", np.concatenate([ends[:1] - [0, 1.2], ends, ends[1:] - [0, 1.2]]))
    yield Label("text", f"{_RULE:.0f} mm: print at 100 %", np.array([right, low]), 1.9, "end")
