"""3MF, the format of 3-D printing: a zip archive with one XML model that names its unit.

Follows the 3MF Core Specification 1.3. The archive carries a fixed date, so that the same solids give the same bytes.
"""

from __future__ import annotations

import io
import zipfile
from collections.abc import Sequence

from sketch2shape.export.mesh import settled
from sketch2shape.model import Solid
from sketch2shape.solids import tessellated

_UNITS = {"px": "millimeter", "mm": "millimeter", "cm": "centimeter", "m": "meter", "in": "inch"}

_CORE = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
_HEAD = '<?xml version="1.0" encoding="UTF-8"?>\n'
_TYPES = (
    _HEAD + '<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">'
    '<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>'
    '<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>'
)
_RELATIONS = (
    _HEAD + '<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">'
    '<Relationship Target="/3D/3dmodel.model" Id="rel0" '
    'Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>'
)


def threemf_bytes(solids: Sequence[Solid], tolerance: float | None = None) -> bytes:
    """A 3MF archive with one object for each solid; a solid in pixels is given in millimetres.

    tolerance : largest distance of a facet from a curved side, in the solids' unit; None for one that looks smooth
    """
    unit = _UNITS[solids[0].unit] if solids else "millimeter"
    objects = "".join(_object(number, solid, tolerance) for number, solid in enumerate(solids, 1))
    items = "".join(f'<item objectid="{number}"/>' for number in range(1, len(solids) + 1))
    model = (
        f'{_HEAD}<model unit="{unit}" xml:lang="en" xmlns="{_CORE}">'
        f"<resources>{objects}</resources><build>{items}</build></model>"
    )
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in (
            ("[Content_Types].xml", _TYPES),
            ("_rels/.rels", _RELATIONS),
            ("3D/3dmodel.model", model),
        ):
            entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, text)
    return buffer.getvalue()


def _object(number: int, solid: Solid, tolerance: float | None) -> str:
    form = tessellated(solid.boundary, tolerance)
    vertices = "".join(f'<vertex x="{x:.9g}" y="{y:.9g}" z="{z:.9g}"/>' for x, y, z in settled(form.vertices).tolist())
    triangles = "".join(f'<triangle v1="{a}" v2="{b}" v3="{c}"/>' for a, b, c in form.triangles.tolist())
    return (
        f'<object id="{number}" type="model" name="object {number}"><mesh>'
        f"<vertices>{vertices}</vertices><triangles>{triangles}</triangles></mesh></object>"
    )
