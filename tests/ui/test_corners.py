"""Corners in a real browser: moved, added, given to the other face, traced, kept."""

from __future__ import annotations

import json
from itertools import pairwise
from pathlib import Path

import pytest
from selenium.webdriver import ActionChains, Chrome
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

from .browsing import (
    FRONT,
    SHIFT,
    blank_page,
    downloaded,
    drag,
    message,
    needs_browser,
    painted,
    place,
    press,
    upload,
    vertex,
    volume,
    wait,
)

pytestmark = needs_browser


def test_a_wrong_vertex_is_dragged_to_its_place(page: Chrome, box_file: Path, tmp_path: Path) -> None:
    upload(page, box_file)
    right, (x, y) = volume(page), place(page, 1, 2)
    drag(page, vertex(page, 1, 2), 60, 40)  # now it is wrong
    wait(lambda: volume(page) != pytest.approx(right, rel=1e-3))
    scale = page.execute_script("return document.getElementById('editor').getScreenCTM().a")
    wrong_x, wrong_y = place(page, 1, 2)
    drag(page, vertex(page, 1, 2), round((x - wrong_x) * scale), round((y - wrong_y) * scale))
    wait(lambda: volume(page) == pytest.approx(right, rel=0.05))


def test_the_front_is_the_face_that_is_clicked(page: Chrome, box_file: Path) -> None:
    upload(page, box_file)
    page.find_element(By.CSS_SELECTOR, "[data-tool=front]").click()
    x, y = (sum(place(page, f, i)[c] for f in (1, 2) for i in (1, 2)) / 4 for c in (0, 1))
    at = "const p = new DOMPoint(...arguments).matrixTransform(document.getElementById('editor').getScreenCTM());"
    x, y = page.execute_script(at + "return [p.x, p.y]", x, y)
    before = [place(page, 1, i) for i in range(4)]
    chain = ActionChains(page)
    chain.w3c_actions.pointer_action.move_to_location(round(x), round(y)).click()
    chain.perform()
    wait(lambda: {place(page, 1, i) for i in range(4)} != set(before))


def test_vertices_are_added_deleted_and_given_to_the_other_face(page: Chrome, box_file: Path) -> None:
    upload(page, box_file)

    def count() -> int:
        return len(page.find_elements(By.CSS_SELECTOR, "g.vertex"))

    ActionChains(page).send_keys("a").perform()  # the Add tool by its key
    (x0, y0), (x1, y1) = (vertex(page, 1, i).location.values() for i in (0, 1))
    editor = page.find_element(By.ID, "editor")
    middle = page.execute_script(
        "const r = arguments[0].getBoundingClientRect(); return [r.x + r.width / 2, r.y + r.height / 2]", editor
    )
    ActionChains(page).move_to_element_with_offset(
        editor, round((x0 + x1) / 2 + 6 - middle[0]), round((y0 + y1) / 2 + 6 - middle[1] - 15)
    ).click().perform()
    assert count() == 10
    press(page, 1, 1, Keys.DELETE)
    assert count() == 8
    front = place(page, 1, 0)
    press(page, 1, 0, "f")
    assert place(page, 2, 0) == front


def test_a_vertex_moves_by_the_arrow_keys(page: Chrome, box_file: Path) -> None:
    upload(page, box_file)
    x, y = place(page, 2, 3)
    press(page, 2, 3, Keys.ARROW_RIGHT, Keys.ARROW_RIGHT, Keys.ARROW_UP)
    assert place(page, 2, 3) == pytest.approx((x + 2, y - 1))
    assert "vertex 4" in page.switch_to.active_element.get_attribute("aria-label")  # the focus stays on it


