"""Draw the examples of the page, sketch2shape/ui/drawings/NAME.png, again: `python scripts/make_examples.py`."""

from __future__ import annotations

from dataclasses import dataclass

from PIL import Image
from repository import ROOT

from synthetic.drawing import draw

TARGET = ROOT / "sketch2shape" / "ui" / "drawings"
LARGEST = (640, 480)
"""Pixels; larger drawings are reduced, as every example is part of what users install."""
COLOURS = 64
"""Of the palette: all the colours of a photo's noise swell a PNG."""


@dataclass(frozen=True)
class Source:
    """An example by its place in the generator: category, seed, and the profile where it is chosen."""

    category: str
    seed: int
    profile: str | None = None


SOURCES = {
    "wireframe": Source("clean_wire_oblique", 3),
    "isometric": Source("clean_dashed_axono", 4, "L"),
    "perspective": Source("clean_wire_persp", 8),
    "hole": Source("holes_dashed", 3),
    "hand": Source("hand_wire", 2),
    "pencil": Source("pencil_removed", 3),
    "photo": Source("photo_wire", 8),
    "blackboard": Source("blackboard_wire", 6),
    "cylinder": Source("cylinder_dashed", 3),
    "ring": Source("tube_removed", 8),
    "channel": Source("arcs_removed", 8),
    "holes": Source("plate_dashed", 8),
    "cone": Source("cone_dashed", 4),
    "pyramid": Source("pyramid_dashed", 6),
}


def main() -> None:
    TARGET.mkdir(parents=True, exist_ok=True)
    for name, source in SOURCES.items():
        drawing = draw(source.category, source.seed, 0, shapes=source.profile)
        picture = Image.fromarray(drawing.pixels[..., :3])
        picture.thumbnail(LARGEST, Image.Resampling.LANCZOS)
        few = picture.quantize(COLOURS, dither=Image.Dither.NONE)
        few.save(TARGET / f"{name}.png", optimize=True)


if __name__ == "__main__":
    main()
