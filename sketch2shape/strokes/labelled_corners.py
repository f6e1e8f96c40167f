"""Corner detection as a stage of its own: detectors propose, strokes confirm.

Strategy. Shi-Tomasi (Shi and Tomasi 1994) and Harris (Harris and Stephens 1988) fire wherever the ink's gradient has
two strong directions: at vertices, but also at crossings, at the ends of dashes, and twice or more at a blunt corner;
they are right to a few pixels. Strokes know what meets where. So a detector only proposes places; the corner is where
strokes meet close by, at the intersection of their lines, and how they meet is the corner's kind: an X is a crossing of
two strokes that both run straight on, and no vertex.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from sketch2shape.model import Bools, Brief, Floats, Ints
from sketch2shape.strokes.corner_detectors import DETECTORS, Detector, detector_named, near, propose, reach_of
from sketch2shape.strokes.junctions import Corners as Joined
from sketch2shape.strokes.junctions import join_ends, slanted_pairs
from sketch2shape.strokes.stage import drawn_strokes, ink_of, working_tolerance
from sketch2shape.strokes.tracing import Strokes

Kind = Literal["end", "L", "Y", "W", "T", "X", "multi", "none"]

STRAIGHT = 0.26
"""Two strokes that meet at less than this (radians, 15 degrees) from straight run on through the corner."""
SPECK = 0.05
"""A stroke by itself, shorter than this part of the drawing, is a dash or part of a letter: its ends are no corners."""


@dataclass(frozen=True, eq=False, repr=False)
class DetectedCorners(Brief):
    """Corners of a drawing; vertices first, then crossings and loose ends.

    points     : (k, 2) float, picture pixels: where strokes meet, sub-pixel; of a detector asked by name, its places
    kinds      : k names: "L" two strokes turn; "Y" three, none of the angles over 180 degrees; "W" three, one is;
                 "T" a stroke ends on another; "X" two strokes cross, both running on; "multi" more than three
                 end there, or run on; "end" a stroke ends in the open; "none" no strokes meet there: a detector asked
                 by name sees more than one place at a blunt corner, and others along the strokes
    degree     : (k,) int, how many arms leave the corner: 0 for none, 1 for an end, 2 for L, 3 for Y, W and T, 4 for X
    shi_tomasi : (k,) bool, proposed by Shi-Tomasi
    harris     : (k,) bool, proposed by Harris
    placed     : (k, 2) float, picture pixels: where the strokes put each corner, `points` where they know of none
    """

    points: Floats
    kinds: tuple[Kind, ...]
    degree: Ints
    shi_tomasi: Bools
    harris: Bools
    placed: Floats

    @property
    def is_vertex(self) -> Bools:
        """(k,) bool: what can be a vertex of the object: strokes meet there and end. At a T something is hidden."""
        return np.array([kind not in ("X", "end", "none") for kind in self.kinds], bool)

    @property
    def vertices(self) -> Floats:
        """(m, 2) float: the corners that can be vertices, where the strokes put them."""
        return self.placed[self.is_vertex]

    def __len__(self) -> int:
        """How many corners."""
        return len(self.points)


def detect_corners(source: Any, detector: Detector = "both", *, tolerance: float | None = None) -> DetectedCorners:
    """Corners of a drawing, with their kind.

    source    : path, bytes, PIL image, array (gray, RGB, RGBA), `Picture`, or the `Ink` of one
    detector  : "both" (or "auto"): where strokes meet and either detector sees it, placed by the strokes;
                "shi-tomasi" (or "goodFeaturesToTrack") or "harris": all that this detector sees, strongest first,
                where it sees it, to a few pixels; the strokes only say what is there
    tolerance : picture pixels by which a drawn line may stray from a straight one, see `trace_strokes`

    `separate_faces(source, corners=...)` takes what is returned. Raises UsageError for an unknown detector,
    UnreadableError or LimitError for a picture that cannot be read.
    """
    chosen = detector_named(detector)
    ink = ink_of(source)
    stray = working_tolerance(ink, tolerance)
    strokes = _drawing(drawn_strokes(ink, stray))
    joined = _with_crossings(strokes, ink.pen_width) if len(strokes.ends) else _nothing()
    places = {name: propose(ink, name) for name in DETECTORS[1:]}
    reach = reach_of(ink, stray)
    found = joined if chosen == "both" else _as_seen(places[chosen], joined, reach)
    seen = {name: near(found.points, place, reach) for name, place in places.items()}
    keep = np.flatnonzero(seen["shi-tomasi"] | seen["harris"])
    return DetectedCorners(
        ink.to_picture(found.points[keep]),
        tuple(found.kinds[k] for k in keep),
        found.degree[keep],
        seen["shi-tomasi"][keep],
        seen["harris"][keep],
        ink.to_picture(found.placed[keep]),
    )


@dataclass(frozen=True)
class _Meetings:
    """Corners in working pixels: where they are seen, what they are, and where the strokes put them."""

    points: Floats
    kinds: tuple[Kind, ...]
    degree: Ints
    placed: Floats


def _nothing() -> _Meetings:
    return _Meetings(np.zeros((0, 2)), (), np.zeros(0, np.intp), np.zeros((0, 2)))


def _as_seen(places: Floats, joined: _Meetings, reach: float) -> _Meetings:
    """The places of a detector (k, 2), each corner of the strokes labelling the one that is nearest to it."""
    kinds: list[Kind] = ["none"] * len(places)
    degree, placed = np.zeros(len(places), np.intp), places.copy()
    if len(places) and len(joined.points):
        gap = np.linalg.norm(places[:, None] - joined.points[None], axis=2)
        for corner in np.argsort(gap.min(axis=0), kind="stable").tolist():
            place = int(gap[:, corner].argmin())
            if gap[place, corner] <= reach and kinds[place] == "none":
                kinds[place], degree[place] = joined.kinds[corner], joined.degree[corner]
                placed[place] = joined.points[corner]
    return _Meetings(places, tuple(kinds), degree, placed)


def _drawing(strokes: Strokes) -> Strokes:
    """Without dashes and letters that lie by themselves."""
    if not len(strokes.ends):
        return strokes
    size = float(np.hypot(*np.ptp(strokes.ends.reshape(-1, 2), axis=0)))
    long = strokes.lengths >= SPECK * size
    ends = strokes.ends.reshape(-1, 2)
    gap = np.linalg.norm(ends[:, None] - ends[None], axis=2)
    other = np.arange(len(ends)) // 2
    touches = ((gap < SPECK * size / 2) & (other[:, None] != other[None]) & long[other][None]).any(axis=1)
    keep = long | touches.reshape(-1, 2).any(axis=1)
    return Strokes(strokes.ends[keep], strokes.inked[keep], strokes.tolerance)


def _with_crossings(strokes: Strokes, pen: float) -> _Meetings:
    """Where ends meet, and where strokes cross far from any of those; loose ends last."""
    joined = join_ends(strokes, pen)
    arms = _arms(strokes, joined)
    kinds = [_kind(a, bool(on)) for a, on in zip(arms, joined.on, strict=True)]
    degree = np.array([len(a) + 2 * bool(on) for a, on in zip(arms, joined.on, strict=True)], np.intp)
    near = strokes.tolerance + 2 * pen
    single = _single(joined.points, degree, near)
    vertices = [k for k in single if kinds[k] != "end"]
    ends = [k for k in single if kinds[k] == "end"]
    crossed, through = _crossings(strokes, joined.points, pen)
    # three strokes through one point are no accident: vertices may coincide there
    cross: list[Kind] = ["multi" if t > 2 else "X" for t in through]
    loose: list[Kind] = ["end" for _ in ends]
    points = np.concatenate([joined.points[vertices], crossed, joined.points[ends]])
    degrees = np.concatenate([degree[vertices], 2 * through, degree[ends]]).astype(np.intp)
    return _Meetings(points, (*(kinds[k] for k in vertices), *cross, *loose), degrees, points)


def _single(points: Floats, degree: Ints, near: float) -> list[int]:
    """Corners without those that lie on one where more strokes meet: most strokes first."""
    kept: list[int] = []
    for k in np.argsort(-degree, kind="stable").tolist():
        if not kept or float(np.linalg.norm(points[kept] - points[k], axis=1).min()) > near:
            kept.append(k)
    return kept


def _arms(strokes: Strokes, joined: Joined) -> list[Floats]:
    """For each corner the directions (radians) in which strokes leave it."""
    span = strokes.ends[:, 1] - strokes.ends[:, 0]
    angle = np.arctan2(span[:, 1], span[:, 0])
    leaving = np.c_[angle, angle + np.pi].ravel()
    at = joined.strokes.ravel()
    return [leaving[at == k] for k in range(len(joined.points))]


def _kind(arms: Floats, on: bool) -> Kind:
    """The kind of a corner from the directions of the strokes that end there, and whether one runs through."""
    if on:
        return "T" if len(arms) == 1 else "multi"
    if len(arms) < 3:
        return "end" if len(arms) < 2 else "L"
    if len(arms) > 3:
        return "multi"
    around = np.sort(arms % (2 * np.pi))
    widest = float(np.diff(np.r_[around, around[0] + 2 * np.pi]).max())
    if abs(widest - np.pi) <= STRAIGHT:
        return "T"
    return "W" if widest > np.pi else "Y"


def _crossings(strokes: Strokes, corners: Floats, pen: float) -> tuple[Floats, Ints]:
    """Where strokes cross away from corners (k, 2): (m, 2) points, and (m,) how many strokes cross there."""
    near = strokes.tolerance + 2 * pen
    i, j, s, t = slanted_pairs(strokes)
    inside = (s > 0) & (s < 1) & (t > 0) & (t < 1)
    a, b = strokes.ends[i[inside]].swapaxes(0, 1)
    points, pairs = a + s[inside, None] * (b - a), np.c_[i, j][inside]
    if len(points) and len(corners):
        free = np.linalg.norm(points[:, None] - corners[None], axis=2).min(axis=1) > near
        points, pairs = points[free], pairs[free]
    groups: list[list[int]] = []
    for k, p in enumerate(points):
        home = next((g for g in groups if float(np.linalg.norm(points[g[0]] - p)) <= near), None)
        groups.append([k]) if home is None else home.append(k)
    middle = np.array([points[g].mean(axis=0) for g in groups]).reshape(-1, 2)
    return middle, np.array([len(np.unique(pairs[g])) for g in groups], np.intp)
