"""The page docs/results.md: tables and the reliability diagram from the outcomes of `evaluate.py`."""

from __future__ import annotations

import collections
import math
from pathlib import Path
from typing import Any

import numpy as np

from evaluation.markdown import table
from synthetic import metrics

Outcome = dict[str, Any]

TITLES = {
    "committed": "Committed drawings (`data/synthetic`)",
    "fresh": "Fresh drawings (all categories of the generator)",
    "bench": "Independent drawings (another generator, not in this repository)",
    "real": "Real pictures (textbooks, pens and tablets, CAD, icons; not in this repository)",
}
INTRO = """# Results

Written by `scripts/evaluate.py`; do not edit. Made with

    {command}

- **exact**: every vertex matched one to one within tolerance and the edges identical, hidden ones included; a picture
  without an object must be refused, a sheet of several must give each and no more.
- **mesh**: exact, and the mesh is watertight, outward, of the right genus, with exactly the object's vertices.
- **solid**: exact, and the three-dimensional proportions are right (5 %, by hand 10 %, in perspective 12 %; where the
  drawing does not fix the depth, those of the front face).
- **answered**: pictures for which something was reported. Times are of `reconstruct` in a warm process while {jobs}
  processes ran.
"""


def write_page(page: Path, outcomes: list[Outcome], command: str, sheets: list[Path], jobs: int = 2) -> None:
    """Write the page and its diagram."""
    page.parent.mkdir(parents=True, exist_ok=True)
    parts = [INTRO.format(command=command, jobs=jobs), "## All\n", summary_table(outcomes)]
    parts += ["## Measures of the field\n", field_table(outcomes)]
    parts += ["## Confidence\n", reliability(outcomes, page.parent / "reliability.svg")]
    for name in _sets(outcomes):
        group = [o for o in outcomes if o["set"] == name]
        parts += [f"## {TITLES[name]}\n", category_table(group)]
    parts += ["## Solids from the true corners, with noise\n", lifting(page.parent / "lifting.md")]
    parts += ["## Failures\n", failures(outcomes, sheets, page.parent)]
    page.write_text("\n".join(parts).rstrip() + "\n")


def lifting(page: Path) -> str:
    """The tables of the page that `evaluate_lifting.py` writes, each under its name."""
    if not page.exists():
        return "Not measured; `python scripts/evaluate_lifting.py` does.\n"
    text = (
        "The share of drawings whose solid is right when it is lifted from their true vertices with normal noise added,"
        f" measured by `scripts/evaluate_lifting.py`; see [lifting]({page.name}).\n"
    )
    kept = [line for line in page.read_text().splitlines() if line.startswith(("### ", "|"))]
    return text + "".join(f"\n{line}\n\n" if line.startswith("#") else f"{line}\n" for line in kept)


def _sets(outcomes: list[Outcome]) -> list[str]:
    return list(dict.fromkeys(o["set"] for o in outcomes))


def _percent(part: float, whole: float) -> str:
    return f"{100 * part / whole:.1f}" if whole else "-"


def _row(name: str, group: list[Outcome]) -> list[str]:
    n = len(group)
    times = np.array([o["ms"] for o in group])
    counts = [sum(bool(o[k]) for o in group) for k in ("exact", "mesh", "solid", "answers")]
    return [name, str(n), *(_percent(c, n) for c in counts), *(f"{np.percentile(times, q):.0f}" for q in (50, 95))]


HEAD = ["", "n", "exact %", "mesh %", "solid %", "answered %", "p50 ms", "p95 ms"]


def summary_table(outcomes: list[Outcome]) -> str:
    """One row a set."""
    return table(HEAD, [_row(name, [o for o in outcomes if o["set"] == name]) for name in _sets(outcomes)])


def category_table(group: list[Outcome]) -> str:
    """One row a category, and all together."""
    by = collections.defaultdict(list)
    for o in group:
        by[o["truth"]["category"]].append(o)
    return table(HEAD, [*(_row(c, by[c]) for c in sorted(by)), _row("**all**", group)])


def field_table(outcomes: list[Outcome]) -> str:
    """sAP, junctions, overlap of solids, one row a set."""
    rows = []
    for name in _sets(outcomes):
        group = [o for o in outcomes if o["set"] == name]
        ap = metrics.structural_ap([(o["truth"], o["answers"]) for o in group])
        right, got, want = np.sum([metrics.junction_counts(o["truth"], o["answers"]) for o in group], axis=0)
        precision, recall = right / max(got, 1), right / max(want, 1)
        f1 = 2 * precision * recall / max(precision + recall, 1e-9)
        solids = [[o[k] for o in group if k in o] for k in ("iou", "chamfer")]
        offs = [o["vertex_error"] for o in group if o["exact"] and o["answers"]]
        rows.append(
            [
                name,
                *(f"{100 * v:.1f}" for v in ap),
                *(f"{100 * v:.1f}" for v in (precision, recall, f1)),
                *(f"{np.median(s):.3f}" if s else "-" for s in solids),
                f"{np.median(offs):.2f}" if offs else "-",
            ]
        )
    head = ["", "sAP5", "sAP10", "sAP15", "corners P", "R", "F1", "IoU", "Chamfer", "vertex px"]
    note = (
        "sAP over all edges at 128 x 128 pixels; vertices matched one to one within 2 of those pixels; IoU and Chamfer"
        " distance (part of the diagonal) after similarity alignment, medians over exact answers whose depth the"
        " drawing fixes; largest vertex error in pixels, median over exact answers.\n"
    )
    return note + "\n" + table(head, rows)


