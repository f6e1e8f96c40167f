"""The list of the numbers that the heart was tuned with: from the code as it stands, and each with its meaning."""

import pytest
from loaded import loaded

from evaluation.markdown import part_replaced


@pytest.fixture(scope="module")
def numbers():
    return loaded("list_numbers")


def test_the_page_lists_the_numbers_of_the_code(numbers):
    page = numbers.PAGE.read_text("utf-8")
    assert part_replaced(page, "numbers", numbers.listing()) == page, "run scripts/list_numbers.py"


def test_every_number_says_what_it_means(numbers):
    every = [n for room in numbers.ROOMS for module in numbers.modules_of(room) for n in numbers.numbers_of(module)]
    assert [n for n in every if not n.meaning] == []


def test_numbers_are_told_from_words_and_from_what_follows(numbers, tmp_path):
    module = tmp_path / "some.py"
    module.write_text(
        'LONG, WIDE = 3, -0.5\n"""Pixels,\nand pens."""\nTWICE: int = 2 * LONG\n"""Pixels."""\nBARE = 7\n'
        'NAMES = ("a", "b")\n"""Words."""\nON = True\n_PLACES = [k / LONG for k in range(3)]\nsmall = 4\n'
        "def f(x, most=12):\n    return 0.5 * x + 2 - 0.03 if x else True\n"
    )
    assert list(numbers.numbers_of(module)) == [
        numbers.Number(("LONG", "WIDE"), "3, -0.5", "some", "Pixels, and pens."),
        numbers.Number(("TWICE",), "2 * LONG", "some", "Pixels."),
        numbers.Number(("BARE",), "7", "some", ""),
    ]
    assert numbers.unnamed_in(module) == 2


def test_a_part_of_a_page_is_replaced_between_its_marks():
    page = "# Head\n\n<!-- a -->\n\nold\n\n<!-- end of a -->\n\nTail\n"
    new = part_replaced(page, "a", "new\n")
    assert new == "# Head\n\n<!-- a -->\n\nnew\n\n<!-- end of a -->\n\nTail\n"
    assert part_replaced(new, "a", "new\n") == new
