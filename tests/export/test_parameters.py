"""Named dimensions: expressions give the numbers back, and names say what a person would."""

from __future__ import annotations

import numpy as np
import pytest
from export.upright import BOX, CURVED, HOUSE, NOTCH, STAR, WINDOW, L, facing
from hypothesis import given
from hypothesis import strategies as st

from sketch2shape.export.parameters import Rounding, design_of, plain_number
from sketch2shape.solids import extrusion_of


def values_of(design):
    return {p.name: float(p.value) for p in design.parameters}


def named(solid):
    return values_of(design_of(extrusion_of(solid)))


def test_a_plate_of_the_same_thickness_has_a_wall():
    assert named(facing([L])) == {"width": 60, "height": 40, "depth": 25, "wall": 15}
    assert named(facing([BOX, WINDOW])) == {"width": 60, "height": 40, "depth": 25, "wall": 5}


def test_other_levels_are_steps_and_holes_are_set_in():
    assert named(facing([HOUSE])) == {"width": 60, "height": 50, "depth": 25, "step": 20}
    found = named(facing([BOX, NOTCH]))
    assert {k: v for k, v in found.items() if k.startswith("inset")} == {"inset_1": 5, "inset_2": 10, "inset_3": 4}


def test_slanted_corners_are_parts_of_the_size():
    assert set(named(facing([STAR]))) == {"width", "height", "depth"}


def test_the_taper_is_told_from_the_larger_end():
    assert named(facing([BOX], scale=0.5))["taper"] == pytest.approx(0.5)
    assert named(facing([BOX], scale=2.0))["taper"] == pytest.approx(0.5)
    assert named(facing([BOX], scale=2.0))["width"] == 120


def test_names_of_several_objects_are_told_apart():
    design = design_of(extrusion_of(facing([L])), "_2")
    assert {p.name for p in design.parameters} == {"width_2", "height_2", "depth_2", "wall_2"}
    assert design.length == "depth_2"


@pytest.mark.parametrize(
    "solid", [facing([L, NOTCH]), facing([STAR]), facing([HOUSE], scale=0.4), facing([BOX]), *CURVED.values()]
)
def test_expressions_give_the_coordinates(solid):
    extrusion = extrusion_of(solid)
    design = design_of(extrusion)
    close = 2e-4 * extrusion.extents.max()

    def value(expressions):
        return [eval(x, {}, values_of(design)) for x in expressions]

    for path, outline in zip(design.outlines, extrusion.outlines, strict=True):
        if outline.circle is not None:
            (center, diameter), (middle, radius) = path.circle, outline.circle
            np.testing.assert_allclose([*value(center), *value([diameter])], [*middle, 2 * radius], atol=close)
            continue
        np.testing.assert_allclose(list(map(value, path.points)), outline.points, atol=close)
        for k, arc in enumerate(path.arcs):
            assert (arc is not None) == bool(outline.bulges[k])
            if arc is not None:
                at, told = outline.arc(k), value([*arc.center, arc.radius, arc.begin, arc.end])
                known = [*at.center, at.radius, np.degrees(at.begin), np.degrees(at.begin + at.sweep)]
                np.testing.assert_allclose(told, known, atol=close)
    np.testing.assert_allclose(value(design.origin), extrusion.origin, atol=close)


def test_round_things_are_told_by_diameter_and_radius():
    assert named(CURVED["cylinder"]) == {"diameter": 40, "height": 70}
    assert named(CURVED["tube"]) == {"diameter": 40, "height": 25, "hole_diameter": 30}
    assert named(CURVED["bucket"]) == {"diameter": 60, "height": 25, "taper": pytest.approx(2 / 3, abs=1e-6)}
    plate = named(CURVED["rounded plate"])
    assert plate == {"width": 60, "height": 40, "depth": 25, "radius": 8, "hole_diameter": 10, "inset": 15}
    assert set(named(CURVED["half cylinder"])) == {"width", "height", "depth"}
    assert set(named(CURVED["slot"])) == {"width", "height", "depth"}


@given(st.floats(1e-6, 1e9), st.floats(0, 1))
def test_numbers_keep_five_digits_of_the_largest(largest, part):
    number = Rounding(largest)
    assert abs(float(number(largest * part)) - largest * part) <= 0.51e-4 * largest
    assert "e" not in number(largest * part)


def test_numbers_are_short():
    assert [plain_number(x, 3) for x in (12.5, -3.0, 0.0004, -0.0004, 100.0)] == ["12.5", "-3", "0", "0", "100"]
