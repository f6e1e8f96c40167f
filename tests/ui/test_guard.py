from collections.abc import Iterator

import pytest
from starlette.testclient import TestClient

from sketch2shape.ui.guard import host_name


@pytest.mark.parametrize(
    ("host", "name"),
    [
        ("127.0.0.1:8765", "127.0.0.1"),
        ("LOCALHOST", "localhost"),
        ("[::1]:80", "[::1]"),
        ("[::1]", "[::1]"),
        ("localhost:", ""),
        ("localhost:80:80", "localhost:80"),
        ("localhost:8x", ""),
        ("localhost.evil.example", "localhost.evil.example"),
    ],
)
def test_the_name_in_a_host_header(host: str, name: str) -> None:
    assert host_name(host) == name


@pytest.mark.parametrize(
    "host", ["evil.example", "127.0.0.1.evil.example", "localhost:80@evil.example", "", "127.0.0.2"]
)
def test_other_names_are_not_served(app: TestClient, host: str) -> None:
    for path in ("/", "/app.js", "/about", "/no"):
        assert app.get(path, headers={"Host": host}).status_code == 421


@pytest.mark.parametrize("host", ["127.0.0.1", "localhost:9999", "[::1]:8765"])
def test_this_machine_is_served_under_its_names(app: TestClient, host: str) -> None:
    assert app.get("/", headers={"Host": host}).status_code == 200


@pytest.mark.parametrize(
    "headers",
    [
        {"Origin": "http://evil.example"},
        {"Origin": "null"},
        {"Origin": "http://127.0.0.1:1"},
        {"Sec-Fetch-Site": "cross-site"},
        {"Sec-Fetch-Site": "same-site"},
    ],
)
def test_posts_from_other_pages_are_refused(app: TestClient, headers: dict[str, str]) -> None:
    assert app.post("/api/lift", json={}, headers=headers).status_code == 403


def test_posts_from_the_own_page_pass(app: TestClient) -> None:
    headers = {"Origin": "http://127.0.0.1:8765", "Sec-Fetch-Site": "same-origin"}
    assert app.post("/api/lift", json={}, headers=headers).status_code == 400  # refused later: it is empty


def test_every_answer_carries_the_protecting_headers(app: TestClient) -> None:
    for path, headers in (("/", {}), ("/no", {}), ("/", {"Host": "evil.example"})):
        answer = app.get(path, headers=headers)
        assert answer.headers["x-content-type-options"] == "nosniff"
        assert "frame-ancestors 'none'" in answer.headers["content-security-policy"]
        assert "access-control-allow-origin" not in answer.headers


def test_a_body_longer_than_it_says_is_counted(app: TestClient) -> None:
    def chunks() -> Iterator[bytes]:  # sent chunked, so that no length is told
        for _ in range(40):
            yield b"x" * 2**15

    assert app.post("/api/reconstruct", content=chunks(), headers={"Content-Type": "image/png"}).status_code == 413


def test_no_web_sockets(app: TestClient) -> None:
    from starlette.websockets import WebSocketDisconnect

    with pytest.raises(WebSocketDisconnect), app.websocket_connect("/"):
        pass
