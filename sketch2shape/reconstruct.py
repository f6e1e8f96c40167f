"""The pipeline: read -> ink -> strokes -> corners -> faces -> verified object -> solid."""

from __future__ import annotations
