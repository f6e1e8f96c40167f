"""A closed line of a wireframe runs where there is ink on both faces."""

import numpy as np
import pytest
from round_sketches import UPRIGHT, drawn, ellipse
from sketches import ink_of

from sketch2shape.strokes import thin
from sketch2shape.sweeps import Sweep, Way
from sketch2shape.sweeps.retracing import retraced

WAY = Way(np.array([30.0, 60.0]))
RIM = ellipse(240.0, 160.0, 120.0, UPRIGHT)


@pytest.fixture(scope="module")
def skeleton():
    return thin(ink_of(drawn(Sweep((RIM,), WAY))))


def evenly_round():
    angle = np.linspace(0, 2 * np.pi, 700, endpoint=False)
    return np.stack([240 + 120 * np.cos(angle), 160 + 48 * np.sin(angle)], axis=1)


def off_rim(line):
    """(k,) pixels, about, from the true ellipse."""
    return np.abs(np.hypot((line[:, 0] - 240) / 120, (line[:, 1] - 160) / 48) - 1) * 60


def test_a_line_beside_the_ink_is_moved_onto_it(skeleton):
    beside = evenly_round() + [2.0, -3.0]
    assert np.median(off_rim(beside)) > 1.5
    assert np.median(off_rim(retraced(beside, WAY, skeleton))) < 0.7


def test_a_notch_is_drawn_out(skeleton):
    notched = evenly_round()
    notched[150:158, 1] -= 8.0
    assert off_rim(notched)[150:158].min() > 3.0
    assert off_rim(retraced(notched, WAY, skeleton))[145:163].max() < 2.0


def test_ink_of_one_face_alone_moves_nothing(skeleton):
    elsewhere = Way(np.array([-170.0, 10.0]))
    beside = evenly_round() + [0.0, 3.0]
    assert np.array_equal(retraced(beside, elsewhere, skeleton), beside)
