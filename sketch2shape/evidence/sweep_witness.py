"""Witnesses for and against a sweep, from which its confidence follows as that of all answers does (see `witness`)."""

from __future__ import annotations

import numpy as np

from sketch2shape.evidence.chords import chords, faces_of
from sketch2shape.evidence.energy import Comparison, Energy, near_line
from sketch2shape.evidence.witness import attached, closed
from sketch2shape.hypotheses import frame
from sketch2shape.model import Bools, Floats, Ints
from sketch2shape.sweeps import Sweep

SWEEP_WITNESSES = (
    "unexplained",
    "attached",
    "closed",
    "missing",
    "noise",
    "gap",
    "numbers",
    "unseen",
    "shallow",
    "small",
    "pointed",
    "inferred",
    "standing",
    "holes",
    "lone",
    "chords",
)
"""Names of the witnesses, in order."""
FEW_LINES = 4
"""Lines with ink up to which a drawing may as well be a flat figure."""
MOST_GAP = 150.0
"""Nats to the next best answer beyond which more say no more."""


def sweep_witnesses(sweep: Sweep, energy: Energy, compared: Comparison, gap: float, leaning: float) -> Floats:
    """(w,) float, see `SWEEP_WITNESSES`.

    gap     : nats to the best sweep that is another object
    leaning : nats for how it stands, see `search.found_sweep`
    """
    view = compared.view
    left, distance, edge = _left(energy, compared)
    ink = float(view.length.sum()) + 1e-9
    hidden = float(compared.hidden.sum()) / (float(compared.lengths.sum()) / view.unit + 1e-9)
    line = sweep.rings[0].line
    depth = float(np.median(np.hypot(*sweep.way.of(line).T)))
    # edges that ink lies on: a figure of few lines fits many objects
    lines = len(np.unique(edge[~left])) if (~left).any() else 0
    return np.array(
        [
            unexplained_part(energy, compared),
            attached(view, left, distance, view.size) / ink,
            closed(view, left) / view.size,
            np.log1p(energy.missing),
            np.log(energy.noise / view.noises[0]),
            np.log1p(float(np.clip(gap, 0.0, MOST_GAP))),
            np.log(sweep.shape_numbers),
            hidden if energy.lines == "removed" else 0.0,
            np.log(depth / (view.pen + 2 * energy.noise) + 1e-9),
            np.log(view.size / view.pen),
            float(sweep.way.is_pointed),
            float(sweep.regular is not None),
            leaning,
            float(len(sweep.rings) - 1),
            float(lines <= FEW_LINES),
            _chords(sweep, view.points[left], near_line(energy.noise), view.size),
        ]
    )


def _chords(sweep: Sweep, foreign: Floats, reach: float, size: float) -> float:
    """See `chords`; of arcs their ends count."""
    rings = [ring.vertices for ring in sweep.rings if len(ring.vertices)]
    if not rings:
        return 0.0
    front = np.concatenate(rings)
    back = front + sweep.way.of(front)
    edges = frame(tuple(len(ring) for ring in rings)).edges
    v = np.concatenate([front, back])
    if sweep.way.is_pointed:
        edges, v = np.minimum(edges, len(front)), v[: len(front) + 1]
    outline = sweep.rings[0].line
    return chords(foreign, v, edges, lambda: faces_of(outline, outline + sweep.way.of(outline)), reach, size)


def unexplained_part(energy: Energy, compared: Comparison) -> float:
    """Part of the ink that lies on none of a sweep's lines, 0..1."""
    view = compared.view
    left, _, _ = _left(energy, compared)
    return float(view.length[left].sum()) / (float(view.length.sum()) + 1e-9)


def _left(energy: Energy, compared: Comparison) -> tuple[Bools, Floats, Ints]:
    """(k,) which ink lies on no line, its distance to the nearest one, pixels, and that line's number."""
    distance, edge = compared.seen if energy.lines == "removed" else compared.every
    return distance > near_line(energy.noise), distance, edge
