"""What textbooks draw into round and pointed solids: the axis or height, radii, diameters, centres, letters."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.spatial import cKDTree

from sketch2shape.model import Floats
from synthetic.hand import Hand, Stroke, freehand
from synthetic.marks import text
from synthetic.pens import Coverage, Pen, coverage
from synthetic.turned_scenes import Turned

LETTER = 0.05
"""Height of a letter, part of the object's diagonal; with broad pens it is `PENS` widths of them."""
PENS = 6.0
"""Height of a letter in widths of the pen, where that is more."""
LETTERED = 6
"""Corners that a base may have for all of them to get letters."""

Word = tuple[str, Floats]
"""A letter and the point that it names."""


def exercise(made: Turned, size: tuple[int, int], pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """The height or axis, a radius or diameter, centre marks and letters, some of them."""
    fine = replace(pen, width=max(pen.width * float(rng.uniform(0.5, 1.0)), 1.0), dash=pen.dash or (1.4, 1.0))
    drawn = np.vstack([line.path for line in made.lines])
    height = max(LETTER * float(np.linalg.norm(np.ptp(drawn, axis=0))), PENS * pen.width, 11.0)
    strokes, words = _added(made, height, hand, rng)
    out = coverage(strokes, fine, size, rng)
    named = [word for word in words if rng.random() < 0.8]
    if not made.rings[0].circle and len(made.rings[0].points) <= LETTERED and rng.random() < 0.6:
        named += _corners(made)
    taken = np.vstack([_dense(path) for path in [*(x.path for x in made.lines), *(s.path for s in strokes)]])
    for name, at in named:
        place = _free(at, 1.1 * height, taken, size)
        taken = np.vstack([taken, place[None]])
        out = np.maximum(out, text(name, (float(place[0]), float(place[1])), height, size, "print"))
    return out


def _added(made: Turned, height: float, hand: Hand, rng: np.random.Generator) -> tuple[list[Stroke], list[Word]]:
    """Lines within the solid, and the letters that belong to them."""
    ends = made.view(np.array([[0, 0, 0], [0, 0, made.depth]], float))[:, :2]
    strokes: list[Stroke] = []
    words: list[Word] = []
    if rng.random() < 0.75:
        beyond = float(rng.choice([0.0, 0.15])) * (ends[1] - ends[0])
        strokes.append(Stroke(freehand(np.array([ends[0] - beyond, ends[1] + beyond]), hand, rng), hidden=True))
        words.append(("h", (ends[0] + ends[1]) / 2))
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
            words.append(("rR"[k], spoke.mean(0)))
        if rng.random() < 0.5:
            arm = 0.5 * height * np.array([[-1, 0], [1, 0], [0, -1], [0, 1.0]])
            strokes += [Stroke(ends[k] + arm[:2]), Stroke(ends[k] + arm[2:])]
            words.append(("S" if scale == 0 else "OM"[k], ends[k]))
    return strokes, words


def _corners(made: Turned) -> list[Word]:
    """Letters of the corners of the front face, from A."""
    corners = made.rings[0].points
    seen = made.view(np.c_[corners, np.zeros(len(corners))])[:, :2]
    return [(chr(ord("A") + i), at) for i, at in enumerate(seen)]


def _free(at: Floats, off: float, taken: Floats, size: tuple[int, int]) -> Floats:
    """The place beside a point, `off` pixels away, that is farthest from what is drawn and on the sheet."""
    turn = np.radians(np.arange(0, 360, 15))
    places = at + off * np.c_[np.cos(turn), np.sin(turn)]
    inside = ((places > off / 2) & (places < np.array(size) - off / 2)).all(1)
    best: Floats = places[int(np.argmax(np.where(inside, cKDTree(taken).query(places)[0], -1)))]
    return best


def _dense(path: Floats) -> Floats:
    """The polyline with points about every 3 pixels, (k, 2)."""
    steps = np.r_[0, np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1))]
    at = np.linspace(0, steps[-1], max(int(steps[-1] / 3), 2))
    points: Floats = np.c_[np.interp(at, steps, path[:, 0]), np.interp(at, steps, path[:, 1])]
    return points
