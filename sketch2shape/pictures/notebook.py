"""How a result shows itself in a notebook: the turning solid beside the drawing, or the overlay as a picture."""

from __future__ import annotations

from html import escape

from sketch2shape.model import Answer
from sketch2shape.pictures.canvas import encode_png
from sketch2shape.pictures.overlay import overlay
from sketch2shape.pictures.viewer import viewer


def notebook_html(result: Answer, height: int = 620) -> str:
    """HTML for a notebook cell: the 3-D viewer in a frame of its own, `height` pixels, cut off from the notebook."""
    page = escape(viewer(result), quote=True)
    style = f"width:100%;height:{height}px;border:0"
    return f'<iframe sandbox="allow-scripts" style="{style}" title="sketch2shape result" srcdoc="{page}"></iframe>'


def notebook_png(result: Answer) -> bytes:
    """PNG bytes for a notebook without HTML: the overlay."""
    return encode_png(overlay(result))
