"""Lines of a page of a PDF: its paths, in the order they are painted; text is left out."""

from __future__ import annotations

import ctypes
from collections.abc import Iterator
from typing import Any

import numpy as np

from sketch2shape.errors import LimitError
from sketch2shape.model import Floats, VectorLine
from sketch2shape.reading.painted import Colour, Shape

CHORDS = 16
"""Chords of a Bezier curve: a quarter of a circle to a thousandth of its radius."""
MOST_SEGMENTS = 40_000
"""Lines and curves of a page."""
MOST_DEPTH, MOST_OBJECTS = 12, 10_000
"""Forms within forms, and objects of a page, those in forms as often as they are shown."""
SCANNED = 0.3
"""Part of a page that a picture fills from which on the page is a scan with marks on it."""

Matrix = Floats
Run = tuple[bool, list[list[float]]]
"""Whether a run of points is curved, and the points."""


def page_shapes(page: Any) -> list[Shape] | None:
    """The shapes of a page of pypdfium2 in points (1/72 inch), y down; None where the page is a scan.

    Raises LimitError.
    """
    from pypdfium2 import raw

    width, height = page.get_size()
    to_sheet = _to_sheet(page)
    shapes: list[Shape] = []
    segments = 0
    found = _objects(page.raw, raw.FPDFPage_CountObjects, raw.FPDFPage_GetObject, to_sheet, 0)
    for count, (kind, handle, matrix) in enumerate(found):
        if count > MOST_OBJECTS:
            raise LimitError("it has too many objects", remedy="a page with one drawing")
        if kind == raw.FPDF_PAGEOBJ_IMAGE:
            corners = _apply(matrix @ _matrix_of(handle), np.array([[0.0, 0], [1, 0], [0, 1]]))
            (ax, ay), (bx, by) = corners[1] - corners[0], corners[2] - corners[0]
            if abs(ax * by - ay * bx) > SCANNED * width * height:
                return None
        elif kind == raw.FPDF_PAGEOBJ_PATH:
            segments += max(0, raw.FPDFPath_CountSegments(handle))
            if segments > MOST_SEGMENTS:
                raise LimitError("its lines have too many points", remedy="a page with one drawing")
            shapes.append(_shape(handle, matrix @ _matrix_of(handle)))
    return shapes


def _to_sheet(page: Any) -> Matrix:
    """From the page's own coordinates to those of the sheet as it is shown: cropped, turned, y down."""
    left, bottom, right, top = page.get_cropbox()
    turns = page.get_rotation() % 360
    along, up = right - left, top - bottom
    back = np.array([[1, 0, -left], [0, 1, -bottom], [0, 0, 1.0]])
    turned = {
        0: [[1, 0, 0], [0, -1, up]],
        90: [[0, 1, 0], [1, 0, 0]],
        180: [[-1, 0, along], [0, 1, 0]],
        270: [[0, -1, up], [-1, 0, along]],
    }[turns]
    return np.asarray(np.array([*turned, [0, 0, 1.0]]) @ back)


def _objects(owner: Any, count: Any, get: Any, matrix: Matrix, depth: int) -> Iterator[tuple[int, Any, Matrix]]:
    """Kind, handle and the matrix around each object, those within forms included."""
    from pypdfium2 import raw

    for index in range(max(0, count(owner))):
        handle = get(owner, index)
        kind = raw.FPDFPageObj_GetType(handle)
        if kind != raw.FPDF_PAGEOBJ_FORM:
            yield kind, handle, matrix
        elif depth < MOST_DEPTH:
            yield kind, handle, matrix
            inner = matrix @ _matrix_of(handle)
            yield from _objects(handle, raw.FPDFFormObj_CountObjects, raw.FPDFFormObj_GetObject, inner, depth + 1)


def _matrix_of(handle: Any) -> Matrix:
    from pypdfium2 import raw

    m = raw.FS_MATRIX()
    if not raw.FPDFPageObj_GetMatrix(handle, ctypes.byref(m)):
        return np.eye(3)
    return np.array([[m.a, m.c, m.e], [m.b, m.d, m.f], [0, 0, 1.0]])


