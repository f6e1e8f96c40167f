"""Sheets as PDF 1.5, each layer an optional content group that viewers can hide (ISO 32000-1, 8.11).

Lines, circles and Latin text in a standard font need a small and settled part of PDF; the same sheets give the same
bytes.
"""

from __future__ import annotations

import math

from sketch2shape.sheets.sheet import CAPITALS, Document, Item, Label, Layer, Round, Sheet, decimal

#: points in a millimetre
_POINTS = 72.0 / 25.4

#: control points of a Bezier curve for a quarter of a circle, as a part of its radius
_QUARTER = 0.5522847498

#: widths of Helvetica's characters from space to tilde, thousandths of the size of the type (Adobe font metrics)
_WIDTHS = (
    "278 278 355 556 556 889 667 191 333 333 389 584 278 333 278 278 556 556 556 556 556 556 556 556 556 556 278 278 "
    "584 584 584 556 1015 667 667 722 722 667 611 778 722 278 500 667 556 833 722 778 667 778 722 667 611 722 667 944 "
    "667 667 611 278 278 278 469 556 333 556 556 500 556 556 278 556 556 222 222 500 222 833 556 556 556 556 333 500 "
    "278 556 500 722 500 500 500 334 260 334 584"
)
_WIDTH_OF = {chr(32 + k): int(w) for k, w in enumerate(_WIDTHS.split())}

#: width of other characters: that of digits
_OTHER = 556


def pdf_bytes(document: Document) -> bytes:
    """The whole file."""
    layers = range(len(document.layers))
    first_layer, first_page = 4, 4 + len(document.layers)
    pages = [first_page + 2 * k for k in range(len(document.sheets))]
    groups = " ".join(f"{first_layer + k} 0 R" for k in layers)
    named = " ".join(f"/L{k} {first_layer + k} 0 R" for k in layers)
    box = f"0 0 {decimal(document.paper.width * _POINTS)} {decimal(document.paper.height * _POINTS)}"
    objects = [
        f"<< /Type /Catalog /Pages 2 0 R /OCProperties << /OCGs [{groups}] /D << /Order [{groups}] >> >> >>".encode(),
        f"<< /Type /Pages /Count {len(pages)} /Kids [{' '.join(f'{p} 0 R' for p in pages)}] >>".encode(),
        b"<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding >>",
        *(b"<< /Type /OCG /Name (" + _escaped(layer.name) + b") >>" for layer in document.layers),
    ]
    for number, sheet in zip(pages, document.sheets, strict=True):
        resources = f"<< /Font << /F1 3 0 R >> /Properties << {named} >> >>"
        page = f"<< /Type /Page /Parent 2 0 R /MediaBox [{box}] /Resources {resources} /Contents {number + 1} 0 R >>"
        content = _content(document, sheet)
        objects += [page.encode(), b"<< /Length %d >>\nstream\n%b\nendstream" % (len(content), content)]
    objects.append(b"<< /Title (" + _escaped(document.title) + b") /Producer (sketch2shape) >>")
    return _file(objects)


def text_width(text: str, height: float) -> float:
    """Width of a text whose capitals are so high, in the same unit."""
    return sum(_WIDTH_OF.get(c, _OTHER) for c in text) / 1000.0 * height / CAPITALS


def _file(objects: list[bytes]) -> bytes:
    """Numbered objects with the table of where they are; the first is the catalogue, the last the information."""
    data, places = b"%PDF-1.5\n%\xe2\xe3\xcf\xd3\n", []
    for number, body in enumerate(objects, 1):
        places.append(len(data))
        data += b"%d 0 obj\n%b\nendobj\n" % (number, body)
    table = b"".join(b"%010d 00000 n \n" % place for place in places)
    count = len(objects) + 1
    end = b"trailer\n<< /Size %d /Root 1 0 R /Info %d 0 R >>\nstartxref\n%d\n%%%%EOF\n" % (count, count - 1, len(data))
    return data + b"xref\n0 %d\n0000000000 65535 f \n%b" % (count, table) + end


def _content(document: Document, sheet: Sheet) -> bytes:
    """The drawing of a sheet, layer by layer, in millimetres from the upper left corner."""
    high = decimal(document.paper.height * _POINTS)
    parts = [f"{_POINTS:.6f} 0 0 -{_POINTS:.6f} 0 {high} cm 1 J 1 j".encode()]
    for number, layer in enumerate(document.layers):
        parts.append(f"/OC /L{number} BDC {_style(layer)}".encode())
        parts += [_drawn(item) for item in document.of_layer(sheet, layer)]
        parts.append(b"EMC")
    return b"\n".join(parts)


def _style(layer: Layer) -> str:
    red, green, blue = (int(layer.color[k : k + 2], 16) / 255 for k in (1, 3, 5))
    color = f"{decimal(red)} {decimal(green)} {decimal(blue)}"
    return f"{color} RG {color} rg {decimal(layer.width)} w [{' '.join(map(decimal, layer.dash))}] 0 d"


def _drawn(item: Item) -> bytes:
    if isinstance(item, Label):
        return _text(item)
    if isinstance(item, Round):
        x, y = item.center.tolist()
        return _circle(x, y, item.radius).encode()
    steps = [f"{decimal(x)} {decimal(y)} {'l' if k else 'm'}" for k, (x, y) in enumerate(item.points.tolist())]
    return f"{' '.join(steps)} {'f' if item.filled else 's' if item.closed else 'S'}".encode()


def _circle(x: float, y: float, r: float) -> str:
    """Four Bezier curves."""
    steps = [f"{decimal(x + r)} {decimal(y)} m"]
    for k in range(4):
        (a, b), (c, d) = ((math.cos(t), math.sin(t)) for t in (k * math.pi / 2, (k + 1) * math.pi / 2))
        pairs = ((a - _QUARTER * b, b + _QUARTER * a), (c + _QUARTER * d, d - _QUARTER * c), (c, d))
        steps.append(" ".join(f"{decimal(x + r * u)} {decimal(y + r * v)}" for u, v in pairs) + " c")
    return " ".join(steps) + " s"


def _text(item: Label) -> bytes:
    """A text, upright again in a page that is turned over."""
    angle = math.radians(item.angle)
    c, s = math.cos(angle), math.sin(angle)
    back = {"start": 0.0, "middle": 0.5, "end": 1.0}[item.anchor] * text_width(item.text, item.height)
    x, y = item.at[0] - back * c, item.at[1] + back * s
    matrix = f"{decimal(c)} {decimal(-s)} {decimal(-s)} {decimal(-c)} {decimal(x)} {decimal(y)} Tm"
    size = decimal(item.height / CAPITALS)
    return f"BT /F1 {size} Tf {matrix} (".encode() + _escaped(item.text) + b") Tj ET"


def _escaped(text: str) -> bytes:
    """A text between the brackets of a PDF string, in the font's encoding."""
    data = text.encode("cp1252", "replace")
    return data.replace(b"\\", b"\\\\").replace(b"(", b"\\(").replace(b")", b"\\)")
