"""Pieces of text that programs in all languages share."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from sketch2shape.model import Solid

#: columns that a list may fill before it is put on several lines
_WIDTH = 100


def about(solids: Sequence[Solid]) -> list[str]:
    """What the program makes and in which unit, in lines for its head; solids are in millimetres or pixels."""
    sizes = ["{:.5g} x {:.5g} x {:.5g}".format(*solid.dimensions) for solid in solids]
    unit = solids[0].unit
    one = f"The solid is {sizes[0]} {unit} (width x height x depth)."
    what = one if len(solids) == 1 else f"{len(solids)} solids: {', '.join(sizes)} {unit} (width x height x depth)."
    lengths = "Lengths are in millimetres."
    if unit == "px":
        lengths = "Lengths are in pixels of the drawing: no real size was given, as --width 40mm does."
    return ["Written by sketch2shape from a drawing.", what, lengths]


def wrapped(head: str, items: Iterable[str], tail: str, *, indent: int = 0, step: int = 4) -> list[str]:
    """A list between brackets: on one line if it fits, else as many items a line as fit.

    indent : columns before it
    step   : columns more before the lines of items
    """
    parts, left = list(items), " " * indent
    line = f"{left}{head}{', '.join(parts)}{tail}"
    if len(line) <= _WIDTH:
        return [line]
    lines, row = [left + head], " " * (indent + step)
    for part in parts:
        if row.strip() and len(row) + len(part) + 1 > _WIDTH:
            lines.append(row.rstrip())
            row = " " * (indent + step)
        row += part + ", "
    return [*lines, row.rstrip(), left + tail]


def bracketed(expression: str) -> str:
    """The expression as a factor."""
    return f"({expression})" if " - " in expression or " + " in expression else expression


def minus(expression: str) -> str:
    """The expression with the other sign."""
    if expression == "0":
        return "0"
    return expression[1:] if expression.startswith("-") and " " not in expression else f"-{bracketed(expression)}"
