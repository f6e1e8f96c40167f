"""How many solids come right that are drawn on the page by a hand that misses.

    python scripts/draw_by_hand.py [EACH] [--screen mouse] [--solid box] [--failures FOLDER]

A row is printed as soon as its drawings are done, the table at the end; EACH drawings (10) of each solid take about
a minute for two. Drawing K of a solid is the same in every run, so a part may be run alone.

Solids are drawn in Chromium, with the mouse on a laptop's screen and with a finger on a phone's, every stroke's ends
missed by a normal error (4 and 3 CSS pixels for each coordinate) and its way wavering by a third of that. Right is an
answer with the right number of vertices, each within 8 % of the drawing's diagonal of its true place, that is no guess;
of the cylinder, whose outline has to be as wide and high to within as much, its name.

What the search of every one of these sketches computes is measured again without a browser, and of a whole prism with
ten sides, which has 30 strokes.
"""

from __future__ import annotations

import argparse
import json
import math
import sys
import time
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

REPOSITORY = Path(__file__).parents[1]
sys.path.insert(0, str(REPOSITORY / "tests" / "ui"))

from chromium import start_browser  # noqa: E402
from selenium.common.exceptions import TimeoutException  # noqa: E402
from selenium.webdriver import Chrome  # noqa: E402
from selenium.webdriver.common.by import By  # noqa: E402
from server import start_app  # noqa: E402

from sketch2shape.ui.jobs import reconstruct_sketch, warm_up  # noqa: E402

NEAR = 0.08
"""Farthest that a vertex may be from its true place, as a fraction of the drawing's diagonal."""
LEAST_STROKES = 4
"""Sketches of no more strokes are left out where computing is measured: the page asks for few of them."""
KEPT = 10.0
"""Milliseconds up to which a solid was there already: the new stroke is one of its edges."""
BETWEEN = 0.2
"""Seconds between two strokes at least."""
MOST_MEASURED = 240
"""Sketches, evenly chosen, whose computing is measured."""
STEPS = 14
"""Places along a stroke that the pointer is told."""
LONGEST = 20.0
"""Seconds that the page may take for anything; what takes longer has failed."""


class Screen(NamedTuple):
    """Where it is drawn: name, size in CSS pixels, the pointer, and by how much the hand misses, pixels."""

    name: str
    width: int
    height: int
    touch: bool
    error: float


SCREENS = (Screen("mouse, 1366 x 768", 1366, 768, False, 4.0), Screen("touch, 360 x 640", 360, 640, True, 3.0))

#: name -> front face in units of the sheet's lesser side, y down, and the way to the back face
SOLIDS: dict[str, tuple[list[tuple[float, float]], tuple[float, float]]] = {
    "box": ([(0.1, 0.4), (0.6, 0.4), (0.6, 0.85), (0.1, 0.85)], (0.3, -0.24)),
    "L": ([(0.1, 0.3), (0.32, 0.3), (0.32, 0.6), (0.62, 0.6), (0.62, 0.88), (0.1, 0.88)], (0.28, -0.2)),
    "house": ([(0.06, 0.5), (0.3, 0.28), (0.54, 0.5), (0.54, 0.9), (0.06, 0.9)], (0.36, -0.14)),
    "wedge": ([(0.1, 0.85), (0.62, 0.85), (0.62, 0.42)], (0.28, -0.24)),
    "hexagonal prism": (
        [(0.4 + 0.28 * math.cos(t), 0.72 + 0.16 * math.sin(t)) for t in np.arange(6) * math.pi / 3 + 0.2],
        (0.0, -0.48),
    ),
}
CYLINDER = (0.45, 0.75, 0.3, 0.11, 0.5)
"""Centre, half axes and height of the standing cylinder, in the same units."""
SEEDS = {name: k for k, name in enumerate([*SOLIDS, "cylinder"])}
"""What the drawings of each solid are drawn at random with."""


def strokes_of(name: str, side: float) -> tuple[list[list[tuple[float, float]]], list[tuple[float, float]]]:
    """The strokes as paths of places on the sheet, and the true vertices (of a cylinder the points of its rims)."""
    if name == "cylinder":
        x, y, a, b, h = (c * side for c in CYLINDER)
        turns = np.linspace(0.4, 0.4 + 2 * math.pi, 40)
        rims = [[(x + a * math.cos(t), y - up + b * math.sin(t)) for t in turns] for up in (0.0, h)]
        sides = [[(x + s * a, y), (x + s * a, y - h)] for s in (-1, 1)]
        return [*rims, *sides], [place for rim in rims for place in rim]
    front, way = SOLIDS[name]
    f1 = [(x * side, y * side) for x, y in front]
    f2 = [(x + way[0] * side, y + way[1] * side) for x, y in f1]
    n = len(f1)
    rings = [[f[i], f[(i + 1) % n]] for f in (f1, f2) for i in range(n)]
    return [*rings[:n], *([p, q] for p, q in zip(f1, f2, strict=True)), *rings[n:]], f1 + f2


