"""Connectors: order the unordered vertices of a face into its polygon.

>>> from sketch2shape.connect import connect
>>> connect([[0, 0], [2, 2], [2, 0], [0, 2]], method="split-walk").tolist()
[0, 2, 1, 3]
"""

from __future__ import annotations

import sys
from types import ModuleType
from typing import Any

from numpy.typing import ArrayLike

from sketch2shape.connect.api import connect, connect_detailed
from sketch2shape.connect.connection import Connection
from sketch2shape.connect.faces import FaceConnection, connect_faces, connect_faces_detailed
from sketch2shape.connect.registry import methods
from sketch2shape.connect.split_walk import Preconditions, split_walk_preconditions
from sketch2shape.model import Ints

__all__ = [
    "Connection",
    "FaceConnection",
    "Preconditions",
    "connect",
    "connect_detailed",
    "connect_faces",
    "connect_faces_detailed",
    "methods",
    "split_walk_preconditions",
]


class _Callable(ModuleType):
    """`sketch2shape.connect` names this package and the function alike: calling the package connects."""

    def __call__(self, points: ArrayLike, method: str = "auto", **parameters: Any) -> Ints:
        """See `connect`."""
        return connect(points, method, **parameters)


sys.modules[__name__].__class__ = _Callable
