"""The whole way from a drawing to its solids."""

from __future__ import annotations

from sketch2shape.pipeline.reconstruction import reconstruct
from sketch2shape.pipeline.result import Result
from sketch2shape.pipeline.solid import Solid, lift

__all__ = ["Result", "Solid", "lift", "reconstruct"]
