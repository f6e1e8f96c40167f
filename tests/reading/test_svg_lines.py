"""Lines of SVG: every element, units, transforms, styles, what is hidden and what is no line."""

import numpy as np
import pytest

from sketch2shape.errors import LimitError
from sketch2shape.reading.painted import OutlinedStrokesError, visible_lines
from sketch2shape.reading.svg_lines import svg_shapes

HEAD = '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" width="400" height="300">'


def lines(body, size=(400.0, 300.0), head=HEAD):
    return visible_lines(svg_shapes(f"{head}{body}</svg>", size))


def ends(one):
    return one.points[[0, -1]].round(6).tolist()


@pytest.mark.parametrize(
    ("body", "first", "last", "count", "curved"),
    [
        ('<line x1="1" y1="2" x2="3" y2="4" stroke="red"/>', [1, 2], [3, 4], 2, False),
        ('<polyline points="1,2 3,4 5,9" fill="none" stroke="red"/>', [1, 2], [5, 9], 3, False),
        ('<polygon points="1,2 3,4 5,9" fill="none" stroke="red"/>', [1, 2], [1, 2], 4, False),
        ('<rect x="1" y="2" width="30" height="40" fill="none" stroke="red"/>', [1, 2], [1, 2], 5, False),
        ('<circle cx="50" cy="60" r="20" fill="none" stroke="red"/>', [70, 60], [70, 60], 97, True),
        ('<ellipse cx="50" cy="60" rx="20" ry="9" fill="none" stroke="red"/>', [70, 60], [70, 60], 97, True),
        ('<path d="M1 2h10v5l-3-3" fill="none" stroke="red"/>', [1, 2], [8, 4], 4, False),
        ('<path d="M0 0A10 10 0 0 1 20 0" fill="none" stroke="red"/>', [0, 0], [20, 0], 49, True),
        ('<path d="M0 0C0 9 9 9 9 0" fill="none" stroke="red"/>', [0, 0], [9, 0], 25, True),
        ('<path d="M0 0Q0 9 9 0" fill="none" stroke="red"/>', [0, 0], [9, 0], 25, True),
    ],
)
def test_every_shape(body, first, last, count, curved):
    (one,) = lines(body)
    assert ends(one) == [first, last]
    assert (len(one.points), one.curved, one.dashed) == (count, curved, False)


def test_straight_and_curved_parts_of_a_path_are_lines_of_their_own():
    found = lines('<path d="M0 10V90A10 10 0 0 0 10 100H90" fill="none" stroke="red"/>')
    assert [(len(one.points), one.curved) for one in found] == [(2, False), (25, True), (2, False)]


def test_subpaths_are_lines_of_their_own():
    found = lines('<path d="M1 2L3 4M5 6L7 8" stroke="red"/>')
    assert [ends(one) for one in found] == [[[1, 2], [3, 4]], [[5, 6], [7, 8]]]


def test_groups_transforms_and_units():
    inner = '<g transform="scale(2) rotate(90)"><path d="M0 0L1 0" stroke="red"/></g>'
    assert ends(lines(f'<g transform="translate(10,20)">{inner}</g>')[0]) == [[10, 20], [10, 22]]
    head = '<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="50mm" viewBox="10 10 50 25">'
    (one,) = lines('<path d="M10 10L60 35" stroke="red"/>', (100 * 96 / 25.4, 50 * 96 / 25.4), head)
    assert one.points[1] == pytest.approx([100 * 96 / 25.4, 50 * 96 / 25.4])


@pytest.mark.parametrize(
    ("style", "dashed"),
    [
        ('stroke-dasharray="4 2"', True),
        ('stroke-dasharray="4"', True),
        ('style="stroke-dasharray:1.5, 0.9"', True),
        ('stroke-dasharray="4px,2px"', True),
        ('stroke-dasharray="none"', False),
        ('stroke-dasharray=""', False),
        ('stroke-dasharray="4 0"', False),
        ('stroke-dasharray="0 3" stroke-linecap="round"', True),
    ],
)
def test_dashes(style, dashed):
    assert lines(f'<path d="M0 0L90 0" stroke="red" {style}/>')[0].dashed is dashed


