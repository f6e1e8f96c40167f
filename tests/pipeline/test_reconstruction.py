"""The main job, end to end on drawings made here, and everything that can go wrong with it."""

import io

import cv2
import numpy as np
import pytest
import trimesh
from hypothesis import HealthCheck, Phase, assume, given, settings
from hypothesis import strategies as st
from PIL import Image
from sketches import DEPTH, HEXAGON, L_SHAPE, SQUARE, line, outline, paper, prism, same_object, shrunk

import sketch2shape as s2s
from sketch2shape.command import main
from sketch2shape.model.drawing import ring_edges
from sketch2shape.reading.limits import Limits


@pytest.mark.parametrize("lines", ["wire", "dashed", "removed"])
def test_a_box_becomes_a_watertight_box(lines):
    result = s2s.reconstruct(prism(SQUARE, SQUARE + DEPTH, lines))
    assert len(result.objects) == len(result.solids) == 1
    assert same_object(result.objects[0], SQUARE, SQUARE + DEPTH, 3.0)
    assert result.objects[0].confidence > 0.9
    assert result.mesh.is_watertight
    assert result.mesh.is_winding_consistent
    assert len(result.mesh.vertices) == 8
    assert result.mesh.volume > 0


def test_less_sure_objects_are_left_out_if_asked():
    picture = prism(SQUARE, SQUARE + DEPTH)
    sure = s2s.reconstruct(picture).confidences[0]
    assert len(s2s.reconstruct(picture, min_confidence=sure).objects) == 1
    with pytest.raises(s2s.NoObjectError, match="1 was asked for"):
        s2s.reconstruct(picture, min_confidence=1.0)


def test_the_visible_cap_is_the_front():
    for lines in ("dashed", "removed"):
        obj = s2s.reconstruct(prism(HEXAGON, HEXAGON + DEPTH, lines)).objects[0]
        assert np.linalg.norm(obj.f1.mean(axis=0) - HEXAGON.mean(axis=0)) < 3


def test_the_connector_of_each_face_is_told_and_can_be_chosen():
    picture = prism(HEXAGON, HEXAGON + DEPTH)
    assert s2s.reconstruct(picture).objects[0].connectors == ("split-walk", "split-walk")
    assert s2s.reconstruct(picture, connector="graham").objects[0].connectors == ("graham", "graham")
    assert s2s.reconstruct(picture, connector="ink").objects[0].connectors == ("ink", "ink")
    concave = prism(L_SHAPE, L_SHAPE + DEPTH)
    chosen = s2s.reconstruct(concave, connector="graham").objects[0]
    assert chosen.connectors == ("ink", "ink")
    assert same_object(chosen, L_SHAPE, L_SHAPE + DEPTH)


@pytest.mark.parametrize("detector", ["both", "shi-tomasi", "harris"])
def test_a_detector_that_sees_the_vertices_changes_nothing(detector):
    picture = prism(L_SHAPE, L_SHAPE + DEPTH)
    told, untold = (s2s.reconstruct(picture, detector=d).objects[0] for d in (detector, "auto"))
    assert told.confidence == untold.confidence
    assert np.array_equal(told.vertices, untold.vertices)


@pytest.mark.parametrize("kind", ["bytes", "pil", "gray", "rgb", "rgba", "path", "picture"])
def test_any_kind_of_picture_gives_the_same_answer(kind, tmp_path):
    gray = prism(SQUARE, SQUARE + DEPTH)
    data = cv2.imencode(".png", gray)[1].tobytes()
    (tmp_path / "box.png").write_bytes(data)
    rgb = np.repeat(gray[..., None], 3, axis=2)
    source = {
        "bytes": data,
        "pil": Image.open(io.BytesIO(data)),
        "gray": gray,
        "rgb": rgb,
        "rgba": np.dstack([rgb, np.full_like(gray, 255)]),
        "path": tmp_path / "box.png",
        "picture": s2s.read_picture(gray),
    }[kind]
    found = s2s.reconstruct(source).objects[0]
    assert np.array_equal(found.vertices, s2s.reconstruct(gray).objects[0].vertices)


def test_white_on_black_is_the_same_drawing():
    assert same_object(s2s.reconstruct(255 - prism(SQUARE, SQUARE + DEPTH)).objects[0], SQUARE, SQUARE + DEPTH)


