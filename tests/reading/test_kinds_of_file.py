"""The same drawing in every kind of file gives the same object."""

from __future__ import annotations

import cv2
import numpy as np
import pytest
from PIL import Image
from scipy.optimize import linear_sum_assignment
from sketches import encoded

import sketch2shape as s2s

FRONT = np.array([[60, 120], [220, 120], [220, 190], [150, 190], [150, 260], [60, 260]], float)
SHIFT = np.array([80.0, -50.0])
SIZE = (360, 320)


def ink():
    """(h, w) uint8: 255 where the wireframe is drawn."""
    mask = np.zeros((SIZE[1], SIZE[0]), np.uint8)
    for ring in (FRONT, FRONT + SHIFT):
        cv2.polylines(mask, [ring.astype(np.int32)], True, 255, 2, cv2.LINE_AA)
    for point in FRONT:
        cv2.line(mask, point.astype(int).tolist(), (point + SHIFT).astype(int).tolist(), 255, 2, cv2.LINE_AA)
    return mask


def on_transparency(colour):
    return np.dstack([np.full((*ink().shape, 3), colour, np.uint8), ink()])


def variants():
    grey = Image.fromarray(255 - ink())
    rotated = Image.Exif()
    rotated[0x0112] = 6
    return {
        "grey.png": encoded(grey, "PNG"),
        "deep.png": encoded(Image.fromarray((255 - ink()).astype(np.uint16) * 257), "PNG"),
        "twelve bits": (255 - ink()).astype(np.uint16) * 16,
        "palette.png": encoded(grey.convert("P"), "PNG"),
        "bilevel.tif": encoded(grey.convert("1"), "TIFF", compression="group4"),
        "cmyk.jpg": encoded(grey.convert("CMYK"), "JPEG", quality=95),
        "black on nothing.png": encoded(Image.fromarray(on_transparency(0)), "PNG"),
        "white on nothing.png": encoded(Image.fromarray(on_transparency(255)), "PNG"),
        "white on nothing.webp": encoded(Image.fromarray(on_transparency(255)), "WEBP", lossless=True),
        "rotated.jpg": encoded(grey.transpose(Image.Transpose.ROTATE_90), "JPEG", exif=rotated, quality=95),
        "moving.gif": encoded(grey, "GIF", save_all=True, append_images=[Image.new("L", SIZE, 255)]),
        "text.pgm": b"P2 %d %d 255 " % SIZE + b" ".join(b"%d" % v for v in (255 - ink()).ravel()),
        "array": np.asarray(grey),
        "image": grey,
    }


@pytest.mark.parametrize("name", variants())
def test_the_object_is_found_in_every_kind_of_file(name):
    (found,) = s2s.reconstruct(variants()[name]).objects
    truth = np.concatenate([FRONT, FRONT + SHIFT])
    assert len(found.vertices) == len(truth)
    distance = np.linalg.norm(found.vertices[:, None] - truth[None], axis=2)
    assert distance[linear_sum_assignment(distance)].max() < 2.5


@pytest.mark.parametrize("size", [(1, 1), (1, 400), (3, 2), (40, 30)])
def test_tiny_pictures_hold_no_object(size):
    for value in (0, 255):
        with pytest.raises(s2s.NoObjectError):
            s2s.reconstruct(np.full(size, value, np.uint8))
