"""The error tree: exit codes, remedies, one line for each failure."""

from __future__ import annotations

import pickle
import subprocess
import sys
from pathlib import Path

import pytest

from sketch2shape import errors


def tree(root):
    yield root
    for child in root.__subclasses__():
        yield from tree(child)


KINDS = list(tree(errors.Sketch2ShapeError))


@pytest.mark.parametrize("kind", KINDS)
def test_every_error_says_what_to_try_and_survives_a_process_boundary(kind):
    assert kind.remedy
    error = pickle.loads(pickle.dumps(kind("what happened", remedy="this")))
    assert (type(error), error.message, error.advice) == (kind, "what happened", "this")


def test_exit_codes_of_the_contract():
    codes = {kind.__name__: kind.exit_code for kind in KINDS}
    assert codes["UsageError"] == 2
    assert codes["UnreadableError"] == 4
    assert codes["NoObjectError"] == 5
    assert codes["LimitError"] == 6
    assert codes["WriteError"] == 7
    assert codes["MissingPackageError"] == 8
    assert codes["CrashError"] == 1


def test_one_line_whatever_the_name_holds():
    line = errors.one_line("a\nb\x1b[31m\udcff.png", "bad", "good")
    assert line == "a\\nb\\x1b[31m\\udcff.png: bad. Try: good"
    assert errors.one_line("ä 图.png", "bad", "good").startswith("ä 图.png")


def test_the_page_of_errors_is_made_from_the_tree():
    script = Path(__file__).parents[1] / "scripts" / "make_error_page.py"
    assert subprocess.run([sys.executable, str(script), "--check"], check=False).returncode == 0
