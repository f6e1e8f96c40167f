"""The pictures that are timed: ordinary drawings, large ones, ones with many vertices, hard ones."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from sketch2shape.model.arrays import Floats
from synthetic.drawing import draw
from synthetic.hand import RULER
from synthetic.negatives import NEGATIVES
from synthetic.pens import Pen

ROOT = Path(__file__).resolve().parent.parent
BENCH = ROOT.parent / "shared" / "bench"
"""Drawings with truth that may lie beside the repository."""
SMALL = ("clean_wire_oblique", "clean_wire_axono", "clean_dashed_oblique", "clean_removed_axono", "clean_wire_persp")
THIN = np.array([0.036, -0.056])
"""Depth of a thin plate, as a part of the sheet's shorter side."""


def small_drawings(scratch: Path, most: int) -> list[Path]:
    """Drawings of 640 x 480: the independent ones beside the repository if there, else fresh ones."""
    found = [
        p
        for p in sorted((BENCH / "drawings").glob("*/*.png"))
        if _size(p) == (640, 480) and p.parent.name != "negative"
    ]
    if not found:
        names = [*SMALL, "hand_wire", "hand_dashed", "hand_removed", "taper_wire", "thin_wire"]
        found = [draw(name, 31, i).save(scratch / "small") for name in names for i in range(6)]
    return found[:: max(len(found) // most, 1)][:most]


def of_set(name: str, most: int) -> list[Path]:
    """Pictures of another set beside the repository, from all its kinds; none where it is not there."""
    found = [p for p in sorted((BENCH / name).glob("*/*")) if p.suffix in (".png", ".jpg")]
    return found[:: max(len(found) // most, 1)][:most]


def _size(path: Path) -> tuple[int, int]:
    from PIL import Image

    with Image.open(path) as picture:
        return picture.size


def wire(ring: Floats, shift: Floats, size: tuple[int, int], pen: float) -> NDArray[np.uint8]:
    """(h, w) grey wireframe of a prism: ring (n, 2) in 0..1 of the sheet's shorter side, the back face shifted."""
    canvas = np.full(size[::-1], 255, np.uint8)
    middle, scale = np.array(size) / 2, min(size)
    f1 = (ring - shift / 2) * scale + middle
    f2 = f1 + shift * scale
    starts, ends = np.vstack([f1, f2, f1]), np.vstack([np.roll(f1, -1, 0), np.roll(f2, -1, 0), f2])
    for a, b in zip(np.round(starts * 16).astype(int), np.round(ends * 16).astype(int), strict=True):
        cv2.line(canvas, a.tolist(), b.tolist(), 0, max(round(pen), 1), cv2.LINE_AA, 4)
    return canvas


def bracket(n: int) -> Floats:
    """(n, 2) ring of n vertices: a triangle, a plate with two corners cut off, or a C with teeth on its long sides.

    All edges run at a clear angle to `THIN`, the depth of these drawings, so that no two lie on each other.
    """
    if n == 3:
        return np.array([[-0.55, 0.35], [0.5, 0.3], [0.4, -0.3]])
    if n == 6:
        return np.array([[-0.6, -0.4], [0.4, -0.4], [0.55, -0.1], [0.55, 0.4], [-0.35, 0.4], [-0.6, 0.1]])
    w, h, arm = 0.62, 0.43, 0.27
    corners = np.array([[-w, -h], [w, -h], [w, arm - h], [arm - w, arm - h]])
    corners = np.vstack([corners, corners[::-1] * [1, -1]])
    ring = []
    for side, (start, end) in enumerate(zip(corners, np.roll(corners, -1, axis=0), strict=True)):
        teeth = 0 if side % 2 else (n - 8) * (side // 2 + 1) // 4 - (n - 8) * (side // 2) // 4
        k = np.arange(teeth + 1)
        tall = min(0.29 * abs(end[0] - start[0]) / (teeth + 1), 0.03) * (0.85 + 0.3 * (0.618 * k % 1))
        points = start + (end - start) * k[:, None] / (teeth + 1)
        points[1:, 1] += (tall * (-1) ** k)[1:]
        ring.append(points)
    return np.vstack(ring)


def of_vertices(folder: Path, counts: Sequence[int]) -> dict[int, Path]:
    """Wireframes with n vertices a face, all on sheets of 2400 x 1800 and so thin that few edges cross."""
    folder.mkdir(parents=True, exist_ok=True)
    out = {}
    for n in counts:
        out[n] = folder / f"vertices_{n}.png"
        cv2.imwrite(str(out[n]), wire(bracket(n), THIN, (2400, 1800), 3))
    return out


def of_pixels(folder: Path, megapixels: Sequence[float]) -> dict[float, Path]:
    """The same house on sheets of different size, the pen in proportion."""
    folder.mkdir(parents=True, exist_ok=True)
    house = np.array([[-0.3, 0.3], [0.2, 0.3], [0.2, -0.05], [-0.05, -0.3], [-0.3, -0.05]])
    out = {}
    for mp in megapixels:
        w = round(np.sqrt(mp * 1e6 * 4 / 3))
        out[mp] = folder / f"pixels_{mp:g}.png"
        cv2.imwrite(str(out[mp]), wire(house, np.array([0.21, -0.13]), (w, round(w * 3 / 4)), w / 320))
    return out


def of_objects(folder: Path, counts: Sequence[int]) -> dict[int, Path]:
    """The same house again and again on one sheet, which grows with their number."""
    folder.mkdir(parents=True, exist_ok=True)
    house = np.array([[-0.3, 0.3], [0.2, 0.3], [0.2, -0.05], [-0.05, -0.3], [-0.3, -0.05]])
    one = wire(house, np.array([0.21, -0.13]), (320, 240), 2)
    out = {}
    for n in counts:
        across = int(np.ceil(np.sqrt(n)))
        sheet = np.full((-(-n // across) * 240, across * 320), 255, np.uint8)
        for k in range(n):
            row, column = divmod(k, across)
            sheet[row * 240 : (row + 1) * 240, column * 320 : (column + 1) * 320] = one
        out[n] = folder / f"objects_{n}.png"
        cv2.imwrite(str(out[n]), sheet)
    return out


def photo(folder: Path, size: tuple[int, int]) -> Path:
    """A phone's photo of a drawing at full size, JPEG."""
    folder.mkdir(parents=True, exist_ok=True)
    pixels = cv2.resize(draw("photo_wire", 5, 1).pixels, size, interpolation=cv2.INTER_CUBIC)
    out = folder / f"photo_{size[0]}.jpg"
    cv2.imwrite(str(out), pixels[..., ::-1], [cv2.IMWRITE_JPEG_QUALITY, 90])
    return out


def hard(folder: Path) -> dict[str, Path]:
    """A page of text, dense scribble, a texture of thousands of corners: all to be refused, and fast."""
    folder.mkdir(parents=True, exist_ok=True)
    out, rng = {}, np.random.default_rng(1)
    size, pen = (1600, 1200), Pen(2.0)
    for name in ("page_of_text", "scribble", "texture", "zigzag", "network", "noise"):
        ink = NEGATIVES[name](size, pen, RULER, rng)
        if name in ("scribble", "texture"):  # three layers make them dense
            ink = np.maximum.reduce([ink, *(NEGATIVES[name](size, pen, RULER, rng) for _ in range(2))])
        out[name.replace("_", " ")] = folder / f"{name}.png"
        cv2.imwrite(str(folder / f"{name}.png"), np.round(255 * (1 - ink)).astype(np.uint8))
    return out
