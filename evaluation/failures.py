"""Sheets of pictures of the drawings that failed: truth and answer drawn over each other, with the cause."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import cv2
import numpy as np
from PIL import Image as PilImage

from evaluation import metrics
from evaluation.curves import has_curves, ring_lines
from evaluation.outcome import Outcome

TILE, COLUMNS, ROWS = (300, 250), 5, 6
MOST = 120
GREEN, RED, BLUE, GREY = (0, 150, 60), (220, 30, 30), (30, 80, 220), (90, 90, 90)


def write_sheets(outcomes: Sequence[Outcome], folder: Path) -> list[Path]:
    """Write folder/1.jpg, 2.jpg, ... and remove older ones; returns the paths."""
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.glob("*.jpg"):
        old.unlink()
    wrong = [o for o in outcomes if o.wrong][:MOST]
    size = COLUMNS * ROWS
    paths = []
    for start in range(0, len(wrong), size):
        tiles = [tile(o) for o in wrong[start : start + size]]
        tiles += [np.full_like(tiles[0], 255)] * (-len(tiles) % COLUMNS)
        rows = [np.hstack(tiles[i : i + COLUMNS]) for i in range(0, len(tiles), COLUMNS)]
        path = folder / f"{start // size + 1}.jpg"
        PilImage.fromarray(np.vstack(rows)).save(path, quality=75, optimize=True)
        paths.append(path)
    return paths


def tile(outcome: Outcome) -> np.ndarray[Any, Any]:
    """One picture, faded, with truth and answer over it and two lines of words below."""
    w, h = TILE
    with PilImage.open(outcome.case.picture) as opened:
        rgba = opened.convert("RGBA")
        ground = PilImage.new("RGBA", rgba.size, "white")
        picture = PilImage.alpha_composite(ground, rgba).convert("RGB")
    scale = min((w - 6) / picture.width, (h - 40) / picture.height)
    small = np.asarray(
        picture.resize((round(picture.width * scale), round(picture.height * scale)), PilImage.Resampling.LANCZOS)
    )
    out = np.full((h, w, 3), 255, np.uint8)
    out[3 : 3 + small.shape[0], 3 : 3 + small.shape[1]] = (small * 0.55 + 255 * 0.45).astype(np.uint8)
    for truth in metrics.objects_of(outcome.case.truth):
        _draw(out, truth, scale, (GREEN, GREEN), 2)
    for answer in outcome.answers:
        _draw(out, answer, scale, (RED, BLUE), 1)
    for line, text in enumerate(
        (f"{outcome.case.set} {outcome.case.id} {outcome.case.truth.get('profile', '')}", outcome.cause)
    ):
        cv2.putText(out, text[:52], (4, h - 22 + 15 * line), cv2.FONT_HERSHEY_SIMPLEX, 0.36, GREY, 1, cv2.LINE_AA)
    return out


def _draw(
    canvas: np.ndarray[Any, Any], thing: dict[str, Any], scale: float, colours: tuple[Any, Any], width: int
) -> None:
    if has_curves(thing):
        for line in ring_lines(thing):
            path = np.round((line * scale + 3) * 16).astype(np.int32).reshape(-1, 1, 2)
            cv2.polylines(canvas, [path], True, colours[0], width, cv2.LINE_AA, 4)
        return
    vertices, edges = metrics.wireframe(thing)
    points = np.round((vertices * scale + 3) * 16).astype(int)
    half = len(vertices) // 2
    for a, b in edges:
        front = a < half and b < half
        cv2.line(canvas, points[a].tolist(), points[b].tolist(), colours[0 if front else 1], width, cv2.LINE_AA, 4)
