"""What textbooks and teachers add around and onto a drawing: letters, dimensions, arrows, ticks, shading, dots."""

from __future__ import annotations

from collections.abc import Callable

import cv2
import numpy as np
from PIL import Image as PilImage
from PIL import ImageDraw, ImageFont

from sketch2shape.model import Floats
from synthetic.hand import Stroke
from synthetic.pens import Coverage, Pen, coverage
from synthetic.scenes import Scene
from synthetic.visibility import faces_of

Mark = Callable[[Scene, Floats, tuple[int, int], Pen, np.random.Generator], Coverage]
"""(scene, drawn vertices, sheet size, pen, random numbers) to the ink to add, (h, w) 0..1."""


def text(words: str, at: tuple[float, float], height: float, size: tuple[int, int], font: str) -> Coverage:
    """Words centred on a point, about `height` pixels high; `font` is "vector" (OpenCV) or "print" (Pillow)."""
    w, h = size
    canvas = np.zeros((h, w), np.uint8)
    if font == "vector":
        scale = height / 22
        (tw, th), _ = cv2.getTextSize(words, cv2.FONT_HERSHEY_SIMPLEX, scale, 1)
        origin = (int(at[0] - tw / 2), int(at[1] + th / 2))
        cv2.putText(canvas, words, origin, cv2.FONT_HERSHEY_SIMPLEX, scale, 255, 1, cv2.LINE_AA)
    else:
        picture = PilImage.fromarray(canvas)
        face = ImageFont.load_default(size=max(height * 1.3, 6))
        ImageDraw.Draw(picture).text(at, words, fill=255, font=face, anchor="mm")
        canvas = np.asarray(picture)
    return np.asarray(canvas / 255, np.float32)


def _font(rng: np.random.Generator) -> str:
    return "vector" if rng.random() < 0.4 else "print"


def letters(scene: Scene, points: Floats, size: tuple[int, int], pen: Pen, rng: np.random.Generator) -> Coverage:
    """A letter beside each vertex of the front face, sometimes of both faces."""
    count = scene.half if rng.random() < 0.6 else len(points)
    font, height = _font(rng), float(rng.uniform(11, 17)) * size[0] / 800
    centre, out = points.mean(0), np.zeros(size[::-1], np.float32)
    for i in range(min(count, 26)):
        away = points[i] - centre
        away = away / max(float(np.linalg.norm(away)), 1e-9)
        at = points[i] + away * (height * 1.1 + pen.width + 2)
        name = chr(ord("A") + i) if count <= scene.half else chr(ord("A") + i % scene.half) + "'" * (i >= scene.half)
        out = np.maximum(out, text(name, (float(at[0]), float(at[1])), height, size, font))
    return out


def _arrow(p: Floats, q: Floats, head: float) -> list[Stroke]:
    """A line from p to q with an open head at q."""
    u = (p - q) / max(float(np.linalg.norm(p - q)), 1e-9)
    side = np.array([-u[1], u[0]])
    return [Stroke(np.array([p, q])), Stroke(np.array([q + head * (u + 0.4 * side), q, q + head * (u - 0.4 * side)]))]


def dimensions(scene: Scene, points: Floats, size: tuple[int, int], pen: Pen, rng: np.random.Generator) -> Coverage:
    """A dimension line below the object and one beside it, with arrows, extension lines and a number."""
    low, high = points.min(0), points.max(0)
    fine, font = Pen(max(pen.width * 0.5, 1.0)), _font(rng)
    strokes, out = [], np.zeros(size[::-1], np.float32)
    # Keep the whole annotation on the sheet where there is room, clear of the object in any case.
    off = min(max(16.0, 5 * pen.width), max(float(size[1] - high[1]) - 14, 10.0))
    y, x = float(high[1]) + off, float(low[0]) - off
    ends = [(np.array([low[0], y]), np.array([high[0], y]))]
    if rng.random() < 0.6:
        ends.append((np.array([x, low[1]]), np.array([x, high[1]])))
    for p, q in ends:
        middle, along = (p + q) / 2, (q - p) / np.linalg.norm(q - p)
        gap = 24 * size[0] / 800
        strokes += _arrow(middle - gap * along, p, 8) + _arrow(middle + gap * along, q, 8)
        label = f"{int(rng.integers(5, 120))} {rng.choice(['cm', 'mm', 'm', ''])}".strip()
        out = np.maximum(out, text(label, (float(middle[0]), float(middle[1])), 11 * size[0] / 800, size, font))
    del scene
    return np.maximum(out, coverage(strokes, fine, size, rng))


