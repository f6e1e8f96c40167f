"""Connectors: order the unordered vertices of a face into its polygon.

>>> from sketch2shape.connect import connect
>>> connect([[0, 0], [2, 2], [2, 0], [0, 2]], method="split-walk").tolist()
[0, 2, 1, 3]
"""

from __future__ import annotations

from sketch2shape.connect.api import connect, connect_detailed
from sketch2shape.connect.connection import Connection
from sketch2shape.connect.faces import FaceConnection, connect_faces, connect_faces_detailed
from sketch2shape.connect.registry import methods
from sketch2shape.connect.split_walk import Preconditions, split_walk_preconditions

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
