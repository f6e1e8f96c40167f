"""Shared by all tests: the committed drawings with their truth."""

import json
import os
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

from synthetic.recipes import HARD

#: how long an example takes says more about the machine than about the code
settings.register_profile("any machine", deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("any machine")

DRAWINGS = Path(__file__).parent.parent / "data" / "synthetic"
EACH = 6
"""One in so many of the hard drawings is tried here, as they take seconds each; `scripts/evaluate.py` tries all."""


def pytest_collection_modifyitems(items):
    """Skip what needs pipes, permissions, descriptors or signals of a POSIX system where there are none."""
    if os.name != "posix":
        for item in items:
            if item.get_closest_marker("posix"):
                item.add_marker(pytest.mark.skip(reason="needs a POSIX system"))


def pytest_generate_tests(metafunc):
    """Run a test that takes `drawing` or `hard_drawing` once for each, or some, committed: (picture's path, truth)."""
    for name in {"drawing", "hard_drawing"} & set(metafunc.fixturenames):
        files = [f for f in sorted(DRAWINGS.glob("*/*.json")) if (f.parent.name in HARD) == (name == "hard_drawing")]
        files = files[:: EACH if name == "hard_drawing" else 1]
        pairs = [(next(p for p in f.parent.glob(f"{f.stem}.*") if p != f), json.loads(f.read_text())) for f in files]
        metafunc.parametrize(name, pairs, ids=[t["id"] for _, t in pairs])


@pytest.fixture(scope="session")
def drawings():
    """Folder of the committed drawings."""
    return DRAWINGS
