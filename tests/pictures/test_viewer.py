import json
import re

from sketch2shape.pictures import viewer
from sketch2shape.pictures.notebook import notebook_html, notebook_png
from sketch2shape.pictures.viewer import facts, shape
from sketch2shape.pipeline.result import Result


def test_the_page_loads_nothing_from_anywhere(tube: Result) -> None:
    page = re.sub(r"data:image/png;base64,[^\"]+", "data:", viewer(tube))
    assert not re.search(r"https?:|//[a-z]|@import|<link", page)
    assert "default-src 'none'" in page
    assert set(re.findall(r'(?:src|href)="([^"]*)', page)) == {"data:"}


def test_the_page_holds_every_vertex_and_edge(notched: Result) -> None:
    page = viewer(notched)
    data = json.loads(re.search(r"new SolidView\([^,]+, (\{.*\})\);", page)[1])
    assert len(data["vertices"]) == 16
    assert len(data["edges"]) == 24
    assert data == json.loads(json.dumps(shape(notched)))


def test_a_name_cannot_become_markup(box: Result) -> None:
    page = viewer(box, "</title><script>alert(1)</script>")
    assert "<script>alert" not in page


def test_the_same_input_gives_the_same_page(box: Result) -> None:
    assert viewer(box) == viewer(box)


def test_the_facts_are_those_of_the_object(box: Result, nothing: Result) -> None:
    told = dict(facts(box))
    assert (told["Vertices"], told["Edges"], told["Faces"]) == ("8", "12", "6")
    assert told["Size"] == "200 × 180 × 150 px"
    assert dict(facts(nothing)) == {"Status": "no two-face object found"}


def test_a_notebook_gets_a_frame_and_a_picture(box: Result) -> None:
    html = notebook_html(box)
    assert html.startswith("<iframe sandbox=")
    assert "<script>" not in html  # all markup of the page is inside the attribute, escaped
    assert notebook_png(box).startswith(b"\x89PNG")


def test_a_result_shows_itself(box: Result, nothing: Result) -> None:
    assert box._repr_html_() == notebook_html(box)
    assert box._repr_png_() == notebook_png(box)
    assert "no two-face object found" in nothing._repr_html_()


def test_a_name_that_is_no_utf8_is_shown(box: Result) -> None:
    page = viewer(box, b"caf\xe9.png".decode("utf-8", "surrogateescape"))
    assert "caf\ufffd.png" in page.encode("utf-8").decode()
