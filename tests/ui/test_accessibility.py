"""axe-core has nothing to object to in any state of the page, by day and by night; small screens, fingers."""

from __future__ import annotations

import importlib.util
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from selenium.webdriver import Chrome
from selenium.webdriver.common.by import By

from sketch2shape.ui.examples import example_png

from .browsing import blank_page, draw_beginning, draw_box, message, needs_browser, painted, read, volume, wait

_FOUND = importlib.util.find_spec("axe_core_python")
pytestmark = [
    needs_browser,
    pytest.mark.skipif(_FOUND is None, reason="axe-core-python is not installed"),
]

_RUN = "const done = arguments[0]; axe.run(document, {resultTypes: ['violations']}).then(r => done(r.violations))"
_SMALL = """
const modal = document.querySelector("dialog[open]"), most = arguments[0];
const spared = e => e.closest(".visually-hidden, #dimensions") || ["checkbox", "range"].includes(e.type)
  || modal && !e.closest("dialog");
const all = [...document.querySelectorAll("button, .button, select, input")];
return all.filter(e => e.checkVisibility() && !spared(e)).filter(e => {
  const box = e.getBoundingClientRect();
  return box.width < most || box.height < most;
}).map(e => `${e.id} ${e.textContent.trim().slice(0, 20)}`)
"""
_FINGER = 40
"""Least width and height of what fingers touch, CSS pixels; most things have 44."""


@pytest.fixture(scope="module")
def page(browser: Chrome, address: str) -> Chrome:
    browser.get(address)
    return browser


def axe() -> str:
    assert _FOUND is not None
    assert _FOUND.origin is not None
    return Path(_FOUND.origin).parent.joinpath("axe.min.js").read_text("utf-8")


def violations(page: Chrome) -> list[tuple[str, list[str]]]:
    found: list[dict[str, Any]] = page.execute_async_script(_RUN)
    return [(v["id"], [n["html"][:120] + n["failureSummary"][:120] for n in v["nodes"]][:3]) for v in found]


def colours(page: Chrome, scheme: str) -> None:
    features = [
        {"name": "prefers-color-scheme", "value": scheme},
        {"name": "prefers-reduced-motion", "value": "reduce"},
    ]
    page.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": features})


def screen(page: Chrome, width: int, height: int) -> None:
    size = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False}
    page.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size)


def click(page: Chrome, css: str) -> None:
    page.execute_script("document.querySelector(arguments[0]).click()", css)
    painted(page)


def start(page: Chrome) -> None:
    page.get(page.current_url.partition("#")[0])
    wait(lambda: page.execute_script("return document.querySelectorAll('#gallery button').length > 5"))


def drawn(page: Chrome) -> None:
    start(page)
    draw_box(page)
    wait(lambda: volume(page) and read(page, "#readings li"))


def begun(page: Chrome) -> None:
    start(page)
    draw_beginning(page)
    wait(lambda: "begins to stand up" in message(page))


def cylinder(page: Chrome) -> None:
    start(page)
    page.execute_script(
        "[...document.querySelectorAll('#gallery button')].find(b => b.textContent === 'Cylinder').click()"
    )
    wait(lambda: "Found the object" in message(page))


def corners(page: Chrome) -> None:
    drawn(page)
    click(page, "#adjust")


def found(page: Chrome) -> None:
    start(page)
    click(page, "#gallery button")
    wait(lambda: "Found the object" in message(page))


def opened(css: str, state: Callable[[Chrome], None]) -> Callable[[Chrome], None]:
    def reach(page: Chrome) -> None:
        state(page)
        click(page, css)

    return reach


def guessed(page: Chrome) -> None:
    drawn(page)
    page.execute_script(
        "const s = timings.state(); location.hash = ''; document.getElementById('guess').hidden = false;"
        "document.getElementById('error-width').textContent = 'x';"
    )


def working(page: Chrome) -> None:
    drawn(page)
    page.execute_script(
        "document.getElementById('busy').hidden = false;document.getElementById('busy-words').textContent = 'Working';"
    )


def badly_typed(page: Chrome) -> None:
    drawn(page)
    click(page, "#dimensions [data-size=depth]")
    page.execute_script(
        "const f = document.querySelector('#dimensions input'); f.value = 'sixty';"
        "f.dispatchEvent(new KeyboardEvent('keydown', {key: 'Enter'}))"
    )
    assert read(page, "#why-not")


def folder(page: Chrome) -> None:
    start(page)
    with tempfile.TemporaryDirectory() as place:
        sheets = Path(place) / "sheets"
        sheets.mkdir()
        sheets.joinpath("a.png").write_bytes(example_png("wireframe"))
        blank_page(sheets / "b.png", 80, 80)
        page.find_element(By.ID, "folder").send_keys(str(sheets))
        wait(lambda: read(page, "#strip").count(":") == 2 and "waiting" not in read(page, "#strip"))


STATES: dict[str, Callable[[Chrome], None]] = {
    "start": start,
    "drawn": drawn,
    "begun": begun,
    "cylinder": cylinder,
    "corners": corners,
    "found": found,
    "a guess and an error": guessed,
    "working": working,
    "download": opened("#download", drawn),
    "link": opened("#share", drawn),
    "numbers": opened("#numbers", drawn),
    "question": opened("#draw", drawn),
    "a size typed badly": badly_typed,
    "folder": folder,
    "measuring and cut": opened("#cut", opened("#measure", drawn)),
}


@pytest.mark.parametrize("state", list(STATES))
def test_axe_has_nothing_to_object_to(page: Chrome, state: str) -> None:
    colours(page, "light")
    screen(page, 1366, 768)
    STATES[state](page)
    page.execute_script(axe())
    assert violations(page) == []
    colours(page, "dark")
    painted(page)
    assert violations(page) == []


@pytest.mark.parametrize(("width", "height"), [(360, 640), (683, 384)])  # a phone; a laptop at 200 %
@pytest.mark.parametrize("state", ["start", "drawn", "found", "download"])
def test_small_screens_show_all_and_fit_fingers(page: Chrome, state: str, width: int, height: int) -> None:
    colours(page, "light")
    screen(page, 1366, 768)
    STATES[state](page)
    screen(page, width, height)
    painted(page)
    assert page.execute_script("return document.documentElement.scrollWidth <= innerWidth")
    small = page.execute_script(_SMALL, _FINGER)
    assert small == []


def test_a_system_with_few_colours_shows_what_is_chosen(page: Chrome) -> None:
    drawn(page)
    page.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [{"name": "forced-colors", "value": "active"}]})
    chosen, other = (
        page.execute_script(
            "return getComputedStyle(document.querySelector(arguments[0])).backgroundColor", f"[data-pad={tool}]"
        )
        for tool in ("pen", "erase")
    )
    assert chosen != other
