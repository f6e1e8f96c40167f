"""Pyramids from the corners of a drawing."""

import numpy as np
import pytest
from round_sketches import PYRAMID, drawn, polyline
from sketches import ink_of, line, outline

from sketch2shape.geometry import are_simple
from sketch2shape.strokes import thin, trace_skeleton
from sketch2shape.sweeps import centres, pyramids


def bases(lines):
    skeleton = thin(ink_of(drawn(PYRAMID, lines)))
    size = float(np.hypot(*np.ptp(skeleton.points, axis=0)))
    strokes = trace_skeleton(skeleton, 1.5)
    return list(pyramids([strokes], centres(strokes, size), skeleton, size))


@pytest.mark.parametrize("lines", ["wire", "dashed"])
def test_the_base_is_a_cycle_of_corners_joined_to_the_point(lines):
    found = [s for s in bases(lines) if np.hypot(*(s.way.centre - PYRAMID.way.centre)) < 4 and s.regular is None]
    true = PYRAMID.rings[0].vertices
    off = [
        np.linalg.norm(s.rings[0].vertices[:, None] - true, axis=2).min(axis=1).max()
        for s in found
        if len(s.rings[0].vertices) == 4
    ]
    assert min(off) < 4


def test_of_a_base_half_hidden_the_rest_follows():
    found = [s for s in bases("removed") if s.regular is not None and len(s.rings[0].vertices) == 4]
    true = PYRAMID.rings[0].vertices
    # a parallelogram: the hidden corner lies opposite the near one
    hidden = true[0] + true[2] - true[1]
    assert min(np.hypot(*(s.rings[0].vertices - hidden).T).min() for s in found) < 6


@pytest.mark.parametrize("end", [[160.0, 320.0], [165.0, 300.0]], ids=["crosses", "ends there"])
def test_a_line_to_a_side_makes_no_corner_of_the_base(end):
    picture = drawn(PYRAMID, "wire")
    polyline(picture, np.array([[225.0, 100.0], [165.0, 300.0], end]))
    skeleton = thin(ink_of(picture))
    size = float(np.hypot(*np.ptp(skeleton.points, axis=0)))
    strokes = trace_skeleton(skeleton, 1.5)
    found = list(pyramids([strokes], centres(strokes, size), skeleton, size))
    true = PYRAMID.rings[0].vertices
    off = [np.linalg.norm(true[:, None] - s.rings[0].vertices, axis=2).min(axis=1).max() for s in found]
    sides = [len(s.rings[0].vertices) for s in found]
    assert min(o for o, n in zip(off, sides, strict=True) if n == 4) < 4
    widest = [widest_angle(s.rings[0].vertices) for s in found]
    # a corner on the line of its neighbours has a straight angle, a base that folds back on itself none that is wide
    assert max(widest) < np.pi - 0.1
    assert min(widest) > np.pi / 3 - 0.1


def test_no_base_crosses_itself():
    star = np.array([240.0, 200.0]) + 140 * np.array([[np.sin(t), -np.cos(t)] for t in 2 * np.pi * np.arange(5) / 5])
    picture = outline(star)
    for i in range(5):
        line(picture, star[i], star[(i + 2) % 5])
    skeleton = thin(ink_of(picture))
    strokes = trace_skeleton(skeleton, 1.5)
    found = list(pyramids([strokes], centres(strokes, 280.0), skeleton, 280.0))
    assert len(found) > 4
    assert all(are_simple(s.rings[0].vertices) for s in found)


def widest_angle(ring):
    """The widest angle of a polygon, radians."""
    before, after = np.roll(ring, 1, axis=0) - ring, np.roll(ring, -1, axis=0) - ring
    u, v = (side / np.linalg.norm(side, axis=1)[:, None] for side in (before, after))
    return float(np.arccos(np.clip((u * v).sum(axis=1), -1, 1)).max())


def test_a_base_in_front_is_seen_whole_though_edges_lie_behind_it():
    base = np.array([[300.0, 90], [400, 150], [380, 290], [280, 230]])
    apex = np.array([120.0, 120])
    picture = outline(base)
    for corner in base[[0, 3]]:
        line(picture, apex, corner)
    line(picture, apex, base[2])  # three edges are seen, the fourth is hidden
    skeleton = thin(ink_of(picture))
    size = float(np.hypot(*np.ptp(skeleton.points, axis=0)))
    strokes = trace_skeleton(skeleton, 1.5)
    near = [s for s in pyramids([strokes], centres(strokes, size), skeleton, size) if s.is_near]
    off = [np.linalg.norm(s.rings[0].vertices[:, None] - base, axis=2).min(axis=1).max() for s in near]
    apart = [np.hypot(*(s.way.centre - apex)) for s in near]
    sides = [len(s.rings[0].vertices) for s in near]
    assert any(o < 4 and a < 4 and n == 4 for o, a, n in zip(off, apart, sides, strict=True))
