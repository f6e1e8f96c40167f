"""The same drawing, changed in ways that mean nothing: is the answer the same?"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from PIL import Image

from evaluation import curves, metrics
from evaluation.cases import Case
from evaluation.markdown import percent, table
from evaluation.outcome import SURE
from evaluation.transforms import TRANSFORMS, Pixels, mapped
from sketch2shape.model import Floats

Answers = list[dict[str, Any]]
Ask = Callable[[Pixels], Answers]


@dataclass(frozen=True)
class Trial:
    """One drawing, changed in one way.

    of_set, id : the drawing
    transform  : name in `TRANSFORMS`
    verdict    : "same", "lost" (an answer became none), "gained", or "other" (another answer)
    right      : right before and after; None where the truth is unknown
    sure       : confidence of 0.9 or more before and after
    moved      : change of the confidence
    """

    of_set: str
    id: str
    transform: str
    verdict: str
    right: tuple[bool, bool] | None
    sure: tuple[bool, bool]
    moved: float


def pixels_of(picture: str) -> Pixels:
    """(h, w, 3) RGB of a file, what is transparent as white."""
    with Image.open(picture) as opened:
        rgba = opened.convert("RGBA")
        ground = Image.new("RGBA", rgba.size, "white")
        return np.ascontiguousarray(np.asarray(Image.alpha_composite(ground, rgba).convert("RGB")))


def ask(pixels: Pixels) -> Answers:
    """What the tool reports for an array; none if it refuses."""
    import sketch2shape as s2s
    from sketch2shape.pipeline.report import report

    try:
        return list(report(s2s.reconstruct(pixels))["objects"])
    except s2s.Sketch2ShapeError:
        return []


def trials(case: Case, names: Sequence[str] = tuple(TRANSFORMS), answer: Ask = ask) -> list[Trial]:
    """The drawing asked about as it is, then changed in each way."""
    pixels = pixels_of(case.picture)
    before = answer(pixels)
    out = []
    for name in names:
        changed, move = TRANSFORMS[name](pixels)
        inverse: Floats = np.linalg.inv(move).astype(np.float64)
        back = [_moved(a, inverse) for a in answer(changed)]
        sure = [max((float(a["confidence"]) for a in some), default=0.0) for some in (before, back)]
        out.append(
            Trial(
                case.set,
                case.id,
                name,
                verdict(before, back),
                _right(case, before, back),
                (sure[0] >= SURE, sure[1] >= SURE),
                sure[1] - sure[0],
            )
        )
    return out


def verdict(before: Answers, after: Answers) -> str:
    """Whether two reports about one picture say the same: as many objects, each with its like."""
    if not before or not after:
        return "same" if before == after else "lost" if before else "gained"
    used: set[int] = set()
    for one in before:
        like = next((k for k, other in enumerate(after) if k not in used and _alike(one, other)), None)
        if like is None:
            return "other"
        used.add(like)
    return "same" if len(after) == len(before) else "other"


def _alike(one: dict[str, Any], other: dict[str, Any]) -> bool:
    """The same vertices and edges, by the tolerance of drawings by hand."""
    return metrics.compare({"projection": "oblique", "medium": "hand"} | one, other).exact


def _moved(answer: dict[str, Any], move: Floats) -> dict[str, Any]:
    return answer | mapped(answer, move) | {"holes": [mapped(h, move) for h in answer["holes"]]}


def _right(case: Case, before: Answers, after: Answers) -> tuple[bool, bool] | None:
    truth = case.truth
    if "f1" not in truth and not isinstance(truth.get("objects"), list):
        return None
    if curves.has_curves(truth):
        return None  # only the rings of the answers are moved back, not their arcs
    return metrics.judge(truth, before).exact, metrics.judge(truth, after).exact


def metamorphic_table(found: Sequence[Trial]) -> str:
    """One row a transformation: how often the answer is the same, what became of the others, and of the right ones."""
    rows = []
    for name in dict.fromkeys(t.transform for t in found):
        group = [t for t in found if t.transform == name]
        known = [t.right for t in group if t.right is not None]
        counts = [str(sum(t.verdict == kind for t in group)) for kind in ("lost", "gained", "other")]
        same = sum(t.verdict == "same" for t in group)
        rights = [str(sum(r[k] for r in known)) for k in (0, 1)]
        both = [str(sum(r == pair for r in known)) for pair in ((True, False), (False, True))]
        steady = [t for t in group if t.verdict == "same" and t.sure[0] == t.sure[1]]
        shares = percent(same, len(group)), percent(len(steady), same)
        rows.append([name, str(len(group)), shares[0], *counts, *rights, *both, shares[1]])
    head = ["", "n", "same %", "lost", "gained", "other", "right before", "after", "broken", "mended", "as sure %"]
    return table(head, rows)
