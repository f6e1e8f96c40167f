"""Sheets of paper: lines, circles and words on layers, in millimetres, as SVG, PDF and DXF."""

from __future__ import annotations

from sketch2shape.sheets.dxf import dxf_file, dxf_pair, sheet_dxf
from sketch2shape.sheets.pdf import pdf_bytes
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
    "dxf_file",
    "dxf_pair",
    "pdf_bytes",
    "sheet_dxf",
    "svg_text",
]
