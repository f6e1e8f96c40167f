"""Two runs of `evaluate.py --raw` compared, drawing by drawing."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from evaluation.markdown import table
from evaluation.outcome import SURE

Record = dict[str, Any]
Run = dict[tuple[str, str], Record]

KINDS = ("fixed", "broken", "sure and wrong now", "no longer sure and wrong", "other verdict", "surer", "less sure")
VERDICTS = {(False, True): "fixed", (True, False): "broken"}
"""Kind of change by the verdict before and after; None is left to the eye."""


@dataclass(frozen=True)
class Change:
    """What changed for one drawing.

    kind   : one of `KINDS`
    of_set : name of the set
    id     : of the drawing
    words  : confidence and cause before and after
    """

    kind: str
    of_set: str
    id: str
    words: str

    def __str__(self) -> str:
        """One line for the screen."""
        return f"{self.kind:24s} {self.of_set}: {self.id}  {self.words}"


def load(path: Path) -> Run:
    """The records of a run by set and drawing."""
    return {(r["set"], r["id"]): r for r in json.loads(path.read_text())}


def changes(before: Run, after: Run, moved: float = 0.05) -> list[Change]:
    """All changes of the drawings that both runs have, by set and kind.

    moved : least change of confidence that counts where the verdict is the same
    """
    found = []
    for key in after:
        if key in before:
            kind = _kind(before[key], after[key], moved)
            if kind:
                found.append(Change(kind, *key, _words(before[key], after[key])))
    sets = list(dict.fromkeys(s for s, _ in after))
    return sorted(found, key=lambda c: (sets.index(c.of_set), KINDS.index(c.kind), c.id))


def _kind(a: Record, b: Record, moved: float) -> str | None:
    if a["right"] != b["right"]:
        return VERDICTS.get((a["right"], b["right"]), "other verdict")
    sure = [a["right"] is False and (r["confidence"] or 0) >= SURE for r in (a, b)]
    if sure[0] != sure[1]:
        return "sure and wrong now" if sure[1] else "no longer sure and wrong"
    off = (b["confidence"] or 0) - (a["confidence"] or 0)
    if abs(off) < moved:
        return None
    return "surer" if off > 0 else "less sure"


def _words(a: Record, b: Record) -> str:
    def told(r: Record) -> str:
        sure = "no answer" if r["confidence"] is None else f"{r['confidence']:.2f}"
        return f"{sure} {r['cause']}".strip()

    return f"{told(a)} -> {told(b)}"


def summary(before: Run, after: Run, found: Sequence[Change]) -> str:
    """One row a set: right before and after of the drawings both runs have, and how many changes of each kind."""
    common = [k for k in after if k in before]
    rows = []
    for name in dict.fromkeys(s for s, _ in common):
        keys = [k for k in common if k[0] == name]
        rights = [str(sum(run[k]["right"] is True for k in keys)) for run in (before, after)]
        kinds = [str(sum(c.of_set == name and c.kind == kind for c in found)) for kind in KINDS]
        times = [f"{sum(run[k]['ms'] for k in keys) / 1e3:.1f}" for run in (before, after)]
        rows.append([name, str(len(keys)), *rights, *kinds, *times])
    alone = len(before) + len(after) - 2 * len(common)
    note = f"\n{alone} drawings are in one run only.\n" if alone else ""
    return table(["", "n", "right before", "after", *KINDS, "s before", "after"], rows) + note
