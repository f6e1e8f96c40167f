"""The solid on its stage in a real browser: full screen, the drawing that folds up, a cut, a ruler."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from selenium.webdriver import ActionChains, Chrome
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

from .browsing import needs_browser, painted, read, upload, wait

pytestmark = needs_browser


def solid(page: Chrome, what: str) -> Any:
    return page.execute_script(f"return timings.solid().{what}")


def depth(page: Chrome) -> float:
    """How deep the solid is on its stage, in units of the drawing."""
    return float(np.ptp(np.array(solid(page, "shape.vertices"))[:, 2]))


def less_motion(page: Chrome, value: str) -> None:
    media = {"features": [{"name": "prefers-reduced-motion", "value": value}]}
    page.execute_cdp_cmd("Emulation.setEmulatedMedia", media)


@pytest.fixture
def shown(page: Chrome, box_file: Any) -> Chrome:
    upload(page, box_file)
    return page


def test_the_stage_fills_the_screen_and_comes_back(shown: Chrome) -> None:
    full = "return document.fullscreenElement?.id ?? ''"
    shown.find_element(By.ID, "full").click()
    wait(lambda: shown.execute_script(full) == "solid-stage")
    wait(lambda: read(shown, "#full", "ariaPressed") == "true")
    high = shown.execute_script("return [document.getElementById('solid').clientHeight, innerHeight]")
    assert high[0] > 0.95 * high[1]
    shown.execute_script("return document.exitFullscreen()")
    wait(lambda: read(shown, "#full", "ariaPressed") == "false")


def test_the_drawing_folds_up_into_the_solid(shown: Chrome) -> None:
    whole, home = depth(shown), solid(shown, "yaw")
    assert whole > 50
    # asked at once, before the page paints again
    flat = "document.getElementById('fold').click(); return timings.solid().shape.vertices.map(v => v[2])"
    assert np.ptp(shown.execute_script(flat)) < 0.1 * whole
    wait(lambda: depth(shown) == pytest.approx(whole))
    assert solid(shown, "yaw") == pytest.approx(home)


def test_for_less_motion_nothing_folds(shown: Chrome) -> None:
    whole = depth(shown)
    less_motion(shown, "reduce")
    try:
        fold = "document.getElementById('fold').click(); return timings.solid().shape.vertices.map(v => v[2])"
        assert np.ptp(shown.execute_script(fold)) == pytest.approx(whole)
    finally:
        less_motion(shown, "")


def test_two_corners_are_measured_and_a_cut_is_moved(shown: Chrome) -> None:
    shown.find_element(By.ID, "measure").click()
    painted(shown)
    canvas = shown.find_element(By.ID, "solid")
    box = "const r = arguments[0].getBoundingClientRect(); return [r.width, r.height]"
    width, height = shown.execute_script(box, canvas)
    seen = [
        shown.execute_script("return timings.solid().seenAt(timings.solid().shape.vertices[arguments[0]])", k)
        for k in (0, 1)
    ]
    for x, y in (s[:2] for s in seen):
        ActionChains(shown).move_to_element_with_offset(
            canvas, int(x - width / 2), int(y - height / 2)
        ).click().perform()
    a, b = (np.array(v) for v in solid(shown, "shape.vertices")[:2])
    assert read(shown, "#measured").startswith(f"{np.linalg.norm(a - b):.0f} between")
    shown.find_element(By.ID, "cut").click()
    at = solid(shown, "section.at")
    shown.execute_script(
        "const c = document.getElementById('cut-at'); c.value = 80; c.dispatchEvent(new Event('input'))"
    )
    assert abs(solid(shown, "section.at") - at) == pytest.approx(0.3)


def test_corners_are_measured_by_the_keyboard(shown: Chrome) -> None:
    shown.find_element(By.ID, "measure").click()
    shown.find_element(By.ID, "solid").send_keys("n", Keys.ENTER, "n")
    a, b = (np.array(v) for v in solid(shown, "shape.vertices")[:2])
    assert read(shown, "#measured").startswith(f"{np.linalg.norm(a - b):.0f} between")
    shown.find_element(By.ID, "solid").send_keys("n", Keys.ENTER)
    c = np.array(solid(shown, "shape.vertices")[2])
    assert read(shown, "#measured").startswith(f"{np.linalg.norm(a - c):.0f} between")


def test_a_size_typed_badly_on_the_solid_is_told_beside_it(shown: Chrome) -> None:
    shown.find_element(By.CSS_SELECTOR, "#dimensions [data-size=depth]").click()
    shown.switch_to.active_element.send_keys("sixty", Keys.ENTER)
    assert "Not a length" in read(shown, "#why-not")
    shown.switch_to.active_element.send_keys("5")
    assert read(shown, "#why-not") == ""
    shown.switch_to.active_element.send_keys(Keys.ENTER, Keys.ESCAPE)
    wait(lambda: not shown.find_elements(By.ID, "why-not"))
    assert read(shown, "#error-depth") == ""
    assert [line for line in shown.get_log("browser") if line["level"] == "SEVERE"] == []


def test_the_standard_views_and_the_cube_turn_the_solid(shown: Chrome) -> None:
    less_motion(shown, "reduce")
    try:
        for name, view in (("front", (0, 0)), ("top", (0, 90)), ("side", (90, 0))):
            shown.find_element(By.CSS_SELECTOR, f"[data-view={name}]").click()
            wait(lambda view=view: (solid(shown, "yaw"), solid(shown, "pitch")) == view)
        shown.find_element(By.CSS_SELECTOR, "[data-view=home]").click()
        painted(shown)
        ActionChains(shown).move_to_element_with_offset(shown.find_element(By.ID, "cube"), -8, 8).click().perform()
        wait(lambda: (solid(shown, "yaw"), solid(shown, "pitch")) == (0, 0))
    finally:
        less_motion(shown, "")


def test_the_cut_is_outlined(shown: Chrome) -> None:
    lines = "return timings.solid().cutLines(300, 300).length"
    assert shown.execute_script(lines) == 0
    shown.find_element(By.ID, "cut").click()
    assert shown.execute_script(lines) == 8  # each of the four sides is two triangles
