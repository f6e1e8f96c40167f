"""The main job, end to end, on every committed drawing: exact topology and a good mesh, or a refusal where due."""

import numpy as np
import pytest

from evaluation import metrics
from sketch2shape.errors import NoObjectError
from sketch2shape.pipeline import reconstruct
from sketch2shape.pipeline.report import report


def test_hard_drawings_are_answered_with_a_good_mesh_or_refused(hard_drawing):
    try:
        result = reconstruct(hard_drawing[0])
    except NoObjectError:
        return
    assert result.mesh.is_watertight
    assert result.mesh.volume > 0


def test_the_object_of_each_committed_drawing_is_found(drawing):
    path, truth = drawing
    if truth.get("objects") == []:
        with pytest.raises(NoObjectError):
            reconstruct(path)
        return
    result = reconstruct(path)
    verdict = metrics.judge(truth, report(result)["objects"])
    assert verdict.exact, verdict.cause
    mesh = result.mesh
    assert mesh.is_watertight
    assert mesh.is_winding_consistent
    assert mesh.volume > 0
    assert len(mesh.vertices) == sum(len(s.vertices) for s in result.solids)
    assert np.isfinite(mesh.vertices).all()
