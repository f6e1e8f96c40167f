"""Running one function over many items in worker processes that may crash, hang or eat memory.

Strategy: a `pebble` pool, because a crash there loses only the item that caused it. A few items more than there are
workers are handed out at a time, so that memory stays flat however many there are. Where the pool itself breaks (a
worker killed from outside while idle), it is made anew and the items it lost are handed out again, a few times at most.
Where no worker can be started at all, the work is done in this process, and the reason is told.

Time is that of computing, so that a busy machine fails no item: the worker sets itself an alarm. One that waits and
does not compute is ended by the clock, a few times later.
"""

from __future__ import annotations

import contextlib
import logging
import os
import signal
import time
from collections import deque
from collections.abc import Callable, Generator, Iterable
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Future, wait
from dataclasses import dataclass
from functools import partial
from typing import Any, Generic, TypeVar

from sketch2shape.batch.worker import HAS_TIMER, PRELOAD, limited_time, prepare
from sketch2shape.conversion.convert import Outcome, Task, report_failure
from sketch2shape.errors import CrashError, LimitError, Sketch2ShapeError
from sketch2shape.processes.contexts import NoWorkersError, working_context

_LOG = logging.getLogger("sketch2shape")

T = TypeVar("T")
R = TypeVar("R")

#: items handed out at a time, for each worker: enough to keep it busy, few enough to bound memory
_AHEAD = 4
#: how often an item may be lost to a broken pool before it is given up
_TRIES = 3
#: a pool is broken if for this long it has items and works on none, seconds; starting workers takes a few
_PATIENCE = 20.0
#: times the limit on computing that an item may take by the clock: it may wait for the disk, or for other programs
WAITING = 5.0
#: how often the loop looks up from waiting, seconds
_POLL = 1.0


def run_tasks(
    tasks: Iterable[Task],
    work: Callable[[Task], Outcome],
    *,
    jobs: int | None = None,
    timeout: float | None = None,
    max_memory: int | None = None,
    notice: Callable[[str], None] | None = None,
) -> Generator[tuple[Task, Outcome], None, None]:
    """Do tasks in worker processes, in the order in which they finish; a crash or hang fails only its own."""
    for task, value in run_each(tasks, work, jobs=jobs, timeout=timeout, max_memory=max_memory, notice=notice):
        yield task, report_failure(task, value) if isinstance(value, Sketch2ShapeError) else value


def run_each(
    items: Iterable[T],
    work: Callable[[T], R],
    *,
    jobs: int | None = None,
    timeout: float | None = None,
    max_memory: int | None = None,
    notice: Callable[[str], None] | None = None,
) -> Generator[tuple[T, R | Sketch2ShapeError], None, None]:
    """Apply `work` to each item in worker processes; yield (item, value or error) as they finish.

    jobs       : number of workers; None: one for each core
    timeout    : seconds of computing for one item, or five times as many by the clock; then its worker is ended and the
                 item gives LimitError
    max_memory : bytes that one item may take on top of the program itself; then it gives LimitError

    notice     : told why the work is done in this process, without limits, where no worker can be started; None: a
                 warning is logged

    A worker that dies gives CrashError for its item. At most a few items for each worker are held at a time.
    """
    crew = _Crew(work, jobs or default_jobs(), timeout, max_memory, notice or _LOG.warning)
    queue, source = deque[_Item[T]](), iter(items)
    try:
        while True:
            while len(crew.pending) < crew.capacity:
                item = queue.popleft() if queue else next((_Item(i) for i in source), None)
                if item is None:
                    break
                crew.hand_out(item)
            if not crew.pending:
                return
            for item, value in crew.finished():
                if isinstance(value, BrokenExecutor) and item.tries < _TRIES:
                    queue.append(item)
                else:
                    yield item.value, _known(value, timeout)
    finally:
        crew.dismiss()


def default_jobs() -> int:
    """One worker for each core that this process may use."""
    with contextlib.suppress(AttributeError):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


@dataclass
class _Item(Generic[T]):
    """An item and how often it was handed out."""

    value: T
    tries: int = 0


def _call(work: Callable[[T], R], timeout: float | None, item: T) -> R | Sketch2ShapeError:
    """Run in the worker: an error of ours travels as a value, lack of memory is a limit."""
    try:
        with limited_time(timeout):
            return work(item)
    except Sketch2ShapeError as error:
        return error
    except MemoryError:
        return LimitError("not enough memory", remedy="a smaller picture, or raise --max-memory")


