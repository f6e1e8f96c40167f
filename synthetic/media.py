"""Media: which pen, hand, paper and camera go together under one name."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace

import numpy as np

from synthetic.hand import HEAVY, LOOSE, RULER, SLOPPY, STEADY, TABLET, Hand
from synthetic.pens import Pen

RGB = tuple[int, int, int]
WHITE: RGB = (255, 255, 255)


@dataclass(frozen=True)
class Style:
    """How one sheet is drawn.

    size    : (w, h) pixels before the camera
    pen     : drawing tool
    hand    : departures from the ruler, already in pixels of this sheet
    ground  : RGB of the paper
    pattern : name in `papers.PATTERNS`
    capture : name in `papers.CAPTURES`
    suffix  : file format, ".png" or ".jpg"
    quality : of a JPEG, 0 to 100
    clear   : ink only, on a transparent ground (PNG with alpha)
    """

    size: tuple[int, int] = (640, 480)
    pen: Pen = field(default_factory=Pen)
    hand: Hand = RULER
    ground: RGB = WHITE
    pattern: str = "blank"
    capture: str = "direct"
    suffix: str = ".png"
    quality: int = 82
    clear: bool = False


def dash_of(rng: np.random.Generator) -> tuple[float, float]:
    """Dash and gap lengths: mostly dashes, sometimes dots."""
    if rng.random() < 0.22:
        return 0.0, float(rng.uniform(0.75, 1.05))
    return float(rng.uniform(1.1, 2.0)), float(rng.uniform(0.7, 1.1))


def _some_hand(rng: np.random.Generator) -> Hand:
    return STEADY if rng.random() < 0.4 else LOOSE


def _clean(rng: np.random.Generator) -> Style:
    return Style(pen=Pen(float(rng.uniform(1.6, 2.6)), dash=dash_of(rng)))


def _thin(rng: np.random.Generator) -> Style:
    return Style(pen=Pen(1.0, (40, 40, 40), dash=dash_of(rng)))


def _marker(rng: np.random.Generator) -> Style:
    ink: RGB = [(15, 15, 15), (25, 50, 160), (180, 30, 40)][int(rng.integers(3))]
    pen = Pen(float(rng.uniform(7, 11)), ink, float(rng.uniform(0.85, 1)), uneven=0.15, dash=(1.8, 1.5))
    return Style((900, 700), pen, STEADY.scaled(1.3))


def _icon(rng: np.random.Generator) -> Style:
    width = float(rng.uniform(9, 18))
    hand = Hand(rounding=float(rng.choice([0.0, 1.0])) * width * 0.8)
    return Style((512, 512), Pen(width, (0, 0, 0), dash=(1.2, 1.5)), hand)


def _hand(rng: np.random.Generator) -> Style:
    return Style(pen=Pen(float(rng.uniform(1.8, 3.2)), dash=dash_of(rng)), hand=_some_hand(rng))


def _handheavy(rng: np.random.Generator) -> Style:
    return Style((800, 600), Pen(float(rng.uniform(2, 3.5)), dash=(1.9, 1.2)), HEAVY)


def _rounded(rng: np.random.Generator) -> Style:
    hand = Hand(wobble=0.8, bow=0.008, shift=0.8, rounding=float(rng.uniform(4, 9)))
    return Style(pen=Pen(float(rng.uniform(2, 3.5))), hand=hand)


def _pencil(rng: np.random.Generator) -> Style:
    shade = int(rng.uniform(70, 125))
    pen = Pen(
        float(rng.uniform(1.6, 2.8)), (shade, shade, shade + 4), grain=float(rng.uniform(0.4, 0.75)), dash=(1.8, 1.1)
    )
    return Style(
        (800, 600), pen, _some_hand(rng), (244, 243, 238), "blank", "noisy" if rng.random() < 0.2 else "direct"
    )


def _ballpen(rng: np.random.Generator) -> Style:
    ink: RGB = [(30, 45, 150), (20, 20, 30), (160, 30, 40)][int(rng.integers(3))]
    pen = Pen(float(rng.uniform(1.4, 2.2)), ink, 0.92, uneven=float(rng.uniform(0.3, 0.6)), dash=(1.8, 1.1))
    return Style((800, 600), pen, _some_hand(rng), (250, 249, 245))


def _coloured(rng: np.random.Generator) -> Style:
    ink: RGB = [(200, 40, 40), (30, 120, 60), (40, 90, 200), (190, 120, 20), (130, 40, 150)][int(rng.integers(5))]
    return Style(
        pen=Pen(float(rng.uniform(1.8, 3)), ink, dash=dash_of(rng)), hand=STEADY if rng.random() < 0.5 else RULER
    )


def _blueprint(rng: np.random.Generator) -> Style:
    ground: RGB = [(24, 62, 140), (16, 40, 92), (40, 90, 170)][int(rng.integers(3))]
    pattern = "squared" if rng.random() < 0.3 else "blank"
    return Style(
        pen=Pen(float(rng.uniform(1.5, 2.6)), (238, 244, 255), dash=dash_of(rng)), ground=ground, pattern=pattern
    )


def _blackboard(rng: np.random.Generator) -> Style:
    ground: RGB = [(38, 66, 54), (30, 32, 34)][int(rng.integers(2))]
    pen = Pen(float(rng.uniform(3, 5)), (232, 232, 222), grain=float(rng.uniform(0.25, 0.5)), dash=(1.8, 1.3))
    return Style((900, 675), pen, LOOSE, ground, "blank", "noisy" if rng.random() < 0.4 else "direct")


def _dark(rng: np.random.Generator) -> Style:
    pen = Pen(float(rng.uniform(1.5, 2.5)), (225, 228, 235), dash=dash_of(rng))
    return Style(pen=pen, ground=(30, 31, 36))


def _transparent(rng: np.random.Generator) -> Style:
    ink: RGB = [(0, 0, 0), (20, 40, 120)][int(rng.integers(2))]
    return Style(pen=Pen(float(rng.uniform(1.6, 4)), ink, dash=dash_of(rng)), clear=True)


def _scan(rng: np.random.Generator) -> Style:
    pen = Pen(float(rng.uniform(1.8, 3.5)), (45, 45, 50), uneven=0.3, dash=(1.8, 1.1))
    return Style(
        (900, 700), pen, _some_hand(rng), (246, 245, 240), "blank", "scan", ".jpg" if rng.random() < 0.4 else ".png"
    )


def _photo(rng: np.random.Generator) -> Style:
    ink: RGB = [(25, 25, 30), (35, 45, 120), (70, 70, 72)][int(rng.integers(3))]
    pen = Pen(float(rng.uniform(2.6, 4.2)), ink, uneven=0.3, dash=(1.8, 1.2))
    pattern = str(rng.choice(["blank", "blank", "squared", "ruled"]))
    return Style((1024, 768), pen, _some_hand(rng).scaled(1.3), (244, 242, 236), pattern, "photo", ".jpg")


def _on_pattern(pattern: str) -> Callable[[np.random.Generator], Style]:
    def style(rng: np.random.Generator) -> Style:
        ink: RGB = [(25, 25, 28), (30, 45, 150)][int(rng.integers(2))]
        hand = [RULER, STEADY, LOOSE][int(rng.integers(3))]
        pen = Pen(float(rng.uniform(1.8, 3)), ink, dash=dash_of(rng))
        return Style((800, 600), pen, hand, (253, 253, 250), pattern)

    return style


def _noisy(rng: np.random.Generator) -> Style:
    return Style(pen=Pen(float(rng.uniform(1.8, 3)), dash=(1.9, 1.1)), ground=(235, 235, 235), capture="noisy")


def _lowres(rng: np.random.Generator) -> Style:
    return Style((800, 620), Pen(float(rng.uniform(5, 8)), dash=(1.8, 1.5)), capture="thumbnail")


def _large(rng: np.random.Generator) -> Style:
    hand = RULER if rng.random() < 0.5 else STEADY.scaled(3.5)
    return Style((2800, 2100), Pen(float(rng.uniform(5, 12)), dash=(1.8, 1.1)), hand)


def _jpeg(rng: np.random.Generator) -> Style:
    return Style(pen=Pen(float(rng.uniform(1.5, 2.5)), dash=dash_of(rng)), suffix=".jpg")


def _tablet(rng: np.random.Generator) -> Style:
    pen = Pen(float(rng.uniform(5, 13)), (0, 0, 0), crisp=True, dash=(1.6, 1.5))
    return Style((560, 480), pen, TABLET.scaled(float(rng.uniform(0.6, 1.2))))


def _textbook(rng: np.random.Generator) -> Style:
    pen = Pen(float(rng.uniform(4, 7)), (25, 25, 25), dash=(1.6, 1.0))
    return Style((620, 520), pen, capture="clipping", suffix=".jpg")


def _faint(rng: np.random.Generator) -> Style:
    pen = Pen(float(rng.uniform(1.4, 3)), dash=None, faint=float(rng.uniform(0.45, 0.75)))
    return Style(pen=pen)


def _gappy(rng: np.random.Generator) -> Style:
    """Strokes end so far before the corners that one to five pen widths of paper show."""
    width = float(rng.uniform(1.6, 3.4))
    hand = RULER if rng.random() < 0.6 else Hand(wobble=0.6, bow=0.005)
    return Style(pen=Pen(width, dash=dash_of(rng)), hand=replace(hand, short=float(rng.uniform(1.5, 5.5)) * width))


def _cad(rng: np.random.Generator) -> Style:
    """What programs render small: thin, clean, black or grey on white, or light on dark."""
    dark = rng.random() < 0.15
    ink: RGB = (235, 235, 235) if dark else [(0, 0, 0), (60, 60, 60)][int(rng.integers(2))]
    pen = Pen(float(rng.uniform(1.0, 1.5)), ink, dash=(0.8, 0.6))
    return Style((256, 256), pen, ground=(25, 25, 30) if dark else WHITE)


def _thick(rng: np.random.Generator) -> Style:
    """A pen as broad as a twentieth of the object."""
    ink: RGB = [(0, 0, 0), (30, 30, 30), (25, 50, 160)][int(rng.integers(3))]
    pen = Pen(float(rng.uniform(11, 20)), ink, crisp=bool(rng.random() < 0.3), dash=(1.5, 1.4))
    hand = RULER if rng.random() < 0.4 else STEADY.scaled(1.8)
    return Style((720, 560), pen, hand)


def _sloppy(rng: np.random.Generator) -> Style:
    """In a hurry: vertices missed, strokes bowed, too long or too short."""
    ink: RGB = [(15, 15, 15), (30, 45, 150), (70, 70, 75)][int(rng.integers(3))]
    pen = Pen(float(rng.uniform(2.0, 5.0)), ink, uneven=0.2, dash=(1.8, 1.3))
    return Style((760, 600), pen, SLOPPY.scaled(float(rng.uniform(0.6, 1.1))))


def _pressed(rng: np.random.Generator) -> Style:
    """JPEG of low quality, as chats and old web sites send pictures."""
    quality = int(rng.integers(22, 55))
    return Style(pen=Pen(float(rng.uniform(1.6, 3.2)), dash=dash_of(rng)), suffix=".jpg", quality=quality)


def _shade(rng: np.random.Generator) -> Style:
    """Evenly lit but for a light shade over a part of the sheet."""
    hand = RULER if rng.random() < 0.5 else STEADY
    pen = Pen(float(rng.uniform(1.8, 3.2)), (40, 40, 45), dash=dash_of(rng))
    return Style((800, 600), pen, hand, (250, 249, 245), "blank", "shade", ".jpg")


MEDIA: dict[str, Callable[[np.random.Generator], Style]] = {
    "clean": _clean,
    "thin": _thin,
    "marker": _marker,
    "icon": _icon,
    "hand": _hand,
    "handheavy": _handheavy,
    "rounded": _rounded,
    "pencil": _pencil,
    "pen": _ballpen,
    "coloured": _coloured,
    "blueprint": _blueprint,
    "blackboard": _blackboard,
    "dark": _dark,
    "transparent": _transparent,
    "scan": _scan,
    "photo": _photo,
    "grid": _on_pattern("squared"),
    "ruled": _on_pattern("ruled"),
    "isodots": _on_pattern("isodots"),
    "noisy": _noisy,
    "lowres": _lowres,
    "large": _large,
    "jpeg": _jpeg,
    "tablet": _tablet,
    "textbook": _textbook,
    "faint": _faint,
    "gappy": _gappy,
    "cad": _cad,
    "thick": _thick,
    "sloppy": _sloppy,
    "pressed": _pressed,
    "shade": _shade,
}
