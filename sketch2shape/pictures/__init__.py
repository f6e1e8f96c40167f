"""Pictures of a result: the overlay, the sheet of stages, the shaded view, the HTML viewer, and pages for a folder.

All functions return pixels or text and write nothing; equal input gives equal bytes.
"""

from sketch2shape.pictures.canvas import encode_png
from sketch2shape.pictures.folder import Entry, contact_sheet, contact_sheets, count_sheets, folder_index
from sketch2shape.pictures.overlay import overlay
from sketch2shape.pictures.preview import preview, preview_of
from sketch2shape.pictures.stages import Stage, stage_panels, stages
from sketch2shape.pictures.viewer import viewer

__all__ = [
    "Entry",
    "Stage",
    "contact_sheet",
    "contact_sheets",
    "count_sheets",
    "encode_png",
    "folder_index",
    "overlay",
    "preview",
    "preview_of",
    "stage_panels",
    "stages",
    "viewer",
]
