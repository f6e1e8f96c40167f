"""Regions that the ink encloses, as polygons."""

import cv2
import numpy as np
import pytest
from sketches import DEPTH, L_SHAPE, SQUARE, ink_of, line, outline, paper, prism

from sketch2shape.hypotheses.regions import enclosed_regions, grown_area, reductions, sharpened


def regions_of(picture):
    ink = ink_of(picture)
    return enclosed_regions(ink.mask, ink.pen_width, 1.5)


def off(polygon, ring):
    """Largest distance between the vertices of a polygon and those of a ring."""
    gap = np.linalg.norm(polygon[:, None] - ring[None], axis=2)
    return max(gap.min(axis=0).max(), gap.min(axis=1).max())


@pytest.mark.parametrize("width", [2, 8])
def test_outlines_run_along_the_middle_of_the_strokes(width):
    regions = regions_of(outline(L_SHAPE, width))
    assert len(regions) == 1
    polygon = regions[0].outline
    assert cv2.contourArea(polygon.astype(np.float32)) == pytest.approx(120 * 70 + 60 * 110, rel=0.06)
    assert off(polygon, L_SHAPE) < 2 + 1.5 * width
    assert len(sharpened(polygon, 3 * width)) == 6


def test_a_box_without_hidden_edges_encloses_its_three_faces_the_largest_first():
    regions = regions_of(prism(SQUARE, SQUARE + DEPTH, "removed"))
    assert [len(r.outline) for r in regions] == [4, 4, 4]
    assert off(regions[0].outline, SQUARE) < 3


def test_what_lies_within_a_region_is_its_island():
    hole = SQUARE.mean(axis=0) + 0.4 * (SQUARE - SQUARE.mean(axis=0))
    picture = prism(SQUARE, SQUARE + DEPTH, "removed")
    outline(hole, picture=picture)
    face = next(r for r in regions_of(picture) if r.islands)
    assert off(face.outline, SQUARE) < 3
    assert len(face.islands) == 1
    assert off(face.islands[0], hole) < 5


def test_open_lines_enclose_nothing():
    assert regions_of(line(line(paper(), [50, 50], [400, 60]), [400, 60], [300, 300])) == []
    assert regions_of(paper()) == []


@pytest.mark.parametrize("radius", [3, 11, 40])
def test_an_area_grows_as_opencv_dilates_it_also_at_the_edge_of_the_picture(radius):
    rng = np.random.default_rng(radius)
    part = np.zeros((150, 200), np.uint8)
    cv2.fillPoly(part, [rng.integers(0, 200, (7, 2), dtype=np.int32)], 1)
    part[rng.integers(0, 150, 5), rng.integers(0, 200, 5)] ^= 1
    disc = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * radius + 1, 2 * radius + 1))
    assert (grown_area(part, radius) == cv2.dilate(part, disc)).all()
    assert (1 - grown_area(1 - part, radius) == cv2.erode(part, disc)).all()


def test_a_cut_corner_is_made_sharp_where_its_neighbours_meet():
    cut = np.array([[6.0, 0], [100, 0], [100, 100], [0, 100], [0, 4]])
    assert off(sharpened(cut, 10.0), np.array([[0.0, 0], [100, 0], [100, 100], [0, 100]])) < 1e-9
    assert np.array_equal(sharpened(cut, 5.0), cut)  # no edge is short


def test_a_step_whose_neighbours_meet_behind_it_stays():
    step = np.array([[0.0, 100], [0, 0], [5, 0], [105, -100], [200, 100]])
    assert np.array_equal(sharpened(step, 10.0), step)


def test_a_triangle_stays_however_short_its_edges():
    triangle = np.array([[0.0, 0], [100, 0], [100, 4]])
    assert np.array_equal(sharpened(triangle, 10.0), triangle)


def test_reductions_lose_a_vertex_each_and_little_of_the_area():
    bumped = np.array([[120.0, 140], [190, 137], [270, 140], [270, 290], [120, 290]])
    found = reductions(bumped)
    assert [len(p) for p in found] == [5, 4]
    assert np.array_equal(found[0], bumped)
    bump = 0.5 * 150 * 3
    assert off(found[1], SQUARE) < 6
    assert abs(cv2.contourArea(found[1].astype(np.float32)) - cv2.contourArea(bumped.astype(np.float32))) <= bump
    assert [len(p) for p in reductions(bumped, 0.9)] == [5, 4, 3]
