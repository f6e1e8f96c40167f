"""The colours of every picture and of the page: one palette, told apart by colour-blind readers too.

The three hues are those of Okabe and Ito's colour universal design set (https://jfly.uni-koeln.de/color/).
"""

from __future__ import annotations

Colour = tuple[int, int, int]
"""Red, green, blue, 0..255."""

FRONT: Colour = (0, 98, 178)
BACK: Colour = (200, 84, 0)
JOIN: Colour = (0, 138, 100)
INK: Colour = (28, 32, 40)
MUTED: Colour = (104, 112, 124)
RULE: Colour = (218, 222, 228)
PAPER: Colour = (255, 255, 255)
BACKDROP: Colour = (246, 247, 249)
SHADE: Colour = (126, 168, 214)
FAILED: Colour = (176, 32, 44)
DONE: Colour = (22, 120, 64)
DOUBT: Colour = (168, 92, 0)


def mix(a: Colour, b: Colour, part: float) -> Colour:
    """The colour that is `part` (0..1) of the way from `a` to `b`."""
    return (
        round(a[0] + (b[0] - a[0]) * part),
        round(a[1] + (b[1] - a[1]) * part),
        round(a[2] + (b[2] - a[2]) * part),
    )


def css(colour: Colour) -> str:
    """The colour as CSS writes it, #rrggbb."""
    return "#{:02x}{:02x}{:02x}".format(*colour)
