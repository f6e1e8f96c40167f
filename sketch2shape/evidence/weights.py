"""Weights of the witnesses, written by `scripts/fit_confidence.py`; see `calibration`."""

CENTRE = (
    0.1095,  # unexplained
    0.0767,  # attached
    0.02,  # closed
    1.1321,  # missing
    0.1223,  # weakest
    0.3659,  # noise
    3.2406,  # gap
    1.6395,  # vertices
    0.1597,  # unseen
    0.4954,  # bow
    0.0925,  # flat
    3.2739,  # shallow
    5.0446,  # small
    0.0975,  # doubled
    0.0125,  # holes
    1.269,  # map
)
SPREAD = (
    0.196,  # unexplained
    0.1368,  # attached
    0.084,  # closed
    1.4497,  # missing
    0.2546,  # weakest
    0.6173,  # noise
    2.1103,  # gap
    0.3812,  # vertices
    0.2259,  # unseen
    0.4577,  # bow
    0.2897,  # flat
    0.8441,  # shallow
    0.7165,  # small
    0.2361,  # doubled
    0.1111,  # holes
    0.1503,  # map
)
WEIGHT = (
    -0.9255,  # unexplained
    -1.0117,  # attached
    -0.6168,  # closed
    -0.0578,  # missing
    -0.5493,  # weakest
    -0.3811,  # noise
    0.042,  # gap
    -0.4915,  # vertices
    -0.377,  # unseen
    -0.1862,  # bow
    -0.5303,  # flat
    0.3152,  # shallow
    0.2016,  # small
    -1.9504,  # doubled
    0.0946,  # holes
    -0.2804,  # map
)
BIAS = 1.0137
