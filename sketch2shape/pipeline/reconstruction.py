"""The pipeline: read -> ink -> strokes -> corners -> faces -> verified object -> solid."""

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from sketch2shape.connectors import check_connector, connector_of
from sketch2shape.errors import NoObjectError, UsageError
from sketch2shape.evidence import REFUSE_BELOW, unexplained_strokes, vouched
from sketch2shape.model import Answer, Floats, Ink, Picture, TwoFaceObject, checked_number
from sketch2shape.pipeline.options import corrections_of, explained, lift_options_of, limits_of
from sketch2shape.pipeline.result import Result
from sketch2shape.pipeline.solid import Solid
from sketch2shape.pipeline.solid import lift as lift_solid
from sketch2shape.search import AnyFound, FoundSweep, Verified, as_object, find_closely, sweep_as_object
from sketch2shape.strokes import detector_named

if TYPE_CHECKING:
    from sketch2shape.corrections import Corrections
    from sketch2shape.lifting import LiftOptions
    from sketch2shape.reading.limits import Limits


@explained
def reconstruct(
    source: Any = None,
    *,
    strokes: Iterable[ArrayLike] | None = None,
    connector: str = "auto",
    detector: str = "auto",
    limits: Limits | Mapping[str, Any] | None = None,
    lift: LiftOptions | Mapping[str, Any] | None = None,
    corrections: Corrections | Mapping[str, Any] | None = None,
    min_confidence: float = 0.0,
) -> Result:
    """The solid shown in a drawing.

    source      : path, bytes, open file, PIL image, array or `Picture`, see `read_picture`
    strokes     : in place of a source, what a pen drew: arrays (n, 2), x to the right, y down, in any order and unit
    connector   : orders the vertices of each face where the ink agrees: "auto", a method of `connect`, or "ink"
    detector    : "shi-tomasi" ("goodFeaturesToTrack"), "harris" or "both" have to see the vertices found, or
                  confidence falls; "auto" asks neither
    limits      : what is refused before decoding
    lift        : how to read the third dimension: `LiftOptions`, or its fields by name
    corrections : what a person put right by hand, or the JSON of their file; complete ones replace the reading
    min_confidence : objects that are less sure are left out, 0..1

    Raises UsageError for an unknown option, connector or detector, UnreadableError, LimitError, or NoObjectError if no
    two-face object is found with enough confidence; its `guess` is the best answer there was.
    """
    from sketch2shape.corrections import corrected, lift_options
    from sketch2shape.ink import find_ink
    from sketch2shape.lifting import choose_front
    from sketch2shape.reading.pen_strokes import from_strokes
    from sketch2shape.reading.read import read_picture

    if (source is None) == (strokes is None):
        raise UsageError("a source or strokes, one of them", remedy="reconstruct('drawing.png') or strokes=[...]")
    check_connector(connector)
    if detector != "auto":
        detector = detector_named(detector)
    min_confidence = checked_number("min_confidence", min_confidence, 0.0, 1.0)
    timings: dict[str, float] = {}
    options, corrections, limits = lift_options_of(lift), corrections_of(corrections), limits_of(limits)
    with _timed(timings, "read"):
        picture = read_picture(source, limits, reduced=True) if strokes is None else from_strokes(strokes)
    if corrections is not None and corrections.complete:
        given = corrected(picture, corrections, options)
        return Result(given.objects, tuple(map(Solid.of, given.solids)), given.picture)
    with _timed(timings, "ink"):
        ink = find_ink(picture)
    with _timed(timings, "faces"):
        found, ink = find_closely(ink)
        objects = tuple(choose_front(_as_object(f, ink, connector, detector)) for f in found)
    sure = tuple(o for o in objects if o.confidence >= REFUSE_BELOW)
    if not sure:
        raise _why_not(objects, ink, picture)
    with _timed(timings, "lift"):
        solids = tuple(
            lift_solid(o, picture_size=picture.size, options=lift_options(corrections, k, options))
            for k, o in enumerate(sure)
        )
    return _sure_enough(Result(sure, solids, picture, timings), min_confidence)


def _sure_enough(result: Result, min_confidence: float) -> Result:
    """The result without objects, or solids, that are less sure. Raises NoObjectError if none is left."""
    kept = [k for k, confidence in enumerate(result.confidences) if confidence >= min_confidence]
    if not kept:
        best = max(result.confidences)
        error = NoObjectError(
            f"the best two-face object has confidence {best:.2f}, {min_confidence:g} was asked for",
            remedy="put it right by hand with sketch2shape ui, or a lower --min-confidence",
        )
        error.guess = Answer(result.objects, result.solids, result.picture, error=error)
        raise error
    objects, solids = tuple(result.objects[k] for k in kept), tuple(result.solids[k] for k in kept)
    return replace(result, objects=objects, solids=solids)


@contextmanager
def _timed(timings: dict[str, float], stage: str) -> Iterator[None]:
    begin = time.perf_counter()
    yield
    timings[stage] = (time.perf_counter() - begin) * 1000


def _as_object(found: AnyFound, ink: Ink, connector: str, detector: str) -> TwoFaceObject:
    """In picture pixels, with the connector that gives each face the order that the ink shows."""
    if isinstance(found, FoundSweep):
        return sweep_as_object(found, ink)
    obj = as_object(found.rings, found.evidence, ink)
    return replace(
        obj,
        confidence=_confidence(found, ink, detector),
        connectors=(connector_of(obj.f1, connector), connector_of(obj.f2, connector)),
        noise=found.noise / ink.scale,
    )


def _confidence(found: Verified, ink: Ink, detector: str) -> float:
    """How sure the object is, less if a corner detector that was asked for does not see its vertices."""
    if detector == "auto":
        return found.confidence
    back = np.concatenate(found.rings.back)[found.evidence.drawn]
    drawn = np.concatenate([*found.rings.front, back])
    return found.confidence * vouched(ink, drawn, detector, found.noise)


def _why_not(objects: tuple[TwoFaceObject, ...], ink: Ink, picture: Picture) -> NoObjectError:
    """The error that says what is missing, with the best guess there was."""
    if not ink.mask.any():
        return NoObjectError("the picture is blank: no ink was found")
    if not objects:
        return NoObjectError("no two faces joined by connecting edges were found")
    best = max(o.confidence for o in objects)
    left_out = unexplained_strokes(ink, objects)
    which = f"; not explained: {_stroke(left_out[0])}" if len(left_out) else ""
    more = f" and {len(left_out) - 1} more" if len(left_out) > 1 else ""
    what = "the best two-face object explains the drawing too badly"
    error = NoObjectError(f"{what} (confidence {best:.2f}{which}{more})")
    error.guess = Answer(objects, tuple(map(lift_solid, objects)), picture, error=error)
    return error


def _stroke(ends: Floats) -> str:
    (x1, y1), (x2, y2) = ends.tolist()
    return f"the stroke from ({x1:.0f}, {y1:.0f}) to ({x2:.0f}, {y2:.0f})"
