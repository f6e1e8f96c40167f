"""From the many ways to store pixels to plain 8-bit RGB on an opaque ground."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import cv2
import numpy as np
from numpy.typing import NDArray

from sketch2shape.errors import UnreadableError
from sketch2shape.reading.limits import Limits

if TYPE_CHECKING:
    from PIL.Image import Image

Pixels = NDArray[np.uint8]

_INTEGERS = "an array (h, w), (h, w, 3) or (h, w, 4) of integers, or of floats in 0..1"

#: EXIF tag of the side that is up
_ORIENTATION = 0x0112
#: ink on transparency counts as light if its mean luminance is above this ...
_LIGHT = 160
#: ... and no more than this part of it is darker than mid-grey (else it is white paper with a dark drawing on it)
_DARK_PART = 0.005
#: a picture is a drawing on transparency only if at least this part of it is transparent
_TRANSPARENT_PART = 0.5


def from_image(image: Image) -> Pixels:
    """(h, w, 3) uint8 of a PIL image: EXIF orientation applied, 16 bits scaled, transparency composited.

    Raises what Pillow raises on damaged data, and UnreadableError on samples that are no numbers.
    """
    image.load()
    if image.mode in ("I", "F") or image.mode.startswith("I;"):
        image = _grey(image)
    elif image.mode in ("LA", "PA", "La", "RGBA", "RGBa") or "transparency" in image.info:
        image = image.convert("RGBA")
    elif image.mode not in ("L", "RGB"):
        image = image.convert("RGB")
    image = _upright(image)
    pixels = np.asarray(image)
    if pixels.ndim == 2:
        return np.asarray(cv2.cvtColor(pixels, cv2.COLOR_GRAY2RGB), dtype=np.uint8)
    return over_ground(pixels) if pixels.shape[2] == 4 else np.ascontiguousarray(pixels)


def _upright(image: Image) -> Image:
    """Turn as EXIF says; damaged EXIF is ignored, because the picture itself may be sound."""
    from PIL import ImageOps

    try:
        return image if image.getexif().get(_ORIENTATION, 1) == 1 else ImageOps.exif_transpose(image)
    except Exception:  # a stranger's EXIF can fail in any way
        return image


def _grey(image: Image) -> Image:
    """Scale 16-bit, 32-bit and float samples to 8 bits; keep the EXIF for later."""
    from PIL import Image

    samples = np.asarray(image)
    grey = Image.fromarray(_float_samples(samples) if samples.dtype.kind == "f" else scale_integers(samples))
    grey.info = {k: v for k, v in image.info.items() if k == "exif"}
    return grey


def _float_samples(samples: NDArray[Any]) -> Pixels:
    """Stretch the finite range of float samples to 0..255 (a float TIFF says nowhere what white is)."""
    if not np.isfinite(samples).all():
        raise UnreadableError("it holds NaN or infinite samples", remedy="save it with 8 bits a sample")
    low, high = float(samples.min()), float(samples.max())
    return np.asarray((samples - low) * (255 / (high - low or 1)), np.uint8)


def scale_integers(samples: NDArray[Any]) -> Pixels:
    """Scale integers to 8 bits by the bits in use: the top of the range stays white, nothing is clipped.

    Files of 16 bits often hold 10-, 12- or 8-bit data, so the range is the next power of two above the largest sample.
    """
    if samples.dtype == np.uint8:
        return samples
    if samples.size and int(samples.min()) < 0:
        samples = samples - samples.min()
    top = max(255, (1 << int(samples.max()).bit_length()) - 1) if samples.size else 255
    scaled = samples * np.float64(255.0 / top)
    return np.rint(scaled, out=scaled).astype(np.uint8)


def over_ground(rgba: NDArray[np.uint8]) -> Pixels:
    """Composite (h, w, 4) over white, or over black where the drawing is light ink on transparency."""
    light = _light_ink(rgba)
    out = np.empty((*rgba.shape[:2], 3), np.uint8)
    for rows in _bands(len(rgba)):
        *colours, alpha = cv2.split(rgba[rows])
        if light:
            out[rows] = cv2.merge([cv2.multiply(c, alpha, scale=1 / 255) for c in colours])
        else:  # white less what the picture takes from it
            taken = [cv2.multiply(cv2.bitwise_not(c), alpha, scale=1 / 255) for c in colours]
            out[rows] = cv2.bitwise_not(cv2.merge(taken))
    return out


def _bands(height: int, step: int = 512) -> list[slice]:
    """Row ranges, so that copies of large pictures stay small."""
    return [slice(y, y + step) for y in range(0, height, step)]


def _light_ink(rgba: NDArray[np.uint8]) -> bool:
    """Whether the picture is mostly transparent and what is drawn on it would vanish on white."""
    stride = max(1, int(np.sqrt(rgba.shape[0] * rgba.shape[1] / 4e6)))
    sample = rgba[::stride, ::stride]
    opacity = np.asarray(cv2.extractChannel(sample, 3), np.uint8)
    if np.count_nonzero(opacity < 128) < _TRANSPARENT_PART * opacity.size or not opacity.any():
        return False
    shown = sample[opacity > 0].astype(np.float32)
    alpha = shown[:, 3] / 255
    total = float(alpha.sum())
    luminance = shown[:, :3] @ np.array([0.299, 0.587, 0.114], np.float32)
    mean = float(luminance @ alpha) / total
    dark = float(alpha[luminance < 128].sum()) / total
    return mean > _LIGHT and dark < _DARK_PART


def _eight_bits(array: NDArray[Any]) -> Pixels:
    """Floats in 0..1, as OpenCV, scikit-image and matplotlib show them, or in 0..255. Raises UnreadableError."""
    low, high = float(array.min()), float(array.max())
    if low < 0 or high > 255:
        raise UnreadableError(f"an array of floats from {low:g} to {high:g} is no picture", remedy=_INTEGERS)
    return np.rint(array * (255.0 if high <= 1.0 else 1.0)).astype(np.uint8)


def from_array(source: Any, limits: Limits) -> Pixels:
    """(h, w, 3) uint8 of an array (h, w), (h, w, 1), (h, w, 3) or (h, w, 4) of integers, booleans, or floats in 0..1.

    Raises UnreadableError on other shapes and types, LimitError on too many pixels.
    """
    array = np.asarray(source)
    if array.dtype.kind == "f" and array.size and not np.isfinite(array).all():
        raise UnreadableError("the array holds NaN or infinite values", remedy=_INTEGERS)
    if array.dtype.kind == "f" and array.size:
        array = _eight_bits(array)
    if array.dtype.kind not in "uib":
        raise UnreadableError(f"an array of {array.dtype} is no picture", remedy=_INTEGERS)
    if array.ndim not in (2, 3) or (array.ndim == 3 and array.shape[2] not in (1, 3, 4)) or 0 in array.shape:
        raise UnreadableError(f"an array of shape {array.shape} is no picture", remedy=_INTEGERS)
    limits.check_size(array.shape[1], array.shape[0])
    pixels = array.astype(np.uint8) * 255 if array.dtype.kind == "b" else scale_integers(array)
    if pixels.ndim == 2 or pixels.shape[2] == 1:
        return np.repeat(pixels.reshape(*pixels.shape[:2], 1), 3, axis=2)
    return over_ground(pixels) if pixels.shape[2] == 4 else pixels.copy()
