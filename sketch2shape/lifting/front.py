"""Which cap is in front, where the drawing alone cannot tell (the Necker cube)."""

from __future__ import annotations

import numpy as np

from sketch2shape.model import Floats, Side, TwoFaceObject

_SIDES: tuple[Side, Side] = ("f1", "f2")


def choose_front(obj: TwoFaceObject) -> TwoFaceObject:
    """The object with f1 as the cap nearer to the viewer.

    Hidden lines that are dashed or left out have already told f1, so it stays. A wireframe has two readings, each
    the other turned inside out. If one cap is drawn smaller it is the farther one (perspective). Else the object is
    taken as seen from above, as most things are drawn: the cap drawn lower is in front, except that of an
    upright object, whose connecting edges are drawn vertical, the top is the visible cap.
    """
    if obj.lines != "wire" or obj.is_pointed:
        return obj
    f1, f2 = (obj.outlines(face)[0] for face in _SIDES)
    size1, size2 = _size(f1), _size(f2)
    slack = 0.02 + 4.0 * obj.noise / max(size1, size2, 1e-9)
    if abs(size2 - size1) > slack * max(size1, size2):
        return obj if size2 < size1 else obj.swapped()
    d = (f2 - f1).mean(axis=0) if len(f1) == len(f2) else f2.mean(axis=0) - f1.mean(axis=0)
    upright = _is_plumb(d, 0.02) or (_is_plumb(d, 0.15) and not _has_plumb_edge(obj.f1))
    behind = d[1] > 0 if upright else d[1] < 0 or (d[1] == 0 and d[0] > 0)
    return obj if behind else obj.swapped()


def _is_plumb(vector: Floats, slack: float) -> bool:
    """Is a vector drawn vertical, to within this sine?"""
    return bool(abs(vector[0]) <= slack * np.hypot(*vector))


def _has_plumb_edge(ring: Floats) -> bool:
    edges = np.roll(ring, -1, axis=0) - ring
    return any(_is_plumb(edge, 0.05) for edge in edges)


def _size(ring: Floats) -> float:
    """Root mean square distance of a ring's vertices from their mean, pixels."""
    return float(np.sqrt(((ring - ring.mean(axis=0)) ** 2).sum(axis=1).mean()))
