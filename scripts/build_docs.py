#!/usr/bin/env python3
"""Build the documentation as a site, strictly: a broken link or a page left out ends it with an error.

    pip install '.[docs]' && python scripts/build_docs.py [--site FOLDER] [--pages-only FOLDER]

Pages come from README.md and its neighbours, from docs/, from the command's parser, from the public names, and from
data/synthetic. They are gathered in a temporary folder, so that nothing made by this is committed.
"""

from __future__ import annotations

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

from make_gallery import write_gallery

import sketch2shape as s2s
from sketch2shape.command.parser import build_parser

ROOT = Path(__file__).resolve().parents[1]
BESIDE = {"README.md": "index.md", "CONTRIBUTING.md": "", "CHANGELOG.md": "", "SECURITY.md": ""}
"""Pages beside the package -> their names on the site, where they differ."""


def gather(folder: Path) -> None:
    """All pages of the site in the folder."""
    shutil.copytree(ROOT / "docs", folder, dirs_exist_ok=True, ignore=shutil.ignore_patterns("*.html", "__pycache__"))
    shutil.copy(ROOT / "LICENSE", folder / "LICENSE.txt")
    shutil.copy(ROOT / "CITATION.cff", folder)
    for name, other in BESIDE.items():
        text = (ROOT / name).read_text("utf-8")
        (folder / (other or name)).write_text(_moved(text), "utf-8")
    (folder / "options.md").write_text(options_page(), "utf-8")
    (folder / "reference.md").write_text(reference_page(), "utf-8")
    write_gallery(folder)


def _moved(text: str) -> str:
    """A page from beside docs/ with its links as they are within."""
    return re.sub(r"\]\((?:docs/)?(LICENSE|[^):]*)", lambda m: "](" + _target(m[1]), text)


def _target(link: str) -> str:
    return {"LICENSE": "LICENSE.txt", "README.md": "index.md"}.get(link, link)


def options_page() -> str:
    """Every option of the command, by group, as the parser has them."""
    parser = build_parser()
    parts = ["# All options\n\nMade from the parser; `sketch2shape --help` prints the same.\n"]
    for group in parser._action_groups:
        rows = [row for action in group._group_actions for row in _option_rows(action)]
        if rows:
            title = (group.title or "").capitalize()
            parts.append(f"## {title}\n\n| option | |\n|---|---|\n" + "".join(rows))
    return "\n".join(parts)


def _option_rows(action: argparse.Action) -> Iterator[str]:
    if action.help != argparse.SUPPRESS:
        names = ", ".join(action.option_strings)
        words = action.metavar or ("" if action.nargs == 0 else (action.choices and "|".join(action.choices)) or "")
        shown = f"{names} {words}".strip().replace("|", "\\|")
        yield f"| `{shown}` | {(action.help or '').replace('|', chr(92) + '|').replace('%%', '%')} |\n"


def reference_page() -> str:
    """Every public name, by the room that defines it."""
    parts = ["# Reference\n\nAll names of `import sketch2shape as s2s`.\n"]
    for room, names in s2s._ROOMS.items():
        parts.append(f"## {room}\n")
        parts += [f"::: sketch2shape.{room}.{name}\n" for name in names]
    return "\n".join(parts)


def build(pages: Path, site: Path) -> int:
    """The site of gathered pages; the exit code of mkdocs, 1 where a link is broken."""
    # not --quiet: warnings that are not shown are not counted as errors
    call = [sys.executable, "-m", "mkdocs", "build", "--strict", "--site-dir", str(site.resolve())]
    known = {**os.environ, "SKETCH2SHAPE_PAGES": str(pages), "NO_MKDOCS_2_WARNING": "1"}
    return subprocess.run(call, cwd=ROOT, env=known).returncode


def main() -> int:
    """Gather and build; the exit code is that of mkdocs."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--site", type=Path, default=ROOT / "out" / "site", help="where the site goes (out/site)")
    parser.add_argument("--pages-only", type=Path, metavar="FOLDER", help="gather the pages there and stop")
    options = parser.parse_args()
    if options.pages_only:
        gather(options.pages_only)
        return 0
    with tempfile.TemporaryDirectory() as folder:
        gather(Path(folder))
        return build(Path(folder), options.site)


if __name__ == "__main__":
    sys.exit(main())
