import re

import numpy as np
import pytest

from sketch2shape.pictures import (
    Entry,
    contact_sheet,
    contact_sheets,
    count_sheets,
    encode_png,
    folder_index,
    overlay,
)
from sketch2shape.pipeline.result import Result


def entries(result: Result) -> list[Entry]:
    return [
        Entry("a/b.png", overlay(result, legend=False), 0.97, None, [("mesh", "a/b c.obj"), ("3-D", "a/b.html")]),
        Entry("<bad>.png", None, None, "not an image"),
    ]


def test_the_index_counts_links_and_tells_what_failed(box: Result) -> None:
    page = folder_index(entries(box), "my <drawings>")
    assert "2 pictures: 1 done, 1 failed" in page
    assert 'href="a/b%20c.obj"' in page
    assert '<li class="bad"' in page
    assert "not an image" in page
    assert "<bad>" not in page
    assert "<drawings>" not in page


def test_an_unsure_answer_is_marked_to_be_checked() -> None:
    page = folder_index([Entry("a.png", confidence=0.7), Entry("b.png", confidence=0.95)], "two")
    assert "2 pictures: 2 done, 1 of them to be checked, 0 failed" in page
    assert '<li class="doubt"' in page
    assert "please check, confidence 0.70" in page


def test_the_sheet_has_a_card_for_each_input(box: Result) -> None:
    one, many = contact_sheet(entries(box)[:1]), contact_sheet(entries(box) * 4)
    assert many.shape[0] > one.shape[0]
    assert many.shape[1] > one.shape[1]
    assert np.array_equal(contact_sheet(entries(box)), contact_sheet(entries(box)))
    assert encode_png(contact_sheet(entries(box))) == encode_png(contact_sheet(entries(box)))


def test_an_empty_folder_has_a_sheet_and_a_page() -> None:
    assert contact_sheet([]).ndim == 3
    assert "0 pictures" in folder_index([], "empty")


NOT_UTF8 = b"caf\xe9/\xff.png".decode("utf-8", "surrogateescape")


def test_names_that_are_no_utf8_are_shown_and_linked() -> None:
    page = folder_index([Entry(NOT_UTF8, message=f"{NOT_UTF8} is odd", links=[("mesh", NOT_UTF8)])], NOT_UTF8)
    assert page.encode("utf-8").decode() == page
    assert 'href="caf%E9/%FF.png"' in page
    assert contact_sheet([Entry(NOT_UTF8, message=NOT_UTF8)]).ndim == 3


@pytest.mark.parametrize(("count", "sheets"), [(0, 1), (1, 1), (60, 1), (61, 2), (130, 3)])
def test_long_folders_take_several_sheets_of_a_size_that_can_be_opened(count: int, sheets: int) -> None:
    made = list(contact_sheets(Entry(f"{k}.png") for k in range(count)))
    assert len(made) == count_sheets(count) == sheets
    assert all(sheet.shape[0] < 3600 for sheet in made)
    cards = [contact_sheet([Entry(f"{k}.png") for k in range(start, min(start + 60, count))]) for start in (0, 60)]
    assert all(np.array_equal(a, b) for a, b in zip(made, cards, strict=False))


def test_the_index_can_be_filtered_and_sorted_without_a_script() -> None:
    page = folder_index(
        [Entry("b.png", confidence=0.95), Entry("a.png", confidence=0.7), Entry("c", message="no")], "x"
    )
    assert [int(m) for m in re.findall(r"--sure:(-?\d+)", page)] == [950, 700, -1]
    assert page.count('type="radio"') == 6
    assert "<script" not in page


def test_long_names_break_between_their_words() -> None:
    page = folder_index([Entry("front_view-of/some&thing.v2.png", confidence=1.0)], "x")
    assert "<h2>front_<wbr>view-<wbr>of/<wbr>some&amp;thing.<wbr>v2.<wbr>png</h2>" in page
