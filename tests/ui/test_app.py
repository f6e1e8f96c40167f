import base64
import io
import re
from dataclasses import replace
from typing import Any

import pytest
import trimesh
from starlette.testclient import TestClient

from sketch2shape.model import Answer, Picture
from sketch2shape.pipeline import reconstruct
from sketch2shape.ui.app import PAGE_MODULES
from sketch2shape.ui.examples import EXAMPLES, example_png
from sketch2shape.writing.formats import FORMATS

from .here import BACK, FRONT

PNG = {"Content-Type": "image/png"}


def test_the_page_and_its_parts_are_served(app: TestClient) -> None:
    page = app.get("/").text
    for part in ("/style.css", "/icon.svg", "/viewer.js", "/app.js"):
        assert part in page
        assert app.get(part).status_code == 200
    for module in PAGE_MODULES:
        assert app.get(f"/{module}.js").headers["content-type"].startswith("text/javascript")


def test_every_script_that_a_script_loads_is_served(app: TestClient) -> None:
    asked = {m for name in PAGE_MODULES for m in re.findall(r'from "\./(\w+)\.js"', app.get(f"/{name}.js").text)}
    assert asked == {*PAGE_MODULES} - {"app"}


def test_scripts_are_short_and_load_each_other_in_no_circle(app: TestClient) -> None:
    text = {name: app.get(f"/{name}.js").text for name in PAGE_MODULES}
    assert [name for name, script in text.items() if script.count("\n") >= 400] == []
    waiting = {name: set(re.findall(r'from "\./(\w+)\.js"', script)) for name, script in text.items()}
    while ready := {name for name, needs in waiting.items() if not needs}:
        waiting = {name: needs - ready for name, needs in waiting.items() if name not in ready}
    assert waiting == {}


def test_nothing_is_loaded_from_elsewhere_and_the_page_is_small(app: TestClient) -> None:
    size = 0
    for part in ("/", "/style.css", "/viewer.js", "/icon.svg", *(f"/{name}.js" for name in PAGE_MODULES)):
        text = app.get(part).text.replace("http://www.w3.org/2000/svg", "")
        assert "http:" not in text
        assert "https:" not in text
        size += len(text)
    assert size < 250_000
    policy = app.get("/").headers["content-security-policy"]
    assert "default-src 'none'" in policy
    assert "unsafe" not in policy


def test_strokes_become_a_solid_in_their_own_coordinates(app: TestClient) -> None:
    pairs = [(a, (a + 1) % 4) for a in range(4)]
    lines = [[p[a], p[b]] for p in (FRONT, BACK) for a, b in pairs] + [[f, b] for f, b in zip(FRONT, BACK, strict=True)]
    moved = [{"points": [[x - 500, y - 300, 7, 0.5] for x, y in line], "dashed": False} for line in lines]
    found = app.post("/api/sketch", json={"strokes": moved}).json()
    assert found["problem"] is None
    corners = {(round(x + 500), round(y + 300)) for ring in ("f1", "f2") for x, y in found["objects"][0][ring]}
    assert corners == {(round(x), round(y)) for x, y in FRONT + BACK}
    assert len(found["facts"][0]["size"]) == 3


def test_a_photo_of_a_tilted_page_is_the_same_solid_when_the_page_asks_again(app: TestClient) -> None:
    found = app.post("/api/reconstruct", content=example_png("photo"), headers=PNG).json()
    told = {k: v for k, v in found["objects"][0].items() if k != "confidence"}
    assert told["noise"] > 0
    sheet = {"width": found["width"], "height": found["height"]}
    again = app.post("/api/lift", json={**sheet, "objects": [told]}).json()
    assert again["facts"][0]["size"] == pytest.approx(found["facts"][0]["size"], rel=0.005)
    bare = {k: told[k] for k in ("f1", "f2", "holes")}
    flat = app.post("/api/lift", json={**sheet, "objects": [bare]}).json()
    assert flat["facts"][0]["size"] != pytest.approx(found["facts"][0]["size"], rel=0.01)


def test_an_answer_that_is_rather_wrong_is_shown_as_a_guess(
    app: TestClient, box_png: bytes, monkeypatch: pytest.MonkeyPatch
) -> None:
    def unsure(picture: Picture) -> Answer:
        answer = reconstruct(picture)
        return replace(answer, objects=tuple(replace(obj, confidence=0.3) for obj in answer.objects))

    monkeypatch.setattr("sketch2shape.pipeline.reconstruct", unsure)
    found = app.post("/api/reconstruct", content=box_png, headers=PNG).json()
    assert len(found["objects"]) == 1
    assert "0.30" in found["problem"]["error"]
    assert found["problem"]["left"] == []


