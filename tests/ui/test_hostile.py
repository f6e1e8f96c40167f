"""A thousand requests that no page of its own would send; the script that sends them is also for use by hand."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from types import ModuleType

import pytest

SCRIPT = Path(__file__).parents[2] / "scripts" / "hostile_requests.py"


def load() -> ModuleType:
    spec = importlib.util.spec_from_file_location("hostile_requests", SCRIPT)
    assert spec is not None
    assert spec.loader is not None
    module = sys.modules["hostile_requests"] = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize("served", ["ui", "serve"])
def test_hostile_requests_are_refused_and_leave_no_trace(served: str) -> None:
    verdict = load().run(1000, 7, served)
    assert verdict.wrong == []
    assert sum(verdict.counts.values()) == 1000
    before, after = verdict.memory
    assert after - before < 150 * 2**20
