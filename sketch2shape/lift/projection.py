"""Which projection a drawing uses, told from how its two faces are related; the simpler family unless the evidence is
significant."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from sketch2shape.lift.homology import FaceRelation, relate_faces
from sketch2shape.model import Floats, TwoFaceObject

Kind = Literal["parallel", "scaled", "converging"]

#: least standard deviation of a drawn vertex, pixels: nothing is known better than this
_LEAST_NOISE = 0.3

#: two faces closer to a translation than this part of the object's size are a translation, whatever their noise
CONVERGENCE = 0.008

#: how often shaking alone may pass for convergence
_CHANCE = 0.01

#: how many times its own residual a simpler family may miss before the wider one is taken
_SIGNIFICANT = 2.0


@dataclass(frozen=True)
class Drawing:
    """A two-face object ready for lifting.

    first, second : (m, 2) pixels, all rings of either face
    sizes         : vertices of each ring
    relation      : how the faces are related
    noise         : standard deviation assumed of a drawn vertex, pixels
    diagonal      : size of the whole object, pixels
    known         : (m,) bool, where f2 was seen, not inferred
    hidden        : do dashed or missing lines tell which face is in front?
    """

    first: Floats
    second: Floats
    sizes: list[int]
    relation: FaceRelation
    noise: float
    diagonal: float
    known: np.ndarray[tuple[int], np.dtype[np.bool_]]
    hidden: bool


def prepare(obj: TwoFaceObject) -> Drawing:
    """Split an object into what the lifting needs."""
    points = _rectified(obj.vertices.astype(np.float64), obj.page)
    m = len(points) // 2
    first, second = points[:m], points[m:]
    known = np.ones(m, bool) if obj.f2_drawn is None else np.asarray(obj.f2_drawn, bool)
    relation = relate_faces(first, second, known)
    diagonal = float(np.linalg.norm(np.ptp(points, axis=0)))
    return Drawing(
        first,
        second,
        [len(r.f1) for r in obj.rings],
        relation,
        max(float(obj.noise), _LEAST_NOISE),
        max(diagonal, 1e-6),
        known,
        obj.lines != "wire",
    )


def _rectified(points: Floats, page: Floats | None) -> Floats:
    """Points as they lie on the page, if the page was photographed at a tilt, in about their size in the picture.

    A homography that sends a point to infinity cannot be that of the page, and is ignored.
    """
    if page is None:
        return points
    mapped = np.c_[points, np.ones(len(points))] @ np.asarray(page, np.float64).T
    depth = mapped[:, 2]
    if not np.isfinite(mapped).all() or np.abs(depth).min() < 1e-9 or np.ptp(np.sign(depth)) > 0:
        return points
    flat: Floats = mapped[:, :2] / depth[:, None]
    size = float(np.linalg.norm(np.ptp(flat, axis=0)))
    if size <= 0.0:
        return points
    scale = float(np.linalg.norm(np.ptp(points, axis=0))) / size
    placed: Floats = (flat - flat.mean(axis=0)) * scale + points.mean(axis=0)
    return placed


def converges(drawing: Drawing, fit_rss: float) -> bool:
    """Does perspective explain the drawing significantly better than a translation of the faces?

    fit_rss : sum of squared residuals of the back face's vertices in the perspective fit, pixels^2

    Two more numbers are fitted than in a parallel view. The F-test for them at one in a hundred has a closed form;
    where the fit is better than the drawing's noise, the noise takes its place.
    """
    m = len(drawing.first)
    freedom = max(2 * m - 4, 1)
    parallel_rss = 2.0 * (2 * m - 2) * drawing.relation.translation_rms**2
    variance = max(fit_rss / freedom, 2.0 * drawing.noise**2)
    needed = 0.5 * freedom * (_CHANCE ** (-2.0 / freedom) - 1.0)
    return bool((parallel_rss - fit_rss) / 2.0 > needed * variance)


def kind_of(drawing: Drawing) -> tuple[Kind, dict[str, Any]]:
    """Are the faces related by a translation, a homothety or a general homology; with the residuals as evidence."""
    r = drawing.relation
    allowed = max(_SIGNIFICANT * drawing.noise, CONVERGENCE * drawing.diagonal)
    evidence = {
        "translation_rms_px": round(r.translation_rms, 3),
        "homothety_rms_px": round(r.homothety_rms, 3),
        "concurrence_rms_px": round(r.centre_rms, 3),
        "face_scale": round(r.scale, 4),
    }
    if r.translation_rms <= allowed or r.translation_rms <= _SIGNIFICANT * min(r.homothety_rms, r.centre_rms):
        return "parallel", evidence
    if r.homothety_rms <= max(_SIGNIFICANT * drawing.noise, _SIGNIFICANT * r.centre_rms) and r.scale > 0:
        return "scaled", evidence
    return "converging", evidence
