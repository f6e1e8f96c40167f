"""One test drawing with its truth: `draw("photo_wire", seed=3, index=0)`; the same arguments give the same bytes."""

from __future__ import annotations

import json
import zlib
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from sketch2shape.model import Floats
from synthetic.cropping import Window, window
from synthetic.exercise import exercise
from synthetic.flat import FLAT
from synthetic.hand import Stroke, moved_vertices, pulled, strokes_of
from synthetic.layers import Drawn, Layer
from synthetic.marks import MARKS, shading
from synthetic.media import MEDIA, Style
from synthetic.negatives import NEGATIVES
from synthetic.nuisances import NUISANCES
from synthetic.other_solids import OTHER_SOLIDS
from synthetic.papers import CAPTURES, Image, ink_on, mapped, paper, to_pixels
from synthetic.pens import Pen, coverage
from synthetic.recipes import RECIPES, Recipe, annotated
from synthetic.scenes import Scene, scene
from synthetic.sheets import SHEETS
from synthetic.turned_scenes import Turned, moved_arc, turned_scene, turned_truth

FACES = ("f1", "f2")

SCORED_LIKE = {
    "gappy": "annotated",
    "thick": "marker",
    "sloppy": "handheavy",
    "pressed": "noisy",
    "shade": "noisy",
}
"""Medium that the measures know, for those that they do not."""

SUBJECTS = NEGATIVES | FLAT | SHEETS | OTHER_SOLIDS
"""What is drawn where no object is, by name."""


@dataclass(frozen=True)
class Drawing:
    """A drawing with truth.

    pixels : (h, w, 3) uint8 RGB, or (h, w, 4) RGBA on a transparent ground
    truth  : JSON-ready: f1, f2, holes, lines, projection, solid, ...; a sheet has `objects`
    suffix : file format that suits the medium
    quality: of a JPEG, 0 to 100
    """

    pixels: NDArray[np.uint8]
    truth: dict[str, Any]
    suffix: str
    quality: int = 82

    def encoded(self) -> bytes:
        """The picture file."""
        order = cv2.COLOR_RGBA2BGRA if self.pixels.shape[2] == 4 else cv2.COLOR_RGB2BGR
        options = (
            [cv2.IMWRITE_JPEG_QUALITY, self.quality] if self.suffix == ".jpg" else [cv2.IMWRITE_PNG_COMPRESSION, 9]
        )
        return bytes(cv2.imencode(self.suffix, cv2.cvtColor(self.pixels, order), options)[1])

    def save(self, folder: Path) -> Path:
        """Write FOLDER/CATEGORY/ID.png (or .jpg) and the truth beside it; returns the picture's path."""
        target = folder / f"{self.truth['id']}{self.suffix}"
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(self.encoded())
        target.with_suffix(".json").write_text(json.dumps(self.truth))
        return target


def draw(category: str, seed: int, index: int, *, shapes: str | None = None) -> Drawing:
    """Drawing number `index` of a category (a name in `RECIPES`); `shapes` overrides the recipe's."""
    recipe, style, facts, rng = _begun(category, seed, index)
    if shapes:
        recipe = replace(recipe, wish=replace(recipe.wish, shapes=shapes))
    if recipe.objects == (0, 0):
        return _negative(recipe.subjects or tuple(NEGATIVES), style, index, facts, rng)
    if recipe.curved:
        return _curved(recipe, style, index, facts, rng)
    if recipe.objects != (1, 1):
        return _sheet(recipe, style, facts, rng)
    return _single(recipe, style, facts, rng)


def pen_strokes(category: str, seed: int, index: int) -> tuple[list[Stroke], Style, dict[str, Any]]:
    """The strokes of a drawing of one object before any ink flows, how they are drawn, and the truth.

    They are those of `draw` with the same arguments, where the category has nothing beside the object.
    """
    recipe, style, facts, rng = _begun(category, seed, index)
    if recipe.curved:
        made, style, strokes = _curved_strokes(recipe, style, index, rng)
        truth = turned_truth(made, recipe.wish.lines)
    else:
        prism, points, style, strokes = _strokes(recipe, style, rng)
        truth = prism.truth(recipe.wish.lines, points)
    return strokes, style, truth | facts | {"width": style.size[0], "height": style.size[1]}


def _begun(category: str, seed: int, index: int) -> tuple[Recipe, Style, dict[str, Any], np.random.Generator]:
    recipe = RECIPES[category]
    rng = np.random.default_rng([seed, zlib.crc32(category.encode()), index])
    medium = recipe.media[index % len(recipe.media)]
    style = MEDIA[medium](rng)
    facts = {"medium": _scored_medium(medium, recipe), "category": category, "id": f"{category}/{index:03d}"}
    return recipe, style, facts, rng


