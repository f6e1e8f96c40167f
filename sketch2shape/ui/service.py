"""Start the HTTP service: `sketch2shape serve`."""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Sequence

from sketch2shape.errors import MissingPackageError, UsageError
from sketch2shape.ui.hosts import LOCAL_NAMES


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
        from sketch2shape.ui.api import create_service
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
