"""Strokes as JSON: Excalidraw, tldraw, and pens."""

from __future__ import annotations

import base64
import json
from typing import Any

import numpy as np

from sketch2shape.model import Floats
from synthetic.hand import Stroke

Size = tuple[int, int]
AWAY = np.array([-310.5, 127.25])
"""Where on the endless sheet of a whiteboard the drawing lies."""


def _excalidraw(elements: list[dict[str, Any]]) -> bytes:
    for k, element in enumerate(elements):
        common: dict[str, Any] = {
            "id": f"e{k}",
            "angle": 0,
            "strokeColor": "#1e1e1e",
            "opacity": 100,
            "isDeleted": False,
        }
        common |= {
            "backgroundColor": "transparent",
            "fillStyle": "solid",
            "strokeWidth": 2,
            "roughness": 1,
            "locked": False,
        }
        common |= {
            "seed": 1000 + k,
            "version": 10,
            "groupIds": [],
            "frameId": None,
            "boundElements": None,
            "link": None,
        }
        elements[k] = common | {"strokeStyle": "solid", "roundness": None} | element
    held = {"type": "excalidraw", "version": 2, "source": "https://excalidraw.com", "elements": elements}
    return json.dumps(held | {"appState": {"gridSize": None, "viewBackgroundColor": "#ffffff"}, "files": {}}).encode()


def _element(kind: str, path: Floats, hidden: bool = False, **more: Any) -> dict[str, Any]:
    at = path[0] + AWAY
    w, h = np.ptp(path, axis=0).tolist()
    return {
        "type": kind,
        "x": float(at[0]),
        "y": float(at[1]),
        "width": w,
        "height": h,
        "points": (path - path[0]).round(4).tolist(),
        "strokeStyle": "dashed" if hidden else "solid",
    } | more


def _text(words: str, x: float, y: float) -> dict[str, Any]:
    return {
        "type": "text",
        "x": x,
        "y": y,
        "width": 80.0,
        "height": 25.0,
        "text": words,
        "fontSize": 20,
        "fontFamily": 5,
    }


def excalidraw_lines(strokes: list[Stroke], _size: Size, _rng: np.random.Generator) -> bytes:
    """The tool for lines, with a label and an element that has been rubbed out."""
    rubbed = _element("line", np.array([[0.0, 0], [300, 300]])) | {"isDeleted": True}
    return _excalidraw([_element("line", s.path, s.hidden) for s in strokes] + [_text("a = 40", 0.0, 0.0), rubbed])


def excalidraw_pen(strokes: list[Stroke], _size: Size, _rng: np.random.Generator) -> bytes:
    """The pen, which knows no dashes: they are strokes."""
    pulls = [p for s in strokes for p in (dashed(s.path) if s.hidden else [s.path])]
    return _excalidraw([_element("freedraw", p, pressures=[], simulatePressure=True) for p in pulls])


def excalidraw_dotted(strokes: list[Stroke], _size: Size, _rng: np.random.Generator) -> bytes:
    """Hidden lines dotted, the lines' points smoothed (which changes nothing with two), a frame around all."""
    lines = [_element("line", s.path, s.hidden, roundness={"type": 2}) for s in strokes]
    for line in lines:
        line["strokeStyle"] = "dotted" if line["strokeStyle"] == "dashed" else "solid"
    every = np.concatenate([s.path for s in strokes]) + AWAY
    low, span = every.min(axis=0) - 20, np.ptp(every, axis=0) + 40
    frame = {"type": "frame", "x": low[0], "y": low[1], "width": span[0], "height": span[1], "name": "Frame 1"}
    return _excalidraw([*lines, frame])


def excalidraw_turned(strokes: list[Stroke], _size: Size, _rng: np.random.Generator) -> bytes:
    """Lines that were drawn level and turned since, as the file keeps them."""
    elements = []
    for s in strokes:
        (a, b), middle = s.path[[0, -1]], s.path[[0, -1]].mean(axis=0)
        length, angle = float(np.linalg.norm(b - a)), float(np.arctan2(*(b - a)[::-1]))
        level = np.array([[-length / 2, 0.0], [length / 2, 0.0]]) + middle
        elements.append(_element("line", level, s.hidden, angle=angle))
    return _excalidraw(elements)


def excalidraw_arrows(strokes: list[Stroke], _size: Size, _rng: np.random.Generator) -> bytes:
    """Arrows without heads, as some draw lines, and one with a head that points at the object."""
    lines = [_element("arrow", s.path, s.hidden, startArrowhead=None, endArrowhead=None) for s in strokes]
    first = strokes[0].path[0]
    pointer = _element("arrow", np.array([first - [90, 70], first]), startArrowhead=None, endArrowhead="arrow")
    return _excalidraw([*lines, pointer, _text("here", -400.0, 60.0)])


