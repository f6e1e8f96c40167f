"""The examples of the documentation run, and the documentation shows no picture that is not there."""

from __future__ import annotations

import ast
import importlib.util
import json
import re
import shutil
from itertools import pairwise
from pathlib import Path

import pytest
from PIL import Image

from sketch2shape.command import main
from sketch2shape.corrections.corrections import SCHEMA

ROOT = Path(__file__).parents[1]
DOCS = ROOT / "docs"
PAGES = sorted([*ROOT.glob("*.md"), *DOCS.glob("*.md")])
BLOCK = re.compile(r"^```python\n(.*?)^```", re.MULTILINE | re.DOTALL)
COMMAND = re.compile(r"^    sketch2shape (.+)$", re.MULTILINE)
DRAWINGS = {
    "drawing.png": "hand_removed/000.png",
    "photo.jpg": "photo_wire/000.jpg",
    "oblique.png": "clean_wire_oblique/000.png",
    "wireframe.png": "clean_wire_axono/000.png",
    "sheet.png": "multi_wire/000.png",
    "drawings/a.png": "cut/000.png",
    "drawings/more/b.png": "dots/000.png",
    "drawing.svg": "../vectors/svg/drawio.svg",
    "board.excalidraw": "../vectors/excalidraw/turned.excalidraw",
    "notes.inkml": "../vectors/inkml/upward.inkml",
    "strokes.json": "../vectors/pen/bare.json",
}
"""Name that the pages use -> a committed drawing."""

TRIED = [
    line
    for page in ("cookbook.md", "solids.md")
    for line in COMMAND.findall((DOCS / page).read_text("utf-8"))
    if line != "ui"
]


@pytest.fixture
def folder(tmp_path: Path, drawings: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The current folder, with the drawings that the pages speak of."""
    for name, source in DRAWINGS.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(drawings / source, tmp_path / name)
    pages = [Image.open(tmp_path / "drawings" / name).convert("L") for name in ("a.png", "more/b.png")]
    pages[0].save(tmp_path / "scan.tif", save_all=True, append_images=pages[1:])
    given = {"schema": SCHEMA, "objects": [{"width": "40mm"}]}
    (tmp_path / "drawing.corrections.json").write_text(json.dumps(given))
    monkeypatch.chdir(tmp_path)
    return tmp_path


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


@pytest.mark.parametrize("page", [p for p in PAGES if BLOCK.search(p.read_text("utf-8"))], ids=lambda p: p.name)
def test_python_of_a_page_runs(page: Path, folder: Path) -> None:
    names: dict[str, object] = {}
    exec("import sketch2shape as s2s\nresult = s2s.reconstruct('drawing.png')", names)
    names["paths_or_arrays"] = ["drawing.png", "photo.jpg"]
    for block in BLOCK.findall(page.read_text("utf-8")):
        exec(compile(block.replace("result.export(...)", "result.mesh"), page.name, "exec"), names)


@pytest.mark.parametrize("line", TRIED)
def test_commands_that_are_shown_run(line: str, folder: Path) -> None:
    words = line.split()
    if "--resume" in words:
        assert main([word for word in words if word != "--resume"]) == 0
    assert main(words) == 0
    outputs = [b for a, b in pairwise(words) if a in ("-o", "--html", "--report", "--index")]
    assert outputs
    assert all((folder / output).exists() for output in outputs)


def test_the_notebook_runs_and_its_values_show_themselves(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(DOCS)
    cells = json.loads((DOCS / "notebook.ipynb").read_text("utf-8"))["cells"]
    names: dict[str, object] = {}
    shown = []
    for cell in (cell for cell in cells if cell["cell_type"] == "code"):
        assert cell["outputs"] == [], "clear the outputs before it is committed"
        *steps, last = ast.parse("".join(cell["source"])).body
        exec(compile(ast.Module(steps, []), "notebook", "exec"), names)
        ends_in_value = isinstance(last, ast.Expr)
        code = ast.Expression(last.value) if ends_in_value else ast.Module([last], [])
        shown.append(eval(compile(code, "notebook", "eval" if ends_in_value else "exec"), names))
    assert "<" in shown[0]._repr_html_()
    assert all(repr(value) for value in shown)


@pytest.mark.parametrize("page", sorted(DOCS.glob("*.md")), ids=lambda p: p.name)
def test_a_page_shows_only_pictures_that_are_there(page: Path) -> None:
    for target in re.findall(r"!\[[^]]*\]\(([^)]+)\)", page.read_text("utf-8")):
        assert (DOCS / target).is_file(), target
