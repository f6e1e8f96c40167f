"""Drawings as files of programs that keep lines: SVG, Excalidraw, tldraw, InkML, JSON and PDF, each in several manners.

`write("svg/inkscape", strokes, size, rng)` gives what the program would save for strokes on a sheet of `size`.
Each manner follows the documented format and has what such files have beside the strokes: layers, styles, transforms,
labels, a frame, a filled ground.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from synthetic import ink_files, json_files, pdf_files, svg_files
from synthetic.hand import Stroke

Size = tuple[int, int]
Writer = Callable[[list[Stroke], Size, np.random.Generator], bytes]

MANNERS: dict[str, Writer] = {**svg_files.MANNERS, **json_files.MANNERS, **ink_files.MANNERS, **pdf_files.MANNERS}
"""kind/manner -> what writes it."""

ENDINGS = {
    "svg": ".svg",
    "excalidraw": ".excalidraw",
    "tldraw": ".tldr",
    "inkml": ".inkml",
    "pen": ".json",
    "pdf": ".pdf",
}
"""kind -> ending of its files."""


def write(manner: str, strokes: list[Stroke], size: Size, rng: np.random.Generator) -> bytes:
    """The file that holds these strokes. `manner` is a key of `MANNERS`."""
    return MANNERS[manner](strokes, size, rng)
