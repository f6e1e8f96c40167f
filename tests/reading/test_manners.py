"""Manners of programs that the committed files do not show: the same solid, whatever wrote it."""

import json
import math

import numpy as np
import pytest
from sketches import DEPTH, HEXAGON, same_object
from solid_lines import prism_lines

import sketch2shape as s2s

BACK = HEXAGON + DEPTH
LINES = [(line.points, line.dashed) for line in prism_lines(HEXAGON, BACK, "dashed")]
SVG = '<svg xmlns="http://www.w3.org/2000/svg" %s>%s</svg>'


def tag(ends, more):
    (x1, y1), (x2, y2) = ends.tolist()
    return f'<line x1="{x1:.3f}" y1="{y1:.3f}" x2="{x2:.3f}" y2="{y2:.3f}" {more}/>'


def inkscape():
    """Millimetres, a moved layer, relative paths, a hidden layer."""
    paths = []
    for ends, dashed in LINES:
        (x, y), (dx, dy) = (ends[0] * 25.4 / 96 - [10, 20]).tolist(), ((ends[1] - ends[0]) * 25.4 / 96).tolist()
        dashes = "stroke-dasharray:1.0583,1.0583;stroke-dashoffset:0;" if dashed else ""
        style = f"fill:none;stroke:#000000;stroke-width:0.264583px;{dashes}stroke-opacity:1"
        paths.append(f'<path style="{style}" d="m {x:.6f},{y:.6f} {dx:.6f},{dy:.6f}"/>')
    hidden = '<g style="display:none"><path d="m 0,0 100,100" style="stroke:#000"/></g>'
    return SVG % (
        'width="210mm" height="297mm" viewBox="0 0 210 297"',
        f'{hidden}<g transform="translate(10,20)">{"".join(paths)}</g>',
    )


def illustrator():
    """Classes; dashes that are made to fit begin and end with a piece of their own."""
    sheet = ".st0{fill:none;stroke:#000000;}.st1{fill:none;stroke:#000000;stroke-dasharray:6.0712,5.0593;}"
    parts = []
    for (a, b), dashed in LINES:
        way = (b - a) / np.hypot(*(b - a))
        if dashed:
            parts += [tag(np.array([a, a + 3 * way]), 'class="st0"'), tag(np.array([b - 3 * way, b]), 'class="st0"')]
        rest = np.array([a + 8 * way, b - 3 * way]) if dashed else np.array([a, b])
        parts.append(tag(rest, f'class="st{int(dashed)}"'))
    return SVG % ('x="0px" y="0px" viewBox="0 0 480 400"', f'<style type="text/css">{sheet}</style>{"".join(parts)}')


def figma():
    """Each line lies beside x, by half its width, and is turned into its place, on a white sheet that is clipped."""
    parts = []
    for (a, b), dashed in LINES:
        long = float(np.hypot(*(b - a)))
        (c, s), (x, y) = ((b - a) / long).tolist(), a.tolist()
        dashes = ' stroke-dasharray="6 6"' if dashed else ""
        turn = f"matrix({c:.6f} {s:.6f} {-s:.6f} {c:.6f} {x:.4f} {y:.4f})"
        parts.append(f'<line y1="-0.5" x2="{long:.4f}" y2="-0.5" transform="{turn}" stroke="black"{dashes}/>')
    sheet = '<rect width="480" height="400" fill="white"/>'
    clip = '<defs><clipPath id="clip0"><rect width="480" height="400" fill="white"/></clipPath></defs>'
    body = f'<g clip-path="url(#clip0)">{sheet}{"".join(parts)}</g>{clip}'
    return SVG % ('width="480" height="400" viewBox="0 0 480 400" fill="none"', body)


