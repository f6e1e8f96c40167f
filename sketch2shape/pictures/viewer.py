"""A 3-D viewer in one HTML file: it holds its own renderer and data, and needs no network."""

from __future__ import annotations

import json
from base64 import b64encode
from functools import cache
from html import escape
from importlib.resources import files
from string import Template
from typing import Any

import numpy as np

from sketch2shape.model import Answer
from sketch2shape.pictures.canvas import encode_png, fit, shown
from sketch2shape.pictures.facets import PITCH, YAW, stand, surface
from sketch2shape.pictures.overlay import overlay
from sketch2shape.solids import shape_name


def viewer(result: Answer, title: str | None = None) -> str:
    """An HTML page that turns the result's solids in 3-D beside the drawing; the same input gives the same text."""
    return _template("viewer.html").substitute(
        title=escape(shown(title or result.picture.source)),
        picture=data_uri(encode_png(_thumb(result))),
        facts="".join(f"<dt>{escape(k)}</dt><dd>{escape(v)}</dd>" for k, v in facts(result)),
        script=renderer(),
        shape=shape_json(result),
    )


def facts(result: Answer) -> list[tuple[str, str]]:
    """What to say about a result in words: (name, value) pairs, one group for each object."""
    rows: list[tuple[str, str]] = []
    for obj, solid in zip(result.objects, result.solids, strict=True):
        size = np.ptp(solid.boundary.extremes(np.eye(3)), axis=0)
        rows += [
            ("Shape", shape_name(solid)),
            ("Vertices", str(len(solid.vertices))),
            ("Edges", str(len(solid.edges))),
            ("Faces", str(len(solid.faces))),
            ("Size", " × ".join(f"{s:.4g}" for s in size) + f" {solid.unit}"),
            ("Projection", solid.projection.family),
            ("Confidence", f"{min(obj.confidence, solid.confidence):.2f}"),
        ]
        rows += [("Assumed", warning) for warning in solid.warnings]
    return rows or [("Status", "no two-face object found")]


def shape(result: Answer) -> dict[str, Any]:
    """What the renderer in the page needs, ready for JSON."""
    drawing = result.objects[0] if result.objects else None
    up = stand(result.solids[0], drawing) if result.solids else None
    form = surface(result.solids, None if up is None else up.rotation)
    return {
        "vertices": [[round(float(c), 4) for c in v] for v in form.vertices],
        "triangles": form.triangles.tolist(),
        "edges": form.edges.tolist(),
        **({"contours": form.contours.tolist()} if len(form.contours) else {}),
        "view": (YAW, PITCH) if up is None else up.view,
    }


def shape_json(result: Answer) -> str:
    """`shape` as text that is safe inside a script element."""
    return json.dumps(shape(result), separators=(",", ":")).replace("<", "\\u003c")


def data_uri(data: bytes, kind: str = "png") -> str:
    """The bytes of a PNG, or of another kind of picture, as an address that holds the picture itself."""
    return f"data:image/{kind};base64," + b64encode(data).decode("ascii")


@cache
def renderer() -> str:
    """The JavaScript of the renderer, class SolidView."""
    return files("sketch2shape.pictures").joinpath("viewer.js").read_text("utf-8")


@cache
def _template(name: str) -> Template:
    return Template(files("sketch2shape.pictures").joinpath(name).read_text("utf-8"))


def _thumb(result: Answer) -> Any:
    pixels = overlay(result)
    return fit(pixels, 900, 900)[0] if max(pixels.shape) > 900 else pixels
