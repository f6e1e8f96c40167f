"""Draw docs/readme.png with the tool itself: drawings, what is found in them, and the solids.

python scripts/make_readme_picture.py
"""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw
from repository import ROOT

from sketch2shape.model.picture import Picture
from sketch2shape.pictures import encode_png, overlay, preview_of
from sketch2shape.pipeline import reconstruct
from synthetic.drawing import draw

TARGET = ROOT / "docs" / "readme.png"
TILE = (400, 300)
SHOWN = (("photo_dashed", "L", 1), ("curved_annotated", None, 4), ("plate_dashed", "round end", 4))
"""Category, shape if it is chosen, and number of each drawing."""
TITLES = (
    ("a photo of a sketch", "a textbook figure", "a blueprint of a plate with round holes"),
    ("what is found: the front face blue, the back face orange, edges behind them dashed",),
    ("the solid, exact and watertight: for a 3-D printer, CAD, a viewer",),
)
"""What stands above each row; several titles share the width."""
BAND = 36
"""Height of the line of text above a row, pixels."""


def main() -> None:
    columns = []
    with tempfile.TemporaryDirectory() as scratch:
        for category, shapes, number in SHOWN:
            path = draw(category, 12, number, shapes=shapes).save(Path(scratch))
            result = reconstruct(path)
            solid = preview_of(result, TILE)
            columns.append((framed(result.picture), framed_pixels(overlay(result, legend=False)), solid))
    rows = [np.hstack(tiles) for tiles in zip(*columns, strict=True)]
    titled = [part for titles, row in zip(TITLES, rows, strict=True) for part in (band(titles, row.shape[1]), row)]
    TARGET.write_bytes(encode_png(np.vstack(titled)))


def band(titles: Sequence[str], width: int) -> np.ndarray:
    """A white band with the titles in the middle of equal parts of its width."""
    from sketch2shape.pictures.canvas import font

    sheet = Image.new("RGB", (width, BAND), "white")
    for at, title in enumerate(titles):
        middle = (width * (2 * at + 1) / (2 * len(titles)), BAND / 2)
        ImageDraw.Draw(sheet).text(middle, title, (60, 60, 60), font(20), anchor="mm")
    return np.asarray(sheet)


def framed(picture: Picture) -> np.ndarray:
    return framed_pixels(picture.pixels)


def framed_pixels(pixels: np.ndarray) -> np.ndarray:
    """The picture in the middle of a white tile."""
    from sketch2shape.pictures.canvas import fit

    w, h = TILE
    small, _ = fit(pixels, w - 12, h - 12)
    tile = np.full((h, w, 3), 255, np.uint8)
    y, x = (h - small.shape[0]) // 2, (w - small.shape[1]) // 2
    tile[y : y + small.shape[0], x : x + small.shape[1]] = small
    return tile


if __name__ == "__main__":
    main()
