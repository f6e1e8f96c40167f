"""Dimensioned drawings: every size is told once, at a scale that is said, and DXF is at full size."""

from __future__ import annotations

import io
from xml.etree import ElementTree

import numpy as np
import pytest
from export.upright import BOX, CURVED, HOUSE, NOTCH, L, facing

from sketch2shape.errors import UsageError
from sketch2shape.export import encode, note_of
from sketch2shape.export.views import views_document
from sketch2shape.sheets import Label, Round, Stroke

SOLIDS = {"box": facing([BOX]), "L": facing([L, NOTCH]), "pixels": facing([5 * HOUSE], unit="px"), **CURVED}


def texts(document, layer="dimensions"):
    return [i.text for sheet in document.sheets for i in sheet.items if isinstance(i, Label) and i.layer == layer]


def lines(document, layer="visible"):
    return [i.points for sheet in document.sheets for i in sheet.items if isinstance(i, Stroke) and i.layer == layer]


@pytest.mark.parametrize("paper", ["a4", "letter"])
@pytest.mark.parametrize("angle", ["third", "first"])
@pytest.mark.parametrize("solid", SOLIDS.values(), ids=SOLIDS)
def test_everything_lies_on_the_sheet(solid, paper, angle):
    document, _ = views_document([solid], paper, angle)
    for layer in ("visible", "hidden", "dimensions", "center"):
        for points in lines(document, layer):
            if layer == "center" and points[:, 1].min() > document.paper.height - 22:
                continue  # the sign of the angle
            assert points.min() > 10
            assert (points < [document.paper.width - 10, document.paper.height - 22]).all()


def test_sizes_and_steps_are_told_once():
    document, note = views_document([facing([L])])
    assert sorted(texts(document)) == sorted(["60", "15", "45", "40", "15", "25", "25"])
    assert note is None
    assert "Dimensions in mm. Scale 1:1" in texts(document, "text")


def test_round_things_are_told_by_diameter_and_radius():
    document, _ = views_document([CURVED["rounded plate"]])
    assert {"2 × Ø10", "4 × R8", "15", "30", "60", "40", "25"} <= set(texts(document))
    document, _ = views_document([CURVED["tube"]])
    assert sorted(texts(document)) == ["25", "40", "40", "Ø30", "Ø40"]


def test_third_and_first_angle_stand_on_opposite_sides():
    for angle, order in (("third", -1), ("first", 1)):
        document, _ = views_document([facing([L, NOTCH])], angle=angle)
        hole = next(p for p in lines(document, "hidden") if np.ptp(p[:, 0]) < 1e-3 and np.ptp(p[:, 1]) > 24)
        whole = np.concatenate(lines(document))
        middle = (whole[:, 1].min() + whole[:, 1].max()) / 2
        assert (hole[:, 1].mean() - middle) * order > 0  # upright hidden lines are the top view's alone
        rings = [i for sheet in document.sheets for i in sheet.items if isinstance(i, Round)]
        cone = next(p for p in lines(document, "text") if len(p) == 4 and np.ptp(p[:, 0]) < 10)
        assert (rings[0].center[0] - cone[:, 0].mean()) * order > 0
    assert "first-angle projection" in texts(views_document([facing([L])], angle="first")[0], "text")


def test_usual_scales_and_what_is_said_without_a_real_size():
    large, note = views_document([facing([10 * BOX], depth=250)])
    assert "scale 1:10" in large.title
    assert note is None
    small, _ = views_document([facing([BOX / 20], depth=1)])
    assert "scale 20:1" in small.title
    pixels = facing([HOUSE], unit="px")
    assert "no real size is known" in note_of(pixels, "views.svg")
    assert any("pixels of the drawing" in text for text in texts(views_document([pixels])[0], "text"))


def test_dxf_is_at_full_size_in_the_solids_unit():
    ezdxf = pytest.importorskip("ezdxf", reason="ezdxf reads DXF back (extra `readback`)")
    for solid, units in ((facing([10 * BOX], depth=250), 4), (facing([BOX], unit="cm"), 5)):
        drawing = ezdxf.read(io.StringIO(encode(solid, "views.dxf").decode()))
        assert drawing.units == units
        assert not drawing.audit().errors
        outlines = drawing.modelspace().query('POLYLINE[layer=="VISIBLE"]')
        found = [np.array([tuple(v.dxf.location)[:2] for v in line.vertices]) for line in outlines]
        sizes = {round(float(s), 3) for points in found for s in np.ptp(points, axis=0)}
        assert {round(float(s), 3) for s in solid.dimensions} <= sizes


def test_svg_has_its_layers():
    root = ElementTree.fromstring(encode(facing([L]), "views.svg"))
    groups = [g.get("id") for g in root.iter("{http://www.w3.org/2000/svg}g")]
    assert groups == ["visible", "hidden", "center", "dimensions", "text"]
    assert root.get("width") == "297mm"


def test_several_solids_have_a_sheet_each():
    assert len(views_document([facing([L]), CURVED["cone"]])[0].sheets) == 2


def test_an_angle_that_there_is_not_is_refused():
    with pytest.raises(UsageError, match="second"):
        encode(facing([BOX]), "views.pdf", angle="second")