def reliability(outcomes: list[Outcome], picture: Path) -> str:
    """Table and diagram: how often answers of a confidence are right, and accuracy against coverage."""
    sure = np.array([[o["confidence"], o["exact"]] for o in outcomes if o["answers"]], float).reshape(-1, 2)
    if not len(sure):
        return "Nothing was answered.\n"
    rows = []
    for low, high in [
        (0, 0.5),
        (0.5, 0.6),
        (0.6, 0.7),
        (0.7, 0.8),
        (0.8, 0.9),
        (0.9, 0.95),
        (0.95, 0.99),
        (0.99, 1.01),
    ]:
        part = sure[(sure[:, 0] >= low) & (sure[:, 0] < high)]
        if len(part):
            rows.append([f"{low:g} to {min(high, 1):g}", str(len(part)), _percent(part[:, 1].sum(), len(part))])
    best = sure[sure[:, 0] >= 0.9]
    text = f"Of {len(best)} answers with confidence 0.9 or more, {_percent(best[:, 1].sum(), len(best))} % are right.\n"
    _diagram(sure, len(outcomes), picture)
    return f"{text}\n![reliability]({picture.name})\n\n" + table(["confidence", "answers", "right %"], rows)


def _diagram(sure: np.ndarray[Any, Any], asked: int, picture: Path) -> None:
    import matplotlib as mpl

    mpl.use("svg")
    mpl.rcParams["svg.hashsalt"] = "sketch2shape"  # the same figures give the same file
    import matplotlib.pyplot as plt

    figure, (left, right) = plt.subplots(1, 2, figsize=(8, 3.6), layout="constrained")
    edges = np.quantile(sure[:, 0], np.linspace(0, 1, 11))
    bins = np.clip(np.searchsorted(edges, sure[:, 0], side="right") - 1, 0, 9)
    groups = [sure[bins == b] for b in range(10) if (bins == b).any()]
    mean, rate = (np.array([g[:, k].mean() for g in groups]) for k in (0, 1))
    spread = [1.96 * math.sqrt(max(r * (1 - r), 0.01) / len(g)) for r, g in zip(rate, groups, strict=True)]
    left.plot([0, 1], [0, 1], color="0.7")
    left.errorbar(mean, rate, yerr=spread, fmt="o", capsize=2)
    left.set(xlabel="confidence (tenths of the answers)", ylabel="right", xlim=(0, 1.02), ylim=(0, 1.02))
    order = np.argsort(-sure[:, 0], kind="stable")
    count = np.arange(1, len(sure) + 1)
    right.plot(count / asked, np.cumsum(sure[order, 1]) / count)
    right.set(xlabel="answered, most confident first (part of all)", ylabel="right, of those", ylim=(0.5, 1.01))
    figure.savefig(picture, metadata={"Date": None})
    plt.close(figure)


def failures(outcomes: list[Outcome], sheets: list[Path], folder: Path) -> str:
    """How often each cause, the sheets of pictures, and the list."""
    wrong = [o for o in outcomes if not o["exact"]]
    if not wrong:
        return "None.\n"
    kinds = collections.Counter((o["set"], kind_of(o)) for o in wrong)
    text = table(["what happened", "set", "drawings"], [[k, s, str(n)] for (s, k), n in kinds.most_common()])
    text += "\nTruth in green, the answer's front face red, back face and connecting edges blue.\n"
    text += "\n".join(f"\n![failures]({s.relative_to(folder).as_posix()})" for s in sheets) + "\n\n"
    rows = [
        [f"{o['set']}: {o['id']}", o["truth"].get("profile", ""), o["cause"], f"{o['confidence']:.2f}"] for o in wrong
    ]
    return text + table(["drawing", "profile", "cause", "confidence"], rows)


def kind_of(outcome: Outcome) -> str:
    """The cause without its numbers."""
    if outcome["status"] in ("crashed", "lost"):
        return f"{outcome['status']}: {outcome['message'].split(':')[0]}"
    if not outcome["answers"]:
        return "refused"
    if outcome["truth"].get("objects") == []:
        return "answered though there is no object"
    for words in ("vertices a face", "off by", "edges wrong", "objects right", "objects reported"):
        if words in outcome["cause"]:
            return {"off by": "a vertex is off", "vertices a face": "wrong number of vertices"}.get(words, words)
    return str(outcome["cause"])
