#!/usr/bin/env python3
"""Write the gallery: every kind of committed drawing, what was found in it, and the solid.

python scripts/make_gallery.py FOLDER        writes FOLDER/gallery.md and FOLDER/gallery/*.jpg
"""

from __future__ import annotations

import io
import os
import sys
from pathlib import Path

os.environ.setdefault("OMP_NUM_THREADS", "1")

import numpy as np
from PIL import Image

import sketch2shape as s2s
from sketch2shape.pictures import overlay, preview_of

DRAWINGS = Path(__file__).resolve().parents[1] / "data" / "synthetic"
TILE = (320, 240)
"""Width and height of one picture, pixels; three of them make a strip."""

HEAD = """# Gallery

Made by `scripts/make_gallery.py` from `data/synthetic`: the first drawing of each kind, what is found in it (front face
blue, back face orange), and the solid. All of them are drawn by the generator of test drawings.
"""


def tile(pixels: np.ndarray) -> Image.Image:
    """The picture in the middle of a white tile."""
    small = Image.fromarray(pixels)
    small.thumbnail(TILE, Image.Resampling.LANCZOS)
    sheet = Image.new("RGB", TILE, "white")
    sheet.paste(small, ((TILE[0] - small.width) // 2, (TILE[1] - small.height) // 2))
    return sheet


def strip(drawing: Path) -> tuple[bytes, str]:
    """JPEG of drawing, overlay and solid side by side, and the confidence; or the drawing and why it is refused."""
    try:
        result = s2s.reconstruct(drawing)
    except s2s.NoObjectError as error:
        tiles, said = [tile(s2s.read_picture(drawing).pixels)], f"refused: {error.message}"
    else:
        pictures = (result.picture.pixels, overlay(result, legend=False), preview_of(result))
        tiles, said = (
            [tile(pixels) for pixels in pictures],
            f"confidence {min(o.confidence for o in result.objects):.2f}",
        )
    sheet = Image.new("RGB", (TILE[0] * len(tiles), TILE[1]), "white")
    for at, picture in enumerate(tiles):
        sheet.paste(picture, (at * TILE[0], 0))
    data = io.BytesIO()
    sheet.save(data, "JPEG", quality=82, optimize=True)
    return data.getvalue(), said


def write_gallery(folder: Path, kinds: str = "*") -> None:
    """The page and its pictures in the folder."""
    (folder / "gallery").mkdir(parents=True, exist_ok=True)
    rows = []
    for place in sorted(p for p in DRAWINGS.glob(kinds) if p.is_dir()):
        drawing = min(p for p in place.iterdir() if p.suffix != ".json")
        data, said = strip(drawing)
        (folder / "gallery" / f"{place.name}.jpg").write_bytes(data)
        name = place.name.replace("_", " ")
        rows.append(f"\n## {name}\n\n![{name}](gallery/{place.name}.jpg)\n\n{said}\n")
    (folder / "gallery.md").write_text(HEAD + "".join(rows), "utf-8")


if __name__ == "__main__":
    write_gallery(Path(sys.argv[1]))
