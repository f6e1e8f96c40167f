"""Many pictures from Python."""

from __future__ import annotations

import numpy as np
import pytest
import stand_in

import sketch2shape as s2s
from sketch2shape.batch import many
from sketch2shape.errors import LimitError, NoObjectError, UnreadableError
from sketch2shape.pipeline.report import report


@pytest.fixture(autouse=True)
def _stand_in(monkeypatch):
    monkeypatch.setattr(many, "_reconstruct", stand_in.reconstruct_numbered)


def test_one_result_for_each_source_in_their_order(tmp_path):
    dark = np.zeros((30, 40, 3), np.uint8)
    sources = [dark, "missing.png", dark + 255, "slow.png", "crash.png", "hang.png", dark[:10]]
    results = list(s2s.reconstruct_many(iter(sources), jobs=2, timeout=10))
    assert [len(r.objects) for r in results] == [1, 0, 0, 0, 0, 0, 1]
    assert results[0].error is None
    assert results[0].picture.pixels.shape == (30, 40, 3)
    assert results[6].picture.pixels.shape == (10, 40, 3)
    assert isinstance(results[1].error, UnreadableError)
    assert isinstance(results[2].error, NoObjectError)
    assert "SIGSEGV" in results[4].error.message
    assert isinstance(results[5].error, LimitError)
    data = report(results[1])
    assert (data["status"], data["source"], data["width"]) == ("failed", "missing.png", None)


def test_it_is_a_generator_that_may_be_left():
    endless = (np.zeros((9, 9), np.uint8) for _ in iter(int, 1))
    results = s2s.reconstruct_many(endless, jobs=1)
    assert len(next(results).objects) == 1
    results.close()
