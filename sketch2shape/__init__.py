"""From a drawing of a prism-like object to an exact, watertight solid.

>>> import sketch2shape as s2s
>>> result = s2s.reconstruct("image.png")  # doctest: +SKIP
>>> result.export("out.obj")  # doctest: +SKIP
"""

from __future__ import annotations

import sys
from importlib import import_module
from types import ModuleType
from typing import Any

__version__ = "0.1.0"

#: public name -> module that defines it; loaded on first use, so that importing the package stays cheap
_PUBLIC = {
    "reconstruct": "reconstruct",
    "reconstruct_many": "batch",
    "read_picture": "read",
    "find_ink": "ink",
    "trace_strokes": "tracing",
    "detect_corners": "detectors",
    "separate_faces": "faces",
    "connect": "connect",
    "connect_faces": "connect",
    "lift": "lift",
    "Result": "result",
    "Picture": "model",
    "Ink": "model",
    "FacePair": "model",
    "TwoFaceObject": "model",
    "Projection": "model",
    "Solid": "model",
    "Sketch2ShapeError": "errors",
    "UsageError": "errors",
    "PointsError": "errors",
    "UnreadableError": "errors",
    "NoObjectError": "errors",
    "LimitError": "errors",
    "WriteError": "errors",
    "MissingPackageError": "errors",
}

__all__ = ["__version__", *_PUBLIC]


class _Stage(ModuleType):
    """A module that is named like the one function it is for, and can be called as that function."""

    def __call__(self, *args: Any, **kwargs: Any) -> Any:
        return getattr(self, self.__name__.rpartition(".")[2])(*args, **kwargs)


class _Package(ModuleType):
    """This package: importing a stage's module binds the module to the stage's name, which must stay callable."""

    def __setattr__(self, name: str, value: Any) -> None:
        if _PUBLIC.get(name) == name and isinstance(value, ModuleType):
            value.__class__ = _Stage
        super().__setattr__(name, value)


sys.modules[__name__].__class__ = _Package


def __getattr__(name: str) -> Any:
    """Load a public name on first use."""
    if name not in _PUBLIC:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_PUBLIC[name]}"), name)


def __dir__() -> list[str]:
    return sorted(__all__)