def test_vague_proportions_make_no_guess_of_what_was_found(
    app: TestClient, box_png: bytes, monkeypatch: pytest.MonkeyPatch
) -> None:
    def vague(picture: Picture) -> Answer:
        answer = reconstruct(picture)
        return replace(answer, solids=tuple(replace(solid, confidence=0.3) for solid in answer.solids))

    monkeypatch.setattr("sketch2shape.pipeline.reconstruct", vague)
    found = app.post("/api/reconstruct", content=box_png, headers=PNG).json()
    assert found["problem"] is None
    assert found["facts"][0]["confidence"] <= 0.3


def test_strokes_that_show_no_solid_give_the_best_guess_or_nothing(app: TestClient) -> None:
    line = {"points": [[0, 0], [100, 0]]}
    found = app.post("/api/sketch", json={"strokes": [line]}).json()
    assert found["objects"] == []
    assert found["problem"]["error"]


def test_the_readings_of_an_object_are_told_as_solids(app: TestClient, corrections: dict[str, Any]) -> None:
    del corrections["objects"][0]["projection"]
    asked = {"corrections": corrections, "object": 0}
    readings = app.post("/api/readings", json=asked).json()["readings"]
    assert [r["number"] for r in readings] == list(range(1, len(readings) + 1))
    assert len(readings) >= 2
    assert all(len(r["solid"]["vertices"]) == 8 and r["size"][0] == pytest.approx(40) for r in readings)
    corrections["objects"][0]["reading"] = 2
    assert app.post("/api/lift", json=corrections).json()["facts"][0]["size"] == pytest.approx(readings[1]["size"])


def test_objects_of_one_sheet_have_one_scale(app: TestClient, corrections: dict[str, Any]) -> None:
    other = {"f1": [[x * 0.5 + 600, y * 0.5] for x, y in FRONT], "f2": [[x * 0.5 + 600, y * 0.5] for x, y in BACK]}
    corrections["objects"].append({**other, "projection": "oblique"})
    first, second = app.post("/api/lift", json=corrections).json()["facts"]
    assert second["unit"] == "mm"
    assert second["size"] == pytest.approx([s / 2 for s in first["size"]], rel=1e-3)


def test_what_the_page_offers(app: TestClient) -> None:
    about = app.get("/about").json()
    assert [f["name"] for f in about["formats"]] == list(FORMATS)
    assert [e["name"] for e in about["examples"]] == list(EXAMPLES)
    assert set(about["reads"]) == {"heic", "pdf", "svg"}
    assert app.get("/queue").json() == {"waiting": 0}


def test_a_drawing_becomes_objects_a_solid_and_stages(app: TestClient, box_png: bytes) -> None:
    found = app.post("/api/reconstruct", content=box_png, headers={**PNG, "X-Name": "my%20box.png"}).json()
    assert (found["name"], found["width"], found["height"]) == ("my box.png", 500, 440)
    assert found["problem"] is None
    assert len(found["objects"][0]["f1"]) == 4
    assert len(found["solid"]["vertices"]) == 8
    assert len(found["corners"]) >= 8
    assert [s["title"] for s in found["stages"]][-1] == "Solid"
    assert found["picture"].startswith("data:image/")


def test_a_picture_without_an_object_says_why_and_is_shown(app: TestClient) -> None:
    import cv2
    import numpy as np

    blank = cv2.imencode(".png", np.full((60, 80, 3), 255, np.uint8))[1].tobytes()
    found = app.post("/api/reconstruct", content=blank, headers=PNG).json()
    assert found["objects"] == []
    assert "blank" in found["problem"]["error"]
    assert found["picture"]


def test_corrections_are_lifted(app: TestClient, corrections: dict[str, Any]) -> None:
    found = app.post("/api/lift", json=corrections).json()
    fact = found["facts"][0]
    assert fact["unit"] == "mm"
    assert fact["size"][0] == pytest.approx(40)
    assert fact["projection"] == "oblique"


def test_moving_a_vertex_changes_the_volume(app: TestClient, corrections: dict[str, Any]) -> None:
    del corrections["objects"][0]["width"]
    before = app.post("/api/lift", json=corrections).json()["facts"][0]["volume"]
    entry = corrections["objects"][0]
    entry["f1"], entry["f2"] = [[*p] for p in entry["f1"]], [[*p] for p in entry["f2"]]
    entry["f1"][0][1] -= 40
    entry["f2"][0][1] -= 40
    after = app.post("/api/lift", json=corrections).json()["facts"][0]["volume"]
    assert after > before * 1.05


