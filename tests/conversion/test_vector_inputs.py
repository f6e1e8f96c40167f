"""Vector drawings through the command, a folder of mixed inputs, every picture of a result, and the service."""

import json

import cv2
import numpy as np
import pytest
import trimesh
from sketches import DEPTH, HEXAGON, SQUARE, prism, same_object
from solid_lines import prism_lines, prism_strokes
from starlette.testclient import TestClient

import sketch2shape as s2s
from sketch2shape.command import main
from sketch2shape.reading.sheet import picture_of
from sketch2shape.ui.api import create_service


def svg(strokes, size=(480, 400)):
    paths = "".join(f'<path d="M{a[0]} {a[1]}L{b[0]} {b[1]}" stroke="black"/>' for a, b in strokes)
    return f'<svg xmlns="http://www.w3.org/2000/svg" width="{size[0]}" height="{size[1]}">{paths}</svg>'


@pytest.fixture
def here(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "in").mkdir()
    cv2.imwrite("in/a.png", prism(SQUARE, SQUARE + DEPTH))
    (tmp_path / "in" / "b.svg").write_text(svg(prism_strokes(HEXAGON, HEXAGON + DEPTH)))
    strokes = [(stroke - [300, 300]).tolist() for stroke in prism_strokes(SQUARE, SQUARE + DEPTH)]
    (tmp_path / "in" / "c.json").write_text(json.dumps({"strokes": strokes}))
    return tmp_path


def test_a_drawing_as_svg_becomes_a_mesh_and_is_never_replaced(here):
    before = (here / "in" / "b.svg").read_bytes()
    assert main(["in/b.svg", "-o", "b.stl", "--json", "--overlay", "b.png", "-q"]) == 0
    assert trimesh.load("b.stl").is_watertight
    report = json.loads((here / "b.json").read_text())
    assert (report["width"], report["height"]) == (480, 400)
    assert "drawing" not in report
    assert main(["in/b.svg", "-o", "in/b.svg", "-q"]) == 2
    assert (here / "in" / "b.svg").read_bytes() == before


def test_a_folder_holds_pictures_and_drawings_and_json_only_by_name(here):
    assert main(["in", "-o", "out", "--json", "--jobs", "1", "-q"]) == 0
    assert sorted(p.name for p in (here / "out").glob("*.obj")) == ["a.obj", "b.obj"]
    assert main(["in/c.json", "-o", "c.obj", "-q"]) == 0


def test_the_report_tells_how_to_go_back_to_own_coordinates(here):
    assert main(["in/c.json", "-o", "c.json", "-q"]) == 0
    report = json.loads((here / "c.json").read_text())
    told, found = report["drawing"], report["objects"][0]
    own = [np.array(told["origin"]) + np.array(found[face]) / told["scale"] for face in ("f1", "f2")]
    assert same_object(s2s.TwoFaceObject(*own), SQUARE - 300, SQUARE + DEPTH - 300, 0.5)


@pytest.mark.parametrize("product", ["overlay.png", "stages.png", "preview.png", "html", "svg", "step"])
def test_all_that_is_made_of_pictures_is_made_of_drawings(here, product):
    result = s2s.reconstruct(picture_of(prism_lines(SQUARE, SQUARE + DEPTH, "dashed"), page=(480, 400)))
    assert result.export(f"x.{product}").stat().st_size > 300


def test_the_overlay_lies_on_the_drawing(here):
    picture = picture_of([line.mapped(np.array([-900.0, -500.0]), 2.0) for line in prism_lines(SQUARE, SQUARE + DEPTH)])
    result = s2s.reconstruct(picture)
    seen = s2s.reconstruct(picture.pixels).objects[0].vertices
    gap = np.linalg.norm(result.objects[0].vertices[:, None] / picture.reduction - seen[None], axis=2).min(axis=1)
    assert gap.max() < 2.5


def test_the_service_takes_strokes(here):
    class Here:
        async def run(self, function, *arguments, **_limits):
            return function(*arguments)

        waiting = 0

        def close(self): ...

    with TestClient(create_service(workers=Here())) as client:
        body = (here / "in" / "c.json").read_bytes()
        answer = client.post("/v1/reconstruct", content=body, headers={"Content-Type": "application/json"})
        assert answer.status_code == 200
        assert answer.json()["status"] == "ok"
        bad = client.post("/v1/reconstruct", content=b'{"strokes": 5}', headers={"Content-Type": "application/json"})
        assert bad.status_code == 415


def test_many_inputs_may_be_drawings(here):
    results = list(s2s.reconstruct_many(["in/a.png", "in/b.svg", b'{"strokes": 5}'], jobs=1))
    assert [r.error is None for r in results] == [True, True, False]