def front_arrow(scene: Scene, points: Floats, size: tuple[int, int], pen: Pen, rng: np.random.Generator) -> Coverage:
    """An arrow that points at the front face, with the word."""
    below = np.array([points[:, 0].min(), points[:, 1].max()])
    tip: Floats = below + np.array([-1, 1]) * (6 + 2 * pen.width)
    tail = tip + np.array([-30.0, 24.0]) * size[0] / 800
    ink = coverage(_arrow(tail, tip, 9), Pen(max(pen.width * 0.8, 1.0)), size, rng)
    del scene
    return np.maximum(ink, text("front", (float(tail[0]), float(tail[1]) + 12), 11 * size[0] / 800, size, _font(rng)))


def right_angles(scene: Scene, points: Floats, size: tuple[int, int], pen: Pen, rng: np.random.Generator) -> Coverage:
    """Small squares in two corners of the front face."""
    n, strokes = scene.sizes[0], []
    for i in rng.choice(n, min(2, n), replace=False):
        p, a, b = points[i], points[i - 1], points[(i + 1) % n]
        u, v = ((q - p) / max(float(np.linalg.norm(q - p)), 1e-9) for q in (a, b))
        s = 9.0 * size[0] / 800
        strokes.append(Stroke(np.array([p + s * u, p + s * (u + v), p + s * v])))
    return coverage(strokes, Pen(max(pen.width * 0.6, 1.0)), size, rng)


def ticks(scene: Scene, points: Floats, size: tuple[int, int], pen: Pen, rng: np.random.Generator) -> Coverage:
    """Short strokes across edges of the front face that say "equal length"."""
    n, strokes = scene.sizes[0], []
    for i in rng.choice(n, min(3, n), replace=False):
        p, q = points[i], points[(i + 1) % n]
        u = (q - p) / max(float(np.linalg.norm(q - p)), 1e-9)
        half = 6.0 * size[0] / 800 * np.array([-u[1], u[0]])
        strokes.append(Stroke(np.array([(p + q) / 2 - half, (p + q) / 2 + half])))
    return coverage(strokes, Pen(max(pen.width * 0.7, 1.0)), size, rng)


def dots(_scene: Scene, points: Floats, size: tuple[int, int], pen: Pen, _rng: np.random.Generator) -> Coverage:
    """A filled dot on each vertex."""
    canvas = np.zeros(size[::-1], np.uint8)
    for p in points:
        centre = (round(p[0] * 16), round(p[1] * 16))
        cv2.circle(canvas, centre, round((pen.width * 1.3 + 1.5) * 16), 255, -1, cv2.LINE_AA, 4)
    return np.asarray(canvas / 255, np.float32)


