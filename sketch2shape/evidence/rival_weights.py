"""Weights of a rival, written by `scripts/fit_confidence.py`; see `rivals`."""

CENTRE = (
    0.9282,  # alone
    0.376,  # rival
)
SPREAD = (
    3.5199,  # alone
    0.382,  # rival
)
WEIGHT = (
    2.5582,  # alone
    -1.4117,  # rival
)
BIAS = 1.3878
