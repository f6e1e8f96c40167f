"""Answers as the page keeps them: plain data, ready for JSON."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from sketch2shape.lifting.measure import free_size
from sketch2shape.lifting.options import SIZES
from sketch2shape.model import Answer, Floats, Solid, TwoFaceObject
from sketch2shape.pictures.facets import stand
from sketch2shape.pictures.viewer import shape
from sketch2shape.pipeline.report import curves
from sketch2shape.solids import shape_name


def described(answer: Answer) -> dict[str, Any]:
    """The objects and solids of an answer."""
    sure = answer.confidences
    return {
        "objects": [_object(obj, c) for obj, c in zip(answer.objects, sure, strict=True)],
        "solid": {**shape(answer), "along": _along(answer)},
        "facts": [_fact(solid, c) for solid, c in zip(answer.solids, sure, strict=True)],
    }


def rounded(points: Floats) -> list[list[float]]:
    """(n, 2) points, to a hundredth of a pixel."""
    return [[round(float(c), 2) for c in p] for p in points]


def _object(obj: TwoFaceObject, sure: float) -> dict[str, Any]:
    return {
        "f1": rounded(obj.f1),
        "f2": rounded(obj.f2),
        "holes": [{"f1": rounded(h.f1), "f2": rounded(h.f2)} for h in obj.holes],
        "arcs": curves(obj).get("arcs", []),
        "lines": obj.lines,
        "noise": round(float(obj.noise), 4),
        "f2_drawn": None if obj.f2_drawn is None else [bool(seen) for seen in obj.f2_drawn],
        "page": None if obj.page is None else obj.page.tolist(),
        "confidence": round(sure, 3),
    }


def _fact(solid: Solid, sure: float) -> dict[str, Any]:
    return {
        "shape": shape_name(solid),
        "projection": solid.projection.family,
        "size": [round(d, 4) for d in solid.dimensions],
        "volume": float(f"{abs(solid.volume):.6g}"),
        "unit": solid.unit,
        "free": free_size(solid.warnings),
        "readings": 1 + len(solid.alternatives),
        "confidence": round(sure, 3),
        "warnings": [w for w in solid.warnings if free_size([w]) is None],  # what is free is marked where it stands
    }


def _along(answer: Answer) -> Sequence[str]:
    """Which size of the first solid runs along each axis of the view: right, down and away."""
    axes = answer.solids[0].axes if answer.solids else None
    if axes is None:
        return SIZES
    turn = stand(answer.solids[0], answer.objects[0] if answer.objects else None).rotation
    return [SIZES[int(k)] for k in np.abs(turn @ axes.T).argmax(axis=1)]
