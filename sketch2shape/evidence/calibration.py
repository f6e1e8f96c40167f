"""Confidence: from how well an answer explains its drawing to how often such answers are right.

The score of verification is no probability. The table below was read off some 1,400 answers on drawings of many media
and on real pictures: what part of the answers with a score near this was right, with a margin. Of answers given with
0.9 or more at least 99 in 100 should be right; `scripts/evaluate.py` draws the reliability diagram.
"""

from __future__ import annotations

import numpy as np

SCORES = (0.0, 0.65, 0.8, 0.9, 0.979, 0.98, 0.99, 1.0)
CONFIDENCES = (0.0, 0.4, 0.5, 0.8, 0.85, 0.9, 0.96, 0.995)
REFUSE_BELOW = 0.4
"""Confidence below which an answer is no answer: most such answers are wrong, or there is nothing to be found."""


def calibrated(score: float) -> float:
    """Confidence 0..1 of an answer with this score of verification, 0..1."""
    return float(np.interp(score, SCORES, CONFIDENCES))
