"""What is drawn on and around the objects: it is there, it reaches the object, and the truth stays the truth."""

from dataclasses import replace

import cv2
import numpy as np
import pytest

from synthetic.drawing import SUBJECTS, draw
from synthetic.hand import RULER, STEADY, Hand, strokes_of
from synthetic.layers import Drawn, nearest_faces
from synthetic.nuisances import NUISANCES
from synthetic.pens import Pen
from synthetic.recipes import HARD, RECIPES
from synthetic.scenes import Wish, scene

SIZE = (640, 480)
AROUND = ("beside",)
"""Nuisances that keep off the object."""


def drawn(lines="removed", seed=1, hand=RULER):
    made = scene(Wish(lines=lines, shapes="L"), SIZE, 2.0, np.random.default_rng(seed), 0.6)
    return Drawn(made, made.points, lines, SIZE, Pen(2.0), hand)


def silhouette(one, margin=0):
    mask = np.zeros(SIZE[::-1], np.uint8)
    hull = cv2.convexHull(np.round(one.points).astype(np.int32))
    cv2.fillConvexPoly(mask, hull, 1)
    return cv2.dilate(mask, np.ones((2 * margin + 1,) * 2, np.uint8)) > 0


@pytest.mark.parametrize("lines", ["wire", "removed"])
@pytest.mark.parametrize("name", list(NUISANCES))
def test_each_nuisance_adds_ink_and_the_same_for_the_same_seed(name, lines):
    for seed in range(2):
        one = drawn(lines, seed, STEADY)
        layers, again = (NUISANCES[name](one, np.random.default_rng(seed)) for _ in range(2))
        assert sum(float(layer.ink.sum()) for layer in layers) > 60
        assert len(layers) == len(again)
        assert all(np.array_equal(a.ink, b.ink) and a.colour == b.colour for a, b in zip(layers, again, strict=True))


@pytest.mark.parametrize("name", [n for n in NUISANCES if n not in AROUND])
def test_a_nuisance_reaches_the_object(name):
    for seed in range(3):
        one = drawn("removed", seed)
        near = silhouette(one, 6)
        layers = NUISANCES[name](one, np.random.default_rng(seed))
        assert max(float(layer.ink[near].max()) for layer in layers) > 0.15


def test_a_drawing_beside_keeps_off_the_object():
    for seed in range(6):
        one = drawn("removed", seed)
        for layer in NUISANCES["beside"](one, np.random.default_rng(seed)):
            assert layer.ink[silhouette(one)].sum() < 0.02 * layer.ink.sum()


@pytest.mark.parametrize("name", ["hatched", "filled", "bare"])
def test_fills_and_hatching_stay_within_the_faces(name):
    for seed in range(2):
        one = drawn("removed", seed)
        index, _ = nearest_faces(one)
        inside = cv2.dilate((cv2.resize((index >= 0).astype(np.float32), SIZE) > 0).astype(np.uint8), np.ones((3, 3)))
        for layer in NUISANCES[name](one, np.random.default_rng(seed)):
            assert layer.ink[inside == 0].max() == 0


def test_faces_beside_each_other_differ_in_tone():
    for index in range(3):
        drawing = draw("filled_bare", 3, index)
        grey = cv2.GaussianBlur(cv2.cvtColor(drawing.pixels, cv2.COLOR_RGB2GRAY), (0, 0), 1).astype(float)
        f1, f2 = (np.array(drawing.truth[k]) for k in ("f1", "f2"))
        # A front edge with its side face turned away from the viewer borders on the paper, else on that face.
        for i in range(len(f1)):
            middle = (f1[i - 1] + f1[i]) / 2
            off = np.array([-(f1[i] - f1[i - 1])[1], (f1[i] - f1[i - 1])[0]])
            off = 5 * off / np.linalg.norm(off)
            a, b = (grey[tuple(np.round(middle + s * off).astype(int)[::-1])] for s in (1, -1))
            assert abs(a - b) > 8, (index, i)
        assert len(f2) == len(f1)


