import numpy as np

from sketch2shape.pictures import Entry, contact_sheet, encode_png, folder_index, overlay
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
    assert '<li class="bad">' in page
    assert "not an image" in page
    assert "<bad>" not in page
    assert "<drawings>" not in page


def test_an_unsure_answer_is_marked_to_be_checked() -> None:
    page = folder_index([Entry("a.png", confidence=0.7), Entry("b.png", confidence=0.95)], "two")
    assert "2 pictures: 2 done, 1 of them to be checked, 0 failed" in page
    assert '<li class="doubt">' in page
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
