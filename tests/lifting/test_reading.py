import numpy as np
import pytest

import sketch2shape.lifting.reading as stage
from sketch2shape.lifting.reading import _likeliest, read_parallel, refined_pose
from sketch2shape.lifting.regularity import find_relations

ELL = np.array([[0, 0], [2, 0], [2, 1], [1, 1], [1, 3], [0, 3.0]]) * 60
ARROW = 2 * np.array([[0, 30], [60, 30], [60, 0], [110, 50], [60, 100], [60, 70], [0, 70.0]])
CHANNEL = 90 * np.array([[0, 0], [2, 0], [2, 1.6], [1.4, 1.6], [1.4, 0.6], [0.6, 0.6], [0.6, 1.6], [0, 1.6]])
HEPTAGON = 90 * np.array([[np.cos(t), np.sin(t)] for t in np.deg2rad([4, 61, 97, 160, 205, 262, 331])])


def seen(face, azimuth, elevation, depth=100.0, astray=0.0):
    """The face of a standing prism as drawn, d drawn astray by an angle in radians, and the face's slant in degrees."""
    a, e = np.deg2rad([azimuth, elevation])
    yaw = np.array([[np.cos(a), 0, np.sin(a)], [0, 1, 0], [-np.sin(a), 0, np.cos(a)]])
    pitch = np.array([[1, 0, 0], [0, np.cos(e), np.sin(e)], [0, -np.sin(e), np.cos(e)]])
    view = (yaw.T @ pitch.T)[:, :2]
    turn = np.array([[np.cos(astray), np.sin(astray)], [-np.sin(astray), np.cos(astray)]])
    return face @ view[:2], depth * view[2] @ turn, float(np.rad2deg(np.arccos(np.cos(a) * np.cos(e))))


def read(face, d, noise=0.3):
    """The best reading of each name."""
    wobble = noise * np.sqrt(2.0 / len(face)) / np.hypot(*d)
    found = {}
    for reading in read_parallel(face, d, find_relations(face, [len(face)], face, noise), noise, wobble):
        if reading.name not in found or reading.odds > found[reading.name].odds:
            found[reading.name] = reading
    return found


def against(readings):
    """Log odds of an oblique drawing against any axonometric view."""
    return readings["oblique"].odds - max(r.odds for name, r in readings.items() if name != "oblique")


def pose(readings):
    return refined_pose(readings["axonometric"].view, readings["axonometric"].pose)


@pytest.mark.parametrize(("azimuth", "elevation"), [(25.0, 20.0), (-45.0, 35.264), (60.0, 15.0), (72.0, 35.0)])
def test_right_angles_tell_the_slant(azimuth, elevation):
    face, d, slant = seen(ELL, azimuth, elevation)
    readings = read(face, d)
    assert against(readings) < 0.0
    assert np.rad2deg(pose(readings).slant) == pytest.approx(slant, abs=0.05)


def test_a_level_face_in_true_shape_is_oblique():
    assert against(read(ELL, np.array([60.0, -60.0]))) > 3.0


def test_a_short_d_drawn_astray_is_turned_back():
    """Seen nearly from its edge, the face would be sheared out of shape by a d drawn a degree off."""
    astray = np.deg2rad(0.8)
    face, d, slant = seen(ARROW, 78.0, 20.0, 25.0, astray)
    found = pose(read(face, d, noise=0.6))
    assert np.rad2deg(found.slant) == pytest.approx(slant, abs=0.5)
    assert -1.2 * astray < found.turn < -0.6 * astray
    straight = seen(ARROW, 78.0, 20.0, 25.0)[1]
    assert np.linalg.norm(found.turned(d) - straight) < 0.4 * np.linalg.norm(d - straight)


def test_edges_crowded_across_d_show_a_face_without_right_angles_aslant():
    found = [np.rad2deg(pose(read(*seen(HEPTAGON, *view)[:2])).slant) for view in ((20.0, 15.0), (65.0, 15.0))]
    assert found[0] + 10.0 < found[1]


def test_edges_along_an_upright_d_are_not_oblique_however_it_is_shaken():
    for aside in (0.0, 0.5, 1.0):
        upright = read(ELL, np.array([aside, -27.0]), noise=1.0)
        straight = read(ELL, np.array([19.0, -19.0]), noise=1.0)
        assert upright["oblique"].odds < straight["oblique"].odds - 4.0


def test_receding_edges_at_a_usual_angle_speak_for_an_oblique_drawing():
    triangle = np.array([[0, 0], [140, 22], [60, -90.0]])
    odds = []
    for degrees in (45.0, 38.0):
        a = np.deg2rad(degrees)
        odds.append(against(read(triangle, 80 * np.array([np.cos(a), -np.sin(a)]))))
    assert odds[0] > odds[1] + 1.0


def test_a_shaky_dimetric_drawing_is_still_read_as_one():
    """Each axis is drawn a little astray: that counts once, not in the right angles between the axes again."""
    face, d, _ = seen(CHANNEL, 20.705, 19.471, 150.0)
    right = 0
    for off in np.random.default_rng(3).normal(0.0, 4.0, (40, *face.shape)):
        readings = read(face + off, d + 2.0 * off.mean(axis=0), noise=4.0)
        right += max(readings.values(), key=lambda r: r.odds).name == "dimetric"
    assert right >= 36


def test_a_vague_pose_is_the_mean_of_those_it_may_be():
    slants, still = np.deg2rad([20.0, 22.0, 24.0, 26.0]), np.zeros(1)
    sharp, vague, two = (
        _likeliest(np.array([chance]), slants, still)
        for chance in ([0.0, 1.0, 0.01, 0.0], [0.6, 1.0, 0.9, 0.5], [1.0, 0.1, 0.1, 0.9])
    )
    assert np.rad2deg(sharp.slant) == pytest.approx(22.0)
    assert np.rad2deg(vague.slant) == pytest.approx((12.0 + 22.0 + 21.6 + 13.0) / 3.0)
    assert np.rad2deg(two.slant) == pytest.approx(20.0)
    assert [sharp.vague, vague.vague, two.vague] == [False, True, False]
    assert refined_pose(None, vague) is vague


def test_the_height_of_a_pyramid_is_not_measured_by_its_sides(monkeypatch):
    """A prism's depth is evidence, a pyramid's height is none."""
    asked = []
    told = stage.depth_odds
    monkeypatch.setattr(stage, "depth_odds", lambda *args: asked.append(1) or told(*args))
    face, d, _ = seen(100.0 * np.array([[0, 0], [1, 0], [1, 1], [0, 1.0]]), 30.0, 25.0)
    relations = find_relations(face, [4], face, 1.0)
    for pyramid, times in ((True, 0), (False, 1)):
        asked.clear()
        read_parallel(face, d, relations, 1.0, 0.01, pyramid=pyramid)
        assert len(asked) == times
