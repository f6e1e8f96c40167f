"""Edges along each other, on a few lines."""

import numpy as np
import pytest

from sketch2shape.evidence.overlaps import ONE_WAY, PLACES, beside, coincidences


def told(*ends, seen=None, reach=2.0):
    lines = np.array(ends, float)
    span = lines[:, 1] - lines[:, 0]
    length = np.linalg.norm(span, axis=1)
    shown = np.ones(len(lines)) if seen is None else np.array(seen, float)
    return beside(lines[:, 0], span, length, reach), coincidences(lines[:, 0], span, length, shown, reach)


LONG = ((0, 0), (100, 0))


def test_pairs_that_are_told_apart_by_their_ends_would_not_lie_along_each_other():
    rng = np.random.default_rng(4)
    a, angle = rng.uniform(0, 60, (40, 2)), rng.choice([0.0, 0.05, 1.5], 40) + rng.normal(0, 0.01, 40)
    length = rng.uniform(5, 60, 40)
    u = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    to = (a[:, None] + PLACES * (length[:, None] * u)[:, None])[:, :, None] - a
    along, across = (to * u).sum(axis=3), np.abs(to[..., 0] * u[:, 1] - to[..., 1] * u[:, 0])
    alike = np.abs(np.sin(angle[:, None] - angle)) < ONE_WAY
    every = (across <= 2.0) & (along >= 0) & (along <= length) & alike[:, None] & ~np.eye(40, dtype=bool)[:, None]
    assert every.any()
    assert (beside(a, length[:, None] * u, length, 2.0) == every).all()


def test_a_short_edge_on_a_long_one_is_one_accident():
    places, count = told(LONG, ((20, 1), (60, 1)))
    assert count == 1
    assert places[1, :, 0].all()
    assert 0.3 < places[0, :, 1].mean() < 0.5


def test_of_two_alike_one_counts_and_none_lies_along_itself():
    places, count = told(LONG, ((100, 0.5), (0, 0.5)))
    assert count == 1
    assert not places[[0, 1], :, [0, 1]].any()


@pytest.mark.parametrize(
    "other", [((0, 5), (100, 5)), ((0, 0), (0, 100)), ((101, 0), (190, 0)), ((70, 0), (190, 0))],
    ids=["beside", "across", "behind", "a little"],
)  # fmt: skip
def test_what_only_comes_near_is_none(other):
    assert told(LONG, other)[1] == 0


def test_what_is_hidden_takes_no_ink():
    assert told(LONG, ((20, 1), (60, 1)), seen=[1, 0.2])[1] == 0
    assert told(LONG, ((20, 1), (60, 1)), seen=[0.2, 1])[1] == 0