@pytest.mark.parametrize("form", list(FORMATS))
def test_every_format_is_written(app: TestClient, corrections: dict[str, Any], box_png: bytes, form: str) -> None:
    sent = {**corrections, "picture": base64.b64encode(box_png).decode(), "source": "box.png"}
    answer = app.post(f"/api/export/{form}", json=sent)
    assert answer.status_code == 200
    assert len(answer.content) > 100


@pytest.mark.parametrize("form", ["stl", "obj", "ply", "glb", "off"])
def test_each_format_is_a_watertight_mesh(app: TestClient, corrections: dict[str, Any], form: str) -> None:
    answer = app.post(f"/api/export/{form}", json=corrections)
    mesh = trimesh.load(io.BytesIO(answer.content), file_type=form, force="mesh")
    mesh.merge_vertices(merge_norm=True, merge_tex=True)
    assert mesh.is_watertight
    assert mesh.volume > 0


def test_3mf_is_served(app: TestClient, corrections: dict[str, Any]) -> None:
    assert app.post("/api/export/3mf", json=corrections).content.startswith(b"PK")


def test_loose_vertices_are_ordered_and_paired(app: TestClient) -> None:
    front = [[0, 0], [100, 80], [100, 0], [0, 80]]
    back = [[130, -20], [30, 60], [30, -20], [130, 60]]
    found = app.post("/api/connect", json={"front": front, "back": back}).json()
    assert [[b - a for a, b in zip(p, q, strict=True)] for p, q in zip(found["f1"], found["f2"], strict=True)] == [
        [30, -20]
    ] * 4
    sides = [abs(a[0] - b[0]) + abs(a[1] - b[1]) for a, b in zip(found["f1"], found["f1"][1:], strict=False)]
    assert sorted(sides)[-1] <= 100  # no diagonal


def test_stages_are_drawn_again_for_corrections(app: TestClient, box_png: bytes, corrections: dict[str, Any]) -> None:
    body = {"picture": base64.b64encode(box_png).decode(), "corrections": corrections}
    stages = app.post("/api/stages", json=body).json()["stages"]
    assert len(stages) == 8


@pytest.mark.parametrize(
    ("method", "path", "options", "status"),
    [
        ("POST", "/api/reconstruct", {"content": b"no picture", "headers": PNG}, 415),
        ("POST", "/api/reconstruct", {"content": b"", "headers": PNG}, 415),
        ("POST", "/api/reconstruct", {"content": b"x" * (2**20 + 1), "headers": PNG}, 413),
        ("POST", "/api/reconstruct", {"files": {"file": b"x"}}, 415),
        ("POST", "/api/reconstruct", {"data": {"path": "/etc/passwd"}}, 415),
        ("POST", "/api/lift", {"content": b"{", "headers": {"Content-Type": "application/json"}}, 400),
        ("POST", "/api/lift", {"json": []}, 400),
        ("POST", "/api/lift", {"json": {}}, 400),
        ("POST", "/api/lift", {"content": b"[" * 10**5, "headers": {"Content-Type": "application/json"}}, 400),
        ("POST", "/api/export/exe", {"json": {}}, 400),
        ("POST", "/api/connect", {"json": {"front": [[0, 0]], "back": "x"}}, 400),
        ("POST", "/api/stages", {"json": {"picture": "%%%"}}, 400),
        ("POST", "/api/sketch", {"json": {"strokes": "x"}}, 415),
        ("POST", "/api/sketch", {"json": {"strokes": [{"points": [[0, "x"]]}]}}, 415),
        ("POST", "/api/sketch", {"json": {"strokes": [{"points": [[0, 1e300], [1, 2]]}]}}, 415),
        ("POST", "/api/readings", {"json": {"corrections": {"objects": []}, "object": 0}}, 400),
        ("POST", "/api/readings", {"json": {"object": -1}}, 400),
        ("GET", "/api/lift", {}, 405),
        ("GET", "/api/nothing", {}, 404),
        ("GET", "/examples/..%2f..%2fpyproject.png", {}, 404),
        ("GET", "/page/app.js", {}, 404),
        ("DELETE", "/", {}, 405),
    ],
)
def test_what_cannot_be_done_is_refused_in_words(
    app: TestClient, method: str, path: str, options: dict[str, Any], status: int
) -> None:
    answer = app.request(method, path, **options)
    assert answer.status_code == status
    assert answer.json()["error"]
    assert "Traceback" not in answer.text


def test_examples_are_served(app: TestClient) -> None:
    assert app.get("/examples/wireframe.png").content.startswith(b"\x89PNG")
