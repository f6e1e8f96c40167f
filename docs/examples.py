"""Examples of the Python API, from a whole reconstruction to single stages; run by the tests.

    python docs/examples.py [FOLDER]      (default: docs/pictures)

Writes the pictures that the documentation shows. The drawing comes from the generator of test drawings, so that nothing
but the package is needed.
"""

from __future__ import annotations

import sys
from collections.abc import Iterable
from pathlib import Path

import numpy as np

import sketch2shape as s2s
from sketch2shape.corrections.corrections import SCHEMA, corrections_from
from sketch2shape.errors import NoObjectError
from sketch2shape.lifting import LiftOptions
from sketch2shape.model.picture import Picture
from sketch2shape.pictures import (
    Entry,
    contact_sheet,
    encode_png,
    folder_index,
    overlay,
    preview_of,
    stage_panels,
    stages,
    viewer,
)
from sketch2shape.ui.examples import EXAMPLES, example_png

SQUARE = np.array([[100.0, 160.0], [300.0, 160.0], [300.0, 340.0], [100.0, 340.0]])


def whole(drawing: bytes) -> s2s.Result:
    """From the bytes of a picture to a solid: the object in the drawing, the solid, and its mesh."""
    result = s2s.reconstruct(drawing)
    found, solid = result.objects[0], result.solids[0]
    print(f"{len(found.f1)} + {len(found.f2)} vertices, {len(found.edges)} edges, confidence {found.confidence:.2f}")
    print(f"read as {solid.projection.family}, watertight: {result.mesh.is_watertight}")
    return result


def single_stages(drawing: bytes) -> None:
    """Each stage alone: ink, strokes, corners, the order of a face's vertices, and lifting."""
    picture = s2s.read_picture(drawing)
    ink = s2s.find_ink(picture)
    strokes, corners = s2s.trace_strokes(ink), s2s.detect_corners(ink)
    print(f"pen {ink.pen_width:.1f} px wide, {len(strokes.ends)} strokes, {len(corners.vertices)} corners")
    order = s2s.connect([[0, 0], [2, 2], [2, 0], [0, 2]], method="auto")
    print(f"four corners in the order {order.tolist()}")
    box = s2s.TwoFaceObject(f1=SQUARE, f2=SQUARE + [45, -30])
    print(f"a box of volume {s2s.lift(box, options=LiftOptions(width='40mm')).volume:.0f} mm3")


def round_and_pointed(path: Path) -> None:
    """Objects with arcs, and those that come to a point, made by hand: a cylinder that stands, and a pyramid."""
    turn = np.linspace(0, 2 * np.pi, 40, endpoint=False)
    rims = [np.array([200.0, y]) for y in (100.0, 260.0)]
    arcs = tuple(
        s2s.DrawnArc(face, None, None, None, s2s.Ellipse(rim, (80.0, 40.0), 0.0), rim + np.c_[80, 40] * circle(turn))
        for face, rim in zip(("f1", "f2"), rims, strict=True)
    )
    cylinder = s2s.lift(s2s.TwoFaceObject(f1=[], f2=[], arcs=arcs), options=LiftOptions(width="40mm"))
    print(f"a cylinder of {' x '.join(f'{d:.1f}' for d in cylinder.dimensions)} mm")
    cylinder.export(path, tolerance="0.02mm")
    base = np.array([[100.0, 300.0], [300.0, 300.0], [370.0, 230.0], [170.0, 230.0]])
    pyramid = s2s.lift(s2s.TwoFaceObject(f1=base, f2=[[235.0, 60.0]]))
    print(f"a pyramid with {len(pyramid.faces)} faces")


def circle(turn: np.ndarray) -> np.ndarray:
    """(n, 2) points of the unit circle at these angles, radians."""
    return np.c_[np.cos(turn), np.sin(turn)]


def correct(result: s2s.Result) -> s2s.Result:
    """Put a vertex right by hand, and say how large the thing is."""
    found = result.objects[0]
    f1 = found.f1 + 0.0
    f1[0] += [4, -3]
    entry = {"f1": f1.tolist(), "f2": found.f2.tolist(), "width": "60mm"}
    given = corrections_from({"schema": SCHEMA, "objects": [entry]})
    return s2s.reconstruct(result.picture, corrections=given)


def refuse(size: int = 80) -> None:
    """A picture without an object is refused, with the reason and what to try."""
    try:
        s2s.reconstruct(np.full((size, size), 255, np.uint8))
    except NoObjectError as error:
        print(f"refused: {error.message}. Try: {error.advice}")


def draw_pictures(result: s2s.Result, folder: Path) -> None:
    """Every picture of one result."""
    (folder / "overlay.png").write_bytes(encode_png(overlay(result)))
    (folder / "stages.png").write_bytes(encode_png(stages(result)))
    (folder / "preview.png").write_bytes(encode_png(preview_of(result)))
    (folder / "viewer.html").write_text(viewer(result, "an example"), "utf-8")
    for k, stage in enumerate(stage_panels(result), 1):
        (folder / f"stage-{k}.png").write_bytes(encode_png(stage.pixels))


def draw_gallery(folder: Path, names: Iterable[str] = EXAMPLES) -> None:
    """Many results at once: a contact sheet and an index."""
    entries = []
    for name in names:
        result = s2s.reconstruct(example_png(name))
        confidence = result.objects[0].confidence
        entries.append(Entry(EXAMPLES[name].title, overlay(result, legend=False), confidence))
        (folder / f"solid-{name}.png").write_bytes(encode_png(preview_of(result, (480, 360))))
    entries.append(Entry("blank.png", message="the picture is blank: no ink was found"))
    (folder / "contact-sheet.png").write_bytes(encode_png(contact_sheet(entries, columns=3)))
    (folder / "index.html").write_text(folder_index(entries, "examples"), "utf-8")


def main(folder: Path, names: Iterable[str] = EXAMPLES) -> None:
    """Run every example and write its pictures."""
    folder.mkdir(parents=True, exist_ok=True)
    drawing = example_png("isometric")
    (folder / "input.png").write_bytes(drawing)
    result = whole(drawing)
    single_stages(drawing)
    round_and_pointed(folder / "cylinder.stl")
    print(f"corrected: {correct(result).solids[0].unit}, {correct(result).objects[0].connectors}")
    refuse()
    draw_pictures(s2s.Result(result.objects, result.solids, Picture(result.picture.pixels, "isometric.png")), folder)
    draw_gallery(folder, names)


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent / "pictures")
