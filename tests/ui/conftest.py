"""An app whose work is done in this process, one that a browser opens, and small pictures to send them."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest
from selenium.common.exceptions import WebDriverException
from selenium.webdriver import Chrome
from selenium.webdriver.common.by import By
from starlette.testclient import TestClient

from sketch2shape.ui.app import create_app

from .browsing import wait
from .chromium import start_browser
from .here import BACK, FRONT, Here
from .server import Address, start_app


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


@pytest.fixture(scope="module")
def address() -> Iterator[Address]:
    with start_app() as where:
        yield where


@pytest.fixture(scope="module")
def downloads(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("downloads")


@pytest.fixture(scope="module")
def browser(downloads: Path) -> Iterator[Chrome]:
    with ExitStack() as stack:
        try:
            chrome = stack.enter_context(start_browser(downloads))
        except WebDriverException as error:
            pytest.skip(f"the browser does not start here: {error.msg}")
        yield chrome


@pytest.fixture
def page(browser: Chrome, address: Address) -> Chrome:
    browser.get(address)
    wait(lambda: browser.find_elements(By.CSS_SELECTOR, "#gallery button"))
    return browser


@pytest.fixture
def box_file(box_png: bytes, tmp_path: Path) -> Path:
    path = tmp_path / "box.png"
    path.write_bytes(box_png)
    return path
