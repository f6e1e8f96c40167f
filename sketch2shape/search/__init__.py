"""From the ink of one object to its front and back face: the best verified hypothesis, or all of them."""

from __future__ import annotations

from sketch2shape.search.search import Found, find_all
from sketch2shape.search.stage import as_object, separate_faces

__all__ = ["Found", "as_object", "find_all", "separate_faces"]
