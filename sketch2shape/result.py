"""What a reconstruction returns: the objects of a picture, their solids, and how to get them out."""

from __future__ import annotations

from dataclasses import dataclass, field

from sketch2shape.model import Picture, Solid, TwoFaceObject


@dataclass(frozen=True)
class Result:
    """The answer for one picture.

    objects    : the two-face objects found, best first
    solids     : one solid for each object, same order
    picture    : the picture it was read from
    timings_ms : time of each stage, milliseconds
    """

    objects: tuple[TwoFaceObject, ...]
    solids: tuple[Solid, ...]
    picture: Picture
    timings_ms: dict[str, float] = field(default_factory=dict)
