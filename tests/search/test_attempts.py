"""What each round makes of a drawing, and in which order rounds are asked."""

import pytest
from sketches import DEPTH, L_SHAPE, SQUARE, ink_of, prism

from sketch2shape.ink.groups import split_groups
from sketch2shape.search.attempts import GOOD, attempts
from sketch2shape.strokes.skeleton import thin


def attempts_at(picture):
    group = split_groups(ink_of(picture))[0]
    return attempts(group, thin(group.ink))


@pytest.mark.parametrize("face", [SQUARE, L_SHAPE], ids=["box", "L"])
def test_the_first_round_explains_a_ruled_wireframe(face):
    first = next(attempts_at(prism(face, face + DEPTH)))
    assert first.number == 0
    assert first.score >= GOOD
    assert first.is_sound
    assert first.shortlist[0][1].lines == "wire"
    assert first.best.sizes == (len(face),)


def test_a_drawing_that_can_be_seen_through_is_taken_for_a_wireframe_before_anything_else():
    """Until the rounds that look for wireframes have been asked, no shortlist holds faces with a hidden back."""
    early = [a for a, _ in zip(attempts_at(prism(SQUARE, SQUARE + DEPTH)), range(3), strict=False)]
    assert [a.number for a in early] == [0, 1, 2]
    assert all(evidence.lines == "wire" for a in early for _, evidence in a.shortlist)


def test_a_drawing_without_crossing_strokes_is_asked_round_by_round():
    numbers = [a.number for a in attempts_at(prism(SQUARE, SQUARE + DEPTH, "removed"))]
    assert len(numbers) > 1
    assert numbers == sorted(set(numbers))  # none comes back, as it would after a first look for wireframes
    first = next(attempts_at(prism(SQUARE, SQUARE + DEPTH, "removed")))
    assert first.shortlist[0][1].lines == "removed"
