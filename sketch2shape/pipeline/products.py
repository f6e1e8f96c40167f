"""What can be written for one picture: meshes, the report, pictures; each with a file ending and an encoder."""

from __future__ import annotations

from collections.abc import Callable
from difflib import get_close_matches
from pathlib import PurePath
from types import ModuleType
from typing import Any

from sketch2shape.errors import UsageError
from sketch2shape.model import Answer
from sketch2shape.pipeline.options import tolerance_of
from sketch2shape.pipeline.report import encode_report, report
from sketch2shape.writing import formats

#: products that are no mesh -> ending of their files
SUFFIXES: dict[str, str] = {name: formats.ending(name) for name in formats.named("report", "picture")}

#: products that are pictures of one result, each with an option of its name
PICTURES = formats.named("picture")

#: products that are no mesh -> function of the result that gives the bytes
ENCODERS: dict[str, Callable[[Answer], bytes]] = {
    "json": lambda result: encode_report(report(result)),
    "overlay": lambda result: _pictures().encode_png(_pictures().overlay(result)),
    "stages": lambda result: _pictures().encode_png(_pictures().stages(result)),
    "preview": lambda result: _pictures().encode_png(_pictures().preview_of(result)),
    "html": lambda result: _pictures().viewer(result).encode("utf-8"),
}


def _pictures() -> ModuleType:
    """The pictures, loaded when one is drawn."""
    from sketch2shape import pictures

    return pictures


def suffix(product: str) -> str:
    """Ending of the files of a product: ".json", ".obj", ... Raises UsageError for an unknown one."""
    if product not in formats.FORMATS:
        near = get_close_matches(product, formats.FORMATS, n=1)
        raise UsageError(
            f"no format is called {product!r}",
            remedy=f"--format {near[0] if near else 'with one of ' + ', '.join(formats.FORMATS)}",
        )
    return formats.ending(product)


def infixed(path: str, product: str, infix: str) -> str:
    """NAME.2.obj for NAME.obj and the infix ".2"; standard output stays what it is."""
    if path == "-":
        return path
    ending = suffix(product)
    stem = path[: -len(ending)] if path.lower().endswith(ending) else path
    return stem + infix + path[len(stem) :]


def product_of(name: str) -> str:
    """The product meant by a file name. Raises UsageError."""
    product = formats.meant_by(name)
    if product is None:
        last = PurePath(name).suffix.lower().lstrip(".")
        endings = dict.fromkeys(end for format in formats.FORMATS.values() for end in format.endings)
        raise UsageError(f"no format has the extension {last!r}", remedy=f"one of {', '.join(endings)}")
    return product


def encode_product(product: str, result: Answer, options: dict[str, Any]) -> bytes:
    """The bytes of a mesh, the report or a picture. `options` go to the mesh encoder."""
    if product in ENCODERS:
        return ENCODERS[product](result)
    from sketch2shape.export import encode

    unit = result.solids[0].unit if result.solids else "px"
    return encode(result, product, **{**options, "tolerance": tolerance_of(options.get("tolerance"), unit)})
