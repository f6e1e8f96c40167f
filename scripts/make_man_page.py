#!/usr/bin/env python3
"""Write docs/sketch2shape.1, the manual page, from the parser: python scripts/make_man_page.py [--check]"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from sketch2shape.command.parser import build_parser

PAGE = Path(__file__).parents[1] / "docs" / "sketch2shape.1"


def roff(text: str) -> str:
    """Plain text as roff shows it."""
    return text.replace("\\", "\\\\").replace("-", "\\-").replace("%%", "%").replace("\n.", "\n\\&.")


def entry(action: argparse.Action) -> str:
    """An option with what it takes and does."""
    names = ", ".join(f"\\fB{roff(name)}\\fR" for name in action.option_strings) or f"\\fI{action.metavar}\\fR"
    takes = "" if action.nargs == 0 or not action.option_strings else f" \\fI{roff(value_of(action))}\\fR"
    return f".TP\n{names}{takes}\n{roff(action.help or '')}\n"


def value_of(action: argparse.Action) -> str:
    """What stands for the option's value."""
    return str(action.metavar or "|".join(map(str, action.choices or [action.dest.upper()])))


def page() -> str:
    """The page as it should be."""
    parser = build_parser()
    parts = [".TH SKETCH2SHAPE 1\n.SH NAME\nsketch2shape \\- from a drawing to an exact, watertight solid\n"]
    parts.append(".SH SYNOPSIS\n.B sketch2shape\n\\fIINPUT\\fR... [\\fB\\-o\\fR \\fIOUT\\fR]... [options]\n")
    parts.append(f".SH DESCRIPTION\n.nf\n{roff(parser.description or '')}\n.fi\n")
    for group in parser._action_groups:
        if group._group_actions:
            parts.append(f".SH {(group.title or '').upper()}\n" + "".join(map(entry, group._group_actions)))
    exit_codes = (parser.epilog or "").removeprefix("exit codes: ")
    parts.append(f".SH EXIT STATUS\n{roff(exit_codes)}\n")
    return "".join(parts)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--check", action="store_true", help="only say whether the page is as it should be")
    if parser.parse_args().check:
        return int(not PAGE.exists() or PAGE.read_text("utf-8") != page())
    PAGE.write_text(page(), "utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
