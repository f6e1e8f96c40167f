"""The script that changes code to see whether tests notice: what it changes, what it samples, what it tells."""

from collections import Counter
from pathlib import Path

import pytest
from loaded import loaded

ROOT = Path(__file__).parent.parent


@pytest.fixture(scope="module")
def mutate():
    return loaded("mutate")


def some(mutate, places=40, each=3):
    return [mutate.Mutant(Path("a/b/c.py"), (p, 0), f"core/{k}", 0) for p in range(places) for k in range(each)]


def test_types_are_spared(mutate):
    text = "x: int | None = 3 | 4\ndef f(a: A | B) -> C | D:\n    return a | b\n"
    spans = mutate.types_in(text)
    lines = text.splitlines()
    assert sorted(lines[a[0] - 1][a[1] : b[1]] for a, b in spans) == ["A | B", "C | D", "int | None"]


def test_a_sample_takes_each_place_once_and_is_the_same_again(mutate):
    every = some(mutate)
    chosen = mutate.sample(every, 10, 4)
    assert len({m.place for m in chosen}) == len(chosen) == 10
    assert chosen == sorted(chosen) == mutate.sample(every, 10, 4)
    assert chosen != mutate.sample(every, 10, 5)


def test_no_sample_is_all_and_a_large_one_all_places(mutate):
    every = some(mutate)
    assert mutate.sample(every, 0, 1) == sorted(every)
    assert len(mutate.sample(every, 999, 1)) == 40


def test_fitted_numbers_and_faces_of_rooms_are_passed_over(mutate):
    modules = mutate.modules_of("evidence")
    assert Path("sketch2shape/evidence/score.py") in modules
    assert not {"__init__", "weights", "sweep_weights"} & {m.stem for m in modules}


def test_the_changed_line_is_shown(mutate):
    assert mutate.changed("a = 1\n    b < 2\n", "a = 1\n    b <= 2\n") == "  - b < 2\n  + b <= 2"


def test_the_summary_counts_fates_by_room(mutate):
    told = mutate.summary({"fit": Counter(survived=2, killed=5)}).splitlines()
    assert told[-1] == "| fit | 7 | 2 | 5 | 0 | 0 |"


def test_every_operator_is_one_of_the_library(mutate):
    plugins = pytest.importorskip("cosmic_ray.plugins")
    assert {f"core/{name}" for name in mutate.OPERATORS} <= set(plugins.operator_names())


def test_a_module_has_mutants_none_of_which_is_a_type(mutate):
    pytest.importorskip("cosmic_ray")
    module = Path("sketch2shape/search/objects.py")
    found = list(mutate.mutants(module))
    lines = (ROOT / module).read_text().splitlines()
    assert any("NumberReplacer" in m.operator and lines[m.place[0] - 1].startswith("MOST_VAIN") for m in found)
    assert not [m for m in found if "BitOr" in m.operator and "| None" in lines[m.place[0] - 1]]
