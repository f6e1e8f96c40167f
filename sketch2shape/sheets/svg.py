"""Sheets as SVG at true size: one beside the other, each a page to Inkscape and a view to browsers.

Each layer is one group over all sheets, so that a cutter's program finds all cuts together. `FILE.svg#sheet_2` shows
the second sheet alone.
"""

from __future__ import annotations

from xml.sax.saxutils import escape, quoteattr

from sketch2shape.sheets.sheet import CAPITALS, Document, Item, Label, Layer, Round, decimal

#: between sheets, millimetres
_GAP = 10.0

_NAMES = (
    'xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" '
    'xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd"'
)


def svg_text(document: Document) -> str:
    """The SVG text."""
    paper, count = document.paper, len(document.sheets)
    step = paper.width + _GAP
    width, height = decimal(count * step - _GAP), decimal(paper.height)
    boxes = [(k * step, f"{decimal(k * step)} 0 {decimal(paper.width)} {height}") for k in range(count)]
    pages = "".join(
        f'<inkscape:page id="page_{k}" x="{decimal(x)}" y="0" width="{decimal(paper.width)}" height="{height}"/>'
        for k, (x, _) in enumerate(boxes, 1)
    )
    views = "".join(f'<view id="sheet_{k}" viewBox="{box}"/>' for k, (_, box) in enumerate(boxes, 1))
    lines = [
        f'<svg {_NAMES} width="{width}mm" height="{height}mm" viewBox="0 0 {width} {height}">',
        f"<title>{escape(document.title)}</title>",
        f'<sodipodi:namedview inkscape:document-units="mm">{pages}</sodipodi:namedview>{views}',
        *(_edge(x, paper.width, paper.height) for x, _ in boxes if count > 1),
    ]
    for layer in document.layers:
        lines.append(_head(layer))
        for k, sheet in enumerate(document.sheets):
            lines += [_drawn(item, layer, k * step) for item in document.of_layer(sheet, layer)]
        lines.append("</g>")
    return "\n".join([*lines, "</svg>"]) + "\n"


def _edge(x: float, width: float, height: float) -> str:
    """The edge of a sheet, where there are several."""
    size = f'width="{decimal(width)}" height="{decimal(height)}"'
    return f'<rect class="sheet" x="{decimal(x)}" y="0" {size} fill="none" stroke="#c0c0c0" stroke-width="0.1"/>'


def _head(layer: Layer) -> str:
    """The opening tag of a layer."""
    dash = f' stroke-dasharray="{" ".join(map(decimal, layer.dash))}"' if layer.dash else ""
    return (
        f'<g id="{layer.name}" inkscape:groupmode="layer" inkscape:label="{layer.name}" fill="none" '
        f'stroke="{layer.color}" stroke-width="{decimal(layer.width)}" stroke-linejoin="round"{dash}>'
    )


def _drawn(item: Item, layer: Layer, left: float) -> str:
    if isinstance(item, Round):
        x, y = item.center
        return f'<circle cx="{decimal(left + x)}" cy="{decimal(y)}" r="{decimal(item.radius)}"/>'
    if isinstance(item, Label):
        return _text(item, layer, left)
    path = "L".join(f"{decimal(left + x)} {decimal(y)}" for x, y in item.points.tolist())
    style = f' fill="{layer.color}" stroke="none"' if item.filled else ""
    return f'<path d="M{path}{"Z" if item.closed else ""}"{style}/>'


def _text(item: Label, layer: Layer, left: float) -> str:
    x, y = decimal(left + item.at[0]), decimal(item.at[1])
    turn = f' transform="rotate({decimal(-item.angle)} {x} {y})"' if item.angle else ""
    size = decimal(item.height / CAPITALS)
    return (
        f'<text x="{x}" y="{y}" font-family="Helvetica, Arial, sans-serif" font-size="{size}" '
        f'text-anchor={quoteattr(item.anchor)} fill="{layer.color}" stroke="none"{turn}>{escape(item.text)}</text>'
    )
