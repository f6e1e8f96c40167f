"""The report on one picture, schema "sketch2shape/1": what was found, or why nothing was."""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np

from sketch2shape import __version__
from sketch2shape.errors import Sketch2ShapeError
from sketch2shape.model import Answer, Arc, Picture, Solid, TwoFaceObject
from sketch2shape.solids import is_pointed, shape_name

SCHEMA = "sketch2shape/1"
#: decimals of a pixel, and of a unit of length
_PIXEL_DECIMALS, _LENGTH_DECIMALS = 3, 6
#: points told of each arc of a solid, both ends included
_SAMPLES = 65


def report(
    answer: Answer | Sketch2ShapeError,
    *,
    source: str | None = None,
    size: tuple[int, int] | None = None,
    timings_ms: dict[str, float] | None = None,
) -> dict[str, Any]:
    """The report as plain data, ready for JSON.

    answer     : a result, or the error that stands for it
    source     : name of the picture; default: the one in the result
    size       : (width, height) in pixels, where the answer is an error and the picture was read all the same
    timings_ms : time of each stage; default: those of the result
    """
    if isinstance(answer, Answer):
        size = answer.picture.size if answer.picture.pixels.size else size
        source = answer.picture.source if source is None else source
        timings_ms = answer.timings_ms if timings_ms is None else timings_ms
    error = answer.error if isinstance(answer, Answer) else answer
    pairs = zip(answer.objects, answer.solids, strict=True) if isinstance(answer, Answer) else ()
    return {
        "schema": SCHEMA,
        "source": source or "",
        "width": size[0] if size else None,
        "height": size[1] if size else None,
        **(_own_coordinates(answer.picture) if isinstance(answer, Answer) else {}),
        "status": "ok" if error is None else "failed",
        "message": None if error is None else error.message,
        "objects": [_object(obj, solid) for obj, solid in pairs],
        "timings_ms": {k: round(v, 2) for k, v in (timings_ms or {}).items()},
        "version": __version__,
    }


def _own_coordinates(picture: Picture) -> dict[str, Any]:
    """How pixels become a vector drawing's own coordinates again, where they are not the same."""
    drawing = picture.drawing
    if drawing is None or (drawing.origin == (0.0, 0.0) and drawing.scale == 1.0):
        return {}
    return {"drawing": {"origin": list(drawing.origin), "scale": drawing.scale}}


def encode_report(data: dict[str, Any]) -> bytes:
    """UTF-8 JSON with a final newline; ASCII inside, so that any file name survives."""
    return (json.dumps(data, allow_nan=False) + "\n").encode("ascii")


def _object(obj: TwoFaceObject, solid: Solid) -> dict[str, Any]:
    described = {
        "f1": _points(obj.f1, _PIXEL_DECIMALS),
        "f2": _points(obj.f2, _PIXEL_DECIMALS),
        "holes": [{"f1": _points(h.f1, _PIXEL_DECIMALS), "f2": _points(h.f2, _PIXEL_DECIMALS)} for h in obj.holes],
        "edges": obj.edges.tolist(),
        **curves(obj),
        "shape": shape_name(solid),
        "projection": {"family": solid.projection.family, **plain(solid.projection.evidence)},
        "confidence": round(float(obj.confidence), 4),
        "solid": {
            "vertices": _points(solid.vertices, _LENGTH_DECIMALS),
            **({"arcs": _solid_arcs(solid)} if solid.boundary.is_round else {}),
            "unit": solid.unit,
            "dimensions": [round(d, _LENGTH_DECIMALS) for d in solid.dimensions],
            "surface": round(solid.area, _LENGTH_DECIMALS),
            "volume": round(solid.volume, _LENGTH_DECIMALS),
            "confidence": round(float(solid.confidence), 4),
            "camera": None if solid.camera is None else plain(solid.camera),
            "warnings": list(solid.warnings),
        },
        "alternatives": [
            {
                "reading": other.reading,
                "mirrored": other.mirrored,
                "projection": {"family": other.projection.family, **plain(other.projection.evidence)},
                "dimensions": [round(d, _LENGTH_DECIMALS) for d in other.dimensions],
                "probability": other.probability,
            }
            for other in solid.alternatives
        ],
        "lines": obj.lines,
        "connectors": {"f1": obj.connectors[0], "f2": obj.connectors[1]},
        "noise": round(float(obj.noise), 3),
    }
    if obj.f2_drawn is not None:
        described["f2_drawn"] = [bool(seen) for seen in obj.f2_drawn]
    if obj.page is not None:
        described["page"] = [[float(f"{c:.9g}") for c in row] for row in obj.page]
    return described


