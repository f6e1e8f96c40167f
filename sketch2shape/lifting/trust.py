"""The solids that a drawing may be of, how likely each is, and how sure the proportions are."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from sketch2shape.lifting.decision import Reading
from sketch2shape.lifting.face import edge_vectors
from sketch2shape.lifting.shape import Shape
from sketch2shape.model import Floats

#: edges whose relative lengths differ by less than this (of the logarithm) make one solid to a person
_SAME = 0.12

#: a solid less likely than this is no alternative, and there are no more than so many
_RARE, _MOST = 0.03, 4

#: weights of the `cues`, fitted by `python scripts/calibrate_lifting.py --fit`
WEIGHTS = np.array([9.407, -2.639, -0.208])

#: lengths of this many standard deviations are as good as exact
_SURE = 200.0

#: how likely a wireframe shows its object from below
_FROM_BELOW = 0.08


@dataclass(frozen=True)
class Option:
    """A solid that the drawing may be of.

    reading     : the likeliest of the readings that give it
    shape       : it
    probability : of all these readings
    held        : how much of the reading's likelihood is in these very proportions
    mirrored    : is the far side taken as the near one?
    """

    reading: Reading
    shape: Shape
    probability: float
    held: float
    mirrored: bool = False

    @property
    def is_oblique(self) -> bool:
        """Does the drawing show the face in its true shape and leave the depth free?"""
        return self.shape.free and self.shape.family == "oblique"


def options_of(readings: list[Reading], *, wire: bool) -> list[Option]:
    """The solids that these readings give, the likeliest first."""
    odds = np.array([r.odds for r in readings])
    likely = np.exp(odds - odds.max())
    likely /= likely.sum()
    found: list[tuple[Option, Floats]] = []
    for reading, part in zip(readings, likely.tolist(), strict=True):
        if part < 0.5 * _RARE and found:
            break
        shape = reading.make()
        if shape is None:
            continue
        form = _form(shape)
        for k, (option, other) in enumerate(found):
            if np.abs(form - other).max() < _SAME:
                whole = option.probability + part
                held = (option.held * option.probability + reading.held * part) / whole
                found[k] = (replace(option, probability=whole, held=held), other)
                break
        else:
            found.append((Option(reading, shape, part, reading.held), form))
    options = [option for option, _ in found]
    oblique = sum(o.probability for o in options if o.is_oblique)
    options.sort(key=lambda o: (-(oblique if o.is_oblique else o.probability), -o.probability))
    best = options[0]
    if wire and best.reading.family != "perspective":
        options = [replace(o, probability=o.probability * (1.0 - _FROM_BELOW)) for o in options]
        options.append(replace(best, probability=best.probability * _FROM_BELOW, mirrored=True))
        options[1:] = sorted(options[1:], key=lambda o: -o.probability)
    return [o for k, o in enumerate(options) if k == 0 or o.probability >= _RARE][:_MOST]


def _form(shape: Shape) -> Floats:
    """(3m,) logarithms of the lengths of the edges of front and back face and of those between, over their mean."""
    if shape.bent is not None or shape.pointed:
        logs = np.log(np.maximum(np.append(shape.lengths, abs(shape.depth)), 1e-9))
        return np.asarray(logs - logs.mean())
    vertices = shape.vertices
    m = len(vertices) // 2
    front, back = vertices[:m], vertices[m:]
    edges = (edge_vectors(front, shape.sizes), edge_vectors(back, shape.sizes), back - front)
    lengths = np.concatenate([np.linalg.norm(v, axis=1) for v in edges])
    logs = np.log(np.maximum(lengths, 1e-9))
    form: Floats = logs - logs.mean()
    return form


def belief(options: list[Option], chosen: int) -> float:
    """How likely it is that the proportions of one of the solids are those drawn, whatever the hand shook."""
    own = options[chosen]
    agree = [o for o in options if o is own or (own.is_oblique and o.is_oblique) or o.mirrored != own.mirrored]
    return min(float(own.held * sum(o.probability for o in agree)), 1.0)


def cues(shape: Shape) -> Floats:
    """What tells how well the drawing tells a shape's proportions, a constant first.

    How uncertain the shakiest edge is, and the depth unless that is free anyway: logarithms of the relative standard
    deviations.
    """
    drawn = shape.drawn_lengths
    depth = abs(shape.depth) * float(np.hypot(*shape.pose[2][:2]))
    sizes = np.array([float(drawn.min()), math.inf if shape.family == "oblique" else depth]) / max(shape.noise, 1e-9)
    return np.append(1.0, -np.log(np.clip(sizes, 1.0, _SURE) / _SURE))


def sureness(options: list[Option], chosen: int) -> float:
    """How sure the proportions of one of the solids are, 0 to 1."""
    return belief(options, chosen) / (1.0 + math.exp(-float(WEIGHTS @ cues(options[chosen].shape))))
