"""Weights of a rival, written by `scripts/fit_confidence.py`; see `rivals`."""

CENTRE = (
    0.0,  # alone
    0.0,  # rival
)
SPREAD = (
    1.0,  # alone
    1.0,  # rival
)
WEIGHT = (
    0.95,  # alone
    -3.51,  # rival
)
BIAS = 1.66
