"""What the app asks of its workers: plain data in, plain data out."""

from __future__ import annotations

from base64 import b64decode
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from sketch2shape.corrections import Corrections, corrected, corrections_from, points_from
from sketch2shape.errors import NoObjectError, UsageError
from sketch2shape.lifting import LiftOptions, lift
from sketch2shape.model import Answer, Ellipse, FacePair, Floats, Picture, TwoFaceObject
from sketch2shape.pictures.canvas import Pixels, encode_jpeg, encode_png, fit
from sketch2shape.pictures.stages import stage_panels
from sketch2shape.pictures.viewer import data_uri
from sketch2shape.ui.described import described, rounded
from sketch2shape.ui.fronts import faced

_SHOWN = 1600  # longest side of the picture sent back to the page, pixels
_MOST_CORNERS = 400  # that the page snaps to
_MOST_LEFT = 40  # strokes that are told to fit nothing
_MOST_SIDE = 40_000  # of a picture that corrections claim to belong to


def warm_up() -> None:
    """Load the libraries that the first picture would otherwise wait for."""
    from importlib import import_module

    from sketch2shape.batch.worker import PRELOAD

    for name in PRELOAD:
        import_module(name)


def reconstruct_picture(data: bytes, name: str, page: int = 0) -> dict[str, Any]:
    """Find the objects of an uploaded picture, of one page of it: all that the page shows of it."""
    from sketch2shape.reading.read import count_pages, read_picture
    from sketch2shape.strokes import detect_corners

    pages = count_pages(data)
    picture = read_picture(data, name=name, reduced=True, page=min(page, pages - 1))
    found, problem = _found(picture)
    return {
        **described(faced(found)),
        "name": name,
        "pages": pages,
        "width": picture.size[0],
        "height": picture.size[1],
        "picture": _shown(picture.pixels),
        "stages": _stages(found),
        "corners": rounded(detect_corners(picture).vertices[:_MOST_CORNERS]),
        "problem": problem,
    }


def reconstruct_sketch(data: Any) -> dict[str, Any]:
    """Find the objects of strokes that were drawn on the page (see docs/vectors.md), in the units of its sheet."""
    from sketch2shape.reading.pen_strokes import from_json

    picture = from_json({"strokes": data.get("strokes")}, "sketch")
    found, problem = _found(picture)
    objects = tuple(_on_sheet(obj, picture) for obj in found.objects)
    solids = tuple(replace(lift(obj), confidence=s.confidence) for obj, s in zip(objects, found.solids, strict=True))
    if problem and picture.drawing:
        origin, scale = np.array(picture.drawing.origin), picture.drawing.scale
        problem["left"] = [rounded(origin + np.array(ends) / scale) for ends in problem["left"]]
    return {**described(faced(Answer(objects, solids, picture))), "problem": problem}


def _found(picture: Picture) -> tuple[Answer, dict[str, Any] | None]:
    """The answer; or the best guess, why it is no more, and the strokes that it leaves out."""
    from sketch2shape.evidence import EVEN_ODDS, unexplained_strokes
    from sketch2shape.ink import find_ink
    from sketch2shape.pipeline import reconstruct

    try:
        answer = reconstruct(picture)
    except NoObjectError as error:
        guess = error.guess or Answer((), (), picture)
        told = error.message, error.advice
    else:
        sure = min(obj.confidence for obj in answer.objects)  # proportions may be vague: other readings are offered
        if sure >= EVEN_ODDS:  # others are likelier wrong than right, and shown as guesses
            return answer, None
        guess, told = answer, (f"no likely solid explains it (confidence {sure:.2f})", "to put its corners right")
    left = unexplained_strokes(find_ink(picture), guess.objects)[:_MOST_LEFT] if guess.objects else np.zeros((0, 2, 2))
    return guess, {"error": told[0], "advice": told[1], "left": [rounded(ends) for ends in left]}


def _on_sheet(obj: TwoFaceObject, picture: Picture) -> TwoFaceObject:
    """An object found in a picture of strokes, in the strokes' own coordinates."""
    if picture.drawing is None:
        return obj
    origin, scale = np.array(picture.drawing.origin), picture.drawing.scale

    def own(points: Floats) -> Floats:
        return np.asarray(origin + points / scale)

    holes = tuple(FacePair(own(h.f1), own(h.f2)) for h in obj.holes)
    arcs = tuple(replace(arc, points=own(arc.points), ellipse=_sized(arc.ellipse, own, scale)) for arc in obj.arcs)
    sides = own(obj.silhouettes)
    noise = obj.noise / scale
    return replace(obj, f1=own(obj.f1), f2=own(obj.f2), holes=holes, arcs=arcs, silhouettes=sides, noise=noise)


