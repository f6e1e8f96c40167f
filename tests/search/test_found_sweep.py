"""Sweeps held against a drawing."""

from dataclasses import replace

import numpy as np
from round_sketches import ARCH, arch, drawn
from sketches import ink_of

from sketch2shape.ink import split_groups
from sketch2shape.search.found_sweep import cheapest, moved, priced
from sketch2shape.search.observed import observed
from sketch2shape.search.scene import Scene


def scene_and_arch():
    """What the search sees of an arch, and the arch there."""
    (group,) = split_groups(ink_of(drawn(ARCH)))
    seen = observed(group)
    return Scene(seen.drawn, seen.skeleton, seen.view), ARCH.shifted(-group.offset)


def test_a_careless_fit_is_priced_under_the_hand_of_the_close_one():
    scene, true = scene_and_arch()
    close = priced(scene, true)
    loose = priced(scene, replace(true, rings=(arch().shifted(true.rings[0].vertices[0] - [120, 180] + [3.0, 3.0]),)))
    assert loose.hand > 2 * close.hand
    assert loose.under(close.hand) > loose.nats
    assert cheapest((loose, close)) is close


def test_what_costs_more_by_its_own_hand_may_be_the_cheaper_one():
    scene, true = scene_and_arch()
    close = priced(scene, true)
    loose = priced(scene, replace(true, way=replace(true.way, shift=true.way.shift + [2.5, 2.5])))
    excused = replace(loose, energy=loose.energy._replace(shape=loose.energy.shape - 1000.0))
    assert excused.nats < close.nats
    assert cheapest((excused, close)) is close


def test_a_sweep_beside_the_ink_is_moved_onto_it():
    scene, true = scene_and_arch()
    beside = priced(scene, true.shifted(np.array([2.0, -1.0])))
    there = moved(beside, scene)
    assert there.hand < beside.hand
    assert np.abs(there.sweep.rings[0].vertices - true.rings[0].vertices).max() < 2.0


def test_a_corner_of_a_hands_arc_is_none_where_no_line_is_drawn():
    """The arch runs on smoothly into its sides: told as corners there, it would show two more lines."""
    scene, true = scene_and_arch()
    (ring,) = true.rings
    assert ring.smooth.any()
    angular = replace(true, rings=(replace(ring, smooth=np.zeros_like(ring.smooth)),))
    assert priced(scene, angular).sweep.rings[0].smooth.tolist() == ring.smooth.tolist()
    lines = replace(true, tangents=True)
    (group,) = split_groups(ink_of(drawn(lines)))
    seen = observed(group)
    shown = priced(Scene(seen.drawn, seen.skeleton, seen.view), angular)
    assert not shown.sweep.rings[0].smooth.any()
