"""The page in a real browser: what a person does with a picture, and what becomes of it."""

from __future__ import annotations

from pathlib import Path

import pytest
import trimesh
from selenium.common.exceptions import StaleElementReferenceException
from selenium.webdriver import ActionChains, Chrome
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

from .browsing import (
    blank_page,
    downloaded,
    drag,
    message,
    needs_browser,
    place,
    read,
    upload,
    vertex,
    volume,
    wait,
)

pytestmark = needs_browser


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


def test_a_folder_becomes_a_filmstrip_with_what_needs_a_look_first(
    page: Chrome, box_png: bytes, tmp_path: Path
) -> None:
    folder = tmp_path / "sheets"
    folder.mkdir()
    folder.joinpath("a.png").write_bytes(box_png)
    blank_page(folder / "b.png", 80, 80)
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
