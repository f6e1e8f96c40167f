"""Nets on sheets: true to scale, within the paper, and said so."""

from __future__ import annotations

from xml.etree import ElementTree

import numpy as np
import pytest
from export.upright import BOX, CURVED, HOUSE, NOTCH, L, facing

from sketch2shape.errors import UsageError
from sketch2shape.export import encode, note_of
from sketch2shape.export.net import net_document
from sketch2shape.sheets import Label, Stroke

SOLIDS = {"box": facing([BOX]), "L": facing([L, NOTCH]), "pixels": facing([3 * HOUSE], unit="px"), **CURVED}


def strokes(document, *layers):
    return [i for sheet in document.sheets for i in sheet.items if isinstance(i, Stroke) and i.layer in layers]


def texts(document):
    return [i.text for sheet in document.sheets for i in sheet.items if isinstance(i, Label)]


@pytest.mark.parametrize("paper", ["a4", "letter"])
@pytest.mark.parametrize("solid", SOLIDS.values(), ids=SOLIDS)
def test_all_lines_lie_within_the_margins(solid, paper):
    document, _ = net_document([solid], paper)
    for line in strokes(document, "cut", "fold", "fold_back"):
        assert line.points.min() > 9.9
        assert (line.points < [document.paper.width - 9.9, document.paper.height - 9.9]).all()


@pytest.mark.parametrize("solid", SOLIDS.values(), ids=SOLIDS)
def test_every_face_has_its_number(solid):
    document, _ = net_document([solid])
    assert {str(k + 1) for k in range(len(solid.faces))} <= set(texts(document))


def test_folds_are_as_long_as_the_edges():
    document, note = net_document([facing([BOX])])
    lengths = [np.linalg.norm(line.points[1] - line.points[0]) for line in strokes(document, "fold")]
    assert {round(float(length), 6) for length in lengths} == {25.0, 40.0, 60.0}
    assert note is None
    assert any("scale 1:1" in text for text in texts(document))


def test_centimetres_are_drawn_as_such():
    document, _ = net_document([facing([BOX / 10], depth=2.5, unit="cm")])
    lengths = [np.linalg.norm(line.points[1] - line.points[0]) for line in strokes(document, "fold")]
    assert max(lengths) == pytest.approx(60.0)


def test_a_solid_larger_than_the_paper_takes_several_sheets():
    document, note = net_document([facing([3 * L], depth=75.0)])
    assert 1 < len(document.sheets) <= 6
    assert note is None


def test_a_face_larger_than_a_sheet_comes_in_parts():
    document, _ = net_document([facing([6 * BOX], depth=30.0)])
    assert sum("part" in text for text in texts(document)) > 4
    assert any("row 2, column 2" in text for text in texts(document))


def test_what_would_take_too_many_sheets_is_drawn_smaller():
    document, note = net_document([facing([BOX], unit="m")])
    assert len(document.sheets) <= 40
    assert "drawn at scale 1:" in note


def test_without_a_real_size_the_scale_is_told():
    solid = facing([HOUSE], unit="px")
    document, note = net_document([solid])
    assert len(document.sheets) == 1
    assert "no real size is known: 100 px" in note
    assert note_of(solid, "net.pdf") == note
    assert note_of(solid, "stl") is None
    assert note_of(facing([HOUSE]), "net.pdf") is None


@pytest.mark.parametrize(
    "ring",
    [
        np.array([[0, 0], [40, 40], [40, 0], [0, 40.0]]),  # crosses itself
        np.array([[0, 0], [40, 0], [40, 0], [40, 40], [0, 40.0]]),  # an edge of no length
        np.array([[0, 0], [20, 0], [40, 0], [30, 0.0]]),  # no area
    ],
)
@pytest.mark.parametrize("unit", ["mm", "px"])
@pytest.mark.parametrize("format", ["net.svg", "views.svg", "worksheet.pdf", "scad", "build123d", "cadquery"])
def test_faces_that_are_none_do_no_harm(ring, unit, format):
    solid = facing([BOX[:1] + ring], unit=unit)
    assert encode(solid, format)


def test_several_solids_begin_on_sheets_of_their_own():
    document, _ = net_document([facing([BOX]), facing([L])])
    assert len(document.sheets) == 2


def test_layers_of_svg():
    root = ElementTree.fromstring(encode(facing([BOX]), "net.svg"))
    assert [g.get("id") for g in root.iter("{http://www.w3.org/2000/svg}g")] == ["cut", "fold", "fold_back", "text"]


def test_papers_that_there_are_not_are_refused():
    with pytest.raises(UsageError, match="a5"):
        encode(facing([BOX]), "net.pdf", paper="a5")
