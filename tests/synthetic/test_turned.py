"""Outlines of lines and arcs, and the truth of curved and pointed objects."""

import cv2
import numpy as np
import pytest
from shapely.geometry import Point, Polygon

from synthetic.drawing import draw
from synthetic.outlines import QUARTER, ROUND, Outline, outline
from synthetic.recipes import RECIPES
from synthetic.turned_scenes import moved_ellipse

CURVED = sorted(c for c, recipe in RECIPES.items() if recipe.curved)


def on_ellipse(points, ellipse):
    """Distance of points from the ellipse, as a fraction of its size: 0 on it."""
    turn = np.radians(ellipse["angle"])
    c, s = np.cos(turn), np.sin(turn)
    along = (np.array(points) - ellipse["center"]) @ np.array([[c, -s], [s, c]])
    return np.abs(np.linalg.norm(along / ellipse["axes"], axis=1) - 1)


def test_a_bulge_of_one_is_a_half_circle_to_the_outside():
    ring = Outline(np.array([[1.0, 0.5], [0.0, 0.5]]), np.array([0.0, 1.0]))
    arc = ring.arcs()[1]
    assert arc.centre == pytest.approx([0.5, 0.5])
    assert arc.radius == pytest.approx(0.5)
    assert arc.at(np.array([0, 0.5, 1])) == pytest.approx(np.array([[0, 0.5], [0.5, 0.0], [1, 0.5]]))
    polygon, _ = ring.chords()
    area = (polygon[:, 0] @ np.roll(polygon[:, 1], -1) - polygon[:, 1] @ np.roll(polygon[:, 0], -1)) / 2
    assert area == pytest.approx(np.pi / 8, rel=0.01)


def test_smooth_joints_are_told_from_corners():
    points = np.array([[0.0, 0], [0.7, 0], [1, 0.3], [1, 1], [0, 1]])
    assert Outline(points, np.array([0, QUARTER, 0, 0, 0])).smooth() == [False, True, True, False, False]
    assert Outline(points, np.array([0, 0.2, 0, 0, 0])).smooth() == [False] * 5


@pytest.mark.parametrize("name", sorted(ROUND))
def test_outlines_have_unit_size_positive_area_and_the_same_area_reversed(name):
    ring = outline(name, np.random.default_rng(3))
    polygon, names = ring.chords()
    assert np.ptp(polygon, axis=0).max() == pytest.approx(1, abs=1e-6)
    x, y = polygon.T
    area = (x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2
    assert area > 0.1
    x, y = ring.reversed().chords()[0].T
    assert (x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2 == pytest.approx(-area)
    assert [n for n in names if n >= 0] == list(range(len(ring.points)))


@pytest.mark.parametrize("category", CURVED)
def test_true_arcs_lie_on_their_ellipses_and_end_in_vertices(category):
    truth = draw(category, 6, 1).truth
    for arc in truth["arcs"]:
        if truth["medium"] != "photo":  # a parallel view and a perspective one draw a circle as an ellipse
            assert on_ellipse(arc["points"], arc["ellipse"]).max() < 0.01
        pair = truth if arc["hole"] is None else truth["holes"][arc["hole"]]
        if arc["from"] is None:
            assert pair[arc["face"]] == []
            assert arc["points"][0] == pytest.approx(arc["points"][-1], abs=0.01)
        else:
            ends = [pair[arc["face"]][arc[k]] for k in ("from", "to")]
            assert np.array(ends) == pytest.approx(np.array([arc["points"][0], arc["points"][-1]]), abs=0.01)
    for arc in truth["solid"]["arcs"]:
        off = np.linalg.norm(np.array(arc["points"]) - arc["center"], axis=1)
        assert off == pytest.approx(arc["radius"], abs=1e-4)
    apex = truth["solid"]["scale"] == 0
    assert (len(truth["f2"]) == 1) == apex
    assert apex or len(truth["f1"]) == len(truth["f2"])


@pytest.mark.parametrize(
    ("category", "shapes", "words"),
    [
        ("arcs_removed", "fillet", "fillet prism"),
        ("plate_dashed", "slot", "slot plate with holes"),
        ("frustum_wire", "half disc", "tapered half disc"),
        ("pyramid_wire", "7", "7-sided pyramid"),
        ("cone_wire", "slot", "cone"),
    ],
)
def test_an_outline_may_be_chosen(category, shapes, words):
    assert draw(category, 6, 1, shapes=shapes).truth["shape"] == words


@pytest.mark.parametrize("lines", ["wire", "dashed", "removed"])
def test_the_face_in_front_is_told_whether_it_lies_above_or_below(lines):
    for index in range(4):
        truth = draw(f"curved_below_{lines}", 6, index).truth
        assert truth["front"] == "f1"
        middle = {
            f: np.mean([p for a in truth["arcs"] if a["face"] == f for p in a["points"]], 0) for f in ("f1", "f2")
        }
        assert middle["f1"][1] > middle["f2"][1] or truth["shape"] == "cone"


def test_the_point_of_a_cone_is_in_front_of_its_base_or_behind():
    assert {draw("cone_dashed", 6, index).truth["front"] for index in range(8)} == {"f1", "f2"}


def test_a_pyramid_shows_its_apex_beside_its_base():
    for index in range(12):
        truth = draw("pyramid_wire", 8, index).truth
        assert not Polygon(truth["f1"]).contains(Point(*truth["f2"][0]))


@pytest.mark.parametrize("category", ["curved_annotated", "curved_sketch"])
def test_every_kind_is_drawn_with_and_without_what_textbooks_add(category):
    shapes = {draw(category, 9, index).truth["shape"].split()[-1] for index in range(len(RECIPES[category].curved))}
    assert len(shapes) > 4


@pytest.mark.parametrize("category", [c for c in CURVED if c.endswith("_wire")])
def test_true_curves_and_outlines_have_ink_under_them(category):
    drawing = draw(category, 6, 0)
    dark = drawing.pixels.min(2) < 170
    away = cv2.distanceTransform((~dark).astype(np.uint8), cv2.DIST_L2, 5)
    paths = [np.array(a["points"]) for a in drawing.truth["arcs"]]
    for ends in drawing.truth["silhouettes"]:
        paths.append(np.linspace(ends[0], ends[1], 20))
    assert paths or category.startswith("pyramid")
    for path in paths:
        at = np.round(path).astype(int)
        assert away[at[:, 1], at[:, 0]].max() < 3


def test_a_cylinder_has_two_outlines_and_two_whole_ellipses():
    truth = draw("cylinder_dashed", 6, 0).truth
    assert truth["f1"] == truth["f2"] == []
    assert [a["face"] for a in truth["arcs"]] == ["f1", "f2"]
    assert len(truth["silhouettes"]) == 2
    assert truth["shape"] == "cylinder"


def test_an_ellipse_moves_as_its_points_do():
    t = np.linspace(0, 2 * np.pi, 30)
    ellipse = {"center": [40.0, 30.0], "axes": [20.0, 10.0], "angle": 30.0}
    c, s = np.cos(np.radians(30)), np.sin(np.radians(30))
    points = np.c_[20 * np.cos(t), 10 * np.sin(t)] @ np.array([[c, s], [-s, c]]) + [40, 30]
    homography = np.array([[1.1, 0.2, 5], [-0.1, 0.9, 3], [1e-3, 5e-4, 1]])
    h = np.c_[points, np.ones(30)] @ homography.T
    moved = moved_ellipse(ellipse, homography)
    assert on_ellipse(h[:, :2] / h[:, 2:], moved).max() < 1e-3
    assert moved["axes"][0] >= moved["axes"][1]
