"""The pad in a real browser: lines drawn by pen, finger, keys and numbers."""

from __future__ import annotations

import time

import pytest
from selenium.webdriver import ActionChains, Chrome
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

from .browsing import (
    FRONT,
    SHIFT,
    draw_beginning,
    draw_box,
    draw_line,
    draw_lines,
    message,
    needs_browser,
    read,
    strokes,
    volume,
    wait,
)

pytestmark = needs_browser


def test_a_solid_stands_up_while_a_box_is_drawn(page: Chrome) -> None:
    draw_box(page)
    wait(lambda: "That is a solid" in message(page) and volume(page))
    assert strokes(page) == 12
    page.find_element(By.ID, "adjust").click()
    assert len(page.find_elements(By.CSS_SELECTOR, "g.vertex")) == 8


def test_a_stroke_along_an_edge_of_the_solid_keeps_it_and_another_does_not(page: Chrome) -> None:
    draw_beginning(page)
    wait(lambda: "begins to stand up" in message(page))
    waits = "return timings.live().waits.length"
    before, shown = page.execute_script(waits), volume(page)
    (x, y), (dx, dy) = FRONT[0], SHIFT
    draw_line(page, (x, y), (x + dx, y + dy))
    assert (page.execute_script(waits), volume(page)) == (before + 1, shown)
    draw_line(page, (x + 20, y + 150), (x + 400, y + 40))
    assert page.execute_script(waits) == before + 1
    wait(lambda: not page.execute_script("return timings.busy()"))


def test_clear_is_undone_and_a_reload_keeps_the_drawing(page: Chrome) -> None:
    draw_box(page)
    wait(lambda: volume(page))
    page.find_element(By.ID, "clear").click()
    assert (strokes(page), volume(page)) == (0, 0)
    page.find_element(By.ID, "undo").click()
    wait(lambda: strokes(page) == 12 and volume(page))
    time.sleep(0.6)  # it is kept after a pause
    page.refresh()
    wait(lambda: strokes(page) == 12 and volume(page))


def test_a_link_holds_the_whole_drawing(page: Chrome, address: str) -> None:
    draw_box(page)
    wait(lambda: volume(page))
    page.find_element(By.ID, "share").click()
    link = wait(lambda: read(page, "#link-text", "value"))
    assert len(link) < 1000
    page.get("about:blank")
    page.get(link)
    wait(lambda: strokes(page) == 12 and volume(page))
    page.get("about:blank")
    page.get(link[:-20])
    wait(lambda: "does not hold" in message(page))


def test_a_question_comes_before_a_drawing_is_dropped(page: Chrome) -> None:
    draw_box(page)
    page.find_element(By.ID, "draw").click()
    assert strokes(page) == 12
    page.find_element(By.CSS_SELECTOR, "#ask [value=no]").click()
    assert strokes(page) == 12
    page.find_element(By.ID, "draw").click()
    page.find_element(By.CSS_SELECTOR, "#ask [value=yes]").click()
    wait(lambda: strokes(page) == 0)


def test_lines_are_drawn_with_the_keyboard_and_by_numbers(page: Chrome) -> None:
    page.find_element(By.ID, "draw").click()
    pad = page.find_element(By.ID, "pad")
    pad.send_keys(Keys.ENTER, Keys.ENTER, *[Keys.ARROW_RIGHT] * 5, Keys.ENTER)
    assert strokes(page) == 1
    pad.send_keys(Keys.ENTER, *[Keys.ARROW_DOWN] * 5, Keys.ESCAPE)
    assert strokes(page) == 1
    page.find_element(By.ID, "numbers").click()
    page.find_element(By.CSS_SELECTOR, "#numbers-box .main").click()
    page.find_element(By.CSS_SELECTOR, "#numbers-box .close").click()
    assert strokes(page) == 2


def stroke_points(page: Chrome, k: int) -> list[list[float]]:
    return [list(p[:2]) for p in page.execute_script("return timings.state().strokes[arguments[0]].points", k)]


def test_a_line_is_selected_moved_and_deleted_and_all_of_it_comes_back(page: Chrome) -> None:
    draw_lines(page, [((-150, 80), (100, 140)), ((-150, 0), (100, 0))])
    drawn = stroke_points(page, 0)
    page.find_element(By.CSS_SELECTOR, "[data-pad=select]").click()
    draw_line(page, (-25, 110), (-25, 60))
    moved = stroke_points(page, 0)
    assert moved == [[x, y - 50] for x, y in drawn]
    ActionChains(page).send_keys(Keys.DELETE).perform()
    assert strokes(page) == 1
    for _ in range(2):
        page.find_element(By.ID, "undo").click()
    assert stroke_points(page, 0) == drawn
    page.find_element(By.ID, "redo").click()
    assert stroke_points(page, 0) == moved


