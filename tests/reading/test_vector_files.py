"""One file in each manner of the programs that keep lines, read as lines, and the object they show found in them."""

import io
import json
from pathlib import Path

import numpy as np
import pytest

import sketch2shape as s2s
from evaluation.metrics import compare
from sketch2shape.pipeline.report import report
from sketch2shape.reading.read import SUFFIXES
from synthetic.drawing import pen_strokes
from synthetic.vector_files import ENDINGS, MANNERS, write

FOLDER = Path(__file__).parents[2] / "data" / "vectors"
TRUTHS = json.loads((FOLDER / "truth.json").read_text())


def placed(answer, truth):
    """The answer on the sheet of the truth: a file has a unit and a place of its own."""

    def every(thing):
        return np.array(thing["f1"] + thing["f2"])

    a, t = every(answer), every(truth)
    k = np.linalg.norm(np.ptp(t, axis=0)) / np.linalg.norm(np.ptp(a, axis=0))
    return {key: ((np.array(answer[key]) - a.min(axis=0)) * k + t.min(axis=0)).tolist() for key in ("f1", "f2")}


@pytest.mark.parametrize("name", TRUTHS)
def test_files_of_each_program_are_read_right(name):
    if name.endswith(".pdf"):
        pytest.importorskip("pypdfium2")
    result = s2s.reconstruct(FOLDER / name)
    assert result.picture.drawing is not None
    assert len(result.objects) == 1
    answer, truth = report(result)["objects"][0], TRUTHS[name]
    verdict = compare(truth, placed(answer, truth))
    assert verdict.exact, verdict.cause
    assert result.objects[0].lines == truth["lines"]


def test_there_are_five_manners_of_each_kind():
    kinds = [manner.partition("/")[0] for manner in MANNERS]
    assert {kind: kinds.count(kind) for kind in ENDINGS} == dict.fromkeys(ENDINGS, 5)
    assert len(TRUTHS) == len(MANNERS)


@pytest.mark.parametrize("kind", [k for k in ENDINGS if k != "pen"])
def test_files_of_each_kind_in_a_folder_are_inputs(kind):
    assert ENDINGS[kind] in SUFFIXES


@pytest.mark.parametrize("manner", [m for m in MANNERS if not m.startswith("pdf")])
def test_what_is_written_holds_every_stroke_to_a_tenth_of_a_pixel(manner):
    strokes, style, _ = pen_strokes("clean_wire_oblique", 5, 1)
    drawing = s2s.read_picture(write(manner, strokes, style.size, np.random.default_rng(1))).drawing
    read = np.concatenate([line.points[[0, -1]] for line in drawing.lines])
    drawn = np.concatenate([s.path[[0, -1]] for s in strokes])
    low = np.concatenate([s.path for s in strokes]).min(axis=0)
    k = np.linalg.norm(np.ptp(drawn, axis=0)) / np.linalg.norm(np.ptp(read, axis=0))
    on_sheet = (read - read.min(axis=0)) * k + low
    gap = np.linalg.norm(drawn[:, None] - on_sheet, axis=2).min(axis=1)
    assert gap.max() < (2.0 if manner == "svg/outlined" else 0.1)


@pytest.mark.parametrize("kind", ["svg", "pdf"])
def test_a_figure_of_matplotlib_is_read_right(kind):
    """Files that the program itself has written: labels as glyphs, a ground, clips, style sheets."""
    figures = pytest.importorskip("matplotlib.figure")
    if kind == "pdf":
        pytest.importorskip("pypdfium2")
    front = np.array([[1, 1], [3, 1], [3, 2.5], [1, 2.5]])
    back = front + [0.9, 0.7]
    axes = (figure := figures.Figure()).subplots()
    axes.axis("off")
    axes.set_aspect("equal")
    for i in range(4):
        for a, b, hidden in (
            (front[i], front[i - 1], False),
            (back[i], back[i - 1], i in (0, 1)),
            (front[i], back[i], i == 0),
        ):
            axes.plot(*np.transpose([a, b]), "k--" if hidden else "k-")
    axes.text(2, 0.8, "a = 2 cm")
    figure.savefig(out := io.BytesIO(), format=kind)
    (found,) = s2s.reconstruct(out.getvalue()).objects
    assert (len(found.f1), found.lines) == (4, "dashed")
    assert found.confidence > 0.9
