"""The memory limit of a worker."""

from __future__ import annotations

import multiprocessing

from sketch2shape.batch.worker import limit_memory


def _allocate(pipe, allowance, size):
    limit_memory(allowance)
    try:
        data = bytearray(size)
        pipe.send(len(data))
    except MemoryError:
        pipe.send("too much")


def _try(allowance, size):
    ours, theirs = multiprocessing.Pipe()
    process = multiprocessing.get_context("fork").Process(target=_allocate, args=(theirs, allowance, size))
    process.start()
    answer = ours.recv()
    process.join()
    return answer


def test_the_allowance_comes_on_top_of_what_is_in_use():
    assert _try(200 * 2**20, 100 * 2**20) == 100 * 2**20
    assert _try(200 * 2**20, 300 * 2**20) == "too much"
