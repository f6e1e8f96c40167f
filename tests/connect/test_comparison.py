"""The faces that connectors are fitted to and compared on."""

import importlib.util
import sys
from pathlib import Path

import numpy as np
import pytest

from sketch2shape.connect.geometry import canonical, ring_is_simple

SCRIPTS = Path(__file__).parent.parent.parent / "scripts"


def load(name: str):
    spec = importlib.util.spec_from_file_location(name, SCRIPTS / f"{name}.py")
    module = sys.modules[name] = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def profiles():
    return load("connector_profiles")


@pytest.fixture(scope="module")
def comparison(profiles):
    return load("compare_connectors")


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


def test_shuffled_faces_remember_their_order(comparison):
    ring = np.array([(0, 0), (4, 0), (4, 3), (1, 2)], float)
    face = comparison.shuffled("kite", ring, np.random.default_rng(3))
    walked = face.points[list(face.order)]
    assert canonical([ring.tolist().index(p) for p in walked.tolist()]) == (0, 1, 2, 3)


def test_a_missing_vertex_leaves_the_ring_of_the_others(comparison):
    ring = np.array([(0, 0), (4, 0), (4, 3), (2, 5), (0, 3)], float)
    face = comparison.shuffled("house", ring, np.random.default_rng(4))
    less = comparison.with_a_vertex_missing(face, np.random.default_rng(5))
    left = [ring.tolist().index(p) for p in less.points[list(less.order)].tolist()]
    assert canonical(left) == tuple(sorted(left))
    assert len(left) == 4


def test_an_extra_vertex_is_right_only_when_left_out(comparison):
    square = comparison.shuffled("square", np.array([(0, 0), (4, 0), (4, 4), (0, 4)], float), np.random.default_rng(1))
    more = comparison.with_an_extra_vertex(square, np.random.default_rng(2))
    assert comparison.is_right(more, "graham", {})
    assert not comparison.is_right(more, "tour", {})
