"""Pictures that no one would draw: noise, scribbles, grids, text, damaged drawings, odd shapes and types of array."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from benchmarks.faults.samples import drawing
from synthetic.hand import RULER
from synthetic.negatives import NEGATIVES
from synthetic.pens import Pen

Raster = NDArray[Any]
Rng = np.random.Generator
#: kinds in which there may be an object after all
MAY_HOLD_AN_OBJECT = frozenset({"comb", "damaged", "many", "twisted"})


def hostile(number: int) -> tuple[str, Raster]:
    """The name of its kind and the raster of this number; the same for the same number."""
    rng = np.random.default_rng(number)
    name = KINDS[number % len(KINDS)]
    raster = _MAKERS[name](rng)
    if rng.random() < 0.2:
        raster = _in_another_form(raster, rng)
    return name, raster


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


def _lone_line(rng: Rng) -> Raster:
    raster = _white(rng)
    h, w = raster.shape[:2]
    a, b = rng.integers(0, [w, h], (2, 2)).tolist()
    cv2.line(raster, a, b, (0, 0, 0), int(rng.integers(1, 60)))
    return raster


def _board(rng: Rng) -> Raster:
    """A chessboard."""
    h, w = _size(rng)
    side = int(rng.integers(1, 60))
    fields = np.add.outer(np.arange(h) // side, np.arange(w) // side) % 2
    return np.repeat((255 * fields).astype(np.uint8)[:, :, None], 3, axis=2)


def _grid(rng: Rng) -> Raster:
    """Lines in two or three directions, dense."""
    h, w = int(rng.integers(200, 900)), int(rng.integers(200, 900))
    raster = np.full((h, w, 3), 255, np.uint8)
    far, step, pen = h + w, int(rng.integers(6, 60)), int(rng.integers(1, 4))
    for angle in rng.uniform(0, np.pi, rng.integers(2, 4)):
        along, across = np.array([np.cos(angle), np.sin(angle)]), np.array([-np.sin(angle), np.cos(angle)])
        for offset in range(-far, far, step):
            a, b = (np.array([w, h]) / 2 + across * offset + along * s for s in (-far, far))
            cv2.line(raster, a.astype(int).tolist(), b.astype(int).tolist(), (0, 0, 0), pen)
    return raster


def _blobs(rng: Rng) -> Raster:
    """A few filled shapes, some larger than the picture."""
    raster = _white(rng)
    h, w = raster.shape[:2]
    for _ in range(rng.integers(1, 12)):
        ring = rng.integers([-w, -h], [2 * w, 2 * h], (rng.integers(3, 9), 2)).astype(np.int32)
        cv2.fillPoly(raster, [ring], rng.integers(0, 256, 3).tolist())
    return raster


def _long(rng: Rng) -> Raster:
    """A strip with drawings on it."""
    tile = np.array(drawing(96, 72))
    strip = np.tile(tile, (1, int(rng.integers(20, 120)), 1))
    return np.ascontiguousarray(strip.swapaxes(0, 1)) if rng.random() < 0.5 else strip


def _dense(rng: Rng, name: str) -> Raster:
    """One to four layers of a picture that holds no object, on a sheet of up to 1.9 megapixels."""
    width = int(rng.integers(150, 1600))
    size, pen = (width, int(width * rng.uniform(0.4, 1))), Pen(float(rng.uniform(1, 4)))
    ink = np.maximum.reduce([NEGATIVES[name](size, pen, RULER, rng) for _ in range(rng.integers(1, 5))])
    return np.repeat(np.round(255 * (1 - ink)).astype(np.uint8)[:, :, None], 3, axis=2)


_OURS = (
    *(_white, _noise, _pepper, _flat, _stripes, _lines, _polygons, _twisted, _comb, _damaged, _many, _circles),
    *(_text, _gradient, _lone_line, _board, _grid, _blobs, _long),
)
_MAKERS: dict[str, Callable[[Rng], Raster]] = {
    **{make.__name__.strip("_"): make for make in _OURS},
    **{f"layers of {name.replace('_', ' ')}": partial(_dense, name=name) for name in NEGATIVES if name != "blank"},
}
#: names of the kinds; number n is of kind n modulo their count
KINDS = tuple(_MAKERS)


def _with_alpha(raster: Raster, rng: Rng) -> Raster:
    return np.dstack([raster, rng.integers(0, 256, raster.shape[:2], np.uint8)])


def _of_numbers(raster: Raster, rng: Rng) -> Raster:
    """Numbers that are no numbers, or none at all."""
    broken = raster.astype(float)
    broken[rng.integers(0, raster.shape[0])] = rng.choice([np.nan, np.inf, -1e300, 1e-300])
    return broken


def _in_another_form(raster: Raster, rng: Rng) -> Raster:
    """The same picture as other code might hold it, or something that is no picture."""
    forms: tuple[Callable[[], Raster], ...] = (
        lambda: raster[..., 0],
        lambda: raster[..., :1],
        lambda: raster[..., :2],
        lambda: np.dstack([raster, raster]),
        lambda: _with_alpha(raster, rng),
        lambda: raster > 127,
        lambda: raster.astype(np.uint16) * 257,
        lambda: raster.astype(">u2") * 200,
        lambda: raster.astype(np.int32) - 128,
        lambda: raster.astype(np.int64) * 2**50,
        lambda: raster.astype(np.uint64) * 2**55,
        lambda: raster.astype(np.int8),
        lambda: (raster / 255).astype(rng.choice(["f2", "f4", "f8"])),
        lambda: _of_numbers(raster, rng),
        lambda: raster.astype(complex),
        lambda: raster.astype(object),
        lambda: raster[::-2, ::-1],
        lambda: raster[:, :0],
        lambda: raster[0, 0],
        lambda: raster[None],
    )
    return forms[rng.integers(len(forms))]()
