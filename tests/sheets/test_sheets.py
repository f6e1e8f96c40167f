"""Sheets read back: SVG as XML, PDF by PDFium, DXF by ezdxf; sizes, layers and words are there."""

from __future__ import annotations

import io
from xml.etree import ElementTree

import numpy as np
import pytest

from sketch2shape.sheets import PAPERS, Document, Label, Layer, Round, Sheet, Stroke, document_dxf, pdf_bytes, svg_text
from sketch2shape.sheets.pdf import text_width

LAYERS = (Layer("cut", "#000000", 0.5), Layer("fold", "#0057b8", 0.3, (3.0, 1.5)), Layer("text", "#5b6470", 0.2))
SQUARE = np.array([[20.0, 20], [70, 20], [70, 60], [20, 60]])


def document(sheets=2, paper="a4"):
    items = (
        Stroke("cut", SQUARE, closed=True),
        Stroke("fold", SQUARE[:2] + 5),
        Round("cut", np.array([120.0, 100.0]), 15.0),
        Label("text", "50 % (a\\b) <&> m²", np.array([30.0, 150.0]), 4.0, "middle", 90.0),
    )
    return Document("A (test) <&>", PAPERS[paper], LAYERS, (Sheet(items),) * sheets)


def svg(text):
    return ElementTree.fromstring(text)


SVG = "{http://www.w3.org/2000/svg}"
INKSCAPE = "{http://www.inkscape.org/namespaces/inkscape}"


def test_svg_is_at_true_size_with_a_page_for_each_sheet():
    root = svg(svg_text(document()))
    assert (root.get("width"), root.get("height"), root.get("viewBox")) == ("430mm", "297mm", "0 0 430 297")
    assert len(list(root.iter(f"{INKSCAPE}page"))) == 2
    assert [view.get("viewBox") for view in root.iter(f"{SVG}view")] == ["0 0 210 297", "220 0 210 297"]


def test_svg_has_a_group_for_each_layer_over_all_sheets():
    groups = list(svg(svg_text(document())).iter(f"{SVG}g"))
    assert [group.get(f"{INKSCAPE}label") for group in groups] == ["cut", "fold", "text"]
    assert [len(group) for group in groups] == [4, 2, 2]
    assert groups[1].get("stroke-dasharray") == "3 1.5"
    assert groups[2][0].text == "50 % (a\\b) <&> m²"


def test_pdf_is_read_by_another_library():
    pdfium = pytest.importorskip("pypdfium2", reason="PDFium reads PDF back (extra `formats`)")
    pdf = pdfium.PdfDocument(pdf_bytes(document(3, "letter")))
    assert len(pdf) == 3
    assert pdf[0].get_size() == pytest.approx((612, 792))
    assert pdf.get_metadata_dict()["Title"] == "A (test) <&>"
    assert pdf[1].get_textpage().get_text_range() == "50 % (a\\b) <&> m²"
    shown = np.asarray(
        pdf[0].render(scale=10 * 25.4 / 72, grayscale=True).to_numpy()
    ).squeeze()  # ten dots a millimetre
    dark = np.argwhere(shown < 100)
    assert dark.min(axis=0) == pytest.approx([200, 200], abs=4)
    assert shown[1000, 1050] < 100  # on the circle
    assert shown[1000, 1200] > 200  # within it
    words = np.argwhere(shown[1200:1800, 200:400] < 160) + [1200, 200]  # running upward about y 150, beside x 30
    assert words[:, 0].mean() == pytest.approx(1500, abs=25)
    assert words[:, 1].max() < 320


def test_pdf_names_its_layers_and_every_object_is_where_the_table_says():
    data = pdf_bytes(document())
    for layer in LAYERS:
        assert b"/Type /OCG /Name (" + layer.name.encode() + b")" in data
    table = data[data.rindex(b"xref\n0 ") :].split(b"trailer")[0].splitlines()[3:]
    for number, row in enumerate(table, 1):
        assert data[int(row[:10]) :].startswith(b"%d 0 obj" % number)
    assert pdf_bytes(document()) == data


def test_widths_are_those_of_the_font():
    assert text_width("A", 0.718) == pytest.approx(0.667)
    assert text_width("~", 0.718) == pytest.approx(0.584)
    assert text_width("0123456789", 0.718) == pytest.approx(5.56)


def test_dxf_is_read_by_another_library():
    ezdxf = pytest.importorskip("ezdxf", reason="ezdxf reads DXF back (extra `readback`)")
    arrow = Stroke("cut", np.array([[0.0, 0], [4, 1], [4, -1]]), closed=True, filled=True)
    page = Document("a", PAPERS["a4"], LAYERS, (Sheet((*document().sheets[0].items, arrow)),))
    read = ezdxf.read(io.StringIO(document_dxf(page, "mm", 2.0)))
    assert read.units == 4
    assert not read.audit().errors
    square, line, circle, text, solid = read.modelspace()
    assert (square.dxf.layer, square.is_closed, line.dxf.layer) == ("CUT", True, "FOLD")
    assert tuple(square.vertices[0].dxf.location) == pytest.approx((40, 554, 0))
    assert (circle.dxf.radius, text.dxf.rotation, text.dxf.height) == (30, 90, 8)
    assert tuple(text.get_placement()[1]) == pytest.approx((60, 294, 0))
    corners = {tuple(point)[:2] for point in (solid.dxf.vtx0, solid.dxf.vtx1, solid.dxf.vtx2, solid.dxf.vtx3)}
    assert len(corners) == 3
