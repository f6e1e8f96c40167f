"""What the app asks of its workers: plain data in, plain data out."""

from __future__ import annotations

from typing import Any

import numpy as np

from sketch2shape.corrections import corrected, corrections_from, points_from
from sketch2shape.errors import NoObjectError, UsageError
from sketch2shape.model import Answer, Floats, Picture
from sketch2shape.pictures.canvas import Pixels, encode_jpeg, encode_png, fit
from sketch2shape.pictures.stages import stage_panels
from sketch2shape.pictures.viewer import data_uri, shape

_SHOWN = 1600  # longest side of the picture sent back to the page, pixels
_MOST_CORNERS = 400  # that the page snaps to
_MOST_SIDE = 40_000  # of a picture that corrections claim to belong to


def warm_up() -> None:
    """Load the libraries that the first picture would otherwise wait for."""
    from importlib import import_module

    from sketch2shape.batch.worker import PRELOAD

    for name in PRELOAD:
        import_module(name)


def reconstruct_picture(data: bytes, name: str) -> dict[str, Any]:
    """Find the objects of an uploaded picture: all that the page shows of it."""
    from sketch2shape.pipeline import reconstruct
    from sketch2shape.reading.read import read_picture
    from sketch2shape.strokes import detect_corners

    picture = read_picture(data, name=name, reduced=True)
    found: Answer
    try:
        found = reconstruct(picture)
        problem = None
    except NoObjectError as error:
        found = Answer((), (), picture)
        problem = {"error": error.message, "advice": error.advice}
    return {
        **_described(found),
        "name": name,
        "width": picture.size[0],
        "height": picture.size[1],
        "picture": _shown(picture.pixels),
        "stages": _stages(found),
        "corners": _rounded(detect_corners(picture).vertices[:_MOST_CORNERS]),
        "problem": problem,
    }


def make_product(data: bytes, product: str, options: dict[str, Any]) -> bytes:
    """The bytes of a product (a mesh format, "json", ...) of an uploaded picture; options as for `reconstruct`."""
    from sketch2shape.pipeline import reconstruct
    from sketch2shape.pipeline.products import encode_product
    from sketch2shape.reading.read import read_picture

    try:
        return encode_product(product, reconstruct(read_picture(data, name="upload", reduced=True), **options), {})
    except NoObjectError as error:
        error.guess = None  # whose picture would travel with it
        raise


def lift_corrections(data: Any) -> dict[str, Any]:
    """The solids of faces that were put right by hand."""
    return _described(_corrected(data, None))


def show_stages(picture: bytes, data: Any) -> dict[str, Any]:
    """The stages drawn again for faces that were put right by hand."""
    from sketch2shape.reading.read import read_picture

    return {"stages": _stages(_corrected(data, read_picture(picture)))}


def export_corrections(data: Any, form: str) -> bytes:
    """A mesh file of the solids."""
    from sketch2shape.export import encode

    return encode(_corrected(data, None), form)


def connect_loose(front: Any, back: Any) -> dict[str, Any]:
    """Vertices told to be of the front and of the back face, in ring order and paired.

    The connector orders the front; each back vertex goes to the front vertex it lies best behind, in all with the least
    squares after the faces' centres are laid on each other (the assignment problem).
    """
    from scipy.optimize import linear_sum_assignment

    from sketch2shape.connectors import connect

    f1, f2 = points_from(front, "the front face"), points_from(back, "the back face")
    if len(f1) != len(f2):
        raise UsageError(f"the front face has {len(f1)} vertices, the back face {len(f2)}")
    f1 = f1[connect(f1)]
    gaps = (f1 - f1.mean(axis=0))[:, None] - (f2 - f2.mean(axis=0))[None]
    f2 = f2[linear_sum_assignment((gaps**2).sum(axis=2))[1]]
    return {"f1": _rounded(f1), "f2": _rounded(f2)}


def _corrected(data: Any, picture: Picture | None) -> Answer:
    """The result of corrections sent by the page, for a blank picture of the size they tell if none is given."""
    corrections = corrections_from(data)
    if corrections is None or not corrections.objects:
        raise UsageError("there is no object yet", remedy="tracing its front face")
    if picture is None:
        picture = Picture(np.broadcast_to(np.uint8(255), (*_size(data), 3)))
    return corrected(picture, corrections)


def _size(data: Any) -> tuple[int, int]:
    """Height and width of the picture that the corrections belong to."""
    size = [data.get(k) for k in ("height", "width")]
    if not all(type(s) is int and 0 < s <= _MOST_SIDE for s in size):
        raise UsageError("the corrections do not tell the picture's width and height")
    return size[0], size[1]


def _described(result: Answer) -> dict[str, Any]:
    """The objects and solids, as the page keeps them."""
    return {
        "objects": [
            {
                "f1": _rounded(obj.f1),
                "f2": _rounded(obj.f2),
                "holes": [{"f1": _rounded(h.f1), "f2": _rounded(h.f2)} for h in obj.holes],
                "confidence": round(sure, 3),
            }
            for obj, sure in zip(result.objects, result.confidences, strict=True)
        ],
        "solid": shape(result),
        "facts": [
            {
                "projection": solid.projection.family,
                "size": [round(d, 4) for d in solid.dimensions],
                "volume": float(f"{abs(solid.volume):.6g}"),
                "unit": solid.unit,
                "warnings": list(solid.warnings),
            }
            for solid in result.solids
        ],
    }


def _rounded(points: Floats) -> list[list[float]]:
    return [[round(float(c), 2) for c in p] for p in points]


def _stages(result: Answer) -> list[dict[str, str]]:
    return [
        {"title": s.title, "sentence": s.sentence, "picture": data_uri(encode_png(s.pixels))}
        for s in stage_panels(result)
    ]


def _shown(pixels: Pixels) -> str:
    """The picture as an address for the page, reduced to a size worth sending."""
    h, w = pixels.shape[:2]
    small = fit(pixels, min(w, _SHOWN), min(h, _SHOWN))[0] if max(h, w) > _SHOWN else pixels
    return data_uri(encode_jpeg(small), "jpeg")
