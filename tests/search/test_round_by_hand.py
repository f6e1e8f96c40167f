"""Round objects as a person draws them: what each mechanism for them is there for, on drawings of the generator."""

import pytest

from evaluation import curves
from sketch2shape.pipeline import reconstruct
from sketch2shape.pipeline.report import report
from synthetic.drawing import draw

DRAWINGS = {
    "a cone drawn in one line": ("cone_removed", 23, 0),
    "a tube in pencil, whose grain parts the lines": ("curved_sketch", 77, 8),
    "a cut cone with wavy sides": ("curved_sketch", 77, 12),
    "a cut cone whose rims are not alike": ("frustum_dashed", 77, 6),
    "a round end that runs into a line askew": ("arcs_removed", 77, 6),
}


@pytest.mark.parametrize("kind", DRAWINGS.values(), ids=DRAWINGS.keys())
def test_it_is_found(kind, tmp_path):
    drawn = draw(*kind)
    (answer,) = report(reconstruct(drawn.save(tmp_path)))["objects"]
    verdict = curves.judge(drawn.truth, [answer])
    assert verdict.exact, verdict.cause
    assert answer["confidence"] > 0.5
