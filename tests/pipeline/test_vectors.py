"""Drawings known as lines, end to end: what a pen's order, direction, grouping, place and unit must not change."""

import io

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from sketches import DEPTH, HEXAGON, L_SHAPE, SQUARE, same_object
from solid_lines import prism_lines, prism_strokes

import sketch2shape as s2s
from sketch2shape.model import VectorLine
from sketch2shape.reading.sheet import picture_of
from synthetic.drawing import pen_strokes

CALM = settings(max_examples=12, deadline=None, suppress_health_check=[HealthCheck.too_slow])


@pytest.mark.parametrize("lines", ["wire", "dashed", "removed"])
@pytest.mark.parametrize("face", [SQUARE, HEXAGON], ids=["square", "hexagon"])
def test_lines_become_the_object_they_show_to_a_part_of_a_pixel(lines, face):
    result = s2s.reconstruct(picture_of(prism_lines(face, face + DEPTH, lines)))
    assert same_object(result.objects[0], face, face + DEPTH, 0.5)
    assert result.objects[0].lines == lines
    assert result.objects[0].confidence > 0.9
    assert result.mesh.is_watertight


def test_strokes_are_given_as_arrays():
    strokes = prism_strokes(L_SHAPE, L_SHAPE + DEPTH)
    result = s2s.reconstruct(strokes=strokes)
    assert same_object(result.objects[0], L_SHAPE, L_SHAPE + DEPTH, 0.01)
    again = s2s.reconstruct(strokes=(stroke for stroke in strokes))
    assert np.array_equal(again.objects[0].vertices, result.objects[0].vertices)


def test_a_source_or_strokes_are_given_and_not_both():
    with pytest.raises(s2s.UsageError, match="one of them"):
        s2s.reconstruct()
    with pytest.raises(s2s.UsageError, match="one of them"):
        s2s.reconstruct("a.png", strokes=[])


def test_nothing_drawn_is_a_blank_picture():
    with pytest.raises(s2s.NoObjectError, match="blank"):
        s2s.reconstruct(strokes=[])


@CALM
@given(st.randoms(use_true_random=False), st.sampled_from(["wire", "dashed", "removed"]))
def test_order_and_direction_of_strokes_change_nothing(random, lines):
    strokes = prism_lines(HEXAGON, HEXAGON + DEPTH, lines)
    told = s2s.reconstruct(picture_of(strokes, page=(480, 400)))
    mixed = [s.mapped(np.zeros(2), 1.0) for s in strokes]
    random.shuffle(mixed)
    turned = [type(s)(s.points[::-1] if random.random() < 0.5 else s.points, s.dashed) for s in mixed]
    again = s2s.reconstruct(picture_of(turned, page=(480, 400)))
    assert np.array_equal(told.objects[0].vertices, again.objects[0].vertices)
    assert np.array_equal(told.solids[0].vertices, again.solids[0].vertices)
    assert told.confidences == pytest.approx(again.confidences, abs=1e-6)


@CALM
@given(st.lists(st.floats(0.05, 0.95), min_size=12, max_size=12), st.sets(st.integers(0, 11)))
def test_a_stroke_in_two_pulls_is_the_same_stroke(places, which):
    strokes = prism_strokes(L_SHAPE[:4], L_SHAPE[:4] + DEPTH)
    cut = []
    for k, (a, b) in enumerate(strokes):
        middle = a + places[k] * (b - a)
        cut += [np.array([a, middle]), np.array([middle, b])] if k in which else [np.array([a, b])]
    told, again = s2s.reconstruct(strokes=strokes), s2s.reconstruct(strokes=cut)
    assert same_object(again.objects[0], told.objects[0].f1, told.objects[0].f2, 0.1)
    assert again.objects[0].confidence > 0.9


@CALM
@given(st.permutations(range(18)), st.sets(st.integers(0, 16)))
def test_edges_drawn_in_one_pull_are_the_same_edges(order, joined):
    edges = prism_strokes(HEXAGON, HEXAGON + DEPTH)
    pulls = [edges[order[0]]]
    for k, number in enumerate(order[1:]):
        after = next((e for e in (edges[number], edges[number][::-1]) if np.array_equal(pulls[-1][-1], e[0])), None)
        if k in joined and after is not None:
            pulls[-1] = np.concatenate([pulls[-1], after[1:]])
        else:
            pulls.append(edges[number])
    told, again = s2s.reconstruct(strokes=edges), s2s.reconstruct(strokes=pulls)
    assert same_object(again.objects[0], told.objects[0].f1, told.objects[0].f2, 0.01)
    assert again.confidences == pytest.approx(told.confidences, abs=1e-6)


