"""The page docs/results.md: tables and the reliability diagram from the outcomes of `evaluate.py`."""

from __future__ import annotations

import collections
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from evaluation import metrics
from evaluation.cases import BY_EYE, SETS
from evaluation.confidence import confidence_tables, diagram
from evaluation.curves import has_curves
from evaluation.markdown import percent, table
from evaluation.outcome import Outcome

INTRO = """# Results

Written by `scripts/evaluate.py`; do not edit. Made with

    {command}

- **right**: every vertex matched one to one within tolerance and the edges identical, hidden ones included; a picture
  without an object must be refused, a sheet of several must give each and no more. Of arcs and apexes: every ring's
  line within tolerance, its sharp vertices, its number of arcs, the apex. For `abc`: of the mesh's and the
  true mesh's surface samples 99 % lie within 3 % of the object's size of each other, the areas differ by at most 4 %.
- **even**, **odd**: the same for the drawings whose file name ends in an even or odd character (`abc`:
  by the one before). Numbers of the method
  are chosen on one half; the other tells whether they hold.
- **mesh**: right, and the mesh is watertight, outward, of the right genus, with exactly the object's vertices.
- **solid**: right, and the three-dimensional proportions are right (5 %, by hand 10 %, in perspective 12 %; where the
  drawing does not fix the depth, those of the front face).
- **answered**: pictures for which something was reported. Times are of `reconstruct` in a warm process while {jobs}
  processes ran.
"""
FRESH = ("committed", "fresh")
"""Sets of this repository's own generator: only their pictures may be shown."""


def write_page(page: Path, outcomes: Sequence[Outcome], command: str, sheets: Sequence[Path], jobs: int = 2) -> None:
    """Write the page and its diagram."""
    page.parent.mkdir(parents=True, exist_ok=True)
    parts = [INTRO.format(command=command, jobs=jobs), "## All\n", summary_table(outcomes)]
    parts += ["## Measures of the field\n", field_table(outcomes)]
    parts += ["## Confidence\n", confidence_tables(outcomes), diagram(outcomes, page.parent / "reliability.svg")]
    for name in sets_of(outcomes):
        group = [o for o in outcomes if o.case.set == name]
        tables = refusal_table(group) if name == "refuse" else category_table(group)
        parts += [f"## {SETS[name].title}\n", tables]
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


def sets_of(outcomes: Sequence[Outcome]) -> list[str]:
    """Names of the sets, in order."""
    return list(dict.fromkeys(o.case.set for o in outcomes))


HEAD = ["", "n", "right %", "even", "odd", "mesh %", "solid %", "answered %", "p50 ms", "p95 ms"]


def _row(name: str, group: Sequence[Outcome]) -> list[str]:
    n = len(group)
    halves = [[o for o in group if o.case.half == half] for half in ("even", "odd")]
    rights = [percent(sum(o.right is True for o in part), len(part)) for part in (group, *halves)]
    counts = [sum(getattr(o, k) for o in group) for k in ("mesh", "solid", "answered")]
    times = np.percentile([o.ms for o in group], (50, 95))
    return [name, str(n), *rights, *(percent(c, n) for c in counts), *(f"{t:.0f}" for t in times)]


def summary_table(outcomes: Sequence[Outcome]) -> str:
    """One row a set; pictures that only the eye can judge count as right if they are refused."""
    return table(HEAD, [_row(name, [o for o in outcomes if o.case.set == name]) for name in sets_of(outcomes)])


def by_category(group: Sequence[Outcome]) -> dict[str, list[Outcome]]:
    """The outcomes of each category, sorted by its name."""
    by: dict[str, list[Outcome]] = collections.defaultdict(list)
    for o in group:
        by[str(o.case.truth["category"])].append(o)
    return dict(sorted(by.items()))


def category_table(group: Sequence[Outcome]) -> str:
    """One row a category, and all together."""
    return table(HEAD, [*(_row(c, some) for c, some in by_category(group).items()), _row("**all**", group)])


def refusal_table(group: Sequence[Outcome]) -> str:
    """What was answered, and how surely, for pictures that hold no object of a kind that is read."""
    note = (
        "Nothing here has a written truth. Kinds marked * may hold solids, so that an answer is judged by eye; all"
        " other answers are wrong.\n\n"
    )
    rows = [
        *([f"{c}{'*' * (c in BY_EYE)}", *_refusals(some)] for c, some in by_category(group).items()),
        ["**all**", *_refusals(group)],
    ]
    return note + table(["", "n", "answered", "even", "odd", "answered %", "sure"], rows)


