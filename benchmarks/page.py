"""The page docs/performance.md and its plots."""

from __future__ import annotations

import platform
from collections.abc import Sequence
from pathlib import Path

from benchmarks.timing import Plot, Report, Table

PAGE = Path(__file__).resolve().parent.parent / "docs" / "performance.md"
INTRO = """# Performance

Written by `python -m benchmarks`; do not edit. Made with

    {command}

Every figure is a ratio of two times (or of a size and its limit) measured in the same run on the same data, medians
of several runs taken in turn. OpenCV and OpenMP use one thread. Python {python}, {machine}.
"""


def text_of(table: Table) -> str:
    """A table as Markdown, with its title and words."""
    lines = [table.head, ["---", *["---:"] * (len(table.head) - 1)], *table.rows]
    body = "\n".join("| " + " | ".join(line) + " |" for line in lines)
    return f"## {table.title}\n\n{table.words}\n\n{body}\n"


def write(path: Path, reports: Sequence[Report], command: str) -> None:
    """Write the page and a picture for each plot."""
    path.parent.mkdir(parents=True, exist_ok=True)
    parts = [INTRO.format(command=command, python=platform.python_version(), machine=platform.machine())]
    for report in reports:
        parts += [text_of(table) for table in report.tables]
        for plot in report.plots:
            name = f"performance_{plot.name}.svg"
            if _draw(plot, path.parent / name):
                parts.append(f"![time against {plot.x}]({name})\n")
    path.write_text("\n".join(parts).rstrip() + "\n")


def _draw(plot: Plot, path: Path) -> bool:
    """Draw a plot, unless matplotlib is not installed."""
    try:
        import matplotlib as mpl
    except ImportError:
        return False

    mpl.use("svg")
    mpl.rcParams["svg.hashsalt"] = "sketch2shape"
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(4.5, 3.2), layout="constrained")
    for label, (x, y) in plot.curves.items():
        axes.loglog(x, y, "o-", label=label)
    axes.set(xlabel=plot.x, ylabel=plot.y)
    axes.grid(alpha=0.3, which="both")
    axes.legend()
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)
    return True
