"""A drawing that is known as lines, not as pixels."""

from __future__ import annotations

from dataclasses import dataclass

from sketch2shape.model.arrays import Brief, Floats


@dataclass(frozen=True, eq=False, repr=False)
class VectorLine(Brief):
    """One line of a vector drawing: the pull of a pen, or a line, curve or outline of a drawing program.

    points : (n, 2) float, x and y of a polyline; curves come as chords so short that nobody sees them
    dashed : whether the file says that it is dashed or dotted
    curved : whether the file says that it is a curve (an arc, an ellipse, a Bezier curve), not corners and not a hand
    """

    points: Floats
    dashed: bool = False
    curved: bool = False

    def mapped(self, origin: Floats, scale: float) -> VectorLine:
        """Moved so that `origin` becomes (0, 0), then enlarged."""
        return VectorLine((self.points - origin) * scale, self.dashed, self.curved)


@dataclass(frozen=True, eq=False, repr=False)
class VectorDrawing(Brief):
    """Lines on a sheet, x to the right, y down, in pixels of the picture: (0, 0) is the sheet's upper left corner.

    lines  : what was drawn, in the order of the file
    size   : width and height of the sheet
    origin : the file's own coordinates of the sheet's upper left corner ...
    scale  : ... and pixels for each of the file's units: own = origin + pixels / scale
    """

    lines: tuple[VectorLine, ...]
    size: tuple[int, int]
    origin: tuple[float, float] = (0.0, 0.0)
    scale: float = 1.0
