"""Lines between the faces of a wireframe."""

from dataclasses import replace

import numpy as np
import pytest
from round_sketches import ARCH, CONE, CYLINDER, drawn, plate, slot
from sketches import ink_of, paper

from sketch2shape.strokes import thin
from sketch2shape.sweeps import Way, joints, shifts, wire_shifts
from sketch2shape.sweeps.rungs import MOST_JOINTS, off_both, rung_ends

SLOT = slot(Way(np.array([60.0, 40.0])), tangents=True)
PLATE = replace(plate(Way(np.array([50.0, 30.0]))), tangents=True)


def seen(sweep, lines="wire"):
    skeleton = thin(ink_of(drawn(sweep, lines)))
    return skeleton, joints(skeleton), float(np.hypot(*np.ptp(skeleton.points, axis=0)))


def test_lines_meet_where_a_vertex_is_drawn():
    _, at, _ = seen(ARCH)
    corners = ARCH.rings[0].vertices[2:]
    for corner in np.concatenate([corners, corners + ARCH.way.shift]):
        assert np.hypot(*(at - corner).T).min() < 8


@pytest.mark.parametrize("sweep", [ARCH, CYLINDER, SLOT, PLATE], ids=["arch", "cylinder", "slot", "plate"])
def test_the_shift_of_a_wireframe_is_the_best(sweep):
    skeleton, at, size = seen(sweep)
    best = wire_shifts(skeleton, at, shifts(skeleton, size), size)[0]
    assert min(np.hypot(*(best - s * sweep.way.shift)) for s in (1, -1)) < 4


def test_a_cone_has_none():
    skeleton, at, size = seen(CONE)
    assert wire_shifts(skeleton, at, shifts(skeleton, size), size) == []


def test_rungs_end_at_the_vertices_of_the_front():
    skeleton, at, size = seen(SLOT)
    ends = rung_ends(skeleton, at, SLOT.way.shift, size)
    for vertex in SLOT.rings[0].vertices:
        assert np.hypot(*(ends - vertex).T).min() < 6


def test_a_place_of_the_front_face_is_on_ink_of_both():
    skeleton, _, _ = seen(SLOT)
    off = off_both(skeleton, SLOT.way.shift)
    x, y = np.rint(SLOT.rings[0].line).astype(int).T
    assert off[y, x].max() < 3
    x, y = np.rint(SLOT.rings[0].line + SLOT.way.shift).astype(int).T
    assert np.median(off[y, x]) > 5


def test_of_a_texture_only_so_many_joints_are_told():
    """Thousands of them are looked at by nobody."""
    picture = paper()
    for x in range(20, 460, 12):
        for y in range(20, 460, 12):
            picture[y : y + 2, x : x + 7] = 0
    skeleton = thin(ink_of(picture))
    assert len(skeleton.paths) > MOST_JOINTS
    assert len(joints(skeleton)) == MOST_JOINTS + 1
