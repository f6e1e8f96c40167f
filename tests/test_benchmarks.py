"""What the benchmark's figures are made of; no clock is asserted on."""

import importlib
import sys
from pathlib import Path

import cv2
import numpy as np
import pytest

from sketch2shape.pipeline import reconstruct

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
    assert module("timing").steepest(x, 3 * x**1.7) == pytest.approx(1.7)
    assert module("timing").steepest(x, [1, 1, 25, 25]) > 3


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
    for n in (3, 6, 12, 25, 200):
        ring = subjects.bracket(n)
        assert ring.shape == (n, 2)
        a, b = ring - np.roll(ring, 1, 0), np.roll(ring, -1, 0) - ring
        turns = cross(a, b) / (np.linalg.norm(a, axis=1) * np.linalg.norm(b, axis=1))
        assert np.abs(turns).min() > 0.08
        # no edge along the depth, and none shorter than 12 pixels of 1100
        along = cross(a, subjects.THIN) / (np.linalg.norm(a, axis=1) * np.linalg.norm(subjects.THIN))
        assert np.abs(along).min() > np.sin(np.radians(20))
        assert np.linalg.norm(a, axis=1).min() * 825 > 12


def cross(a, b):
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]


@pytest.mark.parametrize("n", [24, 50, 200])
def test_a_drawing_with_very_many_vertices_is_found(n, tmp_path):
    (path,) = module("subjects").of_vertices(tmp_path, [n]).values()
    (found,) = reconstruct(path).objects
    assert len(found.f1) == n


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


def _called(call):
    call()
    return 1.0


def test_what_is_not_installed_is_left_out_and_named(tmp_path, monkeypatch):
    for name in ("concave_hull", "vtracer", "matplotlib"):
        monkeypatch.setitem(sys.modules, name, None)
    monkeypatch.setattr(
        module("peers"), "in_turn", lambda calls, _rounds: {name: _called(call) for name, call in calls.items()}
    )
    monkeypatch.setattr(module("peers").shutil, "which", lambda _name: None)
    monkeypatch.setattr(module("peers"), "times", str)
    monkeypatch.setattr(module("peers").subjects, "small_drawings", lambda _scratch, _number: [])
    (hulls,) = module("peers").connectors(tmp_path, quick=True).tables
    assert "what `concave-hull` needs" in hulls.words
    assert "`auto`" in [row[0] for row in hulls.rows]
    (tracers,) = module("peers").tracers(tmp_path, quick=True).tables
    assert "Not installed here: potrace, vtracer" in tracers.words
    plot = module("timing").Plot("size", "megapixels", "time", {"ours": ([1, 10], [1, 9])})
    module("page").write(
        tmp_path / "performance.md", [module("timing").Report([hulls], [plot])], "python -m benchmarks"
    )
    assert "performance_size.svg" not in (tmp_path / "performance.md").read_text()
