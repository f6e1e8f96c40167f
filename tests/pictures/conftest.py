"""Drawings made from points, with the answer that belongs to them."""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np
import pytest

from sketch2shape.model import Projection, Solid, two_face_boundary
from sketch2shape.model.drawing import FacePair, TwoFaceObject
from sketch2shape.model.picture import Picture
from sketch2shape.pipeline.result import Result

BOX = [[100, 160], [300, 160], [300, 340], [100, 340]]
NOTCHED = [[100, 150], [180, 150], [180, 260], [300, 260], [300, 150], [380, 150], [380, 380], [100, 380]]
HOLE = [[200, 220], [200, 340], [320, 340], [320, 220]]


def drawn(f1: Sequence, d: Sequence, holes: Sequence = (), size: tuple[int, int] = (560, 440)) -> Result:
    """An oblique wireframe drawing of a prism and its result."""
    front, shift = np.array(f1, float), np.array(d, float)
    pairs = tuple(FacePair(np.array(h, float), np.array(h, float) + shift) for h in holes)
    obj = TwoFaceObject(front, front + shift, pairs, confidence=0.97)
    pixels = np.full((size[1], size[0], 3), 255, np.uint8)
    for i, j in obj.edges:
        a, b = obj.vertices[[i, j]].round().astype(int).tolist()
        cv2.line(pixels, a, b, (40, 40, 40), 2, cv2.LINE_AA)
    half = len(obj.vertices) // 2
    rings = np.concatenate([r.f1 for r in obj.rings])
    vertices = np.r_[np.c_[rings, np.zeros(half)], np.c_[rings, np.full(half, 150.0)]]
    solid = Solid(two_face_boundary(vertices, [len(r.f1) for r in obj.rings]), Projection("oblique"))
    return Result((obj,), (solid,), Picture(pixels, "drawing.png"))


@pytest.fixture(scope="session")
def box() -> Result:
    return drawn(BOX, [90, -60])


@pytest.fixture(scope="session")
def notched() -> Result:
    return drawn(NOTCHED, [120, -80])


@pytest.fixture(scope="session")
def tube() -> Result:
    return drawn([[120, 160], [400, 160], [400, 400], [120, 400]], [110, -90], [HOLE])


@pytest.fixture(scope="session")
def nothing() -> Result:
    return Result((), (), Picture(np.full((50, 80, 3), 255, np.uint8), "empty.png"))
