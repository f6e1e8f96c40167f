"""Time everything and write docs/performance.md.

python -m benchmarks             all parts (several minutes)
python -m benchmarks --quick     fewer rounds and files
python -m benchmarks --parts warm startup --page ''
"""

from __future__ import annotations

import argparse
import os
import shlex
import sys
import tempfile
from pathlib import Path

os.environ.setdefault("OMP_NUM_THREADS", "1")

import cv2

from benchmarks import folder, page, peers, single, startup

PARTS = {
    "warm": single.warm,
    "startup": startup.startup,
    "folder": folder.folder,
    "growth": single.growth,
    "hard": single.hard,
    "tracers": peers.tracers,
    "connectors": peers.connectors,
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true", help="fewer rounds and files")
    parser.add_argument("--parts", nargs="+", choices=PARTS, default=list(PARTS))
    parser.add_argument("--page", default=str(page.PAGE), help="'' writes none")
    args = parser.parse_args()
    cv2.setNumThreads(1)
    reports = []
    for name in args.parts:
        with tempfile.TemporaryDirectory() as scratch:
            reports.append(PARTS[name](Path(scratch), args.quick))
        for table in reports[-1].tables:
            print(page.text_of(table))
    if args.page:
        page.write(Path(args.page), reports, shlex.join(["python", "-m", "benchmarks", *sys.argv[1:]]))


if __name__ == "__main__":
    main()
