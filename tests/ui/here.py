"""Workers of an app that runs in this process, and a box to send it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

#: a box, pixels of a picture of 500 by 440
FRONT = [[100.0, 160.0], [300.0, 160.0], [300.0, 340.0], [100.0, 340.0]]
BACK = [[190.0, 100.0], [390.0, 100.0], [390.0, 280.0], [190.0, 280.0]]


class Here:
    """Workers that are no processes."""

    async def run(self, function: Callable[..., Any], *arguments: Any, seconds: float) -> Any:
        assert seconds > 0
        return function(*arguments)

    @property
    def waiting(self) -> int:
        return 0

    def close(self) -> None: ...
