"""Witnesses of sweeps: each tells what it is named after."""

from dataclasses import replace

import numpy as np
import pytest
from round_sketches import ARCH, CONE, CYLINDER, PYRAMID, TUBE, drawn
from sketches import ink_of, line, outline

from sketch2shape.evidence import SWEEP_WITNESSES, compare_sweep, observe, sweep_witnesses
from sketch2shape.evidence.sweep_witness import FEW_LINES, MOST_GAP
from sketch2shape.ink import split_groups
from sketch2shape.strokes import thin
from sketch2shape.sweeps import Sweep, Way
from sketch2shape.sweeps.outlines import polygon


def seen_in(picture, sweep, gap=10.0, leaning=0.0):
    """The witnesses by name, and what they were told of."""
    (group,) = split_groups(ink_of(picture))
    view = observe(group, thin(group.ink))
    own = sweep.shifted(-group.offset)
    compared = compare_sweep(own, view, 3.0)
    energy = compared.energy(np.inf)
    told = sweep_witnesses(own, energy, compared, gap, leaning)
    return dict(zip(SWEEP_WITNESSES, told, strict=True)), view, energy


@pytest.mark.parametrize("lines", ["wire", "removed"])
@pytest.mark.parametrize("sweep", [CYLINDER, ARCH, CONE], ids=["cylinder", "arch", "cone"])
def test_the_true_one_has_nothing_against_it(sweep, lines):
    seen, _, _ = seen_in(drawn(sweep, lines), sweep)
    for name in ("unexplained", "attached", "closed"):
        assert seen[name] < 0.05, name
    assert seen["missing"] < np.log1p(10.0)


def test_foreign_ink_is_told_by_length_and_whether_it_touches():
    beside, view, _ = seen_in(line(drawn(CYLINDER), [200, 185], [280, 185]), CYLINDER)
    assert beside["unexplained"] == pytest.approx(80 / view.length.sum(), rel=0.15)
    touching, _, _ = seen_in(line(drawn(CYLINDER), [330, 200], [420, 200]), CYLINDER)
    assert beside["attached"] < 0.02 < touching["attached"]


DART = np.array([[225.0, 100], [120, 280], [225, 200], [330, 290]])


def test_lines_from_vertex_to_vertex_outside_the_silhouette_are_chords():
    base = PYRAMID.rings[0].vertices
    assert seen_in(line(drawn(PYRAMID), base[0], base[2]), PYRAMID)[0]["chords"] == 0.0
    dart = Sweep((polygon(DART),), Way(np.array([8.0, 20.0])))
    assert seen_in(drawn(dart), dart)[0]["chords"] == 0.0
    seen, view, _ = seen_in(line(drawn(dart), DART[1], DART[3]), dart)
    assert seen["chords"] == pytest.approx(np.hypot(*(DART[3] - DART[1])) / view.size, rel=0.02)


def test_ink_that_encloses_something_by_itself_is_told():
    square = np.array([[220.0, 190], [260, 190], [260, 230], [220, 230]])
    seen, view, _ = seen_in(outline(square, picture=drawn(CYLINDER)), CYLINDER)
    assert seen["closed"] == pytest.approx(40 / view.size, rel=0.15)


def test_what_an_object_has_and_the_drawing_lacks_is_missing():
    seen, _, energy = seen_in(drawn(CYLINDER), TUBE)
    assert seen["missing"] == pytest.approx(np.log1p(energy.missing))
    assert energy.missing > 30


@pytest.mark.parametrize("width", [2, 6])
def test_noise_size_and_depth_are_told_by_the_pen(width):
    seen, view, energy = seen_in(drawn(ARCH, width=width), ARCH)
    assert seen["noise"] == pytest.approx(np.log(energy.noise / (0.4 + 0.05 * view.pen)))
    assert seen["small"] == pytest.approx(np.log(view.size / view.pen))
    depth = np.hypot(*ARCH.way.shift)
    assert seen["shallow"] == pytest.approx(np.log(depth / (view.pen + 2 * energy.noise)))


def test_the_gap_counts_up_to_a_limit():
    picture = drawn(CYLINDER)
    assert seen_in(picture, CYLINDER, gap=20.0)[0]["gap"] == pytest.approx(np.log(21.0))
    assert seen_in(picture, CYLINDER, gap=np.inf)[0]["gap"] == pytest.approx(np.log1p(MOST_GAP))
    assert seen_in(picture, CYLINDER, gap=-3.0)[0]["gap"] == 0.0


def test_what_the_sweep_is_is_told():
    arch, cone, tube = (seen_in(drawn(s), s, leaning=2.5)[0] for s in (ARCH, CONE, TUBE))
    assert [s["pointed"] for s in (arch, cone, tube)] == [0.0, 1.0, 0.0]
    assert [s["holes"] for s in (arch, cone, tube)] == [0.0, 0.0, 1.0]
    assert [s["standing"] for s in (arch, cone, tube)] == [2.5, 2.5, 2.5]
    assert arch["numbers"] == pytest.approx(np.log(ARCH.shape_numbers))
    guessed = replace(CONE, regular=3.0)
    assert [seen_in(drawn(CONE), s)[0]["inferred"] for s in (CONE, guessed)] == [0.0, 1.0]


def test_hidden_lines_count_only_where_they_are_left_out():
    wire, removed = (seen_in(drawn(ARCH, lines), ARCH)[0]["unseen"] for lines in ("wire", "removed"))
    assert wire == 0.0
    assert 0.1 < removed < 0.6


def test_a_figure_of_few_lines_is_alone():
    assert len(np.unique(seen_in(drawn(ARCH), ARCH)[1].path)) > FEW_LINES
    assert seen_in(drawn(ARCH), ARCH)[0]["lone"] == 0.0
    assert seen_in(drawn(CONE, "removed"), CONE)[0]["lone"] == 1.0
