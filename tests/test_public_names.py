"""Stages named like their module: `sketch2shape.lift` is both."""

import subprocess
import sys

import pytest


@pytest.mark.parametrize(
    "first", ["s.lift(o)", "from sketch2shape.lift import LiftOptions", "import sketch2shape.lift", "s.TwoFaceObject"]
)
def test_a_stage_can_be_called_whatever_was_imported_first(first):
    code = (
        "import numpy as np, sketch2shape as s\n"
        "square = np.array([[0, 0], [100, 0], [100, 100], [0, 100.0]])\n"
        "o = s.TwoFaceObject(square, square + [30, -30])\n"
        f"{first}\n"
        "assert s.lift(o).volume > 0\n"
        "assert s.lift(o).volume > 0\n"
        "from sketch2shape.lift import lift\n"
        "assert lift(o).volume > 0\n"
    )
    subprocess.run([sys.executable, "-c", code], check=True)
