"""Work in processes of its own, so that no picture can stop, slow or swell the app."""

from __future__ import annotations

import asyncio
import multiprocessing
import signal
from collections.abc import Callable
from concurrent.futures import Future
from concurrent.futures.process import BrokenProcessPool
from typing import TYPE_CHECKING, Any, Protocol, TypeVar

from sketch2shape.batch.worker import HAS_TIMER, limited_time
from sketch2shape.errors import LimitError, Sketch2ShapeError

if TYPE_CHECKING:
    from pebble import ProcessPool

T = TypeVar("T")

#: times the limit on computing that work may take by the clock
_WAITING = 5.0


class BusyError(Sketch2ShapeError):
    """More work is waiting than the app takes on."""

    exit_code = 6
    remedy = "waiting a moment and trying again"


class Workers(Protocol):
    """Runs functions for the app."""

    async def run(self, function: Callable[..., T], *arguments: Any, seconds: float) -> T:
        """The function's result; its errors are raised here. Raises LimitError after `seconds`, BusyError.

        Work that is cancelled before a worker has begun it is never done.
        """

    @property
    def waiting(self) -> int:
        """Tasks that are not done, those in hand included."""

    def close(self) -> None:
        """Stop, without waiting for work in hand."""


class WorkerPool:
    """Worker processes that are replaced when they fail."""

    def __init__(self, workers: int = 2, *, most_waiting: int = 64, memory: int = 4 * 2**30) -> None:
        """Start `workers` processes, each with `memory` bytes for its work; refuse more than `most_waiting` tasks."""
        self._workers, self._memory, self._most, self._count = workers, memory, most_waiting, 0
        self._free = asyncio.Semaphore(workers)
        self._pool = self._start()

    def _start(self) -> ProcessPool:
        from pebble import ProcessPool

        pool = ProcessPool(
            max_workers=self._workers,
            max_tasks=500,  # a fresh process now and then, whatever a library may leak
            initializer=_prepare,
            initargs=[self._memory],
            context=multiprocessing.get_context("spawn"),
        )
        pool.schedule(abs, args=[0])  # the processes start with the first task: let that not be a person's
        return pool

    @property
    def waiting(self) -> int:
        """See Workers."""
        return self._count

    async def run(self, function: Callable[..., T], *arguments: Any, seconds: float) -> T:
        """See Workers."""
        from pebble import ProcessExpired

        if self._count >= self._most:
            raise BusyError(f"too much work is waiting: {self._count} tasks are before yours")
        try:
            # a worker in the middle of its work would be ended with it, and a new one takes a second to start
            result: T = await asyncio.shield(await self._begun(function, arguments, seconds))
            return result
        except TimeoutError as error:
            raise LimitError(
                f"it took longer than {seconds:g} seconds", remedy="a smaller or simpler picture"
            ) from error
        except (ProcessExpired, BrokenProcessPool, MemoryError) as error:
            if HAS_TIMER and getattr(error, "exitcode", None) == -signal.SIGPROF:
                raise LimitError(
                    f"it took longer than {seconds:g} seconds of computing", remedy="a smaller or simpler picture"
                ) from error
            raise LimitError("the work needed too much memory or failed", remedy="a smaller picture") from error

    async def _begun(self, function: Callable[..., Any], arguments: tuple[Any, ...], seconds: float) -> Any:
        """The future of work that has a worker: it waits here, where it can be cancelled, and not in the pool."""
        self._count += 1
        free = False
        try:
            free = await self._free.acquire()
            work = asyncio.wrap_future(self._schedule(function, arguments, seconds))
        except BaseException:
            self._count -= 1
            if free:
                self._free.release()
            raise
        work.add_done_callback(self._done)
        return work

    def _done(self, work: asyncio.Future[Any]) -> None:
        self._count -= 1
        self._free.release()
        if not work.cancelled():
            work.exception()  # where nobody waits for it any more, it is told to nobody

    def _schedule(self, function: Callable[..., Any], arguments: tuple[Any, ...], seconds: float) -> Future[Any]:
        """Hand a task to the pool; a pool that broke down as a whole is replaced first."""
        try:
            return self._scheduled(function, arguments, seconds)
        except RuntimeError:
            self._pool = self._start()
            return self._scheduled(function, arguments, seconds)

    def _scheduled(self, function: Callable[..., Any], arguments: tuple[Any, ...], seconds: float) -> Future[Any]:
        """The limit is on computing; work that only waits is ended a few times later by the clock."""
        clock = seconds * (_WAITING if HAS_TIMER else 1.0)
        return self._pool.schedule(_limited, args=[function, seconds, *arguments], timeout=clock)

    def close(self) -> None:
        """See Workers."""
        self._pool.stop()  # type: ignore[no-untyped-call]
        self._pool.join()


def _limited(function: Callable[..., T], seconds: float, *arguments: Any) -> T:
    """In a worker."""
    with limited_time(seconds):
        return function(*arguments)


def _prepare(memory: int) -> None:
    """In a new worker: leave Ctrl-C to the app, load what all work needs, then limit what a picture may take."""
    import os

    from sketch2shape.batch.worker import limit_memory

    signal.signal(signal.SIGINT, signal.SIG_IGN)
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # it takes memory for each of the cores
    import sketch2shape.ui.jobs as jobs

    jobs.warm_up()
    limit_memory(memory)
