"""What people mean by a drawing: the kinds, and drawings that were once read as solids that no one meant."""

import numpy as np
import pytest

from sketch2shape.errors import UsageError
from sketch2shape.lifting import LiftOptions, lift
from sketch2shape.lifting.decision import all_readings
from sketch2shape.lifting.projection import prepare
from sketch2shape.model.drawing import TwoFaceObject

FACE = np.array([[100, 100], [260, 100], [260, 200], [180, 240], [100, 200.0]])
SQUARE = np.array([[0, 0], [200, 0], [200, 200], [0, 200.0]])
L_SHAPE = np.array([[100, 120], [200, 120], [200, 260], [340, 260], [340, 380], [100, 380.0]])


def reading(back, noise=0.0, front=FACE):
    return all_readings(prepare(TwoFaceObject(front, back, noise=noise)))[0]


def test_kinds_of_drawings():
    assert reading(FACE + [70, -40]).family == "oblique"
    assert reading(0.5 * FACE + [150, 20]).name.startswith("tapered")
    assert reading(0.8 * FACE + [110, 10]).name == "one-point"


def test_the_simpler_kind_is_taken_unless_the_noise_rules_it_out():
    back = 0.9 * FACE + [85, -25]
    assert reading(back, noise=8.0).family == "oblique"
    assert reading(back, noise=0.5).name == "one-point"


def test_shaking_that_no_kind_explains_is_left_to_the_simplest():
    back = FACE + [70, -40] + np.random.default_rng(2).normal(0, 3.0, FACE.shape)
    assert reading(back, noise=0.3).family == "oblique"


@pytest.mark.parametrize("scale", [0.94, 0.96, 0.97, 0.985, 1.03])
def test_a_far_face_a_little_off_in_size_is_a_careless_hand(scale):
    back = 100.0 + scale * (SQUARE - 100.0) + [80, -90]
    solid = lift(TwoFaceObject(SQUARE, back))
    assert solid.projection.family == "oblique"
    width, height, depth = solid.dimensions
    assert width / height == pytest.approx(1.0, abs=0.02)
    assert 110 < depth < 260


def test_a_face_too_uneven_for_a_parallelogram_yet_with_parallel_sides_has_a_reading():
    # the far face is 5 px wider at one side only: by its noise no parallelogram, by its directions one
    front = np.array([[60, 182], [60, 441], [318, 441], [318, 182.0]])
    back = np.array([[180, 60], [180, 318], [446, 315], [444, 57.0]])
    solid = lift(TwoFaceObject(front, back, lines="removed", noise=0.3))
    assert solid.projection.family == "oblique"
    assert solid.dimensions[0] / solid.dimensions[1] == pytest.approx(1.0, abs=0.02)


def box_by_hand(text):
    """Twelve edges as pairs of ends, joined where they nearly meet, as the reader joins them."""
    ends = np.array([[float(c) for c in end.split(",")] for edge in text.split() for end in edge.split("-")])
    groups = []
    for end in ends:
        near = [g for g in groups if np.hypot(*(np.mean(g, axis=0) - end)) < 20]
        if near:
            near[0].append(end)
        else:
            groups.append([end])
    return np.array([np.mean(g, axis=0) for g in groups])


BY_HAND = (
    "216,297-481,298 482,302-476,563 478,566-222,558 221,561-221,304 392,185-652,179 645,175-651,442 224,298-390,178 "
    "479,293-652,178 480,561-651,436"
)


@pytest.mark.parametrize("noise", [0.5, 1.5, 3.0])
def test_a_box_by_hand_is_no_bar(noise):
    points = box_by_hand(BY_HAND)
    front, back = points[[0, 1, 2, 3]], points[[4, 5, 6]]
    hidden = back.mean(axis=0, keepdims=True) * 0 + (points[3] + (back - front[:3]).mean(axis=0))
    obj = TwoFaceObject(
        front,
        np.concatenate([back, hidden]),
        lines="removed",
        f2_drawn=np.array([True, True, True, False]),
        noise=noise,
    )
    solid = lift(obj)
    assert solid.projection.family == "oblique"
    assert max(solid.dimensions) < 2.0 * min(solid.dimensions)


@pytest.mark.parametrize("moved", [0.0, 1.0, 2.0, -2.0])
def test_a_pixel_at_one_vertex_does_not_double_the_depth(moved):
    front = L_SHAPE.copy()
    front[2, 0] += moved
    depth = lift(TwoFaceObject(front, L_SHAPE + [90, -80])).dimensions[2]
    assert depth == pytest.approx(241, rel=0.02)


