"""Rings: the outlines of the two faces of a hypothesis, alone and in stacks.

A search tries hundreds of hypotheses, most of them with rings of the same sizes: a stack holds those in one array, so
that they are checked and judged together.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from sketch2shape.geometry import are_simple
from sketch2shape.model import Bools, Floats, Ints, ring_edges

SHORTEST_RUNG = 0.1
"""Least length of a connecting edge, as a part of the longest: shorter ones make a side of a pyramid's corner."""
SMALLEST_FACE = 0.03
"""Least area of the smaller face, as a part of the larger one."""


class Rings(NamedTuple):
    """Corresponding rings of a hypothesis: front[k][i] joins back[k][i]; the outer ring first."""

    front: tuple[Floats, ...]
    back: tuple[Floats, ...]

    @property
    def vertices(self) -> Floats:
        """(2m, 2) float."""
        return np.concatenate([*self.front, *self.back])

    @property
    def sizes(self) -> tuple[int, ...]:
        """Number of vertices of each ring of one face."""
        return tuple(len(r) for r in self.front)

    @property
    def segments(self) -> tuple[Floats, Floats]:
        """(e, 2) float, pixels: where each edge begins, and (e, 2) the way to its end."""
        ends = self.vertices[frame(self.sizes).edges]
        return ends[:, 0], ends[:, 1] - ends[:, 0]

    def swapped(self) -> Rings:
        """Front and back exchanged."""
        return Rings(self.back, self.front)

    def shifted(self, by: Floats) -> Rings:
        """Moved by a vector (2,)."""
        return Rings(tuple(r + by for r in self.front), tuple(r + by for r in self.back))


def split(vertices: Floats, sizes: Iterable[int]) -> Rings:
    """Vertices (2m, 2) in the order of the contract back into rings."""
    sizes = tuple(sizes)
    if len(sizes) == 1:
        return Rings((vertices[: sizes[0]],), (vertices[sizes[0] :],))
    cuts = np.cumsum(sizes + sizes)[:-1]
    parts = np.split(vertices, cuts)
    return Rings(tuple(parts[: len(sizes)]), tuple(parts[len(sizes) :]))


def coincide(a: Floats, b: Floats, near: float) -> bool:
    """Whether each of the points (k, 2) and (m, 2) has one of the others within `near` pixels."""
    gap = np.linalg.norm(a[:, None] - b[None], axis=2)
    return bool(gap.min(axis=0).max() <= near and gap.min(axis=1).max() <= near)


def has_edges(other: Rings, rings: Rings, drawn: Bools, near: float) -> bool:
    """Whether another object has the drawn edges of one, and no more in all, whichever faces it calls its own.

    drawn : (m,) bool, back vertices of `rings` that are drawn
    near  : pixels by which either end of an edge may lie elsewhere
    """
    edges = frame(rings.sizes).edges
    mine, theirs = rings.vertices[edges], other.vertices[frame(other.sizes).edges]
    if len(mine) != len(theirs):
        return False
    mine = mine[np.append(np.ones_like(drawn), drawn)[edges].all(axis=1)]
    ways = (np.abs(mine[:, None] - way).max(axis=(2, 3)) for way in (theirs, theirs[:, ::-1]))
    return bool(np.minimum(*ways).min(axis=1).max() <= near)


@dataclass(frozen=True)
class Frame:
    """What connects the vertices of rings of certain sizes, m vertices to a face.

    edges  : (3m, 2) int, front, back and connecting edges of each ring in turn
    after  : (m,) int, the next vertex of the same ring
    before : (m,) int, the one before
    fronts : (m,) int, the edges of the front, in the order of the vertices they start from
    backs  : (m,) int, the edges of the back, in the same order
    rungs  : (m,) int, the connecting edges, in the order of the vertices they start from
    spans  : start and end of each ring
    """

    edges: Ints
    after: Ints
    before: Ints
    fronts: Ints
    backs: Ints
    rungs: Ints
    spans: tuple[tuple[int, int], ...]


@lru_cache(maxsize=256)
def frame(sizes: tuple[int, ...]) -> Frame:
    """The frame of rings of these sizes."""
    starts = np.cumsum([0, *sizes]).tolist()
    spans = tuple(pairwise(starts))
    after = np.concatenate([np.r_[a + 1 : b, a] for a, b in spans])
    kind = np.concatenate([np.repeat([0, 1, 2], n) for n in sizes])
    fronts, backs, rungs = (np.flatnonzero(kind == k) for k in range(3))
    return Frame(ring_edges(list(sizes)), after, np.argsort(after), fronts, backs, rungs, spans)


@dataclass(frozen=True)
class Stack:
    """Hypotheses whose rings have the same sizes.

    vertices : (b, 2m, 2) float, each hypothesis in the order of the contract
    sizes    : of the rings of one face, sum m
    """

    vertices: Floats
    sizes: tuple[int, ...]

    @property
    def frame(self) -> Frame:
        """What connects the vertices."""
        return frame(self.sizes)

    @property
    def faces(self) -> Floats:
        """(b, 2, m, 2) float, the vertices of both faces."""
        return self.vertices.reshape(len(self.vertices), 2, -1, 2)

    def __len__(self) -> int:
        """How many hypotheses."""
        return len(self.vertices)

    def some(self, index: Ints) -> Stack:
        """A part of the stack."""
        return Stack(self.vertices[index], self.sizes)


def stack(rings: list[Rings]) -> Stack:
    """Hypotheses with rings of the same sizes as one stack."""
    return Stack(np.array([r.vertices for r in rings]), rings[0].sizes)


def plausible(rings: Rings, least: float) -> bool:
    """Whether the rings could be the faces of an object (see `which_plausible`)."""
    return bool(which_plausible(stack([rings]), least).all())


def which_plausible(stacked: Stack, least: float) -> Bools:
    """(b,) bool: rings that could be the faces of an object, simple, alike in size, no edge shorter than least pixels.

    A back face shrunk to almost nothing turns the object into a pyramid, which is none.
    """
    v = stacked.vertices
    ok: Bools = np.asarray(np.isfinite(v).all(axis=(1, 2)))
    ok &= np.abs(np.where(ok[:, None, None], v, 0.0)).max(axis=(1, 2)) <= 1e5
    v = np.where(ok[:, None, None], v, 0.0)
    faces = v.reshape(len(v), 2, -1, 2)
    edge = faces[:, :, stacked.frame.after] - faces
    ok &= np.einsum("...k,...k", edge, edge).min(axis=(1, 2)) >= least * least
    rung = faces[:, 1] - faces[:, 0]
    length = np.sqrt(np.einsum("...k,...k", rung, rung))
    with np.errstate(divide="ignore", invalid="ignore"):
        for a, b in stacked.frame.spans:
            own = length[:, a:b]
            ok &= own.min(axis=1) >= np.maximum(least, SHORTEST_RUNG * own.max(axis=1))
            x, y = faces[:, :, a:b, 0], faces[:, :, a:b, 1]
            dx, dy = edge[:, :, a:b, 0], edge[:, :, a:b, 1]
            area = (x * dy - y * dx).sum(axis=2)
            ratio = area[:, 1] / area[:, 0]
            ok &= (ratio >= SMALLEST_FACE) & (ratio <= 1 / SMALLEST_FACE)
            if ok.any():
                ok &= are_simple(faces[:, :, a:b]).all(axis=1)
    return ok