class _Crew:
    """A pool that is made anew when it breaks; where there can be none, this process in its place."""

    def __init__(
        self,
        work: Callable[[Any], Any],
        jobs: int,
        timeout: float | None,
        max_memory: int | None,
        notice: Callable[[str], None],
    ) -> None:
        self.pending: dict[Future[Any], _Item[Any]] = {}
        self._jobs, self._work, self._timeout, self._max_memory, self._notice = jobs, work, timeout, max_memory, notice
        self._pool: Any = None
        self._alone = self._proven = False
        self._quiet_since = time.monotonic()

    @property
    def capacity(self) -> int:
        """Items that may be handed out at a time."""
        return 1 if self._alone else self._jobs * _AHEAD

    def hand_out(self, item: _Item[Any]) -> None:
        """Give an item to the pool; where there can be none, do it here and now."""
        item.tries += 1
        if not self.pending:
            self._quiet_since = time.monotonic()
        future = None if self._alone else self._scheduled(item)
        self.pending[self._done_here(item) if future is None else future] = item

    def _scheduled(self, item: _Item[Any]) -> Future[Any] | None:
        """The item's future, None if there is no pool to be had."""
        call = partial(_call, self._work, self._timeout)
        clock = None if self._timeout is None else self._timeout * (WAITING if HAS_TIMER else 1.0)
        reason = "the pool of workers broke"
        for _ in range(2):
            try:
                future: Future[Any] = self._running_pool().schedule(call, args=(item.value,), timeout=clock)
            except RuntimeError:  # the pool broke since
                self._drop_pool()
                continue
            except (NoWorkersError, OSError, ValueError) as error:
                reason = getattr(error, "strerror", None) or str(error)
                break
            return future
        self._go_alone(reason)
        return None

    def _go_alone(self, reason: str) -> None:
        self._alone = True
        self._drop_pool()
        self._notice(f"no worker process can be started ({reason}): working in this one, without limits")

    def _done_here(self, item: _Item[Any]) -> Future[Any]:
        future: Future[Any] = Future()
        try:
            future.set_result(_call(self._work, None, item.value))
        except Exception as error:
            future.set_exception(error)
        return future

    def finished(self) -> list[tuple[_Item[Any], Any]]:
        """Wait until some items are done, or the pool must be given up; their values or exceptions."""
        done, _ = wait(self.pending, timeout=_POLL, return_when=FIRST_COMPLETED)
        if done or any(future.running() for future in self.pending):
            self._quiet_since = time.monotonic()
        elif time.monotonic() - self._quiet_since > _PATIENCE:
            return self._abandon()
        self._proven = self._proven or bool(done)
        return [(self.pending.pop(future), _value(future)) for future in done]

    def _abandon(self) -> list[tuple[_Item[Any], Any]]:
        lost = [(item, BrokenExecutor("a worker was lost")) for item in self.pending.values()]
        self.pending.clear()
        if self._proven:
            self._drop_pool()
        else:
            self._go_alone("none has answered")
        return lost

    def _running_pool(self) -> Any:
        if self._pool is None:
            from pebble import ProcessPool

            context = working_context(PRELOAD, self._jobs)
            self._pool = ProcessPool(self._jobs, initializer=prepare, initargs=(self._max_memory,), context=context)
        return self._pool

    def _drop_pool(self) -> None:
        if self._pool is not None:
            self._pool.stop()
            self._pool.join()
            self._pool = None

    def dismiss(self) -> None:
        """Stop all workers at once."""
        self._drop_pool()


def _value(future: Future[Any]) -> Any:
    """What a finished future holds: its value, or its exception."""
    error = future.exception()
    return future.result() if error is None else error


def _known(value: Any, timeout: float | None) -> Any:
    """A value as it is, an exception as an error of ours."""
    if not isinstance(value, BaseException) or isinstance(value, Sketch2ShapeError):
        return value
    code = getattr(value, "exitcode", None)
    if isinstance(value, TimeoutError) or (HAS_TIMER and code == -signal.SIGPROF):
        how = "" if isinstance(value, TimeoutError) else " of computing"
        return LimitError(f"not done after {timeout:g} s{how}", remedy="a simpler picture, or raise --timeout")
    if isinstance(code, int) and code < 0:
        return CrashError(f"the worker died ({signal.Signals(-code).name})")
    return CrashError(f"the worker died ({type(value).__name__}: {str(value)[:200]})")
