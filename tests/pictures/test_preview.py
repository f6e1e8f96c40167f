from dataclasses import replace

import numpy as np

from sketch2shape.pictures import encode_png, preview
from sketch2shape.pictures.facets import surface
from sketch2shape.pictures.preview import _fill, _project, turn
from sketch2shape.pipeline.result import Result


def test_the_picture_has_the_size_asked_for_and_the_solid_in_it(notched: Result) -> None:
    picture = preview(notched.solids, (320, 240))
    assert picture.shape == (240, 320, 3)
    assert (picture.sum(axis=2) < 200).any()  # dark edges
    assert picture[2, 2].min() > 240  # clear corner


def test_the_same_solid_gives_the_same_bytes(tube: Result) -> None:
    assert encode_png(preview(tube.solids, (320, 240))) == encode_png(preview(tube.solids, (320, 240)))


def test_the_viewer_stands_to_the_right_and_above() -> None:
    right_side, top = turn(30, 20) @ [1, 0, 0], turn(30, 20) @ [0, -1, 0]
    assert right_side[2] < 0  # the right side's normal points to the viewer
    assert top[2] < 0


def test_depth_not_order_decides_what_is_seen(notched: Result) -> None:
    form = surface(notched.solids)
    scene = _project(form.vertices, turn(28, 22), 300, 240)
    pictures = []
    for order in (np.arange(len(form.triangles)), np.arange(len(form.triangles))[::-1]):
        image = np.full((240, 300, 3), 255, np.uint8)
        _fill(image, replace(form, triangles=form.triangles[order]), scene)
        pictures.append(image)
    differing = (pictures[0] != pictures[1]).any(axis=2).mean()
    assert differing < 0.002  # at most the shared borders of triangles


def test_one_sees_through_a_hole(tube: Result) -> None:
    picture = preview(tube.solids, (400, 300), view=(0, 0))
    assert picture[150, 200].min() > 215  # the backdrop, in the middle of the hole
    assert picture[150, 90, 0] < 200  # the front face beside it


def test_no_solids_give_the_backdrop() -> None:
    assert preview((), (80, 60)).shape == (60, 80, 3)
