"""Hidden parts worked out by hand for figures small enough to check on paper."""

import numpy as np

from synthetic.projecting import oblique
from synthetic.visibility import faces_of, seen_intervals

SQUARE = np.array([[0, 0], [4, 0], [4, 4], [0, 4]], float)


def prism(ring, ratio=0.5, angle=np.pi / 4, depth=4.0):
    solid = np.vstack([np.c_[ring, np.zeros(len(ring))], np.c_[ring, np.full(len(ring), depth)]])
    return oblique("cabinet", ratio, angle)(solid)


def seen(ring, **options):
    return {(a, b): s for a, b, s in seen_intervals(prism(ring, **options), [len(ring)])}


def test_a_box_seen_from_the_upper_right_hides_three_edges_at_its_lower_left_back():
    hidden = {edge for edge, parts in seen(SQUARE).items() if not parts}
    # Back face: 4 upper left, 5 upper right, 6 lower right, 7 lower left (y grows downwards).
    assert hidden == {(6, 7), (7, 4), (3, 7)}


def test_everything_else_of_the_box_is_seen_whole():
    whole = [parts for parts in seen(SQUARE).values() if parts]
    assert len(whole) == 9
    assert all(len(p) == 1 and np.allclose(p[0], (0, 1)) for p in whole)


def test_a_notch_lets_the_viewer_see_part_of_the_back_edge():
    # A U open to the top; depth goes straight up by 1: through the slot the bottom's back edge shows, but the back of
    # the feet is covered by the arms.
    u = np.array([[0, 0], [1, 0], [1, 3], [3, 3], [3, 0], [4, 0], [4, 4], [0, 4]], float)
    parts = seen(u, ratio=1.0, angle=np.pi / 2, depth=1.0)
    assert np.allclose(parts[(10, 11)], [(0, 1)])
    assert parts[(14, 15)] == []
    arm = parts[(9, 10)]
    # The inner wall is seen edge-on from here, so its back edge coincides with it: nothing lies before its upper part.
    assert arm


def test_partly_hidden_edges_end_where_the_cover_ends():
    # An L, depth to the upper right by (1, -1). The foot's upper back edge starts behind the post, at x = 1 + 1, and
    # the post covers nothing beyond x = 1.
    ell = np.array([[0, 0], [1, 0], [1, 3], [4, 3], [4, 4], [0, 4]], float)
    parts = seen(ell, ratio=np.sqrt(2), angle=np.pi / 4, depth=1.0)
    assert np.allclose(parts[(8, 9)], [(0, 1)])
    # Back bottom edge, from (5, 3) to (1, 3): behind the foot everywhere.
    assert parts[(10, 11)] == []
    # Back of the post's left side, from (1, 3) up to (1, -1): behind the front face's right edge x = 1 up to y = 0.
    left = parts[(11, 6)]
    assert all(t0 >= 0.74 for t0, _ in left)


def test_a_hole_shows_the_rim_behind_it():
    hole = np.array([[1, 1], [1, 3], [3, 3], [3, 1]], float)
    flat = np.vstack([SQUARE, hole])
    solid = np.vstack([np.c_[flat, np.zeros(8)], np.c_[flat, np.full(8, 1.0)]])
    projected = oblique("free", 1.0, 0.0)(solid)
    parts = {(a, b): s for a, b, s in seen_intervals(projected, [4, 4])}
    # The hole's back rim is shifted right by 1: its left edge (back of 4-5) shows through the hole, its right does not.
    assert np.allclose(parts[(12, 13)], [(0, 1)])
    assert parts[(14, 15)] == []
    # Its upper edge shows only inside the hole: picture x from 2 to 4, the hole ends at 3.
    assert not any(t1 - t0 > 0.51 for t0, t1 in parts[(15, 12)])


def test_edge_on_faces_are_left_out():
    assert len(faces_of(prism(SQUARE, angle=0.0), [4])) == 4
