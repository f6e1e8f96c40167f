"""What tests of the page in a browser do again and again: wait, ask the page, upload, drag, draw."""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any, TypeAlias

import cv2
import numpy as np
import pytest
from selenium.webdriver import ActionChains, Chrome
from selenium.webdriver.common.by import By

from .chromium import missing

needs_browser = pytest.mark.skipif(missing() is not None, reason=str(missing()))

#: a box on the drawing pad, from its middle, pixels of the screen
FRONT = [(-150, -60), (50, -60), (50, 110), (-150, 110)]
SHIFT = (90, -70)

Place: TypeAlias = tuple[int, int]


def wait(check: Callable[[], Any], seconds: float = 120) -> Any:
    """The first true answer of `check`."""
    end = time.monotonic() + seconds
    while True:
        answer = check()
        if answer:
            return answer
        assert time.monotonic() < end, "it did not happen in time"
        time.sleep(0.05)


def read(page: Chrome, css: str, what: str = "textContent") -> str:
    """A property of an element, asked for in one go, since the page may paint in between."""
    return str(page.execute_script("return document.querySelector(arguments[0])?.[arguments[1]] ?? ''", css, what))


def message(page: Chrome) -> str:
    return read(page, "#message")


def volume(page: Chrome) -> float:
    return float(page.execute_script("return document.getElementById('facts').dataset.volume || 0"))


def painted(page: Chrome) -> None:
    """Let the page paint what it has been told, and again for the sizes that gave its parts."""
    page.execute_async_script("const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(done))")


def upload(page: Chrome, path: Path) -> None:
    page.find_element(By.ID, "file").send_keys(str(path))
    wait(lambda: path.name in message(page) and "Looking" not in message(page) and volume(page))
    painted(page)


def selector(face: int, index: int) -> str:
    name = json.dumps({"object": 0, "ring": 0, "face": face, "index": index}, separators=(",", ":"))
    return f"[data-name='{name}'] .spot"


def vertex(page: Chrome, face: int, index: int) -> Any:
    return page.find_element(By.CSS_SELECTOR, selector(face, index))


def place(page: Chrome, face: int, index: int) -> tuple[float, float]:
    """Where a vertex is, pixels of the picture."""
    ask = "const s = document.querySelector(arguments[0]); return [+s.getAttribute('cx'), +s.getAttribute('cy')]"
    x, y = page.execute_script(ask, selector(face, index))
    return x, y


def press(page: Chrome, face: int, index: int, *keys: str) -> None:
    """Press keys on a vertex that has the focus."""
    page.execute_script("document.querySelector(arguments[0]).parentNode.focus()", selector(face, index))
    for key in keys:
        ActionChains(page).send_keys(key).perform()


def downloaded(folder: Path, name: str) -> Path:
    file = folder / name
    wait(lambda: file.exists() and file.stat().st_size and not list(folder.glob("*.crdownload")))
    return file


def drag(page: Chrome, element: Any, dx: int, dy: int) -> None:
    ActionChains(page, duration=20).move_to_element(element).click_and_hold().move_by_offset(
        dx // 2, dy // 2
    ).move_by_offset(dx - dx // 2, dy - dy // 2).release().perform()


def draw_line(page: Chrome, start: Place, end: Place) -> None:
    """Draw a line on the sheet, pixels from its middle."""
    pad = page.find_element(By.ID, "pad")
    ActionChains(page, duration=10).move_to_element_with_offset(
        pad, *start
    ).click_and_hold().move_to_element_with_offset(pad, *end).release().perform()


def draw_lines(page: Chrome, lines: Iterable[tuple[Place, Place]]) -> None:
    """Draw lines on a new sheet."""
    page.find_element(By.ID, "draw").click()
    for start, end in lines:
        draw_line(page, start, end)


def draw_box(page: Chrome) -> None:
    back = [(x + SHIFT[0], y + SHIFT[1]) for x, y in FRONT]
    rings = [[ring[i], ring[(i + 1) % 4]] for i in range(4) for ring in (FRONT, back)]
    draw_lines(page, [(a, b) for a, b in [*rings, *zip(FRONT, back, strict=True)]])


def draw_beginning(page: Chrome) -> None:
    """The front of a box, and one edge that leaves it."""
    (x, y), (dx, dy) = FRONT[1], SHIFT
    draw_lines(page, [*((FRONT[i], FRONT[(i + 1) % 4]) for i in range(4)), ((x, y), (x + dx, y + dy))])


def strokes(page: Chrome) -> int:
    return int(page.execute_script("return window.timings.state().strokes.length"))


def blank_page(path: Path, width: int = 500, height: int = 400) -> Path:
    """A picture with nothing on it, written there."""
    cv2.imwrite(str(path), np.full((height, width, 3), 255, np.uint8))
    return path
