"""An app whose work is done in this process, and small pictures to send it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import cv2
import numpy as np
import pytest
from starlette.testclient import TestClient

from sketch2shape.ui.app import create_app

FRONT = [[100.0, 160.0], [300.0, 160.0], [300.0, 340.0], [100.0, 340.0]]
BACK = [[190.0, 100.0], [390.0, 100.0], [390.0, 280.0], [190.0, 280.0]]


class Here:
    """Workers that are no processes."""

    async def run(self, function: Callable[..., Any], *arguments: Any, seconds: float) -> Any:
        assert seconds > 0
        return function(*arguments)

    @property
    def waiting(self) -> int:
        return 0

    def close(self) -> None: ...


@pytest.fixture(scope="session")
def app() -> Iterator[TestClient]:
    with TestClient(create_app(workers=Here(), max_upload=2**20), base_url="http://127.0.0.1:8765") as client:
        yield client


@pytest.fixture(scope="session")
def box_png() -> bytes:
    pixels = np.full((440, 500, 3), 255, np.uint8)
    corners = [tuple(int(c) for c in p) for p in FRONT + BACK]
    for i in range(4):
        for a, b in ((i, (i + 1) % 4), (4 + i, 4 + (i + 1) % 4), (i, i + 4)):
            cv2.line(pixels, corners[a], corners[b], (20, 20, 20), 2, cv2.LINE_AA)
    return cv2.imencode(".png", pixels)[1].tobytes()


@pytest.fixture
def corrections() -> dict[str, Any]:
    return {
        "schema": "sketch2shape-corrections/1",
        "width": 500,
        "height": 440,
        "objects": [{"f1": FRONT, "f2": BACK, "projection": "oblique", "width": "40mm"}],
    }
