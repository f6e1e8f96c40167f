"""The table of a batch and its summary."""

from __future__ import annotations

import csv
import io
import json

import pytest

from sketch2shape.batch.plan import Planned
from sketch2shape.batch.table import check_table, encode_table, show_summary, summary
from sketch2shape.conversion.convert import Outcome
from sketch2shape.conversion.summary import Measures
from sketch2shape.errors import UsageError

MEASURES = (Measures(4.0, 3.0, 2.0, 52.0, 24.0, "mm"), Measures(1.0, 1.0, 1.0, 6.0, 1.0, "mm"))
ROWS = [
    (
        Planned("in/a,b.png", "a,b.png", ()),
        Outcome("a,b.png", 0, None, None, 2, 0.987654, "", {"o.obj": "1", "o.json": "2"}, 0.5, "two boxes", MEASURES),
    ),
    (Planned("in/ü\udcff\n.png", "ü\udcff\n.png", ()), Outcome("ü", 5, "nothing, really", "draw")),
]


def test_json_lines():
    first, second = map(json.loads, encode_table("r.jsonl", ROWS).splitlines())
    assert first["name"] == "a,b.png"
    assert (first["status"], first["objects"], first["confidence"]) == ("ok", 2, 0.9877)
    assert first["outputs"] == ["o.json", "o.obj"]
    assert [solid["volume"] for solid in first["solids"]] == [24.0, 1.0]
    assert second["solids"] == []
    assert (second["name"], second["status"], second["exit_code"]) == ("ü\udcff\n.png", "failed", 5)


def test_csv():
    rows = list(csv.DictReader(io.StringIO(encode_table("r.CSV", ROWS).decode())))
    assert rows[0]["name"] == "a,b.png"
    assert rows[0]["outputs"] == "o.json|o.obj"
    assert (rows[0]["width"], rows[0]["surface"], rows[0]["unit"]) == ("4.0|1.0", "52.0|6.0", "mm|mm")
    assert rows[1]["volume"] == ""
    assert rows[1]["message"] == "nothing, really"


@pytest.mark.parametrize("name", ["=1+1.png", "+a.png", "-a.png", "@a.png"])
def test_no_cell_is_a_formula(name):
    row = [(Planned(name, name, ()), Outcome(name, 5, "nothing"))]
    (read,) = csv.DictReader(io.StringIO(encode_table("r.csv", row).decode()))
    assert read["name"] == "'" + name
    assert json.loads(encode_table("r.jsonl", row))["name"] == name  # no spreadsheet reads this one


def test_names_of_tables():
    check_table("a.jsonl")
    with pytest.raises(UsageError):
        check_table("a.xlsx")


def test_summary_counts_by_kind():
    rows = summary([outcome for _, outcome in ROWS], 1.25)
    assert rows == [("1", "done (0)"), ("1", "no two-face object found (5)"), ("2", "inputs in 1.2 s")]


@pytest.mark.parametrize("terminal", [False, True])
def test_summary_is_shown(terminal):
    out = io.StringIO()
    out.isatty = lambda: terminal
    show_summary([("7", "done (0)")], out)
    assert "7" in out.getvalue()
    assert "done (0)" in out.getvalue()
