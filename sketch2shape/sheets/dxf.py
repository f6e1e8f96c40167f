"""DXF, release 12: the file around entities, and sheets as entities."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from sketch2shape.sheets.sheet import Document, Item, Label, Round

#: $INSUNITS of a DXF file: what one drawing unit is; 0 for pixels, which are no length
_DXF_UNITS = {"px": 0, "in": 1, "mm": 4, "cm": 5, "m": 6}

#: between sheets, millimetres
_GAP = 10.0

#: code of the point of a text that lies at its place
_ANCHORS = {"start": 0, "middle": 1, "end": 2}


def document_dxf(document: Document, unit: str, factor: float = 1.0) -> str:
    """The sheets side by side as DXF with the document's layers, y upward.

    unit   : what one drawing unit is
    factor : drawing units in a millimetre of the sheet
    """
    layers = {layer.name.upper(): "DASHED" if layer.dash else "CONTINUOUS" for layer in document.layers}
    rows: list[str] = []
    for number, sheet in enumerate(document.sheets):
        corner = (number * (document.paper.width + _GAP), document.paper.height)
        rows += [row for item in sheet.items for row in _drawn(item, corner, factor)]
    return dxf_file(layers, rows, unit)


def _drawn(item: Item, corner: tuple[float, float], factor: float) -> list[str]:
    """An item of a sheet whose upper left corner lies there."""
    layer = item.layer.upper()

    def at(code: int, point: Sequence[float]) -> list[str]:
        return dxf_pair(code, factor * (corner[0] + point[0]), factor * (corner[1] - point[1]))

    if isinstance(item, Round):
        return ["0", "CIRCLE", "8", layer, *at(10, item.center.tolist()), "40", f"{factor * item.radius:.6f}"]
    if isinstance(item, Label):
        # both points are given, as the second counts wherever the first end is not meant
        height, place = f"{factor * item.height:.6f}", item.at.tolist()
        turn = ["50", f"{item.angle:.6f}", "72", str(_ANCHORS[item.anchor])]
        return ["0", "TEXT", "8", layer, *at(10, place), "40", height, "1", _plain(item.text), *turn, *at(11, place)]
    if item.filled:
        corners = [item.points[k % len(item.points)].tolist() for k in range(4 if len(item.points) > 3 else 3)]
        corners += corners[-1:] if len(corners) == 3 else []
        a, b, c, d = corners
        # a solid goes from the third corner to the second: its last two are exchanged
        places = (*at(10, a), *at(11, b), *at(12, d), *at(13, c))
        return ["0", "SOLID", "8", layer, *places]
    rows = ["0", "POLYLINE", "8", layer, "66", "1", "70", str(int(item.closed)), *dxf_pair(10, 0.0, 0.0), "30", "0.0"]
    for point in item.points.tolist():
        rows += ["0", "VERTEX", "8", layer, *at(10, point)]
    return [*rows, "0", "SEQEND", "8", layer]


def _plain(text: str) -> str:
    """A text in the characters of release 12, which has codes for three of those that drawings need."""
    marked = text.replace("°", "%%d").replace("±", "%%p").replace("Ø", "%%c")
    return marked.replace("²", "2").replace("³", "3").replace("×", "x").encode("ascii", "replace").decode()


def dxf_pair(code: int, x: float, y: float) -> list[str]:
    """The rows of a point, of the group codes `code` and ten more."""
    return [str(code), f"{x + 0.0:.6f}", str(code + 10), f"{y + 0.0:.6f}"]  # no -0


def dxf_file(layers: Mapping[str, str], entities: Sequence[str], unit: str) -> str:
    """A whole release 12 file around the entities, that names its unit."""
    line_types = ["0", "LTYPE", "2", "CONTINUOUS", "70", "0", "3", "Solid", "72", "65", "73", "0", "40", "0.0"]
    line_types += ["0", "LTYPE", "2", "DASHED", "70", "0", "3", "Dashed", "72", "65", "73", "2", "40", "12.0"]
    line_types += ["49", "8.0", "49", "-4.0"]
    table: list[str] = []
    for name, line_type in layers.items():
        table += ["0", "LAYER", "2", name, "70", "0", "62", "7" if line_type == "CONTINUOUS" else "8", "6", line_type]
    rows = ["0", "SECTION", "2", "HEADER", "9", "$ACADVER", "1", "AC1009"]
    rows += ["9", "$INSUNITS", "70", str(_DXF_UNITS[unit]), "9", "$MEASUREMENT", "70", "0" if unit == "in" else "1"]
    rows += ["0", "ENDSEC"]
    rows += ["0", "SECTION", "2", "TABLES", "0", "TABLE", "2", "LTYPE", "70", "2", *line_types, "0", "ENDTAB"]
    rows += ["0", "TABLE", "2", "LAYER", "70", str(len(layers)), *table, "0", "ENDTAB", "0", "ENDSEC"]
    rows += ["0", "SECTION", "2", "ENTITIES", *entities, "0", "ENDSEC", "0", "EOF"]
    return "\n".join(rows) + "\n"