def by_hand(path: list[tuple[float, float]], error: float, rng: np.random.Generator) -> np.ndarray:
    """Where the pointer goes: the ends missed, the way between wavering, smoothly."""
    points = np.array(path, float)
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    count = max(STEPS, len(path))
    at = np.linspace(0.0, 1.0, count)
    places = np.stack([np.interp(at * along[-1], along, points[:, c]) for c in (0, 1)], axis=1)
    missed = rng.normal(0.0, error, (2, 2))
    waver = rng.normal(0.0, error / 3, (count, 2))
    waver = (waver + np.roll(waver, 1, axis=0) + np.roll(waver, -1, axis=0)) / 3
    return places + (1 - at)[:, None] * missed[0] + at[:, None] * missed[1] + waver


def pointer(page: Chrome, kind: str, x: float, y: float, touch: bool) -> None:
    """One event of the real browser's input."""
    if touch:
        points = [] if kind == "up" else [{"x": x, "y": y, "radiusX": 9, "radiusY": 9}]
        event = {"down": "touchStart", "move": "touchMove", "up": "touchEnd"}[kind]
        page.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": event, "touchPoints": points})
        return
    event = {"down": "mousePressed", "move": "mouseMoved", "up": "mouseReleased"}[kind]
    page.execute_cdp_cmd(
        "Input.dispatchMouseEvent",
        {"type": event, "x": x, "y": y, "button": "left", "buttons": 0 if kind == "up" else 1, "clickCount": 1},
    )


def stroke(page: Chrome, path: np.ndarray, touch: bool) -> None:
    """One stroke of the pen over the screen."""
    for k, (x, y) in enumerate(path.tolist()):
        pointer(page, "move" if k else "down", x, y, touch)
    pointer(page, "up", *path[-1].tolist(), touch)


def show_screen(page: Chrome, screen: Screen) -> None:
    size = {"width": screen.width, "height": screen.height, "deviceScaleFactor": 1, "mobile": screen.touch}
    page.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size)
    page.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": screen.touch, "maxTouchPoints": 2})


def until(page: Chrome, done: str, pause: float, seconds: float = LONGEST) -> None:
    """Wait until the page says that it is done, after a pause. Raises TimeoutException."""
    end = time.monotonic() + seconds
    time.sleep(pause)
    while not page.execute_script(f"return {done}"):
        if time.monotonic() > end:
            raise TimeoutException(f"the page did not come to {done}")
        time.sleep(0.02)


def settled(page: Chrome) -> None:
    """Wait until the solid of the last stroke is there."""
    until(page, "!timings.busy()", 0.15)


def looked_at(page: Chrome) -> None:
    """Let the hand go to where the next stroke begins, until a solid of these strokes is there, or none is."""
    until(page, "!timings.live().searching()", BETWEEN)


def is_right(name: str, state: dict[str, Any], truth: np.ndarray) -> bool:
    """Are the vertices those of the solid that was meant?"""
    if state["guess"] or len(state["objects"]) != 1:
        return False
    found = state["objects"][0]
    if name == "cylinder":
        outline = np.concatenate([arc["points"] for arc in found["arcs"]] or [np.zeros((1, 2))])
        off = [outline.min(axis=0) - truth.min(axis=0), outline.max(axis=0) - truth.max(axis=0)]
        reach = NEAR * float(np.linalg.norm(np.ptp(truth, axis=0)))
        return str(state["shape"]) == "cylinder" and float(np.abs(off).max()) < reach
    vertices = np.array(found["f1"] + found["f2"])
    if vertices.shape != truth.shape or found["holes"]:
        return False
    gaps = np.linalg.norm(vertices[:, None] - truth[None], axis=2)
    reach = NEAR * float(np.linalg.norm(np.ptp(truth, axis=0)))
    return bool((gaps.min(axis=0) < reach).all() and len(set(gaps.argmin(axis=1).tolist())) == len(truth))


def open_pad(page: Chrome, address: str) -> None:
    """A fresh page, its sheet open."""
    page.get(address)
    page.execute_async_script("const d = arguments[0], t = () => window.timings ? d() : setTimeout(t, 50); t()")
    page.find_element(By.ID, "start-draw").click()


def draw_one(page: Chrome, name: str, screen: Screen, rng: np.random.Generator, sketches: list[Any]) -> bool:
    """Draw a solid and say whether it came right; the strokes after each stroke are added to the sketches."""
    page.execute_script("window.timings.fresh()")
    x, y, width, height = page.execute_script(
        "const r = document.getElementById('pad').getBoundingClientRect(); return [r.x, r.y, r.width, r.height]"
    )
    side = 0.94 * min(width, height)
    paths, truth = strokes_of(name, side)
    for path in paths:
        stroke(page, by_hand(path, screen.error, rng) + (x + 6, y + 6), screen.touch)
        looked_at(page)
        sketches.append(json.loads(page.execute_script("return JSON.stringify(timings.state().strokes)")))
    settled(page)
    known = "return JSON.stringify({...timings.state(), shape: timings.facts()[0]?.shape})"
    state = json.loads(page.execute_script(known))
    return is_right(name, state, np.array(truth) + 6)


