import re
import xml.etree.ElementTree as ET
from itertools import pairwise

import numpy as np
import pytest

from sketch2shape.errors import UsageError
from sketch2shape.export import encode, format_of
from sketch2shape.geometry import signed_area
from sketch2shape.lifting import LiftOptions, lift
from sketch2shape.model.drawing import FacePair, TwoFaceObject
from sketch2shape.model.picture import Picture
from sketch2shape.pipeline.result import Result
from sketch2shape.solids import drawn_lines
from tests.lifting.round_views import CIRCLE, STANDING, Drawer, axonometric
from tests.solids.round_bodies import ROUND

FACE = np.array([[100, 100], [300, 100], [300, 250], [100, 250.0]])
BOX = TwoFaceObject(FACE, FACE + [60, -50])
HOLE = np.array([[150, 150], [250, 150], [250, 200], [150, 200.0]])


def result(*objects, **options):
    solids = tuple(lift(o, options=LiftOptions(**options)) for o in objects)
    return Result(tuple(objects), solids, Picture(np.zeros((480, 640, 3), np.uint8)))


def hidden_length(obj, **options):
    lines = drawn_lines(obj, lift(obj, options=LiftOptions(**options)))
    return sum(np.linalg.norm(line.end - line.start) for line in lines if not line.visible)


@pytest.mark.parametrize("up", ["camera", "y", "z"])
def test_the_three_far_edges_of_a_box_are_hidden(up):
    lines = drawn_lines(BOX, lift(BOX, options=LiftOptions(up=up)))
    gone = {frozenset(BOX.edges[line.edge].tolist()) for line in lines if not line.visible}
    # the far lower left corner is vertex 7: its three edges are behind the box
    assert gone == {frozenset((6, 7)), frozenset((7, 4)), frozenset((3, 7))}


def test_mirrored_reading_hides_the_other_corner():
    lines = drawn_lines(BOX, lift(BOX, options=LiftOptions(necker=True)))
    gone = {frozenset(BOX.edges[line.edge].tolist()) for line in lines if not line.visible}
    assert gone == {frozenset((0, 1)), frozenset((1, 2)), frozenset((1, 5))}


def test_perspective_box_hides_three_edges():
    box = np.array([[x, y, z] for z in (0, 2) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))], float)
    a, e = 0.6, 0.4
    yaw = np.array([[np.cos(a), 0, np.sin(a)], [0, 1, 0], [-np.sin(a), 0, np.cos(a)]])
    pitch = np.array([[1, 0, 0], [0, np.cos(e), np.sin(e)], [0, -np.sin(e), np.cos(e)]])
    view = (box - [0, 0, 1]) @ yaw.T @ pitch.T + [0, 0, 6]
    flat = view[:, :2] / view[:, 2:] * 700 + 300
    obj = TwoFaceObject(flat[:4], flat[4:])
    lines = drawn_lines(obj, lift(obj))
    gone = {i for line in lines if not line.visible for i in [set(obj.edges[line.edge].tolist())][0]}
    far = int(view[:, 2].argmax())
    assert len({line.edge for line in lines if not line.visible}) == 3
    assert far in gone


def test_back_edge_of_a_hole_is_seen_in_part():
    shallow = TwoFaceObject(FACE, FACE + [30, -20], (FacePair(HOLE, HOLE + [30, -20]),))
    lines = [line for line in drawn_lines(shallow, lift(shallow)) if line.edge in range(12, 24)]
    # of the hole's back ring the left and the lower side show through, each without its last piece
    back = [line for line in lines if set(shallow.edges[line.edge].tolist()) == {14, 15}]
    assert [line.visible for line in sorted(back, key=lambda line: line.start[0])] == [True, False]
    assert sum(np.linalg.norm(line.end - line.start) for line in back) == pytest.approx(100.0)


def test_lines_cover_each_edge_once():
    lines = drawn_lines(BOX, lift(BOX))
    drawn = np.zeros(12)
    for line in lines:
        drawn[line.edge] += np.linalg.norm(line.end - line.start)
    ends = BOX.vertices[BOX.edges]
    assert drawn == pytest.approx(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1))


