"""What a reconstruction returns: the objects of a picture, their solids, and how to get them out."""

from __future__ import annotations

from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING

from sketch2shape.model import Answer
from sketch2shape.pipeline.solid import Solid

if TYPE_CHECKING:
    from trimesh import Trimesh

    from sketch2shape.export import Angle, PaperName


@dataclass(frozen=True, eq=False, repr=False)
class Result(Answer):
    """An `Answer` that can be shown and written; its solids can be, too."""

    solids: tuple[Solid, ...]

    def __post_init__(self) -> None:
        """Take plain solids as well."""
        object.__setattr__(self, "solids", tuple(map(Solid.of, self.solids)))

    @property
    def mesh(self) -> Trimesh:
        """All solids as one `trimesh.Trimesh`, a body for each; vertices in the solids' order."""
        from sketch2shape.export import to_trimesh

        return to_trimesh(self.solids)

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
        """Write the solids, the report or a picture to a file, all or nothing, and return its path.

        format : a key of `sketch2shape.export.FORMATS`, or "json" (the report), "overlay", "stages", "preview" (PNG),
                 "html"; None takes it from the name: "a.stl", "a.json", "a.overlay.png"
        ngons  : in OBJ, write whole polygons as faces instead of triangles
        tolerance : in meshes, the largest distance of a facet from a curved side, as "0.1mm" or a number in the solid's
                 unit; None for one that looks smooth
        paper  : of nets and other plans, "a4" or "letter"
        angle  : of views, "third" or "first"

        Raises UsageError for an unknown format, WriteError if the file cannot be written.
        """
        from sketch2shape.pipeline.products import encode_product, product_of
        from sketch2shape.writing import write_file

        target = Path(path)
        options = {"ngons": ngons, "tolerance": tolerance, "paper": paper, "angle": angle}
        data = encode_product(format or product_of(str(target)), self, options)
        write_file(target, data, overwrite=True)
        return target

    def _repr_html_(self) -> str:
        """Show the turning solid in a notebook."""
        from sketch2shape.pictures.notebook import notebook_html

        return notebook_html(self)

    def _repr_png_(self) -> bytes:
        """Show the object drawn over its picture where a notebook shows no HTML."""
        from sketch2shape.pictures.notebook import notebook_png

        return notebook_png(self)
