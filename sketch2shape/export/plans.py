"""Plans of a solid on paper: which document a format is, and as which kind of file."""

from __future__ import annotations

from collections.abc import Sequence

from sketch2shape.export.plan_options import PlanOptions
from sketch2shape.model import Solid
from sketch2shape.sheets import PAPERS, Document, document_dxf, pdf_bytes, svg_text


def encode_plan(solids: Sequence[Solid], format: str, options: PlanOptions) -> bytes:
    """The file's bytes."""
    document, _ = _document(solids, format, options)
    if format.endswith(".dxf"):
        return document_dxf(document, solids[0].unit, _true_size(solids, options)).encode()
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
    if format.startswith("worksheet."):
        from sketch2shape.export.worksheet import worksheet_document

        return worksheet_document(solids, options.paper)
    from sketch2shape.export.views import views_document

    return views_document(solids, options.paper, options.angle)


def _true_size(solids: Sequence[Solid], options: PlanOptions) -> float:
    """Units of the solids in a millimetre of their views on paper."""
    from sketch2shape.export.views import laid_views

    return 1.0 / laid_views(tuple(solids), PAPERS[options.paper].turned, options.angle)[1].factor
