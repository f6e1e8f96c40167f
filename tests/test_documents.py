"""The documents name only what there is: links lead somewhere, paths and options exist, commands are understood."""

from __future__ import annotations

import importlib
import inspect
import re
import shlex
from collections.abc import Iterator
from pathlib import Path

import pytest

from evaluation import options
from sketch2shape.command.parser import build_parser, parse

ROOT = Path(__file__).parents[1]
PAGES = sorted([*ROOT.glob("*.md"), *(ROOT / "docs").glob("*.md")])
PLACES = (ROOT, ROOT / "sketch2shape", ROOT / "docs")
PATH = re.compile(r"(?:[\w.-]+/)+[\w.-]*|[\w-]+\.(?:py|toml|yml|cff)")
SHOWN = re.compile(r"^(?:    |\t)?(?:\$ )?(sketch2shape .+)$", re.MULTILINE)
SCHEMA = re.compile(r"/\d+$")
"""Names of schemas look like paths: `sketch2shape/1`."""
HISTORY = "CHANGELOG.md"
"""It tells of what has gone, too."""


SERVED = ("ui", "serve")
"""First words that have options of their own."""


def spans(text: str) -> Iterator[str]:
    """What stands between single backticks, outside of blocks of code."""
    prose = re.sub(r"^```.*?^```", "", text, flags=re.MULTILINE | re.DOTALL)
    return (match[1] for match in re.finditer(r"`([^`\n]+)`", prose))


def commands(text: str) -> Iterator[list[str]]:
    """The words of each command that a page shows, without what the shell does with them."""
    for line in SHOWN.findall(text):
        told = re.split(r"\s{2,}|\s[>|#&]", line)[0]
        if "..." not in told:
            yield shlex.split(told)[1:]


def there(target: str) -> bool:
    return any((place / target).exists() for place in PLACES)


@pytest.mark.parametrize("page", PAGES, ids=lambda p: p.name)
def test_links_lead_to_files_that_are_there(page: Path) -> None:
    for target in re.findall(r"\]\(([^)\s]+)\)", page.read_text("utf-8")):
        if not re.match(r"[a-z]+:|#", target):
            assert (page.parent / target.partition("#")[0]).exists(), target


@pytest.mark.parametrize("page", [p for p in PAGES if p.name != HISTORY], ids=lambda p: p.name)
def test_paths_and_options_that_are_named_exist(page: Path) -> None:
    known = {option for action in build_parser()._actions for option in action.option_strings}
    for span in spans(page.read_text("utf-8")):
        if PATH.fullmatch(span) and span.partition("/")[0] in FOLDERS and not SCHEMA.search(span):
            assert there(span), span
        if re.fullmatch(r"--[a-z][a-z-]+( [A-Z].*)?", span):
            assert span.split()[0] in known | OF_OTHERS, span


FOLDERS = {p.name for place in PLACES for p in place.iterdir()}
"""First parts of paths that lie here; others are a user's."""
OF_OTHERS = {
    option
    for place in ("scripts", "benchmarks", "sketch2shape/ui")
    for file in (ROOT / place).glob("*.py")
    for option in re.findall(r'"(--[a-z][a-z-]+)"', file.read_text("utf-8"))
}
"""Options of the scripts and of `sketch2shape ui`."""


@pytest.mark.parametrize("page", PAGES, ids=lambda p: p.name)
def test_commands_that_are_shown_are_understood(page: Path) -> None:
    for words in commands(page.read_text("utf-8")):
        if words[0] not in SERVED and not {"--help", "--version"} & set(words):
            parse(words)


def with_shared_options(script: str) -> str:
    """A script with the functions of `evaluation.options` that it calls."""
    shared = [f for name, f in inspect.getmembers(options, inspect.isfunction) if f"{name}(parser" in script]
    return "\n".join([script, *map(inspect.getsource, shared)])


@pytest.mark.parametrize("page", [p for p in PAGES if p.name != HISTORY], ids=lambda p: p.name)
def test_scripts_that_are_shown_exist_and_know_their_options(page: Path) -> None:
    for line in re.findall(r"python (scripts/[^`\n]+)", page.read_text("utf-8")):
        script, *words = re.split(r"\s+", re.split(r"\s{2,}", line.strip())[0])
        assert there(script.rstrip(".,)")), script
        known = with_shared_options((ROOT / script.rstrip(".,)")).read_text("utf-8"))
        for option in (word for word in words if word.startswith("--")):
            assert f'"{option}"' in known, f"{option} of {script}"


def test_what_the_checks_look_at_is_found() -> None:
    text = (
        "Run `reading/read.py`:\n\n    sketch2shape a.png -o - > b.obj\n    sketch2shape INPUT...\n\n```\n`no`\n```\n"
    )
    assert list(spans(text)) == ["reading/read.py"]
    assert list(commands(text)) == [["a.png", "-o", "-"]]
    assert there("reading/read.py")
    assert not there("reading/nothing.py")


def test_figures_of_the_readme_stand_in_the_results() -> None:
    results = (ROOT / "docs" / "results.md").read_text("utf-8")
    figures = re.findall(r"(\d+(?:\.\d+)?) %", (ROOT / "README.md").read_text("utf-8"))
    assert len(figures) >= 4
    assert [figure for figure in figures if not re.search(rf"\b{re.escape(figure)}\b", results)] == []


def rows(page: str) -> Iterator[list[str]]:
    """The cells of each row of a page's tables."""
    for line in (ROOT / "docs" / page).read_text("utf-8").splitlines():
        if line.startswith("| "):
            yield [cell.strip() for cell in line.strip("| ").split(" | ")]


def test_the_glossary_names_what_its_places_define() -> None:
    checked = 0
    for cells in rows("glossary.md"):
        told = list(spans(cells[-1]))
        files = [place / span for span in told if span.endswith(".py") for place in PLACES if (place / span).exists()]
        text = "\n".join(file.read_text("utf-8") for file in files)
        for part in (part for span in told if files and "/" not in span for part in span.split(".")):
            assert re.search(rf"(class|def) {part}\b|^\s*{part}\b.*[:=]", text, re.MULTILINE), f"{part} in {files}"
            checked += 1
    assert checked > 40


def test_the_faces_in_the_architecture_give_what_is_named() -> None:
    for room, *cells in (cells for cells in rows("architecture.md") if len(cells) == 2):
        room = re.sub(r"\[(\w+)\].*", r"\1", room)
        if (ROOT / "sketch2shape" / room / "__init__.py").exists():
            face = importlib.import_module(f"sketch2shape.{room}")
            for name in (span for span in spans(cells[-1]) if span.isidentifier() and span not in ROOMS):
                assert hasattr(face, name), f"{room}.{name}"


ROOMS = {p.name for p in (ROOT / "sketch2shape").iterdir() if p.is_dir()}
