"""The solid, with what can be done with it.

The model holds plain data and knows nothing of files; what comes out of the pipeline can be exported. Both are a
`Solid`: this one is the other with methods, so whatever takes plain data takes it too.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sketch2shape import model
from sketch2shape.errors import UsageError
from sketch2shape.lifting import LiftOptions
from sketch2shape.lifting import lift as lift_object
from sketch2shape.model import TwoFaceObject, checked_count
from sketch2shape.pipeline.options import lift_options_of, tolerance_of

if TYPE_CHECKING:
    from collections.abc import Mapping

    from trimesh import Trimesh

    from sketch2shape.export import Angle, PaperName


@dataclass(frozen=True, eq=False, repr=False)
class Solid(model.Solid):
    """A `sketch2shape.model.Solid` that can be meshed and written."""

    @classmethod
    def of(cls, plain: model.Solid) -> Solid:
        """The same solid with these methods."""
        if isinstance(plain, cls):
            return plain
        return cls(**{field.name: getattr(plain, field.name) for field in fields(plain) if field.init})

    @property
    def mesh(self) -> Trimesh:
        """A watertight `trimesh.Trimesh` with the solid's vertices, in their order."""
        from sketch2shape.export import to_trimesh

        return to_trimesh(self)

    def export(
        self,
        path: str | PathLike[str],
        format: str | None = None,
        *,
        ngons: bool = False,
        tolerance: str | float | None = None,
        paper: PaperName = "a4",
        angle: Angle = "third",
    ) -> Path:
        """Write the solid to a file, all or nothing, and return its path.

        format : a key of `sketch2shape.export.FORMATS` but for the drawings "svg" and "dxf"; None takes it from the
                 extension
        ngons  : in OBJ, write whole polygons as faces instead of triangles
        tolerance : in meshes, the largest distance of a facet from a curved side, as "0.1mm" or a number in the solid's
                 unit; None for one that looks smooth
        paper  : of nets and other plans, "a4" or "letter"
        angle  : of views, "third" or "first"

        Raises UsageError for an unknown format, WriteError if the file cannot be written.
        """
        from sketch2shape.export import encode, format_of
        from sketch2shape.writing import write_file

        target = Path(path)
        chord = tolerance_of(tolerance, self.unit)
        form = format or format_of(target)
        data = encode(self, form, ngons=ngons, tolerance=chord, paper=paper, angle=angle)
        write_file(target, data, overwrite=True)
        return target


def lift(
    obj: TwoFaceObject,
    *,
    picture_size: tuple[int, int] | None = None,
    options: LiftOptions | Mapping[str, Any] | None = None,
) -> Solid:
    """The solid that a two-face object is a drawing of; see `sketch2shape.lifting.lift`.

    obj          : the object in the picture's plane, f1 the front face; its rings may be lists, or OpenCV's (n, 1, 2)
    picture_size : width and height of the picture, pixels
    options      : what the user fixes: `LiftOptions`, or its fields by name

    What the drawing leaves free is set to a default that `Solid.warnings` states. Raises PointsError for rings that are
    no points or do not match, UsageError for options that make no sense.
    """
    if not isinstance(obj, TwoFaceObject):
        raise UsageError(f"lift takes a TwoFaceObject, not {type(obj).__name__}", remedy="TwoFaceObject(f1, f2)")
    size = None if picture_size is None else _size(picture_size)
    return Solid.of(lift_object(obj, picture_size=size, options=lift_options_of(options)))


def _size(given: Any) -> tuple[int, int]:
    """Width and height. Raises UsageError."""
    try:
        width, height = given
    except (TypeError, ValueError):
        raise UsageError(f"picture_size is {given!r}", remedy="picture_size=(width, height)") from None
    return checked_count("picture_size", width), checked_count("picture_size", height)
