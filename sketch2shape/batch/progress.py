"""Telling how a batch goes: a bar on a terminal, plain lines elsewhere, nothing but failures if asked to be quiet."""

from __future__ import annotations

import sys
import time
from types import TracebackType
from typing import Any, Protocol, TextIO

from sketch2shape.conversion.convert import Outcome, Task
from sketch2shape.conversion.telling import Teller

#: seconds between two plain lines
_INTERVAL = 10.0


class Progress(Protocol):
    """Follows a batch."""

    def __enter__(self) -> Progress:
        """Begin."""

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """End, however the batch ended."""

    def advance(self, task: Task, outcome: Outcome) -> None:
        """One input is done."""

    def say(self, line: str) -> None:
        """Show a line."""


def follow(total: int, *, quiet: bool, stream: TextIO | None = None) -> Progress:
    """The progress for a batch of `total` inputs that suits the stream (standard error, where there is one)."""
    out = stream or sys.stderr
    if quiet or out is None:
        return _Quiet(out)
    return _Bar(total, out) if _is_terminal(out) else _Lines(total, out)


def _is_terminal(out: TextIO) -> bool:
    try:
        return out.isatty()
    except (OSError, ValueError):  # closed
        return False


class _Quiet:
    """Failures only."""

    def __init__(self, out: TextIO | None) -> None:
        self._out = out
        self._teller = Teller()

    def __enter__(self) -> Progress:
        return self

    def __exit__(self, *_: object) -> None:
        pass

    def advance(self, task: Task, outcome: Outcome) -> None:
        if outcome.message is not None:
            self.say(self._teller.failure(task, outcome))

    def say(self, line: str) -> None:
        if self._out is None:
            return
        try:
            self._out.write(line + "\n")
            self._out.flush()
        except (OSError, ValueError):  # nobody listens any more: the work goes on
            pass


class _Talkative(_Quiet):
    """A line for each input."""

    def advance(self, task: Task, outcome: Outcome) -> None:
        super().advance(task, outcome)
        if outcome.message is None:
            for line in self._teller.success(task, outcome):
                self.say(line)


class _Lines(_Talkative):
    """A plain line now and then about the whole."""

    def __init__(self, total: int, out: TextIO) -> None:
        super().__init__(out)
        self._total, self._done, self._failed = total, 0, 0
        self._begin = self._last = time.monotonic()

    def advance(self, task: Task, outcome: Outcome) -> None:
        super().advance(task, outcome)
        self._done += 1
        self._failed += outcome.exit_code != 0
        now = time.monotonic()
        if now - self._last >= _INTERVAL:
            self._last = now
            rate = self._done / (now - self._begin)
            left = (self._total - self._done) / rate
            self.say(f"{self._done} of {self._total}, {self._failed} failed, {rate:.1f}/s, {left:.0f} s left")


class _Bar(_Talkative):
    """A bar with rate and time left."""

    def __init__(self, total: int, out: TextIO) -> None:
        super().__init__(out)
        from rich.console import Console
        from rich.progress import BarColumn, MofNCompleteColumn, TextColumn, TimeRemainingColumn
        from rich.progress import Progress as RichProgress

        self._bar = RichProgress(
            BarColumn(),
            MofNCompleteColumn(),
            TextColumn("{task.fields[failed]} failed"),
            TextColumn("{task.fields[rate]:.1f}/s"),
            TimeRemainingColumn(),
            console=Console(file=out),
            transient=True,
        )
        self._bar_id = self._bar.add_task("", total=total, failed=0, rate=0.0)
        self._done, self._failed, self._begin = 0, 0, time.monotonic()

    def __enter__(self) -> Progress:
        self._bar.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._bar.stop()

    def advance(self, task: Task, outcome: Outcome) -> None:
        super().advance(task, outcome)
        self._done += 1
        self._failed += outcome.exit_code != 0
        rate = self._done / max(time.monotonic() - self._begin, 1e-3)
        fields: dict[str, Any] = {"failed": self._failed, "rate": rate}
        self._bar.update(self._bar_id, advance=1, **fields)

    def say(self, line: str) -> None:
        self._bar.console.print(line, markup=False, highlight=False, soft_wrap=True)
