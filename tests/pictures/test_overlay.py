from dataclasses import replace

import numpy as np
import pytest

from sketch2shape.model.picture import Picture
from sketch2shape.pictures import encode_png, overlay
from sketch2shape.pictures.overlay import pale
from sketch2shape.pictures.palette import BACK, FRONT, JOIN
from sketch2shape.pipeline.result import Result


def near(pixel: np.ndarray, colour: tuple[int, int, int]) -> bool:
    return bool(np.abs(pixel.astype(int) - colour).max() < 12)


def test_faces_and_connecting_edges_have_their_own_colours(box: Result) -> None:
    picture = overlay(box)
    scale = picture.shape[1] / box.picture.pixels.shape[1]
    for point, colour in (((200, 160), FRONT), ((290, 100), BACK), ((345, 130), JOIN), ((300, 250), FRONT)):
        x, y = np.rint(np.array(point) * scale).astype(int)
        assert any(near(picture[y + dy, x], colour) for dy in (-2, -1, 0, 1, 2)), point


def test_a_hidden_edge_is_broken_and_a_visible_one_is_not(box: Result) -> None:
    picture = overlay(box, legend=False)
    scale = picture.shape[1] / box.picture.pixels.shape[1]

    def strokes(y: float, x0: float, x1: float) -> int:
        row = picture[round(y * scale), round(x0 * scale) : round(x1 * scale)]
        on = np.abs(row.astype(int) - BACK).max(axis=1) < 60
        return int(np.count_nonzero(np.diff(on.astype(int)) == 1) + on[0])

    assert strokes(100, 200, 380) == 1  # the back's upper edge
    assert strokes(280, 200, 290) > 4  # its lower one, behind the front


def test_over_a_reduced_copy_the_object_lies_where_it_lies_over_the_whole(box: Result) -> None:
    w, h = box.picture.size
    reduced = Picture(np.ascontiguousarray(box.picture.pixels[::2, ::2]), full_size=(w, h))
    whole, small = overlay(box), overlay(replace(box, picture=reduced))
    assert whole.shape == small.shape
    assert np.median(np.abs(whole.astype(int) - small)) == 0
    assert np.abs(whole.astype(int) - small).mean() < 12


def test_small_pictures_are_enlarged_and_huge_ones_reduced(box: Result, nothing: Result) -> None:
    assert max(overlay(nothing, legend=False).shape) == 720
    huge = replace(box, picture=Picture(np.full((3000, 4000, 3), 255, np.uint8)))
    assert overlay(huge, legend=False).shape == (1800, 2400, 3)


def test_nothing_found_still_gives_a_picture(nothing: Result) -> None:
    assert overlay(nothing).shape[0] > overlay(nothing, legend=False).shape[0]


def test_a_blackboard_is_shown_dark_on_light() -> None:
    board = np.full((20, 20, 3), 20, np.uint8)
    assert pale(board).mean() > 200


@pytest.mark.parametrize("name", ["box", "notched", "tube"])
def test_the_same_input_gives_the_same_bytes(name: str, request: pytest.FixtureRequest) -> None:
    result = request.getfixturevalue(name)
    assert encode_png(overlay(result)) == encode_png(overlay(result))
