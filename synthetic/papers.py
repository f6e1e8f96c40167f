"""Papers and the ways a drawing becomes pixels: squared, ruled, dotted paper; scanner, phone camera, thumbnail."""

from __future__ import annotations

from collections.abc import Callable

import cv2
import numpy as np
from numpy.typing import NDArray

from sketch2shape.model import Floats

Pixels = NDArray[np.uint8]
Image = NDArray[np.float32]
Capture = Callable[[Image, np.random.Generator], tuple[Image, Floats]]


def paper(kind: str, size: tuple[int, int], colour: tuple[int, int, int], rng: np.random.Generator) -> Image:
    """(h, w, 3) float32 0..255: blank, squared, ruled or isometrically dotted paper of `size` (w, h)."""
    w, h = size
    sheet = np.empty((h, w, 3), np.float32)
    sheet[:] = colour
    pitch = float(rng.uniform(18, 30)) * max(w / 800, 0.7)
    tint = np.array([[150, 190, 225], [175, 205, 180], [190, 190, 195]][int(rng.integers(3))], np.float32)
    mask = PATTERNS[kind](size, pitch, rng)
    strength = (float(rng.uniform(0.5, 0.95)) * mask)[..., None]
    return np.asarray(sheet * (1 - strength) + tint * strength, np.float32)


def _squared(size: tuple[int, int], pitch: float, rng: np.random.Generator) -> Image:
    return np.asarray(np.maximum(_ruled(size, pitch, rng), _ruled(size[::-1], pitch, rng).T), np.float32)


def _ruled(size: tuple[int, int], pitch: float, rng: np.random.Generator) -> Image:
    w, h = size
    mask = np.zeros((h, w), np.float32)
    for y in np.arange(rng.uniform(0, pitch), h - 1, pitch):
        part = y - int(y)
        mask[int(y)] += 1 - part
        mask[int(y) + 1] += part
    return mask


def _wide_ruled(size: tuple[int, int], pitch: float, rng: np.random.Generator) -> Image:
    mask = _ruled(size, pitch * 1.6, rng)
    if rng.random() < 0.5:
        mask[:, int(size[0] * 0.08)] = 1
    return mask


def _iso_dots(size: tuple[int, int], pitch: float, rng: np.random.Generator) -> Image:
    w, h = size
    mask = np.zeros((h, w), np.uint8)
    for row, y in enumerate(np.arange(pitch / 3, h, pitch * np.sqrt(3) / 2)):
        for x in np.arange(pitch / 2 * (row % 2), w, pitch):
            centre = (int(x * 16), int(y * 16))
            cv2.circle(mask, centre, int(1.3 * 16), 255, -1, cv2.LINE_AA, 4)
    del rng
    return np.asarray(mask / 255, np.float32)


def _blank(size: tuple[int, int], _pitch: float, _rng: np.random.Generator) -> Image:
    return np.zeros(size[::-1], np.float32)


PATTERNS: dict[str, Callable[[tuple[int, int], float, np.random.Generator], Image]] = {
    "blank": _blank,
    "squared": _squared,
    "ruled": _wide_ruled,
    "isodots": _iso_dots,
}


def ink_on(sheet: Image, ink: NDArray[np.float32], colour: tuple[int, int, int]) -> Image:
    """The sheet with ink of one colour laid over it; `ink` (h, w) 0..1."""
    c = np.array(colour, np.float32)
    return np.asarray(sheet * (1 - ink[..., None]) + c * ink[..., None], np.float32)


def direct(image: Image, _rng: np.random.Generator) -> tuple[Image, Floats]:
    """No camera: the picture as drawn. Like every capture, returns the picture and the homography applied."""
    return image, np.eye(3)


def noisy(image: Image, rng: np.random.Generator) -> tuple[Image, Floats]:
    """Sensor noise of 8 to 22 grey levels."""
    return image + rng.normal(0, rng.uniform(8, 22), image.shape).astype(np.float32), np.eye(3)


def scan(image: Image, rng: np.random.Generator) -> tuple[Image, Floats]:
    """A slightly turned page, greyish, a little soft, with dust."""
    h, w = image.shape[:2]
    angle = float(rng.uniform(-2.5, 2.5))
    m = cv2.getRotationMatrix2D((w / 2, h / 2), angle, float(rng.uniform(0.94, 1.0)))
    grey = float(rng.uniform(0.86, 0.97))
    edge = tuple(float(v) for v in image[2, 2])
    out: Image = cv2.warpAffine(image, m, (w, h), flags=cv2.INTER_LINEAR, borderValue=edge).astype(np.float32)
    out *= np.float32(grey)
    out = np.asarray(cv2.GaussianBlur(out, (0, 0), float(rng.uniform(0.4, 0.9))), np.float32)
    for _ in range(int(rng.integers(40, 250))):
        x, y = int(rng.integers(w)), int(rng.integers(h))
        cv2.circle(out, (x, y), int(rng.integers(0, 2)), [float(rng.uniform(30, 180))] * 3, -1)
    out = out + np.asarray(rng.normal(0, 4, (h, w, 1)), np.float32)
    return np.asarray(out, np.float32), np.vstack([m, [0, 0, 1]])


