import json
from pathlib import Path

import pytest

from sketch2shape.corrections.corrections import SCHEMA, parse_corrections
from sketch2shape.corrections.file import read_corrections
from sketch2shape.errors import UsageError

BOX = {"f1": [[10, 20], [110, 20], [110, 80], [10, 80]], "d": [30, -20]}


def save(path: Path, **more: object) -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps({"schema": SCHEMA, "objects": [BOX], **more}))
    return path


def test_one_file_is_for_one_picture(tmp_path: Path) -> None:
    file = str(save(tmp_path / "a.json"))
    assert parse_corrections(read_corrections(file, many=False), "any.png") is not None
    with pytest.raises(UsageError, match="is for one picture"):
        read_corrections(file, many=True)


def test_a_folder_of_saved_files_is_told_apart_by_picture(tmp_path: Path) -> None:
    save(tmp_path / "sub" / "a.corrections.json", source="a.png")
    save(tmp_path / "b.corrections.json", source="b.jpg")
    text = read_corrections(str(tmp_path), many=True)
    assert parse_corrections(text, "sub/a.png") is not None
    assert parse_corrections(text, "b.jpg") is not None
    assert parse_corrections(text, "a.png") is None


def test_what_is_wrong_is_said_before_any_work(tmp_path: Path) -> None:
    save(tmp_path / "bad.json", objects=[{**BOX, "d": [0, 0]}])
    (tmp_path / "text.json").write_text("no")
    (tmp_path / "empty").mkdir()
    for name, words in (
        ("bad.json", "lie on each other"),
        ("text.json", "not JSON"),
        ("empty", "holds no file"),
        ("missing.json", "cannot read"),
    ):
        with pytest.raises(UsageError, match=words):
            read_corrections(str(tmp_path / name), many=False)