def test_an_object_is_traced_where_none_was_found(page: Chrome, tmp_path: Path) -> None:
    page.find_element(By.ID, "file").send_keys(str(blank_page(tmp_path / "blank.png")))
    wait(lambda: "Trace it by hand" in message(page))
    editor = page.find_element(By.ID, "editor")
    for x, y in [*FRONT, FRONT[0], (FRONT[0][0] + SHIFT[0], FRONT[0][1] + SHIFT[1])]:
        ActionChains(page).move_to_element_with_offset(editor, x, y).click().perform()
    wait(lambda: volume(page) > 0)
    assert len(page.find_elements(By.CSS_SELECTOR, "g.vertex")) == 8


def test_an_object_is_traced_by_the_keyboard(page: Chrome, tmp_path: Path) -> None:
    page.find_element(By.ID, "file").send_keys(str(blank_page(tmp_path / "keys.png")))
    wait(lambda: "Trace it by hand" in message(page))
    page.execute_script("document.getElementById('editor').focus()")
    right, left, up, down = Keys.ARROW_RIGHT, Keys.ARROW_LEFT, Keys.ARROW_UP, Keys.ARROW_DOWN
    for way in (right, left * 8, down * 6, right * 8, up * 6, right * 4 + up * 3):
        ActionChains(page).send_keys(way + Keys.ENTER).perform()
    wait(lambda: volume(page) > 0)
    assert len(page.find_elements(By.CSS_SELECTOR, "g.vertex")) == 8


def test_vertices_are_added_by_the_keyboard_one_after_the_other(page: Chrome, tmp_path: Path) -> None:
    page.find_element(By.ID, "file").send_keys(str(blank_page(tmp_path / "more.png")))
    wait(lambda: "Trace it by hand" in message(page))
    page.find_element(By.CSS_SELECTOR, "[data-tool=add]").click()
    page.execute_script("document.getElementById('editor').focus()")
    for _ in range(3):
        ActionChains(page).send_keys(Keys.ARROW_RIGHT * 4 + Keys.ENTER).perform()
        painted(page)
    places = page.execute_script("return timings.state().loose.map(v => v.x)")
    assert [b - a for a, b in pairwise(places)] == [40, 40]


def test_single_vertices_are_told_apart_and_connected(page: Chrome, tmp_path: Path) -> None:
    page.find_element(By.ID, "file").send_keys(str(blank_page(tmp_path / "white.png")))
    wait(lambda: "Trace it by hand" in message(page))
    page.find_element(By.CSS_SELECTOR, "[data-tool=add]").click()
    editor = page.find_element(By.ID, "editor")
    corners = [FRONT[k] for k in (0, 2, 1, 3)]  # in no order
    for x, y in [*corners, *((x + SHIFT[0], y + SHIFT[1]) for x, y in reversed(corners))]:
        ActionChains(page).move_to_element_with_offset(editor, x, y).click().perform()
    assert len(page.find_elements(By.CSS_SELECTOR, "g.vertex.f0")) == 8
    for k in range(8):
        loose = page.find_element(By.CSS_SELECTOR, f"[data-name='{{\"loose\":{k}}}']")
        loose.send_keys("f")
        if k >= 4:
            page.switch_to.active_element.send_keys("f")
    wait(lambda: volume(page) > 0)
    assert len(page.find_elements(By.CSS_SELECTOR, "g.vertex.f1")) == 4
    assert not page.find_elements(By.CSS_SELECTOR, "g.vertex.f0")


def test_corrections_are_saved_and_read_back(page: Chrome, address: str, box_file: Path, downloads: Path) -> None:
    upload(page, box_file)
    press(page, 1, 0, Keys.ARROW_LEFT)
    moved = place(page, 1, 0)
    page.find_element(By.ID, "download").click()
    page.find_element(By.ID, "save").click()
    file = downloaded(downloads, "box.corrections.json")
    saved = json.loads(file.read_text())
    assert saved["source"] == "box.png"
    assert saved["objects"][0]["f1"][0] == pytest.approx(moved)
    page.get("about:blank")
    page.get(address)
    upload(page, box_file)
    assert place(page, 1, 0) != pytest.approx(moved)
    page.find_element(By.ID, "file").send_keys(str(file))
    wait(lambda: place(page, 1, 0) == pytest.approx(moved))
