import json
from contextlib import suppress
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketch2shape.corrections.corrections import (
    SCHEMA,
    Corrections,
    corrected,
    corrections_from,
    lift_options,
    parse_corrections,
)
from sketch2shape.errors import UsageError
from sketch2shape.export import to_trimesh
from sketch2shape.lifting import LiftOptions
from sketch2shape.model.picture import Picture

FRONT = [[10, 20], [110, 20], [110, 80], [10, 80]]
BACK = [[40, 0], [140, 0], [140, 60], [40, 60]]
PICTURE = Picture(np.full((100, 160, 3), 255, np.uint8), "box.png")


def one(**entry: Any) -> dict[str, Any]:
    return {"schema": SCHEMA, "objects": [entry]}


def read(data: Any) -> Corrections:
    found = corrections_from(data)
    assert found is not None
    return found


def test_faces_given_by_hand_are_taken_as_they_are() -> None:
    shape = read(one(f1=FRONT, f2=BACK)).objects[0].shape
    assert shape is not None
    assert shape.f1.tolist() == FRONT
    assert shape.f2.tolist() == BACK
    assert shape.confidence == 1
    assert shape.connectors == ("hand", "hand")


def test_a_shift_stands_for_the_back_face_and_indices_for_points() -> None:
    shifted = read(one(f1=FRONT, d=[30, -20])).objects[0].shape
    indexed = read(one(vertices=FRONT + BACK, f1=[0, 1, 2, 3], f2=[4, 5, 6, 7])).objects[0].shape
    assert shifted is not None
    assert indexed is not None
    assert shifted.f2.tolist() == indexed.f2.tolist() == BACK


def test_a_hole_without_a_back_is_shifted_like_the_object() -> None:
    hole = [[40, 40], [40, 60], [70, 60], [70, 40]]
    shape = read(one(f1=FRONT, f2=BACK, holes=[{"f1": hole}])).objects[0].shape
    assert shape is not None
    assert (shape.holes[0].f2 - shape.holes[0].f1).tolist() == [[30, -20]] * 4


def test_projection_and_sizes_go_into_the_lift_options() -> None:
    given_options = read(one(projection="oblique", width="40mm")).objects[0].options(LiftOptions(height="3cm"))
    assert (given_options.projection, given_options.width, given_options.height) == ("oblique", "40mm", "3cm")
    assert not read(one(projection="oblique")).complete


def test_a_corrected_box_is_lifted_to_its_size_without_looking_at_the_picture() -> None:
    result = corrected(PICTURE, read(one(f1=FRONT, f2=BACK, projection="oblique", width="50mm")))
    assert result.picture is PICTURE
    assert result.solids[0].unit == "mm"
    assert result.solids[0].dimensions[0] == pytest.approx(50)
    assert to_trimesh(result.solids).is_watertight


def test_a_report_can_be_given_back() -> None:
    found = {
        "schema": "sketch2shape/1",
        "source": "a.png",
        "objects": [
            {"f1": FRONT, "f2": BACK, "holes": [], "edges": [[0, 1]], "projection": {"family": "oblique", "x": 1},
             "confidence": 0.4, "solid": {"vertices": []}}
        ],
    }  # fmt: skip
    given_back = read(found).objects[0]
    assert given_back.shape is not None
    assert given_back.projection == "oblique"


def test_a_file_for_a_folder_gives_each_picture_its_own() -> None:
    text = json.dumps({"schema": SCHEMA, "pictures": {"sub/a.png": one(f1=FRONT, f2=BACK), "b.png": {"objects": []}}})
    assert parse_corrections(text, "sub/a.png") is not None
    assert parse_corrections(text, "/home/x/sub/a.png") is not None
    assert parse_corrections(text, "other/a.png") is None
    assert parse_corrections(text, "b.png") == Corrections(())


CROSSED = [[10, 20], [110, 80], [110, 20], [10, 80]]


def test_the_schema_need_not_be_said_as_there_is_only_one() -> None:
    assert corrections_from({"objects": [{"projection": "oblique"}]}) == corrections_from(one(projection="oblique"))


@pytest.mark.parametrize(
    ("data", "words"),
    [
        ([], "JSON object"),
        ({"schema": "sketch2shape-corrections/9", "objects": []}, "schema"),
        ({"schema": "sketch2shape-corrections/1"}, "neither"),
        ({}, "neither"),
        (one(f1=FRONT), 'neither "f2" nor "d"'),
        (one(f1=FRONT, f2=BACK[:3]), "front face has 4 vertices, the back face 3"),
        (one(f1=FRONT[:2], f2=BACK[:2]), "needs 3"),
        (one(f1=CROSSED, d=[30, -20]), "crosses itself"),
        (one(f1=[[0, 0], [1, 0], [float("nan"), 1]], d=[3, 3]), "points"),
        (one(f1=[[0, 0], [1, 0], [1e300, 1]], d=[3, 3]), "points"),
        (one(f1=[[0, 0], [10, 0], [True, 1]], d=[3, 3]), "points"),
        (one(f1=FRONT, d=[0, 0]), "on each other"),
        (one(f1=FRONT, d=[30, -20], holes=[{"f1": [[200, 200], [210, 200], [205, 210]]}]), "hole is not inside"),
        (one(vertices=FRONT, f1=[0, 1, 9], f2=[0, 1, 2]), "from 0 to 3"),
        (one(vertices=FRONT, f1=[0, 1, -1], f2=[0, 1, 2]), "from 0 to 3"),
        (one(f1=FRONT, f2=BACK, projektion="oblique"), "projektion"),
        (one(projection="isometric"), "projection"),
        (one(width="a mile"), "length"),
        (one(width=["40mm"]), "length"),
        (one(f1=[[0, 0]] * 5000, f2=[[0, 0]] * 5000), "more than"),
    ],
)
def test_what_is_wrong_is_said_in_plain_words(data: Any, words: str) -> None:
    with pytest.raises(UsageError, match=words):
        corrections_from(data)


@pytest.mark.parametrize("text", ["", "{", b"\xff\xfe\x00", "[" * 100_000])
def test_text_that_is_not_json_is_refused(text: str | bytes) -> None:
    with pytest.raises(UsageError, match="not JSON"):
        parse_corrections(text)


_JSON = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=5),
    lambda inner: (
        st.lists(inner, max_size=4)
        | st.dictionaries(st.sampled_from(["f1", "f2", "d", "holes", "vertices", "projection", "width", "x"]), inner)
    ),
    max_leaves=12,
)


@given(_JSON)
def test_any_json_is_taken_or_refused_in_words(entry: Any) -> None:
    with suppress(UsageError):  # anything else would be a bug
        corrections_from({"schema": SCHEMA, "objects": [entry]})


def test_a_correction_without_faces_says_how_to_lift_what_is_found() -> None:
    file = read(one(projection="oblique", depth="20mm"))
    assert lift_options(file, 0, LiftOptions()).depth == "20mm"
    assert lift_options(file, 1, LiftOptions()) == lift_options(None, 0, LiftOptions()) == LiftOptions()
