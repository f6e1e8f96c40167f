"""What lies on and around the objects of real drawings, by name: `NUISANCES["arrows"](drawn, rng)`.

Each nuisance invents its own number, sizes and places, and returns layers of ink to be laid under or over the object.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from synthetic.arrows import arrows, callouts
from synthetic.auxiliary import auxiliary, run_on, vertex_dots
from synthetic.beside import beside
from synthetic.dimensioning import dimensioned
from synthetic.fills import bare_fill, filled, hatched, tinted
from synthetic.layers import Drawn, Layer
from synthetic.lettering import words_across

Nuisance = Callable[[Drawn, np.random.Generator], list[Layer]]

NUISANCES: dict[str, Nuisance] = {
    "arrows": arrows,
    "callouts": callouts,
    "words": words_across,
    "dimensioned": dimensioned,
    "auxiliary": auxiliary,
    "vertex_dots": vertex_dots,
    "run_on": run_on,
    "beside": beside,
    "hatched": hatched,
    "filled": filled,
    "bare": bare_fill,
    "tinted": tinted,
}
