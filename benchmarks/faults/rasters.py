"""Pictures that no one would draw, through `reconstruct`: an error of ours or a sound solid, and soon.

Times are of computing, in one thread, so that a busy machine does not matter.
"""

from __future__ import annotations

import time
from collections import Counter, defaultdict
from collections.abc import Mapping, Sequence

import numpy as np

from benchmarks.faults.hostile import KINDS, MAY_HOLD_AN_OBJECT, hostile
from sketch2shape.batch.pool import run_each
from sketch2shape.errors import Sketch2ShapeError
from sketch2shape.pipeline import reconstruct
from sketch2shape.pipeline.result import Result

_SLOW = 5.0


#: outcome ("solid", "sure solid", or the error), seconds of computing, what is wrong with the answer ("" if nothing)
Attempt = tuple[str, float, str]


def run(size: int = 5_000, jobs: int = 2) -> dict[str, object]:
    """`size` rasters, one at a time; one whose worker dies or that takes over 5 s of computing is a finding."""
    return summary(dict(run_each(range(size), try_raster, jobs=jobs, timeout=120, max_memory=2**31)))


def summary(attempts: Mapping[int, Attempt | Sketch2ShapeError]) -> dict[str, object]:
    """What came of the rasters of these numbers."""
    outcomes: Counter[str] = Counter()
    seconds: dict[str, list[float]] = defaultdict(list)
    false: dict[str, Counter[str]] = {"solid": Counter(), "sure solid": Counter()}
    findings = []
    for number, value in sorted(attempts.items()):
        kind = KINDS[number % len(KINDS)]
        if isinstance(value, Sketch2ShapeError):
            findings.append(f"{number} {kind}: {value.message}")
            continue
        outcome, took, finding = value
        outcomes[outcome] += 1
        seconds[kind].append(took)
        if outcome in false and kind not in MAY_HOLD_AN_OBJECT:
            false[outcome][kind] += 1
        if took > _SLOW:
            findings.append(f"{number} {kind}: {took:.1f} s")
        if finding:
            findings.append(f"{number} {kind}: {finding}")
    every = np.array([took for each in seconds.values() for took in each])
    return {
        "rasters": len(attempts),
        "kinds": len(seconds),
        "outcomes": dict(sorted(outcomes.items())),
        "solids in kinds that hold no object": dict(false["solid"].most_common()),
        "the same with a confidence of 0.9 or more": dict(false["sure solid"].most_common()),
        "slowest, s of computing": _slowest(seconds),
        "median, 99th percentile, s": np.round(np.percentile(every, [50, 99]), 2).tolist(),
        "over 1 s, over 5 s": [int((every > 1).sum()), int((every > _SLOW).sum())],
        "findings": findings[:40],
    }


def _slowest(seconds: Mapping[str, Sequence[float]]) -> dict[str, float]:
    """The longest time of each of the eight slowest kinds."""
    worst = sorted(((max(each), kind) for kind, each in seconds.items()), reverse=True)
    return {kind: round(took, 2) for took, kind in worst[:8]}


def try_raster(number: int) -> Attempt:
    """Make and reconstruct a raster; the outcome, the computing time, and what is wrong with the answer."""
    raster = hostile(number)[1]
    begin = time.process_time()
    try:
        result = reconstruct(raster)
        sure = min(found.confidence for found in result.objects) >= 0.9
        outcome, finding = "sure solid" if sure else "solid", _flaw(result)
    except Sketch2ShapeError as error:
        outcome, finding = type(error).__name__, ""
    except Exception as error:
        outcome, finding = "bug", f"{type(error).__name__}: {error}"
    return outcome, time.process_time() - begin, finding


def _flaw(result: Result) -> str:
    """What is wrong with a result that claims to be sound, "" if nothing."""
    mesh = result.mesh
    if not np.isfinite(mesh.vertices).all():
        return "not finite"
    if not mesh.is_watertight:
        return "not watertight"
    if not mesh.is_winding_consistent:
        return "winding differs"
    return "" if mesh.volume > 0 else f"volume {mesh.volume}"
