"""Many inputs at once: planned before work starts, done in worker processes, resumed after a stop."""

from __future__ import annotations

from sketch2shape.batch.many import reconstruct_many

__all__ = ["reconstruct_many"]
