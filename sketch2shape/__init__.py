"""From a drawing of a prism-like object to an exact, watertight solid.

>>> import sketch2shape as s2s
>>> result = s2s.reconstruct("image.png")  # doctest: +SKIP
>>> result.export("out.obj")  # doctest: +SKIP

Names load on first use, so that importing the package stays cheap.
"""

__version__ = "0.1.0"

TYPE_CHECKING = False
"""What type checkers take for true; `typing` itself takes longer to load than all else that `--help` needs."""

if TYPE_CHECKING:
    from sketch2shape.batch import reconstruct_many as reconstruct_many
    from sketch2shape.connectors import connect as connect
    from sketch2shape.connectors import connect_detailed as connect_detailed
    from sketch2shape.connectors import connect_faces as connect_faces
    from sketch2shape.connectors import connect_faces_detailed as connect_faces_detailed
    from sketch2shape.corrections import Corrections as Corrections
    from sketch2shape.corrections import corrections_from as corrections_from
    from sketch2shape.corrections import parse_corrections as parse_corrections
    from sketch2shape.errors import CrashError as CrashError
    from sketch2shape.errors import InterruptedRunError as InterruptedRunError
    from sketch2shape.errors import LimitError as LimitError
    from sketch2shape.errors import MissingPackageError as MissingPackageError
    from sketch2shape.errors import NoObjectError as NoObjectError
    from sketch2shape.errors import OptionError as OptionError
    from sketch2shape.errors import PointsError as PointsError
    from sketch2shape.errors import Sketch2ShapeError as Sketch2ShapeError
    from sketch2shape.errors import UnreadableError as UnreadableError
    from sketch2shape.errors import UsageError as UsageError
    from sketch2shape.errors import WriteError as WriteError
    from sketch2shape.ink import find_ink as find_ink
    from sketch2shape.lifting import LiftOptions as LiftOptions
    from sketch2shape.model import DrawnArc as DrawnArc
    from sketch2shape.model import Ellipse as Ellipse
    from sketch2shape.model import FacePair as FacePair
    from sketch2shape.model import Ink as Ink
    from sketch2shape.model import Picture as Picture
    from sketch2shape.model import Projection as Projection
    from sketch2shape.model import TwoFaceObject as TwoFaceObject
    from sketch2shape.pipeline import Result as Result
    from sketch2shape.pipeline import Solid as Solid
    from sketch2shape.pipeline import lift as lift
    from sketch2shape.pipeline import reconstruct as reconstruct
    from sketch2shape.reading import Limits as Limits
    from sketch2shape.reading import read_picture as read_picture
    from sketch2shape.search import separate_faces as separate_faces
    from sketch2shape.strokes import DetectedCorners as DetectedCorners
    from sketch2shape.strokes import Strokes as Strokes
    from sketch2shape.strokes import detect_corners as detect_corners
    from sketch2shape.strokes import trace_strokes as trace_strokes

_ROOMS = {
    "batch": ("reconstruct_many",),
    "connectors": ("connect", "connect_detailed", "connect_faces", "connect_faces_detailed"),
    "corrections": ("Corrections", "corrections_from", "parse_corrections"),
    "errors": (
        *(
            "CrashError",
            "InterruptedRunError",
            "LimitError",
            "MissingPackageError",
            "NoObjectError",
            "OptionError",
            "PointsError",
        ),
        *("Sketch2ShapeError", "UnreadableError", "UsageError", "WriteError"),
    ),
    "ink": ("find_ink",),
    "lifting": ("LiftOptions",),
    "model": ("DrawnArc", "Ellipse", "FacePair", "Ink", "Picture", "Projection", "TwoFaceObject"),
    "pipeline": ("Result", "Solid", "lift", "reconstruct"),
    "reading": ("Limits", "read_picture"),
    "search": ("separate_faces",),
    "strokes": ("DetectedCorners", "Strokes", "detect_corners", "trace_strokes"),
}
"""Package -> the public names it defines. A test holds it against what type checkers see above."""

__all__ = ["__version__", *sorted(name for names in _ROOMS.values() for name in names)]

if not TYPE_CHECKING:  # a type checker would take every misspelt name for one that is loaded later

    def __getattr__(name):
        """Load a public name on first use."""
        for room, names in _ROOMS.items():
            if name in names:
                from importlib import import_module

                value = getattr(import_module(f"{__name__}.{room}"), name)
                globals()[name] = value
                return value
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")

    def __dir__():
        return sorted(__all__)
