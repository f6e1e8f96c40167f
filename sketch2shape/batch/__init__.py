"""Many inputs at once: planned before work starts, done in worker processes, resumed after a stop."""

from __future__ import annotations

from typing import Any

__all__ = ["reconstruct_many"]


def __getattr__(name: str) -> Any:
    """Load the public function on first use."""
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from sketch2shape.batch.many import reconstruct_many

    return reconstruct_many
