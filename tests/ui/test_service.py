"""The HTTP service for programs."""

from __future__ import annotations

import json
import subprocess
import sys
import urllib.request
from collections.abc import Iterator

import pytest
import trimesh
from starlette.testclient import TestClient

from sketch2shape import __version__
from sketch2shape.export import FORMATS
from sketch2shape.pipeline.products import SUFFIXES
from sketch2shape.ui.api import create_service
from sketch2shape.ui.form import file_of
from sketch2shape.ui.guard import Refusal
from sketch2shape.ui.openapi import MEDIA, OPTIONS

from .here import Here

PNG = {"Content-Type": "image/png"}


AT = "/v1/reconstruct"


@pytest.fixture(scope="module")
def service() -> Iterator[TestClient]:
    with TestClient(create_service(workers=Here(), max_upload=2**20)) as client:
        yield client


def test_health_and_description(service: TestClient) -> None:
    assert service.get("/health").json() == {"status": "ok", "version": __version__}
    described = service.get("/openapi.json").json()
    assert described["openapi"].startswith("3.1")
    asked = described["paths"][AT]["post"]
    assert {p["name"] for p in asked["parameters"]} == {"format", *OPTIONS}
    assert {"200", "400", "413", "415", "422", "503"} <= set(asked["responses"])


def test_every_product_has_a_media_type() -> None:
    assert set(MEDIA) == {*FORMATS, *SUFFIXES}


def test_a_picture_becomes_the_report_or_a_file(service: TestClient, box_png: bytes) -> None:
    report = service.post(AT, content=box_png, headers=PNG).json()
    assert (report["schema"], report["status"]) == ("sketch2shape/1", "ok")
    answer = service.post(f"{AT}?format=stl&width=40mm", content=box_png, headers=PNG)
    assert answer.headers["content-type"] == "model/stl"
    mesh = trimesh.load(trimesh.util.wrap_as_stream(answer.content), file_type="stl")
    assert mesh.is_watertight
    assert service.post(f"{AT}?format=overlay", content=box_png, headers=PNG).content.startswith(b"\x89PNG")


def test_a_form_with_a_file(service: TestClient, box_png: bytes) -> None:
    for field in ("file", "picture"):
        answer = service.post(f"{AT}?format=off", files={field: ("my box.png", box_png, "image/png")})
        assert answer.status_code == 200
        assert answer.content.startswith(b"OFF")


def test_what_is_wrong_is_said(service: TestClient, box_png: bytes) -> None:
    def status(query: str, content: bytes = box_png, kind: str = "image/png") -> tuple[int, str]:
        answer = service.post(AT + query, content=content, headers={"Content-Type": kind})
        assert answer.json()["advice"]
        return answer.status_code, answer.json()["error"]

    assert status("?format=xyz") == (400, "no format is called 'xyz'")
    assert status("?widht=4") == (400, "there is no option 'widht'")
    assert status("?width=wide")[0] == 400
    assert status("?min_confidence=high")[0] == 400
    assert status("", b"text")[0] == 415
    assert status("", kind="text/html")[0] == 415
    assert status("", bytes(2**20 + 1))[0] == 413
    assert status("?min_confidence=1")[0] == 422
    assert status("", kind="multipart/form-data")[0] == 400
    assert service.get(AT).status_code == 405
    assert service.get("/").status_code == 404


def test_forms_are_read_byte_by_byte() -> None:
    content = b"\r\n\x00--b\r\n\r\n--c--"
    head = b'Content-Disposition: form-data; name="file"; filename="a.png"\r\n\r\n'
    other = b'--bound\r\nContent-Disposition: form-data; name="note"\r\n\r\nhello\r\n'
    body = other + b"--bound\r\n" + head + content + b"\r\n--bound--\r\n"
    assert file_of(body, 'multipart/form-data; boundary="bound"') == content
    assert file_of(body, "multipart/form-data; boundary=bound; charset=x") == content
    for wrong in (other + b"--bound--\r\n", b"", b"--bound"):
        with pytest.raises(Refusal):
            file_of(wrong, "multipart/form-data; boundary=bound")


def test_only_names_that_are_served_are_answered(box_png: bytes) -> None:
    with TestClient(create_service(workers=Here(), names=frozenset({"a.org"})), base_url="http://b.org") as client:
        assert client.get("/health").status_code == 421
        assert client.get("/health", headers={"Host": "a.org:80"}).status_code == 200


def test_the_command_serves_until_it_is_stopped(box_png: bytes) -> None:
    call = [sys.executable, "-m", "sketch2shape", "serve", "--port", "0", "--workers", "1"]
    with subprocess.Popen(call, stdout=subprocess.PIPE, text=True) as server:
        try:
            host, port = json.loads(server.stdout.readline())["listening"]
            request = urllib.request.Request(f"http://{host}:{port}{AT}?format=obj", box_png, PNG)
            with urllib.request.urlopen(request, timeout=120) as answer:
                assert answer.read().count(b"\nv ") == 8
        finally:
            server.terminate()
            server.wait(30)


@pytest.mark.parametrize("words", [["--port", "70000"], ["--workers", "0"], ["--timeout", "-1"]])
def test_impossible_settings_are_refused(words: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    from sketch2shape.command.parser import main

    assert main(["serve", *words]) == 2
    assert "must be positive" in capsys.readouterr().err
