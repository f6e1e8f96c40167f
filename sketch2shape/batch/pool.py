"""Running one function over many items in worker processes that may crash, hang or eat memory.

Strategy: a `pebble` pool, because a crash there loses only the item that caused it. A few items more than there are
workers are handed out at a time, so that memory stays flat however many there are. Where the pool itself breaks (a
worker killed from outside while idle), it is made anew and the items it lost are handed out again, a few times at most.
"""

from __future__ import annotations

import contextlib
import multiprocessing
import os
import signal
import sys
import time
from collections import deque
from collections.abc import Callable, Generator, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Future, wait
from dataclasses import dataclass
from functools import partial
from types import ModuleType
from typing import Any, Generic, TypeVar

from sketch2shape.batch.worker import PRELOAD, prepare
from sketch2shape.conversion.convert import Outcome, Task, report_failure
from sketch2shape.errors import CrashError, LimitError, Sketch2ShapeError

T = TypeVar("T")
R = TypeVar("R")

#: items handed out at a time, for each worker: enough to keep it busy, few enough to bound memory
_AHEAD = 4
#: how often an item may be lost to a broken pool before it is given up
_TRIES = 3
#: a pool is broken if for this long it has items and works on none, seconds; starting workers takes a few
_PATIENCE = 20.0
#: how often the loop looks up from waiting, seconds
_POLL = 1.0


def run_tasks(
    tasks: Iterable[Task],
    work: Callable[[Task], Outcome],
    *,
    jobs: int | None = None,
    timeout: float | None = None,
    max_memory: int | None = None,
) -> Generator[tuple[Task, Outcome], None, None]:
    """Do tasks in worker processes, in the order in which they finish; a crash or hang fails only its own."""
    for task, value in run_each(tasks, work, jobs=jobs, timeout=timeout, max_memory=max_memory):
        yield task, report_failure(task, value) if isinstance(value, Sketch2ShapeError) else value


def run_each(
    items: Iterable[T],
    work: Callable[[T], R],
    *,
    jobs: int | None = None,
    timeout: float | None = None,
    max_memory: int | None = None,
) -> Generator[tuple[T, R | Sketch2ShapeError], None, None]:
    """Apply `work` to each item in worker processes; yield (item, value or error) as they finish.

    jobs       : number of workers; None: one for each core
    timeout    : seconds for one item; then its worker is ended and the item gives LimitError
    max_memory : bytes that one item may take on top of the program itself; then it gives LimitError

    A worker that dies gives CrashError for its item. At most a few items for each worker are held at a time.
    """
    crew = _Crew(partial(_call, work), jobs or default_jobs(), timeout, max_memory)
    queue, source = deque[_Item[T]](), iter(items)
    try:
        while True:
            while len(crew.pending) < crew.jobs * _AHEAD:
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


def _call(work: Callable[[T], R], item: T) -> R | Sketch2ShapeError:
    """Run in the worker: an error of ours travels as a value, lack of memory is a limit."""
    try:
        return work(item)
    except Sketch2ShapeError as error:
        return error
    except MemoryError:
        return LimitError("not enough memory", remedy="a smaller picture, or raise --max-memory")


class _Crew:
    """A pool that is made anew when it breaks."""

    def __init__(self, call: Callable[[Any], Any], jobs: int, timeout: float | None, max_memory: int | None) -> None:
        self.jobs = jobs
        self.pending: dict[Future[Any], _Item[Any]] = {}
        self._call, self._timeout, self._max_memory = call, timeout, max_memory
        self._pool: Any = None
        self._quiet_since = time.monotonic()

    def hand_out(self, item: _Item[Any]) -> None:
        """Give an item to the pool."""
        item.tries += 1
        if not self.pending:
            self._quiet_since = time.monotonic()
        for _ in range(2):
            try:
                future = self._running_pool().schedule(self._call, args=(item.value,), timeout=self._timeout)
            except RuntimeError:  # the pool broke since
                self._drop_pool()
                continue
            self.pending[future] = item
            return
        lost: Future[Any] = Future()
        lost.set_exception(BrokenExecutor("no worker can be started"))
        self.pending[lost] = item

    def finished(self) -> list[tuple[_Item[Any], Any]]:
        """Wait until some items are done, or the pool must be given up; their values or exceptions."""
        done, _ = wait(self.pending, timeout=_POLL, return_when=FIRST_COMPLETED)
        if done or any(future.running() for future in self.pending):
            self._quiet_since = time.monotonic()
        elif time.monotonic() - self._quiet_since > _PATIENCE:
            return self._abandon()
        return [(self.pending.pop(future), _value(future)) for future in done]

    def _abandon(self) -> list[tuple[_Item[Any], Any]]:
        lost = [(item, BrokenExecutor("a worker was lost")) for item in self.pending.values()]
        self.pending.clear()
        self._drop_pool()
        return lost

    def _running_pool(self) -> Any:
        if self._pool is None:
            from pebble import ProcessPool

            multiprocessing.set_forkserver_preload(list(PRELOAD))
            self._pool = ProcessPool(self.jobs, initializer=prepare, initargs=(self._max_memory,), context=_Context())
            with _one_thread_each():
                self._pool.schedule(int)  # the first task starts the workers
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
    if isinstance(value, TimeoutError):
        return LimitError(f"not done after {timeout:g} s", remedy="a simpler picture, or raise --timeout")
    code = getattr(value, "exitcode", None)
    if isinstance(code, int) and code < 0:
        return CrashError(f"the worker died ({signal.Signals(-code).name})")
    return CrashError(f"the worker died ({type(value).__name__}: {str(value)[:200]})")


#: workers come from a fork server, which has no threads that could hold a lock, or are spawned where there is none
_BASE: Any = multiprocessing.get_context(
    "forkserver" if "forkserver" in multiprocessing.get_all_start_methods() else "spawn"
)


class _Process(_BASE.Process):  # type: ignore[misc]
    """A worker that does not run the user's main script again.

    Both ways of starting it would import that script, and a script without a `__name__` guard would then start workers
    of workers.
    """

    @staticmethod
    def _Popen(process: Any) -> Any:  # noqa: N802  (the name multiprocessing gives it)
        with _without_main():
            return _BASE.Process._Popen(process)


class _Context(type(_BASE)):  # type: ignore[misc]
    """The context that starts such workers."""

    Process = _Process


@contextlib.contextmanager
def _without_main() -> Iterator[None]:
    main = sys.modules["__main__"]
    sys.modules["__main__"] = ModuleType("__main__")
    try:
        yield
    finally:
        sys.modules["__main__"] = main


@contextlib.contextmanager
def _one_thread_each() -> Iterator[None]:
    """Let processes started meanwhile use one thread for linear algebra: the workers themselves fill the cores."""
    names = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")
    before = {name: os.environ.get(name) for name in names}
    os.environ.update(dict.fromkeys(names, "1"))
    try:
        yield
    finally:
        for name, value in before.items():
            if value is None:
                del os.environ[name]
            else:
                os.environ[name] = value
