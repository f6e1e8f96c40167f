"""Sweeps moved to the ink."""

from dataclasses import replace

import numpy as np
import pytest
from round_sketches import ARCH, CONE, CYLINDER, TUBE, drawn, slot
from scipy.spatial import cKDTree
from sketches import ink_of

from sketch2shape.fit import polished
from sketch2shape.strokes import thin
from sketch2shape.sweeps import Frame, Sweep, Way


@pytest.mark.parametrize("sweep", [ARCH, CYLINDER, CONE], ids=["arch", "cylinder", "cone"])
def test_a_sweep_put_a_little_off_returns(sweep):
    tree = cKDTree(thin(ink_of(drawn(sweep, "wire"))).points)
    ring = sweep.rings[0].shifted(np.array([2.0, -1.5]))
    way = sweep.way
    way = Way(way.shift + [1.5, 2.0]) if way.centre is None else replace(way, centre=way.centre + [2.0, 1.0])
    moved = polished(replace(sweep, rings=(ring,), way=way), tree, 6.0)
    line, to = sweep.rings[0].line, sweep.way.of(sweep.rings[0].line)
    off = cKDTree(np.concatenate([line, line + to]))
    got = moved.rings[0].line
    assert off.query(got)[0].max() < 4.5  # half the distance of the samples
    assert np.abs(moved.way.of(got).mean(axis=0) - to.mean(axis=0)).max() < 2.0


def test_lines_drawn_at_smooth_joints_tell_where_these_are():
    sweep = slot(Way(np.array([70.0, 50.0])), tangents=True)
    tree = cKDTree(thin(ink_of(drawn(sweep, "wire"))).points)
    (ring,) = sweep.rings
    astray = replace(ring, vertices=ring.vertices + [[4.0, 0.0], [0.0, 0.0], [0.0, 0.0], [-4.0, 0.0]])
    moved = polished(replace(sweep, rings=(astray,)), tree, 6.0)
    assert np.abs(moved.rings[0].vertices - ring.vertices).max() < 1.5


def test_circles_are_seen_shortened_along_the_way_to_the_back():
    tree = cKDTree(thin(ink_of(drawn(TUBE, "wire"))).points)
    askew = Frame(np.array([np.sin(0.08), np.cos(0.08)]), TUBE.frame.ratio)
    begun = Sweep(tuple(ring.within(askew) for ring in TUBE.rings), Way(np.array([12.0, 149.0])))
    moved = polished(begun, tree, 14.0)
    assert moved.way.shift == pytest.approx(TUBE.way.shift, abs=1.0)
    assert moved.frame.along == pytest.approx([0.0, 1.0], abs=0.01)
    assert [ring.circle.radius for ring in moved.rings] == pytest.approx([90.0, 50.0], abs=1.0)


def test_a_base_that_was_inferred_stays():
    regular = replace(CONE, regular=1.0)
    tree = cKDTree(thin(ink_of(drawn(CONE, "wire"))).points)
    assert polished(regular, tree, 6.0) is regular
