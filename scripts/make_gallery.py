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
from repository import ROOT

import sketch2shape as s2s
from evaluation.cases import case_of
from evaluation.measure import measure
from evaluation.outcome import Outcome
from sketch2shape.pictures import overlay, preview_of

DRAWINGS = ROOT / "data" / "synthetic"
TILE = (320, 240)
"""Width and height of one picture, pixels; three of them make a strip."""

HEAD = """# Gallery

Made by `scripts/make_gallery.py` from `data/synthetic`: the first drawing of each kind, what is found in it (front face
blue, back face orange), and the solid. All of them are drawn by the generator of test drawings. Each answer is held
against the truth beside its drawing, and wrong ones are shown, too.
"""


def tile(pixels: np.ndarray) -> Image.Image:
    """The picture in the middle of a white tile."""
    small = Image.fromarray(pixels)
    small.thumbnail(TILE, Image.Resampling.LANCZOS)
    sheet = Image.new("RGB", TILE, "white")
    sheet.paste(small, ((TILE[0] - small.width) // 2, (TILE[1] - small.height) // 2))
    return sheet


def strip(drawing: Path) -> tuple[bytes, str]:
    """JPEG of drawing, overlay and solid side by side, of the drawing alone if refused; and what came of it."""
    results: list[s2s.Result] = []

    def kept(source: str) -> s2s.Result:
        results.append(s2s.reconstruct(source))
        return results[-1]

    outcome = measure(case_of(drawing), kept)
    tiles = [tile(s2s.read_picture(drawing).pixels)]
    tiles += [tile(draw(result)) for result in results for draw in (_overlay, preview_of)]
    sheet = Image.new("RGB", (TILE[0] * len(tiles), TILE[1]), "white")
    for at, picture in enumerate(tiles):
        sheet.paste(picture, (at * TILE[0], 0))
    data = io.BytesIO()
    sheet.save(data, "JPEG", quality=82, optimize=True)
    return data.getvalue(), said(outcome)


def _overlay(result: s2s.Result) -> np.ndarray:
    return overlay(result, legend=False)


def said(outcome: Outcome) -> str:
    """Whether it is right, and how sure the answer is or why there is none."""
    verdict = "right" if outcome.right else f"wrong: {outcome.cause}"
    if outcome.answered:
        return f"{verdict}; confidence {outcome.confidence:.2f}"
    return f"{verdict if outcome.right else 'wrong'}; refused: {outcome.message.partition(': ')[2]}"


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
