"""How well the tool reads drawings whose truth is known: `python scripts/evaluate.py` writes docs/results.md."""
