"""The command line. Nothing heavy is imported here, so that --help answers at once."""

from __future__ import annotations

from sketch2shape.command.parser import main

__all__ = ["main"]
