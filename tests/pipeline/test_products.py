"""Names and endings of what can be written."""

from __future__ import annotations

import pytest

from sketch2shape.errors import UsageError
from sketch2shape.export import FORMATS
from sketch2shape.pipeline.products import SUFFIXES, infixed, product_of, suffix


@pytest.mark.parametrize("product", [*FORMATS, *SUFFIXES])
def test_every_product_has_an_ending(product):
    assert suffix(product).startswith(".")


@pytest.mark.parametrize("name", ["a.obj", "A.STL", "a.b.json"])
def test_product_of_a_name(name):
    assert suffix(product_of(name)) == "." + name.lower().rpartition(".")[2]


def test_unknown_ones_are_usage_errors():
    for call in (lambda: suffix("xyz"), lambda: product_of("a.xyz"), lambda: product_of("a")):
        with pytest.raises(UsageError):
            call()


def test_infix_goes_before_the_ending():
    assert infixed("x/a.b.obj", "obj", ".2") == "x/a.b.2.obj"
    assert infixed("A.OBJ", "obj", ".p3") == "A.p3.OBJ"
    assert infixed("-", "obj", ".2") == "-"
