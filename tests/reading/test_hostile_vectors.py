"""Vector drawings made to cost: each is refused with an error of ours, by a bound that is looked at first."""

import json

import numpy as np
import pytest

import sketch2shape as s2s
from sketch2shape.reading.read import read_picture

SVG = '<svg xmlns="http://www.w3.org/2000/svg" width="400" height="300">%s</svg>'
INK = '<ink xmlns="http://www.w3.org/2003/InkML">%s</ink>'
LINE = '<path d="M0 0L9 9" stroke="red"/>'
USED = "".join(f'<g id="g{k + 1}">{tenfold}</g>' for k in range(9) for tenfold in [f'<use href="#g{k}"/>' * 10])
LAUGHS = '<!DOCTYPE svg [<!ENTITY a "ha"><!ENTITY b "&a;&a;&a;&a;">]>' + SVG % "<desc>&b;</desc>"
FILLED = {"type": "ellipse", "x": 0, "y": 0, "width": 50, "height": 50, "backgroundColor": "#f00", "fillStyle": "solid"}

HOSTILE = {
    "entities that expand": LAUGHS,
    "one entity used a million times": f'<!DOCTYPE svg [<!ENTITY a "{"a" * 190}">]>' + SVG % ("&a;" * 10_000),
    "an entity used a million times in an attribute": (
        f'<!DOCTYPE svg [<!ENTITY a "{"1 " * 90}">]>' + SVG % f'<path stroke="red" d="M0 0L{"&a;" * 10**6}"/>'
    ),
    "an entity from a file": '<!DOCTYPE svg [<!ENTITY a SYSTEM "/etc/passwd">]>' + SVG % "&a;",
    "use that expands": SVG % (f'<g id="g0">{LINE}</g>' + USED),
    "use of itself": SVG % '<g id="a"><use href="#a"/></g>',
    "groups 10,000 deep": SVG % ("<g>" * 10_000 + LINE + "</g>" * 10_000),
    "10^6 segments": SVG % ('<path stroke="red" d="M0 0' + "l1 1" * 10**6 + '"/>'),
    "10^6 paths": SVG % (LINE * 10**6),
    "huge coordinates": SVG % '<path stroke="red" d="M0 0L1e300 5L-1e300 2"/>',
    "a long style sheet": SVG % f"<style>{'.a{stroke:red}' * 5000}</style>",
    "a rule for all, often, and many elements": SVG % f"<style>{'*{stroke:red}' * 3800}</style>{LINE * 6000}",
    "many classes": SVG % f'<path class="{"a " * 5000}" d="M0 0"/>',
    "10^6 points as JSON": '{"strokes": [[' + "[1,2]," * 10**6 + "[1,2]]]}",
    "10^5 strokes as JSON": '{"strokes": [' + "[[1,2],[3,4]]," * 10**5 + "[[1,2]]]}",
    "lists 10,000 deep": "[" * 10_000 + "]" * 10_000,
    "NaN": '{"strokes": [[[NaN, 1], [2, 3]]]}',
    "wrong types": '{"strokes": {"a": "b"}}',
    "a tangle": json.dumps({"strokes": [np.random.default_rng(0).random((9000, 2)).tolist()]}),
    "more fillings than anyone paints": json.dumps(
        {"type": "excalidraw", "elements": [FILLED | {"x": k % 60, "y": k % 90} for k in range(600)]}
    ),
    "more elements than anyone draws": json.dumps({"type": "excalidraw", "elements": [FILLED] * 20_001}),
    "a million points of ink": INK % ("<trace>" + "1 2," * 10**6 + "</trace>"),
    "groups of ink 10,000 deep": INK % ("<traceGroup>" * 10_000 + "</traceGroup>" * 10_000),
}


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_drawings_are_refused_in_our_words(name):
    with pytest.raises((s2s.LimitError, s2s.UnreadableError)) as caught:
        read_picture(HOSTILE[name].encode())
    assert len(caught.value.message) < 160


@pytest.mark.parametrize(
    "body",
    [
        '<path stroke="red" d="MNaN 0L1e999 5LInfinity 2"/>',
        '<g transform="scale(1e200)"><g transform="scale(1e200)"><path stroke="red" d="M0 0L1 5"/></g></g>',
        '<rect x="a" y="b" width="c" height="d" stroke="e" transform="f(g)"/><path d="qwerty" stroke="url(#x)"/>',
        '<circle r="-5" stroke="red"/><polygon points="1,2,3" stroke="red"/><rect width="5%" stroke="red"/>',
    ],
)
def test_nonsense_in_an_svg_is_no_object(body):
    with pytest.raises(s2s.Sketch2ShapeError):
        s2s.reconstruct((SVG % body).encode())


def test_forms_within_forms_of_a_pdf_are_bounded():
    pytest.importorskip("pypdfium2")
    from synthetic.pdf_files import _document

    forms = tuple(f"/F{k + 1} Do " * 10 for k in range(4))
    with pytest.raises(s2s.LimitError, match="objects"):
        read_picture(_document("/F0 Do " * 10, "0 0 400 300", forms=(*forms, "0 0 m 9 9 l S")))
