"""Which products the options of the command ask for."""

from __future__ import annotations

from argparse import Namespace

from sketch2shape.pipeline.products import suffix


def wants_pages(arguments: Namespace) -> bool:
    """Whether pictures of the whole batch are asked for, so that each input needs its overlay."""
    return bool(arguments.index or arguments.contact_sheet)


def formats_of(arguments: Namespace) -> list[str]:
    """What --format asks for, by default a mesh. Raises UsageError for an unknown format."""
    names = [part.strip().lower() for value in arguments.format for part in value.split(",")]
    formats = list(dict.fromkeys(names or ["obj"]))
    for name in formats:
        suffix(name)
    return formats


def products_of(arguments: Namespace) -> list[str]:
    """The products asked for by name, without doubles: --format, and --json. Raises UsageError for an unknown one."""
    products = formats_of(arguments)
    if wants_pages(arguments) and "overlay" not in products:
        products.append("overlay")
    if arguments.json and "json" not in products:
        products.append("json")
    return products
