"""The pages of the site that are made from code and drawings."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import pytest

import sketch2shape as s2s
from sketch2shape.command.parser import build_parser

ROOT = Path(__file__).parents[1]


@pytest.fixture(scope="module")
def site() -> Iterator[ModuleType]:
    sys.path.insert(0, str(ROOT / "scripts"))
    yield importlib.import_module("build_docs")
    sys.path.remove(str(ROOT / "scripts"))


def test_every_option_and_every_public_name_has_its_place(site: ModuleType) -> None:
    options, reference = site.options_page(), site.reference_page()
    for action in build_parser()._actions:
        assert all(f"`{name}" in options or f", {name}" in options for name in action.option_strings)
    assert all(f".{name}\n" in reference for name in s2s.__all__ if name != "__version__")


def test_pages_beside_the_documentation_lead_to_their_new_places(site: ModuleType) -> None:
    text = "[a](docs/api.md) [b](LICENSE) [c](https://example.org/docs/x) ![d](docs/readme.png) [e](CHANGELOG.md#x)"
    moved = "[a](api.md) [b](LICENSE.txt) [c](https://example.org/docs/x) ![d](readme.png) [e](CHANGELOG.md#x)"
    assert site._moved(text) == moved


def test_every_page_is_in_the_contents(site: ModuleType) -> None:
    contents = (ROOT / "mkdocs.yml").read_text("utf-8")
    for page in [*(p.name for p in (ROOT / "docs").glob("*.md")), *(new or old for old, new in site.BESIDE.items())]:
        assert f": {page}\n" in contents, page


def test_the_gallery_shows_answers_and_refusals(site: ModuleType, tmp_path: Path) -> None:
    gallery = importlib.import_module("make_gallery")
    gallery.write_gallery(tmp_path, "cut")
    assert "![cut](gallery/cut.jpg)\n\nright; confidence 0." in (tmp_path / "gallery.md").read_text("utf-8")
    gallery.write_gallery(tmp_path, "negative")
    assert "right; refused: " in (tmp_path / "gallery.md").read_text("utf-8")
    assert {p.name for p in (tmp_path / "gallery").iterdir()} == {"cut.jpg", "negative.jpg"}


def test_entries_of_docstrings_become_lists(site: ModuleType) -> None:
    pytest.importorskip("griffe", reason="griffe is part of the extra `docs`")
    lists = importlib.import_module("docstring_lists")
    text = "What it is: a thing.\n\nwidth  : of it, as\n         40mm\nheight : the same\n\nRaises: nothing here"
    made = (
        "What it is: a thing.\n\n- **width**: of it, as\n    40mm\n- **height**: the same\n\n- **Raises**: nothing here"
    )
    assert lists.with_lists(text) == made


def test_a_broken_link_ends_the_build(site: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("mkdocs", reason="mkdocs is part of the extra `docs`")
    pages = tmp_path / "pages"
    monkeypatch.setattr(site, "write_gallery", lambda folder: (folder / "gallery.md").write_text("# Gallery\n"))
    site.gather(pages)
    assert site.build(pages, tmp_path / "site") == 0
    (pages / "gallery.md").write_text("[nowhere](nowhere.md)\n")
    assert site.build(pages, tmp_path / "site") == 1
