"""The example drawings of the page: small files beside this module, drawn by `scripts/make_examples.py`."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from importlib.resources import files


@dataclass(frozen=True)
class Example:
    """A drawing by its title for the page."""

    title: str


EXAMPLES: dict[str, Example] = {
    "wireframe": Example("Wireframe"),
    "isometric": Example("Isometric, hidden edges dashed"),
    "perspective": Example("In perspective"),
    "hole": Example("With a hole"),
    "hand": Example("Drawn by hand"),
    "pencil": Example("Pencil, hidden edges left out"),
    "photo": Example("Photo of a page"),
    "blackboard": Example("On a blackboard"),
    "cylinder": Example("Cylinder"),
    "ring": Example("Ring"),
    "channel": Example("Channel with a round floor"),
    "holes": Example("Round end, two holes"),
    "cone": Example("Cone"),
    "pyramid": Example("Pyramid"),
}


@lru_cache(maxsize=len(EXAMPLES))
def example_png(name: str) -> bytes:
    """The example's picture as PNG bytes. Raises KeyError for a name that is not in EXAMPLES."""
    if name not in EXAMPLES:
        raise KeyError(name)
    return files("sketch2shape.ui").joinpath("drawings", f"{name}.png").read_bytes()
