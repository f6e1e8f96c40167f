"""Weights of the witnesses, written by `scripts/fit_confidence.py`; see `calibration`."""

CENTRE = (
    0.1156,  # unexplained
    0.0779,  # attached
    0.0196,  # closed
    1.1555,  # missing
    0.1297,  # weakest
    0.384,  # noise
    3.2762,  # gap
    1.6315,  # vertices
    0.1637,  # unseen
    0.8972,  # bow
    0.1108,  # flat
    3.2298,  # shallow
    5.0205,  # small
    0.1195,  # doubled
    0.012,  # holes
    1.2703,  # map
)
SPREAD = (
    0.1999,  # unexplained
    0.1345,  # attached
    0.0825,  # closed
    1.4926,  # missing
    0.261,  # weakest
    0.6278,  # noise
    2.1035,  # gap
    0.3855,  # vertices
    0.2318,  # unseen
    2.1587,  # bow
    0.3139,  # flat
    0.8626,  # shallow
    0.7293,  # small
    0.2578,  # doubled
    0.1091,  # holes
    0.1521,  # map
)
WEIGHT = (
    -1.0846,  # unexplained
    -1.0737,  # attached
    -0.5601,  # closed
    0.0894,  # missing
    -0.4417,  # weakest
    -0.0754,  # noise
    0.1016,  # gap
    -0.5366,  # vertices
    -0.4063,  # unseen
    -0.8371,  # bow
    -0.5734,  # flat
    0.3036,  # shallow
    0.1363,  # small
    -2.2672,  # doubled
    0.0743,  # holes
    -0.5829,  # map
)
BIAS = 0.5983
