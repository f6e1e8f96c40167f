"""The page in a real browser: what a person does with it, and what becomes of it."""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import pytest
import trimesh
from selenium.common.exceptions import StaleElementReferenceException, WebDriverException
from selenium.webdriver import ActionChains, Chrome
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

from .chromium import missing, start_browser
from .server import start_app

pytestmark = pytest.mark.skipif(missing() is not None, reason=str(missing()))

#: a box on the drawing pad, from its middle, pixels of the screen
FRONT = [(-150, -60), (50, -60), (50, 110), (-150, 110)]
SHIFT = (90, -70)


@pytest.fixture(scope="module")
def address() -> Iterator[str]:
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
def page(browser: Chrome, address: str) -> Chrome:
    browser.get(address)
    wait(lambda: browser.find_elements(By.CSS_SELECTOR, "#gallery button"))
    return browser


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


@pytest.fixture
def box_file(box_png: bytes, tmp_path: Path) -> Path:
    path = tmp_path / "box.png"
    path.write_bytes(box_png)
    return path


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


def test_upload_drag_undo_and_download_a_watertight_mesh(page: Chrome, box_file: Path, downloads: Path) -> None:
    upload(page, box_file)
    assert len(page.find_elements(By.CSS_SELECTOR, "g.vertex")) == 8
    before, x, y = volume(page), *place(page, 1, 0)
    mesh_before = page.execute_script("return document.getElementById('solid').toDataURL()")

    page.find_element(By.ID, "pair").click()
    drag(page, vertex(page, 1, 0), -40, -30)
    assert place(page, 1, 0) != (x, y)
    wait(lambda: volume(page) != before and "follows" in message(page))
    wait(lambda: page.execute_script("return document.getElementById('solid').toDataURL()") != mesh_before)

    ActionChains(page).key_down(Keys.CONTROL).send_keys("z").key_up(Keys.CONTROL).perform()
    wait(lambda: volume(page) == pytest.approx(before, rel=1e-3))
    assert place(page, 1, 0) == (x, y)
    page.find_element(By.ID, "redo").click()
    wait(lambda: volume(page) != pytest.approx(before, rel=1e-3))
    page.find_element(By.ID, "undo").click()
    wait(lambda: volume(page) == pytest.approx(before, rel=1e-3))

    page.find_element(By.ID, "download").click()
    page.find_element(By.ID, "take-it").click()  # no size was given: the longest side becomes 60 mm
    mesh = trimesh.load(downloaded(downloads, "box.stl"), force="mesh")
    assert mesh.is_watertight
    assert max(mesh.extents) == pytest.approx(60, rel=1e-3)
    assert mesh.bounds[0][2] == pytest.approx(0, abs=1e-6)  # it stands on the bed
    wait(lambda: volume(page) == pytest.approx(mesh.volume, rel=0.02))


def test_a_wrong_vertex_is_dragged_to_its_place(page: Chrome, box_file: Path, tmp_path: Path) -> None:
    upload(page, box_file)
    right, (x, y) = volume(page), place(page, 1, 2)
    drag(page, vertex(page, 1, 2), 60, 40)  # now it is wrong
    wait(lambda: volume(page) != pytest.approx(right, rel=1e-3))
    scale = page.execute_script("return document.getElementById('editor').getScreenCTM().a")
    wrong_x, wrong_y = place(page, 1, 2)
    drag(page, vertex(page, 1, 2), round((x - wrong_x) * scale), round((y - wrong_y) * scale))
    wait(lambda: volume(page) == pytest.approx(right, rel=0.05))


def draw_box(page: Chrome) -> None:
    page.find_element(By.ID, "draw").click()
    pad = page.find_element(By.ID, "pad")
    for i, (x, y) in enumerate(FRONT):
        u, v = FRONT[(i + 1) % 4]
        for a, b, c, d in ((x, y, u, v), (x + 90, y - 70, u + 90, v - 70), (x, y, x + 90, y - 70)):
            ActionChains(page, duration=10).move_to_element_with_offset(
                pad, a, b
            ).click_and_hold().move_to_element_with_offset(pad, c, d).release().perform()


def strokes(page: Chrome) -> int:
    return int(page.execute_script("return window.timings.state().strokes.length"))


def test_a_solid_stands_up_while_a_box_is_drawn(page: Chrome) -> None:
    draw_box(page)
    wait(lambda: "That is a solid" in message(page) and volume(page))
    assert strokes(page) == 12
    page.find_element(By.ID, "adjust").click()
    assert len(page.find_elements(By.CSS_SELECTOR, "g.vertex")) == 8


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


def test_real_sizes_are_those_of_the_upright_solid(page: Chrome, box_file: Path) -> None:
    upload(page, box_file)
    for name, value in (("width", "40"), ("height", "2,5 cm"), ("depth", "60")):
        field = page.find_element(By.ID, f"size-{name}")
        field.send_keys(value)
    page.find_element(By.ID, "facts").click()
    wait(lambda: read(page, "#facts").startswith("40 wide, 25 high, 60 deep mm"))


def test_a_number_typed_badly_is_refused_beside_its_field(page: Chrome, box_file: Path) -> None:
    upload(page, box_file)
    before = volume(page)
    page.find_element(By.ID, "size-width").send_keys("-3")
    assert "Not a length" in read(page, "#error-width")
    assert read(page, "#size-width", "ariaInvalid") == "true"
    assert volume(page) == before