def _sized(ellipse: Ellipse, own: Callable[[Floats], Floats], scale: float) -> Ellipse:
    a, b = ellipse.axes
    return Ellipse(own(ellipse.center), (a / scale, b / scale), ellipse.angle)


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
    return described(_corrected(data, None))


def show_stages(picture: bytes, data: Any) -> dict[str, Any]:
    """The stages drawn again for faces that were put right by hand."""
    from sketch2shape.reading.read import read_picture

    return {"stages": _stages(_corrected(data, read_picture(picture)))}


def other_readings(data: Any, index: Any) -> list[dict[str, Any]]:
    """The solids that the object at this place of the corrections may be, the likeliest first, the present one too."""
    given, size = _corrections(data), _size(data)
    if type(index) is not int or not 0 <= index < len(given.objects):
        raise UsageError("there is no such object")
    present = given.objects[index]
    if present.shape is None:
        raise UsageError("the object has no faces yet")
    readings: list[dict[str, Any]] = []
    count = 1
    while len(readings) < count:
        number = len(readings) + 1
        options = replace(present, reading=number).options(LiftOptions())
        solid = lift(present.shape, picture_size=(size[1], size[0]), options=options)
        count = 1 + len(solid.alternatives)
        readings.append({"number": number, **_reading(Answer((present.shape,), (solid,), _blank(size)))})
    return readings


def _reading(answer: Answer) -> dict[str, Any]:
    solid, told = answer.solids[0], described(answer)
    name = solid.projection.evidence.get("reading", solid.projection.family)
    return {"name": str(name), "solid": told["solid"], "size": told["facts"][0]["size"], "unit": solid.unit}


def export_corrections(data: Any, form: str) -> bytes:
    """The bytes of a format or product of the solids; `data` may hold the picture that some of them show, base64."""
    from sketch2shape.pipeline.products import encode_product
    from sketch2shape.reading.read import read_picture

    sent = data.get("picture") if isinstance(data, dict) else None
    name = str(data.get("source") or "drawing")[:200] if isinstance(data, dict) else ""
    picture = None if sent is None else read_picture(picture_bytes(sent), name=name)
    return encode_product(form, _corrected(data, picture), {})


def picture_bytes(sent: Any) -> bytes:
    """A picture that travels inside JSON. Raises UsageError."""
    try:
        return b64decode(sent, validate=True)
    except (TypeError, ValueError) as error:
        raise UsageError("the request holds no picture") from error


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
    return {"f1": rounded(f1), "f2": rounded(f2)}


def _corrections(data: Any) -> Corrections:
    corrections = corrections_from(data)
    if corrections is None or not corrections.objects:
        raise UsageError("there is no object yet", remedy="tracing its front face")
    return corrections


def _corrected(data: Any, picture: Picture | None) -> Answer:
    """The result of corrections sent by the page, for a blank picture of the size they tell if none is given."""
    corrections = _corrections(data)
    answer = corrected(picture or _blank(_size(data)), corrections)
    return _in_one_scale(answer, corrections)


def _in_one_scale(answer: Answer, corrections: Corrections) -> Answer:
    """Objects of one sheet that were given no size have the scale of the first one that was."""
    sized = [k for k, o in enumerate(corrections.objects) if o.sizes]
    if not sized or len(sized) == len(answer.solids):
        return answer
    first = sized[0]
    unit = answer.solids[first].unit
    bare = lift(answer.objects[first], options=replace(corrections.objects[first], sizes={}).options(LiftOptions()))
    scale = float(np.median(np.array(answer.solids[first].dimensions) / np.maximum(bare.dimensions, 1e-9)))
    solids = list(answer.solids)
    for k, (obj, given) in enumerate(zip(answer.objects, corrections.objects, strict=True)):
        if not given.sizes:
            width = solids[k].dimensions[0] * scale
            solids[k] = lift(obj, options=replace(given, sizes={"width": f"{width:.9g}{unit}"}).options(LiftOptions()))
    return Answer(answer.objects, tuple(solids), answer.picture)


def _blank(size: tuple[int, int]) -> Picture:
    return Picture(np.broadcast_to(np.uint8(255), (*size, 3)))


def _size(data: Any) -> tuple[int, int]:
    """Height and width of the picture that the corrections belong to."""
    size = [data.get(k) for k in ("height", "width")]
    if not all(type(s) is int and 0 < s <= _MOST_SIDE for s in size):
        raise UsageError("the corrections do not tell the picture's width and height")
    return size[0], size[1]


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
