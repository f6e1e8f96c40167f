"""Objects with arcs and with a point, from the drawing to the object."""

from dataclasses import replace
from types import SimpleNamespace

import cv2
import numpy as np
import pytest
from round_sketches import ARCH, CONE, CYLINDER, FACING, PYRAMID, TUBE, arch, drawn, ellipse, half_disc, plate, slot
from sketches import DEPTH, ink_of, paper, prism

from sketch2shape.ink import split_groups
from sketch2shape.search import FoundSweep, find_all, sweep_as_object
from sketch2shape.search.observed import observed
from sketch2shape.search.sweeping import VAIN, _is_vain, _likely_pyramids, find_sweep
from sketch2shape.sweeps import Frame, Outline, Sweep, Way
from sketch2shape.sweeps.outlines import polygon

HALF_CYLINDER = Sweep((half_disc(),), Way(np.array([110.0, -70])))


def found_in(picture):
    ink = ink_of(picture)
    return [sweep_as_object(f, ink) for f in find_all(ink) if isinstance(f, FoundSweep)]


def the_one(picture):
    (found,) = found_in(picture)
    return found


def the_sweep(picture):
    (found,) = find_all(ink_of(picture))
    assert isinstance(found, FoundSweep)
    return found


def shift_of(obj):
    whole = {arc.face: arc.ellipse.center for arc in obj.arcs if arc.hole is None}
    return whole["f2"] - whole["f1"]


@pytest.mark.parametrize("lines", ["wire", "dashed", "removed"])
def test_a_cylinder_is_two_ellipses(lines):
    obj = the_one(drawn(CYLINDER, lines))
    assert [len(obj.f1), len(obj.f2), len(obj.arcs)] == [0, 0, 2]
    assert np.abs(np.abs(shift_of(obj)) - [0, 150]).max() < 3
    assert obj.arcs[0].ellipse.axes == pytest.approx((90, 36), abs=2.5)
    assert len(obj.silhouettes) == 2


def test_hidden_lines_that_are_dashed_are_told_as_dashed():
    assert the_one(drawn(CYLINDER, "dashed")).lines == "dashed"


@pytest.mark.parametrize("lines", ["wire", "dashed", "removed"])
def test_a_tube_has_a_round_hole(lines):
    obj = the_one(drawn(TUBE, lines))
    assert len(obj.holes) == 1
    radii = sorted(arc.ellipse.axes[0] for arc in obj.arcs)
    assert radii == pytest.approx([50, 50, 90, 90], abs=2.5)


@pytest.mark.parametrize("lines", ["dashed", "removed"])
@pytest.mark.parametrize(("sweep", "vertices"), [(ARCH, 4), (HALF_CYLINDER, 2)], ids=["arch", "half cylinder"])
def test_an_arc_is_one_edge(sweep, vertices, lines):
    obj = the_one(drawn(sweep, lines))
    assert len(obj.f1) == len(obj.f2) == vertices
    assert [arc.face for arc in obj.arcs] == ["f1", "f2"]
    assert obj.arcs[0].ellipse.axes[0] == pytest.approx(obj.arcs[0].ellipse.axes[1], rel=0.04)
    assert len(obj.arcs[0].points) >= 9


@pytest.mark.parametrize("lines", ["wire", "dashed", "removed"])
def test_a_cone_comes_to_a_point(lines):
    obj = the_one(drawn(CONE, lines))
    assert obj.is_pointed
    assert np.abs(obj.f2 - [[240, 90]]).max() < 4
    assert obj.arcs[0].ellipse.axes == pytest.approx((90, 36), abs=3)


@pytest.mark.parametrize("lines", ["wire", "dashed"])
def test_a_pyramid_joins_its_base_to_a_point(lines):
    obj = the_one(drawn(PYRAMID, lines))
    assert obj.is_pointed
    assert np.abs(obj.f2 - [[225, 100]]).max() < 4
    off = np.linalg.norm(obj.f1[:, None] - PYRAMID.rings[0].vertices, axis=2)
    assert off.min(axis=1).max() < 4
    assert len(obj.f1) == 4


def test_turning_the_paper_turns_the_answer():
    picture = drawn(ARCH, "removed")
    upright, turned = the_one(picture), the_one(cv2.rotate(picture, cv2.ROTATE_90_CLOCKWISE))
    back = np.stack([turned.f1[:, 1], picture.shape[0] - 1 - turned.f1[:, 0]], axis=1)
    off = np.linalg.norm(back[:, None] - upright.f1, axis=2)
    assert off.min(axis=1).max() < 2


def test_a_box_is_none_of_them():
    f1 = np.array([[120.0, 140], [270, 140], [270, 290], [120, 290]])
    assert found_in(prism(f1, f1 + DEPTH)) == []


