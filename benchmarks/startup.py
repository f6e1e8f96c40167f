"""From the shell: the command on one drawing, help, version, the import."""

from __future__ import annotations

from pathlib import Path

from benchmarks import subjects
from benchmarks.timing import Report, Table, in_turn, python, times, tool


def startup(scratch: Path, quick: bool) -> Report:
    """Wall time of fresh processes, each over the import that bounds it."""
    drawing = str(subjects.small_drawings(scratch, 1)[0])
    out = str(scratch / "startup.obj")
    t = in_turn(
        {
            "command": tool(drawing, "-o", out, "--overwrite"),
            "cv2, numpy, trimesh": python("import cv2, numpy, trimesh"),
            "--help": tool("--help"),
            "--version": tool("--version"),
            "argparse": python("import argparse"),
            "import": python("import sketch2shape"),
            "numpy": python("import numpy"),
        },
        5 if quick else 11,
    )
    rows = [
        [
            "`sketch2shape drawing.png -o solid.obj`",
            "`import cv2, numpy, trimesh`",
            times(t["command"] / t["cv2, numpy, trimesh"]),
            "0.9",
        ],
        ["`sketch2shape --help`", "`import argparse`", times(t["--help"] / t["argparse"]), "1.5"],
        ["`sketch2shape --version`", "`import argparse`", times(t["--version"] / t["argparse"]), "1.5"],
        ["`import sketch2shape`", "`import numpy`", times(t["import"] / t["numpy"]), "0.5"],
    ]
    return Report([Table("From the shell", "Whole processes, start to end.", ["", "over", "times", "goal"], rows)])
