"""What goes wrong in a request, as a status and plain words: for the page and for the service."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable, Coroutine
from functools import wraps
from typing import Any, ParamSpec, TypeVar

from starlette.requests import Request
from starlette.responses import JSONResponse, Response

from sketch2shape.errors import Sketch2ShapeError
from sketch2shape.ui.guard import Refusal
from sketch2shape.ui.workers import BusyError

P = ParamSpec("P")
T = TypeVar("T")

#: exit code of an error -> HTTP status
_STATUS = {1: 500, 2: 400, 4: 415, 5: 422, 6: 413, 8: 501}


def in_plain_words(answer: Callable[P, Awaitable[Response]]) -> Callable[P, Awaitable[Response]]:
    """Turn what goes wrong into a status and words."""

    @wraps(answer)
    async def guarded(*arguments: P.args, **named: P.kwargs) -> Response:
        try:
            return await answer(*arguments, **named)
        except Refusal as refusal:
            return refusal.response()
        except Sketch2ShapeError as error:
            status = 503 if isinstance(error, BusyError) else _STATUS.get(error.exit_code, 500)
            return JSONResponse({"error": error.message, "advice": error.advice}, status_code=status)
        except Exception as error:  # the last line of defence: whoever asked is told, the app goes on
            words = f"something went wrong inside ({type(error).__name__})"
            return JSONResponse({"error": words, "advice": "report this as a bug, with the drawing"}, status_code=500)

    return guarded


async def while_wanted(request: Request, work: Coroutine[Any, Any, T]) -> T:
    """What work gives; it is cancelled once whoever asked, whose body has been read, has gone. Raises Refusal then."""
    task, gone = asyncio.create_task(work), asyncio.create_task(_gone(request))
    try:
        await asyncio.wait({task, gone}, return_when=asyncio.FIRST_COMPLETED)
        if not task.done():
            raise Refusal(400, "nobody waits for the answer", "try again")
        return task.result()
    finally:
        task.cancel()
        gone.cancel()


async def _gone(request: Request) -> None:
    while (await request.receive())["type"] != "http.disconnect":
        pass


async def plain_refusal(_request: Request, error: Exception) -> Response:
    """What is said of an address that is not there, or a method that it does not take."""
    status = getattr(error, "status_code", 404)
    words = "there is no such page" if status == 404 else "this cannot be asked in this way"
    return Refusal(status, words).response()
