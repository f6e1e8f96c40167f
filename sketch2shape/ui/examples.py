"""The example drawings of the page, drawn on request by the generator of test drawings."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache


@dataclass(frozen=True)
class Example:
    """A drawing by its place in the generator: title for the page, category, seed and index."""

    title: str
    category: str
    seed: int
    index: int


EXAMPLES: dict[str, Example] = {
    "wireframe": Example("Wireframe", "clean_wire_oblique", 5, 0),
    "isometric": Example("Isometric, hidden edges dashed", "clean_dashed_axono", 5, 1),
    "hole": Example("With a hole", "holes_wire", 5, 0),
    "hand": Example("Drawn by hand", "hand_wire", 5, 0),
    "pencil": Example("Pencil, hidden edges left out", "pencil_removed", 5, 0),
    "photo": Example("Photo of a page", "photo_wire", 5, 0),
}


@lru_cache(maxsize=len(EXAMPLES))
def example_png(name: str) -> bytes:
    """The example's picture as PNG bytes. Raises KeyError for a name that is not in EXAMPLES."""
    from sketch2shape.pictures.canvas import encode_png
    from sketch2shape.synthetic.drawing import draw

    example = EXAMPLES[name]
    return encode_png(draw(example.category, example.seed, example.index).pixels[..., :3])
