"""Pairs of an outline and a way to the back face: what is looked at first, and what leads nowhere."""

from itertools import count, pairwise
from types import SimpleNamespace

import numpy as np
import pytest
from round_sketches import CYLINDER, FACING, drawn, ellipse, plate, slot
from scipy.spatial import cKDTree
from sketches import ink_of

from sketch2shape.ink import split_groups
from sketch2shape.search import sweep_pairs
from sketch2shape.search.observed import observed
from sketch2shape.search.scene import Scene, _runs_along, are_close
from sketch2shape.search.sweep_pairs import (
    BARELY,
    LEAST_SCALE,
    MOST_PRICED,
    SHALLOW,
    SHALLOW_PENS,
    Pair,
    cut,
    evenly,
    is_flat,
    pairs_of,
    pairs_of_rungs,
)
from sketch2shape.sweeps import Loop, Sweep, Way
from sketch2shape.sweeps.outlines import polygon

SIZE = 400.0
FAR_OFF = np.full((400, 480), 100.0, np.float32)
PLAIN = SimpleNamespace(size=SIZE, cells=None, ellipses=[], skeleton=SimpleNamespace(pen_width=2.0, distance=FAR_OFF))
"""A scene without ink, of which nothing is asked but the drawing's size and the pen's."""
RIM = ellipse(y=280.0).line
"""180 pixels wide and 72 high about (240, 280)."""


def scene_of(sweep, lines="wire"):
    """What the search sees of a drawing, and where that lies in the picture."""
    (group,) = split_groups(ink_of(drawn(sweep, lines)))
    seen = observed(group)
    return Scene(seen.drawn, seen.skeleton, seen.view), group.offset


def first_pair(sweep):
    """The likeliest pair of a wireframe, and by how many pixels its lines stray from a rim of the sweep."""
    scene, offset = scene_of(sweep)
    pair = next(pairs_of(scene, bowed=True))[0]
    front = [evenly(ring.line) for ring in sweep.rings]
    rims = cKDTree(np.concatenate([*front, *(line + sweep.way.shift for line in front)]))
    found = np.concatenate([loop.line for loop in (pair.loop, *pair.holes)]) + offset
    return pair, float(rims.query(found)[0].max())


def test_the_first_pair_of_a_wire_plate_is_whole_and_has_its_holes():
    sweep = plate(Way(np.array([34.0, -26])))
    pair, off = first_pair(sweep)
    assert pair.is_whole
    assert len(pair.holes) == 2
    assert np.abs(np.abs(pair.way.shift) - [34, 26]).max() < 1
    assert off < 6
    outside = [pair.loop.inside.holds(hole.probes, 2.0) for hole in pair.holes]
    assert np.all(outside)


def test_close_loops_replace_rough_ones():
    box = polygon(np.array([[100.0, 130], [290, 130], [290, 330], [100, 330]]))
    sweep = Sweep((box, ellipse(195.0, 230.0, 25.0, FACING)), Way(np.array([150.0, -58])))
    pair, off = first_pair(sweep)
    assert len(pair.holes) == 1
    # the rough loop cuts corners, where the lines between the faces lie on themselves for a while
    assert off < 5


def test_a_closed_line_beside_the_outline_is_no_hole():
    way = Way(np.array([90.0, -60]))
    beside = polygon(np.array([[320.0, 190], [400, 190], [400, 270], [320, 270]]))
    pair, _ = first_pair(Sweep((*slot(way).rings, beside, ellipse(220.0, 220.0, 40.0, FACING)), way))
    (hole,) = pair.holes
    assert np.ptp(hole.line, axis=0) == pytest.approx([80, 80], abs=6)


@pytest.fixture
def batches(monkeypatch):
    """The values of the pairs of each batch, where the sources give pairs of these values."""

    def given(*sources, bowed=True, far=30.0):
        lengths = count(far, 10.0)
        for name, values in zip(("_coherent", "_moved", "_drawn_together"), sources, strict=False):
            some = [Pair(Loop(RIM), Way(np.array([0.0, next(lengths)])), value=v) for v in values]
            monkeypatch.setattr(sweep_pairs, name, lambda _, some=some: iter(some))
        return [[pair.value for pair in batch] for batch in pairs_of(PLAIN, bowed=bowed)]

    return given


def test_a_batch_ends_where_a_pair_explains_enough_and_has_those_nearly_as_good(batches):
    assert batches([0.3, 0.85], [0.7, 0.9, 0.75], []) == [[0.85], [0.9, 0.75, 0.7], [0.3]]


def test_what_no_source_explains_is_given_when_all_have_been_asked(batches):
    assert batches([0.3], [0.5], [0.2, 0.45]) == [[0.5, 0.45, 0.3]]


def test_a_batch_is_so_large_and_the_rest_waits_for_the_next(batches):
    many = [0.9] * (MOST_PRICED + 2)
    assert [len(batch) for batch in batches(many, [0.9], [])] == [MOST_PRICED, 3]


