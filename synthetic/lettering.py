"""Words and letters that lie across the edges of the object."""

from __future__ import annotations

import cv2
import numpy as np

from sketch2shape.model import Floats
from synthetic.layers import Drawn, Layer, some_colour
from synthetic.marks import text
from synthetic.pens import Coverage

WORDS = (
    "front",
    "top",
    "side",
    "base",
    "A = 24",
    "V = ?",
    "Fig. 2",
    "right view",
    "wood",
    "6 kg",
    "h",
    "a",
    "x + 2",
    "S",
)


def written(
    words: str, at: Floats, height: float, size: tuple[int, int], rng: np.random.Generator, angle: float = 0.0
) -> Coverage:
    """Words centred on a point (x, y), `height` pixels high, turned by `angle` radians (clockwise on the sheet)."""
    font = str(rng.choice(["vector", "print", "print"]))
    flat = text(words, (float(at[0]), float(at[1])), height, size, font)
    if angle == 0.0:
        return flat
    turn = cv2.getRotationMatrix2D((float(at[0]), float(at[1])), -float(np.degrees(angle)), 1.0)
    return np.asarray(cv2.warpAffine(flat, turn, size, flags=cv2.INTER_LINEAR), np.float32)


def readable(direction: Floats) -> float:
    """Angle of a text line along a direction, never upside down."""
    angle = float(np.arctan2(direction[1], direction[0]))
    return (angle + np.pi / 2) % np.pi - np.pi / 2


def height_of(drawn: Drawn, rng: np.random.Generator) -> float:
    """Height of letters, pixels: of a size with what textbooks, teachers and programs write."""
    return max(float(rng.uniform(0.03, 0.065)) * drawn.diagonal, 9.0)


def words_across(drawn: Drawn, rng: np.random.Generator) -> list[Layer]:
    """Letters that touch their vertices, words across edges or large on a face; some with the line erased below."""
    colour, layers = some_colour(rng, 0.75), []
    if rng.random() < 0.6:
        layers.append(Layer(_touching_letters(drawn, rng), colour))
    for _ in range(int(rng.integers(1, 4)) if layers else int(rng.integers(2, 5))):
        edges = drawn.drawn_edges()
        a, b = edges[int(rng.integers(len(edges)))]
        p, q = drawn.points[a], drawn.points[b]
        at = p + rng.uniform(0.25, 0.75) * (q - p) + rng.uniform(-0.6, 0.6, 2) * height_of(drawn, rng)
        height = height_of(drawn, rng) * float(rng.choice([1.0, 1.0, 1.8]))
        angle = readable(q - p) if rng.random() < 0.35 else 0.0
        ink = written(str(rng.choice(WORDS)), at, height, drawn.size, rng, angle)
        if rng.random() < 0.2:
            layers.append(Layer(_halo(ink, height), drawn.ground))
        layers.append(Layer(ink, colour))
    return layers


def _touching_letters(drawn: Drawn, rng: np.random.Generator) -> Coverage:
    height, out = height_of(drawn, rng), np.zeros(drawn.size[::-1], np.float32)
    first = int(rng.integers(26))
    for i, p in enumerate(drawn.points):
        if rng.random() < 0.75:
            near = drawn.outward(p, rng, 1.2) * height * rng.uniform(0.2, 0.8)
            name = chr(ord("A") + (first + i) % 26) + str(rng.choice(["", "", "'", "1"]))
            out = np.maximum(out, written(name, p + near, height, drawn.size, rng))
    return out


def _halo(ink: Coverage, height: float) -> Coverage:
    """The surroundings of letters, as programs erase lines below them."""
    reach = max(round(height / 4), 2)
    return np.asarray(cv2.dilate((ink > 0.2).astype(np.float32), np.ones((2 * reach + 1,) * 2, np.uint8)), np.float32)