def test_a_size_is_changed_where_it_stands_on_the_solid(page: Chrome, box_file: Path) -> None:
    upload(page, box_file)
    page.find_element(By.CSS_SELECTOR, "#dimensions [data-size=width]").click()
    page.switch_to.active_element.send_keys("30 mm", Keys.ENTER)
    wait(lambda: read(page, "#facts").startswith("30 wide"))
    assert read(page, "#size-width", "value") == "30"


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
    import cv2
    import numpy as np

    blank = tmp_path / "blank.png"
    cv2.imwrite(str(blank), np.full((400, 500, 3), 255, np.uint8))
    page.find_element(By.ID, "file").send_keys(str(blank))
    wait(lambda: "Trace it by hand" in message(page))
    editor = page.find_element(By.ID, "editor")
    for x, y in [*FRONT, FRONT[0], (FRONT[0][0] + SHIFT[0], FRONT[0][1] + SHIFT[1])]:
        ActionChains(page).move_to_element_with_offset(editor, x, y).click().perform()
    wait(lambda: volume(page) > 0)
    assert len(page.find_elements(By.CSS_SELECTOR, "g.vertex")) == 8


def test_single_vertices_are_told_apart_and_connected(page: Chrome, tmp_path: Path) -> None:
    import cv2
    import numpy as np

    blank = tmp_path / "white.png"
    cv2.imwrite(str(blank), np.full((400, 500, 3), 255, np.uint8))
    page.find_element(By.ID, "file").send_keys(str(blank))
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


def test_a_folder_becomes_a_filmstrip_with_what_needs_a_look_first(
    page: Chrome, box_png: bytes, tmp_path: Path
) -> None:
    import cv2
    import numpy as np

    folder = tmp_path / "sheets"
    folder.mkdir()
    folder.joinpath("a.png").write_bytes(box_png)
    cv2.imwrite(str(folder / "b.png"), np.full((80, 80, 3), 255, np.uint8))
    folder.joinpath("notes.txt").write_text("no picture")
    page.find_element(By.ID, "folder").send_keys(str(folder))
    wait(lambda: read(page, "#strip").count(":") == 2 and "waiting" not in read(page, "#strip"))
    assert read(page, "#strip li:first-child").startswith("b.png")
    page.find_element(By.CSS_SELECTOR, "#strip li:last-child button").click()
    wait(lambda: volume(page) > 0 and "a.png" in message(page))


def test_a_page_of_a_pdf_is_chosen(page: Chrome, box_png: bytes, tmp_path: Path) -> None:
    pytest.importorskip("pypdfium2")
    from io import BytesIO

    from PIL import Image

    box = Image.open(BytesIO(box_png)).convert("RGB")
    Image.new("RGB", box.size, "white").save(tmp_path / "two.pdf", save_all=True, append_images=[box])
    page.find_element(By.ID, "file").send_keys(str(tmp_path / "two.pdf"))
    wait(lambda: "No object was found" in message(page))
    assert read(page, "#pages") == "Page 1 of 2Page 2 of 2"
    page.execute_script("const p = document.getElementById('pages'); p.value = 1; p.dispatchEvent(new Event('change'))")
    wait(lambda: "Found the object" in message(page) and volume(page))


def test_what_cannot_be_read_here_is_said_before_the_upload(page: Chrome, tmp_path: Path) -> None:
    photo = tmp_path / "photo.heic"
    photo.write_bytes(b"no photo")
    page.execute_script("window.timings.reads({heic: false})")
    page.find_element(By.ID, "file").send_keys(str(photo))
    wait(lambda: "HEIC cannot be read here" in message(page))


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


def test_what_is_no_picture_is_said_on_the_page(page: Chrome, tmp_path: Path) -> None:
    text = tmp_path / "notes.txt"
    text.write_text("not a drawing")
    page.find_element(By.ID, "file").send_keys(str(text))
    wait(lambda: "not a picture" in message(page).lower())
    assert "bad" in page.find_element(By.ID, "message").get_attribute("class")


def test_examples_are_one_click_away_and_fit_a_narrow_screen(page: Chrome) -> None:
    page.set_window_size(420, 900)
    try:
        page.find_elements(By.CSS_SELECTOR, "#gallery button")[1].click()
        wait(lambda: "Found the object" in message(page))
        assert page.execute_script("return document.documentElement.scrollWidth <= innerWidth")
    finally:
        page.set_window_size(1400, 1000)


def test_the_page_asks_nobody_else_and_reports_no_errors(page: Chrome, address: str, box_file: Path) -> None:
    page.get_log("browser")
    upload(page, box_file)
    asked = page.execute_script("return performance.getEntriesByType('resource').map(e => e.name)")
    assert asked
    assert all(a.startswith((address, "data:", "blob:")) for a in asked)
    assert page.get_log("browser") == []


def test_everything_that_can_be_used_has_a_name(page: Chrome, box_file: Path) -> None:
    def asked() -> list[str] | None:
        """None if the page was painted anew meanwhile."""
        usable = page.find_elements(
            By.CSS_SELECTOR, "button, select, input, canvas, svg[role], g[role], [tabindex='0']"
        )
        try:
            return [e.get_attribute("outerHTML")[:80] for e in usable if e.is_displayed() and not e.accessible_name]
        except StaleElementReferenceException:
            return None

    def nameless() -> list[str]:
        answers: list[list[str]] = []
        wait(lambda: (now := asked()) is not None and not answers.append(now))
        return answers[-1]

    assert nameless() == []
    upload(page, box_file)
    assert nameless() == []
    page.find_element(By.ID, "draw").click()
    assert nameless() == []
