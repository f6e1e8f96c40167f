"""How plans on paper are laid out."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

from sketch2shape.errors import OptionError
from sketch2shape.sheets import PAPERS

PaperName = Literal["a4", "letter"]
Angle = Literal["third", "first"]


@dataclass(frozen=True)
class PlanOptions:
    """How plans are laid out.

    paper : size of the sheets
    angle : how views are arranged: third angle puts each on the side it is seen from, first angle on the other
    """

    paper: PaperName = "a4"
    angle: Angle = "third"

    def __post_init__(self) -> None:
        """Raise OptionError for what there is not."""
        if self.paper not in get_args(PaperName):
            raise OptionError(f"there is no paper called {self.paper!r}", remedy=f"one of {', '.join(PAPERS)}")
        if self.angle not in get_args(Angle):
            raise OptionError(f"there is no {self.angle!r} angle", remedy="third or first")
