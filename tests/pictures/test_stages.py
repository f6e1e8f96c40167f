import numpy as np

from sketch2shape.pictures import encode_png, stage_panels, stages
from sketch2shape.pictures.palette import BACK, FRONT
from sketch2shape.pipeline.result import Result


def has(pixels: np.ndarray, colour: tuple[int, int, int]) -> bool:
    return bool((np.abs(pixels.astype(int) - colour).max(axis=2) < 8).any())


def test_the_panels_follow_the_papers_columns(notched: Result) -> None:
    titles = [p.title for p in stage_panels(notched)]
    assert titles == [
        "Input",
        "Vertices and regions",
        "Face f1",
        "Face f2",
        "Both faces",
        "Each face connected",
        "Complete object",
        "Solid",
    ]


def test_each_face_panel_shows_its_own_face_only(notched: Result) -> None:
    front, back = stage_panels(notched)[2:4]
    assert has(front.pixels, FRONT)
    assert not has(front.pixels, BACK)
    assert has(back.pixels, BACK)
    assert not has(back.pixels, FRONT)


def test_the_sheet_is_the_same_each_time(tube: Result) -> None:
    assert encode_png(stages(tube)) == encode_png(stages(tube))


def test_a_picture_without_an_object_shows_its_input_alone(nothing: Result) -> None:
    assert [p.title for p in stage_panels(nothing)] == ["Input"]
    assert stages(nothing).ndim == 3
