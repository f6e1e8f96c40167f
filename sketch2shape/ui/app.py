"""The web app: a page, and a few requests that hand plain data to the workers and back.

It keeps nothing of what it is sent.
"""

from __future__ import annotations

import json
from collections.abc import AsyncIterator, Mapping
from contextlib import asynccontextmanager
from functools import cache
from importlib.resources import files
from typing import Any
from urllib.parse import unquote

from starlette.applications import Starlette
from starlette.concurrency import run_in_threadpool
from starlette.middleware import Middleware
from starlette.requests import Request
from starlette.responses import JSONResponse, Response
from starlette.routing import Route

from sketch2shape import __version__
from sketch2shape.ui import jobs
from sketch2shape.ui.answers import in_plain_words, plain_refusal, while_wanted
from sketch2shape.ui.examples import EXAMPLES, example_png
from sketch2shape.ui.guard import Guard, Refusal, Uploads
from sketch2shape.ui.hosts import LOCAL_NAMES
from sketch2shape.ui.offers import offered_formats, readable_extras
from sketch2shape.ui.openapi import VECTOR_KINDS
from sketch2shape.ui.workers import WorkerPool, Workers

PAGE_MODULES = (
    "app", "begun", "camera", "changing", "editor", "folder", "geometry", "history", "keep", "live", "marks",
    "opening", "pad", "painting", "readings", "round", "server", "shape", "sheets", "showing", "sizes", "sketching",
    "stage", "take", "tidy", "wiring", "words", "work",
)  # fmt: skip
"""Scripts of the page, which load each other."""

_PAGE_FILES: dict[str, tuple[str, str, str]] = {  # address -> package, file, media type: nothing else is served
    "/": ("sketch2shape.ui", "page/index.html", "text/html; charset=utf-8"),
    "/style.css": ("sketch2shape.ui", "page/style.css", "text/css; charset=utf-8"),
    "/icon.svg": ("sketch2shape.ui", "page/icon.svg", "image/svg+xml"),
    "/viewer.js": ("sketch2shape.pictures", "viewer.js", "text/javascript; charset=utf-8"),
    **{
        f"/{name}.js": ("sketch2shape.ui", f"page/{name}.js", "text/javascript; charset=utf-8") for name in PAGE_MODULES
    },
}

_PICTURE_KINDS = ("image/", "application/octet-stream", "application/pdf", *VECTOR_KINDS)
_LIFT_SECONDS, _MOST_JSON = 15.0, 2**20


def create_app(
    *,
    workers: Workers | None = None,
    names: frozenset[str] = LOCAL_NAMES,
    max_upload: int = 24 * 2**20,
    seconds: float = 60.0,
    key: str | None = None,
) -> Starlette:
    """The ASGI application.

    workers    : who does the work; None starts worker processes with the app
    names      : host names the app answers to
    max_upload : largest picture taken, bytes
    seconds    : time limit for one picture
    key        : only who shows it is served; None: everybody
    """
    service = _Service(workers, max_upload, seconds)
    routes = [Route(address, _page_file, methods=["GET"]) for address in _PAGE_FILES]
    routes += [
        Route("/about", service.about, methods=["GET"]),
        Route("/queue", service.queue, methods=["GET"]),
        Route("/examples/{name}.png", _example, methods=["GET"]),
        Route("/api/reconstruct", service.reconstruct, methods=["POST"]),
        Route("/api/sketch", service.sketch, methods=["POST"]),
        Route("/api/lift", service.lift, methods=["POST"]),
        Route("/api/readings", service.readings, methods=["POST"]),
        Route("/api/connect", service.connect, methods=["POST"]),
        Route("/api/stages", service.stages, methods=["POST"]),
        Route("/api/export/{form}", service.export, methods=["POST"]),
    ]
    return Starlette(
        routes=routes,
        middleware=[Middleware(Guard, names=names, key=key)],
        exception_handlers={404: plain_refusal, 405: plain_refusal},
        lifespan=service.lifespan,
    )


