"""Sheets of paper: lines, circles and words on layers, in millimetres, as SVG, PDF and DXF."""

from __future__ import annotations

from sketch2shape.sheets.dxf import document_dxf, dxf_file, dxf_pair
from sketch2shape.sheets.pdf import pdf_bytes, text_width
from sketch2shape.sheets.sheet import PAPERS, Document, Item, Label, Layer, Paper, Round, Sheet, Stroke
from sketch2shape.sheets.svg import svg_text

__all__ = [
    "PAPERS",
    "Document",
    "Item",
    "Label",
    "Layer",
    "Paper",
    "Round",
    "Sheet",
    "Stroke",
    "document_dxf",
    "dxf_file",
    "dxf_pair",
    "pdf_bytes",
    "svg_text",
    "text_width",
]
