"""From the ink of one object to its front and back face: the best verified hypothesis, or all of them."""

from __future__ import annotations

from sketch2shape.search.closer import find_closely
from sketch2shape.search.exact import Verified
from sketch2shape.search.found import Found
from sketch2shape.search.found_sweep import FoundSweep
from sketch2shape.search.objects import AnyFound, find_all
from sketch2shape.search.stage import as_object, separate_faces
from sketch2shape.search.swept_object import sweep_as_object

__all__ = [
    "AnyFound",
    "Found",
    "FoundSweep",
    "Verified",
    "as_object",
    "find_all",
    "find_closely",
    "separate_faces",
    "sweep_as_object",
]
