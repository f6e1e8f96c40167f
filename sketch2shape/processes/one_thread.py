"""Imported first by the fork server, before it loads linear algebra for all workers."""

from __future__ import annotations

from sketch2shape.processes.threads import compute_in_one_thread

compute_in_one_thread(whatever_was_asked=True)
