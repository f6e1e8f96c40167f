"""The best few of many hypotheses."""

import numpy as np
from sketches import DEPTH, SQUARE, prism, sheet_of

from sketch2shape.hypotheses.hypothesis import Rings
from sketch2shape.search.shortlist import FIRST, HOPE, MOST_HYPOTHESES, SHORTLIST, VAIN, shortlist, verified

SHEET = sheet_of(prism(SQUARE, SQUARE + DEPTH))
BOX = Rings((SQUARE,), (SQUARE + DEPTH,))
WRONG = Rings((SQUARE,), (SQUARE + DEPTH + [14.0, 0],))


def noted(taken):
    """The box, then 99 worse ones, each noted as it is asked for."""
    for k in range(100):
        taken.append(k)
        yield BOX if k == 0 else Rings((SQUARE + 0.1 * k,), (SQUARE + DEPTH,))


def test_the_best_comes_first_and_few_are_kept():
    some = [WRONG, BOX, *(Rings((SQUARE + k,), (SQUARE + DEPTH,)) for k in range(1, 12))]
    best = shortlist(some, SHEET, [])
    assert np.array_equal(best[0][0].vertices, BOX.vertices)
    scores = [evidence.score for _, evidence in best]
    assert scores == sorted(scores, reverse=True)
    assert len(best) <= SHORTLIST


def test_a_nearly_perfect_one_ends_the_search():
    taken = []
    assert shortlist(noted(taken), SHEET, [], enough=1)[0][1].score > 0.995
    assert len(taken) < 10


def test_what_is_known_stays_in_the_running():
    known = list(verified([BOX], SHEET))
    assert shortlist([WRONG], SHEET, known)[0][0] is BOX


def test_the_same_hypothesis_is_judged_once_and_nonsense_never():
    infinite = Rings((SQUARE,), (SQUARE + np.inf,))
    assert len(list(verified([infinite, BOX, BOX, Rings((SQUARE,), (SQUARE,))], SHEET))) == 1


def test_two_faces_on_the_same_lines_are_no_object():
    sheet = sheet_of(prism(SQUARE, SQUARE + DEPTH), reach=8.0)
    assert len(list(verified([BOX], sheet))) == 1
    assert list(verified([Rings((SQUARE,), (SQUARE + [9.0, -6],))], sheet)) == []


def test_two_faces_alike_that_explain_all_ink_end_the_search_after_their_batch():
    taken = []
    assert shortlist(noted(taken), SHEET, [], enough=5)[0][1].score > 0.995
    assert len(taken) == FIRST * 5


def test_hypotheses_without_hope_are_given_up():
    taken = []

    def source():
        for k in range(MOST_HYPOTHESES):
            taken.append(k)
            yield Rings((SQUARE[:3] + [k, 3.0 * k],), (SQUARE[:3] + DEPTH + [k, 3.0 * k],))

    assert all(evidence.score < HOPE for _, evidence in shortlist(source(), SHEET, []))
    assert VAIN <= len(taken) < MOST_HYPOTHESES