@pytest.mark.parametrize("legs", [(2.0, 1.0), (1.9, 1.0), (2.1, 1.0), (1.0, 2.0)])
def test_three_isometric_directions_outweigh_a_right_angle_in_the_drawing(legs):
    wide, high = 100.0 * legs[0], 100.0 * legs[1]
    c, s = np.cos(np.pi / 6), np.sin(np.pi / 6)
    face = np.array([[0, 0], [wide * c, wide * s], [wide * c, wide * s - high]]) + [100, 300]
    solid = lift(TwoFaceObject(face, face + [104, -60]))
    assert solid.projection.evidence["reading"] == "isometric"
    lengths = np.linalg.norm(np.roll(solid.vertices[:3], -1, axis=0) - solid.vertices[:3], axis=1)
    assert lengths[:2] / lengths[0] == pytest.approx([1.0, high / wide], abs=0.01)


@pytest.mark.parametrize("scale", [1.0, 1.01, 0.99])
def test_an_hour_glass_keeps_its_equal_slopes(scale):
    ring = np.array([[0, 0], [120, 0], [80, 70], [120, 140], [0, 140], [40, 70.0]]) + 200
    middle = ring.mean(axis=0)
    solid = lift(TwoFaceObject(ring, middle + scale * (ring - middle) + [70, -50], noise=0.8))
    assert solid.projection.family == "oblique"
    slopes = np.linalg.norm(np.roll(solid.vertices[:6], -1, axis=0) - solid.vertices[:6], axis=1)[[1, 2, 4, 5]]
    assert slopes / slopes.mean() == pytest.approx(1.0, abs=0.02)


def test_named_views_are_told_by_their_axes():
    flat, steep = np.deg2rad([7.181, 41.41])
    axes = np.array([[np.cos(flat), np.sin(flat)], [0, -1.0]]) * 200
    face = np.array([[0, 0], axes[0], axes[0] + axes[1], axes[1]]) + [100, 400]
    d = 50 * np.array([np.cos(steep), -np.sin(steep)])
    solid = lift(TwoFaceObject(face, face + d))
    assert solid.projection.evidence["reading"] in ("dimetric", "axonometric")
    sides = sorted(solid.dimensions)
    assert sides[1] / sides[2] == pytest.approx(1.0, abs=0.03)
    assert sides[0] / sides[2] == pytest.approx(0.5, abs=0.05)


def test_alternatives_are_the_next_readings_and_can_be_taken():
    obj = TwoFaceObject(SQUARE, SQUARE + [60, -60], noise=1.0)
    first = lift(obj)
    assert first.projection.evidence["reading"] == "cabinet"
    second = first.alternatives[0]
    assert second.reading == "cavalier"
    assert 0.0 < second.probability < 0.5
    taken = lift(obj, options=LiftOptions(reading=2))
    assert taken.dimensions == pytest.approx(second.dimensions)
    assert taken.projection.evidence["reading"] == "cavalier"
    assert [a.reading for a in taken.alternatives].count("cabinet") >= 1


def test_a_reading_that_is_not_there_is_refused_with_what_there_is():
    obj = TwoFaceObject(SQUARE, SQUARE + [60, -60], noise=1.0)
    with pytest.raises(UsageError, match=r"only \d readings"):
        lift(obj, options=LiftOptions(reading=9))
    wedge = TwoFaceObject(FACE, FACE + [70, -40], lines="removed", noise=0.1)
    alone = LiftOptions(reading=2, projection="oblique", depth_ratio=0.5)
    with pytest.raises(UsageError, match="only one reading") as caught:
        lift(wedge, options=alone)
    assert "--necker" in caught.value.advice


def test_a_wireframe_may_be_seen_from_below():
    obj = TwoFaceObject(SQUARE, SQUARE + [70, -70])
    assert any(a.mirrored for a in lift(obj).alternatives)
    known = TwoFaceObject(SQUARE, SQUARE + [70, -70], lines="removed")
    assert not any(a.mirrored for a in lift(known).alternatives)


def test_probabilities_are_of_one_whole():
    obj = TwoFaceObject(FACE, FACE + [70, -40], noise=2.0)
    solid = lift(obj)
    assert sum(a.probability for a in solid.alternatives) < 1.0
    assert 0.0 <= solid.confidence <= 1.0
    ranked = [a.probability for a in solid.alternatives]
    assert ranked == sorted(ranked, reverse=True)
