"""Mechanisms of the heart, and what stands in for each of them where `ablate.py` switches it off."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from sketch2shape.fit import refinement
from sketch2shape.search import tolerances
from sketch2shape.search.objects import PLAINLY
from sketch2shape.sweeps import Way

HUGE = 1e9
"""Instead of a limit: infinity times nothing is no number."""


class Mechanism(NamedTuple):
    """Something the heart does that it could leave out.

    name : in words
    off  : dotted name of each function or constant -> what stands in for it where the mechanism is switched off
    """

    name: str
    off: dict[str, Any]

    @property
    def room(self) -> str:
        """Where it lives."""
        return next(iter(self.off), "..").split(".")[1]


def _first(first: Any, *_: Any, **__: Any) -> Any:
    return first


def _least_nats(found: Any) -> Any:
    return min(found, key=lambda f: f.nats)


def _first_two(first: Any, second: Any, *_: Any) -> Any:
    return first, second


def _always(value: Any) -> Callable[..., Any]:
    return lambda *_, **__: value


def _only_measured(rings: Any, *how: Any) -> Any:
    return rings, refinement.refine(rings, *how)[1]


def _as_it_is(sweep: Any) -> Any:
    return [sweep]


def _in(module: str, **off: Any) -> dict[str, Any]:
    return {f"sketch2shape.{module}.{name}": value for name, value in off.items()}


def _as_good(stacked: Any, _: Any = None) -> Any:
    """One for each, instead of a bound."""
    return np.ones(len(stacked.vertices))


def _but_the_last(*how: Any) -> Any:
    return tolerances.rounds_for(*how)[:-1]


def _everywhere(points: Any, _: Any) -> Any:
    return np.ones(points.shape[:-1], np.bool_)


def _all_simple(polygons: Any) -> Any:
    return np.ones(polygons.shape[:-2], np.bool_)


def _as_swept(_: Any, backs: Any, *__: Any) -> Any:
    return [None] * len(backs)


def _as_guessed(shift: Any, *_: Any) -> Way:
    return Way(shift)


_NONE, _NO = _always(()), _always(False)
_NO_MAPS = _always(np.zeros((0, 3, 3)))

MECHANISMS = (
    Mechanism("nothing: how far times differ by chance", {}),
    Mechanism("exact reading of ruled vector lines", _in("search.objects", find_exact=_always(None))),
    # the search for straight objects
    Mechanism("wireframes", _in("search.attempts", wire_hypotheses=_NONE)),
    Mechanism("faces of regions", _in("hypotheses.opaque", caps=_NONE)),
    Mechanism("faces of regions without corners", _in("hypotheses.opaque", loose_caps=_NONE)),
    Mechanism("second look", _in("search.search", second_attempts=_NONE)),
    Mechanism("second look: walks", _in("search.attempts", walked=_NONE)),
    Mechanism("second look: unions of regions", _in("search.attempts", united=_NONE)),
    Mechanism("third look: neighbours", _in("search.search", climbed_attempts=_NONE)),
    Mechanism("climbing by the energy", _in("search.search", climb=_NONE)),
    Mechanism("close vertices exchanged", _in("search.climbing", _exchanged=_NONE)),
    Mechanism("flat vertices of trusted answers left out", _in("search.climbing", _left_out=_NONE)),
    Mechanism("hidden vertices on the plainest map", _in("search.search", with_hidden=_first)),
    Mechanism("tips ahead of where strokes run into one", _in("hypotheses.opaque", _with_tips=_first_two)),
    Mechanism("edges cut off by the border", _in("search.objects", closed_at_border=_always(None))),
    Mechanism(
        "edges go on beyond the border",
        _in("evidence.score", in_picture=_everywhere) | _in("evidence.energy", in_picture=_everywhere),
    ),
    Mechanism("early rounds for wireframes alone", _in("search.attempts", _early=_always([]))),
    Mechanism("a close look", _in("search.attempts", BENT=np.inf, STEADY=0.0)),
    Mechanism("fine rounds later where lines are known", _in("search.attempts", _likely_first=_first)),
    Mechanism("few ends in threes: no wireframe", _in("search.attempts", FEW_IN_THREES=0.0)),
    Mechanism("rounds limited by narrow ink", _in("search.attempts", COARSEST=np.inf)),
    Mechanism("the last resort", _in("search.attempts", rounds_for=_but_the_last)),
    Mechanism("the last resort has to be good", _in("search.attempts", ROUGH=0.0)),
    Mechanism("gaps at corners bridged", _in("search.observed", bridged=_always(None))),
    Mechanism(
        "textures and scribbles given up",
        _in("search.observed", _is_no_drawing=_NO) | _in("search.search", _is_scribble=_NO),
    ),
    Mechanism("fine lines enlarged", _in("search.closer", FINE=0.0)),
    Mechanism("loose ends drawn on", _in("search.tolerances", without_loose_ends=_first)),
    Mechanism("stale searches end", _in("search.search", STALE=np.inf)),
    Mechanism("hidden vertices where dashes meet", _in("search.search", at_dashes=_first_two)),
    Mechanism("a vertex caught by wrong ink put right", _in("search.refining", _put_right=_first_two)),
    Mechanism("dashes told by thin ink", _in("search.refining", is_dashed=_NO)),
    Mechanism(
        "a tie goes to the first",
        _in("search.found", TIE=0.0) | _in("search.search", TIE=0.0) | _in("search.climbing", TIE=0.0),
    ),
    Mechanism(
        "one hand", _in("search.found", hand_of=_always(np.inf)) | _in("search.climbing", hand_of=_always(np.inf))
    ),
    Mechanism("a plain answer limits vertices", _in("search.search", _is_plainest=_NO)),
    Mechanism("an exact answer ends a round", _in("search.search", _is_exact=_NO)),
    Mechanism("a plain answer ends a source", _in("search.shortlist", _is_plain=_NO)),
    Mechanism("a vain source ends", _in("search.shortlist", VAIN=HUGE)),
    Mechanism("a first look bounds the score", _in("search.shortlist", most_possible=_as_good)),
    Mechanism("shallow objects are none", _in("search.shortlist", SHALLOWEST=0.0)),
    # moving to the ink
    Mechanism(
        "refinement", _in("search.refining", refine=_only_measured) | _in("fit.simplification", refine=_only_measured)
    ),
    Mechanism("simplification", _in("search.refining", simplified=_first_two)),
    Mechanism("simplification: settled ways", _in("fit.simplification", MOST_SETTLED=0)),
    Mechanism("simplification: unseen bends", _in("fit.simplification", UNSEEN_BEND=0.0)),
    Mechanism("simplification: marks at corners", _in("fit.simplification", MARK=0.0)),
    Mechanism("polishing of sweeps", _in("search.found_sweep", polished=_first)),
    Mechanism("polishing: ratio of circles held", _in("fit.polishing", FIXED_RATIO=0.0)),
    # the judge
    Mechanism("the weakest edge holds a score", _in("evidence.score", _held_by=np.ones_like)),
    Mechanism("edges along others cost", _in("evidence.energy", coincidences=_always(0))),
    Mechanism("gaps at ends are cheap", _in("evidence.energy", GAP_PRICE=1.0)),
    Mechanism("edges explain no more than their length", _in("evidence.energy", CROWDED=HUGE)),
    Mechanism("no more noise than the hand's", _in("evidence.energy", STEADY=HUGE)),
    Mechanism("long foreign strokes are cheaper", _in("evidence.view", STROKE_UNIT=HUGE)),
    Mechanism("strokes across others are told once", _in("evidence.view", MOST_LINKED=0)),
    Mechanism("specks are cheap", _in("evidence.view", SPECK=1.0, DASH=1.0)),
    Mechanism(
        "chords make flat figures doubtful",
        _in("evidence.witness", chords=_always(0.0)) | _in("evidence.sweep_witness", chords=_always(0.0)),
    ),
    Mechanism("rivals make answers doubtful", _in("search.search", rivalry=_always(0.0))),
    Mechanism("faces alone are no objects", _in("search.search", LEAST_DRAWN=0)),
    # sources of straight objects
    Mechanism("back faces pulled to drawn rungs", _in("hypotheses.opaque", _pulled=_as_swept)),
    Mechanism("cut tips of regions sharpened", _in("hypotheses.opaque", sharpened=_first)),
    Mechanism("maps from two rungs", _in("hypotheses.wireframe", _from_two=_NO_MAPS)),
    Mechanism("maps from three rungs", _in("hypotheses.wireframe", _from_three=_NO_MAPS)),
    Mechanism("holes of wireframes", _in("hypotheses.wireframe", with_holes=_always(None))),
    Mechanism("faces are simple polygons", _in("hypotheses.hypothesis", are_simple=_all_simple)),
    # the search for objects with arcs and points
    Mechanism("sweeps", _in("search.objects", find_sweep=_always(None))),
    Mechanism("a likely sweep stands at once", _in("search.objects", LIKELY=np.inf)),
    Mechanism("sweeps for ink that may be a hole", _in("search.objects", _leaves_some=_NO)),
    Mechanism("obtuse corners are no arcs", _in("search.objects", OBTUSE=np.inf)),
    Mechanism("what leaves much is not improved", _in("search.sweeping", VAIN=np.inf)),
    Mechanism(
        "textures are not put together", _in("sweeps.joined", MOST_SHARED=HUGE) | _in("sweeps.spans", MOST_LINES=HUGE)
    ),
    Mechanism("pyramids beside sure prisms", _in("search.objects", ATTACHED=np.inf)),
    Mechanism("pyramids beside prisms nearly at a point", _in("search.objects", CONVERGING=0.0)),
    Mechanism("bare figures are no answers", _in("search.objects", LACKING=np.inf)),
    Mechanism("sweeps: wireframes", _in("search.sweep_pairs", _coherent=_NONE)),
    Mechanism("sweeps: loops moved", _in("search.sweep_pairs", _moved=_NONE)),
    Mechanism("sweeps: loops drawn together", _in("search.sweep_pairs", _drawn_together=_NONE)),
    Mechanism("sweeps: thin wireframes by what they cover", _in("search.sweep_pairs", eroded_outline=_always(None))),
    Mechanism("sweeps: small holes", _in("search.sweep_improvement", small_holes=_NONE)),
    Mechanism("sweeps: vertices at the ends of rungs", _in("search.sweep_improvement", _at_rungs=_first)),
    Mechanism("sweeps: put together from rungs", _in("search.sweeping", joined=_NONE)),
    Mechanism("shifts told by rungs", _in("search.scene", wire_shifts=_always([]))),
    Mechanism(
        "sweeps compared under one hand",
        _in("search.found_sweep", cheapest=_least_nats)
        | _in("search.sweep_improvement", cheapest=_least_nats)
        | _in("search.sweeping", cheapest=_least_nats),
    ),
    Mechanism("sweeps: pyramids", _in("search.sweeping", _likely_pyramids=_always([]))),
    Mechanism("sweeps: ellipses", _in("search.scene", ellipses=_always([]))),
    Mechanism("pieces of bowed lines put together", _in("sweeps.loops", linked=_always([]))),
    Mechanism("sweeps: enclosed loops", _in("search.scene", enclosed_loops=_always([]))),
    Mechanism("close loops replace rough ones", _in("search.sweep_pairs", WHOLE=np.inf)),
    Mechanism("ways settled before they are cut", _in("search.sweep_pairs", settled=_first)),
    Mechanism("shifts settled on wires", _in("search.sweep_pairs", settled_wire=_as_guessed)),
    Mechanism("holes tell the shape of arcs", _in("search.sweep_pairs", MOST_HINTS=0)),
    Mechanism(
        "circles of a face in one frame",
        _in("search.sweep_pairs", in_one_frame=tuple) | _in("search.sweep_improvement", in_one_frame=tuple),
    ),
    Mechanism("a sweep's hand by the median", _in("search.found_sweep", _hand=_always(np.inf))),
    Mechanism("lines at smooth joints", _in("search.found_sweep", _manners=_as_it_is)),
    Mechanism("hands' arcs run on smoothly", _in("search.found_sweep", _smoothed=_first)),
    Mechanism("unlikely arcs given where nothing straight is", _in("search.objects", POSSIBLE=HUGE)),
    Mechanism("depth has to be seen", _in("search.sweeping", _shows_depth=_always(True))),
    Mechanism("hidden lines told as dashed", _in("search.sweeping", _dashed=_first)),
    Mechanism("shifts that grow in perspective", _in("search.sweep_improvement", _in_perspective=_first)),
    Mechanism("sweeps: round faces in perspective", _in("search.sweeping", _likely_rounds=_always([]))),
    Mechanism("arcs that lean in perspective", _in("search.sweep_pairs", _frame_along=_always(None))),
    Mechanism("rims of holes looked for afar", _in("search.sweep_improvement", _from_afar=_first)),
    Mechanism("centres of ways that leave lines", _in("search.sweep_improvement", _leaves_some=_NO)),
    Mechanism("round faces have sides", _in("search.sweeping", _has_sides=_always(True))),
    Mechanism("all cuts of likely outlines", _in("search.sweeping", MISSED=np.inf)),
    Mechanism("flat arcs where the answer is doubtful", _in("search.objects", PERHAPS=PLAINLY)),
    Mechanism("holes of sweeps", _in("search.sweep_improvement", with_holes=_first)),
    Mechanism("closed lines in faces are likely holes", _in("evidence.energy", LIKELY_HOLE=0.0)),
    Mechanism("needless vertices of sweeps dropped", _in("search.sweep_improvement", _simpler=_first)),
    Mechanism("notches of outlines dropped", _in("search.sweep_improvement", _without_notches=_NONE)),
    Mechanism("outlines put on the ink of both faces", _in("search.sweep_pairs", retraced=_first)),
    Mechanism("a face drawn twice is no object", _in("search.search", LAID=HUGE)),
    Mechanism(
        "what explains anything is no object",
        _in("search.search", is_crowded=_always(False)) | _in("search.sweeping", is_crowded=_always(False)),
    ),
    Mechanism("a tangle gets one look", _in("search.search", TANGLE=HUGE)),
    Mechanism("a closer look only where nothing fits", _in("search.closer", PARTLY=0.0)),
    Mechanism("a doubtful face alone is no object", _in("search.search", shows_little=_always(False))),
    Mechanism("writing makes answers doubtful", _in("search.objects", WRITING=1.0)),
    Mechanism("straight objects with round holes", _in("search.objects", find_drilled=_always(None))),
    Mechanism("points stand plumb", _in("search.found_sweep", _leaning=_always(0.0))),
    Mechanism("sides of a base cost", _in("search.sweeping", SIDE=0.0)),
    # sources of objects with arcs and points
    Mechanism("sweeps seen from the other side", _in("sweeps.sweep.Sweep", reversed=_first)),
    Mechanism("silhouettes are sure to be seen only whole", _in("sweeps.sweep", _doubtful=_first)),
    Mechanism("bases in front of hidden edges", _in("sweeps.pyramids", _closed=_NONE)),
    Mechanism("regular bases half hidden", _in("sweeps.pyramids", _regular_bases=_NONE)),
    Mechanism("feet of a pyramid by themselves", _in("sweeps.pyramids", _feet=_first)),
)
