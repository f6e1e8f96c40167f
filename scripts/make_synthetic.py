"""Draw the committed drawings of data/synthetic again: `python scripts/make_synthetic.py [OUT]`.

One or a few small drawings of each kind; `scripts/make_drawings.py` draws any number of all kinds.
"""

from __future__ import annotations

import sys
from pathlib import Path

from repository import ROOT

from synthetic.drawing import draw
from synthetic.recipes import HARD

SEED = 2026
ONE_EACH = (
    *("clean_wire_oblique", "clean_wire_axono", "clean_wire_persp", "clean_dashed_oblique", "clean_dashed_axono"),
    *("clean_dashed_persp", "clean_removed_oblique", "clean_removed_axono", "clean_removed_persp", "thin_wire"),
    *("thin_removed", "marker_wire", "marker_removed", "icon_wire", "icon_removed", "hand_wire", "hand_dashed"),
    *("hand_removed", "handheavy_wire", "pencil_wire", "pencil_removed", "pen_wire", "pen_dashed", "coloured_wire"),
    *("blueprint_wire", "blueprint_removed", "dark_dashed", "transparent_wire", "transparent_removed", "scan_wire"),
    *("photo_wire", "photo_removed", "grid_wire", "grid_removed", "ruled_wire", "isodots_wire", "lowres_wire"),
    *("lowres_removed", "large_wire", "jpeg_dashed", "taper_wire", "taper_dashed", "taper_removed", "holes_wire"),
    *("holes_dashed", "many_vertices", "many_removed", "accident_cube", "accident_vertex", "accident_collinear"),
    *("accident_coincident", "rounded_wire", "multi_wire", "multi_removed", "letters", "annotated_dashed"),
    *("annotated_removed", "shaded_wire", "shaded_removed", "dots", "diagonals", "cut"),
)
NEGATIVES = (0, 1, 3, 5, 8, 9, 12, 13, 15, 17)


def main() -> None:
    out = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "data" / "synthetic"
    for name in ONE_EACH:
        draw(name, SEED, 0).save(out)
    for index in NEGATIVES:
        draw("negative", SEED, index).save(out)
    for name in sorted(HARD):
        of_three_styles = name.endswith(("_wire", "_dashed", "_removed")) and not name.startswith("tinted")
        for index in range(1 if of_three_styles else 2):
            draw(name, SEED, index).save(out)


if __name__ == "__main__":
    main()
