"""Enlarged ink: the same places, and gaps that a smaller mask has closed."""

import numpy as np
from sketches import ink_of, line, paper

from sketch2shape.ink import enlarged


def test_places_stay_where_they_are_in_the_picture():
    ink = ink_of(line(paper(), [100, 150], [300, 150]))
    larger = enlarged(ink)
    y, x = np.nonzero(larger.mask)
    places = larger.to_picture(np.stack([x, y], axis=1))
    assert np.abs(places[:, 1] - 150).max() < 2
    assert abs(places[:, 0].min() - 100) < 2
    assert abs(places[:, 0].max() - 300) < 2
    assert larger.mask.shape == (2 * ink.mask.shape[0], 2 * ink.mask.shape[1])
    assert 1.3 * ink.pen_width < larger.pen_width < 3 * ink.pen_width


def test_lines_that_nearly_touch_are_apart():
    picture = line(line(paper(), [100, 150], [300, 150], 1), [100, 153], [300, 153], 1)
    column = enlarged(ink_of(picture)).mask[:, 400]
    assert int(np.count_nonzero(np.diff(column.astype(int)) == 1)) == 2
