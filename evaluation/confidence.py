"""Whether the confidence keeps its promise: tables and the reliability diagram."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise
from pathlib import Path

import numpy as np

from evaluation.markdown import percent, table
from evaluation.outcome import SURE, Outcome
from sketch2shape.model import Floats

EDGES = (0.0, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95, 0.99, 1.0)
"""Of the table's classes of confidence."""


def confidence_tables(outcomes: Sequence[Outcome]) -> str:
    """How much of the sure is right and of the right is sure, by set and half; then right answers by confidence."""
    judged = [o for o in outcomes if o.answered and o.right is not None]
    if not judged:
        return "Nothing was answered.\n"
    sure = [o for o in judged if o.sure]
    share = percent(sum(o.right is True for o in sure), len(sure))
    text = f"Of {len(sure)} answers with confidence {SURE} or more, {share} % are right.\n\n"
    head = ["", "answers", "sure", "sure and right", "sure, right %", "right", "right, sure %"]
    text += table(head, [[name, *_promise(group)] for name, group in _groups(judged)])
    rows = []
    for low, high in pairwise(EDGES):
        part = [o for o in judged if low <= o.confidence < high or o.confidence == high == EDGES[-1]]
        if part:
            row = [f"{low:g} to {high:g}", str(len(part))]
            halves = [[o for o in part if o.case.half == half] for half in ("even", "odd")]
            rows.append(row + [percent(sum(o.right is True for o in some), len(some)) for some in (part, *halves)])
    return text + "\n" + table(["confidence", "answers", "right %", "even", "odd"], rows)


def _groups(judged: Sequence[Outcome]) -> Iterator[tuple[str, list[Outcome]]]:
    """All, each half, each set, each half of each set."""
    sets = list(dict.fromkeys(o.case.set for o in judged))
    for name in ("**all**", *sets):
        group = [o for o in judged if o.case.set == name or name not in sets]
        yield name, group
        for half in ("even", "odd"):
            yield f"{name}, {half}", [o for o in group if o.case.half == half]


def _promise(group: Sequence[Outcome]) -> list[str]:
    sure, right = [o for o in group if o.sure], [o for o in group if o.right]
    both = sum(o.sure for o in right)
    counts = [str(len(group)), str(len(sure)), str(both), percent(both, len(sure))]
    return [*counts, str(len(right)), percent(both, len(right))]


def diagram(outcomes: Sequence[Outcome], picture: Path) -> str:
    """Draw accuracy against confidence for each half, and against coverage; returns the picture's Markdown."""
    known = [o for o in outcomes if o.answered and o.right is not None]
    if not known:
        return ""
    import matplotlib as mpl

    mpl.use("svg")
    mpl.rcParams["svg.hashsalt"] = "sketch2shape"  # the same figures give the same file
    import matplotlib.pyplot as plt

    figure, (left, right) = plt.subplots(1, 2, figsize=(8, 3.6), layout="constrained")
    left.plot([0, 1], [0, 1], color="0.7")
    for half, marker in (("even", "o"), ("odd", "s")):
        points = _points([o for o in known if o.case.half == half])
        if len(points):
            mean, rate, spread = _tenths(points)
            left.errorbar(mean, rate, yerr=spread, fmt=marker, capsize=2, label=half)
    left.set(xlabel="confidence (tenths of the answers)", ylabel="right", xlim=(0, 1.02), ylim=(0, 1.02))
    left.legend(frameon=False)
    points = _points(known)
    order = np.argsort(-points[:, 0], kind="stable")
    count = np.arange(1, len(points) + 1)
    right.plot(count / len(outcomes), np.cumsum(points[order, 1]) / count)
    right.set(xlabel="answered, most confident first (fraction of all)", ylabel="right, of those", ylim=(0.5, 1.01))
    figure.savefig(picture, metadata={"Date": None})
    plt.close(figure)
    return f"![reliability]({picture.name})\n"


def _points(outcomes: Sequence[Outcome]) -> Floats:
    return np.array([[o.confidence, o.right is True] for o in outcomes], float).reshape(-1, 2)


def _tenths(points: Floats) -> tuple[list[float], list[float], list[float]]:
    """Mean confidence, share of right ones and the half width of its 95 % interval, a tenth of the answers each."""
    edges = np.quantile(points[:, 0], np.linspace(0, 1, 11))
    bins = np.clip(np.searchsorted(edges, points[:, 0], side="right") - 1, 0, 9)
    groups = [points[bins == b] for b in range(10) if (bins == b).any()]
    mean, rate = ([float(g[:, k].mean()) for g in groups] for k in (0, 1))
    spread = [1.96 * math.sqrt(max(r * (1 - r), 0.01) / len(g)) for r, g in zip(rate, groups, strict=True)]
    return mean, rate, spread
