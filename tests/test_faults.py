"""The campaigns of damage, small."""

from __future__ import annotations

import numpy as np
import pytest

from benchmarks.faults import bombs, leak, names, rasters, reader
from benchmarks.faults.hostile import KINDS, hostile
from benchmarks.faults.samples import mutated, samples
from sketch2shape.errors import CrashError
from sketch2shape.reading.read import read_picture


@pytest.mark.parametrize("name", samples())
def test_samples_are_sound_until_they_are_damaged(name):
    data = samples()[name]
    assert read_picture(data).pixels.size
    assert any(mutated(data, np.random.default_rng(i)) != data for i in range(3))


def test_damaged_files_give_typed_errors():
    assert reader.run(300, jobs=1)["findings"] == []


def test_bombs_are_refused():
    found = bombs.bombs()
    assert len(found) >= 20
    for name in ("rgb.png", "strips.tif", "canvas.webp", "text.png"):
        assert len(found[name]) < 2**20
    kinds = {name: _refusal(data) for name, data in found.items()}
    assert set(kinds.values()) == {"LimitError", "UnreadableError"}
    assert kinds["rgb.png"] == kinds["canvas.webp"] == kinds["large.tif"] == "LimitError"


def _refusal(data):
    try:
        read_picture(data)
    except Exception as error:
        return type(error).__name__


def test_odd_names_give_one_output_each():
    assert names.run(25)["findings"] == []


def test_conversions_leave_no_descriptor_open():
    outcome = leak.run(60)
    before, after = outcome["file descriptors"]
    assert after <= before  # what other tests left open may be closed meanwhile


def test_rasters_are_the_same_for_the_same_number():
    for number in range(len(KINDS)):
        kind, raster = hostile(number)
        assert kind == KINDS[number]
        assert raster.tobytes() == hostile(number)[1].tobytes()
    assert rasters.try_raster(0)[0] == "NoObjectError"


def test_slow_wrong_and_lost_rasters_are_findings():
    ours = {
        0: ("NoObjectError", 0.1, ""),
        1: ("solid", 7.0, "not finite"),
        3: ("sure solid", 1.0, ""),
        2: CrashError("the worker died"),
    }
    told = rasters.summary(ours)
    assert told["outcomes"] == {"NoObjectError": 1, "solid": 1, "sure solid": 1}
    assert told["solids in kinds that hold no object"] == {KINDS[1]: 1}
    assert told["the same with a confidence of 0.9 or more"] == {KINDS[3]: 1}
    assert told["over 1 s, over 5 s"] == [1, 1]
    assert [finding.split(": ")[1] for finding in told["findings"]] == ["7.0 s", "not finite", "the worker died"]