def test_the_time_of_each_stage_is_told():
    timings = s2s.reconstruct(prism(SQUARE, SQUARE + DEPTH)).timings_ms
    assert {"read", "ink", "faces", "lift"} <= set(timings)
    assert all(t >= 0 for t in timings.values())


def test_a_picture_given_as_an_array_stays_as_it_is():
    picture = prism(SQUARE, SQUARE + DEPTH)
    before = picture.copy()
    s2s.reconstruct(picture)
    assert np.array_equal(picture, before)


PYRAMID = line(
    line(line(line(outline(np.array([[120.0, 300], [300, 300], [370, 240], [190, 240]])), [120, 300], [240, 90]),
              [300, 300], [240, 90]), [370, 240], [240, 90]), [190, 240], [240, 90]
)  # fmt: skip
CIRCLE = cv2.circle(paper(), (240, 200), 120, 0, 2, cv2.LINE_AA)
TEXT = cv2.putText(paper(), "no prism", (60, 220), cv2.FONT_HERSHEY_SIMPLEX, 2, 0, 3, cv2.LINE_AA)
NOISE = np.random.default_rng(0).integers(0, 255, (400, 480), np.uint8)


@pytest.mark.parametrize(
    ("picture", "why"),
    [
        (paper(), "blank"),
        (np.zeros((300, 300), np.uint8), "blank"),
        (outline(L_SHAPE), None),
        (outline(HEXAGON - [80, 0], picture=outline(SQUARE[:3] + [170, 60])), None),
        (CIRCLE, None),
        (TEXT, None),
        (NOISE, None),
        (line(paper(), [50, 50], [400, 300]), None),
    ],
    ids=["blank", "black", "polygon", "two polygons", "circle", "text", "noise", "line"],
)
def test_a_picture_without_an_object_is_refused_with_a_reason(picture, why):
    with pytest.raises(s2s.NoObjectError) as error:
        s2s.reconstruct(picture)
    assert error.value.exit_code == 5
    assert why is None or why in error.value.message


def test_a_pyramid_comes_to_a_point():
    (pyramid,) = s2s.reconstruct(PYRAMID).objects
    assert pyramid.is_pointed
    assert pyramid.f2 == pytest.approx(np.array([[240.0, 90]]), abs=3)
    assert len(pyramid.f1) == 4


@pytest.mark.parametrize("source", [b"", b"no picture at all", "/no/such/picture.png", b"\x89PNG\r\n\x1a\n cut off"])
def test_what_is_no_picture_is_unreadable(source):
    with pytest.raises(s2s.UnreadableError) as error:
        s2s.reconstruct(source)
    assert error.value.exit_code == 4


def test_a_picture_over_the_limit_is_refused():
    picture = prism(SQUARE, SQUARE + DEPTH)
    data = cv2.imencode(".png", picture)[1].tobytes()
    for limits in (Limits(max_pixels=1000), Limits(max_bytes=100)):
        with pytest.raises(s2s.LimitError) as error:
            s2s.reconstruct(data, limits=limits)
        assert error.value.exit_code == 6
    assert s2s.reconstruct(data, limits=Limits(max_pixels=picture.size)).objects


def test_an_unknown_connector_is_refused_before_anything_is_read():
    with pytest.raises(s2s.UsageError, match="split-walk"):
        s2s.reconstruct("/no/such/picture.png", connector="spilt-walk")


def test_an_option_in_the_wrong_place_is_told_where_it_belongs():
    for name, place in (("width", "lift=sketch2shape.LiftOptions(width=...)"), ("conector", "connector=...")):
        with pytest.raises(TypeError, match=name) as caught:
            s2s.reconstruct("/no/such/picture.png", **{name: "40mm"})
        assert isinstance(caught.value, s2s.UsageError)
        assert caught.value.advice == place
    with pytest.raises(s2s.UsageError, match="lift is str"):
        s2s.reconstruct("/no/such/picture.png", lift="40mm")


def test_lift_options_may_be_a_dictionary():
    result = s2s.reconstruct(prism(SQUARE, SQUARE + DEPTH), lift={"width": "40mm"})
    assert result.solids[0].dimensions[0] == pytest.approx(40)
    assert result.solids[0].unit == "mm"


def test_an_unknown_detector_is_refused_before_anything_is_read():
    with pytest.raises(s2s.UsageError, match="fast"):
        s2s.reconstruct("/no/such/picture.png", detector="fast")


# ------------------------------------------------------------------ any prism: right, or refused


