#!/usr/bin/env python3
"""Write docs/errors.md from the error tree: python scripts/make_error_page.py [--check]"""

from __future__ import annotations

import argparse
import inspect
import sys
from collections.abc import Iterator
from pathlib import Path

from sketch2shape import errors

PAGE = Path(__file__).parents[1] / "docs" / "errors.md"

HEAD = """# Errors and exit codes

Made from `sketch2shape/errors.py` by `scripts/make_error_page.py`.

A failure is one line on standard error, `FILE: what happened. Try: what helps`, and an exit code. In Python each is an
exception below `sketch2shape.Sketch2ShapeError`, with `.message`, `.advice` and `.exit_code`.

| exit code | error | when | what helps |
|---|---|---|---|
| 0 | | all done | |
"""

TAIL = """| 3 | | several inputs, and some of them failed; the line of each says why | `--report FILE.jsonl` lists all |
| 130 | | interrupted by Ctrl-C, SIGTERM or SIGHUP | `--resume` |

A single picture ends with its own code; a folder, or several inputs, with 0, 3 or 130. What stops a batch before it
starts (no pictures in it, outputs that exist already, options that contradict each other) ends with its own code too.
"""


def tree(kind: type[errors.Sketch2ShapeError]) -> Iterator[type[errors.Sketch2ShapeError]]:
    yield kind
    for child in kind.__subclasses__():
        yield from tree(child)


def page() -> str:
    """The page as it should be."""
    kinds = sorted(tree(errors.Sketch2ShapeError), key=lambda k: (k.exit_code, k.__name__))
    rows = [
        f"| {k.exit_code} | `{k.__name__}` | {(inspect.getdoc(k) or '').splitlines()[0]} | {k.remedy} |\n"
        for k in kinds
        if k.__module__ == errors.__name__ and k is not errors.InterruptedRunError
    ]
    return HEAD + "".join(rows) + TAIL


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--check", action="store_true", help="only say whether the page is as it should be")
    if parser.parse_args().check:
        return int(not PAGE.exists() or PAGE.read_text() != page())
    PAGE.parent.mkdir(exist_ok=True)
    PAGE.write_text(page())
    return 0


if __name__ == "__main__":
    sys.exit(main())
