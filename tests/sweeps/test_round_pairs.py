"""Two ellipses as the faces of a round object in perspective."""

import numpy as np
import pytest
from round_sketches import ellipse

from sketch2shape.sweeps import Frame, round_pairs

NEAR = ellipse(200.0, 200.0, 90.0, Frame(np.array([0.3, 0.954]), 0.5))
FAR = ellipse(330.0, 330.0, 70.0, Frame(np.array([0.1, 0.995]), 0.65))


def test_either_ellipse_may_be_the_nearer_and_becomes_the_other():
    found = list(round_pairs([NEAR.line, FAR.line]))
    assert len(found) == 2
    for swept, front, back in zip(found, (NEAR, FAR), (FAR, NEAR), strict=True):
        (ring,) = swept.rings
        assert ring.middle == pytest.approx(front.middle, abs=0.2)
        image = swept.image(ring)
        assert image.middle == pytest.approx(back.middle, abs=0.5)
        assert image.circle.radius == pytest.approx(back.circle.radius, abs=0.5)
        assert image.frame.ratio == pytest.approx(back.frame.ratio, abs=0.01)


def test_the_centre_is_where_both_outer_tangents_meet():
    small = ellipse(400.0, 200.0, 45.0, Frame(np.array([1.0, 0.0]), 0.5))
    large = ellipse(200.0, 200.0, 90.0, Frame(np.array([1.0, 0.0]), 0.5))
    swept = next(iter(round_pairs([large.line, small.line])))
    assert swept.way.centre == pytest.approx([600, 200], abs=3)
    # a cone cut off, in a parallel view
    assert swept.way.scale == pytest.approx(0.5, abs=0.01)
    assert swept.way.slope == pytest.approx([0, 0], abs=1e-4)


@pytest.mark.parametrize(
    "other",
    [ellipse(200.0, 200.0, 60.0), ellipse(330.0, 200.0, 90.0), ellipse(200.0, 200.0, 90.0)],
    ids=["one inside the other", "parallel sides", "the same"],
)
def test_ellipses_without_sides_that_meet_are_no_pair(other):
    assert not list(round_pairs([ellipse(200.0, 200.0, 90.0).line, other.line]))
