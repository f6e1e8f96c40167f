"""The measure for CAD parts, on boxes whose place is known."""

import cv2
import numpy as np
import pytest
import trimesh

from evaluation import meshes
from evaluation.cases import Case
from evaluation.measure import measure
from sketch2shape.model import Picture, Projection, Solid, TwoFaceObject, two_face_boundary
from sketch2shape.pipeline.result import Result


def turned():
    """Seen from a corner."""
    return trimesh.transformations.euler_matrix(0.5, 0.7, 0.0)[:3, :3]


def box(deeper=1.0):
    """A box of 3 x 2 x 4 in the frame of the true meshes: y up, seen along z."""
    corners = np.array([[x, y, z] for z in (0, 4 * deeper) for x, y in ((0, 0), (3, 0), (3, 2), (0, 2))], float)
    return corners @ turned().T


EDGES = (
    [(i, (i + 1) % 4) for i in range(4)] + [(i + 4, (i + 1) % 4 + 4) for i in range(4)] + [(i, i + 4) for i in range(4)]
)


@pytest.fixture
def drawn(tmp_path):
    """Picture and true mesh of the box, and its corners in pixels with the depth at the same scale."""
    corners = box() * [40, -40, 40]
    corners = corners - corners.min(0) + [30.0, 30.0, 0.0]
    picture = np.full((300, 300), 255, np.uint8)
    for a, b in EDGES:
        cv2.line(picture, np.round(corners[a, :2]).astype(int), np.round(corners[b, :2]).astype(int), 0, 1)
    for x, y, _ in corners:
        cv2.circle(picture, (round(x), round(y)), 2, 0, -1)
    cv2.imwrite(str(tmp_path / "1.png"), picture)
    trimesh.convex.convex_hull(box()).export(tmp_path / "1.glb")
    truth = {"mesh": str(tmp_path / "1.glb"), "category": "straight_two_face"}
    return Case("abc", "straight_two_face/1", str(tmp_path / "1.png"), truth), corners


def answer(corners):
    found = TwoFaceObject(corners[:4, :2], corners[4:, :2], confidence=0.95)
    solid = Solid(two_face_boundary(corners, (4,)), Projection("axonometric"))
    return Result((found,), (solid,), Picture(np.zeros((2, 2, 3), np.uint8)))


def test_the_true_box_is_right_and_so_is_its_mirror_image_in_depth(drawn):
    case, corners = drawn
    assert measure(case, lambda _: answer(corners)).right
    assert measure(case, lambda _: answer(corners * [1, 1, -1])).right


def test_another_depth_another_place_and_no_answer_are_wrong(drawn):
    case, corners = drawn
    long = answer(np.vstack([corners[:4], corners[:4] + 1.3 * (corners[4:] - corners[:4])]))
    assert "area" in measure(case, lambda _: long).cause
    away = measure(case, lambda _: answer(corners + [25, 0, 0]))
    assert away.wrong
    assert "surface is off" in away.cause
    none = Result((), (), Picture(np.zeros((2, 2, 3), np.uint8)))
    assert measure(case, lambda _: none).cause == "0 objects reported"


def test_a_camera_brings_a_standing_solid_into_the_picture():
    corners = box()
    mesh = trimesh.convex.convex_hull(corners)
    camera = np.array([[20.0, 0, 0, 50], [0, 0, -20, 80], [0, 0, 0, 1]])
    placed = meshes.in_picture(mesh, camera.tolist())
    assert placed.vertices == pytest.approx(
        np.c_[mesh.vertices[:, 0] * 20 + 50, 80 - mesh.vertices[:, 2] * 20, mesh.vertices[:, 1] * 20]
    )
    scaled = meshes.in_picture(mesh, (camera * 3).tolist())
    assert scaled.vertices == pytest.approx(placed.vertices)
    camera[2, 0] = 0.01
    assert meshes.in_picture(mesh, camera.tolist()) is None


def test_a_reading_is_right_by_its_corners_whatever_its_depth(drawn):
    case, corners = drawn
    true = meshes.corners(meshes.true_mesh(case.truth["mesh"], case.picture))
    assert meshes.has_corners(corners[::-1, :2] + 1.0, true)
    assert not meshes.has_corners(corners[:6, :2], true)
    moved = corners[:, :2].copy()
    moved[0] += 25.0
    assert not meshes.has_corners(moved, true)
