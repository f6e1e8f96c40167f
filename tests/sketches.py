"""Small drawings for the tests of seeing: outlines a reader can picture, drawn with anti-aliased lines."""

import io

import cv2
import numpy as np

from sketch2shape.evidence.sheet import skeleton_sheet
from sketch2shape.ink.find import find_ink
from sketch2shape.model.drawing import ring_edges
from sketch2shape.model.picture import Picture
from sketch2shape.strokes.skeleton import thin

SQUARE = np.array([[120.0, 140], [270, 140], [270, 290], [120, 290]])
L_SHAPE = np.array([[90.0, 120], [210, 120], [210, 190], [150, 190], [150, 300], [90, 300]])
HEXAGON = np.array([200.0, 200]) + 90 * np.array([[np.cos(t), np.sin(t)] for t in np.arange(6) * np.pi / 3 + 0.2])
DEPTH = np.array([90.0, -60])


def ink_of(picture):
    return find_ink(Picture(cv2.cvtColor(picture, cv2.COLOR_GRAY2RGB)))


def sheet_of(picture, reach=2.5):
    """What hypotheses are compared with: the thinned ink, every pixel of it alike."""
    skeleton = thin(ink_of(picture))
    return skeleton_sheet(skeleton, np.ones(len(skeleton.points)), reach)


def paper(height=400, width=480):
    return np.full((height, width), 255, np.uint8)


def line(picture, a, b, width=2, dashed=False):
    """A straight line in the given picture, to a sixteenth of a pixel."""
    a, b = np.asarray(a, float), np.asarray(b, float)
    length = float(np.linalg.norm(b - a))
    starts = np.arange(0, length, 18.0) if dashed else np.array([0.0])
    for s in starts:
        ends = a + (b - a) * np.array([[s], [min(s + 9.0, length) if dashed else length]]) / length
        p, q = (tuple(int(v) for v in np.rint(e * 16)) for e in ends)
        cv2.line(picture, p, q, 0, width, cv2.LINE_AA, 4)
    return picture


def outline(ring, width=2, picture=None):
    """A closed polygon."""
    picture = paper() if picture is None else picture
    for k in range(len(ring)):
        line(picture, ring[k - 1], ring[k], width)
    return picture


def prism(f1, f2, lines="wire", width=2, picture=None):
    """A drawing of the object with these faces; a convex f1 unless all edges are drawn alike."""
    picture = paper() if picture is None else picture
    vertices = np.concatenate([f1, f2])
    for (i, j), hidden in zip(ring_edges([len(f1)]), hidden_edges(f1, f2), strict=True):
        if lines == "wire" or not hidden:
            line(picture, vertices[i], vertices[j], width)
        elif lines == "dashed":
            line(picture, vertices[i], vertices[j], width, dashed=True)
    return picture


def hidden_edges(f1, f2):
    """(3n,) bool for a convex f1 in front: an edge is seen if one of its faces looks towards the viewer.

    A side does if its ring, followed as the surface has it, turns the same way as that of f1.
    """
    n = len(f1)
    side = [signed_area([f1[(i + 1) % n], f1[i], f2[i], f2[(i + 1) % n]]) * signed_area(f1) > 0 for i in range(n)]
    return np.array([False] * n + [not s for s in side] + [not (side[i] or side[i - 1]) for i in range(n)])


def signed_area(ring):
    x, y = np.asarray(ring, float).T
    return 0.5 * float(x @ np.roll(y, -1) - y @ np.roll(x, -1))


def shrunk(ring, by, towards):
    """The ring drawn towards a point: the back of a frustum, or of a box in one-point perspective."""
    return towards + by * (ring - towards)


def same_object(obj, f1, f2, within=2.0):
    """Whether the object found is the one drawn: the same vertices, joined by the same edges, whatever their order."""
    found, truth = obj.vertices, np.concatenate([f1, f2])
    if len(found) != len(truth):
        return False
    gap = np.linalg.norm(found[:, None] - truth[None], axis=2)
    edges = {frozenset(e) for e in ring_edges([len(f1)]).tolist()}
    return any({frozenset((m[i], m[j])) for i, j in obj.edges.tolist()} == edges for m in _matchings(gap <= within))


def _matchings(near):
    """Every way to match found vertices to true ones nearby; there is one unless vertices coincide."""
    ways = [()]
    for row in near:
        ways = [(*way, j) for way in ways for j in np.flatnonzero(row).tolist() if j not in way]
    return ways


def encoded(image, kind, **options):
    """A picture of PIL as the bytes of a file."""
    out = io.BytesIO()
    image.save(out, kind, **options)
    return out.getvalue()
