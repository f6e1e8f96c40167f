"""What a request must fulfil before any of the app's code sees it.

Strategy: the app serves one person on one machine, so it answers only requests addressed to this machine by name (a
page elsewhere that rebinds its DNS name has another Host), only posts from its own page (Origin), only plain bodies of
a known type (a form on another page cannot send them) and only bodies up to a size that is counted while reading, not
believed.
"""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

from starlette.requests import ClientDisconnect, Request
from starlette.responses import JSONResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from sketch2shape.ui import share
from sketch2shape.ui.hosts import host_name

_HEADERS = {
    "Content-Security-Policy": "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; "
    "connect-src 'self'; form-action 'none'; frame-ancestors 'none'; base-uri 'none'",
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cache-Control": "no-store",
}
_BODY_SECONDS = 30.0


class Refusal(Exception):  # noqa: N818 - it is an answer, not a failure of the program
    """A request that is not served: HTTP status and plain words for the page."""

    def __init__(self, status: int, message: str, advice: str = "reload the page") -> None:
        """Keep what to answer."""
        super().__init__(message)
        self.status, self.message, self.advice = status, message, advice

    def response(self) -> JSONResponse:
        """The answer as JSON; the connection is closed, since the rest of the body may not have been read."""
        return JSONResponse(
            {"error": self.message, "advice": self.advice}, status_code=self.status, headers={"Connection": "close"}
        )


class Guard:
    """ASGI middleware: checks Host and Origin, and adds the headers that keep the page to itself."""

    def __init__(self, app: ASGIApp, names: frozenset[str], key: str | None = None) -> None:
        """Let requests through that are addressed to one of `names` (without port, IPv6 in brackets).

        key : if given, only those who have shown it are served, see `share`
        """
        self.app, self.names, self.key = app, frozenset(n.lower() for n in names), key

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Serve or refuse one request."""
        if scope["type"] == "lifespan":
            await self.app(scope, receive, send)
            return
        if scope["type"] != "http":  # no web sockets here
            await send({"type": "websocket.close", "code": 1008})
            return

        async def send_guarded(message: Message) -> None:
            if message["type"] == "http.response.start":
                extra = [(k.lower().encode(), v.encode()) for k, v in _HEADERS.items()]
                message = {**message, "headers": [*message.get("headers", []), *extra]}
            await send(message)

        refusal = self._refusal(scope)
        target: ASGIApp = self.app if refusal is None else refusal.response()
        if refusal is None and self.key is not None:
            target = share.refusal(scope, self.key) or target
        await target(scope, receive, send_guarded)

    def _refusal(self, scope: Scope) -> Refusal | None:
        headers = [(k.lower(), v.decode("latin-1")) for k, v in scope["headers"]]
        hosts = [v for k, v in headers if k == b"host"]
        if len(hosts) != 1 or host_name(hosts[0]) not in self.names:
            return Refusal(421, "this address is not served here", "open the address that the command printed")
        if scope["method"] in ("GET", "HEAD"):
            return None
        origins = [v for k, v in headers if k == b"origin"]
        if any(o not in (f"http://{hosts[0]}", f"https://{hosts[0]}") for o in origins):
            return Refusal(403, "the request comes from another page")
        if any(k == b"sec-fetch-site" and v not in ("same-origin", "none") for k, v in headers):
            return Refusal(403, "the request comes from another page")
        return None


class Uploads:
    """Bodies that are in memory: of one at most `each` bytes are read, and together they take at most `together`."""

    def __init__(self, each: int, together: int = 512 * 2**20) -> None:
        """Hold nothing yet."""
        self.each, self._together, self._held = each, max(together, each), 0

    @asynccontextmanager
    async def body(self, request: Request, kinds: tuple[str, ...], most: int | None = None) -> AsyncIterator[bytes]:
        """The request's body, of one of these media types ("image/" admits all of its kind), held while it is used.

        most : bytes, where it is not `each`

        Raises Refusal.
        """
        most = self.each if most is None else most
        _check_kind(request, kinds, most)
        held = _Held(self)
        try:
            try:
                async with asyncio.timeout(_BODY_SECONDS):
                    data = await held.read(request, most)
            except TimeoutError as error:
                raise Refusal(408, "the upload took too long", "try again") from error
            except ClientDisconnect as error:
                raise Refusal(400, "the upload was cut off", "try again") from error
            yield data
        finally:
            self._held -= held.size

    def hold(self, size: int) -> None:
        """Count bytes in. Raises Refusal if they are too many."""
        if self._held + size > self._together:
            raise Refusal(503, "too much is being sent at once", "wait a moment and try again")
        self._held += size


class _Held:
    """One body on its way."""

    def __init__(self, uploads: Uploads) -> None:
        self.uploads, self.size = uploads, 0

    async def read(self, request: Request, most: int) -> bytes:
        chunks = []
        async for chunk in request.stream():
            if self.size + len(chunk) > most:
                raise _too_large(most)
            self.uploads.hold(len(chunk))
            self.size += len(chunk)
            chunks.append(chunk)
        return b"".join(chunks)


def _check_kind(request: Request, kinds: tuple[str, ...], most: int) -> None:
    """Refuse a body by what its head says of it."""
    kind = request.headers.get("content-type", "").partition(";")[0].strip().lower()
    if not any(kind == k or (k.endswith("/") and kind.startswith(k)) for k in kinds):
        raise Refusal(415, f"a body of type {kind[:60] or 'none'!r} is not taken here", "send " + " or ".join(kinds))
    length = request.headers.get("content-length", "0")
    if not length.isdigit() or int(length[:20]) > most:
        raise _too_large(most)


def _too_large(most: int) -> Refusal:
    return Refusal(413, f"the upload is larger than {most / 2**20:g} MB", "use a smaller picture")
