"""What a reconstruction returns: the objects of a picture, their solids, and how to get them out."""

from __future__ import annotations

from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING

from sketch2shape.model import Answer

if TYPE_CHECKING:
    from trimesh import Trimesh


@dataclass(frozen=True)
class Result(Answer):
    """An `Answer` that can be shown and written."""

    @property
    def mesh(self) -> Trimesh:
        """All solids as one `trimesh.Trimesh`, a body for each; vertices in the solids' order."""
        from sketch2shape.export import to_trimesh

        return to_trimesh(self.solids)

    def export(self, path: str | PathLike[str], format: str | None = None, *, ngons: bool = False) -> Path:
        """Write the solids to a file, all or nothing, and return its path.

        format : a key of `sketch2shape.export.FORMATS`; None takes it from the extension
        ngons  : in OBJ, write whole polygons as faces instead of triangles

        Raises UsageError for an unknown format, WriteError if the file cannot be written.
        """
        from sketch2shape.export import encode, format_of
        from sketch2shape.writing import write_file

        target = Path(path)
        write_file(target, encode(self, format or format_of(target), ngons=ngons), overwrite=True)
        return target

    def _repr_html_(self) -> str:
        """Show the turning solid in a notebook."""
        from sketch2shape.pictures.notebook import notebook_html

        return notebook_html(self)

    def _repr_png_(self) -> bytes:
        """Show the object drawn over its picture where a notebook shows no HTML."""
        from sketch2shape.pictures.notebook import notebook_png

        return notebook_png(self)
