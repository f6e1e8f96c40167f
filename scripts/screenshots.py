"""Take the screenshots of docs/ui.md: drives the real page in Chromium, in all its states, on three screens.

python scripts/screenshots.py [FOLDER] [--only STATE] [--screen NAME]      (default: docs/pictures, all)
"""

from __future__ import annotations

import argparse
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw

REPOSITORY = Path(__file__).parents[1]
sys.path.insert(0, str(REPOSITORY / "tests" / "ui"))
sys.path.insert(0, str(REPOSITORY / "scripts"))

from chromium import start_browser  # noqa: E402
from class_of_thirty import link_of  # noqa: E402
from draw_by_hand import Screen, by_hand, settled, show_screen, stroke, strokes_of  # noqa: E402
from selenium.webdriver import Chrome  # noqa: E402
from selenium.webdriver.common.by import By  # noqa: E402
from server import start_app  # noqa: E402

from sketch2shape.ui.examples import example_png  # noqa: E402

#: name in the file -> screen
SCREENS = {
    "desktop": Screen("", 1366, 768, False, 2.0),
    "tablet": Screen("", 820, 1180, True, 1.5),
    "phone": Screen("", 360, 640, True, 1.0),
    "zoomed": Screen("", 683, 384, False, 1.0),
}
"""The last is the laptop's at 200 %."""
ZOOMED = frozenset({"start", "drawn", "found", "take"})
"""States that are shown at 200 % too."""
COLOURS = 64
"""Colours of a screenshot kept as they are, the most frequent ones, and again as many near all others: small files."""


LONGEST = 60.0
"""Seconds that the page may take for anything."""
CAMERA = ("--use-fake-device-for-media-stream", "--use-fake-ui-for-media-stream")
"""Chromium without a camera shows a moving pattern."""


def until(page: Chrome, true: str, rest: float = 1.2) -> None:
    """Wait until something is true on the page, and then for what moves to come to rest."""
    end = time.monotonic() + LONGEST
    while not page.execute_script(f"return {true}"):
        if time.monotonic() > end:
            raise TimeoutError(f"the page does not come to {true}")
        time.sleep(0.1)
    time.sleep(rest)


def says(page: Chrome, words: str) -> None:
    """Wait until the page says so."""
    until(page, f"document.getElementById('message').textContent.includes({words!r})")


def click(page: Chrome, css: str) -> None:
    page.execute_script("document.querySelector(arguments[0]).click()", css)


def start(page: Chrome, _screen: Screen) -> None:
    until(page, "document.querySelectorAll('#gallery img').length > 5")


def draw(page: Chrome, screen: Screen, name: str, count: int) -> None:
    """The first strokes of a solid, by a steady hand."""
    page.find_element(By.ID, "start-draw").click()
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
    says(page, "Found the object")


def take(page: Chrome, screen: Screen) -> None:
    found(page, screen)
    click(page, "#download")
    time.sleep(0.5)


def give(page: Chrome, css: str, value: str) -> None:
    """Type into a field."""
    page.execute_script(
        "const f = document.querySelector(arguments[0]); f.value = arguments[1]; f.dispatchEvent(new Event('change'))",
        css,
        value,
    )


def stage_in_view(page: Chrome) -> None:
    """Where the page is long, the solid in view."""
    page.execute_script("if (innerWidth < 860) document.getElementById('solid-stage').scrollIntoView()")
    time.sleep(0.6)


def cut(page: Chrome, screen: Screen) -> None:
    """Cut open and given a height."""
    draw(page, screen, "cylinder", 99)
    give(page, "#size-height", "40")
    time.sleep(1.5)
    click(page, "#cut")
    stage_in_view(page)


def readings(page: Chrome, screen: Screen) -> None:
    """A box, which may be seen in several ways."""
    draw(page, screen, "box", 99)
    until(page, "document.querySelectorAll('#readings canvas').length > 1")
    stage_in_view(page)


