"""Work is done for those who wait for it."""

from __future__ import annotations

import asyncio
from typing import Any

import pytest
from starlette.requests import Request

from sketch2shape.ui.answers import while_wanted
from sketch2shape.ui.guard import Refusal


def asked_by(messages: list[dict[str, Any]]) -> Request:
    """A request of somebody who says this, then nothing."""

    async def receive() -> dict[str, Any]:
        if not messages:
            await asyncio.sleep(60)
        return messages.pop(0)

    return Request({"type": "http", "method": "POST", "path": "/", "headers": []}, receive)


def test_work_goes_on_while_somebody_waits() -> None:
    async def work() -> int:
        await asyncio.sleep(0.01)
        return 3

    assert asyncio.run(while_wanted(asked_by([{"type": "http.request"}]), work())) == 3


def test_work_is_cancelled_once_nobody_does() -> None:
    ended = []

    async def work() -> None:
        try:
            await asyncio.sleep(60)
        finally:
            ended.append(True)

    async def both() -> None:
        with pytest.raises(Refusal, match="nobody waits"):
            await while_wanted(asked_by([{"type": "http.request"}, {"type": "http.disconnect"}]), work())
        await asyncio.sleep(0)

    asyncio.run(both())
    assert ended


def test_what_goes_wrong_is_told() -> None:
    async def work() -> None:
        raise ValueError("three")

    with pytest.raises(ValueError, match="three"):
        asyncio.run(while_wanted(asked_by([]), work()))