def _refusals(group: Sequence[Outcome]) -> list[str]:
    answered = [o for o in group if o.answered]
    halves = [str(sum(o.case.half == half for o in answered)) for half in ("even", "odd")]
    share = percent(len(answered), len(group))
    return [str(len(group)), str(len(answered)), *halves, share, str(sum(o.sure for o in answered))]


def field_table(outcomes: Sequence[Outcome]) -> str:
    """sAP, junctions, overlap of solids, one row for each set whose truth is vertices."""
    rows = []
    for name in sets_of(outcomes):
        group = [o for o in outcomes if o.case.set == name and _of_vertices(o.case.truth)]
        if not group:
            continue
        pairs = [(o.case.truth, o.answers) for o in group]
        ap = metrics.structural_ap(pairs)
        right, got, want = np.sum([metrics.junction_counts(*p) for p in pairs], axis=0)
        precision, recall = right / max(got, 1), right / max(want, 1)
        f1 = 2 * precision * recall / max(precision + recall, 1e-9)
        shares = [f"{100 * v:.1f}" for v in (*ap, precision, recall, f1)]
        iou, chamfer = (_median([getattr(o, k) for o in group], 3) for k in ("iou", "chamfer"))
        rows.append([name, *shares, iou, chamfer, _median([o.vertex_error for o in group if o.right], 2)])
    head = ["", "sAP5", "sAP10", "sAP15", "corners P", "R", "F1", "IoU", "Chamfer", "vertex px"]
    note = (
        "sAP over all edges at 128 x 128 pixels; vertices matched one to one within 2 of those pixels; IoU and Chamfer"
        " distance (fraction of the diagonal) after similarity alignment, medians over right answers whose depth the"
        " drawing fixes; largest vertex error in pixels, median over right answers.\n"
    )
    return note + "\n" + table(head, rows)


def _of_vertices(truth: dict[str, Any]) -> bool:
    return ("f1" in truth or bool(truth.get("objects"))) and not has_curves(truth)


def _median(values: Sequence[float], digits: int) -> str:
    known = [v for v in values if v == v]
    return f"{np.median(known):.{digits}f}" if known else "-"


def failures(outcomes: Sequence[Outcome], sheets: Sequence[Path], folder: Path) -> str:
    """How often each cause, the sheets of pictures, the list, and what is left to the eye."""
    wrong = [o for o in outcomes if o.wrong]
    open_ = [o for o in outcomes if o.right is None]
    if not wrong and not open_:
        return "None.\n"
    kinds = collections.Counter((o.case.set, kind_of(o)) for o in wrong)
    text = table(["what happened", "set", "drawings"], [[k, s, str(n)] for (s, k), n in kinds.most_common()])
    text += "\nTruth in green, the answer's front face red, back face and connecting edges blue.\n"
    text += "\n".join(f"\n![failures]({s.relative_to(folder).as_posix()})" for s in sheets) + "\n\n"
    head = ["drawing", "profile", "cause", "confidence"]
    text += table(head, [_failure(o, o.cause) for o in wrong])
    if open_:
        text += "\nAnswers that only the eye can judge:\n\n" + table(head, [_failure(o, "") for o in open_])
    return text


def _failure(outcome: Outcome, cause: str) -> list[str]:
    case = outcome.case
    confidence = f"{outcome.confidence:.2f}" if outcome.answered else "-"
    return [f"{case.set}: {case.id}", str(case.truth.get("profile", "")), cause, confidence]


def kind_of(outcome: Outcome) -> str:
    """The cause without its numbers."""
    if outcome.status in ("crashed", "lost"):
        return f"{outcome.status}: {outcome.message.split(':')[0]}"
    if not outcome.answered:
        return "refused"
    if outcome.case.truth.get("objects") == []:
        return "answered though there is no object"
    for words in ("vertices a face", "off by", "edges wrong", "objects right", "objects reported", "area"):
        if words in outcome.cause:
            named = {"off by": "a vertex or surface is off", "vertices a face": "wrong number of vertices"}
            return named.get(words, {"area": "the area is wrong"}.get(words, words))
    return outcome.cause
