"""The pieces of a net laid out on sheets; a face larger than a sheet is cut into parts that overlap."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import shapely

from sketch2shape.model import Boundary, Floats
from sketch2shape.solids.development import FlatFace
from sketch2shape.solids.net import Piece, polygon, unfolded
from sketch2shape.solids.tabs import Joint, joints

#: millimetres between pieces, and by which the parts of a face that is larger than a sheet overlap
_GAP, _OVERLAP = 4.0, 10.0

#: depth of tabs: millimetres, or a part of the solid's largest size if that is less
_TAB, _TAB_PART = 7.0, 0.2

#: heights of the numbers on faces and on tabs, millimetres, and as parts of the room there is
_NUMBER, _TAB_NUMBER, _NUMBER_PART = 6.0, 2.4, 0.6

#: part of the largest room that is enough for a number in the middle of a face
_ROOM = 0.7

#: how exactly the middle of the largest circle within a face is found, as a part of the face's size
_MIDDLE = 0.02

Room = tuple[float, float]
"""Width and height that can be drawn on, millimetres."""


@dataclass(frozen=True)
class Cut:
    """A line on a layer, or a text at the only point.

    points : (k, 2) millimetres, y up
    height : of the text
    """

    layer: str
    points: Floats
    text: str = ""
    height: float = 0.0

    def moved(self, turn: Floats, by: Floats) -> Cut:
        """Turned about the origin by a matrix (2, 2), then shifted."""
        return Cut(self.layer, self.points @ turn.T + by, self.text, self.height)


def packed(boundary: Boundary, room: Room, most: int) -> list[list[Cut]]:
    """What stands on each sheet, from the room's lower left corner.

    boundary : of the solid as large as on the paper, millimetres
    most     : sheets after which the rest is left out, as nobody wants that many
    """
    size = float(np.ptp(boundary.extremes(np.eye(3)), axis=0).max())
    depth = min(_TAB, _TAB_PART * size)

    def fits(outline: shapely.Geometry) -> bool:
        sides = sorted(_sides(outline))
        return sides[0] + 2 * depth <= min(room) and sides[1] + 2 * depth <= max(room)

    if not fits(_largest_face(boundary)) and size > most * max(room):
        return [[]] * (most + 1)
    pieces = unfolded(boundary, fits)
    drawn = [_settled(_lines(piece, number, glued), room) for number, piece, glued in _with_joints(pieces, depth)]
    return _on_sheets(drawn, room)


def largest_factor(boundary: Boundary, room: Room) -> float:
    """A scale at which the net, in as few pieces as it can have, may just go on one sheet."""
    sides = np.array([sorted(_sides(piece.outline)) for piece in unfolded(boundary)])
    each = np.array(sorted(room)) / np.maximum(sides, 1e-9)
    return float(min(each.min(), np.sqrt(room[0] * room[1] / max(float(sides.prod(axis=1).sum()), 1e-9))))


def _largest_face(boundary: Boundary) -> shapely.Geometry:
    points = boundary.extremes(np.eye(3))
    spans = np.sort(np.ptp(points, axis=0))
    return shapely.box(0, 0, spans[1], spans[2])


def _sides(outline: shapely.Geometry) -> tuple[float, float]:
    """Width and height of the smallest rectangle around an outline."""
    corners = shapely.get_coordinates(shapely.minimum_rotated_rectangle(outline))
    if len(corners) < 4:
        return float(np.ptp(corners)) if len(corners) else 0.0, 0.0
    a, b = np.linalg.norm(np.diff(corners[:3], axis=0), axis=1).tolist()
    return a, b


def _with_joints(pieces: list[Piece], depth: float) -> Iterator[tuple[int, Piece, list[Joint]]]:
    found = joints(pieces, depth)
    for number, piece in enumerate(pieces):
        yield number, piece, [joint for joint in found if number in (joint.sides[0][0], joint.sides[1][0])]


def _lines(piece: Piece, number: int, glued: list[Joint]) -> list[Cut]:
    """All lines and numbers of a piece."""
    found = [Cut("fold_back" if fold.back else "fold", fold.points) for fold in piece.folds if not fold.smooth]
    for joint in glued:
        for k, (where, _, edge) in enumerate(joint.sides):
            if where != number:
                continue
            tab = joint.tab if k == 0 else None
            if tab is None:
                found.append(Cut("cut", edge.points))
                continue
            found += [Cut("fold", edge.points), Cut("cut", tab.outline)]
            height = min(_TAB_NUMBER, _NUMBER_PART * tab.depth)
            if len(tab.base) == 2:
                found.append(Cut("text", tab.middle[None], str(tab.target + 1), height))
    return [*found, *map(_numbered, piece.faces)]


def _numbered(face: FlatFace) -> Cut:
    """The number of a face: in its middle, unless it has more room elsewhere."""
    shape = polygon(face)
    if shape.area == 0.0:
        return Cut("text", face.ring().mean(axis=0)[None], str(face.number + 1), _TAB_NUMBER)
    size = float(np.hypot(*np.subtract(shape.bounds[2:], shape.bounds[:2])))
    line = shapely.maximum_inscribed_circle(shape, _MIDDLE * size)
    middle, radius = shapely.get_coordinates(line)[:1], float(line.length)
    room = shapely.distance(shape.centroid, shape.boundary) if shape.contains(shape.centroid) else 0.0
    if room > _ROOM * radius:
        middle, radius = shapely.get_coordinates(shape.centroid), float(room)
    return Cut("text", middle, str(face.number + 1), min(_NUMBER, _NUMBER_PART * radius))


def _settled(lines: list[Cut], room: Room) -> tuple[list[Cut], float, float]:
    """The lines turned to lie along the paper, their lower left corner at the origin, with their width and height.

    Most folds are level or upright then, unless the piece only fits aslant.
    """
    points = np.concatenate([line.points for line in lines])
    corners = shapely.get_coordinates(shapely.minimum_rotated_rectangle(shapely.MultiPoint(points)))
    straight = [line for line in lines if len(line.points) == 2] + ([Cut("", corners[:2])] if len(corners) > 2 else [])
    aligned: dict[float, float] = {0.0: 0.0}
    for line in straight:
        (x, y) = line.points[1] - line.points[0]
        angle = round(float(np.degrees(np.arctan2(y, x))) % 90.0, 2) % 90.0
        aligned[angle] = aligned.get(angle, 0.0) + (float(np.hypot(x, y)) if line.layer.startswith("fold") else 0.0)
    ways = []
    for turn, quarter in ((turn, quarter) for turn in aligned for quarter in (0.0, 90.0)):
        c, s = np.cos(np.radians(turn + quarter)), np.sin(np.radians(turn + quarter))
        matrix = np.array([[c, s], [-s, c]])
        width, height = np.ptp(points @ matrix.T, axis=0).tolist()
        over = max(width - room[0], 0.0) + max(height - room[1], 0.0)
        rank = (round(over, 3), -round(aligned[turn], 3), round(width * height, 3), round(height, 3), turn + quarter)
        ways.append((rank, matrix, width, height))
    _, matrix, width, height = min(ways, key=lambda way: way[0])
    return [line.moved(matrix, -(points @ matrix.T).min(axis=0)) for line in lines], width, height


def _on_sheets(drawn: list[tuple[list[Cut], float, float]], room: Room) -> list[list[Cut]]:
    """The pieces in rows, the highest first; each on the first sheet with room."""
    sheets: list[list[Cut]] = []
    rows: list[list[tuple[float, float, float]]] = []
    for lines, width, height in sorted(drawn, key=lambda piece: -piece[2]):
        if width > room[0] + 1e-6 or height > room[1] + 1e-6:
            for part in _parts(lines, width, height, room):
                sheets.append(part)
                rows.append([(0.0, room[1], room[0])])
            continue
        number, x, y = _place(rows, width, height, room)
        if number == len(sheets):
            sheets.append([])
        sheets[number] += [line.moved(np.eye(2), np.array([x, room[1] - y - height])) for line in lines]
    return sheets


def _place(
    rows: list[list[tuple[float, float, float]]], width: float, height: float, room: Room
) -> tuple[int, float, float]:
    """Sheet and upper left corner for a piece; rows are (top, height, filled width), sheet by sheet."""
    for number, sheet in enumerate(rows):
        for k, (top, high, filled) in enumerate(sheet):
            if height <= high + 1e-9 and filled + _GAP + width <= room[0]:
                sheet[k] = (top, high, filled + _GAP + width)
                return number, filled + _GAP, top
        below = sheet[-1][0] + sheet[-1][1] + _GAP
        if below + height <= room[1]:
            sheet.append((below, height, width))
            return number, 0.0, below
    rows.append([(0.0, height, width)])
    return len(rows) - 1, 0.0, 0.0


def _parts(lines: list[Cut], width: float, height: float, room: Room) -> Iterator[list[Cut]]:
    """A large face in parts, row by row from above; each overlaps the next one to the right and below."""
    step = (room[0] - _OVERLAP, room[1] - _OVERLAP)
    columns, rows = (max(int(np.ceil((s - _OVERLAP) / d)), 1) for s, d in zip((width, height), step, strict=True))
    for row in range(rows):
        for column in range(columns):
            corner = np.array([column * step[0], height - row * step[1] - room[1]])
            window = shapely.box(*corner, *(corner + room))
            part = [clipped for line in lines for clipped in _clipped(line, window)]
            name = f"part {row * columns + column + 1} of {rows * columns}: row {row + 1}, column {column + 1}"
            at = corner + [room[0] / 2, 3.0]
            yield [line.moved(np.eye(2), -corner) for line in (*part, Cut("text", at[None], name, 2.2))]


def _clipped(line: Cut, window: shapely.Polygon) -> Iterator[Cut]:
    if line.text:
        if window.contains(shapely.Point(line.points[0])):
            yield line
        return
    for part in shapely.get_parts(shapely.intersection(shapely.LineString(line.points), window)):
        if part.geom_type == "LineString":
            yield Cut(line.layer, shapely.get_coordinates(part))
