"""The command line: options, and the exit code. Nothing heavy is imported here, so that --help answers at once."""

from __future__ import annotations

import argparse
import contextlib
import os
import re
import sys
import warnings
from collections.abc import Sequence

from sketch2shape import __version__
from sketch2shape.command.completion import PrintCompletion
from sketch2shape.errors import Sketch2ShapeError, one_line
from sketch2shape.processes.threads import compute_in_one_thread
from sketch2shape.writing import occupy_descriptors, tell
from sketch2shape.writing.formats import FORMATS, named

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import NoReturn

    from sketch2shape.writing.formats import Group

_DESCRIPTION = """From a drawing of a prism-like object to an exact, watertight solid.

  sketch2shape drawing.png -o solid.obj           one picture, one mesh
  sketch2shape drawings/ -o meshes/ --json        a folder; its tree is kept
  sketch2shape ui                                 the same in the browser, and put it right by hand
  sketch2shape serve                              the same over HTTP, for programs
  cat drawing.png | sketch2shape - -o - > a.obj   standard input and output"""

_EPILOG = """exit codes: 0 all done, 1 bug, 2 usage, 3 some inputs failed, 4 input unreadable or not an image,
5 no two-face object found, 6 limit exceeded, 7 cannot write, 8 optional package missing, 130 interrupted"""

USUAL_COLUMNS = 80
"""Width of the help where there is no terminal."""

_UNITS = {"": 1, "K": 2**10, "M": 2**20, "G": 2**30, "T": 2**40}


#: other names of units
_UNIT_NAMES = {
    **dict.fromkeys(("inch", "inches", '"'), "in"),
    **dict.fromkeys(("millimetre", "millimetres", "millimeter", "millimeters"), "mm"),
    **dict.fromkeys(("centimetre", "centimetres", "centimeter", "centimeters"), "cm"),
    **dict.fromkeys(("metre", "metres", "meter", "meters"), "m"),
    **dict.fromkeys(("pixel", "pixels"), "px"),
}


class _Help(argparse.RawDescriptionHelpFormatter):
    """Asks the terminal for its width by itself: `shutil`, which argparse asks, loads every compression there is."""

    def __init__(self, prog: str) -> None:
        super().__init__(prog, width=_columns() - 2)


def _columns() -> int:
    """Width of the terminal, as `shutil.get_terminal_size` tells it."""
    with contextlib.suppress(KeyError, ValueError):
        if (told := int(os.environ["COLUMNS"])) > 0:
            return told
    with contextlib.suppress(AttributeError, ValueError, OSError):
        return os.get_terminal_size(sys.__stdout__.fileno()).columns or USUAL_COLUMNS  # type: ignore[union-attr]
    return USUAL_COLUMNS


class _Parser(argparse.ArgumentParser):
    """Says what is wrong in one line, like every other failure."""

    def error(self, message: str) -> NoReturn:
        tell(one_line("sketch2shape", message, self._advice(message)))
        self.exit(2)

    def _advice(self, message: str) -> str:
        """The option that was probably meant, where there is one like it."""
        unknown = re.match(r"unrecognized arguments: (-[^\s=]+)", message)
        if unknown:
            from difflib import get_close_matches

            near = get_close_matches(unknown[1], self._option_string_actions, n=1)
            if near:
                return near[0]
        return "sketch2shape --help"


def build_parser() -> argparse.ArgumentParser:
    """The parser, one function for each group of options."""
    parser = _Parser(
        prog="sketch2shape",
        description=_DESCRIPTION,
        epilog=_EPILOG,
        formatter_class=_Help,
        allow_abbrev=False,
    )
    parser.add_argument("inputs", metavar="INPUT", nargs="+", help="image, folder, or - for standard input")
    parser.add_argument("-V", "--version", action="version", version=f"sketch2shape {__version__}")
    parser.add_argument("--print-completion", metavar="SHELL", action=PrintCompletion, help="for bash, zsh or fish")
    parser.add_argument("-q", "--quiet", action="store_true", help="say nothing but what failed")
    parser.add_argument("--debug", action="store_true", help="show the traceback of a bug")
    for add in (_output_options, _reading_options, _method_options, _solid_options, _batch_options):
        add(parser)
    return parser


