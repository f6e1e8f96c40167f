"""Sharing the page with a local network: who holds the key may come in.

The key is made anew at each start and is part of the address that the command prints. The first visit puts it into a
cookie and takes it out of the address. Host, origin and all else are checked as they are without sharing. There is no
encryption: who can listen to the network's traffic can read the key and the drawings.
"""

from __future__ import annotations

import hmac
import io
import secrets
import socket
from http.cookies import CookieError, SimpleCookie
from urllib.parse import parse_qs

from starlette.responses import PlainTextResponse, RedirectResponse, Response
from starlette.types import Scope

from sketch2shape.errors import MissingPackageError

COOKIE = "sketch2shape-key"
_KEY_BYTES = 16


def new_key() -> str:
    """A key that nobody guesses."""
    return secrets.token_urlsafe(_KEY_BYTES)


def refusal(scope: Scope, key: str) -> Response | None:
    """What is answered instead of the page: None to who has shown the key before, the cookie to who shows it now."""
    headers = {name.lower(): value.decode("latin-1") for name, value in scope["headers"]}
    if _is(_cookie(headers.get(b"cookie", "")), key):
        return None
    shown = parse_qs(scope["query_string"].decode("latin-1")).get("key", [""])[0]
    if scope["method"] == "GET" and scope["path"] == "/" and _is(shown, key):
        welcome = RedirectResponse("/", status_code=303)
        welcome.set_cookie(COOKIE, key, httponly=True, samesite="lax")
        return welcome
    words = "This page is shared with a key. Open the whole address that the command printed, or scan its code.\n"
    return PlainTextResponse(words, status_code=403, headers={"Connection": "close"})


def _cookie(header: str) -> str:
    try:
        found = SimpleCookie(header).get(COOKIE)
    except CookieError:
        return ""
    return "" if found is None else found.value


def _is(shown: str, key: str) -> bool:
    return hmac.compare_digest(shown.encode("utf-8", "replace"), key.encode())


def local_address() -> str:
    """This machine's address in its network, "127.0.0.1" if it is in none; nothing is sent to find out."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            probe.connect(("192.0.2.1", 9))  # a documentation address (RFC 5737): only the route is looked up
        except OSError:
            return "127.0.0.1"
        return str(probe.getsockname()[0])


def code_of(address: str) -> str:
    """A QR code of an address, to be printed in a terminal. Raises MissingPackageError."""
    try:
        import segno
    except ImportError as error:
        raise MissingPackageError("--share needs the package segno", remedy="pip install 'sketch2shape[ui]'") from error
    drawn = io.StringIO()
    segno.make(address, micro=False).terminal(drawn, compact=True)
    return drawn.getvalue()