def test_dashes_come_from_groups_and_classes():
    assert lines('<g stroke-dasharray="3 3" stroke="red"><path d="M0 0L90 0"/></g>')[0].dashed
    style = "<style>.a{stroke:#000;stroke-dasharray:3,3}</style>"
    assert lines(f'{style}<path class="a" d="M0 0L90 0"/>')[0].dashed


@pytest.mark.parametrize(
    "body",
    [
        '<path d="M0 0L90 0"/>',
        '<path d="M0 0L90 0" stroke="none"/>',
        '<path d="M0 0L90 0" stroke="white"/>',
        '<path d="M0 0L90 0" stroke="red" stroke-width="0"/>',
        '<path d="M0 0L90 0" stroke="red" stroke-opacity="0"/>',
        '<path d="M0 0L90 0" stroke="red" visibility="hidden"/>',
        '<g style="display:none"><path d="M0 0L90 0" stroke="red"/></g>',
        '<defs><path d="M0 0L90 0" stroke="red"/></defs>',
        '<clipPath><path d="M0 0L90 0" stroke="red"/></clipPath>',
        '<marker><path d="M0 0L90 0" stroke="red"/></marker>',
        '<text x="0" y="20" stroke="red">word</text>',
        '<image width="90" height="90" href="data:image/png;base64,AAAA"/>',
    ],
)
def test_what_is_not_seen_or_no_line_is_left_out(body):
    assert lines(body) == []


def test_parts_that_are_used_again():
    body = '<defs><path id="q" d="M0 0L10 0" stroke="red"/></defs><use xlink:href="#q" x="5" y="7"/><use href="#q"/>'
    assert [ends(one) for one in lines(body)] == [[[5, 7], [15, 7]], [[0, 0], [10, 0]]]


def test_parts_that_use_themselves_or_grow_without_end_are_refused():
    with pytest.raises(LimitError):
        lines('<g id="a"><use href="#a"/></g>')
    used = [f'<use href="#g{k}"/>' * 10 for k in range(9)]
    inner = ['<path d="M0 0L9 9" stroke="red"/>', *used]
    groups = "".join(f'<g id="g{k}">{body}</g>' for k, body in enumerate(inner))
    with pytest.raises(LimitError):
        lines(groups)


def test_curves_are_close_to_the_circle():
    (one,) = lines('<circle cx="0" cy="0" r="100" fill="none" stroke="red"/>')
    middles = (one.points[1:] + one.points[:-1]) / 2
    assert np.hypot(*middles.T).min() > 99.9


def test_many_curves_get_fewer_chords_and_too_many_are_refused():
    body = '<path fill="none" stroke="red" d="M0 0' + "q1 1 2 0" * 3000 + '"/>'
    assert len(lines(body)[0].points) == 3000 * 4 + 1
    with pytest.raises(LimitError):
        lines('<path fill="none" stroke="red" d="M0 0' + "l1 1" * 31_000 + '"/>')


def test_paths_without_data_such_as_the_glyph_of_a_space_are_left_out():
    glyphs = '<defs><path id="s"/><path id="a" d="M0 0L9 0L9 9Z"/></defs><use href="#s"/><use href="#a" x="20"/>'
    assert len(lines(f'{glyphs}<path d="M0 0L400 0" stroke="red"/><path d="M0 0L0 300" stroke="red"/>')) == 2


def test_what_the_library_stumbles_over_is_left_to_a_renderer(monkeypatch):
    monkeypatch.setattr("svgelements.SVG.parse", lambda *_a, **_k: [][0])
    with pytest.raises(OutlinedStrokesError):
        lines('<path d="M0 0L400 0" stroke="red"/>')


def test_numbers_that_are_none_are_left_out():
    assert lines('<path d="M0 0L1e999 5" stroke="red"/><path d="MNaN 0L1 5" stroke="red"/>') == []
