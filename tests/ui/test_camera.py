"""The camera in a real browser: Chromium's false one, and none at all."""

from __future__ import annotations

from pathlib import Path

from selenium.webdriver import Chrome
from selenium.webdriver.common.by import By

from .browsing import message, needs_browser, read, wait
from .chromium import start_browser

pytestmark = needs_browser

FALSE_CAMERA = ("--use-fake-device-for-media-stream", "--use-fake-ui-for-media-stream")


def is_on(page: Chrome) -> bool:
    return bool(page.execute_script("return document.getElementById('camera').srcObject?.active ?? false"))


def test_a_photo_is_taken_looked_at_and_the_camera_turned_off(address: str, tmp_path: Path) -> None:
    with start_browser(tmp_path, *FALSE_CAMERA) as page:
        page.get(address)
        wait(lambda: page.find_elements(By.CSS_SELECTOR, "#gallery button"))
        page.find_element(By.ID, "start-photo").click()
        wait(lambda: is_on(page) and page.execute_script("return document.getElementById('camera').videoWidth"))
        page.find_element(By.CSS_SELECTOR, "#camera-box button:not(.main)").click()
        wait(lambda: not is_on(page))
        assert read(page, "body", "className") == ""
        page.find_element(By.ID, "photo").click()
        wait(lambda: is_on(page) and page.execute_script("return document.getElementById('camera').videoWidth"))
        page.find_element(By.ID, "shoot").click()
        # what it shows is no drawing: the photo is there, to be traced
        wait(lambda: page.find_elements(By.CSS_SELECTOR, "#editor image"))
        wait(lambda: "Looking" not in message(page))
        assert not is_on(page)


def test_where_there_is_no_camera_that_is_said(page: Chrome) -> None:
    page.find_element(By.ID, "start-photo").click()
    wait(lambda: message(page).startswith("No camera can be used here"))
    assert not page.find_elements(By.CSS_SELECTOR, "#camera-box[open]")
