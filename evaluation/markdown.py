"""Tables for the pages that scripts write."""

from __future__ import annotations

from collections.abc import Sequence


def table(head: Sequence[str], rows: Sequence[Sequence[str]], *, words: bool = False) -> str:
    """Rows of text as Markdown; all columns but the first are aligned at the right, as numbers are, unless of words."""
    lines = [head, ["---", *["---" if words else "---:"] * (len(head) - 1)], *rows]
    return "".join("| " + " | ".join(cells) + " |\n" for cells in lines)


def share(some: Sequence[bool]) -> str:
    """How many of them are true, in percent with its sign; a dash of nothing."""
    return f"{percent(sum(some), len(some))} %" if some else "-"


def percent(part: float, whole: float) -> str:
    """A share in percent with one decimal; a dash of nothing."""
    return f"{100 * part / whole:.1f}" if whole else "-"


def part_replaced(page: str, name: str, text: str) -> str:
    """A page with what stands between `<!-- name -->` and `<!-- end of name -->` written anew."""
    begin, end = f"<!-- {name} -->\n", f"<!-- end of {name} -->\n"
    before, rest = page.split(begin)
    return f"{before}{begin}\n{text}\n{end}{rest.split(end)[1]}"
