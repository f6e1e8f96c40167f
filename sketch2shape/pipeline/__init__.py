"""The whole way from a drawing to its solids."""

from __future__ import annotations

from sketch2shape.pipeline.reconstruction import reconstruct
from sketch2shape.pipeline.result import Result

__all__ = ["Result", "reconstruct"]
