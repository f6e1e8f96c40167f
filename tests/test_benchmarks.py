"""What the benchmark's figures are made of; no clock is asserted on."""

import importlib
import sys
from pathlib import Path

import cv2
import numpy as np
import pytest

ROOT = Path(__file__).parent.parent


@pytest.fixture(scope="module", autouse=True)
def _importable():
    sys.path.insert(0, str(ROOT))
    yield
    sys.path.remove(str(ROOT))


def module(name):
    return importlib.import_module(f"benchmarks.{name}")


def test_exponent_is_the_power_of_a_power_law():
    x = np.array([1.0, 2, 5, 10])
    assert module("timing").exponent(x, 3 * x**1.7) == pytest.approx(1.7)


def test_calls_take_turns_and_the_first_round_is_not_counted():
    seen = []
    seconds = module("timing").in_turn({"a": lambda: seen.append("a"), "b": lambda: seen.append("b")}, 2)
    assert seen == ["a", "b"] * 3
    assert set(seconds) == {"a", "b"}


def test_growth_pictures_have_the_size_and_the_corners_they_claim(tmp_path):
    subjects = module("subjects")
    for megapixels, path in subjects.of_pixels(tmp_path, (0.1, 1.0)).items():
        h, w = cv2.imread(str(path), cv2.IMREAD_GRAYSCALE).shape
        assert h * w == pytest.approx(megapixels * 1e6, rel=0.02)
    for n in (3, 12, 25):
        ring = subjects.gear(n)
        a, b = ring - np.roll(ring, 1, 0), np.roll(ring, -1, 0) - ring
        assert np.abs(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]).min() > 1e-4


def test_the_page_shows_each_table_and_plot(tmp_path):
    pytest.importorskip("matplotlib")
    timing, page = module("timing"), module("page")
    table = timing.Table("Speed", "Of something.", ["", "times"], [["ours", "1.20"]])
    plot = timing.Plot("size", "megapixels", "time", {"ours": ([1, 10], [1, 9])})
    page.write(tmp_path / "performance.md", [timing.Report([table], [plot])], "python -m benchmarks")
    text = (tmp_path / "performance.md").read_text()
    assert "| ours | 1.20 |" in text
    assert "python -m benchmarks" in text
    assert (tmp_path / "performance_size.svg").read_text().startswith("<?xml")
