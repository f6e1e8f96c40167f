"""Names of strangers: equal stems, case twins, Unicode forms, newlines, dashes. One output each, inputs unchanged."""

from __future__ import annotations

import hashlib
import json
import subprocess
import sys
import tempfile
import unicodedata
from pathlib import Path

from benchmarks.faults.samples import drawing
from sketch2shape.batch.plan import fold

_FOLDERS = [
    *("a", "A", "b c", "--json", "-o", "ü", unicodedata.normalize("NFD", "ü"), "图纸", "new\nline", ".hidden"),
    *("quote'\"", "$(x)", "*", "a.png", "tab\t", "%s", "x" * 200, "🙂", "con", "trailing "),
]
_FILES = [
    *("plan.png", "plan.jpg", "PLAN.PNG", "Plan.bmp", "plan.png.png", "plan.png~2.gif", "-plan.png", "--help.png"),
    *("pl an.png", "pl\nan.png", "plän.png", unicodedata.normalize("NFD", "plän.png"), "straße.png", "STRASSE.png"),
    *("图.png", "🙂.png", ".png.png", "a.b.c.png", "plan.", "ﬁ.png", "fi.png", "y" * 200 + ".png", "K.png", "k.png"),
    "\udcff\udcfe.png",
]


def run(size: int = 500) -> dict[str, object]:
    """`size` pictures in nested folders of odd names."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        inputs = _fill(folder / "in", size)
        before = {path: _digest(path) for path in inputs}
        command = [sys.executable, "-m", "sketch2shape", "--", str(folder / "in")]
        command[3:3] = ["-o", str(folder / "out"), "--report", str(folder / "report.jsonl"), "--quiet"]
        done = subprocess.run(command, capture_output=True, check=False)
        rows = list(map(json.loads, (folder / "report.jsonl").read_text().splitlines()))
        meshes = [path for path in (folder / "out").rglob("*.obj") if path.is_file()]
        findings = [f"exit code {done.returncode}: {done.stderr[:300]!r}"] if done.returncode else []
        if not len(rows) == len(meshes) == len(inputs):
            findings.append(f"{len(inputs)} inputs, {len(rows)} rows, {len(meshes)} meshes")
        keys = {fold(str(path.relative_to(folder / "out"))) for path in meshes}
        if len(keys) < len(meshes):
            findings.append(f"{len(meshes) - len(keys)} meshes share a name on some file system")
        kept = {row["outputs"][0] for row in rows if row["outputs"]}
        if len(kept) != len(meshes):
            findings.append("an output was reported twice")
        findings += [f"{path!r} was changed" for path in inputs if _digest(path) != before[path]]
        findings += [f"{path!r} has appeared" for path in set(_files(folder / "in")) - set(inputs)]
    return {
        "inputs": len(inputs),
        "folders": len({p.parent for p in inputs}),
        "meshes": len(meshes),
        "findings": findings,
    }


def _fill(root: Path, size: int) -> list[Path]:
    """Folders within folders, and files in turn, until there are enough."""
    folders = [Path(), *(Path(f) for f in _FOLDERS), *(Path(f, g) for f in _FOLDERS[:4] for g in _FOLDERS[:10])]
    names = [name for name in _FILES if name.rpartition(".")[2]]
    made: list[Path] = []
    number = 0
    while len(made) < size:
        path = root / folders[number % len(folders)] / names[(number // len(folders)) % len(names)]
        number += 1
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.exists():
            kind = {".jpg": "JPEG", ".bmp": "BMP", ".gif": "GIF"}.get(path.suffix.lower(), "PNG")
            drawing(150, 120).save(path, kind)
            made.append(path)
    return made


def _files(root: Path) -> list[Path]:
    return [path for path in root.rglob("*") if path.is_file()]


def _digest(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()
