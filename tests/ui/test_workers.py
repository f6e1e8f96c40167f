import asyncio
import itertools
import os
import time
from collections.abc import Iterator

import pytest

from sketch2shape.corrections.corrections import SCHEMA
from sketch2shape.errors import LimitError, UsageError
from sketch2shape.ui.jobs import lift_corrections
from sketch2shape.ui.workers import BusyError, WorkerPool


@pytest.fixture(scope="module")
def pool() -> Iterator[WorkerPool]:
    pool = WorkerPool(1, most_waiting=2, memory=3 * 2**30)
    yield pool
    pool.close()


def test_work_is_done_in_another_process(pool: WorkerPool) -> None:
    assert asyncio.run(pool.run(os.getpid, seconds=60)) != os.getpid()


def test_errors_come_back_with_their_advice(pool: WorkerPool) -> None:
    with pytest.raises(UsageError, match="no object yet") as caught:
        asyncio.run(pool.run(lift_corrections, {"schema": SCHEMA, "objects": []}, seconds=60))
    assert caught.value.advice == "tracing its front face"
    with pytest.raises(ValueError, match="invalid literal"):
        asyncio.run(pool.run(int, "three", seconds=60))


def test_work_without_end_is_stopped_and_the_pool_goes_on(pool: WorkerPool) -> None:
    with pytest.raises(LimitError, match="longer than"):
        asyncio.run(pool.run(time.sleep, 600, seconds=0.3))
    with pytest.raises(LimitError, match="of computing"):
        asyncio.run(pool.run(sum, itertools.repeat(1), seconds=0.3))
    assert asyncio.run(pool.run(abs, -3, seconds=60)) == 3


def test_a_worker_that_dies_is_replaced(pool: WorkerPool) -> None:
    with pytest.raises(LimitError):
        asyncio.run(pool.run(os._exit, 3, seconds=60))
    assert asyncio.run(pool.run(abs, -3, seconds=60)) == 3


def test_a_pool_that_broke_down_is_replaced(pool: WorkerPool) -> None:
    unknown = type("Unknown", (), {"__module__": "no_such_module", "__reduce__": lambda _: (_missing, ())})
    with pytest.raises(Exception):  # noqa: B017, PT011 - pebble has its own words for it
        asyncio.run(pool.run(abs, unknown(), seconds=60))
    assert asyncio.run(pool.run(abs, -3, seconds=60)) == 3


def _missing() -> None:
    """Known to this test only, not to a worker."""


def test_memory_is_limited(pool: WorkerPool) -> None:
    with pytest.raises(LimitError, match="memory"):
        asyncio.run(pool.run(bytearray, 8 * 2**30, seconds=60))


def test_work_beyond_the_queue_is_refused(pool: WorkerPool) -> None:
    async def crowd() -> list[object]:
        work = [pool.run(time.sleep, 0.2, seconds=60) for _ in range(5)]
        return await asyncio.gather(*work, return_exceptions=True)

    outcomes = asyncio.run(crowd())
    assert sum(isinstance(o, BusyError) for o in outcomes) == 3
    assert not issubclass(BusyError, UsageError)


def test_work_that_nobody_waits_for_is_not_begun_and_what_is_begun_is_ended() -> None:
    pool = WorkerPool(1)

    async def change_of_mind() -> tuple[int, int, int]:
        worker = await pool.run(os.getpid, seconds=60)
        begun = asyncio.create_task(pool.run(time.sleep, 0.5, seconds=60))
        waiting = asyncio.create_task(pool.run(time.sleep, 600, seconds=60))
        await asyncio.sleep(0.1)
        for task in (waiting, begun):
            task.cancel()
        await asyncio.gather(begun, waiting, return_exceptions=True)
        return worker, pool.waiting, await pool.run(os.getpid, seconds=60)

    before, waiting, after = asyncio.run(change_of_mind())
    assert (before, waiting) == (after, 1)
    pool.close()
