"""Draw docs/readme.png with the tool itself: drawings, what is found in them, and the solids.

python scripts/make_readme_picture.py
"""

from __future__ import annotations

import tempfile
from pathlib import Path

import numpy as np
from repository import ROOT

from sketch2shape.model.picture import Picture
from sketch2shape.pictures import encode_png, overlay, preview
from sketch2shape.pipeline import reconstruct
from synthetic.drawing import draw

TARGET = ROOT / "docs" / "readme.png"
TILE = (400, 300)
SHOWN = (("photo_wire", "house"), ("annotated_dashed", "stairs"), ("blueprint_removed", "star"))


def main() -> None:
    columns = []
    with tempfile.TemporaryDirectory() as scratch:
        for category, shapes in SHOWN:
            path = draw(category, 12, 0, shapes=shapes).save(Path(scratch))
            result = reconstruct(path)
            solid = preview(result.solids, TILE)
            columns.append(np.vstack([framed(result.picture), framed_pixels(overlay(result, legend=False)), solid]))
    TARGET.write_bytes(encode_png(np.hstack(columns)))


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