def dashed(path: Floats) -> list[Floats]:
    """Pieces of 11 pixels with gaps of 8; the last reaches the end."""
    steps = np.r_[0, np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1))]
    starts = np.linspace(0, max(steps[-1] - 11, 0), max(1, round((steps[-1] + 8) / 19)))
    out = []
    for start in starts:
        at = np.linspace(start, min(start + 11, steps[-1]), 4)
        out.append(np.c_[np.interp(at, steps, path[:, 0]), np.interp(at, steps, path[:, 1])])
    return out


def _tldraw(shapes: list[dict[str, Any]]) -> bytes:
    records: list[dict[str, Any]] = [
        {"gridSize": 10, "name": "", "meta": {}, "id": "document:document", "typeName": "document"},
        {"meta": {}, "id": "page:page", "name": "Page 1", "index": "a1", "typeName": "page"},
        {"id": "camera:page:page", "x": 0, "y": 0, "z": 1, "meta": {}, "typeName": "camera"},
    ]
    for k, shape in enumerate(shapes):
        common = {
            "id": f"shape:s{k}",
            "typeName": "shape",
            "parentId": "page:page",
            "index": f"a{k:04d}",
            "rotation": 0,
        }
        records.append(common | {"isLocked": False, "opacity": 1, "meta": {}} | shape)
    return json.dumps({"tldrawFileFormatVersion": 1, "schema": {"schemaVersion": 2}, "records": records}).encode()


def _shape(kind: str, at: Floats, props: dict[str, Any], **more: Any) -> dict[str, Any]:
    x, y = (at + AWAY).tolist()
    return {"type": kind, "x": x, "y": y, "props": {"color": "black", "size": "m"} | props} | more


def tldraw_lines(strokes: list[Stroke], _size: Size, _rng: np.random.Generator) -> bytes:
    """The tool for lines: points by name, ordered by their index."""
    shapes = []
    for s in strokes:
        ends = (s.path[[0, -1]] - s.path[0]).tolist()
        points = {
            f"a{k}": {"id": f"a{k}", "index": f"a{k}", "x": x, "y": y} for k, (x, y) in ((2, ends[1]), (1, ends[0]))
        }
        dash = "dashed" if s.hidden else "draw"
        shapes.append(_shape("line", s.path[0], {"dash": dash, "spline": "line", "points": points, "scale": 1}))
    return _tldraw(shapes)


def tldraw_pen(strokes: list[Stroke], _size: Size, _rng: np.random.Generator) -> bytes:
    """The pen, with points as older versions keep them, and a label."""
    label = _shape("text", np.zeros(2), {"richText": {"type": "doc", "content": []}, "w": 100, "autoSize": True})
    return _tldraw([*(_draw(s, packed=False) for s in strokes), label])


def tldraw_packed(strokes: list[Stroke], _size: Size, _rng: np.random.Generator) -> bytes:
    """The pen, with points as newer versions keep them."""
    return _tldraw([_draw(s, packed=True) for s in strokes])


def _draw(stroke: Stroke, *, packed: bool) -> dict[str, Any]:
    points = np.c_[stroke.path - stroke.path[0], np.full(len(stroke.path), 0.5)]
    segment: dict[str, Any] = {"type": "free"}
    if packed:
        told = [points[0].astype("<f4").tobytes()]
        at = points[0].copy()
        for point in points[1:]:
            step = (point - at).astype("<f2")
            at = at + step.astype(np.float64)
            told.append(step.tobytes())
        segment["path"] = base64.b64encode(b"".join(told)).decode()
    else:
        segment["points"] = [{"x": x, "y": y, "z": z} for x, y, z in points.round(2).tolist()]
    props = {"dash": "dotted" if stroke.hidden else "draw", "segments": [segment], "fill": "none", "isComplete": True}
    return _shape(
        "draw", stroke.path[0], props | {"isClosed": False, "isPen": False, "scale": 1, "scaleX": 1, "scaleY": 1}
    )


