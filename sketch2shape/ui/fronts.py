"""Which sides of a box the page calls front and back: those that stand in front and behind once it stands upright.

Any two opposite sides of a box can pass for the two faces. The search takes the pair that explains the drawing, and the
lifting reads all three; a person looks for the side that faces them.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from sketch2shape.lifting import OTHER_PAIRS, lift
from sketch2shape.model import Answer, Ints, Solid, TwoFaceObject

_ALIKE = 0.02
"""Sizes that differ by less than this fraction are those of the same solid."""


def faced(answer: Answer) -> Answer:
    """The answer with the front of each box as its front face; of its solid only the vertices' order changes."""
    pairs = [_faced(obj, solid) for obj, solid in zip(answer.objects, answer.solids, strict=True)]
    return replace(answer, objects=tuple(p[0] for p in pairs), solids=tuple(p[1] for p in pairs))


def _faced(obj: TwoFaceObject, solid: Solid) -> tuple[TwoFaceObject, Solid]:
    order = _order(obj, solid)
    if order is None:
        return obj, solid
    points, seen = np.concatenate([obj.f1, obj.f2]), np.ones(8, bool)
    if obj.f2_drawn is not None:
        seen[4:] = obj.f2_drawn
    told = None if obj.f2_drawn is None else seen[order[4:]]
    if not seen[order[:4]].all():  # a front that was inferred would pass for one that was seen
        return obj, solid
    turned = replace(obj, f1=points[order[:4]], f2=points[order[4:]], f2_drawn=told)
    again = lift(turned)
    same = np.allclose(again.dimensions, solid.dimensions, rtol=_ALIKE)
    return (turned, replace(again, confidence=solid.confidence)) if same else (obj, solid)


def _order(obj: TwoFaceObject, solid: Solid) -> Ints | None:
    """The numbers of the vertices, front then back; None if they are in that order or it is no box."""
    if len(obj.f1) != 4 or len(obj.f2) != 4 or obj.holes or obj.is_round or solid.up != "z":
        return None
    ways = [np.arange(8), *OTHER_PAIRS]
    ways += [np.roll(way, 4) for way in ways]
    at = solid.vertices
    through = [at[way[4:]].mean(axis=0) - at[way[:4]].mean(axis=0) for way in ways]
    best = int(np.argmax([d[1] / max(float(np.linalg.norm(d)), 1e-9) for d in through]))
    return ways[best] if best else None
