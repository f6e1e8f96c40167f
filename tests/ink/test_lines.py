from __future__ import annotations

import cv2
import numpy as np
from skimage.morphology import skeletonize

from sketch2shape.ink.lines import Lines, arcs_of, lines_of


def lines_in(image: np.ndarray, pen: float = 3.0) -> Lines:
    return lines_of(*arcs_of(skeletonize(image > 0), pen), pen)


def canvas() -> np.ndarray:
    return np.zeros((200, 300), np.uint8)


def test_a_crossing_is_two_lines_with_free_ends() -> None:
    image = cv2.line(cv2.line(canvas(), (20, 100), (280, 100), 1, 3), (150, 20), (150, 180), 1, 3)
    lines = lines_in(image)
    assert sorted(np.round(lines.length, -1).tolist()) == [160.0, 260.0]
    assert lines.free.all()
    assert not lines.on_line.any()
    assert all(len(arcs) == 2 for arcs in lines.arcs)


def test_a_line_ends_on_one_that_goes_on() -> None:
    image = cv2.line(cv2.line(canvas(), (20, 100), (280, 100), 1, 3), (150, 20), (150, 100), 1, 3)
    lines = lines_in(image)
    stem = int(np.argmin(lines.length))
    assert sorted(lines.free[stem].tolist()) == [False, True]
    assert lines.on_line[stem].sum() == 1


def test_a_corner_of_three_is_no_line_that_goes_on() -> None:
    image = canvas()
    for end in ((60, 20), (240, 60), (150, 190)):
        cv2.line(image, (150, 100), end, 1, 3)
    lines = lines_in(image)
    assert len(lines.arcs) == 3
    assert not lines.on_line.any()
    assert np.allclose(np.linalg.norm(lines.axis, axis=1), 1.0)


def test_curves_are_no_lines() -> None:
    assert len(lines_in(cv2.ellipse(canvas(), (150, 190), (130, 150), 0, 180, 360, 1, 3)).arcs) == 0
    assert len(lines_in(canvas()).arcs) == 0
