from importlib.resources import files

import pytest

from sketch2shape.pipeline import reconstruct
from sketch2shape.ui.examples import EXAMPLES, example_png

HOLES = {"hole": 1, "ring": 1, "holes": 2}
ROUND = ("cylinder", "ring", "channel", "holes", "cone")


@pytest.mark.parametrize("name", list(EXAMPLES))
def test_each_example_becomes_a_solid(name: str) -> None:
    result = reconstruct(example_png(name))
    assert len(result.objects) == 1
    assert result.objects[0].confidence >= 0.9
    assert result.mesh.is_watertight
    assert len(result.objects[0].holes) == HOLES.get(name, 0)
    assert bool(result.objects[0].arcs) == (name in ROUND)


def test_each_example_is_a_file_of_the_package_and_each_file_an_example() -> None:
    shipped = [f.name for f in files("sketch2shape.ui").joinpath("drawings").iterdir()]
    assert sorted(shipped) == sorted(f"{name}.png" for name in EXAMPLES)


def test_no_other_name_is_an_example() -> None:
    with pytest.raises(KeyError):
        example_png("../secret")
