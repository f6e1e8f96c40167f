"""Lines of a page of a PDF: matrices, forms, turned pages, dashes; scans and pages of text stay pictures."""

import numpy as np
import pytest

from sketch2shape.reading.read import read_picture
from synthetic.hand import Stroke
from synthetic.pdf_files import MANNERS, _document

pytest.importorskip("pypdfium2")
CUBE = [np.array(p, float) for p in ([[50, 60], [250, 60]], [[250, 60], [250, 200]], [[250, 200], [50, 200]])]
CUBE += [np.array(p, float) for p in ([[50, 200], [50, 60]], [[50, 60], [90, 30]], [[250, 60], [290, 30]])]


@pytest.mark.parametrize(("name", "scale"), [("cairo", 1), ("office", 0.75), ("turned", 1)])
def test_lines_lie_where_the_page_shows_them(name, scale):
    data = MANNERS[f"pdf/{name}"]([Stroke(p) for p in CUBE], (320, 240), np.random.default_rng(0))
    drawing = read_picture(data).drawing
    assert drawing.size == (320 * scale, 240 * scale)
    read = np.array([line.points[[0, -1]] for line in drawing.lines[: len(CUBE)]])
    assert np.allclose(read, np.array(CUBE) * scale, atol=0.01)


def page(content):
    return read_picture(_document(content, "0 0 400 300"))


LINES = "".join(f"{x} 20 m {x} 280 l S\n" for x in range(20, 160, 20))


def test_curves_and_closed_paths():
    drawing = page(LINES + "200 100 m 200 155 300 155 300 100 c 300 50 l h S\n").drawing
    bent, straight = drawing.lines[-2:]
    assert (len(bent.points), bent.curved) == (17, True)
    assert straight.points.tolist() == [[300, 200], [300, 250], [200, 200]]


@pytest.mark.parametrize(
    ("dash", "dashed"), [("[3 2] 0 d", True), ("[3] 0 d", True), ("[] 0 d", False), ("[3 0] 0 d", False)]
)
def test_dashes(dash, dashed):
    assert page(f"{LINES}{dash} 200 100 m 300 100 l S\n").drawing.lines[-1].dashed is dashed


def test_a_page_of_text_with_a_rule_is_a_picture():
    assert page("20 20 m 380 20 l S BT /H 12 Tf 20 200 Td (words) Tj ET").drawing is None


def test_a_scan_with_marks_is_a_picture():
    scan = "q 400 0 0 300 0 0 cm BI /W 1 /H 1 /CS /G /BPC 8 ID \xff EI Q\n"
    assert page(scan + LINES).drawing is None


def test_marks_in_a_colour_that_is_not_seen_are_left_out():
    assert len(page(LINES + "1 G 200 100 m 300 100 l S").drawing.lines) == 7
