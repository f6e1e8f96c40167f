"""Pictures that no one would draw, through `reconstruct`: an error of ours or a sound solid, and soon."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Callable

import cv2
import numpy as np
from numpy.typing import NDArray

from benchmarks.faults.samples import drawing
from sketch2shape.batch.pool import run_each
from sketch2shape.errors import Sketch2ShapeError
from sketch2shape.reconstruct import reconstruct
from sketch2shape.result import Result

Raster = NDArray[np.uint8]
Rng = np.random.Generator

_SLOW = 5.0


def run(size: int = 5_000, jobs: int = 2, first: int = 0) -> dict[str, object]:
    """`size` rasters, one at a time; one whose worker dies or that takes over 5 s of computing is a finding."""
    counts: Counter[str] = Counter()
    slow: Counter[str] = Counter()
    findings, slowest = [], 0.0
    for number, value in run_each(range(first, first + size), try_raster, jobs=jobs, timeout=30, max_memory=2**31):
        if isinstance(value, Sketch2ShapeError):
            findings.append(f"{number} {hostile(number)[0]}: {value.message}")
            continue
        outcome, seconds, finding = value
        counts[outcome] += 1
        slowest = max(slowest, seconds)
        if seconds > _SLOW:
            slow[hostile(number)[0]] += 1
        if finding:
            findings.append(f"{number} {hostile(number)[0]}: {finding}")
    return {
        "rasters": size,
        "outcomes": dict(sorted(counts.items())),
        "slowest, s of computing": round(slowest, 2),
        "over 5 s, by kind": dict(slow),
        "findings": findings[:40],
    }


def try_raster(number: int) -> tuple[str, float, str]:
    """Make and reconstruct a raster; the outcome, the computing time, and what is wrong with the answer."""
    raster = hostile(number)[1]
    begin = time.process_time()
    try:
        result = reconstruct(raster)
        outcome, finding = "solid", _flaw(result)
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


def hostile(number: int) -> tuple[str, Raster]:
    """The name of its kind and the raster of this number; the same for the same number."""
    rng = np.random.default_rng(number)
    make = _KINDS[number % len(_KINDS)]
    return make.__name__.strip("_"), make(rng)


def _size(rng: Rng) -> tuple[int, int]:
    """Height and width; seldom extreme."""
    if rng.random() < 0.15:
        return int(rng.choice([1, 2, 3, 5])), int(rng.choice([1, 2, 7, 300, 3000]))
    return int(rng.integers(20, 500)), int(rng.integers(20, 500))


def _white(rng: Rng) -> Raster:
    return np.full((*_size(rng), 3), 255, np.uint8)


def _noise(rng: Rng) -> Raster:
    return rng.integers(0, 256, (*_size(rng), 3), np.uint8)


def _pepper(rng: Rng) -> Raster:
    raster = _white(rng)
    raster[rng.random(raster.shape[:2]) < rng.uniform(0, 0.5)] = 0
    return raster


def _flat(rng: Rng) -> Raster:
    return np.full((*_size(rng), 3), rng.integers(0, 256), np.uint8)


def _stripes(rng: Rng) -> Raster:
    raster = _white(rng)
    raster[:: int(rng.integers(1, 9))] = 0
    if rng.random() < 0.5:
        raster[:, :: int(rng.integers(1, 9))] = 0
    return raster


def _lines(rng: Rng) -> Raster:
    raster = _white(rng)
    h, w = raster.shape[:2]
    for _ in range(rng.integers(1, 120)):
        a, b = rng.integers(-20, [w + 20, h + 20], (2, 2)).tolist()
        cv2.line(raster, a, b, (0, 0, 0), int(rng.integers(1, 5)))
    return raster


def _polygons(rng: Rng) -> Raster:
    raster = _white(rng)
    h, w = raster.shape[:2]
    for _ in range(rng.integers(1, 8)):
        ring = rng.integers(0, [w, h], (rng.integers(3, 14), 2)).astype(np.int32)
        cv2.polylines(raster, [ring], True, (0, 0, 0), int(rng.integers(1, 4)))
    return raster


def _twisted(rng: Rng) -> Raster:
    """Two polygons of equal count whose corners are joined in a wrong order, or that are degenerate."""
    raster = np.full((300, 300, 3), 255, np.uint8)
    n = int(rng.integers(3, 9))
    ring = rng.integers(40, 200, (n, 2)).astype(np.int32)
    other = ring + rng.integers(-40, 60, 2).astype(np.int32)
    turn = rng.permutation(n) if rng.random() < 0.5 else np.roll(np.arange(n), 1)
    for points in (ring, other):
        cv2.polylines(raster, [points], True, (0, 0, 0), 2)
    for a, b in zip(ring, other[turn], strict=True):
        cv2.line(raster, a.tolist(), b.tolist(), (0, 0, 0), 2)
    return raster


def _comb(rng: Rng) -> Raster:
    """A prism with many thin teeth."""
    raster = np.full((400, 500, 3), 255, np.uint8)
    teeth, x, ring = int(rng.integers(2, 40)), 30.0, []
    step = 380 / teeth
    for _ in range(teeth):
        ring += [[x, 100], [x + step / 2, 100], [x + step / 2, 250], [x + step, 250]]
        x += step
    front = np.array([*ring, [x, 330], [30, 330]]).round().astype(np.int32)
    back = front + rng.integers(-60, 60, 2).astype(np.int32)
    for points in (front, back):
        cv2.polylines(raster, [points], True, (0, 0, 0), 1)
    for a, b in zip(front, back, strict=True):
        cv2.line(raster, a.tolist(), b.tolist(), (0, 0, 0), 1)
    return raster


def _damaged(rng: Rng) -> Raster:
    """A sound drawing with patches wiped out, moved and scrawled over."""
    scale = int(rng.integers(1, 6))
    raster = np.array(drawing(96 * scale, 72 * scale))
    h, w = raster.shape[:2]
    for _ in range(rng.integers(0, 6)):
        y, x, s = int(rng.integers(0, h)), int(rng.integers(0, w)), int(rng.integers(2, 30))
        raster[y : y + s, x : x + s] = rng.choice([0, 255])
    if rng.random() < 0.5:
        raster = np.roll(raster, rng.integers(-40, 40), axis=int(rng.integers(0, 2)))
    if rng.random() < 0.3:
        raster = 255 - raster
    return np.ascontiguousarray(raster)


def _many(rng: Rng) -> Raster:
    """A sheet full of small boxes."""
    tile = np.array(drawing(int(rng.integers(30, 90)), int(rng.integers(30, 70))))
    return np.tile(tile, (int(rng.integers(1, 7)), int(rng.integers(1, 7)), 1))


def _circles(rng: Rng) -> Raster:
    raster = _white(rng)
    h, w = raster.shape[:2]
    for _ in range(rng.integers(1, 40)):
        centre = rng.integers(0, [w, h]).tolist()
        cv2.circle(raster, centre, int(rng.integers(1, 120)), (0, 0, 0), int(rng.choice([-1, 1, 2])))
    return raster


def _text(rng: Rng) -> Raster:
    raster = _white(rng)
    for y in range(15, raster.shape[0], 18):
        words = "".join(chr(c) for c in rng.integers(33, 127, 60))
        cv2.putText(raster, words, (3, y), int(rng.integers(0, 8)), float(rng.uniform(0.3, 1)), (0, 0, 0), 1)
    return raster


def _gradient(rng: Rng) -> Raster:
    h, w = _size(rng)
    ramp = np.add.outer(np.linspace(0, rng.uniform(0, 255), h), np.linspace(0, rng.uniform(0, 255), w))
    return np.repeat(ramp.clip(0, 255).astype(np.uint8)[:, :, None], 3, axis=2)


_KINDS: tuple[Callable[[Rng], Raster], ...] = (
    *(_white, _noise, _pepper, _flat, _stripes, _lines, _polygons, _twisted),
    *(_comb, _damaged, _many, _circles, _text, _gradient),
)
