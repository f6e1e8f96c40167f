"""An object as it stands on its sheet, and the layers of ink that nuisances add to it."""

from __future__ import annotations

from dataclasses import dataclass, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from sketch2shape.model import Floats
from synthetic.hand import Hand, Stroke, freehand
from synthetic.pens import Coverage, Pen, coverage
from synthetic.scenes import Scene
from synthetic.visibility import faces_of

RGB = tuple[int, int, int]


@dataclass(frozen=True)
class Drawn:
    """An object on its sheet.

    scene  : the object
    points : (2m, 2) where the hand put the vertices, pixels
    lines  : "wire", "dashed", "removed"
    size   : (w, h) of the sheet, pixels
    pen    : the pen it is drawn with
    hand   : the hand that draws it
    ground : RGB of the paper
    """

    scene: Scene
    points: Floats
    lines: str
    size: tuple[int, int]
    pen: Pen
    hand: Hand
    ground: RGB = (255, 255, 255)

    @property
    def diagonal(self) -> float:
        """Of the object's bounding box, pixels."""
        return float(np.linalg.norm(np.ptp(self.points, axis=0)))

    @property
    def centre(self) -> Floats:
        """(2,) middle of the bounding box."""
        middle: Floats = (self.points.min(0) + self.points.max(0)) / 2
        return middle

    def drawn_edges(self) -> list[tuple[int, int]]:
        """Edges (a, b) of which the viewer sees more than half; all edges of a wireframe."""
        return [
            (a, b) for a, b, seen in self.scene.edges if self.lines == "wire" or sum(t1 - t0 for t0, t1 in seen) > 0.5
        ]

    def fine_pen(self, rng: np.random.Generator) -> Pen:
        """The pen for what is not the object: as broad or down to half as broad, never dashed by itself."""
        return replace(self.pen, width=max(self.pen.width * float(rng.uniform(0.5, 1.0)), 1.0), faint=0.0)

    def outward(self, point: Floats, rng: np.random.Generator, spread: float) -> Floats:
        """(2,) unit vector from the object's middle through a point, turned by up to `spread` radians."""
        away = point - self.centre
        turn = np.arctan2(away[1], away[0]) + rng.uniform(-spread, spread)
        unit: Floats = np.array([np.cos(turn), np.sin(turn)])
        return unit

    def strokes(self, paths: list[Floats], rng: np.random.Generator, dashed: bool = False) -> list[Stroke]:
        """Polylines as the object's own hand draws them."""
        loose = replace(self.hand, over=0.0, gap=0.0, short=0.0)
        return [Stroke(freehand(p, loose, rng), hidden=dashed) for p in paths]

    def ink(self, paths: list[Floats], pen: Pen, rng: np.random.Generator, dashed: bool = False) -> Coverage:
        """Coverage of polylines drawn by the object's own hand."""
        return coverage(self.strokes(paths, rng, dashed), pen, self.size, rng)


@dataclass(frozen=True)
class Layer:
    """Ink of one colour.

    ink    : (h, w) 0..1
    colour : RGB, None for the object's own ink
    under  : lies below the object's strokes
    """

    ink: Coverage
    colour: RGB | None = None
    under: bool = False


SUPERSAMPLED = 3
"""Times as many pixels along each side where areas are filled, so that their borders are smooth."""


def area(polygons: list[Floats], size: tuple[int, int]) -> Coverage:
    """(h, w) 0..1: the inside of polygons."""
    w, h = size
    canvas = np.zeros((h * SUPERSAMPLED, w * SUPERSAMPLED), np.uint8)
    for polygon in polygons:
        points = np.round(((polygon + 0.5) * SUPERSAMPLED - 0.5) * 16).astype(np.int32)
        cv2.fillPoly(canvas, [points.reshape(-1, 1, 2)], 255, cv2.LINE_8, 4)
    return np.asarray(cv2.resize(canvas, size, interpolation=cv2.INTER_AREA) / 255, np.float32)


def nearest_faces(drawn: Drawn) -> tuple[NDArray[np.intp], list[Floats]]:
    """Which face the viewer sees at each pixel of the supersampled sheet (-1: none), and the faces' planes.

    Planes are (3,) depth key = plane . (x, y, 1); the first face is the front face.
    """
    w, h = (SUPERSAMPLED * n for n in drawn.size)
    y, x = (np.mgrid[0:h, 0:w].astype(np.float32) + 0.5) / SUPERSAMPLED - 0.5
    nearest = np.full((h, w), np.inf, np.float32)
    index = np.full((h, w), -1, np.intp)
    faces = faces_of(np.c_[drawn.points, drawn.scene.key], drawn.scene.sizes)
    for number, face in enumerate(faces):
        mask = np.zeros((h, w), np.uint8)
        rings = [np.round(((r + 0.5) * SUPERSAMPLED - 0.5) * 16).astype(np.int32).reshape(-1, 1, 2) for r in face.rings]
        cv2.fillPoly(mask, rings, 1, cv2.LINE_8, 4)
        key = face.plane[0] * x + face.plane[1] * y + face.plane[2]
        closer = (mask > 0) & (key < nearest)
        nearest[closer] = key[closer]
        index[closer] = number
    return index, [f.plane for f in faces]


def at_size(supersampled: NDArray[np.bool_], size: tuple[int, int]) -> Coverage:
    """A supersampled mask as smooth coverage of a sheet of `size` (w, h)."""
    return np.asarray(cv2.resize(supersampled.astype(np.float32), size, interpolation=cv2.INTER_AREA), np.float32)


def some_colour(rng: np.random.Generator, own: float = 0.6) -> RGB | None:
    """The object's own ink with probability `own`, else a colour that people have at hand."""
    if rng.random() < own:
        return None
    colours: list[RGB] = [(200, 30, 30), (30, 80, 200), (20, 130, 60), (230, 120, 0), (110, 110, 110), (150, 40, 150)]
    return colours[int(rng.integers(len(colours)))]


def unit(vector: Floats) -> Floats:
    """The vector at length 1."""
    scaled: Floats = vector / max(float(np.linalg.norm(vector)), 1e-9)
    return scaled


def across(vector: Floats) -> Floats:
    """(2,) the vector turned by a quarter."""
    return np.array([-vector[1], vector[0]])
