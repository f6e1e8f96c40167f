"""Plans of a solid on paper: which document a format is, and as which kind of file."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, get_args

from sketch2shape.errors import OptionError
from sketch2shape.model import Solid
from sketch2shape.sheets import PAPERS, Document, pdf_bytes, svg_text

PaperName = Literal["a4", "letter"]


@dataclass(frozen=True)
class PlanOptions:
    """How plans are laid out.

    paper : size of the sheets
    """

    paper: PaperName = "a4"

    def __post_init__(self) -> None:
        """Raise OptionError for what there is not."""
        if self.paper not in get_args(PaperName):
            raise OptionError(f"there is no paper called {self.paper!r}", remedy=f"one of {', '.join(PAPERS)}")


def encode_plan(solids: Sequence[Solid], format: str, options: PlanOptions) -> bytes:
    """The file's bytes."""
    document, _ = _document(solids, format, options)
    return pdf_bytes(document) if format.endswith(".pdf") else svg_text(document).encode()


def plan_note(solids: Sequence[Solid], format: str, options: PlanOptions) -> str | None:
    """What had to be assumed about the scale, in words; None where nothing was."""
    _, note = _document(solids, format, options)
    return note


def _document(solids: Sequence[Solid], format: str, options: PlanOptions) -> tuple[Document, str | None]:
    """The sheets, and what had to be assumed."""
    if format.startswith("net."):
        from sketch2shape.export.net import net_document

        return net_document(solids, options.paper)
    raise ValueError(f"{format} is no plan")