def tldraw_grouped(strokes: list[Stroke], _size: Size, _rng: np.random.Generator) -> bytes:
    """Lines in a group that was turned and moved since, and an arrow that points at them."""
    angle = 0.3
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    place = np.array([40.0, -25.0])
    group = _shape("group", place, {}, id="shape:group", index="a0000", rotation=angle)
    inner = [Stroke((s.path - place) @ turn - AWAY, s.hidden, s.weight) for s in strokes]
    shapes = json.loads(tldraw_lines(inner, (0, 0), np.random.default_rng(0)))["records"][3:]
    for shape in shapes:
        shape["parentId"] = "shape:group"
    ends = {"start": {"x": 0, "y": 0}, "end": {"x": 60, "y": 50}, "arrowheadStart": "none", "arrowheadEnd": "arrow"}
    return _tldraw([group, *shapes, _shape("arrow", np.array([-50.0, -50]), ends, id="shape:arrow", index="a9999")])


def tldraw_pages(strokes: list[Stroke], _size: Size, _rng: np.random.Generator) -> bytes:
    """A second page, and lines as arrows without heads."""
    shapes = []
    for s in strokes:
        (x, y), dash = (s.path[-1] - s.path[0]).tolist(), "dashed" if s.hidden else "draw"
        ends = {"start": {"x": 0, "y": 0}, "end": {"x": x, "y": y}, "arrowheadStart": "none", "arrowheadEnd": "none"}
        shapes.append(_shape("arrow", s.path[0], {"dash": dash, "bend": 0, **ends}))
    other = {"meta": {}, "id": "page:two", "name": "Page 2", "index": "a2", "typeName": "page"}
    far = _shape(
        "geo", np.zeros(2), {"geo": "rectangle", "w": 900, "h": 900, "growY": 0, "dash": "draw", "fill": "none"}
    )
    held = json.loads(_tldraw([*shapes, far | {"parentId": "page:two"}]))
    held["records"].append(other)
    return json.dumps(held).encode()


def pen_plain(strokes: list[Stroke], size: Size, _rng: np.random.Generator) -> bytes:
    """Lists of points, and the sheet."""
    paths = [p.round(2).tolist() for s in strokes for p in (dashed(s.path) if s.hidden else [s.path])]
    return json.dumps({"strokes": paths, "width": size[0], "height": size[1]}).encode()


def pen_pressed(strokes: list[Stroke], _size: Size, rng: np.random.Generator) -> bytes:
    """Points with time and pressure, no sheet."""
    clock = 0.0
    out = []
    for s in strokes:
        times = clock + 8.0 * np.arange(len(s.path))
        clock = float(times[-1]) + 300.0
        out.append(
            {"points": np.c_[s.path, times, rng.uniform(0.3, 0.9, len(s.path))].round(3).tolist(), "dashed": s.hidden}
        )
    return json.dumps({"strokes": out}).encode()


def pen_named(strokes: list[Stroke], size: Size, _rng: np.random.Generator) -> bytes:
    """Points with names, in parts of the window."""
    unit = 1.0 / max(size)
    out = [{"points": [{"x": x, "y": y} for x, y in (s.path * unit).tolist()], "dashed": s.hidden} for s in strokes]
    return json.dumps({"strokes": out, "width": size[0] * unit, "height": size[1] * unit}).encode()


def pen_bare(strokes: list[Stroke], _size: Size, _rng: np.random.Generator) -> bytes:
    """A bare list, around a middle of (0, 0)."""
    middle = np.concatenate([s.path for s in strokes]).mean(axis=0)
    paths = [(p - middle).tolist() for s in strokes for p in (dashed(s.path) if s.hidden else [s.path])]
    return json.dumps(paths).encode()


def pen_cut(strokes: list[Stroke], size: Size, rng: np.random.Generator) -> bytes:
    """Each stroke in pulls that overlap a little, some the other way round, in a random order."""
    pulls = []
    for s in strokes:
        fine = s.path if len(s.path) > 2 else np.linspace(s.path[0], s.path[-1], 21)
        cut = int(rng.integers(len(fine) // 4, 3 * len(fine) // 4 + 1))
        for part in (fine[: cut + 2], fine[cut:]):
            if len(part) > 1:
                pulls.append({"points": part[:: 1 if rng.random() < 0.5 else -1].tolist(), "dashed": s.hidden})
    order = rng.permutation(len(pulls))
    return json.dumps({"strokes": [pulls[k] for k in order], "width": size[0], "height": size[1]}).encode()


def _named(kind: str, *writers: Any) -> dict[str, Any]:
    return {f"{kind}/{f.__name__.partition('_')[2]}": f for f in writers}


MANNERS = {
    **_named("excalidraw", excalidraw_lines, excalidraw_pen, excalidraw_dotted, excalidraw_turned, excalidraw_arrows),
    **_named("tldraw", tldraw_lines, tldraw_pen, tldraw_packed, tldraw_grouped, tldraw_pages),
    **_named("pen", pen_plain, pen_pressed, pen_named, pen_bare, pen_cut),
}
