"""The evaluation itself: an oracle scores 100 %, and what goes wrong is counted and named."""

import importlib
import sys
from pathlib import Path

import numpy as np
import pytest

from evaluation import page as page_of
from evaluation.failures import write_sheets
from sketch2shape import errors
from sketch2shape.model import Projection, Solid, two_face_boundary
from sketch2shape.model.drawing import FacePair, TwoFaceObject
from sketch2shape.model.picture import Picture
from sketch2shape.pipeline.result import Result
from synthetic import metrics
from synthetic.drawing import draw

SCRIPTS = Path(__file__).parent.parent / "scripts"


@pytest.fixture(scope="module")
def scripts():
    sys.path.insert(0, str(SCRIPTS))
    yield {"evaluate": importlib.import_module("evaluate")}
    sys.path.remove(str(SCRIPTS))


@pytest.fixture
def case(tmp_path):
    drawing = draw("clean_wire_axono", 3, 0)
    return {"set": "fresh", "id": drawing.truth["id"], "picture": str(drawing.save(tmp_path)), "truth": drawing.truth}


def result_for(truth, confidence=0.95, turn=0):
    """What a perfect tool would say; `turn` gives the back face a wrong order."""
    f2 = np.roll(truth["f2"], turn, 0)
    found = TwoFaceObject(np.array(truth["f1"]), np.array(f2), tuple(FacePair(**h) for h in truth["holes"]), confidence)
    solid = Solid(two_face_boundary(metrics.true_solid(truth), (truth["n"],)), Projection("axonometric"))
    return Result((found,), (solid,), Picture(np.zeros((2, 2, 3), np.uint8)))


def pretend(monkeypatch, answer):
    module = importlib.import_module("sketch2shape.pipeline")
    monkeypatch.setattr(module, "reconstruct", answer, raising=False)


def test_an_oracle_is_exact_with_a_good_mesh_and_solid(scripts, case, monkeypatch):
    pretend(monkeypatch, lambda _: result_for(case["truth"]))
    outcome = scripts["evaluate"].measure(case)
    assert outcome["exact"]
    assert outcome["mesh"]
    assert outcome["solid"]
    assert outcome["iou"] == pytest.approx(1, abs=1e-6)
    # Two independent samples of one surface still lie a little apart.
    assert outcome["chamfer"] < 0.03


def test_wrong_answers_refusals_and_bugs_are_told_apart(scripts, case, monkeypatch):
    def refuse(_):
        raise errors.NoObjectError("no two faces")

    def fail(_):
        raise ZeroDivisionError("oh")

    kinds = []
    for answer in (lambda _: result_for(case["truth"], turn=1), refuse, fail):
        pretend(monkeypatch, answer)
        outcome = scripts["evaluate"].measure(case)
        assert not outcome["exact"]
        kinds.append(page_of.kind_of(outcome))
    assert kinds == ["edges wrong", "refused", "crashed: ZeroDivisionError"]


def test_a_crash_is_no_right_refusal(scripts, monkeypatch, tmp_path):
    def fail(_):
        raise ZeroDivisionError

    pretend(monkeypatch, fail)
    drawing = draw("negative", 1, 3)
    case = {"set": "fresh", "id": "negative/003", "picture": str(drawing.save(tmp_path)), "truth": drawing.truth}
    assert not scripts["evaluate"].measure(case)["exact"]


def test_the_page_tells_the_command_the_shares_and_the_failures(scripts, case, monkeypatch, tmp_path):
    pytest.importorskip("matplotlib")
    outcomes = []
    for turn in (0, 0, 0, 1):
        pretend(monkeypatch, lambda _, turn=turn: result_for(case["truth"], turn=turn))
        outcomes.append(scripts["evaluate"].measure(case))
    page = tmp_path / "docs" / "results.md"
    sheets = write_sheets(outcomes, page.parent / "failures")
    page_of.write_page(page, outcomes, "python scripts/evaluate.py", sheets)
    text = page.read_text()
    assert "python scripts/evaluate.py" in text
    assert "| fresh | 4 | 75.0 |" in text
    assert "Of 4 answers with confidence 0.9 or more, 75.0 % are right." in text
    assert "vertices right, edges wrong" in text
    assert "failures/1.jpg" in text
    assert (page.parent / "failures" / "1.jpg").stat().st_size > 1000
    assert (page.parent / "reliability.svg").exists()


def test_the_page_holds_the_tables_of_the_lifting(scripts, tmp_path):
    (tmp_path / "lifting.md").write_text(
        "# Lifting\n\nWords.\n\n## How often\n\n### A set\n\n| right | 0 px |\n|---|---|\n| all | 90 % |\n"
    )
    text = page_of.lifting(tmp_path / "lifting.md")
    assert "### A set\n\n| right | 0 px |\n|---|---|\n| all | 90 % |\n" in text
    assert "Words" not in text
    assert "How often" not in text
    assert "Not measured" in page_of.lifting(tmp_path / "none.md")


def test_the_recorded_command_leaves_out_places_on_this_machine(scripts):
    options = ["--raw", "/somewhere/raw.json", "--sets", "committed", "--page", "", "--seed", "3"]
    assert scripts["evaluate"].recorded(options) == "python scripts/evaluate.py --sets committed --seed 3"
