"""The HTTP service for programs, `sketch2shape serve`: a picture in, its solid or the report out; nothing is kept."""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import AsyncIterator, Sequence
from contextlib import asynccontextmanager
from typing import TYPE_CHECKING, Any

from sketch2shape import __version__
from sketch2shape.errors import MissingPackageError, UsageError
from sketch2shape.ui.hosts import LOCAL_NAMES

if TYPE_CHECKING:
    from starlette.applications import Starlette
    from starlette.requests import Request
    from starlette.responses import Response

    from sketch2shape.ui.workers import Workers

_KINDS = ("image/", "application/octet-stream", "application/pdf", "multipart/form-data")


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
    from starlette.applications import Starlette
    from starlette.middleware import Middleware
    from starlette.responses import JSONResponse
    from starlette.routing import Route

    from sketch2shape.ui import jobs
    from sketch2shape.ui.answers import in_plain_words, plain_refusal
    from sketch2shape.ui.guard import Guard, read_body
    from sketch2shape.ui.openapi import MEDIA, description
    from sketch2shape.ui.workers import WorkerPool

    crew: list[Workers] = [workers] if workers else []

    @asynccontextmanager
    async def lifespan(_app: Starlette) -> AsyncIterator[None]:
        if workers is None:
            crew.append(WorkerPool(processes))
        try:
            yield
        finally:
            if workers is None:
                crew.pop().close()

    async def health(_request: Request) -> Response:
        return JSONResponse({"status": "ok", "version": __version__})

    async def openapi(_request: Request) -> Response:
        return JSONResponse(description())

    @in_plain_words
    async def reconstruct(request: Request) -> Response:
        from starlette.responses import Response

        product, options = _asked(dict(request.query_params))
        body = await read_body(request, _KINDS, max_upload)
        content_type = request.headers.get("content-type", "")
        if content_type.lower().startswith("multipart/"):
            from sketch2shape.ui.form import file_of

            body = file_of(body, content_type)
        made = await crew[0].run(jobs.make_product, body, product, options, seconds=seconds)
        return Response(made, media_type=MEDIA[product])

    return Starlette(
        routes=[
            Route("/health", health, methods=["GET"]),
            Route("/openapi.json", openapi, methods=["GET"]),
            Route("/v1/reconstruct", reconstruct, methods=["POST"]),
        ],
        middleware=[] if names is None else [Middleware(Guard, names=names)],
        exception_handlers={404: plain_refusal, 405: plain_refusal},
        lifespan=lifespan,
    )


def _asked(query: dict[str, str]) -> tuple[str, dict[str, Any]]:
    """The product and the options of `reconstruct` in a query. Raises UsageError."""
    from sketch2shape.ui.openapi import MEDIA, OPTIONS

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


def build_parser() -> argparse.ArgumentParser:
    """The options of `sketch2shape serve`."""
    parser = argparse.ArgumentParser(
        prog="sketch2shape serve",
        description="An HTTP service: POST a picture to /v1/reconstruct?format=stl; /openapi.json describes it, "
        "/health says whether it is up. Nothing is kept.",
    )
    parser.add_argument("--host", default="127.0.0.1", help="address to listen on (default: this machine only)")
    parser.add_argument("--port", type=int, default=8766, help="port, 0 for any free one (default 8766)")
    parser.add_argument(
        "--allow-host", metavar="NAME", action="append", default=[],
        help="answer to this host name (may be repeated); default: this machine's, or any if --host is another address",
    )  # fmt: skip
    parser.add_argument("--workers", type=int, default=2, help="worker processes (default 2)")
    parser.add_argument("--max-upload", metavar="MB", type=float, default=24, help="largest picture taken (default 24)")
    parser.add_argument("--timeout", metavar="S", type=float, default=60, help="seconds of computing (default 60)")
    return parser


def main(argv: Sequence[str] | None = None) -> int:
    """Run `sketch2shape serve` with these arguments until it is interrupted; returns the exit code."""
    options = build_parser().parse_args(argv)
    if not (0 <= options.port < 65536 and options.max_upload > 0 and options.timeout > 0 and options.workers > 0):
        raise UsageError("port, upload size, time limit and workers must be positive and a port below 65536")
    try:
        from sketch2shape.ui.serve import listen, run_app

        local = options.host in ("127.0.0.1", "localhost", "::1")
        names = frozenset(options.allow_host) | LOCAL_NAMES if local or options.allow_host else None
        app = create_service(
            names=names, max_upload=int(options.max_upload * 2**20), seconds=options.timeout, processes=options.workers
        )
    except ImportError as error:
        raise MissingPackageError(
            f"the service needs the package {error.name}", remedy="pip install 'sketch2shape[ui]'"
        ) from error
    listening = listen(options.host, options.port)
    sys.stdout.write(json.dumps({"listening": list(listening.getsockname()[:2])}) + "\n")
    sys.stdout.flush()
    run_app(app, listening)
    return 0
