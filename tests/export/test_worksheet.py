"""Worksheets: what is asked on the first sheet is answered on the second, and right."""

from __future__ import annotations

import re

import numpy as np
import pytest
import shapely
from export.upright import BOX, CURVED, HOUSE, NOTCH, L, facing
from solids.bodies import BODIES

from sketch2shape.export import encode, note_of
from sketch2shape.export.worksheet import worksheet_document
from sketch2shape.sheets import Label, Stroke, text_width

SOLIDS = {
    "box": facing([BOX]),
    "L with a hole": facing([L, NOTCH]),
    "frustum": facing([HOUSE], scale=0.5),
    "pyramid": facing([HOUSE], scale=0.0, along="up"),
    "boss": BODIES["boss"][0],
    **CURVED,
}
each = pytest.mark.parametrize("solid", SOLIDS.values(), ids=SOLIDS)


def labels(sheet, layer):
    return [item.text for item in sheet.items if isinstance(item, Label) and item.layer == layer]


def said(texts, sign):
    """The number after "V = ... = " or "S = ... = "."""
    line = next(text for text in texts if text.startswith(f"{sign} = "))
    return float(re.search(r"= ([\d.]+) \S+$", line)[1])


@each
def test_volume_and_surface_are_told_on_the_second_sheet_alone(solid):
    first, second = worksheet_document([solid])[0].sheets
    assert labels(first, "solution") == []
    answers = labels(second, "solution")
    assert said(answers, "V") == pytest.approx(solid.volume, rel=1e-3)
    assert said(answers, "S") == pytest.approx(solid.area, rel=1e-3)
    assert labels(first, "dimensions") == labels(second, "dimensions")


@each
def test_the_way_to_the_volume_leads_there(solid):
    text = " ".join(labels(worksheet_document([solid])[0].sheets[1], "solution"))
    given = " ".join(
        line for line in labels(worksheet_document([solid])[0].sheets[1], "solution") if "=" not in line[:4]
    )
    numbers = {name: float(value) for name, value in re.findall(r"\b([Aah]) = ([\d.]+)", given)}
    if "a" in numbers:
        mean = numbers["A"] + numbers["a"] + np.sqrt(numbers["A"] * numbers["a"])
        assert numbers["h"] / 3 * mean == pytest.approx(solid.volume, rel=2e-3)
    elif "A · h / 3" in text:
        assert numbers["A"] * numbers["h"] / 3 == pytest.approx(solid.volume, rel=2e-3)
    elif "A" in numbers:
        assert numbers["A"] * numbers["h"] == pytest.approx(solid.volume, rel=2e-3)


@each
@pytest.mark.parametrize("paper", ["a4", "letter"])
def test_nothing_leaves_the_paper_and_lengths_do_not_cover_each_other(solid, paper):
    document, _ = worksheet_document([solid], paper)
    page = shapely.box(10, 10, document.paper.width - 10, document.paper.height - 10)
    for sheet in document.sheets:
        boxes = []
        for item in sheet.items:
            if isinstance(item, Stroke):
                assert page.contains(shapely.MultiPoint(item.points))
            elif isinstance(item, Label):
                width = text_width(item.text, item.height)
                left = item.at[0] - {"start": 0.0, "middle": 0.5, "end": 1.0}[item.anchor] * width
                box = shapely.box(left, item.at[1] - item.height, left + width, item.at[1])
                assert page.contains(box), item.text
                assert not any(box.intersects(other) for other in boxes), item.text
                boxes.append(box)


def test_every_length_of_an_l_is_there():
    sheet = worksheet_document([facing([L])])[0].sheets[0]
    assert set(labels(sheet, "dimensions")) == {"60", "45", "15", "40", "25"}
    assert {"visible", "hidden"} <= {item.layer for item in sheet.items}


def test_counts():
    answers = labels(worksheet_document([facing([BOX])])[0].sheets[1], "solution")
    assert "6 faces, 12 edges, 8 corners" in answers
    answers = labels(worksheet_document([CURVED["cone"]])[0].sheets[1], "solution")
    assert "2 faces, 1 edge, 1 corner" in answers


def test_the_drawing_is_the_one_that_was_read(drawings):
    from sketch2shape import reconstruct

    result = reconstruct(drawings / "hand_removed/000.png", lift={"width": "60mm"})
    sheet = worksheet_document(result.solids)[0].sheets[0]
    points = np.concatenate(
        [i.points for i in sheet.items if isinstance(i, Stroke) and i.layer in ("visible", "hidden")]
    )
    drawn = result.objects[0].vertices
    scale = np.ptp(points, axis=0) / np.ptp(drawn, axis=0)
    assert scale[0] == pytest.approx(scale[1], rel=0.03)


def test_pixels_are_told_as_units():
    solid = facing([HOUSE], unit="px")
    assert "no real size" in note_of(solid, "worksheet.pdf")
    assert any("All lengths are in units" in text for text in labels(worksheet_document([solid])[0].sheets[0], "text"))
    assert note_of(facing([HOUSE]), "worksheet.pdf") is None


def test_another_library_reads_the_words():
    pdfium = pytest.importorskip("pypdfium2", reason="PDFium reads PDF back (extra `formats`)")
    pdf = pdfium.PdfDocument(encode(facing([BOX]), "worksheet.pdf"))
    first, second = (page.get_textpage().get_text_range() for page in pdf)
    assert "What is its volume?" in first
    assert "60000 mm³" not in first
    assert "V = A · h = 60000 mm³" in second
