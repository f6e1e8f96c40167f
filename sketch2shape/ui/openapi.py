"""The description of the HTTP service, OpenAPI 3.1."""

from __future__ import annotations

from typing import Any

from sketch2shape import __version__
from sketch2shape.writing.formats import FORMATS

#: media types of drawings that hold lines: strokes of a pen, whiteboards, InkML
VECTOR_KINDS = ("application/json", "application/inkml+xml", "application/vnd.excalidraw+json")

#: product -> media type of the answer
MEDIA = {name: format.media for name, format in FORMATS.items()}

#: option in the query -> (type, what it means)
OPTIONS = {
    "projection": ("string", "auto, oblique, axonometric or perspective"),
    "width": ("string", "real width, as 40mm"),
    "height": ("string", "real height"),
    "depth": ("string", "real size from front to back"),
    "fit": ("string", "the largest size of the solid, as 50mm"),
    "up": ("string", "the axis upward, z or y, or camera for the picture's frame"),
    "unit": ("string", "unit of length: px, mm, cm, m or in"),
    "min_confidence": ("number", "leave out objects that are less sure, 0 to 1"),
}

_REFUSALS = {
    "400": "options that make no sense, or no picture in the form",
    "408": "the upload took too long",
    "413": "too many bytes or pixels, or too much computing",
    "415": "not a picture, or a body of another type",
    "422": "no object was found, or none that can be trusted",
    "500": "a bug",
    "501": "an optional package is missing on the server",
    "503": "too much work is waiting: try again",
}


def description() -> dict[str, Any]:
    """The whole document, ready for JSON."""
    picture = {"schema": {"type": "string", "format": "binary"}}
    form = {"type": "object", "required": ["file"], "properties": {"file": {"type": "string", "format": "binary"}}}
    refusal = {"application/json": {"schema": {"$ref": "#/components/schemas/Refusal"}}}
    answers: dict[str, Any] = {
        "200": {"description": "the product", "content": {m: {} for m in sorted({*MEDIA.values()})}}
    }
    answers |= {status: {"description": words, "content": refusal} for status, words in _REFUSALS.items()}
    product = {"name": "format", "in": "query", "schema": {"type": "string", "enum": [*MEDIA], "default": "json"}}
    return {
        "openapi": "3.1.0",
        "info": {
            "title": "sketch2shape",
            "version": __version__,
            "description": "From a drawing of a prism-like object to an exact, watertight solid. Nothing is kept.",
        },
        "paths": {
            "/v1/reconstruct": {
                "post": {
                    "summary": "A picture in, its solid (or the report on it) out",
                    "parameters": [
                        product,
                        *(
                            {"name": name, "in": "query", "description": words, "schema": {"type": kind}}
                            for name, (kind, words) in OPTIONS.items()
                        ),
                    ],
                    "requestBody": {
                        "required": True,
                        "content": {
                            "image/*": picture,
                            "application/pdf": picture,
                            **dict.fromkeys(VECTOR_KINDS, picture),
                            "application/octet-stream": picture,
                            "multipart/form-data": {"schema": form},
                        },
                    },
                    "responses": answers,
                }
            },
            "/health": {
                "get": {"summary": "Whether the service is up", "responses": {"200": {"description": "it is"}}}
            },
        },
        "components": {
            "schemas": {
                "Refusal": {
                    "type": "object",
                    "properties": {
                        "error": {"type": "string", "description": "what happened"},
                        "advice": {"type": "string", "description": "what to try"},
                    },
                }
            }
        },
    }
