import re
from importlib.resources import files

import pytest

from sketch2shape.pictures.palette import (
    BACK,
    BACKDROP,
    DOUBT,
    FAILED,
    FRONT,
    INK,
    JOIN,
    MUTED,
    PAPER,
    Colour,
    css,
    mix,
)


def contrast(a: Colour, b: Colour) -> float:
    """Contrast ratio of the Web Content Accessibility Guidelines 2.2."""

    def luminance(colour: Colour) -> float:
        parts = [c / 255 for c in colour]
        r, g, b = (p / 12.92 if p <= 0.04045 else ((p + 0.055) / 1.055) ** 2.4 for p in parts)
        return 0.2126 * r + 0.7152 * g + 0.0722 * b

    dark, light = sorted([luminance(a), luminance(b)])
    return (light + 0.05) / (dark + 0.05)


@pytest.mark.parametrize("colour", [FRONT, BACK, JOIN, DOUBT])
def test_lines_stand_out_from_the_paper(colour: Colour) -> None:
    assert contrast(colour, PAPER) >= 4.0  # the guidelines ask 3 of graphics


@pytest.mark.parametrize("colour", [INK, MUTED, FAILED])
def test_words_can_be_read(colour: Colour) -> None:
    assert contrast(colour, BACKDROP) >= 4.5


def test_the_words_of_the_page_can_be_read_by_day_and_by_night() -> None:
    style = files("sketch2shape.ui").joinpath("page/style.css").read_text("utf-8")
    day, night = (
        {
            k: v if len(v) == 6 else "".join(c * 2 for c in v)
            for k, v in re.findall(r"--([\w-]+): #(\w{6}|\w{3});", part)
        }
        for part in style.split("@media (prefers-color-scheme: dark)", 1)
    )
    for colours in (day, {**day, **night}):
        rgb = {k: (int(v[:2], 16), int(v[2:4], 16), int(v[4:], 16)) for k, v in colours.items()}
        for words in ("ink", "muted", "bad", "front", "warn"):
            assert contrast(rgb[words], rgb["ground"]) >= 4.5, words
        for words, under in (("good", "goodtint"), ("warn", "warntint"), ("bad", "badtint"), ("on", "front")):
            assert contrast(rgb[words], rgb[under]) >= 4.5, words
    rgb = {k: (int(v[:2], 16), int(v[2:4], 16), int(v[4:], 16)) for k, v in day.items()}
    assert (rgb["front"], rgb["back"], rgb["join"]) == (FRONT, BACK, JOIN)  # the page and the pictures agree


def test_mixing_and_css() -> None:
    assert mix((0, 0, 0), (200, 100, 50), 0.5) == (100, 50, 25)
    assert css((0, 98, 178)) == "#0062b2"
