"""The faces that connectors are fitted to and compared on."""

import importlib
from pathlib import Path

import numpy as np
import pytest

from sketch2shape.connectors.polygon import canonical, ring_is_simple

SCRIPTS = Path(__file__).parent.parent.parent / "scripts"


@pytest.fixture(scope="module", autouse=True)
def scripts():
    """Scripts import each other by name, as when they are run."""
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(SCRIPTS)
        yield


@pytest.fixture(scope="module")
def profiles(scripts):
    return importlib.import_module("connector_profiles")


@pytest.fixture(scope="module")
def sets(scripts):
    return importlib.import_module("connector_faces")


@pytest.fixture(scope="module")
def precision(scripts):
    return importlib.import_module("connector_precision")


def test_profiles_are_simple_rings(profiles):
    rng = np.random.default_rng(0)
    rings = [(name, ring) for name, _, ring in profiles.faces(rng, count=3)]
    assert {name for name, _ in rings} == set(profiles.PROFILES)
    assert np.mean([ring_is_simple(ring) for _, ring in rings]) > 0.99
    assert all(np.ptp(ring, axis=0).max() == pytest.approx(300) for _, ring in rings)


def test_rectilinear_profiles_have_right_angles_only(profiles):
    for name, _, ring in profiles.faces(np.random.default_rng(1), profiles.RECTILINEAR, ("turned",), 5):
        steps = np.roll(ring, -1, axis=0) - ring
        steps /= np.hypot(*steps.T)[:, None]
        assert np.abs((steps * np.roll(steps, -1, axis=0)).sum(axis=1)).max() < 1e-9, name


def test_shuffled_faces_remember_their_order(sets):
    ring = np.array([(0, 0), (4, 0), (4, 3), (1, 2)], float)
    face = sets.shuffled("kite", ring, np.random.default_rng(3))
    walked = face.points[list(face.order)]
    assert canonical([ring.tolist().index(p) for p in walked.tolist()]) == (0, 1, 2, 3)


def test_a_missing_vertex_leaves_the_ring_of_the_others(sets):
    ring = np.array([(0, 0), (4, 0), (4, 3), (2, 5), (0, 3)], float)
    face = sets.shuffled("house", ring, np.random.default_rng(4))
    less = sets.with_a_vertex_missing(face, np.random.default_rng(5))
    left = [ring.tolist().index(p) for p in less.points[list(less.order)].tolist()]
    assert canonical(left) == tuple(sorted(left))
    assert len(left) == 4


def test_an_extra_vertex_is_right_only_when_left_out(sets, precision):
    square = sets.shuffled("square", np.array([(0, 0), (4, 0), (4, 4), (0, 4)], float), np.random.default_rng(1))
    more = sets.with_an_extra_vertex(square, np.random.default_rng(2))
    assert precision.is_right(more, "graham", {})
    assert not precision.is_right(more, "tour", {})
