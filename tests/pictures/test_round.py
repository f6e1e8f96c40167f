"""Round and pointed solids in every picture: arcs smooth, outlines drawn, nothing between facets."""

import json
import warnings

import cv2
import numpy as np
import pytest

from sketch2shape.lifting import lift
from sketch2shape.model import Answer, Picture
from sketch2shape.pictures import overlay, preview, preview_of, stages, viewer
from sketch2shape.pictures.facets import surface
from sketch2shape.pictures.palette import BACK, FRONT, JOIN
from sketch2shape.pictures.viewer import shape
from tests.lifting.round_views import CIRCLE, HOLE, ROUNDED, SQUARE, STANDING, Drawer, axonometric

CASES = {
    "cylinder": ([CIRCLE], 1.5, 1.0),
    "tube": ([CIRCLE, HOLE], 1.5, 1.0),
    "rounded": ([ROUNDED], 0.8, 1.0),
    "plate": ([SQUARE, HOLE], 0.5, 1.0),
    "cone": ([CIRCLE], -1.5, 0.0),
    "pyramid": ([SQUARE], -1.5, 0.0),
}


def answer(name):
    rings, depth, scale = CASES[name]
    obj = Drawer(axonometric(), STANDING).draw(rings, depth, scale)
    return Answer((obj,), (lift(obj),), Picture(np.full((480, 640, 3), 255, np.uint8), "round.png"))


@pytest.mark.parametrize("name", CASES)
def test_every_picture_is_drawn_without_a_warning(name):
    result = answer(name)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for draw in (overlay, stages, preview_of):
            assert draw(result).std() > 1.0
        assert "<canvas" in viewer(result)


@pytest.mark.parametrize("name", ["cylinder", "cone", "pyramid"])
def test_overlay_has_all_three_colours(name):
    pixels = overlay(answer(name), legend=False).reshape(-1, 3).astype(int)
    for colour in (FRONT, JOIN) if name != "cylinder" else (FRONT, BACK, JOIN):
        assert (np.abs(pixels - colour).sum(axis=1) < 30).sum() > 100


def test_a_curved_side_has_no_lines_on_it():
    result = answer("cylinder")
    pixels = preview(result.solids, (480, 360), drawing=result.objects[0])
    dark = (cv2.cvtColor(pixels, cv2.COLOR_RGB2GRAY) < 90).astype(np.uint8)
    column = dark[:, 240]  # down the middle: top rim twice, bottom rim
    assert len(np.flatnonzero(np.diff(column) == 1)) == 3
    row = dark[190]  # across the side: its two outlines
    assert len(np.flatnonzero(np.diff(row) == 1)) == 2


def test_the_page_gets_outlines_only_for_round_solids():
    told = shape(answer("cylinder"))
    assert len(told["contours"]) > 40
    ends = np.array(told["contours"])
    assert ends[:, :2].max() < len(told["vertices"])
    assert ends[:, 2:].max() < len(told["triangles"])
    assert "contours" not in shape(answer("pyramid"))
    json.dumps(told)


def test_several_solids_keep_their_outlines_apart():
    one, two = answer("cylinder").solids[0], answer("cone").solids[0]
    both = surface([one, two])
    first = surface([one])
    assert (both.contours[len(first.contours) :, 2:] >= len(first.triangles)).all()
    assert (both.contours[len(first.contours) :, :2] >= len(first.vertices)).all()


def test_outlines_of_faces_hold_their_arcs():
    obj = answer("plate").objects[0]
    outer, hole = obj.outlines("f1")
    assert len(outer) == 4
    assert len(hole) >= 9
    assert answer("cone").objects[0].outlines("f2") == ()