def sizes(page: Chrome, screen: Screen) -> None:
    """Two sizes given, the third one typed badly where it stands on the solid."""
    draw(page, screen, "house", 99)
    give(page, "#size-width", "40")
    give(page, "#size-height", "50")
    time.sleep(1.5)
    click(page, "#bed")
    click(page, "#dimensions [data-size=depth]")
    page.execute_script(
        "const f = document.querySelector('#dimensions input'); f.value = 'sixty';"
        "f.dispatchEvent(new KeyboardEvent('keydown', {key: 'Enter'}))"
    )
    stage_in_view(page)


def marks(page: Chrome, screen: Screen) -> None:
    """A house with an edge left out, a line that belongs to no solid and two that do not meet."""
    page.find_element(By.ID, "start-draw").click()
    time.sleep(0.3)
    box = "const r = document.getElementById('pad').getBoundingClientRect(); return [r.x, r.y, r.width, r.height]"
    x, y, width, height = page.execute_script(box)
    side = 0.92 * min(width, height)
    rng = np.random.default_rng(3)
    paths = strokes_of("house", side)[0]
    (x0, y0), (x1, y1) = paths[3]
    paths[3] = [(x0, y0), (x1 + 0.12 * (x0 - x1), y1 + 0.12 * (y0 - y1))]
    del paths[8]
    for path in [*paths, [(0.1 * side, 0.12 * side), (0.4 * side, 0.2 * side)]]:
        stroke(page, by_hand(path, screen.error, rng) + (x + 10, y + 8), screen.touch)
    settled(page)
    time.sleep(1.5)


def wrong(page: Chrome, screen: Screen) -> None:
    """A picture of a box that lacks edges and has lines that belong to no solid."""
    start(page, screen)
    picture = Image.new("RGB", (640, 480), "white")
    pen = ImageDraw.Draw(picture)
    front = [(120, 180), (360, 180), (360, 400), (120, 400)]
    back = [(x + 130, y - 110) for x, y in front]
    edges = [(f[k], f[(k + 1) % 4]) for f in (front, back) for k in range(4)] + list(zip(front, back, strict=True))
    foreign = [((40, 60), (300, 330)), ((560, 440), (330, 120)), ((200, 440), (460, 250)), ((40, 300), (600, 330))]
    for (x0, y0), (x1, y1) in [e for k, e in enumerate(edges) if k not in (5, 6, 9)] + foreign:
        pen.line([x0, y0, x1, y1], fill="#222", width=4)
    with tempfile.TemporaryDirectory() as folder:
        picture.save(Path(folder) / "sketch.png")
        page.find_element(By.ID, "file").send_keys(str(Path(folder) / "sketch.png"))
        until(page, "!document.getElementById('message').textContent.includes('Looking') && timings.facts().length")


def strip(page: Chrome, screen: Screen) -> None:
    """A folder of pictures, one of them without an object."""
    start(page, screen)
    names = ("photo", "pencil", "hole", "cone", "isometric")
    with tempfile.TemporaryDirectory() as folder:
        sheets = Path(folder) / "sheets"
        sheets.mkdir()
        for name in names:
            sheets.joinpath(f"{name}.png").write_bytes(example_png(name))
        Image.new("RGB", (400, 300), "white").save(sheets / "blank.png")
        page.find_element(By.ID, "folder").send_keys(str(sheets))
        looked = "const s = document.getElementById('strip').textContent; return !s.includes('waiting') && s"
        until(page, f"(() => {{ {looked} }})()")
    click(page, "#strip li:nth-child(2) button")
    time.sleep(1)
    page.execute_script("document.getElementById('strip').scrollIntoView({block: 'end'})")


def camera(page: Chrome, screen: Screen) -> None:
    start(page, screen)
    page.execute_script(
        "window.matchMedia = (old => q => q.includes('coarse') ? {matches: false} : old(q))(matchMedia)"
    )
    click(page, "#start-photo")
    until(page, "document.getElementById('camera').videoWidth > 0")


