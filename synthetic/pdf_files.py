"""Strokes as a page of a PDF, in the manners of the programs that print drawings."""

from __future__ import annotations

import zlib

import numpy as np

from sketch2shape.model import Floats
from synthetic.hand import Stroke
from synthetic.json_files import dashed

Size = tuple[int, int]
_HELVETICA = "<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica >>"


def _document(content: str, box: str, *, more: str = "", forms: tuple[str, ...] = (), packed: bool = False) -> bytes:
    """A file with one page; `more` goes into the page, `forms` are its form XObjects F0, F1, ..."""
    names = " ".join(f"/F{k} {6 + k} 0 R" for k in range(len(forms)))
    resources = f"<< /Font << /H 5 0 R >> /XObject << {names} >> >>"
    objects: list[str | bytes] = [
        "<< /Type /Catalog /Pages 2 0 R >>",
        "<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
        f"<< /Type /Page /Parent 2 0 R /MediaBox [{box}] {more} /Resources {resources} /Contents 4 0 R >>",
        _stream(content, "", packed),
        _HELVETICA,
        *(_stream(form, "/Type /XObject /Subtype /Form /BBox [-5000 -5000 5000 5000]", packed) for form in forms),
    ]
    out, places = b"%PDF-1.5\n%\xe2\xe3\xcf\xd3\n", []
    for k, body in enumerate(objects):
        places.append(len(out))
        out += f"{k + 1} 0 obj\n".encode() + (body if isinstance(body, bytes) else body.encode()) + b"\nendobj\n"
    table = "".join(f"{place:010d} 00000 n \n" for place in places)
    trailer = (
        f"xref\n0 {len(objects) + 1}\n0000000000 65535 f \n{table}trailer\n<< /Size {len(objects) + 1} /Root 1 0 R >>\n"
    )
    return out + f"{trailer}startxref\n{len(out)}\n%%EOF\n".encode()


def _stream(content: str, entries: str, packed: bool) -> bytes:
    data = zlib.compress(content.encode(), 9) if packed else content.encode()
    entries += " /Filter /FlateDecode" if packed else ""
    return f"<< {entries} /Length {len(data)} >>\nstream\n".encode() + data + b"\nendstream"


def _path(points: Floats) -> str:
    return " ".join(f"{x:.4f} {y:.4f} {'l' if k else 'm'}" for k, (x, y) in enumerate(points))


def _text(words: str, x: float, y: float) -> str:
    return f"BT /H 12 Tf {x:.1f} {y:.1f} Td ({words}) Tj ET\n"


def tikz(strokes: list[Stroke], size: Size, _rng: np.random.Generator) -> bytes:
    """A figure in a page of text: moved by a matrix, y up, dashes set and unset, states saved and restored."""
    h = size[1]
    flipped = [Stroke(np.c_[s.path[:, 0], h - s.path[:, 1]] * 0.72, s.hidden) for s in strokes]
    lines = "".join(
        f"q {'[3.0 3.0] 0.0 d ' if s.hidden else ''}0.3985 w {_path(s.path - [40, 30])} S Q\n" for s in flipped
    )
    body = f"q 1 0 0 1 112.0 330.0 cm\n0 G 0 g\n{lines}Q\n" + _text("Figure 1: a solid.", 150, 300)
    return _document(body + _text("Find its volume.", 72, 740), "0 0 612 792", packed=True)


def cairo(strokes: list[Stroke], size: Size, _rng: np.random.Generator) -> bytes:
    """All in a form, turned over by a matrix so that y counts downwards; a white ground."""
    w, h = size
    lines = "".join(f"{'[ 6 4] 0 d' if s.hidden else '[] 0.0 d'} {_path(s.path)} S\n" for s in strokes)
    form = f"0 0 0 RG 2 w 1 J 1 j\n{lines}"
    return _document(f"1 0 0 -1 0 {h} cm\n1 1 1 rg 0 0 {w} {h} re f\nq /F0 Do Q\n", f"0 0 {w} {h}", forms=(form,))


def office(strokes: list[Stroke], size: Size, _rng: np.random.Generator) -> bytes:
    """A clip around the page, a coloured label, hairlines, dashes as lines of their own."""
    w, h = size
    pulls = [p for s in strokes for p in (dashed(s.path) if s.hidden else [s.path])]
    lines = "".join(f"{_path(np.c_[p[:, 0], h - p[:, 1]] * 0.75)} S\n" for p in pulls)
    head = f"0.1 w\nq 0 0.028 {w * 0.75:.2f} {h * 0.75:.2f} re W* n\n"
    label = f"0.9 0.2 0.2 rg 20 20 14 9 re f*\n{_text('B', 23, 21)}"
    return _document(f"{head}0 0 0 RG\n{lines}{label}Q\n", f"0 0 {w * 0.75:.2f} {h * 0.75:.2f}", packed=True)


def turned(strokes: list[Stroke], size: Size, _rng: np.random.Generator) -> bytes:
    """A page on its side, cropped out of a larger one that does not begin at (0, 0)."""
    w, h = size
    # shown upright by a quarter turn: what is (x, y) on the sheet lies at (y, x) on the page
    lines = "".join(
        f"{'[5 5] 0 d' if s.hidden else '[] 0 d'} {_path(s.path[:, ::-1] + [100, 50])} S\n" for s in strokes
    )
    crop = f"/Rotate 90 /CropBox [100 50 {100 + h} {50 + w}]"
    return _document(f"1 w 0 G\n{lines}", f"60 20 {160 + h} {120 + w}", more=crop)


def filled(strokes: list[Stroke], size: Size, _rng: np.random.Generator) -> bytes:
    """No strokes at all: each line is a filled quadrilateral, as some printer drivers have it."""
    w, h = size
    pulls = [p for s in strokes for p in (dashed(s.path) if s.hidden else [s.path])]
    bodies = []
    for pull in pulls:
        a, b = np.c_[pull[[0, -1], 0], h - pull[[0, -1], 1]]
        side = np.array([-(b - a)[1], (b - a)[0]]) / max(float(np.linalg.norm(b - a)), 1e-9) * 0.8
        bodies.append(f"{_path(np.array([a + side, b + side, b - side, a - side]))} h f\n")
    return _document("0 g\n" + "".join(bodies) + _text("scale 1:2", 10, 10), f"0 0 {w} {h}")


MANNERS = {f"pdf/{f.__name__}": f for f in (tikz, cairo, office, turned, filled)}