def _apply(matrix: Matrix, points: Floats) -> Floats:
    return np.asarray(points @ matrix[:2, :2].T + matrix[:2, 2])


def _shape(handle: Any, matrix: Matrix) -> Shape:
    from pypdfium2 import raw

    parts: list[VectorLine] = []
    rings: list[Floats] = []
    for runs in _subpaths(handle):
        lines = [VectorLine(_apply(matrix, np.array(points)), curved=curved) for curved, points in runs]
        lines = [line for line in lines if np.isfinite(line.points).all()]
        parts += lines
        rings += [np.concatenate([line.points for line in lines])] if lines else []
    fill_mode, has_stroke = ctypes.c_int(), raw.FPDF_BOOL()
    raw.FPDFPath_GetDrawMode(handle, ctypes.byref(fill_mode), ctypes.byref(has_stroke))
    stroke = _colour(handle, raw.FPDFPageObj_GetStrokeColor, 25) if has_stroke.value else None
    fill = _colour(handle, raw.FPDFPageObj_GetFillColor, 242) if fill_mode.value else None
    return Shape(tuple(parts), tuple(rings), stroke, _is_dashed(handle), fill)


def _subpaths(handle: Any) -> list[list[Run]]:
    """Each subpath as runs of points, straight from one to the next or curved throughout."""
    from pypdfium2 import raw

    subpaths: list[list[Run]] = []
    start = now = [0.0, 0.0]
    controls: list[list[float]] = []
    for index in range(max(0, raw.FPDFPath_CountSegments(handle))):
        segment = raw.FPDFPath_GetPathSegment(handle, index)
        x, y = ctypes.c_float(), ctypes.c_float()
        raw.FPDFPathSegment_GetPoint(segment, ctypes.byref(x), ctypes.byref(y))
        point, kind = [x.value, y.value], raw.FPDFPathSegment_GetType(segment)
        if kind == raw.FPDF_SEGMENT_MOVETO:
            subpaths.append([])
            start = now = point
            continue
        if not subpaths:
            subpaths.append([])
        if kind == raw.FPDF_SEGMENT_BEZIERTO:
            controls.append(point)
            if len(controls) == 3:
                _extend(subpaths[-1], True, now, _bezier(now, *controls))
                now, controls = point, []
        else:
            _extend(subpaths[-1], False, now, [point])
            now = point
        if raw.FPDFPathSegment_GetClose(segment) and now != start:
            _extend(subpaths[-1], False, now, [start])
            now = start
    return subpaths


def _extend(runs: list[Run], curved: bool, now: list[float], more: list[list[float]]) -> None:
    if not runs or runs[-1][0] != curved:
        runs.append((curved, [now]))
    runs[-1][1].extend(more)


def _bezier(*controls: list[float]) -> list[list[float]]:
    """Points along a cubic curve, but for its start."""
    t = (np.arange(1, CHORDS + 1) / CHORDS)[:, None]
    a, b, c, d = (np.array(p) for p in controls)
    s = 1 - t
    points: list[list[float]] = (s**3 * a + 3 * s**2 * t * b + 3 * s * t**2 * c + t**3 * d).tolist()
    return points


def _colour(handle: Any, getter: Any, least: int) -> Colour | None:
    """Red, green and blue where the colour is at least that opaque, of 255."""
    parts = [ctypes.c_uint() for _ in range(4)]
    if not getter(handle, *(ctypes.byref(part) for part in parts)) or parts[3].value < least:
        return None
    return parts[0].value, parts[1].value, parts[2].value


def _is_dashed(handle: Any) -> bool:
    from pypdfium2 import raw

    count = raw.FPDFPageObj_GetDashCount(handle)
    if count <= 0:
        return False
    lengths = (ctypes.c_float * count)()
    raw.FPDFPageObj_GetDashArray(handle, lengths, count)
    gaps = list(lengths)[1::2] if count % 2 == 0 else list(lengths)
    return bool(max(gaps) > 0.0)
