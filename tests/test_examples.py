"""The examples of the documentation run, and the documentation shows no picture that is not there."""

from __future__ import annotations

import importlib.util
import re
from pathlib import Path

import pytest

DOCS = Path(__file__).parents[1] / "docs"


def test_the_examples_run_and_write_their_pictures(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    spec = importlib.util.spec_from_file_location("examples_of_the_docs", DOCS / "examples.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    module.main(tmp_path, ["wireframe", "hole"])
    printed = capsys.readouterr().out
    assert "watertight: True" in printed
    assert "refused: the picture is blank" in printed
    made = {p.name for p in tmp_path.iterdir()}
    assert {"overlay.png", "stages.png", "preview.png", "viewer.html", "contact-sheet.png", "index.html"} <= made


@pytest.mark.parametrize("page", sorted(DOCS.glob("*.md")), ids=lambda p: p.name)
def test_a_page_shows_only_pictures_that_are_there(page: Path) -> None:
    for target in re.findall(r"!\[[^]]*\]\(([^)]+)\)", page.read_text("utf-8")):
        assert (DOCS / target).is_file(), target
