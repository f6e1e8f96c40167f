"""What was found in a picture, in a line of words."""

from __future__ import annotations

import numpy as np

from sketch2shape.model import Answer, Solid

#: objects of a sheet that are described one by one
_MOST = 4
#: sides and right angles of a box are exact to this part of its size
_EXACT = 1e-3


def least_confidence(answer: Answer) -> float:
    """Confidence of the object that is least sure."""
    return min(answer.confidences)


def describe(answer: Answer) -> str:
    """What the objects are, how large, how sure, and what had to be assumed.

    As in "box, 40 x 40 x 51 mm, confidence 0.99; the drawing leaves the depth free: 51 mm is assumed".
    """
    solids = answer.solids[:_MOST]
    words = [f"{kind_of(solid)}, {size_of(solid)}" for solid in solids]
    if len(answer.solids) > _MOST:
        words.append(f"{len(answer.solids) - _MOST} more")
    count = f"{len(answer.solids)} objects: " if len(answer.solids) > 1 else ""
    assumed = list(dict.fromkeys(warning for solid in answer.solids for warning in solid.warnings))
    return "; ".join([f"{count}{', '.join(words)}, confidence {least_confidence(answer):.2f}", *assumed])


def kind_of(solid: Solid) -> str:
    """A box, or how many sides a prism or a tapered object has, and its holes."""
    n, half = solid.ring_sizes[0], sum(solid.ring_sizes)
    front, back = solid.vertices[:n], solid.vertices[half : half + n]
    joins = back - front
    size = float(np.linalg.norm(np.ptp(solid.vertices, axis=0)))
    straight = bool(np.ptp(joins, axis=0).max() <= _EXACT * size)
    holes = len(solid.ring_sizes) - 1
    if straight and not holes and n == 4 and _is_square(np.array([front[1] - front[0], front[3] - front[0], joins[0]])):
        return "box"
    kind = "prism" if straight else "tapered object"
    return f"{kind} with {n} sides" + (f" and {holes} hole{'s' * (holes > 1)}" if holes else "")


def _is_square(edges: np.ndarray) -> bool:
    """Whether three edges (3, 3) stand at right angles."""
    unit = edges / np.maximum(np.linalg.norm(edges, axis=1, keepdims=True), 1e-300)
    return bool(np.abs(unit @ unit.T - np.eye(3)).max() <= _EXACT)


def size_of(solid: Solid) -> str:
    """As in "40 x 40 x 51.5 mm": width, height and depth along the object's own axes."""
    return " x ".join(f"{extent:.4g}" for extent in solid.dimensions) + f" {solid.unit}"
