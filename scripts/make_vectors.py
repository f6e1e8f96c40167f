"""Write the vector drawings of data/vectors again: `python scripts/make_vectors.py [OUT]`.

One file in each manner of `synthetic/vector_files.py`, and truth.json with what they show, in pixels of the sheet that
was drawn on; a file has its own unit and place.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

import numpy as np
from repository import ROOT

from synthetic.drawing import pen_strokes
from synthetic.vector_files import ENDINGS, MANNERS, write

SEED = 3
RULED = (
    "clean_wire_oblique",
    "clean_dashed_axono",
    "clean_removed_oblique",
    "clean_dashed_oblique",
    "clean_wire_axono",
)
BY_HAND = ("hand_wire", "hand_dashed", "hand_removed")
STRAIGHT = ("excalidraw/turned", "tldraw/lines", "tldraw/grouped", "tldraw/pages", "pdf/filled")
"""Manners that know nothing but straight lines."""


def main() -> None:
    out = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "data" / "vectors"
    truths = {}
    for k, manner in enumerate(MANNERS):
        kind, _, name = manner.partition("/")
        by_hand = k % 5 > 2 and manner not in STRAIGHT
        category = BY_HAND[k % 3] if by_hand else RULED[k % 5]
        strokes, style, truth = pen_strokes(category, SEED, k)
        target = out / kind / f"{name}{ENDINGS[kind]}"
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(write(manner, strokes, style.size, np.random.default_rng([SEED, k])))
        truths[target.relative_to(out).as_posix()] = truth
    (out / "truth.json").write_text(json.dumps(truths, indent=1) + "\n")


if __name__ == "__main__":
    main()