@pytest.mark.parametrize(
    "figure",
    [
        lambda p: cv2.ellipse(p, (240, 200), (120, 60), 0, 0, 360, 0, 2, cv2.LINE_AA),
        lambda p: [cv2.circle(p, (240, 200), r, 0, 2, cv2.LINE_AA) for r in (50, 100)],
        lambda p: [cv2.circle(p, (x, 200), 60, 0, 2, cv2.LINE_AA) for x in (180, 300)],
    ],
    ids=["an ellipse alone", "concentric circles", "circles that touch"],
)
def test_circles_alone_are_no_object(figure):
    picture = paper()
    figure(picture)
    assert all(obj.confidence < 0.9 for obj in found_in(picture))


def test_a_wireframe_of_a_rounded_plate_with_holes():
    obj = the_one(drawn(plate(Way(np.array([34.0, -26]))), "wire"))
    assert len(obj.f1) == 8
    assert sorted(arc.hole is None for arc in obj.arcs if arc.face == "f1") == [False, False, True, True, True, True]


@pytest.mark.parametrize("tangents", [False, True], ids=["plain", "lines at smooth joints"])
def test_lines_may_be_drawn_at_smooth_joints(tangents):
    found = the_sweep(drawn(slot(Way(np.array([64.0, -46])), tangents=tangents), "wire"))
    (ring,) = found.sweep.rings
    assert found.sweep.tangents is tangents
    assert len(ring.vertices) == 4
    assert ring.curved.sum() == 2


def test_a_wireframe_may_be_hardly_deeper_than_its_lines_are_wide():
    ring = Outline(FACING, np.array([[60.0, 300], [420, 300]]), np.array([-0.5, 0.0]), np.zeros(2, bool))
    (group,) = split_groups(ink_of(drawn(Sweep((ring,), Way(np.array([0.0, 9.0]))))))
    found = find_sweep(observed(group))
    assert found.unexplained < 0.05
    assert found.confidence > 0.7
    assert [len(ring.vertices) for ring in found.sweep.rings] == [2]


def test_a_thin_wireframe_whose_arcs_are_too_short_to_bow_is_found_by_what_it_covers():
    whole = plate(Way(np.array([10.0, 9])))
    (group,) = split_groups(ink_of(drawn(replace(whole, rings=whole.rings[:1], tangents=True))))
    found = find_sweep(observed(group), arcs=False)
    assert found.unexplained < 0.02
    assert [(len(ring.vertices), ring.curved.sum()) for ring in found.sweep.rings] == [(8, 4)]


def test_a_shift_grows_over_the_face_in_perspective():
    way = Way(np.array([64.0, -46]), slope=np.array([6e-4, 0.0]), origin=np.array([220.0, 220]))
    found = the_sweep(drawn(slot(way), "dashed"))
    assert found.sweep.way.slope == pytest.approx([6e-4, 0], abs=1.5e-4)
    assert found.noise < 1.0


def in_perspective(radius=90.0, ratio=0.35, scale=0.8, slope=2.5e-3):
    """A round face that comes nearer to a centre far below, the lower the more."""
    ring = ellipse(y=100.0, radius=radius, frame=Frame(np.array([0.0, 1.0]), ratio))
    return ring, Way(np.zeros(2), np.array([240.0, 900]), scale, np.array([0.0, slope]), np.array([240.0, 100]))


@pytest.mark.parametrize("lines", ["wire", "dashed", "removed"])
def test_a_cylinder_in_perspective_has_an_ellipse_of_its_own_behind(lines):
    ring, way = in_perspective()
    obj = the_one(drawn(Sweep((ring,), way), lines))
    (there,) = (arc.ellipse for arc in obj.arcs if arc.face == "f2")
    image = Sweep((ring,), way).image(ring)
    assert there.center == pytest.approx(image.middle, abs=3)
    assert there.axes[1] / there.axes[0] == pytest.approx(image.frame.ratio, abs=0.04)
    assert image.frame.ratio > 0.42
    assert obj.confidence > 0.8


def test_a_tumbler_whose_mouth_is_seen_so_flat_that_its_line_hardly_bows():
    ring, way = in_perspective(ratio=0.1, slope=6e-3)
    obj = the_one(drawn(Sweep((ring,), way), "removed"))
    (there,) = (arc.ellipse for arc in obj.arcs if arc.face == "f2")
    assert there.axes[1] / there.axes[0] == pytest.approx(Sweep((ring,), way).image(ring).frame.ratio, abs=0.06)


def test_the_rims_of_a_hole_tell_the_perspective_that_half_a_rim_leaves_open():
    ring, way = in_perspective(ratio=0.8, scale=0.9, slope=1e-3)
    inner = ellipse(y=100.0, radius=60.0, frame=ring.frame)
    obj = the_one(drawn(Sweep((ring, inner), way), "removed"))
    assert len(obj.holes) == 1
    assert obj.confidence > 0.9