def test_svg_has_a_group_for_each_layer():
    root = ET.fromstring(encode(result(BOX), "svg"))
    groups = {g.get("class"): g for g in root.iter("{http://www.w3.org/2000/svg}g") if g.get("class")}
    paths = {name: g[0].get("d") for name, g in groups.items()}
    assert paths["visible"].count("M") == 9
    assert paths["hidden"].count("M") == 3
    assert (root.get("width"), root.get("height")) == ("640", "480")


def test_face_is_laid_flat_at_its_size():
    solids = result(TwoFaceObject(FACE, FACE + [60, -50], (FacePair(HOLE, HOLE + [60, -50]),)), width="40mm").solids
    root = ET.fromstring(encode(solids, "face.svg"))
    path = root[0].get("d")
    assert path.count("M") == path.count("Z") == 2
    rows = encode(solids, "face.dxf").decode().splitlines()
    x = [float(rows[i + 3 + 1]) for i, row in enumerate(rows) if row == "VERTEX"]
    assert max(x) == pytest.approx(40.0)


@pytest.mark.parametrize(("unit", "millimetres"), [("mm", 1.0), ("cm", 10.0), ("m", 1000.0), ("in", 25.4)])
@pytest.mark.parametrize("face", [FACE, FACE * [1, 0.08], FACE * [0.05, 1]])
def test_a_face_is_cut_at_full_size_in_every_unit(unit, millimetres, face):
    solids = result(TwoFaceObject(face, face + [60, -50]), width="40mm", unit=unit).solids
    root = ET.fromstring(encode(solids, "face.svg"))
    box = [float(v) for v in root.get("viewBox").split()]
    shown = {"mm": 1.0, "cm": 10.0, "in": 25.4}
    for size, extent in zip((root.get("width"), root.get("height")), box[2:], strict=True):
        suffix = size.lstrip("0123456789.e-+")
        # millimetres on paper for each unit of the path
        assert float(size[: -len(suffix)]) * shown[suffix] / extent == pytest.approx(millimetres, rel=1e-6)
    corners = np.array([[float(v) for v in pair.split()] for pair in root[0].get("d").strip("MZ").split("L")])
    stroke = float(root[0].get("stroke-width"))
    assert corners.min(axis=0) == pytest.approx([0, 0])
    assert (np.ptp(corners, axis=0) + stroke <= np.array(box[2:]) + 1e-9).all()
    assert np.ptp(corners[:, 0]) * millimetres == pytest.approx(40.0)


@pytest.mark.parametrize(("unit", "code"), [("px", 0), ("in", 1), ("mm", 4), ("cm", 5), ("m", 6)])
def test_a_dxf_file_names_its_unit(unit, code):
    options = {} if unit == "px" else {"width": "40mm", "unit": unit}
    rows = encode(result(BOX, **options), "face.dxf").decode().splitlines()
    assert rows[rows.index("$INSUNITS") + 1 : rows.index("$INSUNITS") + 3] == ["70", str(code)]
    drawing = encode(result(BOX, **options), "dxf").decode().splitlines()
    assert drawing[drawing.index("$INSUNITS") + 2] == "0"  # in pixels of the picture


def test_dxf_opens_in_ezdxf():
    ezdxf = pytest.importorskip("ezdxf", reason="ezdxf reads DXF back and is not installed")
    import io

    document = ezdxf.read(io.StringIO(encode(result(BOX, BOX), "dxf").decode()))
    layers = [line.dxf.layer for line in document.modelspace().query("LINE")]
    assert (layers.count("VISIBLE"), layers.count("HIDDEN")) == (18, 6)
    assert not document.audit().errors
    face = ezdxf.read(io.StringIO(encode(result(BOX, width="40mm"), "face.dxf").decode()))
    assert face.header["$INSUNITS"] == 4
    (outline,) = face.modelspace().query("POLYLINE")
    assert outline.is_closed
    assert len(outline) == 4


def test_dxf_pairs_a_code_with_each_value():
    rows = encode(result(BOX), "dxf").decode().splitlines()
    assert len(rows) % 2 == 0
    assert all(code.isdigit() for code in rows[::2])
    assert [v for c, v in zip(rows[::2], rows[1::2], strict=True) if v == "LINE"] == ["LINE"] * 12


