"""Take the screenshots of docs/ui.md: drives the real page in Chromium, in all its states, on three screens.

python scripts/screenshots.py [FOLDER]      (default: docs/pictures)
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
from PIL import Image

REPOSITORY = Path(__file__).parents[1]
sys.path.insert(0, str(REPOSITORY / "tests" / "ui"))
sys.path.insert(0, str(REPOSITORY / "scripts"))

from chromium import start_browser  # noqa: E402
from draw_by_hand import Screen, by_hand, settled, show_screen, stroke, strokes_of  # noqa: E402
from selenium.webdriver import Chrome  # noqa: E402
from server import start_app  # noqa: E402

#: name in the file -> screen
SCREENS = {
    "desktop": Screen("", 1366, 768, False, 2.0),
    "tablet": Screen("", 820, 1180, True, 2.0),
    "phone": Screen("", 360, 640, True, 2.0),
}
COLOURS = 192
"""Colours of a screenshot: enough for flat surfaces and small files."""


def until(page: Chrome, words: str) -> None:
    """Wait until the page says so."""
    end = time.monotonic() + 90
    while words not in str(page.execute_script("return document.getElementById('message').textContent")):
        if time.monotonic() > end:
            raise TimeoutError(f"the page does not say {words!r}")
        time.sleep(0.1)
    time.sleep(1.2)


def click(page: Chrome, css: str) -> None:
    page.execute_script("document.querySelector(arguments[0]).click()", css)


def start(page: Chrome, _screen: Screen) -> None:
    loaded = "return document.querySelectorAll('#gallery img').length > 5"
    while not page.execute_script(loaded):
        time.sleep(0.1)
    time.sleep(1.5)


def draw(page: Chrome, screen: Screen, name: str, count: int) -> None:
    """The first strokes of a solid, by a steady hand."""
    click(page, "#start-draw")
    time.sleep(0.3)
    box = "const r = document.getElementById('pad').getBoundingClientRect(); return [r.x, r.y, r.width, r.height]"
    x, y, width, height = page.execute_script(box)
    rng = np.random.default_rng(3)
    for path in strokes_of(name, 0.92 * min(width, height))[0][:count]:
        stroke(page, by_hand(path, screen.error, rng) + (x + 10, y + 8), screen.touch)
    settled(page)
    time.sleep(1.5)


def drawing(page: Chrome, screen: Screen) -> None:
    draw(page, screen, "L", 9)


def drawn(page: Chrome, screen: Screen) -> None:
    draw(page, screen, "L", 99)


def corners(page: Chrome, screen: Screen) -> None:
    draw(page, screen, "house", 99)
    click(page, "#adjust")
    time.sleep(0.6)


def found(page: Chrome, screen: Screen) -> None:
    start(page, screen)
    click(page, "#gallery li:nth-child(11) button")
    until(page, "Found the object")


def take(page: Chrome, screen: Screen) -> None:
    found(page, screen)
    click(page, "#download")
    time.sleep(0.5)


def cut(page: Chrome, screen: Screen) -> None:
    """Cut open and given a height; where the page is long, the solid in view."""
    draw(page, screen, "cylinder", 99)
    page.execute_script(
        "const f = document.getElementById('size-height'); f.value = '40'; f.dispatchEvent(new Event('change'));"
    )
    time.sleep(1.5)
    click(page, "#cut")
    page.execute_script("document.getElementById('solid-stage').scrollIntoView()")
    time.sleep(0.6)


STATES: dict[str, Callable[[Chrome, Screen], None]] = {
    "start": start, "drawing": drawing, "drawn": drawn, "corners": corners, "cut": cut, "found": found,
    "take": take,
}  # fmt: skip


def main(folder: Path) -> None:
    with start_app() as address, start_browser() as page:
        for place, screen in SCREENS.items():
            show_screen(page, screen)
            for state, reach in STATES.items():
                dark = "dark" if state == "corners" else "light"
                media = {"features": [{"name": "prefers-color-scheme", "value": dark}]}
                page.execute_cdp_cmd("Emulation.setEmulatedMedia", media)
                page.get("about:blank")
                page.get(address)
                page.execute_async_script(
                    "const d = arguments[0], t = () => window.timings ? d() : setTimeout(t, 50); t()"
                )
                reach(page, screen)
                file = folder / f"ui-{state}-{place}.png"
                page.save_screenshot(str(file))
                Image.open(file).convert("RGB").quantize(COLOURS, dither=Image.Dither.NONE).save(file, optimize=True)
                print(file.name)


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else REPOSITORY / "docs" / "pictures")
