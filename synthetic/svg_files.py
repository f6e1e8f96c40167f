"""Strokes as SVG, in the manners of the programs that people draw with."""

from __future__ import annotations

import numpy as np

from sketch2shape.model import Floats
from synthetic.hand import Stroke

Size = tuple[int, int]


def _numbers(points: Floats, places: int = 3) -> list[str]:
    return [f"{x:.{places}f},{y:.{places}f}" for x, y in points]


def inkscape(strokes: list[Stroke], size: Size, _rng: np.random.Generator) -> bytes:
    """Layers, a page in millimetres, relative path data, styles as attributes, a label."""
    w, h = size
    mm = 25.4 / 96
    shift = np.array([11.0, -7.5])

    def path(stroke: Stroke, k: int) -> str:
        at = stroke.path * mm - shift
        steps = np.vstack([at[:1], np.diff(at, axis=0)])
        dash = "stroke-dasharray:1.5, 0.9;stroke-dashoffset:0" if stroke.hidden else "stroke-dasharray:none"
        style = f"fill:none;stroke:#000000;stroke-width:0.5;stroke-linecap:round;{dash}"
        data = "m " + " ".join(_numbers(steps, 5))
        return f'<path style="{style}" d="{data}" id="path{k}" inkscape:connector-curvature="0"/>'

    paths = "\n".join(path(s, k) for k, s in enumerate(strokes))
    return f"""<?xml version="1.0" encoding="UTF-8" standalone="no"?>
<!-- Created with Inkscape (http://www.inkscape.org/) -->
<svg width="{w * mm:.4f}mm" height="{h * mm:.4f}mm" viewBox="0 0 {w * mm:.4f} {h * mm:.4f}" version="1.1" id="svg5"
   xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"
   xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd"
   xmlns="http://www.w3.org/2000/svg" xmlns:svg="http://www.w3.org/2000/svg">
<sodipodi:namedview id="namedview7" pagecolor="#ffffff" inkscape:document-units="mm"/><defs id="defs2"/>
<g inkscape:label="Guides" inkscape:groupmode="layer" id="layer2" style="display:none">
<path style="fill:none;stroke:#000000" d="M 0,0 H 100 V 100"/></g>
<g inkscape:label="Layer 1" inkscape:groupmode="layer" id="layer1" transform="translate({shift[0]},{shift[1]})">
{paths}
<text xml:space="preserve" style="font-size:5px" x="3" y="12" id="text1"><tspan x="3" y="12">box 1</tspan></text>
</g></svg>
""".encode()


def illustrator(strokes: list[Stroke], size: Size, _rng: np.random.Generator) -> bytes:
    """Entities for name spaces, classes in a style sheet, <line> and <polyline>."""
    w, h = size

    def shape(stroke: Stroke) -> str:
        name = "st1" if stroke.hidden else "st0"
        if len(stroke.path) == 2:
            (a, b), (c, d) = stroke.path
            return f'<line class="{name}" x1="{a:.2f}" y1="{b:.2f}" x2="{c:.2f}" y2="{d:.2f}"/>'
        return f'<polyline class="{name}" points="{" ".join(_numbers(stroke.path, 2))} "/>'

    shapes = "\n".join(map(shape, strokes))
    return f"""<?xml version="1.0" encoding="utf-8"?>
<!-- Generator: Adobe Illustrator 16.0.0, SVG Export Plug-In . SVG Version: 6.00 Build 0)  -->
<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd" [
  <!ENTITY ns_extend "http://ns.adobe.com/Extensibility/1.0/">
  <!ENTITY ns_ai "http://ns.adobe.com/AdobeIllustrator/10.0/">
  <!ENTITY ns_svg "http://www.w3.org/2000/svg">
  <!ENTITY ns_xlink "http://www.w3.org/1999/xlink">
]>
<svg version="1.1" id="Layer_1" xmlns:x="&ns_extend;" xmlns:i="&ns_ai;" xmlns="&ns_svg;" xmlns:xlink="&ns_xlink;"
   x="0px" y="0px" width="{w}px" height="{h}px" viewBox="0 0 {w} {h}" enable-background="new 0 0 {w} {h}">
<style type="text/css">
  .st0{{fill:none;stroke:#231F20;stroke-width:2;stroke-miterlimit:10;}}
  .st1{{fill:none;stroke:#231F20;stroke-miterlimit:10;stroke-dasharray:6,4;}}
</style>
<g>
{shapes}
</g>
</svg>
""".encode()