def test_an_arc_in_perspective_leans_away_from_the_way_to_the_back():
    ring = arch(Frame(np.array([0.94, -0.34]), 0.75))
    way = Way(np.zeros(2), np.array([900.0, -300]), 0.88, np.array([-6e-4, 3e-4]), ring.middle)
    obj = the_one(drawn(Sweep((ring,), way), "removed"))
    assert len(obj.f1) == 4
    assert len([arc for arc in obj.arcs if arc.face == "f1"]) == 1
    assert obj.confidence > 0.9


def test_the_base_tells_the_roundings_that_are_too_small_to_see_on_top():
    r, k = 22.0, -np.tan(np.pi / 8)
    x, y = np.array([90.0, 90 + r, 370 - r, 370]), np.array([270.0, 270 + r, 370 - r, 370])
    places = [(1, 0), (2, 0), (3, 1), (3, 2), (2, 3), (1, 3), (0, 2), (0, 1)]
    base = Outline(FACING, np.array([[x[i], y[j]] for i, j in places]), k * np.array([0.0, 1] * 4), np.ones(8, bool))
    tapered = Sweep((base,), Way(np.zeros(2), np.array([230.0, -60]), 0.3), is_near=False)
    obj = the_one(drawn(tapered, "dashed"))
    assert len(obj.f1) == 8
    assert len([arc for arc in obj.arcs if arc.face == "f1"]) == 4
    assert obj.confidence > 0.8


@pytest.mark.parametrize(("x", "radius"), [(230, 55), (230, 80), (290, 60), (350, 60), (150, 50)])
def test_two_circles_without_sides_are_no_object(x, radius):
    picture = paper(400, 500)
    for centre, size in (((150, 200), 80), ((x, 200), radius)):
        cv2.circle(picture, centre, size, 0, 2, cv2.LINE_AA)
    assert all(f.confidence < 0.2 for f in find_all(ink_of(picture)))


def test_two_ellipses_that_overlap_without_sides_are_no_cylinder_in_perspective():
    picture = paper(400, 880)
    for centre, axes in (((534, 220), (51, 29)), ((613, 206), (49, 24))):
        cv2.ellipse(picture, centre, axes, 0, 0, 360, 0, 2, cv2.LINE_AA)
    assert all(f.confidence < 0.2 for f in find_all(ink_of(picture)))


def test_a_box_of_straight_lines_keeps_its_round_hole():
    box = polygon(np.array([[100.0, 160], [290, 214], [290, 374], [100, 320]]))
    frame = Frame(np.array([0.93, -0.36]), 0.55)
    obj = the_one(drawn(Sweep((box, ellipse(195.0, 267.0, 42.0, frame)), Way(np.array([150.0, -58]))), "wire"))
    assert len(obj.f1) == 4
    assert len(obj.holes) == 1


def test_letters_beside_a_pyramid_are_not_its_careless_lines():
    picture = drawn(PYRAMID, "dashed")
    for letter, at in zip("PABCD", [(232, 90), (92, 290), (205, 348), (340, 300), (236, 240)], strict=True):
        cv2.putText(picture, letter, at, cv2.FONT_HERSHEY_COMPLEX, 0.7, 0, 1, cv2.LINE_AA)
    found = the_sweep(picture)
    assert found.sweep.way.is_pointed
    assert len(found.sweep.rings[0].vertices) == 4
    # by the noise of the letters the hand would be three times as careless
    assert found.noise < 1.0


def test_a_straight_wireframe_is_searched_for_a_narrow_round_hole():
    box = polygon(np.array([[100.0, 160], [290, 214], [290, 374], [100, 320]]))
    hole = ellipse(195.0, 267.0, 18.0, Frame(np.array([0.93, -0.36]), 0.55))
    found = the_sweep(drawn(Sweep((box, hole), Way(np.array([120.0, -46]))), "wire"))
    assert [len(ring.vertices) for ring in found.sweep.rings] == [4, 0]


@pytest.mark.parametrize("sweep", [TUBE, plate(Way(np.array([34.0, -26])))], ids=["tube", "plate"])
def test_a_hole_found_in_a_round_outline_is_seen_as_that_is(sweep):
    found = the_sweep(drawn(sweep, "removed"))
    assert len(found.sweep.rings) == len(sweep.rings)
    assert len({ring.frame.ratio for ring in found.sweep.rings}) == 1


def test_of_two_bases_that_explain_as_much_the_one_with_fewer_sides_is_likelier():
    (base,) = PYRAMID.rings
    middle = 0.5 * (base.vertices[0] + base.vertices[-1])
    more = replace(PYRAMID, rings=(polygon(np.concatenate([base.vertices, middle[None]])),))
    scene = SimpleNamespace(pyramids=(more, PYRAMID), size=250.0, cells=SimpleNamespace(value_of_lines=lambda _: 0.9))
    assert _likely_pyramids(scene) == [PYRAMID, more]


@pytest.mark.parametrize(("left", "vain"), [(VAIN + 0.01, True), (VAIN, False), (1.0, True), (0.0, False)])
def test_what_leaves_much_is_not_moved_to_the_ink(left, vain):
    assert _is_vain(SimpleNamespace(unexplained=left)) is vain