@pytest.mark.parametrize("lines", ["wire", "removed"])
def test_faces_may_be_drawn_round_in_one_pull_and_edges_twice(lines):
    f1, f2 = HEXAGON, HEXAGON + DEPTH
    each = prism_strokes(f1, f2, lines)
    ring = np.concatenate([f1, f1[:1]])
    result = s2s.reconstruct(strokes=[ring, *each])
    assert same_object(result.objects[0], f1, f2, 0.5)
    assert result.objects[0].confidence > 0.9


@CALM
@given(
    st.floats(-1e4, 1e4),
    st.floats(-1e4, 1e4),
    st.floats(0.01, 100.0),
    st.sampled_from([0.0, 0.5 * np.pi, np.pi, 1.5 * np.pi]),
)
def test_place_size_and_quarter_turns_of_the_drawing_move_the_object_along(x, y, size, angle):
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    strokes = prism_strokes(L_SHAPE, L_SHAPE + DEPTH)
    moved = [size * s @ turn.T + [x, y] for s in strokes]
    result = s2s.reconstruct(strokes=moved)
    drawing = result.picture.drawing
    own = [p / drawing.scale + drawing.origin for p in (result.objects[0].f1, result.objects[0].f2)]
    back = [(p - [x, y]) @ turn / size for p in own]
    obj = s2s.TwoFaceObject(*back)
    assert same_object(obj, L_SHAPE, L_SHAPE + DEPTH, 0.5)


def test_json_strokes_are_read_from_bytes_and_files(tmp_path):
    import json

    strokes = [s.tolist() for s in prism_strokes(SQUARE, SQUARE + DEPTH)]
    data = json.dumps({"strokes": strokes, "width": 480, "height": 400})
    file = tmp_path / "drawing.json"
    file.write_text(data)
    for source in (data.encode(), str(file), io.BytesIO(data.encode()), io.StringIO(data)):
        result = s2s.reconstruct(source)
        assert result.picture.size == (480, 400)
        assert same_object(result.objects[0], SQUARE, SQUARE + DEPTH, 0.01)


def test_the_other_stages_take_vector_drawings_too():
    picture = picture_of(prism_lines(SQUARE, SQUARE + DEPTH), page=(480, 400))
    corners = s2s.detect_corners(picture)
    gap = np.linalg.norm(corners.vertices[:, None] - np.concatenate([SQUARE, SQUARE + DEPTH]), axis=2)
    assert gap.shape == (8, 8)
    assert (gap.min(axis=0) < 1).all()
    assert len(s2s.trace_strokes(picture).ends) == 12
    assert any(same_object(o, SQUARE, SQUARE + DEPTH, 1) for o in s2s.separate_faces(picture))


@pytest.mark.parametrize("lines", ["wire", "dashed", "removed"])
def test_the_clean_drawing_that_is_exported_is_read_again(lines, tmp_path):
    told = s2s.reconstruct(picture_of(prism_lines(HEXAGON, HEXAGON + DEPTH, lines), page=(480, 400)))
    again = s2s.reconstruct(told.export(tmp_path / "clean.svg"))
    assert again.picture.drawing is not None
    assert again.picture.size == (480, 400)
    assert same_object(again.objects[0], HEXAGON, HEXAGON + DEPTH, 1.0)
    assert again.objects[0].confidence > 0.9


@pytest.mark.parametrize(("seed", "index"), [(11, 3), (51, 0)])
def test_what_nobody_sees_follows_from_exact_lines_in_perspective(seed, index):
    strokes, style, truth = pen_strokes("clean_removed_persp", seed, index)
    result = s2s.reconstruct(picture_of([VectorLine(s.path) for s in strokes], page=style.size))
    assert same_object(result.objects[0], np.array(truth["f1"]), np.array(truth["f2"]), 1.0)


def test_a_dashed_edge_that_grazes_the_outline_of_what_hides_it_is_in_its_place():
    strokes, style, truth = pen_strokes("clean_dashed_persp", 77, 4)
    result = s2s.reconstruct(picture_of([VectorLine(s.path, dashed=s.hidden) for s in strokes], page=style.size))
    assert same_object(result.objects[0], np.array(truth["f1"]), np.array(truth["f2"]), 1.0)