def drawio():
    """Colours for light and dark pages, words as HTML, half a pixel of border."""
    look = 'fill="none" stroke="#000000" pointer-events="stroke" '
    look += 'style="stroke: light-dark(rgb(0, 0, 0), rgb(255, 255, 255));"'
    dashes = ' stroke-dasharray="3 3"'
    parts = [f"<g><g>{tag(ends, look + dashed * dashes)}</g></g>" for ends, dashed in LINES]
    words = '<switch><foreignObject width="100%" height="100%"><div xmlns="http://www.w3.org/1999/xhtml">A</div>'
    words += '</foreignObject><text x="45" y="34" fill="#000">A</text></switch>'
    return SVG % ('width="480px" height="400px" viewBox="-0.5 -0.5 480 400"', f"<g>{''.join(parts)}{words}</g>")


def affinity():
    """A page in per cent, groups moved away and back, each path from its own origin."""
    parts = []
    for ends, dashed in LINES:
        (x, y), (dx, dy) = ends[0].tolist(), (ends[1] - ends[0]).tolist()
        dashes = "stroke-dasharray:0,4,0,4;" if dashed else ""
        path = f'<path d="M0,0L{dx:.3f},{dy:.3f}" style="fill:none;stroke:black;stroke-width:1px;{dashes}"/>'
        parts.append(f'<g transform="matrix(1,0,0,1,{x:.4f},{y:.4f})">{path}</g>')
    inner = f'<g transform="matrix(1,0,0,1,1234.5,77)">{"".join(parts)}</g>'
    return SVG % (
        'width="100%" height="100%" viewBox="0 0 480 400" style="fill-rule:evenodd;stroke-linecap:round;"',
        f'<g transform="matrix(1,0,0,1,-1234.5,-77)">{inner}</g>',
    )


def excalidraw():
    """Lines that were turned: their points are those of before, about the middle of which they turn."""
    elements = []
    for ends, dashed in LINES:
        middle, angle = ends.mean(axis=0), 0.3
        c, s = math.cos(-angle), math.sin(-angle)
        before = (ends - middle) @ np.array([[c, s], [-s, c]]) + middle
        elements.append(
            {"type": "line", "x": before[0, 0], "y": before[0, 1], "angle": angle, "isDeleted": False}
            | {"strokeStyle": "dashed" if dashed else "solid", "points": [[0, 0], (before[1] - before[0]).tolist()]}
        )
    return json.dumps({"type": "excalidraw/clipboard", "elements": elements, "files": {}})


def tldraw():
    """Arrows without heads, in a group that is turned."""
    c, s = math.cos(0.5), math.sin(0.5)
    records = [{"typeName": "page", "id": "page:p", "index": "a1"}]
    group = {"typeName": "shape", "type": "group", "id": "shape:g", "parentId": "page:p", "index": "a1", "props": {}}
    records.append(group | {"x": 50.0, "y": 20.0, "rotation": 0.5})
    for k, (ends, dashed) in enumerate(LINES):
        (x, y), to = (own := (ends - [50.0, 20.0]) @ np.array([[c, -s], [s, c]]))[0].tolist(), own[1] - own[0]
        heads = {"arrowheadStart": "none", "arrowheadEnd": "none", "dash": "dashed" if dashed else "draw", "bend": 0}
        props = heads | {"start": {"x": 0, "y": 0}, "end": {"x": float(to[0]), "y": float(to[1])}}
        arrow = {"typeName": "shape", "type": "arrow", "id": f"shape:{k}", "parentId": "shape:g", "index": f"a{k:03d}"}
        records.append(arrow | {"x": x, "y": y, "rotation": 0, "props": props})
    return json.dumps({"tldrawFileFormatVersion": 1, "schema": {"schemaVersion": 2}, "records": records})


@pytest.mark.parametrize("manner", [inkscape, illustrator, figma, drawio, affinity, excalidraw, tldraw])
def test_each_program_s_manner_gives_the_same_solid(manner):
    result = s2s.reconstruct(manner().encode())
    drawing = result.picture.drawing
    assert drawing is not None
    (found,) = result.objects
    assert found.lines == "dashed"
    own = [p / drawing.scale + drawing.origin for p in (found.f1, found.f2)]
    shift = (np.concatenate(own).min(axis=0) - np.concatenate([HEXAGON, BACK]).min(axis=0)).round()
    assert same_object(s2s.TwoFaceObject(*own), HEXAGON + shift, BACK + shift, 2.0)
    assert found.confidence > 0.9