def figma(strokes: list[Stroke], size: Size, _rng: np.random.Generator) -> bytes:
    """A white ground, a clip around all, absolute path data, colours by name."""
    w, h = size

    def path(stroke: Stroke) -> str:
        dash = ' stroke-dasharray="8 6"' if stroke.hidden else ""
        data = "M" + "L".join(f"{x:.6g} {y:.6g}" for x, y in stroke.path)
        return f'<path d="{data}" stroke="black" stroke-width="2"{dash}/>'

    paths = "\n".join(map(path, strokes))
    return f"""<svg width="{w}" height="{h}" viewBox="0 0 {w} {h}" fill="none" xmlns="http://www.w3.org/2000/svg">
<g clip-path="url(#clip0_1_2)">
<rect width="{w}" height="{h}" fill="white"/>
{paths}
</g>
<defs><clipPath id="clip0_1_2"><rect width="{w}" height="{h}" fill="white"/></clipPath></defs>
</svg>
""".encode()


def drawio(strokes: list[Stroke], size: Size, _rng: np.random.Generator) -> bytes:
    """No sheet but the box of what is drawn; labels as HTML with text beside it for programs that know none."""
    w, h = size

    def path(stroke: Stroke) -> str:
        dash = ' stroke-dasharray="3 3"' if stroke.hidden else ""
        data = "M " + " L ".join(f"{x:.2f} {y:.2f}" for x, y in stroke.path)
        return (
            f'<path d="{data}" fill="none" stroke="rgb(0, 0, 0)" stroke-miterlimit="10"{dash} pointer-events="stroke"/>'
        )

    paths = "\n".join(map(path, strokes))
    label = '<div xmlns="http://www.w3.org/1999/xhtml">40 mm</div>'
    return f"""<svg xmlns="http://www.w3.org/2000/svg" style="background-color: rgb(255, 255, 255);"
 xmlns:xlink="http://www.w3.org/1999/xlink" version="1.1" width="{w}px" height="{h}px" viewBox="-0.5 -0.5 {w} {h}">
<defs/><g>
{paths}
<g transform="translate(-0.5 -0.5)"><switch><foreignObject pointer-events="none" width="100%" height="100%">{label}
</foreignObject><text x="60" y="23" fill="#000000" font-family="Helvetica" font-size="12px">40 mm</text></switch></g>
</g></svg>
""".encode()


def outlined(strokes: list[Stroke], size: Size, rng: np.random.Generator) -> bytes:
    """Each stroke as the outline of what a pressed pen leaves, filled, as drawing apps on tablets export it."""
    w, h = size
    paths = [
        f'<path d="{_outline(dash, rng)}" fill="#1d1d1d" stroke="none"/>'
        for stroke in strokes
        for dash in (_dashes(stroke.path) if stroke.hidden else [stroke.path])
    ]
    return f"""<svg xmlns="http://www.w3.org/2000/svg" width="{w}" height="{h}" viewBox="0 0 {w} {h}">
<g transform="matrix(1, 0, 0, 1, 0, 0)">
{chr(10).join(paths)}
</g></svg>
""".encode()


def _dashes(path: Floats) -> list[Floats]:
    """Pieces of 12 pixels with gaps of 8; the last reaches the end."""
    steps = np.r_[0, np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1))]
    count = max(1, round((steps[-1] + 8) / 20))
    starts = np.linspace(0, max(steps[-1] - 12, 0), count)
    out = []
    for start in starts:
        at = np.linspace(start, min(start + 12, steps[-1]), 5)
        out.append(np.c_[np.interp(at, steps, path[:, 0]), np.interp(at, steps, path[:, 1])])
    return out


def _outline(path: Floats, rng: np.random.Generator) -> str:
    """Quadratic curves through the middles of a ring around the stroke, which is thinner at its ends."""
    steps = np.r_[0, np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1))]
    at = np.linspace(0, steps[-1], max(6, int(steps[-1] / 12)))
    fine = np.c_[np.interp(at, steps, path[:, 0]), np.interp(at, steps, path[:, 1])]
    ahead = np.gradient(fine, axis=0)
    normal = np.c_[-ahead[:, 1], ahead[:, 0]] / np.linalg.norm(ahead, axis=1, keepdims=True)
    half = 1.2 + 0.25 * np.sin(np.linspace(0, 6, len(fine)) + rng.uniform(0, 6))
    half[[0, -1]] *= 0.4
    ring = np.vstack([fine + half[:, None] * normal, (fine - half[:, None] * normal)[::-1]])
    middle = (ring + np.roll(ring, -1, axis=0)) / 2
    curves = " ".join(
        f"{a:.2f},{b:.2f} {c:.2f},{d:.2f}"
        for (a, b), (c, d) in zip(np.roll(ring, -1, axis=0), np.roll(middle, -1, axis=0), strict=True)
    )
    return f"M{middle[0][0]:.2f},{middle[0][1]:.2f} Q{curves} Z"


MANNERS = {f"svg/{f.__name__}": f for f in (inkscape, illustrator, figma, drawio, outlined)}
