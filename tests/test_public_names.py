"""The public names: what type checkers and editors see of them is what there is."""

import ast
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

import sketch2shape as s2s

USER = """
import sketch2shape as s2s

reveal_type(s2s.reconstruct)
s2s.reconstruct("a.png", conector="ink")
s2s.recontruct("a.png")
s2s.reconstruct("a.png").objects[0].f3
"""


def test_type_checkers_see_every_name_that_is_loaded_lazily():
    tree = ast.parse(Path(s2s.__file__).read_text())
    block = next(n for n in tree.body if isinstance(n, ast.If))
    seen = {(n.module.rpartition(".")[2], a.name) for n in block.body for a in n.names}
    assert seen == {(room, name) for room, names in s2s._ROOMS.items() for name in names}


@pytest.mark.parametrize("name", s2s.__all__)
def test_every_name_loads(name):
    assert getattr(s2s, name) is not None
    assert name in dir(s2s)


def test_a_misspelt_name_is_an_attribute_error():
    with pytest.raises(AttributeError, match="recontruct"):
        _ = s2s.recontruct


def test_mypy_knows_the_signatures_and_refuses_misspelt_words(tmp_path):
    pytest.importorskip("mypy", reason="mypy is part of the extra `lint`")
    user = tmp_path / "user.py"
    user.write_text(USER)
    cache = os.environ.get("MYPY_CACHE_DIR", str(tmp_path / "cache"))
    call = [sys.executable, "-m", "mypy", "--strict", "--cache-dir", cache, str(user)]
    said = subprocess.run(call, capture_output=True, text=True, cwd=Path(s2s.__file__).parents[1]).stdout
    assert re.search(r":4: note: Revealed type is .*def \(source: Any.* -> .*Result", said)
    assert re.search(r':5: error: Unexpected keyword argument "conector"', said)
    assert re.search(r':6: error: Module has no attribute "recontruct"', said)
    assert re.search(r':7: error: "TwoFaceObject" has no attribute "f3"', said)


def test_importing_the_package_loads_no_array_library():
    code = "import sys, sketch2shape; print([m for m in ('numpy', 'cv2', 'trimesh', 'argparse') if m in sys.modules])"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True).stdout.strip() == "[]"
