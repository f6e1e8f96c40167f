"""The example drawings of the page, drawn on request by the generator of test drawings."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache


@dataclass(frozen=True)
class Example:
    """A drawing by its place in the generator: title for the page, category, seed, and the profile if it is chosen."""

    title: str
    category: str
    seed: int
    profile: str | None = None


EXAMPLES: dict[str, Example] = {
    "wireframe": Example("Wireframe", "clean_wire_oblique", 3),
    "isometric": Example("Isometric, hidden edges dashed", "clean_dashed_axono", 4, "L"),
    "perspective": Example("In perspective", "clean_wire_persp", 8),
    "hole": Example("With a hole", "holes_dashed", 3),
    "hand": Example("Drawn by hand", "hand_wire", 2),
    "pencil": Example("Pencil, hidden edges left out", "pencil_removed", 3),
    "photo": Example("Photo of a page", "photo_wire", 8),
    "blackboard": Example("On a blackboard", "blackboard_wire", 6),
}


@lru_cache(maxsize=len(EXAMPLES))
def example_png(name: str) -> bytes:
    """The example's picture as PNG bytes. Raises KeyError for a name that is not in EXAMPLES."""
    from sketch2shape.pictures.canvas import encode_png
    from sketch2shape.synthetic.drawing import draw

    example = EXAMPLES[name]
    return encode_png(draw(example.category, example.seed, 0, shapes=example.profile).pixels[..., :3])
