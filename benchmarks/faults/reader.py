"""Damaged files through the reader: typed errors or pixels, nothing else, and soon."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Iterator

import numpy as np

from benchmarks.faults.samples import mutated, samples
from sketch2shape.batch.pool import run_each
from sketch2shape.errors import Sketch2ShapeError
from sketch2shape.reading.read import count_pages, read_picture
from sketch2shape.writing import quiet_stderr

_BLOCK = 250
_SLOW = 5.0


def run(size: int = 100_000, jobs: int = 2) -> dict[str, object]:
    """`size` damaged files in blocks; a block whose worker dies or hangs is a finding."""
    counts: Counter[str] = Counter()
    findings, slowest = [], 0.0
    for block, value in run_each(_blocks(size), read_block, jobs=jobs, timeout=120, max_memory=2**30):
        if isinstance(value, Sketch2ShapeError):
            findings.append(f"block {block}: {value.message}")
            continue
        kinds, worst, found = value
        counts.update(kinds)
        slowest = max(slowest, worst)
        findings += found
    return {
        "files": size,
        "kinds of sound files they were made from": len(samples()),
        "read": counts.pop("read", 0),
        "refused": dict(sorted(counts.items())),
        "slowest, s": round(slowest, 2),
        "findings": findings[:20],
    }


def _blocks(size: int) -> Iterator[tuple[int, int]]:
    for start in range(0, size, _BLOCK):
        yield start, min(_BLOCK, size - start)


def read_block(block: tuple[int, int]) -> tuple[dict[str, int], float, list[str]]:
    """Damage and read some files; what came of it, the longest time, and findings."""
    sound = list(samples().items())
    counts: Counter[str] = Counter()
    findings, slowest = [], 0.0
    for number in range(block[0], sum(block)):
        rng = np.random.default_rng(number)
        name, data = sound[number % len(sound)]
        broken = mutated(data, rng)
        begin = time.perf_counter()
        try:
            with quiet_stderr():
                pixels = read_picture(broken).pixels
            if pixels.ndim != 3 or pixels.shape[2] != 3 or pixels.dtype != np.uint8 or not pixels.size:
                findings.append(f"{number} {name}: pixels {pixels.shape} {pixels.dtype}")
            counts["read"] += 1
            with quiet_stderr():
                count_pages(broken)
        except Sketch2ShapeError as error:
            counts[type(error).__name__] += 1
        except Exception as error:
            findings.append(f"{number} {name}: {type(error).__name__}: {error}")
        seconds = time.perf_counter() - begin
        slowest = max(slowest, seconds)
        if seconds > _SLOW:
            findings.append(f"{number} {name}: {seconds:.1f} s")
    return dict(counts), slowest, findings
