"""Weights of the witnesses, written by `scripts/fit_confidence.py`; see `calibration`."""

CENTRE = (0.0,) * 16
SPREAD = (1.0,) * 16
WEIGHT = (0.0,) * 16
BIAS = 0.0