def near_ink(drawing, radius):
    """Distance in pixels from each true vertex within the picture to the nearest pixel that differs from its ground."""
    pixels = drawing.pixels[..., :3].astype(np.float32)
    ground = cv2.medianBlur(drawing.pixels[..., :3].copy(), 31).astype(np.float32)
    far = cv2.distanceTransform((np.abs(pixels - ground).max(2) < 18).astype(np.uint8), cv2.DIST_L2, 5)
    points = np.round(np.array(drawing.truth["f1"] + drawing.truth["f2"])).astype(int)
    inside = ((points >= 0) & (points < [pixels.shape[1], pixels.shape[0]])).all(1)
    return far[points[inside, 1], points[inside, 0]] <= radius


@pytest.mark.parametrize(
    "category", sorted(c for c in HARD if c.endswith(("_wire", "_dashed")) and not RECIPES[c].curved)
)
def test_true_vertices_have_ink_nearby(category):
    wide = 25 if category.startswith(("gaps", "sloppy", "thick")) else 6
    # Dashes need not reach their ends, and the ink of a thin, pale pen may be below the threshold at places.
    assert near_ink(draw(category, 4, 0), wide).mean() > 0.9


@pytest.mark.parametrize("category", sorted(HARD)[::5])
def test_the_same_seed_gives_the_same_bytes(category):
    assert draw(category, 5, 0).encoded() == draw(category, 5, 0).encoded()


@pytest.mark.parametrize("lines", ["wire", "dashed", "removed"])
def test_strokes_stop_short_of_every_corner(lines):
    one = drawn(lines)
    for stroke in strokes_of(one.scene, one.points, lines, Hand(short=9.0), np.random.default_rng(1)):
        length = np.linalg.norm(stroke.path[-1] - stroke.path[0])
        near = np.linalg.norm(one.points - stroke.path[0], axis=1).min()
        # A stroke may also start where another edge hides the rest; short ones keep four tenths of their length.
        assert near > min(9.0 * 0.8, 0.7 * length)


def test_the_border_cuts_off_one_or_two_vertices_of_one_face():
    out = 0
    for index in range(8):
        truth = draw("cropped_wire", 2, index).truth
        inside = []
        for face in ("f1", "f2"):
            points = np.array(truth[face])
            inside.append(((points > -0.5) & (points < [truth["width"] - 0.5, truth["height"] - 0.5])).all(1))
        gone = [int((~i).sum()) for i in inside]
        assert max(gone) <= 2
        assert min(gone) == 0
        out += max(gone) > 0
    assert out >= 6


def test_a_shallow_object_is_a_few_pens_deep():
    for index in range(4):
        truth = draw("shallow_wire", 2, index).truth
        away = np.linalg.norm(np.array(truth["f2"]) - truth["f1"], axis=1)
        assert away.max() < 20
        assert away.max() < 0.08 * np.linalg.norm(np.ptp(np.array(truth["f1"]), axis=0))


def test_tiny_drawings_have_vertices_four_to_eight_pixels_apart():
    for index in range(4):
        truth = draw("tiny_wire", 2, index).truth
        assert (truth["width"], truth["height"]) == (256, 256)
        points = np.array(truth["f1"] + truth["f2"])
        off = np.linalg.norm(points[:, None] - points, axis=2) + 1e3 * np.eye(len(points))
        assert 2.3 < off.min() <= 8.5


@pytest.mark.parametrize("name", list(SUBJECTS))
def test_what_is_no_object_is_drawn_within_the_sheet(name):
    for seed in range(3):
        ink = SUBJECTS[name]((640, 480), Pen(2.0), RULER, np.random.default_rng(seed))
        assert ink.shape == (480, 640)
        assert name == "blank" or ink.sum() > 100


def test_hard_categories_are_recipes_and_negatives_tell_what_they_show():
    assert set(RECIPES) >= HARD
    truth = draw("no_flat", 1, 1).truth
    assert truth["objects"] == []
    assert truth["profile"] == "triangles"


def test_a_low_quality_is_written():
    drawing = draw("pressed_wire", 1, 0)
    assert len(drawing.encoded()) < 0.75 * len(replace(drawing, quality=90).encoded())
