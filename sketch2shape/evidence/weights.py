"""Weights of the witnesses, written by `scripts/fit_confidence.py`; see `calibration`."""

CENTRE = (
    0.1089,  # unexplained
    0.0765,  # attached
    0.0199,  # closed
    1.1321,  # missing
    0.1223,  # weakest
    0.3659,  # noise
    3.2543,  # gap
    1.6395,  # vertices
    0.1609,  # unseen
    0.4954,  # bow
    0.09,  # flat
    3.2748,  # shallow
    5.0422,  # small
    0.1051,  # doubled
    0.0125,  # holes
    1.2693,  # map
)
SPREAD = (
    0.196,  # unexplained
    0.1369,  # attached
    0.084,  # closed
    1.4497,  # missing
    0.2546,  # weakest
    0.6173,  # noise
    2.1071,  # gap
    0.3812,  # vertices
    0.2264,  # unseen
    0.4577,  # bow
    0.2862,  # flat
    0.8432,  # shallow
    0.7194,  # small
    0.242,  # doubled
    0.1111,  # holes
    0.1504,  # map
)
WEIGHT = (
    -0.8514,  # unexplained
    -1.0475,  # attached
    -0.6358,  # closed
    0.0082,  # missing
    -0.5698,  # weakest
    -0.2696,  # noise
    0.0306,  # gap
    -0.3952,  # vertices
    -0.4601,  # unseen
    -0.2104,  # bow
    -0.4272,  # flat
    0.3155,  # shallow
    0.1078,  # small
    -2.2592,  # doubled
    0.0853,  # holes
    -0.3325,  # map
)
BIAS = 0.942
