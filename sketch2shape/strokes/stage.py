"""Strokes of a drawing as a stage of its own: from a picture, or from its ink, in the picture's pixels."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from sketch2shape.ink import find_ink
from sketch2shape.model import Ink, checked_number
from sketch2shape.strokes.skeleton import thin
from sketch2shape.strokes.tracing import Strokes, trace_skeleton

TOLERANCE = 1.5
"""Working pixels by which a ruled line strays from a straight one once it is drawn, scanned and thinned ..."""
BLUNT = 0.25
"""... and that as a part of the width of a thick pen, whose blobs pull the middle line about."""


def trace_strokes(source: Any, *, tolerance: float | None = None) -> Strokes:
    """Straight strokes of a drawing, solid and dashed, longest first; in the picture's pixels.

    source    : path, bytes, PIL image, array (gray, RGB, RGBA), `Picture`, or the `Ink` of one
    tolerance : picture pixels by which a drawn line may stray from a straight one; None for ruled lines, about 1 % of
                the drawing's size for a hand without a ruler

    The ink is thinned, its branches are cut into nearly straight pieces (Douglas and Peucker 1973), and pieces on one
    line are joined across crossings and the gaps of dashes. Raises UnreadableError or LimitError for a picture that
    cannot be read.
    """
    ink = ink_of(source)
    strokes = drawn_strokes(ink, working_tolerance(ink, tolerance))
    return replace(strokes, ends=ink.to_picture(strokes.ends), tolerance=strokes.tolerance / ink.scale)


def drawn_strokes(ink: Ink, tolerance: float) -> Strokes:
    """Strokes in working pixels, without the stubs that thinning leaves where lines meet at a sharp angle."""
    strokes = trace_skeleton(thin(ink), tolerance)
    long = strokes.lengths > 2 * ink.pen_width + tolerance
    return Strokes(strokes.ends[long], strokes.inked[long], tolerance)


def working_tolerance(ink: Ink, tolerance: float | None) -> float:
    """A tolerance given in picture pixels, or that of ruled lines, in working pixels."""
    if tolerance is None:
        return max(TOLERANCE, BLUNT * ink.pen_width)
    return checked_number("tolerance", tolerance, 0.0) * ink.scale


def ink_of(source: Any) -> Ink:
    """The ink of whatever a stage was given: itself, or that of the picture."""
    return source if isinstance(source, Ink) else find_ink(source)
