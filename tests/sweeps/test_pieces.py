"""Rings cut into lines and arcs."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from round_sketches import FACING, UPRIGHT, arch, ellipse, half_disc

from sketch2shape.search.sweep_pairs import evenly
from sketch2shape.sweeps import Outline, cut_ring


def best(ring, along=FACING.along, pen=2.0):
    return min(cut_ring(ring, along, pen), key=lambda cut: cut.cost)


def rounded(frame=FACING, radius=30.0):
    """A square with round corners."""
    low, high = 100.0, 300.0
    a, b = low + radius, high - radius
    vertices = [[a, low], [b, low], [high, a], [high, b], [b, high], [a, high], [low, b], [low, a]]
    bulge = float(np.tan(np.pi / 8))
    return Outline(frame, np.array(vertices), np.tile([0.0, -bulge], 4), np.ones(8, bool))


@pytest.mark.parametrize(
    ("ring", "arcs"), [(arch(), 1), (half_disc(), 1), (rounded(), 4)], ids=["arch", "half disc", "rounded"]
)
@pytest.mark.parametrize("pen", [3.0, 4.0])
def test_a_ring_is_cut_where_its_pieces_meet(ring, arcs, pen):
    cut = best(np.round(evenly(ring.line)), pen=pen).outline
    assert len(cut.vertices) == len(ring.vertices)
    assert cut.curved.sum() == arcs
    assert cut.smooth.sum() == ring.smooth.sum()
    off = np.linalg.norm(cut.vertices[:, None] - ring.vertices, axis=2).min(axis=1)
    assert off.max() < 7


def test_a_polygon_has_no_arcs():
    square = np.array([[100.0, 100], [260, 120], [250, 300], [90, 280]])
    cut = best(np.round(evenly(square))).outline
    assert len(cut.vertices) == 4
    assert not cut.curved.any()


def test_an_ellipse_is_one_piece_and_tells_the_frame():
    first = next(iter(cut_ring(np.round(evenly(ellipse().line)), UPRIGHT.along, 2.0)))
    assert first.outline.circle is not None
    assert first.frame.ratio == pytest.approx(0.4, abs=0.01)


def test_many_sides_stay_sides():
    t = np.arange(12) * np.pi / 6
    dozen = np.array([200.0, 200]) + 120 * np.stack([np.cos(t), np.sin(t)], axis=1)
    cuts = [cut.outline for cut in cut_ring(evenly(dozen), FACING.along, 2.0)]
    assert any(len(cut.vertices) == 12 and not cut.curved.any() for cut in cuts)


@given(st.floats(0.3, 0.95), st.floats(0, np.pi))
def test_the_frame_of_a_slanted_arch_is_found(ratio, angle):
    from sketch2shape.sweeps import Frame

    frame = Frame(np.array([np.cos(angle), np.sin(angle)]), ratio)
    flat = FACING.flat(arch().vertices)
    ring = Outline(frame, frame.seen(flat), arch().bulges, arch().smooth)
    cut = best(evenly(ring.line), frame.along)
    assert cut.frame.ratio == pytest.approx(ratio, abs=0.06)
    assert cut.outline.curved.sum() == 1