def test_lines_are_chosen_moved_and_deleted_by_the_keyboard(page: Chrome) -> None:
    draw_lines(page, [((-150, 80), (100, 140)), ((-150, 0), (100, 0))])
    (x, y), _ = stroke_points(page, 1)
    pad = page.find_element(By.ID, "pad")
    pad.send_keys("n", "n")
    assert read(page, "#hint").startswith("Line 2 of 2")
    pad.send_keys(Keys.ARROW_RIGHT)
    assert stroke_points(page, 1)[0] == [x + 10, y]
    pad.send_keys("b", Keys.DELETE)
    assert strokes(page) == 1
    assert stroke_points(page, 0)[0] == [x + 10, y]


def test_the_eraser_takes_all_that_it_crosses_however_fast(page: Chrome) -> None:
    draw_lines(page, [((-150, 40 * k), (100, 40 * k)) for k in range(-2, 3)])
    page.find_element(By.CSS_SELECTOR, "[data-pad=erase]").click()
    draw_line(page, (-20, -50), (-20, 120))
    assert strokes(page) == 1
    page.find_element(By.ID, "undo").click()
    assert strokes(page) == 5


def test_shift_keeps_to_an_axis(page: Chrome) -> None:
    page.find_element(By.ID, "draw").click()
    ActionChains(page).key_down(Keys.SHIFT).perform()
    draw_line(page, (-150, 0), (100, 60))
    ActionChains(page).key_up(Keys.SHIFT).perform()
    (_, y1), (_, y2) = stroke_points(page, 0)
    assert y1 == pytest.approx(y2)


def test_escape_cancels_a_stroke(page: Chrome) -> None:
    page.find_element(By.ID, "draw").click()
    pad = page.find_element(By.ID, "pad")
    ActionChains(page, duration=10).move_to_element(pad).click_and_hold().move_by_offset(90, 20).perform()
    ActionChains(page).send_keys(Keys.ESCAPE).perform()
    ActionChains(page, duration=10).move_by_offset(10, 20).release().perform()
    assert strokes(page) == 0


def test_another_reading_is_taken_with_one_tap(page: Chrome) -> None:
    draw_box(page)
    wait(lambda: page.find_elements(By.CSS_SELECTOR, "#readings button"))
    before = volume(page)
    page.find_elements(By.CSS_SELECTOR, "#readings button")[1].click()
    wait(lambda: volume(page) != pytest.approx(before, rel=0.05))
    wait(lambda: read(page, "#readings [aria-pressed=true]", "ariaLabel").startswith("Reading 2"))


def test_a_second_finger_locks_the_axis_and_two_fingers_zoom(page: Chrome) -> None:
    page.find_element(By.ID, "draw").click()
    box = "const r = document.getElementById('pad').getBoundingClientRect(); return [r.x, r.y]"
    x, y = page.execute_script(box)

    def touch(kind: str, *points: tuple[float, float]) -> None:
        told = [{"x": x + a, "y": y + b, "id": k} for k, (a, b) in enumerate(points)]
        page.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": kind, "touchPoints": told})

    touch("touchStart", (100, 100))
    for k in range(1, 8):
        touch("touchMove", (100 + 20 * k, 100 + 6 * k))
    touch("touchStart", (240, 142), (50, 200))
    touch("touchMove", (260, 150), (50, 200))
    touch("touchEnd")
    (x1, y1, *_), (x2, y2, *_) = page.execute_script("return window.timings.state().strokes[0].points")
    assert y2 == pytest.approx(y1)
    assert x2 > x1 + 100

    touch("touchStart", (200, 200))
    touch("touchStart", (200, 200), (300, 200))
    touch("touchMove", (180, 200), (320, 200))
    touch("touchMove", (150, 200), (350, 200))
    touch("touchEnd")
    assert strokes(page) == 1
    assert page.execute_script("return window.timings.zoom()") > 1.5


def test_a_face_and_one_edge_are_a_solid_that_may_be_taken(page: Chrome) -> None:
    draw_beginning(page)
    wait(lambda: "begins to stand up" in message(page) and volume(page))
    assert page.find_element(By.ID, "download").get_attribute("disabled")
    assert "fit no solid" not in read(page, "#hint")
    page.find_element(By.ID, "anyway").click()
    wait(lambda: page.find_element(By.ID, "download").is_enabled())


def test_a_palm_does_not_draw_nor_a_finger_while_a_pen_does(page: Chrome) -> None:
    page.find_element(By.ID, "draw").click()
    box = "const r = document.getElementById('pad').getBoundingClientRect(); return [r.x + 60, r.y + 60]"
    x, y = page.execute_script(box)

    def rub(radius: float) -> None:
        for kind, dx in (("touchStart", 0), ("touchMove", 60), ("touchMove", 120)):
            points = [{"x": x + dx, "y": y + dx / 2, "radiusX": radius, "radiusY": radius}]
            page.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
        page.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})

    rub(40)
    assert strokes(page) == 0
    rub(9)
    assert strokes(page) == 1
    for kind, dx in (("mousePressed", 0), ("mouseMoved", 80), ("mouseReleased", 160)):
        told = {
            "type": kind,
            "x": x + dx,
            "y": y + 200,
            "button": "left",
            "buttons": 1,
            "pointerType": "pen",
            "clickCount": 1,
        }
        page.execute_cdp_cmd("Input.dispatchMouseEvent", told)
    assert strokes(page) == 2
    rub(9)
    assert strokes(page) == 2
