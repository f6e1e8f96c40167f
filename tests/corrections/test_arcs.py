"""Arcs in a corrections file are read in the report's words, and a report can be given back."""

import json

import numpy as np
import pytest

from sketch2shape.corrections.corrections import SCHEMA, corrected, corrections_from
from sketch2shape.errors import UsageError
from sketch2shape.lifting import lift
from sketch2shape.model import Answer, Picture
from sketch2shape.pipeline.report import report
from sketch2shape.solids import shape_name
from tests.lifting.round_views import CIRCLE, HALF, HOLE, ROUNDED, SLOT, SQUARE, STANDING, Drawer, axonometric

PICTURE = Picture(np.full((480, 640, 3), 255, np.uint8), "round.png")
CASES = {
    "cylinder": ([CIRCLE], 1.5, 1.0),
    "half": ([HALF], 1.5, 1.0),
    "rounded": ([ROUNDED], 1.5, 1.0),
    "slot with a hole": ([SLOT, HOLE], 0.5, 1.0),
    "plate": ([SQUARE, HOLE], 0.5, 1.0),
    "cone": ([CIRCLE], -1.5, 0.0),
    "pyramid": ([SQUARE], -1.5, 0.0),
}


def told(name):
    rings, depth, scale = CASES[name]
    obj = Drawer(axonometric(), STANDING).draw(rings, depth, scale)
    solid = lift(obj)
    return obj, solid, json.loads(json.dumps(report(Answer((obj,), (solid,), PICTURE))))


@pytest.mark.parametrize("name", CASES)
def test_a_report_given_back_gives_the_same_solid(name):
    obj, solid, data = told(name)
    again = corrected(PICTURE, corrections_from(data))
    assert [(a.face, a.hole, a.start, a.end) for a in again.objects[0].arcs] == [
        (a.face, a.hole, a.start, a.end) for a in obj.arcs
    ]
    assert shape_name(again.solids[0]) == shape_name(solid)
    assert again.solids[0].dimensions == pytest.approx(solid.dimensions, rel=5e-3)


def test_arcs_of_the_back_face_may_be_left_out():
    _, solid, data = told("rounded")
    entry = data["objects"][0]
    entry["arcs"] = [{k: a[k] for k in ("face", "hole", "from", "to", "points")} for a in entry["arcs"]][:4]
    again = corrected(PICTURE, corrections_from(data))
    assert len(again.objects[0].arcs) == 8
    assert again.solids[0].dimensions == pytest.approx(solid.dimensions, rel=5e-3)


def test_an_arc_follows_vertices_that_were_moved():
    _, _, data = told("half")
    entry = data["objects"][0]
    for face in ("f1", "f2"):
        entry[face] = [[2 * x, 2 * y] for x, y in entry[face]]
    shape = corrections_from(data).objects[0].shape
    arc = shape.arcs[0]
    assert arc.points[0] == pytest.approx(shape.f1[0])
    assert arc.points[-1] == pytest.approx(shape.f1[1])
    assert len(arc.points) >= 9


def wrong(change):
    _, _, data = told("slot with a hole")
    entry = data["objects"][0]
    change(entry)
    with pytest.raises(UsageError) as caught:
        corrections_from({"schema": SCHEMA, "objects": [entry]})
    return caught.value.message


def test_what_is_no_arc_is_refused_in_words():
    assert "no edge runs" in wrong(lambda e: e["arcs"][0].update({"from": 0, "to": 2}))
    assert "of no ring" in wrong(lambda e: e["arcs"][0].update({"hole": 5}))
    assert "of no ring" in wrong(lambda e: e["arcs"][0].update({"face": "f3"}))
    assert "two arcs" in wrong(lambda e: e["arcs"].append(e["arcs"][0]))
    assert "points" in wrong(lambda e: e["arcs"][0].update({"points": [[0, 0]]}))
    assert "must be a list" in wrong(lambda e: e.update({"arcs": {}}))
    assert "0 vertices and 0 arcs" in wrong(lambda e: e.update({"arcs": e["arcs"][:4]}))
    assert "lacks its whole ellipse" in wrong(lambda e: e.update({"arcs": e["arcs"][:-1]}))


def test_a_point_has_no_holes():
    _, _, data = told("plate")
    entry = data["objects"][0]
    entry["f2"] = entry["f2"][:1]
    with pytest.raises(UsageError, match="cannot have holes"):
        corrections_from({"schema": SCHEMA, "objects": [entry]})
