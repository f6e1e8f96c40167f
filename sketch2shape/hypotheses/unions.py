"""Unions: faces that lines cut into several regions, put together again.

A diagonal, a section, a hatching line or an arrow across a face splits what the ink encloses. A face is then a union of
neighbouring regions; the fewer vertices and the fewer dents such a union has, the likelier it is a face.
"""

from __future__ import annotations

from collections.abc import Iterator

import cv2
import numpy as np
from shapely import Polygon, area, convex_hull, intersects, unary_union
from shapely.geometry.base import BaseGeometry

from sketch2shape.hypotheses.regions import Region
from sketch2shape.model import Floats

MOST_REGIONS = 24
"""Regions that are put together, the largest."""
KEPT = 10
"""Unions of one size that grow on."""
MOST_PARTS = 6
"""Regions in a union."""
MOST_UNIONS = 400
"""Unions of one size that are looked at."""
DENT_PRICE = 10.0
"""Vertices that are as unlikely as a union which fills none of its convex hull."""
NOTCH = 3.0
"""Half the width of notches between the parts of a union, over the gap between regions."""
MOST_VERTICES = 16
"""Vertices of a union that could be a face."""


def united(regions: list[Region], pen: float, tolerance: float) -> Iterator[Region]:
    """Unions of two and more neighbouring regions, the plainest first.

    pen, tolerance : pixels, stroke width and how far a line may stray
    """
    gap = 0.5 * pen + tolerance
    some = regions[:MOST_REGIONS]
    shapes = [Polygon(r.outline).buffer(0).buffer(gap, join_style="mitre") for r in some]
    near = [[j for j, b in enumerate(shapes) if j != i and intersects(a, b)] for i, a in enumerate(shapes)]
    level = {frozenset([i]) for i in range(len(some))}
    seen = set(level)
    for _ in range(1, MOST_PARTS):
        grown = {members | {j} for members in level for i in members for j in near[i] if j not in members} - seen
        seen |= grown
        ranked = sorted(_ranked(grown, shapes, gap, tolerance), key=lambda r: r[0])[: 2 * KEPT]
        yield from (region for _, region, _ in ranked)
        level = {members for _, _, members in ranked[:KEPT]}


def _ranked(
    unions: set[frozenset[int]], shapes: list[BaseGeometry], gap: float, tolerance: float
) -> Iterator[tuple[tuple[float, float], Region, frozenset[int]]]:
    for members in sorted(unions, key=sorted)[:MOST_UNIONS]:
        whole = unary_union([shapes[i] for i in sorted(members)])
        # where a line met the outline it has cut off tips: notches between the parts
        whole = whole.buffer(NOTCH * gap, join_style="mitre").buffer(-(NOTCH + 1.0) * gap, join_style="mitre")
        if whole.geom_type != "Polygon" or whole.is_empty:
            continue
        outline = _simplified(np.array(whole.exterior.coords[:-1]), tolerance + 0.35 * gap)
        if 3 <= len(outline) <= MOST_VERTICES:
            dents = 1.0 - float(area(whole) / max(float(area(convex_hull(whole))), 1.0))
            yield (len(outline) + DENT_PRICE * dents, -float(area(whole))), Region(outline), members


def _simplified(outline: Floats, tolerance: float) -> Floats:
    return np.asarray(cv2.approxPolyDP(outline.astype(np.float32)[:, None], tolerance, True)[:, 0], float)
