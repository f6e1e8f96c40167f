"""What speaks for an oblique drawing."""

import numpy as np
import pytest

from sketch2shape.lifting.oblique_cues import level_odds
from sketch2shape.lifting.regularity import find_relations

NOISE, WOBBLE = 0.5, 0.005
ASKEW = np.radians(6.0)
TURN = np.array([[np.cos(ASKEW), np.sin(ASKEW)], [-np.sin(ASKEW), np.cos(ASKEW)]])
RECTANGLE = np.array([[0.0, 0], [220, 0], [220, 150], [0, 150]])


def odds(face, toward):
    relations = find_relations(face, [4], face, NOISE)
    vectors = (relations.rows @ face)[: len(relations.edges)]
    spread = NOISE * relations.weight[: len(vectors)] / relations.drawn[: len(vectors)]
    way = np.array(toward) / np.hypot(*toward)
    return level_odds(relations, np.arctan2(vectors[:, 1], vectors[:, 0]), spread, way, WOBBLE)


def test_a_page_may_be_held_askew_but_not_where_something_is_plumb():
    aside, plumb = (1.0, -1.0), (0.0, -1.0)
    turned = RECTANGLE @ TURN
    leaning = np.stack([RECTANGLE[:, 0], RECTANGLE[:, 1] + np.tan(ASKEW) * RECTANGLE[:, 0]], axis=1)
    assert odds(RECTANGLE, aside) > odds(turned, aside) > odds(turned, plumb) + 1.0
    assert odds(turned, aside) > odds(leaning, aside) + 1.0
    assert odds(leaning, plumb) == pytest.approx(odds(leaning, aside))
