"""What a person put right by hand: the corrections file, and how it is applied.

The file is JSON. For one picture:

    {"schema": "sketch2shape-corrections/1",
     "objects": [{"f1": [[x, y], ...], "f2": [[x, y], ...],        ring order, f1[i] joins f2[i], pixels of the picture
                  "holes": [{"f1": [...], "f2": [...]}],
                  "projection": "axonometric", "reading": 2, "width": "40mm"}]}

`"arcs"`, in the words of a report, tell which edges are curved (`"points"` along them suffice; those of "f2" may be
left out, but for whole ellipses); "f2" of one vertex is the point of a pyramid or a cone.
`"lines"`, `"noise"`, `"f2_drawn"` and `"page"`, as in a report, tell how it is drawn; the proportions depend on it.
`"d": [dx, dy]` may stand for "f2", which is then f1 shifted. With `"vertices": [[x, y], ...]` the rings may be indices
into it. An object without "f1" leaves the finding to the program and only says how to lift the object at this place of
the list. For a folder, `{"schema": ..., "pictures": {"a.png": {"objects": [...]}, ...}}`. A report (NAME.json) is
accepted as well, so that a wrong number can be put right in it and the report given back.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import PurePosixPath
from typing import TYPE_CHECKING, Any, Literal, cast

import numpy as np

from sketch2shape.corrections.arcs import arcs_from, needs_vertices
from sketch2shape.corrections.manner import MANNERS, manner_from
from sketch2shape.errors import UsageError
from sketch2shape.model import Answer, FacePair, Floats, Picture, Side, TwoFaceObject

if TYPE_CHECKING:
    from sketch2shape.lifting import LiftOptions
SCHEMA = "sketch2shape-corrections/1"

_UNTANGLE = "vertices in ring order, none on another, no edges that cross"
_MOST_VERTICES, _MOST_OBJECTS, _FARTHEST = 2000, 200, 1e6
_MOST_READINGS = 100
_FAMILIES = ("auto", "oblique", "axonometric", "perspective")
_SIZES = ("width", "height", "depth")
#: what a report says of an object beyond what can be corrected
_FINDINGS = frozenset({"silhouettes", "shape", "edges", "confidence", "solid", "alternatives", "connectors"})
_OBJECT_KEYS = frozenset({"vertices", "f1", "f2", "d", "holes", "arcs", "projection", "reading", *_SIZES, *MANNERS})


@dataclass(frozen=True)
class ObjectCorrection:
    """What is right about one object.

    shape      : the object's faces as given by hand, None to keep those found
    projection : its projection, "auto" to tell it from the drawing
    sizes      : real "width", "height", "depth" by name, such as "40mm" or a number
    reading    : 1 for the likeliest solid that the drawing may be of, 2 for the next; None where nothing was said
    """

    shape: TwoFaceObject | None = None
    projection: Literal["auto", "oblique", "axonometric", "perspective"] = "auto"
    sizes: Mapping[str, str | float] = field(default_factory=dict)
    reading: int | None = None

    def options(self, base: LiftOptions) -> LiftOptions:
        """The lift options `base`, with what this correction says put in their place."""
        changes: dict[str, Any] = dict(self.sizes)
        if self.projection != "auto":
            changes["projection"] = self.projection
        if self.reading is not None:
            changes["reading"] = self.reading
        return replace(base, **changes)


@dataclass(frozen=True)
class Corrections:
    """The corrections of one picture: one entry for each object, best first."""

    objects: tuple[ObjectCorrection, ...]

    @property
    def complete(self) -> bool:
        """Whether every object's faces are given, so that nothing needs to be found in the picture."""
        return bool(self.objects) and all(o.shape is not None for o in self.objects)


def parse_corrections(text: str | bytes, name: str = "") -> Corrections | None:
    """The corrections for the picture called `name` in a corrections file or report; None if it says nothing on it.

    Raises UsageError in plain words if the text is not such a file.
    """
    try:
        data = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise _wrong(f"the corrections are not JSON ({str(error)[:80]})") from error
    return corrections_from(data, name)


def corrections_from(data: Any, name: str = "") -> Corrections | None:
    """As `parse_corrections`, from JSON that is already decoded."""
    top = _mapping(data, "the corrections")
    if top.get("schema", SCHEMA) not in (SCHEMA, "sketch2shape/1"):
        raise _wrong(f'the schema of the corrections is not "{SCHEMA}"')
    if "pictures" not in top and "objects" not in top:
        raise _wrong('the corrections have neither "objects" nor "pictures"')
    if "pictures" in top:
        pictures = _mapping(top["pictures"], '"pictures"')
        key = entry_for(pictures, name)
        return None if key is None else Corrections(_objects(_mapping(pictures[key], f"the entry for {name}")))
    return Corrections(_objects(top))


