"""Draw the gallery of docs/lifting.md: ambiguous drawings, what each may be of, and what is taken.

    python scripts/lifting_gallery.py        docs/lifting/*.svg written, the table printed as Markdown

`scripts/evaluate_lifting.py` puts the table into the page.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from repository import ROOT

from sketch2shape.lifting import lift
from sketch2shape.model.arrays import Floats
from sketch2shape.model.drawing import TwoFaceObject
from sketch2shape.model.solid import Solid

FOLDER = ROOT / "docs" / "lifting"

_COS, _SIN = float(np.cos(np.pi / 6)), 0.5
_SQUARE = np.array([[0, 0], [120, 0], [120, 120], [0, 120.0]])
_L = np.array([[0, 0], [60, 0], [60, 90], [150, 90], [150, 160], [0, 160.0]])


@dataclass(frozen=True)
class Example:
    """An ambiguous drawing.

    name : of its picture
    obj  : the drawing
    why  : what decides
    """

    name: str
    obj: TwoFaceObject
    why: str


def examples() -> list[Example]:
    """Twelve of them."""
    iso = np.array([[_COS, _SIN], [0, -1.0]])
    wedge = np.array([[0, 0], [200 * _COS, 100], [200 * _COS, 0.0]])
    back = 60 + 0.96 * (_SQUARE - 60) + [55, -60]
    rng = np.random.default_rng(3)
    shaky = _SQUARE * [1.6, 1.1]
    tall = 60 + 0.6 * (_SQUARE - 60)
    leaning = np.array([[0, 0], [130, 0], [170, -80], [40, -80.0]])
    kite = np.array([[0, 0], [130, 70], [20, 150], [-90, 60.0]])
    made = [
        ("cube", _SQUARE, _SQUARE + [60, -60], "receding edges of 0.7 of a side: the usual half scale is nearer"),
        ("cavalier", _SQUARE, _SQUARE + [85, -85], "receding edges just as long as a side: drawn at full scale"),
        ("careless", _SQUARE, back, "a far face at 96 % is a careless hand, not a slab in perspective"),
        ("one-point", _SQUARE, 60 + 0.78 * (_SQUARE - 60) + [70, -60], "at 78 % it is a face farther away"),
        ("tapered", _SQUARE, tall + [70, -60], "at 60 % no box in perspective looks so: it tapers"),
        (
            "isometric",
            *_pair(np.array([[0, 0], [1, 0], [1, 1], [0, 1.0]]) @ iso * 120, [104, -60]),
            "three axes at 30, 90 and 150 degrees",
        ),
        ("wedge", wedge, wedge + [104, -60], "a right angle in the drawing, but all three isometric axes"),
        (
            "shaky",
            shaky + rng.normal(0, 4, (4, 2)),
            shaky + [75, -70] + rng.normal(0, 4, (4, 2)),
            "level and plumb edges: a box by hand, not a bar",
        ),
        ("letter", _L, _L + [70, -62], "the depth is free: a long and a short one are told"),
        ("leaning", leaning, leaning + [52, -52], "a level edge speaks for a parallelogram in its true shape"),
        (
            "standing",
            kite * [1, 0.6],
            kite * [1, 0.6] + [0, 130],
            "plumb edges stand; no right angle fixes the slant of the top",
        ),
        (
            "flat",
            *_pair(np.array([[0, 0], [200, 60], [200, -40], [0, -100.0]]), [60, -35]),
            "two full axes, the third one drawn short: no named view, but one that stands",
        ),
    ]
    return [
        Example(name, TwoFaceObject(a, np.asarray(b), noise=1.0 if name != "shaky" else 2.5), why)
        for name, a, b, why in made
    ]


def _pair(face: Floats, d: list[float]) -> tuple[Floats, Floats]:
    return face, face + d


def picture(obj: TwoFaceObject) -> str:
    """The drawing as a small SVG."""
    points = obj.vertices - obj.vertices.min(axis=0) + 10
    width, height = points.max(axis=0) + 10
    lines = "".join(
        f"M{x:.1f} {y:.1f}L{u:.1f} {v:.1f}" for (x, y), (u, v) in (points[[a, b]].tolist() for a, b in obj.edges)
    )
    head = f'<svg xmlns="http://www.w3.org/2000/svg" width="{0.5 * width:.0f}" height="{0.5 * height:.0f}"'
    return (
        f'{head} viewBox="0 0 {width:.0f} {height:.0f}"><rect width="100%" height="100%" fill="white"/>'
        f'<path d="{lines}" fill="none" stroke="black" stroke-width="3" stroke-linecap="round"/></svg>\n'
    )


def row(example: Example, solid: Solid) -> str:
    """One row of the table: picture, what is taken, what else it may be, why."""
    rest = sum(a.probability for a in solid.alternatives)
    taken = _told(solid.projection.evidence["reading"], False, solid.dimensions, 1.0 - rest)
    others = (
        "<br>".join(_told(a.reading, a.mirrored, a.dimensions, a.probability) for a in solid.alternatives) or "none"
    )
    name = example.name
    return f"| ![{name}](lifting/{name}.svg) | {taken} | {others} | {solid.confidence:.2f} | {example.why} |"


def _told(reading: str, mirrored: bool, size: tuple[float, float, float], probability: float) -> str:
    words = reading + (", from below" if mirrored else "")
    return f"{words}: {' x '.join(f'{s:.0f}' for s in size)} ({probability:.0%})"


def gallery() -> str:
    """The table as Markdown; the pictures are written."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    rows = ["| drawing | taken | it may also be | sure | why |", "|---|---|---|---|---|"]
    for example in examples():
        (FOLDER / f"{example.name}.svg").write_text(picture(example.obj))
        rows.append(row(example, lift(example.obj)))
    return "\n".join(rows) + "\n"


if __name__ == "__main__":
    print(gallery())
