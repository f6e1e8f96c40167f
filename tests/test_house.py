"""The house: imports run down only, without a circle, and its picture in the documentation is the present one."""

from __future__ import annotations

import importlib
import sys
from pathlib import Path
from types import ModuleType

import pytest

ROOT = Path(__file__).parents[1]


@pytest.fixture(scope="module")
def house() -> ModuleType:
    sys.path.insert(0, str(ROOT / "scripts"))
    yield importlib.import_module("house")
    sys.path.remove(str(ROOT / "scripts"))


def test_no_circle_of_modules_or_rooms_and_no_import_that_climbs(house):
    now = house.read(ROOT)
    assert house.circles(now.imports) == []
    assert house.circles(now.edges) == []
    assert house.climbing(now.edges, house.layers(ROOT)) == []
    assert len(now.at_root) <= 4


def test_the_picture_in_the_documentation_is_the_present_one(house):
    drawn = importlib.import_module("house_picture").picture(house.read(ROOT), house.layers(ROOT))
    shown = (ROOT / "docs" / "architecture.svg").read_text("utf-8")
    assert drawn == shown, "python scripts/house.py --picture docs/architecture.svg"


def test_imports_of_every_form_are_seen(house, tmp_path):
    package = tmp_path / house.PACKAGE
    for name, text in {
        "__init__.py": "",
        "low/__init__.py": "",
        "low/inner.py": "from sketch2shape.top import face",
        "top/__init__.py": "from .face import f",
        "top/face.py": "def f():\n    from ..low import inner\n",
        "side.py": "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    import sketch2shape.low.inner\n",
    }.items():
        (package / name).parent.mkdir(parents=True, exist_ok=True)
        (package / name).write_text(text)
    seen = house.read(tmp_path)
    short = {(a.removeprefix("sketch2shape."), b.removeprefix("sketch2shape.")) for a, b in seen.imports}
    assert short == {("low.inner", "top.face"), ("top", "top.face"), ("top.face", "low.inner"), ("side", "low.inner")}
    assert seen.edges == {("low", "top"), ("top", "low"), ("side", "low")}
    assert house.circles(seen.edges) == [["low", "top"]]
    assert house.circles(seen.imports) == [["sketch2shape.low.inner", "sketch2shape.top.face"]]
    assert house.climbing(seen.edges, [["top", "side"], ["low"]]) == [("low", "top")]
    assert [a for a, _ in seen.past_faces] == ["sketch2shape.low.inner", "sketch2shape.side", "sketch2shape.top.face"]