@st.composite
def convex(draw):
    n = draw(st.integers(3, 7))
    turn = draw(st.floats(0, 2))
    gaps = np.array(draw(st.lists(st.floats(0.7, 1.3), min_size=n, max_size=n)))
    angles = turn + 2 * np.pi * np.cumsum(gaps) / gaps.sum()
    return np.array([210.0, 230]) + [[110, 95]] * np.c_[np.cos(angles), np.sin(angles)]


@st.composite
def rectilinear(draw):
    steps = draw(st.integers(1, 3))
    x = 60 + np.cumsum([draw(st.floats(40, 70)) for _ in range(steps + 1)])
    y = 320 - np.cumsum([draw(st.floats(35, 60)) for _ in range(steps + 1)])
    ring = [[60.0, 320.0]]
    for k in range(steps + 1):
        ring += [[x[k], ring[-1][1]], [x[k], y[k]]] if k == 0 else [[x[k], y[k - 1]], [x[k], y[k]]]
    return np.array([*ring, [60.0, y[-1]]])


def least_turn(f1, f2):
    """The smallest angle (radians) between edges that meet: below some degrees a corner is no corner to the eye."""
    n = len(f1)
    arms = [[r[k - 1] - r[k], r[(k + 1) % n] - r[k], o[k] - r[k]] for r, o in ((f1, f2), (f2, f1)) for k in range(n)]
    sines = [
        abs(u[0] * v[1] - u[1] * v[0]) / (np.linalg.norm(u) * np.linalg.norm(v))
        for three in arms
        for u, v in (three[:2], three[1:], three[::2])
    ]
    return float(np.arcsin(min(sines)))


def least_gap(f1, f2):
    """The smallest distance (pixels) of a vertex from an edge that is not its own: nearer, two lines look like one."""
    v = np.r_[f1, f2]
    edges = ring_edges([len(f1)])
    gaps = []
    for k, p in enumerate(v):
        a, b = v[edges[~(edges == k).any(axis=1)].T]
        s = np.clip(((p - a) * (b - a)).sum(axis=1) / ((b - a) ** 2).sum(axis=1), 0, 1)
        gaps.append(np.linalg.norm(a + s[:, None] * (b - a) - p, axis=1).min())
    return min(gaps)


@settings(
    max_examples=25,
    deadline=None,
    derandomize=True,
    phases=[Phase.generate],
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.filter_too_much],
)
@given(
    st.one_of(convex(), rectilinear()),
    st.floats(0.35, 0.9),
    st.sampled_from([60.0, 90.0, 120.0]),
    st.sampled_from([1.0, 0.75]),
    st.integers(1, 4),
)
def test_any_prism_or_frustum_is_found_exactly_or_refused(f1, slope, depth, taper, width):
    f2 = shrunk(f1, taper, f1.mean(axis=0)) + depth * np.array([np.cos(slope), -np.sin(slope)])
    assume(least_turn(f1, f2) > 0.15 and least_gap(f1, f2) > 3 * width + 5)
    try:
        obj = s2s.reconstruct(prism(f1, f2, width=width, picture=paper(440, 520))).objects[0]
    except s2s.NoObjectError:
        return
    assert same_object(obj, f1, f2, 3.0 + width) or obj.confidence < 0.9


def test_an_isometric_cube_becomes_a_cube_on_the_table(tmp_path):
    """The maker's line: sketch2shape iso_cube.png -o cube.stl --width 40mm."""
    side, c, s = 180.0, np.cos(np.pi / 6), np.sin(np.pi / 6)
    right, left, up = side * np.array([c, -s]), side * np.array([-c, -s]), side * np.array([0.0, -1.0])
    corner = np.array([320.0, 460.0])
    sheet = np.full((640, 640), 255, np.uint8)
    for start, a, b in ((corner + up, right, left), (corner, right, up), (corner, left, up)):
        ring = [start, start + a, start + a + b, start + b]
        cv2.polylines(sheet, [np.round(ring).astype(np.int32)], True, 0, 3, cv2.LINE_AA)
    cv2.imwrite(str(tmp_path / "iso_cube.png"), sheet)
    assert main([str(tmp_path / "iso_cube.png"), "-o", str(tmp_path / "cube.stl"), "--width", "40mm"]) == 0
    mesh = trimesh.load(tmp_path / "cube.stl")
    assert np.ptp(mesh.vertices, axis=0) == pytest.approx(40.0, rel=1e-3)
    assert mesh.vertices[:, 2].min() == pytest.approx(0.0, abs=1e-4)
