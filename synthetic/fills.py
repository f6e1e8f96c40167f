"""Faces told by more than their outline: filled with colours or greys, tinted like glass, hatched."""

from __future__ import annotations

import colorsys
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from sketch2shape.model import Floats
from synthetic.hand import Stroke
from synthetic.layers import RGB, SUPERSAMPLED, Drawn, Layer, area, at_size, nearest_faces, some_colour
from synthetic.pens import coverage

LEAST_STEP = 12
"""Grey levels by which two faces differ at least, that a viewer can tell them apart."""
LEAST_CONTRAST = 24
"""Grey levels by which a face differs at least from the paper."""
LEAST_AREA = 0.06
"""Part of the object's picture that a face fills at least if it is hatched."""


def filled(drawn: Drawn, rng: np.random.Generator) -> list[Layer]:
    """The faces that the viewer sees filled, below the outlines."""
    return _fills(drawn, rng)


def bare_fill(drawn: Drawn, rng: np.random.Generator) -> list[Layer]:
    """The same without outlines: the recipe leaves the strokes away."""
    return _fills(drawn, rng)


def _fills(drawn: Drawn, rng: np.random.Generator) -> list[Layer]:
    """Each face that is seen in a tone of its own; one colour in the light of a lamp, or colours at will."""
    index, planes = nearest_faces(drawn)
    seen = [int(k) for k in np.unique(index) if k >= 0]
    pixels_a_unit = drawn.diagonal / float(np.linalg.norm(np.ptp(drawn.scene.solid, axis=0)))
    normals = {k: planes[k] * [pixels_a_unit, pixels_a_unit, 0] + [0, 0, 1] for k in seen}
    tones = _tones(normals, _neighbours(index), drawn.ground, rng)
    # One area below all, so that no paper shines through where two faces meet.
    layers = [Layer(at_size(index >= 0, drawn.size), tones[seen[0]], under=True)]
    return layers + [Layer(at_size(index == k, drawn.size), tones[k], under=True) for k in seen]


def _neighbours(index: NDArray[np.intp]) -> set[tuple[int, int]]:
    """Pairs of faces that lie beside each other in the picture, more than in a point."""
    found: set[tuple[int, int]] = set()
    for one, other in ((index[:, :-1], index[:, 1:]), (index[:-1], index[1:])):
        border = (one != other) & (one >= 0) & (other >= 0)
        pairs, counts = np.unique(np.sort(np.c_[one[border], other[border]], axis=1), axis=0, return_counts=True)
        found |= {(int(a), int(b)) for (a, b), count in zip(pairs, counts, strict=True) if count > 2 * SUPERSAMPLED}
    return found


def _tones(
    normals: dict[int, Floats], beside: set[tuple[int, int]], ground: RGB, rng: np.random.Generator
) -> dict[int, RGB]:
    """Colours of the faces, clear of the paper and of those beside them."""
    vivid, uneven = rng.random() < 0.25, 0.0
    while True:
        hue, saturation = rng.random(), float(rng.choice([0.0, rng.uniform(0.1, 0.8)]))
        lamp = rng.normal(0, 1, 3)
        tones = {}
        for k, normal in normals.items():
            light = 0.5 + 0.5 * float(normal @ lamp) / float(np.linalg.norm(normal) * np.linalg.norm(lamp))
            light = (1 - uneven) * light + uneven * float(rng.random())
            if vivid:
                colour = colorsys.hsv_to_rgb(rng.random(), rng.uniform(0.3, 0.9), rng.uniform(0.4, 1.0))
            else:
                colour = colorsys.hsv_to_rgb(hue, saturation, 0.2 + 0.75 * light)
            tones[k] = (round(255 * colour[0]), round(255 * colour[1]), round(255 * colour[2]))
        greys = {k: _grey(c) for k, c in tones.items()}
        apart = all(abs(greys[i] - greys[j]) >= LEAST_STEP for i, j in beside)
        if apart and all(abs(g - _grey(ground)) >= LEAST_CONTRAST for g in greys.values()):
            return tones
        uneven = min(uneven + 0.02, 1.0)  # parallel faces beside each other have one tone in any light


