"""What a connector answers."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from sketch2shape.model import Floats, Ints


@dataclass(frozen=True)
class Walk:
    """What one method found, before it is judged.

    order        : (m,) indices of the points in ring order; m < n where the method leaves points out
    met, violated: the method's own preconditions and promises, in words
    rings        : all closed walks, for methods that may give several polygons
    edges        : (k, 2) indices, for methods that give a graph rather than a ring
    sureness     : 0..1 probability that the order is right, for methods that can tell
    alternatives : other orders that are as good, or nearly so
    parameters   : values that were used, defaults included
    """

    order: Ints
    met: tuple[str, ...] = ()
    violated: tuple[str, ...] = ()
    rings: tuple[Ints, ...] = ()
    edges: Ints | None = None
    sureness: float | None = None
    alternatives: tuple[Ints, ...] = ()
    parameters: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class Connection:
    """The polygon through some points, and how far it can be trusted.

    points       : (n, 2) float, as given
    order        : (m,) int, the points in ring order; a method that leaves points out has m < n
    method       : name of the method
    complete     : every point is on the ring exactly once
    simple       : the ring neither crosses nor touches itself
    met, violated: preconditions and promises that hold, or do not, in words
    sureness     : 0..1 probability that the order is right; None for methods that cannot tell
    alternatives : other orders that are as good, or nearly so, best first; () if there is no rival
    rings, edges : all closed walks, or the graph, for methods that give more than one ring
    parameters   : values that were used, defaults included
    """

    points: Floats
    order: Ints
    method: str
    complete: bool
    simple: bool
    met: tuple[str, ...] = ()
    violated: tuple[str, ...] = ()
    sureness: float | None = None
    alternatives: tuple[Ints, ...] = ()
    rings: tuple[Ints, ...] = ()
    edges: Ints | None = None
    parameters: Mapping[str, Any] = field(default_factory=dict)

    @property
    def ring(self) -> Floats:
        """(m, 2) the points in ring order."""
        return self.points[self.order]

    @property
    def tied(self) -> bool:
        """Another order is as good, or nearly so."""
        return len(self.alternatives) > 0
