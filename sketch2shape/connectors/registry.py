"""The list of connectors: one entry a method, loaded when it is first used."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from importlib import import_module
from typing import Any

from sketch2shape.connectors.connection import Walk
from sketch2shape.errors import UsageError


@dataclass(frozen=True)
class Method:
    """One way to connect points.

    name       : as given to `connect`
    location   : "module:function" within this package; the function takes (n, 2) points and keyword parameters
    rule       : what it does, in a line
    complexity : time for n points
    limit      : most points it takes, or None if it is linear
    """

    name: str
    location: str
    rule: str
    complexity: str
    limit: int | None

    @property
    def function(self) -> Callable[..., Walk]:
        """The implementation."""
        module, name = self.location.split(":")
        loaded: Callable[..., Walk] = getattr(import_module(f"sketch2shape.connectors.{module}"), name)
        return loaded

    @property
    def parameters(self) -> Mapping[str, Any]:
        """Parameter names and their defaults."""
        taken = list(inspect.signature(self.function).parameters.values())[1:]
        return {p.name: p.default for p in taken}

    def check(self, given: Mapping[str, Any]) -> None:
        """Raise UsageError for parameters the method does not take."""
        unknown = sorted(set(given) - set(self.parameters)) if given else []
        if unknown:
            takes = ", ".join(self.parameters) or "no parameters"
            raise UsageError(f"method {self.name!r} expected {takes}, got {', '.join(unknown)}")


_ENTRIES = (
    Method("auto", "auto:auto", "the most regular simple ring, from a model of how faces look", "O(n^3) a round", 400),
    Method("split-walk", "split_walk:split_walk", "split at the centroid, walk each half (the paper)", "O(n)", None),
    Method("graham", "graham:graham", "convex hull by angular sort", "O(n log n)", 2_000_000),
    Method("jarvis", "jarvis:jarvis", "convex hull by gift wrapping", "O(n h)", 200_000),
    Method("park-oh", "park_oh:park_oh", "dig from the hull's edges, ratio N", "O(n h)", 5_000),
    Method("park-oh-all", "park_oh:park_oh_all", "park-oh, then insert the points left out", "O(n^3)", 1_000),
    Method("concave-hull", "concave_hull:concave_hull", "the package concave-hull", "O(n log n)", 2_000_000),
    Method("galton-duckham", "galton_duckham:galton_duckham", "swinging arm of length r", "O(n h)", 2_000),
    Method("moreira-santos", "moreira_santos:moreira_santos", "right-most of the k nearest", "O(n h k)", 2_000),
    Method("chi-shape", "chi_shape:chi_shape", "Delaunay less long border edges", "O(n log n)", 200_000),
    Method("chi-shape-shapely", "chi_shape:chi_shape_shapely", "shapely.concave_hull", "O(n log n)", 1_000_000),
    Method("alpha-shape", "alpha_shape:alpha_shape", "border of small Delaunay triangles", "O(n log n)", 5_000),
    Method("a-shape", "a_shape:a_shape", "Delaunay edges beside marker points; the crust", "O(n log n)", 200_000),
    Method("ec-shape", "ec_shape:ec_shape", "Delaunay less triangles with empty-circle tests", "O(n log n)", 200_000),
    Method("orthogonal", "orthogonal:orthogonal", "pair the points along two directions", "O(n^2 log n)", 2_000),
    Method("angular", "angular:angular", "sort by angle about the mean", "O(n log n)", 2_000_000),
    Method("tour", "tour:tour", "short tour: insertion, 2-opt, or-opt", "O(n^2) a round", 400),
)
_BY_NAME = {entry.name: entry for entry in _ENTRIES}


def methods() -> tuple[str, ...]:
    """Names of all methods, "auto" first."""
    return tuple(_BY_NAME)


def find_method(name: str) -> Method:
    """The entry of that name. Raises UsageError with the nearest names otherwise."""
    if isinstance(name, str) and name in _BY_NAME:
        return _BY_NAME[name]
    near = get_close_matches(str(name), _BY_NAME, n=1)
    hint = f" (did you mean {near[0]!r}?)" if near else ""
    raise UsageError(f"expected method to be one of {', '.join(_BY_NAME)}, got {name!r}{hint}")
