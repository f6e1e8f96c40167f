"""Coverage-guided attack on the reader with atheris (`pip install atheris`); it has no wheels for every system.

python -m benchmarks.faults.coverage_guided FOLDER -max_total_time=600     FOLDER collects interesting inputs
"""

from __future__ import annotations

import sys
from pathlib import Path

import atheris

with atheris.instrument_imports(include=["PIL", "sketch2shape"]):
    import PIL.BmpImagePlugin
    import PIL.GifImagePlugin
    import PIL.JpegImagePlugin
    import PIL.PngImagePlugin
    import PIL.PpmImagePlugin
    import PIL.TiffImagePlugin
    import PIL.WebPImagePlugin  # noqa: F401

    from sketch2shape.errors import Sketch2ShapeError
    from sketch2shape.reading.limits import Limits
    from sketch2shape.reading.read import count_pages, read_picture

from benchmarks.faults.samples import samples
from sketch2shape.writing.files import quiet_stderr

_LIMITS = Limits(max_pixels=1_000_000)


def one_input(data: bytes) -> None:
    """Only errors of ours may come out."""
    try:
        with quiet_stderr():
            read_picture(data, _LIMITS)
            count_pages(data)
    except Sketch2ShapeError:
        pass


def main() -> None:
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for name, data in samples().items():
        (folder / name).write_bytes(data)
    atheris.Setup([*sys.argv, "-timeout=5", "-rss_limit_mb=2048", "-max_len=65536"], one_input)
    atheris.Fuzz()


if __name__ == "__main__":
    main()