def _scored_medium(medium: str, recipe: Recipe) -> str:
    """The medium by whose tolerance an answer is scored."""
    if (recipe.marks or recipe.nuisances) and medium == "clean":
        return "annotated"
    return SCORED_LIKE.get(medium, medium)


def _single(recipe: Recipe, style: Style, facts: dict[str, Any], rng: np.random.Generator) -> Drawing:
    made, points, style, strokes = _strokes(recipe, style, rng)
    lines = recipe.wish.lines
    ink = style.pen.alpha * coverage(strokes, style.pen, style.size, rng)
    for name in _chosen(recipe.marks, rng):
        ink = np.maximum(ink, MARKS[name](made, points, style.size, style.pen, rng))
    layers = _layers(recipe, Drawn(made, points, lines, style.size, style.pen, style.hand, style.ground), rng)
    sheet = paper(style.pattern, style.size, style.ground, rng)
    if "shading" in recipe.marks:
        red, green, blue = (int(v) for v in rng.integers(40, 200, 3))
        tint = (red, green, blue) if rng.random() < 0.5 else (60, 60, 60)
        sheet = ink_on(sheet, shading(made, points, style.size, lines, rng), tint)
    sheet = _laid(sheet, [layer for layer in layers if layer.under], style.pen)
    image = sheet if "bare" in recipe.nuisances else ink_on(sheet, ink, style.pen.colour)
    image = _laid(image, [layer for layer in layers if not layer.under], style.pen)
    truth = made.truth(lines, points) | facts
    if "cut" in recipe.marks:
        image, truth = _cut(image, truth, style, rng)
    if recipe.crop:
        image, truth = _cropped(image, truth, window(made, points, lines, style.size, rng))
    if style.clear:
        colour = np.full((*ink.shape, 3), style.pen.colour, np.float32)
        image = np.dstack([colour, ink * 255])
    return _captured(image, truth, style, rng)


def _strokes(recipe: Recipe, style: Style, rng: np.random.Generator) -> tuple[Scene, Floats, Style, list[Stroke]]:
    """A prism, where the hand puts its vertices, on what sheet, and its strokes."""
    style = _roomy(style, recipe)
    made = scene(recipe.wish, style.size, style.pen.width, rng, _share_of_sheet(recipe, rng))
    points = moved_vertices(made, style.hand, rng)
    return made, points, style, strokes_of(made, points, recipe.wish.lines, style.hand, rng)


def _curved(recipe: Recipe, style: Style, index: int, facts: dict[str, Any], rng: np.random.Generator) -> Drawing:
    """An object with arcs or an apex; its hand wanders, but its corners stay where they are."""
    made, style, strokes = _curved_strokes(recipe, style, index, rng)
    ink = style.pen.alpha * coverage(strokes, style.pen, style.size, rng)
    if recipe.marks:
        ink = np.maximum(ink, exercise(made, style.size, style.pen, style.hand, rng))
    image = ink_on(paper(style.pattern, style.size, style.ground, rng), ink, style.pen.colour)
    return _captured(image, turned_truth(made, recipe.wish.lines) | facts, style, rng)


def _curved_strokes(
    recipe: Recipe, style: Style, index: int, rng: np.random.Generator
) -> tuple[Turned, Style, list[Stroke]]:
    kind, lines = recipe.curved[index % len(recipe.curved)], recipe.wish.lines
    fill = 0.76 if recipe.marks else 0.84
    made = turned_scene(kind, recipe.wish, style.size, style.pen.width, rng, fill)
    shown = [line for line in made.lines if not line.hidden or lines != "removed"]
    strokes = [s for line in shown for s in pulled(line.path, line.hidden and lines == "dashed", style.hand, rng)]
    return made, style, strokes


def _share_of_sheet(recipe: Recipe, rng: np.random.Generator) -> float:
    """Part of the sheet that the object may fill."""
    if recipe.nuisances:
        return float(rng.uniform(0.5, 0.75))
    return 0.58 if annotated(recipe) else 0.84


def _layers(recipe: Recipe, drawn: Drawn, rng: np.random.Generator) -> list[Layer]:
    """What lies on and around the object: of several nuisances two or three."""
    names = list(recipe.nuisances)
    if len(names) > 1:
        names = [str(n) for n in rng.choice(names, int(rng.integers(2, 4)), replace=False)]
    return [layer for name in names for layer in NUISANCES[name](drawn, rng)]


def _laid(image: Image, layers: list[Layer], pen: Pen) -> Image:
    """The picture with the layers laid over it in turn."""
    for layer in layers:
        image = ink_on(image, layer.ink * np.float32(pen.alpha), layer.colour or pen.colour)
    return image


