"""Completion in shells, and the manual page: made from the parser."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from sketch2shape.command.completion import SHELLS, completion
from sketch2shape.command.parser import build_parser

ROOT = Path(__file__).parents[2]


@pytest.mark.parametrize("shell", SHELLS)
def test_every_option_is_completed(shell, capsys):
    with pytest.raises(SystemExit) as stop:
        build_parser().parse_args(["--print-completion", shell])
    assert stop.value.code == 0
    script = capsys.readouterr().out
    for action in build_parser()._actions:
        for name in action.option_strings:
            assert name.lstrip("-") in script
    assert "axonometric" in script
    assert "face.dxf" in script


def test_bash_completes_options_their_values_and_files(tmp_path):
    if shutil.which("bash") is None:
        pytest.skip("bash is not installed")
    (tmp_path / "drawing.png").touch()
    script = completion(build_parser(), "bash")
    for words, expected in (("--overw", "--overwrite"), ("--projection obl", "oblique"), ("draw", "drawing.png")):
        line = f"{script}\nCOMP_WORDS=(sketch2shape {words}); COMP_CWORD=$((${{#COMP_WORDS[@]}}-1)); _sketch2shape"
        done = subprocess.run(
            ["bash", "-c", line + '; echo "${COMPREPLY[*]}"'], cwd=tmp_path, capture_output=True, text=True, check=True
        )
        assert done.stdout.split() == [expected]


def test_the_manual_page_is_made_from_the_parser():
    script = ROOT / "scripts" / "make_man_page.py"
    assert subprocess.run([sys.executable, str(script), "--check"], check=False).returncode == 0
