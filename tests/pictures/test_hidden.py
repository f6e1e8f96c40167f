import numpy as np

from sketch2shape.model.drawing import TwoFaceObject
from sketch2shape.pictures.hidden import visible_edges, visible_runs
from sketch2shape.pipeline.result import Result


def hidden_pairs(obj: TwoFaceObject) -> set[tuple[int, int]]:
    return {tuple(sorted(e)) for e, seen in zip(obj.edges.tolist(), visible_edges(obj), strict=True) if not seen}


def test_a_box_hides_the_three_edges_of_its_far_lower_left_corner(box: Result) -> None:
    # f1 is 0 1 2 3 from the upper left, f2 is 4 5 6 7; the back goes right and up, so 7 is hidden
    assert hidden_pairs(box.objects[0]) == {(4, 7), (6, 7), (3, 7)}


def test_the_mirrored_box_hides_the_opposite_corner(box: Result) -> None:
    # now the back goes left and down, so that its upper right corner, 5, is hidden
    assert hidden_pairs(box.objects[0].swapped()) == {(4, 5), (5, 6), (1, 5)}


def test_an_edge_is_seen_in_part_through_a_hole(tube: Result) -> None:
    runs = [run for edge in visible_runs(tube.objects[0]) for run in edge]
    partly = [edge for edge in visible_runs(tube.objects[0]) if len(edge) > 1]
    assert partly
    assert all(0 <= a < b <= 1 for a, b, _ in runs)


def test_the_front_face_is_always_in_view(notched: Result) -> None:
    obj = notched.objects[0]
    front = (obj.edges < len(obj.f1)).all(axis=1)
    assert visible_edges(obj)[front].all()


def test_a_tapering_object_hides_what_its_near_end_covers() -> None:
    f1 = np.array([[0.0, 0.0], [100, 0], [100, 100], [0, 100]])
    inner = f1 * 0.5 + 25
    assert visible_edges(TwoFaceObject(inner, f1)).all()  # the near end is the small one: all faces show
    assert visible_edges(TwoFaceObject(f1, inner)).sum() == 4  # the far end lies behind the near one
