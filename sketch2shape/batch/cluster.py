"""The same batch on a Dask cluster: tasks go to its scheduler, files lie on storage that all machines share.

Strategy: the cluster does what it is good at (it hands a task whose worker has died to another one), and nothing is
asked of it that it does not have: a limit on computing time is kept by a watchdog in the worker, which ends its
process, and the memory limit is the one that the worker was started with.
"""

from __future__ import annotations

import contextlib
import os
import threading
import time
from collections.abc import Callable, Generator, Iterable, Iterator
from dataclasses import replace
from importlib import import_module
from typing import Any

from sketch2shape.batch.pool import WAITING
from sketch2shape.conversion.convert import Outcome, Task, report_failure
from sketch2shape.errors import CrashError, MissingPackageError, Sketch2ShapeError, UsageError

#: tasks handed to the scheduler at a time, for each thread of a worker
_AHEAD = 4
#: seconds to wait for the scheduler
_PATIENCE = 30


def run_on_cluster(
    tasks: Iterable[Task],
    work: Callable[[Task], Outcome],
    *,
    scheduler: str,
    timeout: float | None = None,
) -> Generator[tuple[Task, Outcome], None, None]:
    """Do tasks on the cluster of a Dask scheduler (tcp://host:port), in the order in which they finish.

    A worker that dies costs no task: the scheduler gives it to another worker, a few times at most.

    Raises MissingPackageError, and UsageError if there is no scheduler.
    """
    with _client(scheduler) as client:
        yield from _follow(client, (_absolute(task) for task in tasks), work, timeout)


@contextlib.contextmanager
def _client(scheduler: str) -> Iterator[Any]:
    try:
        distributed: Any = import_module("distributed")
    except ImportError:
        raise MissingPackageError(
            "--scheduler needs the package distributed", remedy="pip install 'sketch2shape[cluster]'"
        ) from None
    try:
        client = distributed.Client(scheduler, timeout=_PATIENCE, set_as_default=False)
    except (OSError, ValueError, TypeError) as error:
        raise UsageError(f"no Dask scheduler at {scheduler} ({error})", remedy="--scheduler tcp://HOST:8786") from None
    try:
        yield client
    finally:
        client.close()


def _follow(
    client: Any, tasks: Iterator[Task], work: Callable[[Task], Outcome], timeout: float | None
) -> Iterator[tuple[Task, Outcome]]:
    """Keep some tasks at the scheduler, and yield what comes back."""
    running: dict[Any, Task] = {}
    finished: Any = import_module("distributed").as_completed(loop=client.loop)

    def hand_out(count: int) -> None:
        for _ in range(count):
            task = next(tasks, None)
            if task is None:
                return
            future = client.submit(_watched, work, task, timeout, pure=False)
            running[future] = task
            finished.add(future)

    hand_out(_AHEAD * max(1, sum(client.nthreads().values())))
    while running:
        future = next(finished)
        task = running.pop(future)
        yield task, _outcome(task, future)
        future.release()
        hand_out(1)


def _outcome(task: Task, future: Any) -> Outcome:
    error = future.exception()
    if error is None:
        outcome: Outcome = future.result()
        return outcome
    if not isinstance(error, Sketch2ShapeError):
        text = (str(error).splitlines() or [""])[0][:200]
        error = CrashError(f"every worker that tried it died ({type(error).__name__}: {text})")
    return report_failure(task, error)


def _absolute(task: Task) -> Task:
    """The task with absolute paths, which mean the same on every machine that shares the storage.

    A task may be done twice, if its worker dies after the work: the second time its own files are there already.
    """
    outputs = tuple(replace(output, path=os.path.abspath(output.path)) for output in task.outputs)
    return replace(task, source=os.path.abspath(task.source), outputs=outputs, overwrite=True)


def _watched(work: Callable[[Task], Outcome], task: Task, timeout: float | None) -> Outcome:
    """Run on the worker: end its process if the task takes too long; the watchers of the cluster start another."""
    if timeout is None:
        return work(task)
    done = threading.Event()
    watchdog = threading.Thread(target=_end_if_late, args=(done, timeout, _computing_time()), daemon=True)
    watchdog.start()
    try:
        return work(task)
    finally:
        done.set()
        watchdog.join()


def _end_if_late(done: threading.Event, timeout: float, computed: Callable[[], float]) -> None:
    """End this process once a task has computed, or taken by the clock, for longer than it may."""
    begin = time.monotonic()

    def left() -> float:
        return min(timeout - computed(), WAITING * timeout - (time.monotonic() - begin))

    while not done.wait(max(left(), 0.0)):
        if left() <= 0.0:
            os._exit(1)


def _computing_time() -> Callable[[], float]:
    """What tells the seconds that the calling thread has computed from now on; by the clock where the system cannot."""
    if not hasattr(time, "pthread_getcpuclockid"):
        begin = time.monotonic()
        return lambda: time.monotonic() - begin
    clock = time.pthread_getcpuclockid(threading.get_ident())
    start = time.clock_gettime(clock)
    return lambda: time.clock_gettime(clock) - start
