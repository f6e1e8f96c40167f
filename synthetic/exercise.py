"""What textbooks draw into round and pointed solids: the axis or height, radii, diameters, centres, letters."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from sketch2shape.model import Floats
from synthetic.hand import Hand, Stroke, freehand
from synthetic.marks import text
from synthetic.pens import Coverage, Pen, coverage
from synthetic.turned_scenes import Turned


def exercise(made: Turned, size: tuple[int, int], pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """The height or axis, a radius or diameter, centre marks and letters, some of them."""
    fine = replace(pen, width=max(pen.width * float(rng.uniform(0.5, 1.0)), 1.0), dash=pen.dash or (1.4, 1.0))
    ends = made.view(np.array([[0, 0, 0], [0, 0, made.depth]], float))[:, :2]
    drawn = np.vstack([line.path for line in made.lines])
    strokes, height = [], max(0.045 * float(np.linalg.norm(np.ptp(drawn, axis=0))), 11.0)
    letters: list[tuple[str, Floats]] = []
    if rng.random() < 0.75:
        beyond = float(rng.choice([0.0, 0.15])) * (ends[1] - ends[0])
        strokes.append(Stroke(freehand(np.array([ends[0] - beyond, ends[1] + beyond]), hand, rng), hidden=True))
        letters.append(("h", (ends[0] + ends[1]) / 2 + [height, 0]))
    ring = made.rings[0]
    rim = (
        ring.circle.at(np.array([rng.random()])) if ring.circle else ring.points[[int(rng.integers(len(ring.points)))]]
    )
    for k, (scale, z) in enumerate(((1.0, 0.0), (made.scale, made.depth))):
        if scale and rng.random() < 0.6:
            spoke = made.view(np.c_[np.vstack([np.zeros(2), scale * rim]), [z, z]])[:, :2]
            start = spoke[0] if rng.random() < 0.7 else 2 * spoke[0] - spoke[1]
            path = freehand(np.array([start, spoke[1]]), hand, rng)
            strokes.append(Stroke(path, hidden=bool(rng.random() < 0.4)))
            letters.append(("rR"[k], spoke.mean(0) + [0, -0.8 * height]))
        if rng.random() < 0.5:
            arm = 0.5 * height * np.array([[-1, 0], [1, 0], [0, -1], [0, 1.0]])
            strokes += [Stroke(ends[k] + arm[:2]), Stroke(ends[k] + arm[2:])]
            letters.append(("O" if k == 0 else "S", ends[k] + [-height, height]))
    out = coverage(strokes, fine, size, rng)
    for name, at in letters:
        if rng.random() < 0.7:
            out = np.maximum(out, text(name, (float(at[0]), float(at[1])), height, size, "print"))
    return out