def parse(argv: Sequence[str]) -> argparse.Namespace:
    """Parse arguments, in any order. Names after `--` are inputs, even if they begin with a dash."""
    cut = argv.index("--") if "--" in argv else len(argv)
    names = ["./" + name if name.startswith("-") and name != "-" else name for name in argv[cut + 1 :]]
    return build_parser().parse_intermixed_args([*argv[:cut], *names])


def _output_options(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("output")
    group.add_argument(
        "-o", "--output", metavar="OUT", action="append", default=[],
        help="file (its extension picks the format), folder, or - for standard output; may be given several times "
        "for one picture; default: beside the input",
    )  # fmt: skip
    group.add_argument(
        "-f", "--format", metavar="FORMAT", action="append", default=[],
        help=f"format where OUT is a folder or -: obj by default; of {_known()}; several: obj,stl",
    )  # fmt: skip
    for product in named("picture"):
        what = FORMATS[product].what
        group.add_argument(f"--{product}", metavar="FILE", help=f"{what}; for folders use --format {product}")
    group.add_argument("--json", action="store_true", help="write the report NAME.json beside each mesh")
    group.add_argument("--timings", action="store_true", help="reports tell the time of each stage")
    existing = group.add_mutually_exclusive_group()
    existing.add_argument("--overwrite", action="store_true", help="replace outputs that exist (default: refuse)")
    existing.add_argument("--versioned", action="store_true", help="keep outputs that exist, write NAME.2.obj")


def _known() -> str:
    """The formats by what they hold, as in "solids obj, stl; reports json"."""
    groups: tuple[Group, ...] = ("solid", "program", "plan", "drawing", "report", "picture")
    return "; ".join(f"{group}s {', '.join(names)}" for group in groups if (names := named(group)))


def _reading_options(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("reading")
    group.add_argument("--pages", metavar="N|all", default="1", help="page of a TIFF or PDF, or all (default 1)")
    group.add_argument("--max-pixels", metavar="N", type=_size, help="refuse larger pictures unread (default 64M)")
    group.add_argument("--max-bytes", metavar="N", type=_bytes, help="refuse larger files unread (default 256M)")


def _method_options(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("method")
    group.add_argument("--connector", metavar="NAME", default="auto", help="orders face vertices (default auto)")
    group.add_argument(
        "--detector", choices=("auto", "both", "shi-tomasi", "harris"), default="auto", type=_detector,
        help="corner detector that has to see the vertices found (default: none has to)",
    )  # fmt: skip
    group.add_argument("--vertices", metavar="FILE.json", help="what was put right by hand (or an edited report)")
    group.add_argument(
        "--min-confidence",
        metavar="C",
        type=_fraction,
        help="leave out objects that are less sure, 0 to 1; 0.9 is sure",
    )


def _solid_options(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("solid")
    group.add_argument(
        "--projection", choices=("auto", "oblique", "axonometric", "perspective"), default="auto", type=_projection,
        help="how the object was projected (default: told from the drawing)",
    )  # fmt: skip
    group.add_argument(
        "--reading", metavar="N", type=_count, default=1, help="2 takes the next best reading (default 1)"
    )
    group.add_argument("--width", metavar="L", help="size of the upright solid from left to right, as 40mm")
    group.add_argument("--height", metavar="L", help="its size upward")
    group.add_argument("--depth", metavar="L", help="its size from front to back; any of the three together")
    group.add_argument("--fit", metavar="L", help="scale the solid so that this is its largest size, as 50mm")
    group.add_argument(
        "--depth-ratio", metavar="R", type=float,
        help="drawn over true length of receding edges, where the drawing is oblique (default 0.5, cabinet)",
    )  # fmt: skip
    group.add_argument("--unit", choices=("px", "mm", "cm", "m", "in"), default="px", type=_unit, help="unit of length")
    group.add_argument(
        "--up", choices=("z", "y", "camera"), default="z",
        help="the solid stands with this axis upward (default z), or keeps the picture's frame",
    )  # fmt: skip
    group.add_argument("--necker", action="store_true", help="the mirrored reading: near and far exchanged")
    group.add_argument("--no-beautify", action="store_true", help="leave nearly right angles and equal lengths alone")
    group.add_argument("--ngons", action="store_true", help="OBJ: whole faces instead of triangles")
    group.add_argument(
        "--tolerance", metavar="L",
        help="largest distance of a mesh from a curved side, as 0.1mm (default: one that looks smooth)",
    )  # fmt: skip
    group.add_argument("--paper", choices=("a4", "letter"), type=str.lower, help="of nets and other plans (default a4)")
    group.add_argument(
        "--angle", choices=("third", "first"),
        help="of views: third angle (default) puts each on the side it is seen from, first angle on the other",
    )  # fmt: skip


def _batch_options(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("folders and several inputs, or one")
    group.add_argument("--jobs", metavar="N", type=_count, help="worker processes (default: one for each core)")
    group.add_argument("--timeout", metavar="S", type=_seconds, help="seconds for one input (default 120 in a batch)")
    group.add_argument("--max-memory", metavar="N", type=_bytes, help="memory for one input (default 4G in a batch)")
    group.add_argument("--resume", action="store_true", help="go on with a run that was stopped")
    group.add_argument("--watch", action="store_true", help="stay, and convert pictures as they appear in the folder")
    group.add_argument("--fail-fast", action="store_true", help="stop at the first input that fails")
    group.add_argument("--dry-run", action="store_true", help="print what would be read and written, and stop")
    group.add_argument("--index", metavar="FILE.html", help="page with thumbnail, status and links of each input")
    group.add_argument("--contact-sheet", metavar="FILE.png", help="picture with a thumbnail of each input")
    group.add_argument("--report", metavar="FILE", help="table of what became of each input, .jsonl or .csv")
    group.add_argument("--scheduler", metavar="URL", help="run on a Dask cluster, as tcp://host:8786")


def _count(text: str) -> int:
    if not text.isdigit() or not 0 < int(text) <= 1024:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number from 1 to 1024")
    return int(text)


def _fraction(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = -1.0
    if not 0 <= value <= 1:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number from 0 to 1")
    return value


def _unit(text: str) -> str:
    return _UNIT_NAMES.get(text.lower(), text.lower())


def _projection(text: str) -> str:
    """Isometric and its kin are axonometric: which angles a drawing has is told from the drawing."""
    return "axonometric" if text in ("isometric", "dimetric", "trimetric") else text


def _detector(text: str) -> str:
    """OpenCV's goodFeaturesToTrack is Shi-Tomasi."""
    return "shi-tomasi" if text.lower() == "goodfeaturestotrack" else text


def _seconds(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = 0.0
    if not 0 < value < 1e9:
        raise argparse.ArgumentTypeError(f"{text!r} is not a positive number of seconds")
    return value


def _scaled(text: str, kilo: int) -> int:
    plain = text.upper().removesuffix("B").removesuffix("I")
    number, unit = (plain[:-1], plain[-1]) if plain[-1:] in _UNITS and plain[-1:] else (plain, "")
    try:
        value = int(float(number) * (_UNITS[unit] if kilo == 1024 else 1000 ** list(_UNITS).index(unit)))
    except (ValueError, OverflowError):
        value = 0
    if value < 1:
        raise argparse.ArgumentTypeError(f"{text!r} is not a size such as 500M or 2G")
    return value


def _size(text: str) -> int:
    return _scaled(text, 1000)


def _bytes(text: str) -> int:
    return _scaled(text, 1024)


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command and return its exit code."""
    occupy_descriptors()
    words = list(sys.argv[1:] if argv is None else argv)
    served = words[0] if words[:1] in (["ui"], ["serve"]) else None
    arguments = argparse.Namespace(inputs=[served], debug=False) if served else parse(words)
    if not arguments.debug:
        warnings.simplefilter("ignore")  # decoders warn of what is odd in a file
    try:
        if served:
            from importlib import import_module

            room = {"ui": "sketch2shape.ui.serve", "serve": "sketch2shape.ui.service"}[served]
            return int(import_module(room).main(words[1:]))
        compute_in_one_thread()
        from sketch2shape.command.run import run

        return run(arguments)
    except Sketch2ShapeError as error:
        _complain(arguments.inputs, error)
        return error.exit_code
    except KeyboardInterrupt:
        tell("sketch2shape: interrupted")
        return 130
    except Exception as error:
        if arguments.debug:
            raise
        what = f"internal error ({type(error).__name__}: {error})"
        tell(one_line("sketch2shape", what, "--debug, and report it as a bug"))
        return 1


def _complain(inputs: Sequence[str], error: Sketch2ShapeError) -> None:
    about = inputs[0] if len(inputs) == 1 else "sketch2shape"
    tell(one_line(about, error.message, error.advice))


if __name__ == "__main__":
    sys.exit(main())
