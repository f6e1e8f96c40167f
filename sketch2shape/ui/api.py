"""The HTTP service for programs: a picture in, its solid or the report out; nothing is kept."""

from __future__ import annotations

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from typing import Any

from starlette.applications import Starlette
from starlette.middleware import Middleware
from starlette.requests import Request
from starlette.responses import JSONResponse, Response
from starlette.routing import Route

from sketch2shape import __version__
from sketch2shape.errors import UsageError
from sketch2shape.ui import jobs
from sketch2shape.ui.answers import in_plain_words, plain_refusal
from sketch2shape.ui.form import file_of
from sketch2shape.ui.guard import Guard, Uploads
from sketch2shape.ui.openapi import MEDIA, OPTIONS, VECTOR_KINDS, description
from sketch2shape.ui.workers import WorkerPool, Workers

_KINDS = ("image/", "application/octet-stream", "application/pdf", *VECTOR_KINDS, "multipart/form-data")


def create_service(
    *,
    workers: Workers | None = None,
    names: frozenset[str] | None = None,
    max_upload: int = 24 * 2**20,
    seconds: float = 60.0,
    processes: int = 2,
) -> Starlette:
    """The ASGI application.

    workers    : who does the work; None starts `processes` worker processes with the app
    names      : host names the app answers to; None: to any
    max_upload : largest picture taken, bytes
    seconds    : of computing, for one picture
    """
    service = _Service(workers, processes, max_upload, seconds)
    return Starlette(
        routes=[
            Route("/health", _health, methods=["GET"]),
            Route("/openapi.json", _openapi, methods=["GET"]),
            Route("/v1/reconstruct", service.reconstruct, methods=["POST"]),
        ],
        middleware=[] if names is None else [Middleware(Guard, names=names)],
        exception_handlers={404: plain_refusal, 405: plain_refusal},
        lifespan=service.lifespan,
    )


class _Service:
    """The request that needs work done."""

    def __init__(self, workers: Workers | None, processes: int, max_upload: int, seconds: float) -> None:
        self._workers, self._processes, self._uploads, self._seconds = workers, processes, Uploads(max_upload), seconds

    @asynccontextmanager
    async def lifespan(self, _app: Starlette) -> AsyncIterator[None]:
        """Keep the workers as long as the app runs."""
        if self._workers is not None:
            yield
            return
        self._workers = WorkerPool(self._processes)
        try:
            yield
        finally:
            self._workers.close()
            self._workers = None

    @in_plain_words
    async def reconstruct(self, request: Request) -> Response:
        """Picture bytes in, alone or in a form; the bytes of a product out."""
        if self._workers is None:
            raise RuntimeError("the app has not been started")
        product, options = _asked(dict(request.query_params))
        content_type = request.headers.get("content-type", "")
        async with self._uploads.body(request, _KINDS) as sent:
            body = file_of(sent, content_type) if content_type.lower().startswith("multipart/") else sent
            made = await self._workers.run(jobs.make_product, body, product, options, seconds=self._seconds)
        return Response(made, media_type=MEDIA[product])


async def _health(_request: Request) -> Response:
    return JSONResponse({"status": "ok", "version": __version__})


async def _openapi(_request: Request) -> Response:
    return JSONResponse(description())


def _asked(query: dict[str, str]) -> tuple[str, dict[str, Any]]:
    """The product and the options of `reconstruct` in a query. Raises UsageError."""
    product = query.pop("format", "json")
    if product not in MEDIA:
        raise UsageError(f"no format is called {product[:40]!r}", remedy=f"format= one of {', '.join(MEDIA)}")
    unknown = next((name for name in query if name not in OPTIONS), None)
    if unknown is not None:
        raise UsageError(f"there is no option {unknown[:40]!r}", remedy=f"one of {', '.join(OPTIONS)}")
    options: dict[str, Any] = {}
    if "min_confidence" in query:
        try:
            options["min_confidence"] = float(query.pop("min_confidence"))
        except ValueError:
            raise UsageError("min_confidence is no number", remedy="min_confidence=0.9") from None
    return product, {**options, "lift": query}