class _Service:
    """The requests that need work done."""

    def __init__(self, workers: Workers | None, max_upload: int, seconds: float) -> None:
        self._workers, self._uploads, self._seconds = workers, Uploads(max_upload), seconds

    @asynccontextmanager
    async def lifespan(self, _app: Starlette) -> AsyncIterator[None]:
        """Keep the workers as long as the app runs."""
        own = self._workers is None
        self._workers = self._workers or WorkerPool()
        try:
            yield
        finally:
            if own:
                self.workers.close()

    @property
    def workers(self) -> Workers:
        """The workers, started."""
        if self._workers is None:
            raise RuntimeError("the app has not been started")
        return self._workers

    @asynccontextmanager
    async def _json(self, request: Request, *, with_picture: bool = False) -> AsyncIterator[Mapping[str, Any]]:
        """The body as a JSON object, held while it is used. Raises Refusal."""
        most = _MOST_JSON + (self._uploads.each * 4 // 3 if with_picture else 0)
        async with self._uploads.body(request, ("application/json",), most) as body:
            try:
                data = json.loads(body)
            except (ValueError, RecursionError) as error:
                raise Refusal(400, "the request is not JSON") from error
            if not isinstance(data, dict):
                raise Refusal(400, "the request is not a JSON object")
            yield data

    @in_plain_words
    async def reconstruct(self, request: Request) -> Response:
        """Picture bytes in; objects, solids and stages out."""
        name = unquote(request.headers.get("x-name", ""))[:200] or "drawing"
        page = request.headers.get("x-page", "0")
        number = int(page) if page.isdecimal() and len(page) < 6 else 0
        async with self._uploads.body(request, _PICTURE_KINDS) as data:
            found = await self.workers.run(jobs.reconstruct_picture, data, name, number, seconds=self._seconds)
        return JSONResponse(found)

    async def about(self, _request: Request) -> Response:
        """What the page offers: examples, formats, kinds of files that can be read here, the largest upload."""
        listed = [{"name": name, "title": example.title} for name, example in EXAMPLES.items()]
        offers = {"formats": offered_formats(), "reads": readable_extras(), "most": self._uploads.each}
        return JSONResponse({"examples": listed, **offers, "version": __version__})

    async def queue(self, _request: Request) -> Response:
        """How much work waits."""
        return JSONResponse({"waiting": self.workers.waiting})

    @in_plain_words
    async def sketch(self, request: Request) -> Response:
        """Strokes in; objects and solids out."""
        async with self._json(request) as data:
            work = self.workers.run(jobs.reconstruct_sketch, data, seconds=_LIFT_SECONDS)
            return JSONResponse(await while_wanted(request, work))

    @in_plain_words
    async def readings(self, request: Request) -> Response:
        """{"corrections": ..., "object": number} in; the solids it may be of out."""
        async with self._json(request) as data:
            asked = data.get("corrections"), data.get("object")
            readings = await self.workers.run(jobs.other_readings, *asked, seconds=_LIFT_SECONDS)
        return JSONResponse({"readings": readings})

    @in_plain_words
    async def lift(self, request: Request) -> Response:
        """Corrections in, solids out."""
        async with self._json(request) as data:
            return JSONResponse(await self.workers.run(jobs.lift_corrections, data, seconds=_LIFT_SECONDS))

    @in_plain_words
    async def connect(self, request: Request) -> Response:
        """{"front": points, "back": points} in, rings out."""
        async with self._json(request) as data:
            front, back = (data.get(k) for k in ("front", "back"))
            return JSONResponse(await self.workers.run(jobs.connect_loose, front, back, seconds=_LIFT_SECONDS))

    @in_plain_words
    async def stages(self, request: Request) -> Response:
        """{"picture": base64, "corrections": ...} in, the stages' pictures out."""
        async with self._json(request, with_picture=True) as data:
            picture = jobs.picture_bytes(data.get("picture"))
            found = await self.workers.run(jobs.show_stages, picture, data.get("corrections"), seconds=self._seconds)
        return JSONResponse(found)

    @in_plain_words
    async def export(self, request: Request) -> Response:
        """Corrections in, a file out."""
        form = request.path_params["form"]
        async with self._json(request, with_picture=True) as data:
            made = await self.workers.run(jobs.export_corrections, data, form, seconds=self._seconds)
        return Response(made, media_type="application/octet-stream")


@cache
def _content(package: str, name: str) -> bytes:
    return files(package).joinpath(name).read_bytes()


async def _page_file(request: Request) -> Response:
    package, name, kind = _PAGE_FILES[request.url.path]
    return Response(_content(package, name), media_type=kind)


async def _example(request: Request) -> Response:
    name = request.path_params["name"]
    if name not in EXAMPLES:
        return Refusal(404, "there is no such example").response()
    return Response(await run_in_threadpool(example_png, name), media_type="image/png")
