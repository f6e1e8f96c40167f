"""Run campaigns and write what came of them: python -m benchmarks.faults [NAME...] [--part 0.1]

--part F     only this part of the full size
--page FILE  where the results go (default docs/robustness.md); those of campaigns not run now are kept
"""

from __future__ import annotations

import argparse
import json
import platform
import sys
import time
from collections.abc import Callable
from pathlib import Path

from benchmarks.faults import bombs, kills, leak, names, rasters, reader, storm

_PAGE = Path(__file__).parents[2] / "docs" / "robustness.md"

CAMPAIGNS: dict[str, tuple[Callable[..., dict[str, object]], int | None]] = {
    "reader": (reader.run, 100_000),
    "rasters": (rasters.run, 5_000),
    "bombs": (bombs.run, None),
    "storm": (storm.run, 1_000),
    "kills": (kills.run, 100),
    "names": (names.run, 500),
    "leak": (leak.run, 2_000),
}

_HEAD = """# Robustness

Campaigns of damage and what came of them: `python -m benchmarks.faults` (see there for parts). An empty list of
findings is the aim. `python -m benchmarks.faults.coverage_guided` needs atheris and runs apart.
"""


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", help=f"some of {', '.join(CAMPAIGNS)}; default: all")
    parser.add_argument("--part", type=float, default=1.0)
    parser.add_argument("--page", type=Path, default=_PAGE)
    arguments = parser.parse_args()
    found = 0
    for name in arguments.names or CAMPAIGNS:
        run, size = CAMPAIGNS[name]
        begin = time.monotonic()
        outcome = run() if size is None else run(max(1, round(size * arguments.part)))
        outcome = {
            **outcome,
            "took, s": round(time.monotonic() - begin),
            "with": f"Python {platform.python_version()} on {platform.system()}",
        }
        found += len(outcome["findings"])  # type: ignore[arg-type]
        print(name, json.dumps(outcome, indent=1, ensure_ascii=True), flush=True)
        _record(arguments.page, name, (sys.modules[run.__module__].__doc__ or "").strip(), outcome)
    return int(found > 0)


def _record(page: Path, name: str, what: str, outcome: dict[str, object]) -> None:
    """Put a campaign's result in the page, in the place of its last one."""
    text = page.read_text() if page.exists() else _HEAD
    lines = "".join(f"- {key}: {json.dumps(value)}\n" for key, value in outcome.items())
    section = f"\n## {name}\n\n{what}\n\n{lines}"
    head, *sections = text.split("\n## ")
    kept = {s.partition("\n")[0]: "\n## " + s for s in sections}
    kept[name] = section.rstrip("\n") + "\n"
    page.parent.mkdir(exist_ok=True)
    page.write_text(head + "".join(kept[key] for key in sorted(kept)))


if __name__ == "__main__":
    sys.exit(main())
