"""The same strokes as pixels and as vectors: how many are read exactly, and how long it takes.

    python scripts/compare_vectors.py --seed 11 --per-category 20 --categories 'clean_*' 'hand_*'

Each drawing is made once; its pixels are a picture file in memory, its strokes a vector drawing with the same dashes
known. Times are of computing, of the whole call, picture file to solid; the first calls of the process do not count.
"""

from __future__ import annotations

import argparse
import fnmatch
import statistics
import time
from collections.abc import Callable
from typing import Any

import cv2
import repository  # noqa: F401 - for `synthetic`

import sketch2shape as s2s
from evaluation.metrics import compare
from sketch2shape.model import VectorLine
from sketch2shape.pipeline.report import report
from sketch2shape.reading.sheet import picture_of
from synthetic.drawing import draw, pen_strokes
from synthetic.recipes import RECIPES

Row = tuple[float, bool, bool]
"""Milliseconds, whether exact, whether sure of it."""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=11)
    parser.add_argument("--per-category", type=int, default=20, metavar="N")
    parser.add_argument("--categories", nargs="+", default=["clean_*", "hand_*"], metavar="PATTERN")
    args = parser.parse_args()
    cv2.setNumThreads(1)
    names = [c for c in RECIPES if any(fnmatch.fnmatch(c, p) for p in args.categories)]
    print("| drawings | number | pixels exact | vectors exact | pixels ms | vectors ms | ratio |")
    print("|---|---:|---:|---:|---:|---:|---:|")
    every: list[tuple[Row, Row]] = []
    _both(names[0], args.seed + 1, 0)
    for name in names:
        rows = [_both(name, args.seed, index) for index in range(args.per_category)]
        every += rows
        print(_line(name, rows), flush=True)
    print(_line("all", every))
    for half in (0, 1):
        print(_line(("even", "odd")[half], every[half::2]))
    for kind, place in (("pixels", 0), ("vectors", 1)):
        sure = [both[place] for both in every if both[place][2]]
        print(f"{kind}: {len(sure)} sure, {sum(not row[1] for row in sure)} of them wrong")


def _both(name: str, seed: int, index: int) -> tuple[Row, Row]:
    drawing = draw(name, seed, index)
    data = drawing.encoded()
    strokes, style, truth = pen_strokes(name, seed, index)
    lines = [VectorLine(s.path, dashed=s.hidden) for s in strokes]
    return (
        _measured(lambda: s2s.reconstruct(data), drawing.truth),
        _measured(lambda: s2s.reconstruct(picture_of(lines, page=style.size)), truth),
    )


def _measured(call: Callable[[], s2s.Result], truth: dict[str, Any]) -> Row:
    begin = time.process_time()
    try:
        result = call()
    except s2s.NoObjectError:
        return (time.process_time() - begin) * 1e3, False, False
    took = (time.process_time() - begin) * 1e3
    objects = report(result)["objects"]
    exact = len(objects) == 1 and compare(truth, objects[0]).exact
    return took, exact, min(result.confidences) >= 0.9


def _line(name: str, rows: list[tuple[Row, Row]]) -> str:
    pixels, vectors = zip(*rows, strict=True)
    p, v = (statistics.median(row[0] for row in side) for side in (pixels, vectors))
    right = [sum(row[1] for row in side) for side in (pixels, vectors)]
    return f"| {name} | {len(rows)} | {right[0]} | {right[1]} | {p:.0f} | {v:.0f} | {v / p:.2f} |"


if __name__ == "__main__":
    main()