def test_of_straight_lines_only_wireframes_are_given_and_less_of_the_ink_is_enough(batches):
    assert batches([0.65, 0.3], [0.9], bowed=False) == [[0.65]]
    assert batches([0.55], [0.9], bowed=False) == []


def test_pairs_that_lead_nowhere_or_say_the_same_are_left_out(batches, monkeypatch):
    assert batches([0.9, 0.85], [], [], far=-5.0) == []
    monkeypatch.setattr(sweep_pairs, "ALIKE", 1.0)
    assert batches([0.85, 0.9], [], []) == [[0.85]]


def test_the_larger_face_is_the_front():
    apart = Way(np.zeros(2), np.array([240.0, -200]), 1.6)
    for swept in cut(Pair(Loop(evenly(RIM)), apart, is_whole=True), PLAIN):
        assert swept.way.scale == pytest.approx(1 / 1.6)
        assert not swept.is_near
        assert np.ptp(swept.rings[0].line, axis=0) == pytest.approx([1.6 * 180, 1.6 * 72], abs=3)


def test_an_outline_that_goes_nowhere_is_not_cut():
    assert list(cut(Pair(Loop(evenly(RIM)), Way(np.array([0.0, 1.0])), is_whole=True), PLAIN)) == []


SQUARE_CORNERS = np.array([[50.0, 50], [150, 50], [150, 150], [50, 150], [50, 50]])


def test_an_ellipse_stands_for_what_the_ink_encloses_there():
    scene, offset = scene_of(CYLINDER, "removed")
    rim = CYLINDER.rings[0].line - offset
    assert len([loop for loop in scene.loops if are_close(loop.line, rim, 6.0)]) == 1


def test_an_ellipse_with_the_box_of_another_outline_does_not_stand_for_it():
    angle = np.linspace(0, 2 * np.pi, 200, endpoint=False)
    circle = 50 * np.stack([np.cos(angle), np.sin(angle)], axis=1) + 100
    square = np.concatenate([np.linspace(a, b, 50) for a, b in pairwise(SQUARE_CORNERS)])
    assert are_close(circle, square, 6.0)
    assert not _runs_along(circle, square, 6.0)
    assert _runs_along(circle, circle + [3.0, -2.0], 6.0)


def point(x, y):
    return Way(np.zeros(2), np.array([x, y]), 0.0)


@pytest.mark.parametrize(
    ("y", "flat"),
    [(280, True), (250, True), (244 - 0.8 * BARELY * SIZE, True), (244 - 1.2 * BARELY * SIZE, False), (90, False)],
    ids=["middle", "inside", "barely outside", "outside", "far away"],
)
def test_a_point_inside_its_round_base_or_barely_outside_leads_nowhere(y, flat):
    assert is_flat(point(240.0, y), RIM, PLAIN) is flat


@pytest.mark.parametrize(("part", "flat"), [(0.9, True), (1.1, False)])
def test_a_short_shift_leads_nowhere_for_the_drawing_and_for_the_pen(part, flat):
    broad = SimpleNamespace(size=SIZE, skeleton=SimpleNamespace(pen_width=8.0))
    assert is_flat(Way(np.array([0.0, part * SHALLOW * SIZE])), RIM, PLAIN) is flat
    assert is_flat(Way(np.array([part * SHALLOW_PENS * 8.0, 0.0])), RIM, broad) is flat


@pytest.mark.parametrize(
    ("scale", "flat"), [(0.9 * LEAST_SCALE, True), (0.4, False), (1.8, False), (1.1 / LEAST_SCALE, True)]
)
def test_a_face_far_smaller_than_the_other_is_a_point(scale, flat):
    assert is_flat(Way(np.zeros(2), np.array([240.0, -200]), scale), RIM, PLAIN) is flat


def test_a_closed_line_is_sampled_a_pixel_apart_all_around():
    square = np.array([[10.0, 10], [30, 10], [30, 50], [10, 50]])
    points = evenly(square)
    assert len(points) == 120
    assert np.hypot(*(np.roll(points, -1, axis=0) - points).T) == pytest.approx(1.0)
    assert len(evenly(square / 20)) == 12


def test_lines_are_close_by_their_boxes_on_all_four_sides():
    for side in ([4.0, 0], [-4.0, 0], [0, 4.0], [0, -4.0]):
        moved = RIM + side
        assert are_close(RIM, moved, 4.1)
        assert not are_close(RIM, moved, 3.9)
    wider = RIM * [1.1, 1.0] - [24.0, 0]
    assert not are_close(RIM, wider, 8.9)
    assert are_close(RIM, wider, 9.1)


def test_shifts_of_rungs_are_asked_where_the_ink_tells_none():
    plain = slot(Way(np.array([60.0, 40.0])), tangents=True)
    scene, _ = scene_of(plain)
    (covered,) = pairs_of_rungs(scene)
    scene.__dict__["shifts"] = np.zeros((0, 2))
    pair, again = pairs_of_rungs(scene)
    assert are_close(again.loop.line, covered.loop.line, 1.0)
    for told in (pair, covered):
        assert np.hypot(*(np.abs(told.way.shift) - [60, 40])) < 3
