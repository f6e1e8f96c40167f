"""Order the unordered vertices of a face into its polygon: the connectors.

>>> from sketch2shape.connectors import connect
>>> connect([[0, 0], [2, 2], [2, 0], [0, 2]], method="split-walk").tolist()
[0, 2, 1, 3]
"""

from __future__ import annotations

from sketch2shape.connectors.connection import Connection
from sketch2shape.connectors.ordering import check_connector, connector_of
from sketch2shape.connectors.points import as_points
from sketch2shape.connectors.registry import methods
from sketch2shape.connectors.split_walk import Preconditions, split_walk_preconditions
from sketch2shape.connectors.stage import connect, connect_detailed
from sketch2shape.connectors.two_faces import FaceConnection, connect_faces, connect_faces_detailed

__all__ = [
    "Connection",
    "FaceConnection",
    "Preconditions",
    "as_points",
    "check_connector",
    "connect",
    "connect_detailed",
    "connect_faces",
    "connect_faces_detailed",
    "connector_of",
    "methods",
    "split_walk_preconditions",
]