def lift_options(corrections: Corrections | None, index: int, base: LiftOptions) -> LiftOptions:
    """The lift options for the object at this place: `base`, with what the corrections say of it put in its place."""
    if corrections is None or index >= len(corrections.objects):
        return base
    return corrections.objects[index].options(base)


def corrected(picture: Picture, corrections: Corrections, options: LiftOptions | None = None) -> Answer:
    """The result made of the faces given by hand alone, lifted; the picture is not looked at.

    Raises UsageError if an object lacks its faces (`corrections.complete` tells), or cannot be lifted.
    """
    from sketch2shape.lifting import LiftOptions, lift

    base = options or LiftOptions()
    shapes = [o.shape for o in corrections.objects]
    if not corrections.complete:
        raise _wrong("an object in the corrections has no faces")
    objects = cast("tuple[TwoFaceObject, ...]", tuple(shapes))
    solids = tuple(
        lift(shape, picture_size=picture.size, options=lift_options(corrections, k, base))
        for k, shape in enumerate(objects)
    )
    return Answer(objects, solids, picture)


def entry_for(pictures: Iterable[str], name: str) -> str | None:
    """Of the names of pictures the one that means `name`: itself or, failing that, the longest that it ends with."""
    names = list(pictures)
    if name in names:
        return name
    parts = PurePosixPath(name.replace("\\", "/")).parts
    alike = [k for k in names if parts and parts[-len(PurePosixPath(k).parts) :] == PurePosixPath(k).parts]
    return max(alike, key=len) if alike else None


def _objects(picture: Mapping[str, Any]) -> tuple[ObjectCorrection, ...]:
    listed = _sequence(picture.get("objects", []), '"objects"')
    if len(listed) > _MOST_OBJECTS:
        raise _wrong(f"{len(listed)} objects are more than {_MOST_OBJECTS}")
    return tuple(_object(entry, f"object {k + 1}") for k, entry in enumerate(listed))


def _object(data: Any, where: str) -> ObjectCorrection:
    entry = _mapping(data, where)
    unknown = sorted(set(entry) - _OBJECT_KEYS - _FINDINGS)
    if unknown:
        raise _wrong(f"{where} has the unknown entry {unknown[0]!r}")
    shape = None
    if "f1" in entry:
        points = points_from(entry["vertices"], f"{where}, vertices") if "vertices" in entry else None
        shape = _faces(entry, points, where)
    projection = _projection(entry.get("projection", "auto"), where)
    return ObjectCorrection(shape, projection, _sizes(entry, where), _reading(entry.get("reading"), where))


def _faces(entry: Mapping[str, Any], points: Floats | None, where: str) -> TwoFaceObject:
    """The object whose faces an entry gives."""
    outer = _pair(entry, points, where, pointed=True)
    listed = _sequence(entry.get("holes", []), f"{where}, holes")
    shift = outer.f2[0] - outer.f1[0] if len(outer.f1) and len(outer.f2) else None
    holes = tuple(_pair(_mapping(h, f"{where}, hole"), points, f"{where}, hole", shift) for h in listed)
    if holes and len(outer.f2) == 1:
        raise _wrong(f"{where} comes to a point: it cannot have holes")
    arcs = arcs_from(entry.get("arcs", []), [outer, *holes], points_from, where)
    wrong = needs_vertices([outer, *holes], arcs)
    if wrong:
        raise _wrong(f"{where}: {wrong[0]}; a face needs 3 vertices, or arcs")
    manner = manner_from(entry, sum(len(ring.f2) for ring in (outer, *holes)), where)
    shape = TwoFaceObject(outer.f1, outer.f2, holes, connectors=("hand", "hand"), arcs=arcs, **manner)
    _check_faces(shape, where)
    return shape


