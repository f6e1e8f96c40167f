"""The memory limit of a worker."""

from __future__ import annotations

import subprocess
import sys

_ALLOCATE = """
from sketch2shape.batch.worker import limit_memory
limit_memory({allowance})
try:
    print(len(bytearray({size})))
except MemoryError:
    print("too much")
"""


def _try(allowance, size):
    code = _ALLOCATE.format(allowance=allowance, size=size)
    return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.strip()


def test_the_allowance_comes_on_top_of_what_is_in_use():
    assert _try(200 * 2**20, 100 * 2**20) == str(100 * 2**20)
    assert _try(200 * 2**20, 300 * 2**20) == "too much"