def _grey(colour: RGB) -> float:
    return 0.299 * colour[0] + 0.587 * colour[1] + 0.114 * colour[2]


def tinted(drawn: Drawn, rng: np.random.Generator) -> list[Layer]:
    """Faces like coloured glass, each over those behind it, or one face alone in a light colour."""
    n, half = drawn.scene.sizes[0], drawn.scene.half
    f1, f2 = drawn.points[:n], drawn.points[half : half + n]
    faces = [f2, *(np.array([f1[i - 1], f1[i], f2[i], f2[i - 1]]) for i in range(n)), f1]
    if rng.random() < 0.5:
        faces = [faces[int(rng.choice(np.array([0, len(faces) - 1, rng.integers(len(faces))])))]]
    strength = float(rng.uniform(0.15, 0.5))
    one = some_colour(rng, 0.0)
    return [
        Layer(
            np.asarray(strength * area([f], drawn.size), np.float32),
            one if rng.random() < 0.6 else some_colour(rng, 0.0),
            True,
        )
        for f in faces
    ]


def hatched(drawn: Drawn, rng: np.random.Generator) -> list[Layer]:
    """One face or several hatched, from fine to coarse, sometimes crosswise, by ruler or by hand."""
    index, _ = nearest_faces(drawn)
    if drawn.lines == "wire":
        chosen = [0]
    else:
        seen = _broad(index)
        chosen = [int(k) for k in rng.permutation(seen)[: int(rng.integers(1, min(3, len(seen)) + 1))]]
    pen = replace(drawn.pen, width=max(drawn.pen.width * float(rng.uniform(0.35, 0.9)), 1.0))
    finest, coarsest = 2.6 * pen.width, 0.12 * drawn.diagonal
    pitch = float(np.exp(rng.uniform(np.log(finest), np.log(max(coarsest, 1.5 * finest)))))
    layers = []
    for k in chosen:
        mask = _whole_front(drawn) if drawn.lines == "wire" else at_size(index == k, drawn.size)
        turn = float(np.radians(rng.choice([45, -45, 30, 0, 90, rng.uniform(0, 180)])))
        turns = [turn, turn + np.pi / 2] if rng.random() < 0.15 else [turn]
        lines = [line for t in turns for line in _hatch_lines(drawn, t, pitch, rng)]
        layers.append(Layer(np.asarray(coverage(lines, pen, drawn.size, rng) * mask, np.float32)))
    return layers


def _broad(index: NDArray[np.intp]) -> list[int]:
    """The faces of which enough is seen to be hatched."""
    faces, counts = np.unique(index[index >= 0], return_counts=True)
    return [int(f) for f, count in zip(faces, counts, strict=True) if count > LEAST_AREA * counts.sum()]


def _whole_front(drawn: Drawn) -> NDArray[np.float32]:
    """The front face less its holes: in a wireframe nothing lies before it."""
    n, start = drawn.scene.sizes[0], drawn.scene.sizes[0]
    mask = area([drawn.points[:n]], drawn.size)
    for k in drawn.scene.sizes[1:]:
        mask = np.minimum(mask, 1 - area([drawn.points[start : start + k]], drawn.size))
        start += k
    return mask


def _hatch_lines(drawn: Drawn, turn: float, pitch: float, rng: np.random.Generator) -> list[Stroke]:
    """Parallel lines over the object's box, uneven by what the hand is."""
    along, aside = np.array([np.cos(turn), np.sin(turn)]), np.array([-np.sin(turn), np.cos(turn)])
    reach = 0.55 * drawn.diagonal
    uneven = 0.12 * pitch if drawn.hand.wobble else 0.0
    paths = []
    for c in np.arange(-reach + rng.uniform(0, pitch), reach, pitch):
        middle = drawn.centre + (c + rng.normal(0, 1) * uneven) * aside
        paths.append(np.array([middle - reach * along, middle + reach * along]))
    return drawn.strokes(paths, rng)
