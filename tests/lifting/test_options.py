import pytest

from sketch2shape.errors import UsageError
from sketch2shape.lifting import LiftOptions
from sketch2shape.lifting.options import length


@pytest.mark.parametrize(
    ("text", "unit", "value"),
    [("40mm", "mm", 40), ("40mm", "cm", 4), ("1.5 in", "mm", 38.1), (12, "mm", 12), ("12", "cm", 12), ("7px", "px", 7)],
)
def test_lengths(text, unit, value):
    assert length(text, unit) == pytest.approx(value)


@pytest.mark.parametrize(
    "options",
    [
        {"depth": "-3mm"},
        {"width": "wide"},
        {"height": 0},
        {"depth": float("nan")},
        {"depth_ratio": 0},
        {"unit": "furlong"},
        {"projection": "fisheye"},
        {"up": "x"},
    ],
)
def test_nonsense_is_refused(options):
    with pytest.raises(UsageError):
        LiftOptions(**options)


@pytest.mark.parametrize("text", ["1e-9mm", "1e12mm", 1e-7])
def test_lengths_that_no_file_can_hold_are_refused(text):
    with pytest.raises(UsageError, match="is too"):
        LiftOptions(width=text)


def test_unit_follows_the_sizes_unless_it_is_given():
    assert LiftOptions(width="40mm").solid_unit == "mm"
    assert LiftOptions(width="40mm", unit="cm").sizes() == (4.0, None, None)
    assert LiftOptions().solid_unit == "px"
