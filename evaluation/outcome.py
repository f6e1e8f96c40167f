"""What became of one drawing, as plain data for pages, pictures and comparison."""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

from evaluation.cases import Case

SURE = 0.9
"""Confidence from which on an answer is called sure; the promise is that 99 % of those are right."""

NAN = float("nan")


@dataclass(frozen=True)
class Outcome:
    """One drawing, what was answered, and how that was judged.

    case         : the drawing
    status       : "ok", "refused" (an error of the tool's own), "crashed" (any other), "lost" (killed or too slow)
    message      : the error in words
    answers      : the report's objects
    ms           : time of the call, milliseconds
    right        : is the answer, or the refusal, right? None where only the eye can tell
    cause        : what is wrong, in a few words
    mesh, solid  : is it right with a sound mesh; with right proportions?
    vertex_error : largest distance of a vertex from its place, pixels
    solid_error  : relative RMS distance from the true solid
    iou, chamfer : overlap with the true solid, distance of the surfaces (fraction of the diagonal)
    """

    case: Case
    status: Literal["ok", "refused", "crashed", "lost"] = "ok"
    message: str = ""
    answers: tuple[dict[str, Any], ...] = ()
    ms: float = 0.0
    right: bool | None = False
    cause: str = ""
    mesh: bool = False
    solid: bool = False
    vertex_error: float = NAN
    solid_error: float = NAN
    iou: float = NAN
    chamfer: float = NAN

    @property
    def answered(self) -> bool:
        """Whether something was reported."""
        return bool(self.answers)

    @property
    def wrong(self) -> bool:
        """Whether it is known to be wrong."""
        return self.right is False

    @property
    def confidence(self) -> float:
        """Of the surest object reported; not a number if there is none."""
        return max((float(a["confidence"]) for a in self.answers), default=NAN)

    @property
    def sure(self) -> bool:
        """Whether something was reported with a confidence of `SURE` or more."""
        return self.confidence >= SURE


def save(outcomes: Sequence[Outcome], path: Path) -> None:
    """Write one JSON record a drawing, one a line, in order."""
    lines = [json.dumps(_record(o)) for o in outcomes]
    path.write_text("[\n" + ",\n".join(lines) + "\n]\n")


def _record(outcome: Outcome) -> dict[str, Any]:
    """All but the truth and the picture's place, which belong to the machine and not to the answer."""
    case = outcome.case
    told = {"set": case.set, "id": case.id, "category": case.truth["category"], "half": case.half}
    fields = {f.name: getattr(outcome, f.name) for f in dataclasses.fields(outcome) if f.name != "case"}
    return _finite(told | {"confidence": outcome.confidence} | fields)


def _finite(record: dict[str, Any]) -> dict[str, Any]:
    """Not-a-number as null, which JSON has."""
    return {k: None if isinstance(v, float) and v != v else v for k, v in record.items()}
