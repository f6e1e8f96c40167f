"""Lines and arcs that both faces of a wireframe show."""

import numpy as np
import pytest
from round_sketches import drawn, slot
from sketches import ink_of

from sketch2shape.strokes import thin
from sketch2shape.sweeps import Way
from sketch2shape.sweeps.rungs import off_both
from sketch2shape.sweeps.spans import Field, cells_of, spans_of, worth_of

SLOT = slot(Way(np.array([60.0, 40.0])), tangents=True)
ALONG = SLOT.way.shift / np.hypot(*SLOT.way.shift)


def field_with(nodes):
    skeleton = thin(ink_of(drawn(SLOT)))
    return Field(off_both(skeleton, SLOT.way.shift), nodes, 2.5, 300.0)


@pytest.fixture(scope="module")
def field():
    return field_with(SLOT.rings[0].vertices)


def edges(spans):
    return {(a, b, round(float(c))) for a, b, c in zip(spans.first, spans.second, spans.bulges, strict=True)}


def test_the_edges_of_a_slot_are_found_in_the_frame_of_its_circles(field):
    frame, spans = spans_of(field, ALONG)[0]
    assert frame.ratio == pytest.approx(1.0, abs=0.07)
    straight = {(i, j) for i, j, bulge in zip(spans.first, spans.second, spans.bulges, strict=True) if bulge == 0}
    assert straight == {(0, 1), (2, 3)}
    assert {(1, 2, -1), (0, 3, 1)} <= edges(spans)
    assert worth_of(spans, field).max() > 0.8


def test_nodes_that_are_a_little_off_have_them_too():
    moved = SLOT.rings[0].vertices + [[2.0, 1], [-1, 2], [1, -2], [-2, -1]]
    _, spans = spans_of(field_with(moved), ALONG)[0]
    assert {(0, 1, 0), (2, 3, 0), (1, 2, -1), (0, 3, 1)} <= edges(spans)


def test_a_line_that_one_face_lacks_is_none(field):
    elsewhere = field_with(SLOT.rings[0].vertices + [0.0, 25.0])
    assert all(not len(spans.first) for _, spans in spans_of(elsewhere, ALONG))


def test_what_runs_along_the_way_to_the_back_is_none(field):
    for _, spans in spans_of(field, np.array([1.0, 0.0])):
        assert not (spans.bulges == 0).any()


def test_cells_hold_all_of_a_span(field):
    _, spans = spans_of(field, ALONG)[0]
    cells = cells_of(spans, field)
    line = int(np.flatnonzero(spans.bulges == 0)[0])
    assert cells[line].sum() == pytest.approx(160 / 4, abs=3)
