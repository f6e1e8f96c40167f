"""Stands in for the vision core, and misbehaves for pictures whose names ask for it."""

from __future__ import annotations

import os
import signal
import time
from unittest.mock import patch

import numpy as np

from sketch2shape.batch.many import _reconstruct as many_reconstruct
from sketch2shape.conversion.convert import convert
from sketch2shape.errors import NoObjectError, UnreadableError
from sketch2shape.model import Projection, Solid, two_face_boundary
from sketch2shape.model.drawing import TwoFaceObject
from sketch2shape.pipeline.result import Result
from sketch2shape.reading.read import read_picture

CONFIDENCE = 0.9


def reconstruct(source, *, limits=None, **_):
    """A box as large as the picture; none if it is blank."""
    picture = read_picture(source, limits)
    if picture.pixels.min() > 200:
        raise NoObjectError("the picture is blank")
    height, width = picture.pixels.shape[:2]
    f1 = np.array([[0.0, 0], [width, 0], [width, height], [0, height]])
    vertices = np.r_[np.c_[f1, np.zeros(4)], np.c_[f1, np.full(4, 9.0)]]
    solid = Solid(two_face_boundary(vertices, (4,)), Projection("oblique"))
    return Result((TwoFaceObject(f1, f1 + [5, -5], confidence=CONFIDENCE),), (solid,), picture, {"ink": 1.0})


def work(task):
    """`convert`, but a picture named crash, hang, hog or bug does just that, and one named gate waits for a file."""
    misbehave(task.name)
    with patch("sketch2shape.pipeline.reconstruct", reconstruct):
        return convert(task)


def reconstruct_numbered(numbered, limits, options):
    """The same for what `reconstruct_many` runs in its workers."""
    if isinstance(numbered[1], str):
        misbehave(numbered[1])
    with patch("sketch2shape.pipeline.reconstruct", reconstruct):
        return many_reconstruct(numbered, limits, options)


def act(name):
    """Misbehave, or say so and tell the worker's number."""
    misbehave(name)
    if name == "known":
        raise UnreadableError("as a value")
    if name == "suicide":
        os.kill(os.getpid(), signal.SIGKILL)
    return f"did {name}", os.getpid()


def misbehave(name):
    if "crash" in name:
        os.kill(os.getpid(), signal.SIGSEGV)
    while "hang" in name:
        pass
    if "wait" in name:
        time.sleep(1000)
    if "hog" in name:
        hoard = [bytearray(2**26) for _ in range(2**14)]
        del hoard
    if "bug" in name:
        raise ZeroDivisionError("oh no")
    if "slow" in name:
        time.sleep(0.2)
    if "gate" in name:
        while not os.path.exists("open"):
            time.sleep(0.01)
