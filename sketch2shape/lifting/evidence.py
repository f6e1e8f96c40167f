"""How well a relation between the two drawn faces explains them, in log odds: the currency of all readings.

The told noise is only a guess at how a hand shook: the drawing's own residual says more. So residuals are taken as
Student's t, whose scale is the told noise with the weight of a few observations. Each parameter that a wider relation
fits besides costs what it could have explained by chance.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from sketch2shape.lifting.face_relation import FaceRelation
from sketch2shape.lifting.regularity import Relations
from sketch2shape.model import Floats

#: the told noise counts as much as this many residuals
_WEIGHT = 4.0

#: far over near face: how careless hands draw what should be alike (its spread), and how likely a hand is careless
_CARELESS_SPREAD, _CARELESS = 0.035, 0.3

#: far over near face where a prism faces the viewer in perspective: mean and spread
_FACING, _FACING_SPREAD = 0.8, 0.08

#: smaller over larger face of a tapered object: the widest that is still tapered, about
_LEAST_TAPER, _TAPER_EDGE = 0.92, 0.02

#: log odds that two more parameters cost: an F-test's at one in a hundred (half of 9.2)
_TWO_PARAMETERS = 4.6

#: how likely an edge is parallel to an earlier one
_PARALLEL = 0.5

_ROOT_TWO_PI = math.sqrt(2.0 * math.pi)


@dataclass(frozen=True)
class Relation:
    """How two faces are related.

    odds  : log odds of it
    scale : back face over front face
    noise : standard deviation of a drawn vertex as it leaves it, pixels
    loose : standard deviation of the scale
    """

    odds: float
    scale: float
    noise: float
    loose: float = 0.0


def of_alike_faces(relation: FaceRelation, noise: float, skew: tuple[float, float] | None = None) -> Relation:
    """Two faces meant alike, drawn so or, carelessly, of nearly one size.

    noise : the told standard deviation of a drawn vertex, pixels
    skew  : for parallelograms, how far they are from one, squared, and that over the variance of a vertex
    """
    rss, count = _residuals(relation.translation_rms, 2, relation, skew)
    odds = math.log(1.0 - _CARELESS) + float(fit_odds(rss, count, noise))
    exact = Relation(odds, 1.0, shaking(rss, count - 2, noise))
    if relation.scale <= 0.0:
        return exact
    scaled = of_scaled_faces(relation, noise, skew)
    odds = math.log(_CARELESS) + scaled.odds + _normal(scaled.scale, 1.0, math.hypot(_CARELESS_SPREAD, scaled.loose))
    return exact if exact.odds >= odds else Relation(odds, scaled.scale, scaled.noise)


def of_scaled_faces(relation: FaceRelation, noise: float, skew: tuple[float, float] | None = None) -> Relation:
    """A face and one similar to it, whose scale could have been any between 0 and 1; as `of_alike_faces`."""
    rss, count = _residuals(relation.homothety_rms, 3, relation, skew)
    shaken = shaking(rss, count - 3, noise)
    size = float(np.linalg.norm(relation.first - relation.first.mean(axis=0)))
    loose = shaken * math.sqrt(1.0 + relation.scale**2) / max(size, 1e-9)
    odds = float(fit_odds(rss, count, noise)) + math.log(min(_ROOT_TWO_PI * loose, 1.0))
    return Relation(odds, relation.scale, shaken, loose)


def _residuals(rms: float, fitted: int, relation: FaceRelation, skew: tuple[float, float] | None) -> tuple[float, int]:
    """Sum of squared residuals, each of a vertex's variance, pixels^2, and the coordinates that they come from."""
    count = 2 * len(relation.first)
    rss = rms**2 * max(count - fitted, 1)
    return (rss, count) if skew is None else (rss + skew[0] / skew[1], count + 2)


def facing_odds(scale: float, loose: float) -> float:
    """Log odds of a scale of the back face if it is the front face farther away; loose: its standard deviation."""
    return _normal(min(scale, 1.0 / scale), _FACING, math.hypot(_FACING_SPREAD, loose))


def tapered_odds(scale: float, loose: float) -> float:
    """Log odds of a scale of the back face if the object tapers; as `facing_odds`."""
    return -float(np.logaddexp(0.0, (min(scale, 1.0 / scale) - _LEAST_TAPER) / (_TAPER_EDGE + loose)))


def converging_odds(rss: Floats | float, relation: FaceRelation, noise: float) -> Floats:
    """Log odds of a perspective fit of the faces with these residuals, pixels^2."""
    return fit_odds(rss, 2 * len(relation.first), noise) - _TWO_PARAMETERS


def parallels_odds(relations: Relations, noise: float) -> float:
    """Log odds of a face's edges being parallel to others as they are; noise: of a vertex of the face, pixels."""
    spread = noise * np.sqrt(2.0 * relations.edges) / np.maximum(relations.lengths, 1e-9)
    each = np.log(_PARALLEL * math.pi / (_ROOT_TWO_PI * np.hypot(spread, _SLOPPY)))
    return float((relations.edges - 1) @ np.maximum(each, 0.0))


#: least standard deviation of the direction of a parallel edge, radians
_SLOPPY = math.radians(0.5)


def shaking(rss: float, freedom: int, noise: float) -> float:
    """Standard deviation of a drawn vertex, pixels, from the told noise and the residuals; at least the told one.

    rss     : sum of squared residuals, each of variance noise^2, pixels^2
    freedom : how many of them are free
    """
    return max(noise, math.sqrt((_WEIGHT * noise**2 + rss) / (_WEIGHT + max(freedom, 0))))


def fit_odds(rss: Floats | float, count: int, noise: float) -> Floats:
    """Log odds of residuals against none at all; count: coordinates they come from."""
    odds: Floats = -0.5 * (_WEIGHT + count) * np.log1p(np.asarray(rss) / (_WEIGHT * noise**2))
    return odds


def _normal(value: float, mean: float, spread: float) -> float:
    return -0.5 * ((value - mean) / spread) ** 2 - math.log(_ROOT_TWO_PI * spread)
