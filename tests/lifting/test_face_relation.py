import numpy as np
import pytest

from sketch2shape.lifting.face_relation import relate_faces

FACE = np.array([[100, 100], [220, 90], [260, 200], [150, 240], [90, 170.0]])


def test_translation_fits_with_nothing_left():
    r = relate_faces(FACE, FACE + [40, -30])
    assert r.d == pytest.approx([40, -30])
    assert (r.translation_rms, r.homothety_rms, r.centre_rms) == pytest.approx((0, 0, 0), abs=1e-6)
    assert abs(r.centre[2]) < 1e-6 * np.hypot(*r.centre[:2])


def test_homothety_meets_in_its_centre():
    r = relate_faces(FACE, 0.7 * FACE + [120, 60])
    assert r.scale == pytest.approx(0.7)
    assert r.homothety_rms == pytest.approx(0, abs=1e-9)
    assert r.translation_rms > 5
    assert r.centre[:2] / r.centre[2] == pytest.approx([400, 200])


def test_residuals_are_those_of_one_vertex():
    rng = np.random.default_rng(0)
    turn = np.arange(400) * 2 * np.pi / 400
    ring = 300 + 100 * np.c_[np.cos(turn), np.sin(turn)]
    shaken = relate_faces(ring + rng.normal(0, 1.5, ring.shape), ring + [200, 50] + rng.normal(0, 1.5, ring.shape))
    assert shaken.translation_rms == pytest.approx(1.5, rel=0.1)
    assert shaken.homothety_rms == pytest.approx(1.5, rel=0.1)


def test_inferred_vertices_do_not_count():
    back = FACE + [40, -30]
    back[2] += 50
    known = np.array([True, True, False, True, True])
    assert relate_faces(FACE, back, known).translation_rms == pytest.approx(0, abs=1e-9)
    assert relate_faces(FACE, back, known & False).translation_rms > 5
