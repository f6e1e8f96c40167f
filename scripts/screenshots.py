"""Take the screenshots of docs/ui.md: drives the real page in Chromium.

python scripts/screenshots.py [FOLDER]      (default: docs/pictures)
"""

from __future__ import annotations

import sys
import time
from pathlib import Path

REPOSITORY = Path(__file__).parents[1]
sys.path.insert(0, str(REPOSITORY / "tests" / "ui"))

from chromium import start_browser  # noqa: E402
from selenium.webdriver import ActionChains, Chrome  # noqa: E402
from selenium.webdriver.common.by import By  # noqa: E402
from selenium.webdriver.support.ui import WebDriverWait  # noqa: E402
from server import start_app  # noqa: E402

FRONT = [(-190, -60), (-90, -60), (-90, 30), (30, 30), (30, 130), (-190, 130)]
DEPTH = (110, -75)


def until(page: Chrome, words: str) -> None:
    end = time.monotonic() + 60
    while words not in page.find_element(By.ID, "message").text:
        if time.monotonic() > end:
            raise TimeoutError(f"the page does not say {words!r}")
        time.sleep(0.1)
    time.sleep(0.5)


def example(page: Chrome, name: str) -> None:
    page.execute_script(
        "const s = document.getElementById('examples'); s.value = arguments[0]; s.dispatchEvent(new Event('change'))",
        name,
    )
    until(page, "Found the object")


def draw(page: Chrome) -> None:
    """An L on the drawing pad: front, back, and the edges between them."""
    page.find_element(By.ID, "draw").click()
    pad = page.find_element(By.ID, "pad")
    for i, (x, y) in enumerate(FRONT):
        u, v = FRONT[(i + 1) % len(FRONT)]
        for dx, dy in ((0, 0), DEPTH):
            stroke(page, pad, (x + dx, y + dy), (u + dx, v + dy))
        stroke(page, pad, (x, y), (x + DEPTH[0], y + DEPTH[1]))


def stroke(page: Chrome, pad: object, a: tuple[int, int], b: tuple[int, int]) -> None:
    chain = ActionChains(page, duration=10).move_to_element_with_offset(pad, *a).click_and_hold()
    chain.move_to_element_with_offset(pad, *b).release().perform()


def whole_page(page: Chrome, file: Path) -> None:
    """A screenshot of the page from top to bottom."""
    width = page.execute_script("return innerWidth")
    height = page.execute_script("return document.documentElement.scrollHeight")
    frame = page.execute_script("return outerHeight - innerHeight")
    before = page.get_window_size()
    page.set_window_size(before["width"], height + frame)
    time.sleep(0.6)
    page.save_screenshot(str(file))
    page.set_window_size(before["width"], before["height"])
    print(f"{file.name}: {width} x {height}")


def main(folder: Path) -> None:
    with start_app() as address, start_browser() as page:
        page.set_window_size(1400, 940)
        page.get(address)
        loaded = "const i = document.images; return i.length > 5 && [...i].every(p => p.complete)"
        WebDriverWait(page, 60).until(lambda p: p.execute_script(loaded))
        page.save_screenshot(str(folder / "ui-start.png"))
        example(page, "isometric")
        page.find_element(By.ID, "size-value").send_keys("60")
        until(page, "follows")
        whole_page(page, folder / "ui-found.png")
        draw(page)
        page.save_screenshot(str(folder / "ui-draw.png"))
        page.find_element(By.ID, "make").click()
        until(page, "Found the object")
        page.save_screenshot(str(folder / "ui-drawn.png"))
        page.set_window_size(430, 900)
        example(page, "photo")
        page.save_screenshot(str(folder / "ui-narrow.png"))


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else REPOSITORY / "docs" / "pictures")
