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
OTHERS = (0, 1, 2, 12, 4, 5, 6, 7, 8, 42, 69)
"""Every solid of another kind, the cup three times; number 3, a scan, is too large a file."""
CURVED = (
    *(("cylinder_wire", 2, ""), ("cylinder_removed", 4, ""), ("cylinder_dashed", 7, ""), ("tube_dashed", 2, "")),
    *(("tube_removed", 6, ""), ("plate_wire", 5, ""), ("plate_dashed", 6, ""), ("plate_dashed", 4, "")),
    *(("plate_removed", 5, ""), ("arcs_wire", 1, "slot"), ("arcs_dashed", 8, ""), ("arcs_removed", 9, "")),
    *(("arcs_removed", 2, "fillet"), ("arcs_dashed", 6, ""), ("arcs_dashed", 4, ""), ("arcs_removed", 8, "")),
    *(("arcs_wire", 5, ""), ("arcs_dashed", 1, "round end"), ("arcs_removed", 6, ""), ("cone_wire", 2, "")),
    *(("cone_dashed", 3, ""), ("cone_removed", 4, ""), ("frustum_wire", 1, ""), ("frustum_removed", 7, "")),
    *(("frustum_dashed", 5, "rounded rectangle"), ("pyramid_wire", 1, "3"), ("pyramid_dashed", 1, "12")),
    *(("pyramid_dashed", 2, "5"), ("pyramid_removed", 4, ""), ("pyramid_removed", 5, "6"), ("pyramid_wire", 6, "6")),
    *(("curved_annotated", 4, ""), ("curved_annotated", 7, ""), ("curved_annotated", 9, "")),
    *(("curved_annotated", 18, ""), ("curved_annotated", 34, ""), ("curved_persp_wire", 1, "")),
    *(("curved_persp_dashed", 5, ""), ("curved_persp_removed", 2, ""), ("curved_below_removed", 1, "")),
    *(("curved_below_dashed", 5, ""), ("curved_sketch", 4, ""), ("curved_sketch", 6, ""), ("curved_sketch", 7, "")),
)
"""More with arcs and points: category, number (which chooses the pen), and the outline where it is chosen."""


def main() -> None:
    out = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "data" / "synthetic"
    for name in ONE_EACH:
        draw(name, SEED, 0).save(out)
    for index in NEGATIVES:
        draw("negative", SEED, index).save(out)
    for name in sorted(HARD):
        of_three_styles = name.endswith(("_wire", "_dashed", "_removed")) and not name.startswith("tinted")
        for index in OTHERS if name == "no_others" else range(1 if of_three_styles else 2):
            draw(name, SEED, index).save(out)
    for name, index, shape in CURVED:
        draw(name, SEED, index, shapes=shape or None).save(out)


if __name__ == "__main__":
    main()