def photo(image: Image, rng: np.random.Generator) -> tuple[Image, Floats]:
    """A phone's picture: tilted page, its edge and the table in view, uneven light, a shadow, blur, noise."""
    h, w = image.shape[:2]
    corners = np.array([[0, 0], [w, 0], [w, h], [0, h]], np.float32)
    inset = rng.uniform(0.015, 0.085, (4, 2)) * [w, h]
    inward = np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]])
    seen = (corners + inset * inward).astype(np.float32)
    m = cv2.getPerspectiveTransform(corners, seen)
    table = np.array([[96, 72, 52], [70, 74, 80], [150, 128, 100], [40, 38, 42]][int(rng.integers(4))], np.float32)
    wood = (rng.normal(0, 6, (h, 1, 1)) + rng.normal(0, 3, (h, w, 1))).astype(np.float32)
    page = cv2.warpPerspective(np.ones((h, w), np.float32), m, (w, h))[..., None]
    out = cv2.warpPerspective(image, m, (w, h), flags=cv2.INTER_LINEAR) * page + (table + wood) * (1 - page)
    out = out * _light((w, h), rng)[..., None]
    out = cv2.GaussianBlur(out, (0, 0), float(rng.uniform(0.5, 1.2)))
    out = out + np.asarray(rng.normal(0, rng.uniform(2, 6), image.shape), np.float32)
    return np.asarray(out, np.float32), np.asarray(m, np.float64)


def _light(size: tuple[int, int], rng: np.random.Generator) -> Image:
    """Falling-off light with the soft shadow of a hand or a phone."""
    w, h = size
    y, x = np.mgrid[0:h, 0:w].astype(np.float32)
    t = rng.uniform(0, 2 * np.pi)
    slope = (np.cos(t) * (x / w - 0.5) + np.sin(t) * (y / h - 0.5)) * rng.uniform(0.15, 0.5)
    light = rng.uniform(0.65, 0.9) + slope
    if rng.random() < 0.6:
        s, at = rng.uniform(0, 2 * np.pi), rng.uniform(-0.2, 0.2)
        beyond = np.cos(s) * (x / w - 0.5) + np.sin(s) * (y / h - 0.5) - at
        light = light * (1 - rng.uniform(0.15, 0.35) / (1 + np.exp(-beyond * rng.uniform(15, 60))))
    return np.asarray(np.clip(light, 0.2, 1.0), np.float32)


def shade(image: Image, rng: np.random.Generator) -> tuple[Image, Floats]:
    """A flat copy with light that falls off a little and perhaps a soft shadow; no tilt."""
    h, w = image.shape[:2]
    light = _light((w, h), rng)
    light = 1 - float(rng.uniform(0.25, 0.6)) * (1 - light / light.max())
    out = image * light[..., None] + np.asarray(rng.normal(0, rng.uniform(0.5, 2.5), image.shape), np.float32)
    return np.asarray(out, np.float32), np.eye(3)


def thumbnail(image: Image, rng: np.random.Generator) -> tuple[Image, Floats]:
    """The picture reduced to about 200 pixels and sharpened a little, as web sites do."""
    h, w = image.shape[:2]
    factor = float(rng.uniform(190, 240)) / w
    small = cv2.resize(image, (round(w * factor), round(h * factor)), interpolation=cv2.INTER_AREA)
    soft = cv2.GaussianBlur(small, (0, 0), 0.8)
    fx, fy = small.shape[1] / w, small.shape[0] / h
    m = np.array([[fx, 0, (fx - 1) / 2], [0, fy, (fy - 1) / 2], [0, 0, 1]])
    return np.asarray(small + 0.4 * (small - soft), np.float32), m


def clipping(image: Image, rng: np.random.Generator) -> tuple[Image, Floats]:
    """The small, soft scan of an old textbook, about 110 to 190 pixels wide."""
    h, w = image.shape[:2]
    factor = float(rng.uniform(110, 190)) / w
    small = cv2.resize(image, (round(w * factor), round(h * factor)), interpolation=cv2.INTER_AREA)
    soft = cv2.GaussianBlur(small, (0, 0), float(rng.uniform(0.4, 0.8)))
    fx, fy = small.shape[1] / w, small.shape[0] / h
    m = np.array([[fx, 0, (fx - 1) / 2], [0, fy, (fy - 1) / 2], [0, 0, 1]])
    return np.asarray(soft, np.float32), m


CAPTURES: dict[str, Capture] = {
    "direct": direct,
    "noisy": noisy,
    "scan": scan,
    "photo": photo,
    "shade": shade,
    "thumbnail": thumbnail,
    "clipping": clipping,
}


def mapped(points: Floats, homography: Floats) -> Floats:
    """(k, 2) points moved by a (3, 3) homography."""
    h = np.c_[points, np.ones(len(points))] @ homography.T
    moved: Floats = h[:, :2] / h[:, 2:]
    return moved


def to_pixels(image: Image) -> Pixels:
    """Rounded and clipped to uint8."""
    return np.asarray(np.clip(np.round(image), 0, 255), np.uint8)
