"""Start the web app on this machine: `sketch2shape ui`."""

from __future__ import annotations

import argparse
import socket
import sys
import threading
import webbrowser
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from sketch2shape.errors import MissingPackageError, UsageError
from sketch2shape.ui.hosts import LOCAL_NAMES

if TYPE_CHECKING:
    from starlette.applications import Starlette


#: addresses that mean every one of this machine
_ANY = ("0.0.0.0", "::")

#: connections at a time, of which each takes a file descriptor: processes have 1,024; work is limited by the workers
_MOST_CONNECTIONS = 800


def build_parser() -> argparse.ArgumentParser:
    """The options of `sketch2shape ui`."""
    parser = argparse.ArgumentParser(
        prog="sketch2shape ui",
        description="See drawings turn into solids, and put them right by hand, in the browser. "
        "Everything stays on this machine.",
    )
    parser.add_argument(
        "--host", default="127.0.0.1", help="address to listen on (default 127.0.0.1: this machine only)"
    )
    parser.add_argument("--port", type=int, default=8765, help="port, 0 for any free one (default 8765)")
    parser.add_argument(
        "--allow-host",
        metavar="NAME",
        action="append",
        default=[],
        help="also answer to this host name (may be repeated)",
    )
    parser.add_argument(
        "--share",
        action="store_true",
        help="serve the local network: prints an address with a key and its QR code; only who has the key comes in",
    )
    parser.add_argument("--no-browser", action="store_true", help="do not open the browser")
    parser.add_argument("--max-upload", metavar="MB", type=float, default=24, help="largest picture taken (default 24)")
    parser.add_argument("--timeout", metavar="S", type=float, default=60, help="seconds for one picture (default 60)")
    return parser


def main(argv: Sequence[str] | None = None) -> int:
    """Run `sketch2shape ui` with these arguments until it is interrupted; returns the exit code."""
    options = build_parser().parse_args(argv)
    host = "0.0.0.0" if options.share and options.host == "127.0.0.1" else options.host
    serve(
        host,
        options.port,
        names=LOCAL_NAMES | set(options.allow_host),
        max_upload=int(options.max_upload * 2**20),
        seconds=options.timeout,
        share=options.share,
        on_start=_announce if options.no_browser else _announce_and_open,
    )
    return 0


def serve(
    host: str = "127.0.0.1",
    port: int = 8765,
    *,
    names: frozenset[str] | set[str] = LOCAL_NAMES,
    max_upload: int = 24 * 2**20,
    seconds: float = 60.0,
    share: bool = False,
    on_start: Callable[[str], None] = lambda _: None,
) -> None:
    """Serve the app until interrupted.

    host, port : where to listen; port 0 takes any free one
    names      : host names to answer to; `host` itself is added
    max_upload : largest picture taken, bytes
    seconds    : time limit for one picture
    share      : let in only who shows a key that is made now, and print its QR code
    on_start   : told the app's address once it can be opened

    Raises UsageError if the address cannot be used, MissingPackageError without the extra `ui`.
    """
    try:
        import uvicorn  # noqa: F401  (said now if it is missing)

        from sketch2shape.ui.app import create_app
        from sketch2shape.ui.share import code_of, local_address, new_key
    except ImportError as error:
        raise MissingPackageError(
            f"the web app needs the package {error.name}", remedy="pip install 'sketch2shape[ui]'"
        ) from error
    if not (0 <= port < 65536 and max_upload > 0 and seconds > 0):
        raise UsageError("port, upload size and time limit must be positive and a port below 65536")
    listening = listen(host, port)
    named = local_address() if share and host in _ANY else host
    bracketed = f"[{named}]" if ":" in named else named
    key = new_key() if share else None
    app = create_app(names=frozenset(names) | {bracketed}, max_upload=max_upload, seconds=seconds, key=key)
    address = f"http://{bracketed}:{listening.getsockname()[1]}/" + (f"?key={key}" if share else "")
    if share:
        sys.stdout.write(code_of(address) + "\n")
    on_start(address)
    run_app(app, listening)


def run_app(app: Starlette, listening: socket.socket) -> None:
    """Serve an app on a socket that listens, until interrupted."""
    import uvicorn

    from sketch2shape.ui.protocol import ImpatientProtocol

    config = uvicorn.Config(
        app,
        access_log=False,
        log_level="critical",  # what goes wrong is said on the page; a visitor who hangs up is no news
        server_header=False,
        ws="none",
        http=ImpatientProtocol,
        loop="asyncio",
        lifespan="on",
        limit_concurrency=_MOST_CONNECTIONS,
        timeout_keep_alive=5,
        timeout_graceful_shutdown=2,
    )
    uvicorn.Server(config).run(sockets=[listening])


def listen(host: str, port: int) -> socket.socket:
    """A socket that listens on the address. Raises UsageError."""
    try:
        family, kind, _, _, address = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)[0]
        listening = socket.socket(family, kind)
        listening.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        listening.bind(address)
        listening.listen(512)
    except OSError as error:
        raise UsageError(
            f"cannot listen on {host} port {port} ({error.strerror or error})", remedy="another --port, or --port 0"
        ) from error
    return listening


def _announce(address: str) -> None:
    sys.stdout.write(f"sketch2shape is at {address}  (Ctrl-C stops it)\n")
    sys.stdout.flush()


def _announce_and_open(address: str) -> None:
    _announce(address)
    threading.Timer(0.7, webbrowser.open, [address]).start()