def diagonals(scene: Scene, points: Floats, size: tuple[int, int], pen: Pen, rng: np.random.Generator) -> Coverage:
    """Auxiliary lines: a diagonal of the front face or of the body, dashed."""
    n, half = scene.sizes[0], scene.half
    i = int(rng.integers(n))
    j = (i + n // 2) % n + (half if n < 4 or rng.random() < 0.5 else 0)
    fine = Pen(max(pen.width * 0.7, 1.0), dash=(1.2, 1.1))
    return coverage([Stroke(np.array([points[i], points[j]]), hidden=True)], fine, size, rng)


def caption(_scene: Scene, points: Floats, size: tuple[int, int], _pen: Pen, rng: np.random.Generator) -> Coverage:
    """A figure's caption and a line of the neighbouring text, partly cut off by the border."""
    font, height, out = _font(rng), 13 * size[0] / 800, np.zeros(size[::-1], np.float32)
    top, bottom = float(points[:, 1].min()), float(points[:, 1].max())
    if bottom + 2.5 * height < size[1]:
        number = int(rng.integers(1, 30))
        out = text(f"Fig. {number}", (size[0] / 2, min(bottom + 45, size[1] - height)), height, size, font)
    if top > 2.5 * height:
        words = "Find the volume of the prism shown below, in cubic centimetres, and sketch its net."
        out = np.maximum(out, text(words, (size[0] * 0.55, height), height, size, font))
    return out


def leaders(_scene: Scene, points: Floats, size: tuple[int, int], pen: Pen, rng: np.random.Generator) -> Coverage:
    """Reference numbers with a curved line to an edge, as patents have them."""
    fine, out, strokes = Pen(max(pen.width * 0.6, 1.0)), np.zeros(size[::-1], np.float32), []
    centre = points.mean(0)
    for i in rng.choice(len(points), min(3, len(points)), replace=False):
        away = (points[i] - centre) / max(float(np.linalg.norm(points[i] - centre)), 1e-9)
        touch = points[i] - 0.2 * (points[i] - points[i - 1])
        tip = points[i] + away * rng.uniform(28, 45) * size[0] / 800
        bend = (touch + tip) / 2 + 8 * np.array([-away[1], away[0]])
        t = np.linspace(0, 1, 12)[:, None]
        strokes.append(Stroke((1 - t) ** 2 * touch + 2 * t * (1 - t) * bend + t**2 * tip))
        at = tip + away * 12
        number = text(str(int(rng.integers(10, 140))), (float(at[0]), float(at[1])), 12 * size[0] / 800, size, "print")
        out = np.maximum(out, number)
    return np.maximum(out, coverage(strokes, fine, size, rng))


def hatching(scene: Scene, points: Floats, size: tuple[int, int], pen: Pen, rng: np.random.Generator) -> Coverage:
    """The front face hatched, as sections are."""
    pitch = float(rng.uniform(7, 12)) * size[0] / 800
    w, h = size
    lines = [Stroke(np.array([[c, 0], [c - h, h]], float)) for c in np.arange(0, w + h, pitch * np.sqrt(2))]
    mask = np.zeros((h, w), np.uint8)
    ring = np.round(points[: scene.sizes[0]] * 16).astype(np.int32)
    cv2.fillPoly(mask, [ring.reshape(-1, 1, 2)], 1, cv2.LINE_8, 4)
    return np.asarray(coverage(lines, Pen(max(pen.width * 0.5, 1.0)), size, rng) * mask, np.float32)


def construction(scene: Scene, points: Floats, size: tuple[int, int], pen: Pen, rng: np.random.Generator) -> Coverage:
    """Faint lines drawn beyond the corners first, as draughtsmen do."""
    strokes = []
    for a, b, _ in scene.edges:
        beyond = (points[b] - points[a]) * rng.uniform(0.08, 0.25)
        strokes.append(Stroke(np.array([points[a] - beyond, points[b] + beyond])))
    faint = coverage(strokes, Pen(max(pen.width * 0.5, 1.0)), size, rng)
    return np.asarray(faint * rng.uniform(0.15, 0.35), np.float32)


def shading(scene: Scene, points: Floats, size: tuple[int, int], lines: str, rng: np.random.Generator) -> Coverage:
    """Grey for the faces a viewer sees, (h, w) 0..0.45; in wire drawings for the front face alone."""
    w, h = size
    out = np.zeros((h, w), np.float32)
    nearest = np.full((h, w), np.inf, np.float32)
    y, x = np.mgrid[0:h, 0:w].astype(np.float32)
    faces = faces_of(np.c_[points, scene.key], scene.sizes)
    for face in faces if lines != "wire" else faces[:1]:
        mask = np.zeros((h, w), np.uint8)
        cv2.fillPoly(mask, [np.round(r * 16).astype(np.int32).reshape(-1, 1, 2) for r in face.rings], 1, cv2.LINE_8, 4)
        key = face.plane[0] * x + face.plane[1] * y + face.plane[2]
        front = (mask > 0) & (key < nearest)
        nearest[front] = key[front]
        out[front] = rng.uniform(0.0, 0.45)
    return out


MARKS: dict[str, Mark] = {
    "letters": letters,
    "dimensions": dimensions,
    "front": front_arrow,
    "right_angles": right_angles,
    "ticks": ticks,
    "dots": dots,
    "diagonals": diagonals,
    "caption": caption,
    "leaders": leaders,
    "hatching": hatching,
    "construction": construction,
}
