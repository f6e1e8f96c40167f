"""The app and the browser in a network namespace that has nothing but its own loopback: no request can leave it."""

from __future__ import annotations

import shutil
import subprocess
import sys

import pytest

from .chromium import missing

_INSIDE = """
ip link set lo up || exit 90
[ "$(ip -o link | wc -l)" = 1 ] || exit 91
cd tests/ui || exit 92
exec "$0" -m pytest -q -p no:cacheprovider test_browser.py test_pad.py -k "upload_drag or box_is_drawn or asks_nobody"
"""


def _lacking() -> str | None:
    """Why this cannot be tried here, or None."""
    for tool in ("unshare", "ip"):
        if shutil.which(tool) is None:
            return f"{tool} is not installed (Debian: util-linux, iproute2)"
    trial = subprocess.run(["unshare", "--net", "ip", "link", "set", "lo", "up"], capture_output=True, check=False)
    return None if trial.returncode == 0 else "no right to make a network namespace"


pytestmark = pytest.mark.skipif((missing() or _lacking()) is not None, reason=str(missing() or _lacking()))


def test_everything_works_with_loopback_only(pytestconfig: pytest.Config) -> None:
    command = ["unshare", "--net", "sh", "-c", _INSIDE, sys.executable]
    done = subprocess.run(command, cwd=pytestconfig.rootpath, capture_output=True, text=True, timeout=600, check=False)
    if "3 skipped" in done.stdout:
        pytest.skip(done.stdout[-300:])
    assert done.returncode == 0, done.stdout[-3000:] + done.stderr[-2000:]
    assert "3 passed" in done.stdout
