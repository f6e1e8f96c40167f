"""Which ink is searched at all."""

import cv2
import numpy as np
from sketches import ink_of, paper, prism

from sketch2shape.ink import split_groups
from sketch2shape.search.observed import observed
from synthetic.hand import RULER
from synthetic.negatives import NEGATIVES
from synthetic.pens import Pen

COMB = np.array(
    [[0, 0], [1, 0], [1, 2], [2, 2], [2, 0], [3, 0], [3, 2], [4, 2], [4, 0], [5, 0], [5, 3], [0, 3.0]]
) * 55 + [60, 150]  # fmt: skip


def test_writing_and_scribbles_are_not_searched_but_busy_wireframes_are():
    rng = np.random.default_rng(3)
    letters, grid = paper(), paper()
    for x, y in [(x, y) for y in range(20, 380, 14) for x in range(20, 460, 18)]:
        cv2.line(letters, (x, y), (x + 9, y + int(rng.integers(0, 9))), 0, 1)
    for k in range(14):
        cv2.line(grid, (40 + 30 * k, 30), (40 + 30 * k, 30 + 26 * 13), 0, 1)
        cv2.line(grid, (40, 30 + 26 * k), (40 + 30 * 13, 30 + 26 * k), 0, 1)
    layers = [NEGATIVES["scribble"]((1600, 1200), Pen(2.0), RULER, rng) for _ in range(3)]
    scribble = np.round(255 * (1 - np.maximum.reduce(layers))).astype(np.uint8)

    def is_searched(picture):
        return observed(split_groups(ink_of(picture))[0]) is not None

    assert not is_searched(scribble)
    assert not is_searched(letters)
    assert is_searched(grid)
    assert is_searched(prism(COMB, COMB + [70, -45]))