def curves(obj: TwoFaceObject) -> dict[str, Any]:
    """The curved edges as drawn, and the outlines of curved sides, by the report's words; nothing if there are none."""
    if not obj.is_round:
        return {}
    arcs = [
        {
            "face": arc.face,
            "hole": arc.hole,
            "from": arc.start,
            "to": arc.end,
            "ellipse": {
                "center": [round(float(c), _PIXEL_DECIMALS) for c in arc.ellipse.center],
                "axes": [round(float(a), _PIXEL_DECIMALS) for a in arc.ellipse.axes],
                "angle": round(float(arc.ellipse.angle), _PIXEL_DECIMALS),
            },
            "points": _points(arc.points, _PIXEL_DECIMALS),
        }
        for arc in obj.arcs
    ]
    return {"arcs": arcs, "silhouettes": [_points(ends, _PIXEL_DECIMALS) for ends in obj.silhouettes]}


def _solid_arcs(solid: Solid) -> list[dict[str, Any]]:
    """The arcs of the front face, then of the back face, ring by ring."""
    flat = solid.faces[:1] if is_pointed(solid) else solid.faces[:2]
    found: list[dict[str, Any]] = []
    for name, face in zip(("f1", "f2"), flat, strict=False):
        for ring, loop in enumerate(face.loops):
            numbers = sorted(number for number, _ in loop)
            first = min((solid.edges[e].start or 0 for e in numbers), default=0)
            for edge in (solid.edges[e] for e in numbers):
                arc = solid.boundary.arc(edge)
                if arc is not None:
                    ends = [None if end is None else end - first for end in (edge.start, edge.end)]
                    found.append({"face": name, "hole": ring - 1 if ring else None, **_solid_arc(arc, ends)})
    return found


def _solid_arc(arc: Arc, ends: list[int | None]) -> dict[str, Any]:
    whole = ends[0] is None
    return {
        "from": ends[0],
        "to": ends[1],
        "center": [round(float(c), _LENGTH_DECIMALS) + 0.0 for c in arc.circle.center],
        "normal": [round(float(c), 9) + 0.0 for c in arc.circle.normal],
        "radius": round(arc.circle.radius, _LENGTH_DECIMALS),
        "points": _points(arc.at(np.linspace(0.0, 1.0, _SAMPLES)[: -1 if whole else None]), _LENGTH_DECIMALS),
    }


def _points(points: Any, decimals: int) -> list[list[float]]:
    rounded = np.round(np.asarray(points, float), decimals) + 0.0  # no -0.0
    return [[float(x) for x in row] for row in rounded]


def plain(value: Any) -> Any:
    """NumPy values, tuples and dataclass-free nests as JSON types; a number that is not finite becomes None."""
    if isinstance(value, dict):
        return {str(k): plain(v) for k, v in value.items()}
    if isinstance(value, np.ndarray):
        return plain(value.tolist())
    if isinstance(value, list | tuple | set | frozenset):
        return [plain(v) for v in value]
    if isinstance(value, np.generic):
        return plain(value.item())
    if isinstance(value, float):
        return round(value, 9) if math.isfinite(value) else None
    return value if value is None or isinstance(value, bool | int | str) else str(value)
