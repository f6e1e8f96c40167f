"""Thirty fresh browsers open a drawing at once: `python scripts/class_of_thirty.py [COUNT]`.

Each is a user context of its own in one Chromium, without anything kept, and opens a link that holds a box. Prints
how many pages came whole (all examples, no error in the console) and how many showed the solid. Exits 1 unless all did.
"""

from __future__ import annotations

import base64
import json
import sys
import time
import zlib
from pathlib import Path

REPOSITORY = Path(__file__).parents[1]
sys.path.insert(0, str(REPOSITORY / "tests" / "ui"))

from chromium import start_browser  # noqa: E402
from draw_by_hand import SOLIDS  # noqa: E402
from server import start_app  # noqa: E402

SECONDS = 300.0
"""Longest wait for all of them."""
_WHOLE = "return document.querySelectorAll('#gallery img').length > 5 && !!window.timings"
_SOLID = "return Number(document.getElementById('facts').dataset.volume) > 0"


def link_of(name: str, side: float) -> str:
    """The part of the address that holds a solid of `draw_by_hand`, as the page packs it."""
    front, way = SOLIDS[name]
    f1 = [(round(10 * x * side), round(10 * y * side)) for x, y in front]
    f2 = [(x + round(10 * way[0] * side), y + round(10 * way[1] * side)) for x, y in f1]
    n = len(f1)
    edges = [(f[i], f[(i + 1) % n]) for f in (f1, f2) for i in range(n)] + list(zip(f1, f2, strict=True))
    strokes = [[0, *a, *b] for a, b in edges]
    deflate = zlib.compressobj(wbits=-15)
    packed = deflate.compress(json.dumps([1, strokes, []]).encode()) + deflate.flush()
    return "#d=" + base64.urlsafe_b64encode(packed).decode().rstrip("=")


def main(count: int) -> int:
    link = link_of("box", 300.0)
    with start_app() as address, start_browser(many=True) as browser:
        first = browser.current_window_handle
        begin = time.monotonic()
        for _ in range(count):
            context = browser.browser.create_user_context()
            page = browser.browsing_context.create(type="tab", user_context=context)
            browser.browsing_context.navigate(page, address + link, wait="none")
        handles = [h for h in browser.window_handles if h != first]
        whole: set[str] = set()
        solid: set[str] = set()
        while (len(whole) < count or len(solid) < count) and time.monotonic() - begin < SECONDS:
            for handle in handles:
                browser.switch_to.window(handle)
                whole |= {handle} if browser.execute_script(_WHOLE) else set()
                solid |= {handle} if browser.execute_script(_SOLID) else set()
            time.sleep(0.5)
        errors = 0
        for handle in handles:
            browser.switch_to.window(handle)
            errors += sum(line["level"] == "SEVERE" for line in browser.get_log("browser"))
        seconds = time.monotonic() - begin
    print(f"{count} browsers: {len(whole)} pages whole, {len(solid)} solids, {errors} errors, {seconds:.0f} s")
    return int(len(whole) < count or len(solid) < count or errors > 0)


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1]) if len(sys.argv) > 1 else 30))
