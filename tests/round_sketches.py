"""Small drawings of things that are round or pointed, and sweeps a reader can picture."""

import cv2
import numpy as np
from sketches import paper

from sketch2shape.sweeps import Circle, Frame, Outline, Sweep, Way
from sketch2shape.sweeps.outlines import polygon

UPRIGHT = Frame(np.array([0.0, 1.0]), 0.4)
"""Of circles that lie on the ground, seen from above."""
FACING = Frame(np.array([0.8, -0.6]), 1.0)
"""Of circles seen face on."""
DOWN = np.array([0.0, 150.0])


def ellipse(x=240.0, y=120.0, radius=90.0, frame=UPRIGHT):
    """A whole ellipse as a ring."""
    none = np.zeros(0)
    centre = frame.flat(np.array([x, y]))
    return Outline(frame, np.zeros((0, 2)), none, none.astype(bool), Circle(centre, radius))


def arch(frame=FACING):
    """A square with a half circle on top: four vertices, the upper two smooth."""
    vertices = np.array([[120.0, 180], [240, 180], [240, 300], [120, 300]])
    return Outline(frame, vertices, np.array([-1.0, 0, 0, 0]), np.array([True, True, False, False]))


def half_disc(frame=FACING):
    """A half circle on its diameter."""
    return Outline(frame, np.array([[120.0, 240], [300, 240]]), np.array([-1.0, 0.0]), np.zeros(2, bool))


def plate(way):
    """A plate with rounded corners and two round holes, face on."""
    r, k = 60.0, np.tan(np.pi / 8)
    x = np.array([60.0, 60 + r, 400 - r, 400])
    y = np.array([120.0, 120 + r, 340 - r, 340])
    places = [(1, 0), (2, 0), (3, 1), (3, 2), (2, 3), (1, 3), (0, 2), (0, 1)]
    vertices = np.array([[x[i], y[j]] for i, j in places])
    outer = Outline(FACING, vertices, np.array([0, k, 0, k, 0, k, 0, k]) * -1.0, np.ones(8, bool))
    return Sweep((outer, ellipse(140.0, 230.0, 35.0, FACING), ellipse(300.0, 230.0, 55.0, FACING)), way)


def slot(way, *, tangents=False):
    """A plate with round ends, face on."""
    vertices = np.array([[140.0, 150], [300, 150], [300, 290], [140, 290]])
    return Sweep((Outline(FACING, vertices, np.array([0, -1.0, 0, -1.0]), np.ones(4, bool)),), way, tangents=tangents)


CYLINDER = Sweep((ellipse(),), Way(DOWN))
TUBE = Sweep((ellipse(), ellipse(radius=50.0)), Way(DOWN))
ARCH = Sweep((arch(),), Way(np.array([90.0, -60])))
CONE = Sweep((ellipse(y=280.0),), Way(np.zeros(2), np.array([240.0, 90]), 0.0), is_near=False)
PYRAMID = Sweep(
    (polygon(np.array([[120.0, 280], [210, 320], [330, 290], [230, 250]])),),
    Way(np.zeros(2), np.array([225.0, 100]), 0.0),
    is_near=False,
)


def polyline(picture, points, width=2, dashed=False):
    """A line through points, dashed by its length."""
    if not dashed:
        at = [np.rint(points * 16).astype(np.int32)]
        cv2.polylines(picture, at, False, 0, width, cv2.LINE_AA, 4)
        return
    run = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])
    for start in np.arange(0, run[-1], 18.0):
        at = np.linspace(start, min(start + 9.0, run[-1]), 5)
        polyline(picture, np.stack([np.interp(at, run, points[:, 0]), np.interp(at, run, points[:, 1])], axis=1), width)


def drawn(sweep, lines="wire", width=2):
    """The picture of a sweep: rims, sides and silhouettes, hidden ones like the others, dashed or left out."""
    from sketch2shape.sweeps import redraw

    picture = paper()
    made = redraw(sweep, 1.0, 2.0)
    for edge in np.unique(made.edge):
        own = np.flatnonzero(made.edge == edge)
        for hidden in (False, True):
            if hidden and lines == "removed":
                continue
            mine = own[(made.depth[own] == 2) == hidden] if lines != "wire" else own
            if lines == "wire" and hidden:
                continue
            for run in np.split(mine, np.flatnonzero(np.diff(mine) != 1) + 1):
                if len(run):
                    step = 0.5 * made.length[run][:, None] * made.along[run]
                    at = np.concatenate([made.points[run] - step, (made.points[run] + step)[-1:]])
                    polyline(picture, at, width, dashed=hidden and lines == "dashed")
    return picture