def link(page: Chrome, screen: Screen) -> None:
    drawn(page, screen)
    click(page, "#share")
    time.sleep(0.5)


def followed(page: Chrome, _screen: Screen) -> None:
    """What one sees who was sent a link."""
    page.get(page.current_url + link_of("L", 300.0))
    until(page, "timings.facts().length")


def kept(page: Chrome, screen: Screen) -> None:
    """The page after a reload."""
    draw(page, screen, "wedge", 99)
    page.refresh()
    until(page, "window.timings && timings.facts().length")


def back(page: Chrome, screen: Screen) -> None:
    """The first screen of somebody who has a drawing."""
    draw(page, screen, "wedge", 99)
    address = page.current_url
    page.get("about:blank")
    page.get(address)
    start(page, screen)


def question(page: Chrome, screen: Screen) -> None:
    drawn(page, screen)
    click(page, "#draw")
    time.sleep(0.5)


def dark(page: Chrome, screen: Screen) -> None:
    drawn(page, screen)


STATES: dict[str, Callable[[Chrome, Screen], None]] = {
    "start": start, "drawing": drawing, "drawn": drawn, "corners": corners, "cut": cut, "found": found,
    "take": take, "readings": readings, "sizes": sizes, "marks": marks, "wrong": wrong, "strip": strip,
    "camera": camera, "link": link, "followed": followed, "kept": kept, "back": back, "question": question,
    "dark": dark,
}  # fmt: skip
DARK = frozenset({"corners", "dark"})
"""States that are shown by night."""


def few_colours(picture: Image.Image) -> Image.Image:
    """The picture with a palette: its most frequent colours exactly, and such as come near to all others."""
    pixels = np.asarray(picture.convert("RGB")).astype(int)
    known, numbers, times = np.unique(pixels.reshape(-1, 3), axis=0, return_inverse=True, return_counts=True)
    near = picture.convert("RGB").quantize(COLOURS, Image.Quantize.MAXCOVERAGE).getpalette() or []
    palette = np.concatenate([known[np.argsort(-times)[:COLOURS]], np.reshape(near, (-1, 3))])[: 2 * COLOURS]
    nearest = np.abs(known[:, None] - palette[None]).sum(axis=2).argmin(axis=1)
    made = Image.fromarray(nearest[numbers].reshape(pixels.shape[:2]).astype(np.uint8), "P")
    made.putpalette(palette.astype(np.uint8).tobytes())
    return made


def take_one(page: Chrome, address: str, state: str, screen: Screen, file: Path) -> None:
    """One state on one screen, from a fresh page."""
    media = {"features": [{"name": "prefers-color-scheme", "value": "dark" if state in DARK else "light"}]}
    page.execute_cdp_cmd("Emulation.setEmulatedMedia", media)
    page.get("about:blank")
    page.get(address)
    page.execute_async_script("const d = arguments[0], t = () => window.timings ? d() : setTimeout(t, 50); t()")
    STATES[state](page, screen)
    page.save_screenshot(str(file))
    few_colours(Image.open(file)).save(file, optimize=True)
    print(file.name, f"{file.stat().st_size / 1000:.0f} kB", flush=True)


def main(folder: Path, states: list[str], screens: list[str]) -> None:
    with start_app() as address, start_browser(None, *CAMERA) as page:
        page.set_page_load_timeout(LONGEST)
        page.set_script_timeout(LONGEST)
        for name in screens:
            show_screen(page, SCREENS[name])
            for state in states:
                if name != "zoomed" or state in ZOOMED:
                    take_one(page, address, state, SCREENS[name], folder / f"ui-{state}-{name}.png")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default=REPOSITORY / "docs" / "pictures")
    parser.add_argument("--only", choices=STATES, action="append", help="this state; may be given again")
    parser.add_argument("--screen", choices=SCREENS, action="append", help="this screen; may be given again")
    asked = parser.parse_args()
    main(asked.folder, asked.only or list(STATES), asked.screen or list(SCREENS))
