"""What was found in one picture, as plain data."""

from __future__ import annotations

from dataclasses import dataclass, field

from sketch2shape.errors import Sketch2ShapeError
from sketch2shape.model.arrays import Brief
from sketch2shape.model.drawing import TwoFaceObject
from sketch2shape.model.picture import Picture
from sketch2shape.model.solid import Solid

TRUSTED = 0.9
"""Confidence from which an answer need not be looked at: of those at least 99 in 100 are right."""


@dataclass(frozen=True, eq=False, repr=False)
class Answer(Brief):
    """The answer for one picture.

    objects    : the two-face objects found, best first
    solids     : one solid for each object, same order
    picture    : the picture it was read from
    timings_ms : time of each stage, milliseconds
    error      : why there are no objects, where `reconstruct_many` met a failure; `reconstruct` raises it instead
    """

    objects: tuple[TwoFaceObject, ...]
    solids: tuple[Solid, ...]
    picture: Picture
    timings_ms: dict[str, float] = field(default_factory=dict, repr=False)
    error: Sketch2ShapeError | None = None

    @property
    def confidences(self) -> tuple[float, ...]:
        """How sure each answer is as a whole: the lesser of the object's confidence and the solid's."""
        return tuple(
            min(float(obj.confidence), float(solid.confidence))
            for obj, solid in zip(self.objects, self.solids, strict=True)
        )