def _pair(
    entry: Mapping[str, Any],
    points: Floats | None,
    where: str,
    shift: Floats | None = None,
    *,
    pointed: bool = False,
) -> FacePair:
    """The two rings of an object or a hole; one that is not given is the other one shifted; pointed: may f2 be one?"""
    f1 = _ring(entry.get("f1"), points, f"{where}, f1")
    if "f2" in entry:
        f2 = _ring(entry["f2"], points, f"{where}, f2")
    elif "d" in entry:
        f2 = f1 + points_from([entry["d"]], f"{where}, d")[0]
    elif shift is not None:
        f2 = f1 + shift
    else:
        raise _wrong(f'{where} has "f1" but neither "f2" nor "d"')
    if len(f1) != len(f2) and not (pointed and len(f2) == 1):
        raise _wrong(f"{where}: the front face has {len(f1)} vertices, the back face {len(f2)}")
    return FacePair(f1, f2)


def _ring(data: Any, points: Floats | None, where: str) -> Floats:
    if points is None:
        ring = points_from(data, where)
    else:
        indices = _sequence(data, where)
        if not all(type(i) is int and 0 <= i < len(points) for i in indices):
            raise _wrong(f"{where} must be numbers of vertices from 0 to {len(points) - 1}")
        ring = points[np.array(indices, np.intp)]
    if len(ring) > _MOST_VERTICES:
        raise _wrong(f"{where} has {len(ring)} vertices; a face has at most {_MOST_VERTICES}")
    return ring


def points_from(data: Any, where: str) -> Floats:
    """(n, 2) float points of a JSON list; `where` names it in the UsageError raised if it is something else."""
    rows = _sequence(data, where)
    if len(rows) > 2 * _MOST_VERTICES:
        raise _wrong(f"{where} has more than {2 * _MOST_VERTICES} points")
    for row in rows:
        pair = isinstance(row, list | tuple) and len(row) == 2 and all(type(c) in (int, float) for c in row)
        if not (pair and all(math.isfinite(c) and abs(c) <= _FARTHEST for c in row)):
            raise _wrong(f"{where} must be points [x, y] in pixels")
    return np.array(rows, float).reshape(-1, 2)


def _check_faces(shape: TwoFaceObject, where: str) -> None:
    """Refuse faces that are no polygons: crossing themselves, without area, or with holes outside."""
    from shapely import Polygon

    faces: list[tuple[Side, str]] = [("f1", "front"), ("f2", "back")]
    for side, name in faces[:1] if shape.is_pointed else faces:
        rings = shape.outlines(side)
        face = Polygon(rings[0], rings[1:])
        crossed = not Polygon(rings[0]).is_valid
        if crossed or not face.is_valid:
            what = "the outline crosses itself" if crossed else "a hole is not inside it"
            raise _wrong(f"{where}: the {name} face is not a polygon, {what}", _UNTANGLE)
        if face.area < 1e-6:
            raise _wrong(f"{where}: the {name} face has no area", _UNTANGLE)
    if not shape.is_round and not shape.is_pointed and np.allclose(shape.f1, shape.f2, atol=1e-6):
        raise _wrong(f"{where}: front and back face lie on each other", _UNTANGLE)


def _projection(data: Any, where: str) -> Literal["auto", "oblique", "axonometric", "perspective"]:
    family = data.get("family") if isinstance(data, Mapping) else data
    if family not in _FAMILIES:
        raise _wrong(f"{where}: the projection must be one of {', '.join(_FAMILIES)}")
    return cast(Literal["auto", "oblique", "axonometric", "perspective"], family)


def _reading(data: Any, where: str) -> int | None:
    if data is not None and not (type(data) is int and 1 <= data <= _MOST_READINGS):
        raise _wrong(f"{where}: the reading must be a number from 1 to {_MOST_READINGS}")
    return data


def _sizes(entry: Mapping[str, Any], where: str) -> dict[str, str | float]:
    """The real sizes given, checked as the lift options check them."""
    from sketch2shape.lifting import LiftOptions

    sizes = {k: entry[k] for k in _SIZES if entry.get(k) is not None}
    for name, value in sizes.items():
        if type(value) not in (str, int, float) or len(str(value)) > 40:
            raise _wrong(f"{where}: {name} must be a length such as 40mm")
    LiftOptions(**sizes)
    return sizes


def _mapping(data: Any, where: str) -> Mapping[str, Any]:
    if not isinstance(data, Mapping):
        raise _wrong(f"{where} must be a JSON object")
    return data


def _sequence(data: Any, where: str) -> Sequence[Any]:
    if not isinstance(data, list | tuple):
        raise _wrong(f"{where} must be a list")
    return data


def _wrong(message: str, remedy: str = "the form of the corrections file in docs/ui.md") -> UsageError:
    return UsageError(message, remedy=remedy)
