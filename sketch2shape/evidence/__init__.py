"""How well a hypothesis explains a drawing, and how sure that makes it."""

from __future__ import annotations

from sketch2shape.evidence.behind import BESIDE, shown_behind, shows_little
from sketch2shape.evidence.calibration import EVEN_ODDS, REFUSE_BELOW, Weights, confidence
from sketch2shape.evidence.chords import faces_of
from sketch2shape.evidence.coverage import coverage, is_crowded
from sketch2shape.evidence.detectors_agree import vouched
from sketch2shape.evidence.energy import LEAST_DRAWN, Comparison, Energy, compare, near_line, nearest_edges, with_hidden
from sketch2shape.evidence.exact import exactly_drawn
from sketch2shape.evidence.redrawing import compare_sweep
from sketch2shape.evidence.rivals import against_rivals, rivalry
from sketch2shape.evidence.score import PERFECT, Evidence, is_dashed, judge, judge_all, judge_stack, most_possible
from sketch2shape.evidence.sheet import Sheet, sheet_for
from sketch2shape.evidence.sweep_calibration import sweep_confidence
from sketch2shape.evidence.sweep_witness import SWEEP_WITNESSES, sweep_witnesses, unexplained_part
from sketch2shape.evidence.unexplained import unexplained_strokes
from sketch2shape.evidence.view import View, observe
from sketch2shape.evidence.witness import WITNESSES, is_table, witnesses

__all__ = [
    "BESIDE",
    "EVEN_ODDS",
    "LEAST_DRAWN",
    "PERFECT",
    "REFUSE_BELOW",
    "SWEEP_WITNESSES",
    "WITNESSES",
    "Comparison",
    "Energy",
    "Evidence",
    "Sheet",
    "View",
    "Weights",
    "against_rivals",
    "compare",
    "compare_sweep",
    "confidence",
    "coverage",
    "exactly_drawn",
    "faces_of",
    "is_crowded",
    "is_dashed",
    "is_table",
    "judge",
    "judge_all",
    "judge_stack",
    "most_possible",
    "near_line",
    "nearest_edges",
    "observe",
    "rivalry",
    "sheet_for",
    "shown_behind",
    "shows_little",
    "sweep_confidence",
    "sweep_witnesses",
    "unexplained_part",
    "unexplained_strokes",
    "vouched",
    "with_hidden",
    "witnesses",
]