def test_drawings_need_the_whole_result():
    with pytest.raises(UsageError, match="whole result"):
        encode(lift(BOX), "svg")


def test_names_of_the_flat_face():
    assert format_of("a/b.face.svg") == "face.svg"
    assert format_of("a.v2.svg") == "svg"
    assert format_of("a.stp") == "step"


def path_area(d):
    """Area inside an SVG path of lines and circular arcs."""
    numbers = r"(-?[\d.e+-]+) (-?[\d.e+-]+)"
    steps = re.findall(rf"([MLA])(?:(-?[\d.e+-]+) -?[\d.e+-]+ 0 ([01]) ([01]) )?{numbers}", d)
    points = np.array([[float(x), float(y)] for *_, x, y in steps])
    area = signed_area(points)
    for (p, q), (kind, r, large, sweep, *_) in zip(pairwise(points), steps[1:], strict=True):
        if kind == "A":
            half = np.arcsin(min(np.linalg.norm(q - p) / (2 * float(r)), 1.0))
            turn = 2 * (np.pi - half if large == "1" else half)
            area += (1 if sweep == "1" else -1) * 0.5 * float(r) ** 2 * (turn - np.sin(turn))
    return abs(area)


@pytest.mark.parametrize("name", ["cylinder", "half cylinder", "slot", "tube"])
def test_a_flat_face_keeps_true_arcs(name):
    solid, volume, *_ = ROUND[name]
    paths = ET.fromstring(encode(solid, "face.svg"))[0].get("d").split("Z")[:-1]
    outer, *holes = [path_area(path) for path in paths]
    assert outer - sum(holes) == pytest.approx(volume / 3.0, rel=1e-6)


@pytest.mark.parametrize("name", ["plate with two holes", "groove", "slot", "half cylinder"])
def test_dxf_of_a_flat_face_has_bulges_and_circles(name):
    ezdxf = pytest.importorskip("ezdxf", reason="ezdxf reads DXF back and is not installed")
    import io

    solid, volume, *_ = ROUND[name]
    space = ezdxf.read(io.StringIO(encode(solid, "face.dxf").decode())).modelspace()
    (outline,) = space.query("POLYLINE")
    rows = np.array([[v.dxf.location.x, v.dxf.location.y, v.dxf.bulge] for v in outline.vertices])
    after = np.roll(rows, -1, axis=0)
    area = 0.5 * float((rows[:, 0] * after[:, 1] - after[:, 0] * rows[:, 1]).sum())
    turn = 4 * np.arctan(rows[:, 2])
    chord = np.linalg.norm(after[:, :2] - rows[:, :2], axis=1)
    bent = np.flatnonzero(turn)
    radius = chord[bent] / (2 * np.sin(np.abs(turn[bent]) / 2))
    area += float((np.sign(turn[bent]) * radius**2 / 2 * (np.abs(turn[bent]) - np.sin(np.abs(turn[bent])))).sum())
    area = abs(area) - sum(np.pi * c.dxf.radius**2 for c in space.query("CIRCLE"))
    assert area == pytest.approx(volume / np.ptp(solid.vertices[:, 2]), rel=1e-4)


@pytest.mark.parametrize("format", ["svg", "dxf"])
def test_the_drawing_of_a_cylinder_has_rims_and_outlines(format):
    obj = Drawer(axonometric(), STANDING).draw([CIRCLE], 1.5)
    text = encode(result(obj), format).decode()
    if format == "svg":
        root = ET.fromstring(text)
        groups = {g.get("class"): g[0].get("d") for g in root.iter("{http://www.w3.org/2000/svg}g") if g.get("class")}
        assert groups["visible"].count("M") in (4, 5)  # the lower rim may begin where it is seen
        assert groups["hidden"].count("M") == 1
        return
    ezdxf = pytest.importorskip("ezdxf", reason="ezdxf reads DXF back and is not installed")
    import io

    space = ezdxf.read(io.StringIO(text)).modelspace()
    assert [line.dxf.layer for line in space.query("LINE")] == ["VISIBLE"] * 2
    assert {p.dxf.layer for p in space.query("POLYLINE")} == {"VISIBLE", "HIDDEN"}
