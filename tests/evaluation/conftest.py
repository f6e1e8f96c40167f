import pytest

from evaluation.cases import case_of
from synthetic.drawing import draw


@pytest.fixture
def case(tmp_path):
    """A drawing of a box or the like, with its truth beside it."""
    return case_of(draw("clean_wire_axono", 3, 0).save(tmp_path), of_set="fresh")
