"""What is said while a batch runs."""

from __future__ import annotations

import io

import pytest

from sketch2shape.batch import progress
from sketch2shape.conversion.convert import Outcome, Output, Task

GOOD = (
    Task("in/a.png", "a.png", (Output("obj", "o/a.obj"),)),
    Outcome("a.png", confidence=0.95, found="box, 4 x 3 x 2 mm"),
)
BAD = (Task("in/[b].png", "[b].png", ()), Outcome("[b].png", 5, "nothing there", "draw"))


class _Terminal(io.StringIO):
    def isatty(self):
        return True


@pytest.mark.parametrize(("out", "quiet"), [(io.StringIO(), True), (io.StringIO(), False), (_Terminal(), False)])
def test_failures_are_always_said_in_full(out, quiet):
    with progress.follow(2, quiet=quiet, stream=out) as follower:
        follower.advance(*GOOD)
        follower.advance(*BAD)
    assert "in/[b].png: nothing there. Try: draw\n" in out.getvalue()
    assert ("in/a.png: box, 4 x 3 x 2 mm -> o/a.obj\n" in out.getvalue()) is not quiet


def test_plain_lines_tell_rate_and_time_left(monkeypatch):
    clock = iter(range(0, 1000, 6))
    monkeypatch.setattr(progress.time, "monotonic", lambda: float(next(clock)))
    out = io.StringIO()
    with progress.follow(4, quiet=False, stream=out) as follower:
        for _ in range(2):
            follower.advance(*GOOD)
    assert out.getvalue().splitlines()[-1] == "2 of 4, 0 failed, 0.2/s, 12 s left"


def test_a_closed_stream_does_not_stop_the_work():
    out = io.StringIO()
    follower = progress.follow(1, quiet=True, stream=out)
    out.close()
    follower.advance(*BAD)


def test_without_standard_error_nothing_is_said(monkeypatch):
    monkeypatch.setattr(progress.sys, "stderr", None)
    with progress.follow(1, quiet=False) as follower:
        follower.advance(*BAD)
        follower.say("hello")
