"""How an object is drawn, told in a corrections file."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from sketch2shape.corrections import corrections_from
from sketch2shape.corrections.manner import manner_from
from sketch2shape.errors import UsageError

SQUARE = [[0, 0], [200, 0], [200, 200], [0, 200]]


def test_what_a_report_tells_is_kept_with_the_faces() -> None:
    entry = {"f1": SQUARE, "d": [80, -90], "lines": "removed", "noise": 2.5, "f2_drawn": [True, True, True, False]}
    found = corrections_from({"objects": [entry]})
    assert found is not None
    shape = found.objects[0].shape
    assert shape is not None
    assert (shape.lines, shape.noise) == ("removed", 2.5)
    assert shape.f2_drawn is not None
    assert shape.f2_drawn.tolist() == [True, True, True, False]
    assert shape.page is None


def test_nothing_need_be_told() -> None:
    assert manner_from({"noise": None}, 4, "object 1") == {}


def test_a_tilted_page_is_kept() -> None:
    page = [[1, 0.1, 3], [0, 1, 0], [1e-4, 0, 1]]
    assert np.allclose(manner_from({"page": page}, 4, "object 1")["page"], page)


@pytest.mark.parametrize(
    ("entry", "said"),
    [
        ({"lines": "wavy"}, "wire, dashed, removed"),
        ({"noise": -1}, "number of pixels"),
        ({"noise": "much"}, "number of pixels"),
        ({"noise": float("nan")}, "number of pixels"),
        ({"f2_drawn": [1, 0, 1, 0]}, "true and false"),
        ({"f2_drawn": [True]}, "tells of 1 vertices"),
        ({"page": [[1, 0], [0, 1]]}, "three rows"),
        ({"page": [[1, 0, 0], [0, 1, 0], [0, 0, float("inf")]]}, "three rows"),
        ({"page": [[1, 0, 0], [1, 0, 0], [0, 0, 1]]}, "no view of a page"),
    ],
)
def test_what_no_report_tells_is_refused(entry: dict[str, Any], said: str) -> None:
    with pytest.raises(UsageError, match=said):
        manner_from(entry, 4, "object 1")