def draw_all(page: Chrome, name: str, screen: Screen, each: int, sketches: list[Any], failures: Path | None) -> int:
    """How many of the drawings of a solid come right; pictures of the others go to a folder if one is given."""
    right = 0
    for k in range(each):
        rng = np.random.default_rng([k, SEEDS[name], screen.width])
        try:
            good = draw_one(page, name, screen, rng, sketches)
        except TimeoutException as late:
            print(f"{name}, {k}: {late.msg}", flush=True)
            good = False
        if failures and not good:
            page.save_screenshot(str(failures / f"{name}-{screen.width}-{k}.png".replace(" ", "-")))
            (failures / f"{name}-{screen.width}-{k}.json".replace(" ", "-")).write_text(json.dumps(sketches[-1]))
        right += good
    return right


def computing(strokes: list[Any], times: int = 1) -> tuple[float, bool]:
    """Least milliseconds of computing that the server's search of these strokes takes, and whether it gives a solid."""
    spent = []
    for _ in range(times):
        begin = time.process_time()
        found = reconstruct_sketch({"strokes": strokes})
        spent.append(1000 * (time.process_time() - begin))
    return min(spent), bool(found["objects"])


def ten_sided() -> list[Any]:
    """The 30 strokes of a prism, as the page sends them."""
    turns = np.arange(10) * math.pi / 5 + 0.2
    low = [(300 + 170 * math.cos(t), 420 + 75 * math.sin(t)) for t in turns]
    high = [(x + 40, y - 260) for x, y in low]
    rings = [[ring[k], ring[(k + 1) % 10]] for ring in (low, high) for k in range(10)]
    return [{"points": line} for line in [*rings, *zip(low, high, strict=True)]]


def tell_computing(sketches: list[Any]) -> None:
    """Print what searches compute."""
    warm_up()
    whole = ten_sided()
    computing(whole)
    some = [s for s in sketches if len(s) > LEAST_STROKES]
    found = [computing(s) for s in some[:: 1 + len(some) // MOST_MEASURED]]
    spent = [ms for ms, some in found if some]
    print(f"\nComputing of a search that gives a solid: median {np.median(spent):.0f} ms, nine in ten ", end="")
    print(f"{np.percentile(spent, 90):.0f} ms ({len(spent)} sketches); of 30 strokes {computing(whole, 5)[0]:.0f} ms.")


def tell_waits(waits: list[float]) -> None:
    """Print how long solids take, milliseconds from the end of a stroke."""
    median, most = np.percentile(waits, [50, 90])
    searched = [ms for ms in waits if ms > KEPT]
    print(
        f"\nFrom the end of a stroke until a solid of all strokes is there: median {median:.0f} ms, nine in ten ",
        end="",
    )
    print(f"{most:.0f} ms ({len(waits)} strokes); where it was not there already ({len(searched)} strokes): ", end="")
    print(f"median {np.median(searched):.0f} ms.")


def main(each: int, screens: list[Screen], names: list[str], failures: Path | None) -> None:
    table: dict[str, list[int]] = {name: [] for name in names}
    waits: list[float] = []
    sketches: list[Any] = []
    with start_app() as address, start_browser() as page:
        page.set_page_load_timeout(LONGEST)
        page.set_script_timeout(LONGEST)
        for screen in screens:
            show_screen(page, screen)
            open_pad(page, address)
            for name in names:
                begin = time.monotonic()
                table[name].append(draw_all(page, name, screen, each, sketches, failures))
                took = time.monotonic() - begin
                print(f"{screen.name}: {name}, {table[name][-1]} of {each} in {took:.0f} s", flush=True)
            waits += page.execute_script("return window.timings.live().waits")
    print("\n| solid | " + " | ".join(s.name for s in screens) + " |\n|---|" + "---|" * len(screens))
    for name, right in table.items():
        print(f"| {name} | " + " | ".join(f"{r} of {each}" for r in right) + " |")
    sums = [sum(column) for column in zip(*table.values(), strict=True)]
    print("| all | " + " | ".join(f"{s} of {each * len(names)}" for s in sums) + " |", flush=True)
    tell_waits(waits)
    tell_computing(sketches)


def wanted() -> argparse.Namespace:
    """What the command line asks for."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("each", nargs="?", type=int, default=10, help="drawings of each solid on each screen")
    parser.add_argument("--screen", choices=[s.name.split(",")[0] for s in SCREENS], help="only this one")
    parser.add_argument("--solid", choices=SEEDS, help="only this one")
    parser.add_argument("--failures", type=Path, help="folder for pictures and strokes of what did not come right")
    return parser.parse_args()


if __name__ == "__main__":
    asked = wanted()
    if asked.failures:
        asked.failures.mkdir(parents=True, exist_ok=True)
    main(
        asked.each,
        [s for s in SCREENS if s.name.startswith(asked.screen or "")],
        [asked.solid] if asked.solid else list(SEEDS),
        asked.failures,
    )
