"""How well a hypothesis explains a drawing, and how sure that makes it."""

from __future__ import annotations

from sketch2shape.evidence.calibration import REFUSE_BELOW, confidence
from sketch2shape.evidence.detectors_agree import vouched
from sketch2shape.evidence.energy import Comparison, Energy, compare
from sketch2shape.evidence.score import PERFECT, Evidence, is_dashed, judge, judge_all, judge_stack, most_possible
from sketch2shape.evidence.sheet import Sheet, sheet_for
from sketch2shape.evidence.unexplained import unexplained_strokes
from sketch2shape.evidence.view import View, observe
from sketch2shape.evidence.witness import WITNESSES, witnesses

__all__ = [
    "PERFECT",
    "REFUSE_BELOW",
    "WITNESSES",
    "Comparison",
    "Energy",
    "Evidence",
    "Sheet",
    "View",
    "compare",
    "confidence",
    "is_dashed",
    "judge",
    "judge_all",
    "judge_stack",
    "most_possible",
    "observe",
    "sheet_for",
    "unexplained_strokes",
    "vouched",
    "witnesses",
]
