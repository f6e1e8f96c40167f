#!/usr/bin/env python3
"""Write the plans that the documentation shows, from a committed drawing and a plate made by hand.

python scripts/make_plans.py        writes docs/plans/*.svg
"""

from __future__ import annotations

import numpy as np
from repository import ROOT

import sketch2shape as s2s
from sketch2shape.export import encode
from sketch2shape.export.worksheet import worksheet_document
from sketch2shape.model import ArcPlace, Circle, Projection, Solid, two_face_boundary
from sketch2shape.sheets import svg_text

DRAWING = ROOT / "data" / "synthetic" / "hand_removed" / "000.png"
PLANS = ROOT / "docs" / "plans"


def bracket() -> Solid:
    """An angle, 60 x 40 x 30 mm, with a round hole through its foot's thicker end, lying on its side."""
    outline = np.array([[0, 0], [60, 0], [60, 14], [22, 14], [22, 40], [0, 40.0]])
    center, radius, depth = np.array([11.0, 27.0]), 6.0, 30.0

    def placed(flat: np.ndarray, level: float) -> np.ndarray:
        return np.c_[flat[:, 0] - 30.0, np.full(len(flat), level), flat[:, 1]]

    circles = {
        ArcPlace(face, 1, None): Circle(placed(center[None], level)[0], np.array([0.0, 1.0, 0.0]), radius)
        for face, level in (("f1", -depth / 2), ("f2", depth / 2))
    }
    points = np.concatenate([placed(outline, -depth / 2), placed(outline, depth / 2)])
    axes = np.array([[1.0, 0, 0], [0, 0, 1], [0, 1, 0]])
    return Solid(two_face_boundary(points, [6, 0], circles), Projection("oblique"), "mm", axes=axes)


def on_white(svg: str) -> str:
    """The sheets on white paper, as pages may be dark."""
    head, body = svg.split(">", 1)
    return f'{head}><rect width="100%" height="100%" fill="#ffffff"/>{body}'


def main() -> int:
    PLANS.mkdir(exist_ok=True)
    drawn = s2s.reconstruct(DRAWING, lift={"width": "60mm"})
    part = bracket()
    for name, text in {
        "net": encode(drawn, "net.svg").decode(),
        "views": encode(part, "views.svg").decode(),
        "worksheet": svg_text(worksheet_document(drawn.solids)[0]),
    }.items():
        (PLANS / f"{name}.svg").write_text(on_white(text), "utf-8")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
