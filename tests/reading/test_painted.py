"""What is left to see of shapes painted over each other."""

import numpy as np
import pytest

from sketch2shape.errors import UnreadableError
from sketch2shape.model import VectorLine
from sketch2shape.reading.painted import OutlinedStrokesError, Shape, middle_line, visible_lines

GREY, BLACK, WHITE = (200, 200, 200), (0, 0, 0), (255, 255, 255)


def line(*points, **more):
    return Shape((VectorLine(np.array(points, float)),), stroke=BLACK, **more)


def box(x, y, w, h, **more):
    ring = np.array([[x, y], [x + w, y], [x + w, y + h], [x, y + h], [x, y]], float)
    return Shape((VectorLine(ring),), (ring,), **more)


def length(lines):
    return sum(float(np.linalg.norm(np.diff(one.points, axis=0), axis=1).sum()) for one in lines)


def test_a_filled_shape_hides_what_was_painted_before_it_and_not_what_comes_after():
    across, cover = line([0, 50], [100, 50]), box(30, 30, 40, 40, fill=WHITE)
    assert length(visible_lines([across, cover])) == pytest.approx(60, abs=1)
    assert length(visible_lines([cover, across])) == pytest.approx(100)


def test_lines_along_the_border_of_a_filling_are_seen():
    face = box(30, 30, 40, 40, fill=WHITE)
    assert length(visible_lines([line([30, 30], [70, 30]), line([0, 0], [100, 100]), face])) > 40 + 80


def test_filled_faces_without_strokes_have_borders():
    assert length(visible_lines([box(0, 0, 100, 100, fill=GREY), line([100, 0], [150, 50])])) > 460


def test_the_ground_is_no_line_and_its_colour_is_not_seen():
    ground = box(0, 0, 200, 200, fill=GREY)
    white = Shape(line([20, 20], [150, 150]).parts, stroke=WHITE)
    grey = Shape(line([150, 20], [20, 150]).parts, stroke=GREY)
    (seen,) = visible_lines([ground, white, grey])
    assert seen.points.tolist() == [[20, 20], [150, 150]]
    assert visible_lines([white]) == []


def test_arrow_heads_dots_and_letters_are_left_out():
    head = np.array([[50.0, 50], [54, 48], [54, 52]])
    small = Shape((VectorLine(head),), (head,), fill=BLACK)
    assert len(visible_lines([line([0, 0], [200, 0]), line([0, 0], [0, 200]), small])) == 2


def test_a_thin_filled_shape_is_a_line_through_its_middle():
    ring = np.array([[10.0, 9], [110, 9], [110, 11], [10, 11]])
    (seen, _) = visible_lines([Shape((VectorLine(ring),), (ring,), fill=BLACK), line([0, 0], [0, 90])])
    assert seen.points[:, 1] == pytest.approx(10, abs=1.1)
    assert abs(np.ptp(seen.points[:, 0])) > 98


def test_the_outline_of_a_bent_stroke_has_a_middle_too():
    t = np.linspace(0, np.pi / 2, 40)
    arc = np.c_[np.cos(t), np.sin(t)]
    outline = np.concatenate([102 * arc, (98 * arc)[::-1]])
    middle = middle_line(outline, 4.0)
    assert np.hypot(*middle.T) == pytest.approx(100, abs=2.1)


def test_the_outline_of_a_tangle_has_none():
    outer, inner = (
        np.array([[0.0, 0], [100, 0], [100, 100], [0, 100]]),
        np.array([[2.0, 2], [2, 98], [98, 98], [98, 2]]),
    )
    shape = Shape((VectorLine(outer), VectorLine(inner)), (outer, inner), fill=BLACK)
    with pytest.raises(OutlinedStrokesError):
        visible_lines([shape])


def test_dashes_are_those_of_the_shape():
    (seen,) = visible_lines([line([0, 0], [9, 9], dashed=True)])
    assert seen.dashed


def test_nothing_painted_is_nothing_seen():
    assert visible_lines([]) == []
    assert visible_lines([Shape(())]) == []


def test_a_picture_of_many_fillings_is_none_of_lines():
    with pytest.raises(OutlinedStrokesError):
        visible_lines([box(k, k, 9, 9, fill=GREY) for k in range(501)])


def test_coordinates_that_are_huge_are_refused():
    with pytest.raises(UnreadableError, match="huge"):
        visible_lines([line([0, 0], [1e300, 5]), box(0, 0, 9, 9, fill=GREY)])


def test_fillings_that_would_take_long_are_left_to_a_picture():
    turns = np.linspace(0, 2 * np.pi, 96)
    discs = []
    for x in range(300):
        ring = np.c_[x + 60 * np.cos(turns), 60 * np.sin(turns)]
        discs.append(Shape((VectorLine(ring),), (ring,), stroke=BLACK, fill=GREY))
    tangle = np.random.default_rng(1).random((200, 2)) * 400
    knot = Shape((VectorLine(tangle),), (tangle,), stroke=BLACK, fill=GREY)
    for shapes in (discs, [line([0, 0], [9, 9]), knot]):
        with pytest.raises(OutlinedStrokesError):
            visible_lines(shapes)


def test_what_many_rings_fill_is_by_the_rule_of_even_and_odd():
    rings = [box(5 * k, 5 * k, 100 - 10 * k, 100 - 10 * k).rings[0] for k in range(5)]
    cover = Shape((VectorLine(rings[0]),), tuple(rings), fill=GREY)
    crossing = line([-10, 50], [110, 50])
    # stripes 5 wide are filled on both sides, and the square in the middle
    outside = 20.0 + 2 * 2 * 5.0
    own = sum(length([VectorLine(ring)]) for ring in rings)
    assert length(visible_lines([crossing, cover])) == pytest.approx(outside + own, abs=6)