def _roomy(style: Style, recipe: Recipe) -> Style:
    """A larger sheet where many vertices or annotations have to fit."""
    if annotated(recipe) or "shading" in recipe.marks:
        return replace(style, size=(800, 600))
    if recipe.wish.shapes == "large" or recipe.wish.holes:
        return replace(style, size=(900, 700))
    return style


def _chosen(marks: tuple[str, ...], rng: np.random.Generator) -> list[str]:
    names = [m for m in marks if m in MARKS]
    if len(names) <= 1:
        return names
    return [str(n) for n in rng.choice(names, int(rng.integers(2, 5)), replace=False)]


def _cut(image: Image, truth: dict[str, Any], style: Style, rng: np.random.Generator) -> tuple[Image, dict[str, Any]]:
    """Crop so that the border touches the object on one or two sides: its outermost strokes are half cut off."""
    points = np.array(truth["f1"] + truth["f2"])
    low = np.maximum(np.floor(points.min(0)).astype(int), 0)
    high = np.ceil(points.max(0)).astype(int) + 1
    keep = rng.integers(0, 2, 4)
    x0, y0 = int(low[0] * keep[0]), int(low[1] * keep[1])
    x1, y1 = (int(high[k]) if keep[2 + k] else style.size[k] for k in (0, 1))
    return _cropped(image, truth, (x0, y0, x1, y1))


def _cropped(image: Image, truth: dict[str, Any], kept: Window) -> tuple[Image, dict[str, Any]]:
    """What lies in the window."""
    x0, y0, x1, y1 = kept
    return image[y0:y1, x0:x1], _moved(truth, np.array([[1, 0, -x0], [0, 1, -y0], [0, 0, 1.0]]))


def _sheet(recipe: Recipe, style: Style, facts: dict[str, Any], rng: np.random.Generator) -> Drawing:
    """Several objects in the cells of a larger sheet."""
    count = int(rng.integers(recipe.objects[0], recipe.objects[1] + 1))
    cell = (520, 420)
    full = (cell[0] * 2, cell[1] * (1 if count <= 2 else 2))
    strokes, objects = [], []
    for place in rng.permutation(4 if count > 2 else 2)[:count]:
        offset = np.array([place % 2 * cell[0], place // 2 * cell[1]], float)
        made = _shifted(scene(recipe.wish, cell, style.pen.width, rng, 0.74), offset)
        points = moved_vertices(made, style.hand, rng)
        strokes += strokes_of(made, points, recipe.wish.lines, style.hand, rng)
        objects.append(made.truth(recipe.wish.lines, points) | {"medium": facts["medium"]})
    ink = style.pen.alpha * coverage(strokes, style.pen, full, rng)
    image = ink_on(paper(style.pattern, full, style.ground, rng), ink, style.pen.colour)
    truth = {"objects": objects, "profile": "+".join(o["profile"] for o in objects), "lines": recipe.wish.lines}
    return _captured(image, truth | {"projection": {"family": "mixed"}} | facts, style, rng)


def _shifted(made: Scene, offset: Floats) -> Scene:
    return replace(made, points=made.points + offset)


def _negative(
    subjects: tuple[str, ...], style: Style, index: int, facts: dict[str, Any], rng: np.random.Generator
) -> Drawing:
    name = subjects[index % len(subjects)]
    ink = style.pen.alpha * SUBJECTS[name](style.size, style.pen, style.hand, rng)
    image = ink_on(paper(style.pattern, style.size, style.ground, rng), ink, style.pen.colour)
    truth = {"objects": [], "profile": name, "lines": "none", "projection": {"family": "none"}} | facts
    return _captured(image, truth, style, rng)


def _captured(image: Image, truth: dict[str, Any], style: Style, rng: np.random.Generator) -> Drawing:
    taken, homography = CAPTURES[style.capture](image, rng)
    pixels = to_pixels(taken)
    size = {"width": int(pixels.shape[1]), "height": int(pixels.shape[0])}
    if "objects" in truth:
        objects = [_moved(o, homography) | size for o in truth["objects"]]
        return Drawing(pixels, truth | {"objects": objects} | size, style.suffix, style.quality)
    return Drawing(pixels, _moved(truth, homography) | size, style.suffix, style.quality)


def _moved(truth: dict[str, Any], homography: Floats) -> dict[str, Any]:
    def rings(pair: dict[str, Any]) -> dict[str, Any]:
        return {k: np.round(mapped(np.array(pair[k], float).reshape(-1, 2), homography), 3).tolist() for k in FACES}

    moved = truth | rings(truth) | {"holes": [rings(h) for h in truth["holes"]]}
    if "arcs" in truth:
        moved["arcs"] = [moved_arc(a, homography) for a in truth["arcs"]]
        moved["silhouettes"] = [np.round(mapped(np.array(s), homography), 3).tolist() for s in truth["silhouettes"]]
    return moved
