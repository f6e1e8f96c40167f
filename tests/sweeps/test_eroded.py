"""The front face as what is left of all that a drawing covers."""

import cv2
import numpy as np
import pytest
from round_sketches import CYLINDER, drawn, half_disc, slot
from scipy.spatial import cKDTree
from sketches import ink_of

from sketch2shape.strokes import thin
from sketch2shape.sweeps import Sweep, Way, eroded_outline

HALF_DISC = Sweep((half_disc(),), Way(np.array([0.0, 14.0])))


@pytest.mark.parametrize(
    "sweep",
    [HALF_DISC, slot(Way(np.array([-13.0, 9.0]))), CYLINDER],
    ids=["thin half disc", "thin slot", "cylinder"],
)
def test_what_is_left_is_the_front_face(sweep):
    found = eroded_outline(thin(ink_of(drawn(sweep))).mask, sweep.way.shift)
    line = sweep.rings[0].line
    apart = [cKDTree(a).query(b)[0].max() for a, b in ((found, line), (line, found))]
    assert max(apart) < 7.0  # a thinned line rounds sharp corners


def test_nothing_is_left_of_open_lines_nor_of_what_is_smaller_than_the_way():
    lines = np.zeros((90, 120), np.uint8)
    cv2.polylines(lines, [np.array([[10, 10], [100, 20], [90, 80]], np.int32)], False, 1)
    assert eroded_outline(lines, np.array([0.0, 12.0])) is None
    cv2.rectangle(lines, (40, 40), (50, 48), 1)
    assert eroded_outline(lines, np.array([30.0, 0.0])) is None


@pytest.mark.parametrize("shift", [(7.0, 0.0), (0.0, -11.0), (13.0, 5.0), (0.4, 0.2)])
def test_the_way_is_followed_to_its_end_and_no_further(shift):
    lines = np.zeros((90, 120), np.uint8)
    cv2.rectangle(lines, (20, 20), (100, 70), 1)
    (left, top), (right, low) = (f(eroded_outline(lines, np.array(shift)), axis=0) for f in (np.min, np.max))
    x, y = np.rint(shift)
    assert (left, right) == (20 - min(x, 0), 100 - max(x, 0))
    assert (top, low) == (20 - min(y, 0), 70 - max(y, 0))
