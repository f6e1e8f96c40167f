"""What goes wrong in a request, as a status and plain words: for the page and for the service."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from functools import wraps
from typing import ParamSpec

from starlette.requests import Request
from starlette.responses import JSONResponse, Response

from sketch2shape.errors import Sketch2ShapeError
from sketch2shape.ui.guard import Refusal
from sketch2shape.ui.workers import BusyError

P = ParamSpec("P")

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


async def plain_refusal(_request: Request, error: Exception) -> Response:
    """What is said of an address that is not there, or a method that it does not take."""
    status = getattr(error, "status_code", 404)
    words = "there is no such page" if status == 404 else "this cannot be asked in this way"
    return Refusal(status, words).response()
