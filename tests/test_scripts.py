"""Scripts run by their path, from anywhere, with nothing but the package installed."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from loaded import loaded

SCRIPTS = Path(__file__).parent.parent / "scripts"


@pytest.mark.parametrize("name", ["make_drawings", "evaluate", "evaluate_lifting", "evaluate_round_lifting"])
def test_a_script_finds_what_it_imports(name, tmp_path):
    kept = {k: v for k, v in os.environ.items() if k != "PYTHONPATH"}
    ran = subprocess.run(
        [sys.executable, str(SCRIPTS / f"{name}.py"), "--help"], cwd=tmp_path, env=kept, capture_output=True, text=True
    )
    assert ran.returncode == 0, ran.stderr
    assert "usage:" in ran.stdout


def test_what_is_written_by_hand_stays_when_the_page_of_the_lifting_is_written_anew(tmp_path):
    evaluate_lifting = loaded("evaluate_lifting")
    page = tmp_path / "page.md"
    assert evaluate_lifting.by_hand(page) == ""
    page.write_text("## Made\n\na\n\n## What nothing fixes\n\nb\n\n## How often\n\nc\n")
    assert evaluate_lifting.by_hand(page) == "## What nothing fixes\n\nb\n\n"
