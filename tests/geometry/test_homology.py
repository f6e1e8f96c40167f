"""The plane map between the faces: recovered exactly from points it was applied to."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketch2shape.geometry import homology

POINTS = np.array([[100.0, 120], [260, 110], [300, 240], [180, 310], [90, 230]])
number = st.floats(-1, 1)


def perspective(centre, axis, size=300.0):
    """Straight from the definition, I + v a^T in units of the drawing: fixes the centre and all points of the axis."""
    v, a = np.array([*centre, 1.0]), np.array([*axis, 0.35])
    norm = np.array([[1 / size, 0, -200 / size], [0, 1 / size, -200 / size], [0, 0, 1]])
    return np.linalg.inv(norm) @ (np.eye(3) + np.outer(v, a)) @ norm


@given(number, number, number, number)
def test_a_homology_is_recovered_from_its_points(cx, cy, ax, ay):
    if np.hypot(cx, cy) < 0.3:
        return  # connecting lines that all but meet inside the face tell the centre badly
    h = perspective((3 * cx, 3 * cy), (0.15 * ax, 0.15 * ay))
    image = homology.apply(h, POINTS)
    if not np.isfinite(image).all() or np.linalg.norm(image - POINTS, axis=1).min() < 20:
        return
    again = homology.homology(POINTS, image)
    assert np.abs(homology.apply(again, POINTS) - image).max() < 1e-4
    # three points are enough, and say where all others go
    three = homology.homology(POINTS[[0, 2, 3]], image[[0, 2, 3]])
    assert np.abs(homology.apply(three, POINTS) - image).max() < 1e-3


@given(st.floats(0.2, 3), st.floats(-200, 200), st.floats(-200, 200))
def test_a_similarity_is_recovered_from_two_points(scale, x, y):
    image = scale * POINTS + [x, y]
    h = homology.similarity(POINTS[1:3], image[1:3])
    assert np.abs(homology.apply(h, POINTS) - image).max() < 1e-6


def test_a_translation_is_both_a_similarity_and_a_homology():
    image = POINTS + [70, -40]
    for h in (
        homology.translation(np.array([70.0, -40])),
        homology.similarity(POINTS, image),
        homology.homology(POINTS, image),
    ):
        assert np.abs(homology.apply(h, POINTS) - image).max() < 1e-6


def test_a_similarity_never_turns_the_face_over():
    assert homology.similarity(POINTS, POINTS.mean(axis=0) - 2 * POINTS)[0, 0] > 0


def test_maps_come_in_stacks():
    d = np.array([[10.0, 0], [0, 20]])
    assert np.array_equal(homology.apply(homology.translation(d), POINTS), POINTS[None] + d[:, None])
    pairs = np.stack([POINTS[:3], POINTS[2:]])
    maps = homology.homology(pairs, pairs + 5.0)
    assert maps.shape == (2, 3, 3)
    assert homology.apply(maps, POINTS) == pytest.approx(np.stack([POINTS + 5.0] * 2), abs=1e-6)


def test_points_on_the_horizon_go_to_infinity():
    h = np.array([[1.0, 0, 0], [0, 1, 0], [-0.01, 0, 1]])
    assert homology.apply(h, np.array([[100.0, 0], [50, 0]])).tolist() == [[np.inf, np.inf], [100.0, 0.0]]


def test_a_similarity_follows_the_seen_points_alone_within_bounds():
    dst = 0.5 * POINTS + [7.0, -3]
    lost = dst.copy()
    lost[2] += 40
    seen = np.arange(5) != 2
    maps = homology.similarity_of_seen(POINTS[None], lost[None], seen[None])
    assert np.allclose(homology.apply(maps, POINTS)[0], dst)
    assert homology.similarity_of_seen(POINTS, dst, seen, least=0.8)[0, 0] == 0.8
    assert homology.similarity_of_seen(POINTS, dst, seen, most=0.4)[0, 0] == 0.4
    one = homology.similarity_of_seen(POINTS, dst, np.arange(5) == 1)
    assert np.allclose(homology.apply(one, POINTS), POINTS + dst[1] - POINTS[1])
