"""The one error tree: each class owns its exit code and the remedy it offers.

A failure is shown as one line, ``FILE: what happened. Try: remedy``.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any, ClassVar


class Sketch2ShapeError(Exception):
    """Root of every error this package raises on purpose."""

    exit_code: ClassVar[int] = 1
    remedy: ClassVar[str] = "report this as a bug, with the drawing"

    def __init__(self, message: str, *, remedy: str | None = None) -> None:
        """Keep the message, and a remedy that is more to the point than the class's own."""
        super().__init__(message)
        self.message = message
        self.advice = remedy or type(self).remedy


class UsageError(Sketch2ShapeError):
    """The options or arguments do not make sense together."""

    exit_code = 2
    remedy = "sketch2shape --help"


class PointsError(UsageError, ValueError):
    """Points given to a stage have the wrong shape, type or values."""

    remedy = "pass an (n, 2) array of finite numbers, n >= 3, without duplicates"


class OptionError(UsageError, TypeError):
    """A function was given an option that it does not have."""

    remedy = "another name, see help()"


class UnreadableError(Sketch2ShapeError):
    """The input is missing, damaged or not an image."""

    exit_code = 4
    remedy = "a PNG, JPEG, WebP, TIFF, BMP, GIF or PNM picture"


class NoObjectError(Sketch2ShapeError):
    """The picture holds no two-face object, or none that can be trusted."""

    exit_code = 5
    remedy = "a drawing of one prism-like object with all its visible edges drawn through"

    #: the best answer there was, an `Answer` that is not trusted, or None
    guess: Any = None


class LimitError(Sketch2ShapeError):
    """A limit on pixels, bytes, time or memory was passed."""

    exit_code = 6
    remedy = "a smaller picture, or raise the limit"


class WriteError(Sketch2ShapeError):
    """The output cannot be written."""

    exit_code = 7
    remedy = "another output path, or free some space"


class MissingPackageError(Sketch2ShapeError):
    """An optional package is needed for this and not installed."""

    exit_code = 8
    remedy = "pip install 'sketch2shape[all]'"


class CrashError(Sketch2ShapeError):
    """The process that worked on the input died, or a bug stopped it."""


class InterruptedRunError(Sketch2ShapeError):
    """The run was interrupted before this input was done."""

    exit_code = 130
    remedy = "--resume"


def one_line(source: str, message: str, remedy: str) -> str:
    """`FILE: what happened. Try: remedy`, on one line whatever characters a file name holds."""
    return on_one_line(f"{source}: {message}. Try: {remedy}")


def on_one_line(text: str) -> str:
    """The text with whatever would break the line, or hide, written as an escape."""
    return "".join(c if c.isprintable() else c.encode("unicode_escape", "surrogatepass").decode() for c in text)
