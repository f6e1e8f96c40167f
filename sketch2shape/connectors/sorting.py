"""Points sorted by x, equal x by y, handed out in pieces that fit the processor's caches.

Strategy: pack x, y and the index into one unsigned 64-bit number and sort those, which compares in registers and is
linear in practice; nothing is gathered, as the sorted numbers hold the coordinates. Coordinates that are not whole
numbers, or too wide, are first mapped to as many integer levels as fit; only the few that share a level are then
sorted exactly. All else is done on pieces of some ten thousand points: arrays as long as the input would cost more for
their memory, which the system clears page by page, than for what is computed.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from sketch2shape.model import Floats, Ints

Keys = NDArray[np.uint64]
#: points of a piece, at least; a column (a run of equal x) is never cut
PIECE = 2**15
#: fewer points than this are sorted as they are
_FEW = 256


def sorted_pieces(x: Floats, y: Floats) -> Iterator[tuple[Ints, Floats, Floats]]:
    """(indices, x, y) of one piece of the points (n,), (n,) after the other; no two pieces share an x."""
    n = len(x)
    if n < _FEW:
        order = np.lexsort((y, x))
        yield order, x[order], y[order]
        return
    bits, low, y_low = int(n - 1).bit_length(), float(x.min()), float(y.min())
    span, tall = float(x.max()) - low, int(float(y.max()) - y_low).bit_length()
    if int(span).bit_length() + tall + bits <= 64 and low.is_integer() and y_low.is_integer():
        keys = _packed(x, y, low, y_low, tall, bits)
        if keys is not None:
            yield from _unpacked(keys, low, y_low, tall, bits)
            return
    yield from _levelled(x, y, low, float(2 ** min(64 - bits, 52) - 1) / span, bits)


def _packed(x: Floats, y: Floats, low: float, y_low: float, tall: int, bits: int) -> Keys | None:
    """Sorted numbers of x, y and index, from the highest bit down; None if a coordinate is not whole."""
    keys = np.empty(len(x), dtype=np.uint64)
    for start in range(0, len(x), PIECE):
        piece = slice(start, start + PIECE)
        across, up = (x[piece] - low).astype(np.uint64), (y[piece] - y_low).astype(np.uint64)
        if not ((across + low == x[piece]).all() and (up + y_low == y[piece]).all()):
            return None
        across <<= np.uint64(tall)
        across |= up
        keys[piece] = across
    return _sorted_with_index(keys, bits)


def _unpacked(keys: Keys, low: float, y_low: float, tall: int, bits: int) -> Iterator[tuple[Ints, Floats, Floats]]:
    for piece in _pieces(keys, tall + bits):
        part = keys[piece]
        members = (part & _ones(bits)).astype(np.intp)
        part >>= np.uint64(bits)
        up = (part & _ones(tall)).astype(np.float64)
        up += y_low
        part >>= np.uint64(tall)
        across = part.astype(np.float64)
        across += low
        yield members, across, up


def _levelled(x: Floats, y: Floats, low: float, scale: float, bits: int) -> Iterator[tuple[Ints, Floats, Floats]]:
    keys = np.empty(len(x), dtype=np.uint64)
    for start in range(0, len(x), PIECE):
        piece = slice(start, start + PIECE)
        keys[piece] = ((x[piece] - low) * scale).astype(np.uint64)
    keys = _sorted_with_index(keys, bits)
    for piece in _pieces(keys, bits):
        part = keys[piece]
        members = _settle_ties((part & _ones(bits)).astype(np.intp), part >> np.uint64(bits), x, y)
        yield members, x[members], y[members]


def _sorted_with_index(keys: Keys, bits: int) -> Keys:
    """Sorted keys, each with its index in the lowest bits. Overwrites `keys`."""
    for start in range(0, len(keys), PIECE):
        part = keys[start : start + PIECE]
        part <<= np.uint64(bits)
        part |= np.arange(start, start + len(part), dtype=np.uint64)
    keys.sort()
    return keys


def _ones(bits: int) -> np.uint64:
    return np.uint64((1 << bits) - 1)


def _pieces(keys: Keys, shift: int) -> Iterator[slice]:
    """Slices of sorted keys; keys that agree above the lowest `shift` bits stay together."""
    start, n = 0, len(keys)
    while start < n:
        end = min(start + PIECE, n)
        following = ((int(keys[end - 1]) >> shift) + 1) << shift  # the least key of the next x
        end = int(np.searchsorted(keys, np.uint64(following))) if following < 2**64 else n
        yield slice(start, end)
        start = end


def _settle_ties(order: Ints, level: Keys, x: Floats, y: Floats) -> Ints:
    """Sort exactly within each run of points that share a level."""
    equal = level[1:] == level[:-1]
    tied = np.flatnonzero(np.r_[equal, False] | np.r_[False, equal])
    if len(tied):
        members = order[tied]
        order[tied] = members[np.lexsort((y[members], x[members]))]
    return order
