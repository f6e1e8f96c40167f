import json

import numpy as np
import pytest

from synthetic.drawing import draw
from synthetic.negatives import NEGATIVES
from synthetic.recipes import RECIPES


def rings(truth):
    return [truth["f1"], *(h["f1"] for h in truth["holes"])], [truth["f2"], *(h["f2"] for h in truth["holes"])]


@pytest.mark.parametrize("category", ["clean_wire_oblique", "photo_wire", "annotated_dashed", "multi_wire", "negative"])
def test_the_same_seed_gives_the_same_bytes(category):
    one, two = draw(category, 5, 3), draw(category, 5, 3)
    assert one.encoded() == two.encoded()
    assert one.truth == two.truth
    assert one.encoded() != draw(category, 6, 4).encoded()


def test_truth_is_json_and_names_both_faces():
    truth = json.loads(json.dumps(draw("holes_wire", 1, 0).truth))
    front, back = rings(truth)
    assert [len(r) for r in front] == [len(r) for r in back]
    assert len(front) >= 2
    assert truth["n"] == len(truth["f1"]) == len(truth["solid"]["profile"])


@pytest.mark.parametrize("index", range(3))
def test_parallel_prisms_have_one_shift(index):
    truth = draw("clean_wire_axono", 2, index).truth
    shift = np.array(truth["f2"]) - truth["f1"]
    assert np.abs(shift - shift[0]).max() < 0.01


def test_every_wire_edge_has_ink_under_it():
    drawing = draw("clean_wire_oblique", 3, 1)
    dark = drawing.pixels.min(2) < 160
    f1, f2 = (np.array(drawing.truth[k]) for k in ("f1", "f2"))
    starts, ends = np.vstack([f1, f2, f1]), np.vstack([np.roll(f1, -1, 0), np.roll(f2, -1, 0), f2])
    for a, b in zip(starts, ends, strict=True):
        at = np.round(a + np.linspace(0, 1, 40)[:, None] * (b - a)).astype(int)
        assert all(dark[y - 1 : y + 2, x - 1 : x + 2].any() for x, y in at)


def test_photo_truth_follows_the_tilt_of_the_page():
    drawing = draw("photo_wire", 4, 0)
    grey = drawing.pixels.min(2).astype(float)
    for x, y in np.round(drawing.truth["f1"]).astype(int):
        patch = grey[y - 12 : y + 13, x - 12 : x + 13]
        assert grey[y - 4 : y + 5, x - 4 : x + 5].min() < 0.75 * np.median(patch)


@pytest.mark.parametrize("lines", ["dashed", "removed"])
def test_a_hidden_corner_of_a_box_is_dashed_or_left_out(lines):
    for index in range(20):
        drawing = draw(f"clean_{lines}_oblique", 8, index, shapes="square")
        f1, f2 = (np.array(drawing.truth[k]) for k in ("f1", "f2"))
        inside = f2[(f2 > f1.min(0) + 5).all(1) & (f2 < f1.max(0) - 5).all(1)]
        if len(inside) == 1:
            break
    x, y = np.round(inside[0]).astype(int)
    inked = (drawing.pixels.min(2) < 160)[y - 2 : y + 3, x - 2 : x + 3].any()
    assert inked == (lines == "dashed")


@pytest.mark.parametrize("category", sorted(RECIPES))
def test_every_category_can_be_drawn_small_enough_to_score(category):
    truth = draw(category, 11, 0).truth
    assert truth["category"] == category
    for thing in truth.get("objects", [truth]):
        points = np.array(thing["f1"] + thing["f2"], float).reshape(-1, 2)
        inside = (points > -3) & (points < np.array([truth["width"], truth["height"]]) + 3)
        assert inside.all() or category.startswith("cropped")


@pytest.mark.parametrize("index", range(len(NEGATIVES)))
def test_negatives_hold_no_object_but_ink(index):
    drawing = draw("negative", 1, index)
    assert drawing.truth["objects"] == []
    assert (np.ptp(drawing.pixels) > 40) == (drawing.truth["profile"] != "blank" or drawing.suffix == ".jpg")
