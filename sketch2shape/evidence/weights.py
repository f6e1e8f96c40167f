"""Weights of the witnesses, written by `scripts/fit_confidence.py`; see `calibration`."""

CENTRE = (
    0.147,  # unexplained
    0.0931,  # attached
    0.0083,  # closed
    0.7134,  # loose
    0.1749,  # weakest
    0.5616,  # noise
    1.6922,  # vertices
    0.1746,  # unseen
    0.0331,  # bend
    0.0589,  # flat
    2.9952,  # shallow
    4.9116,  # small
    0.0916,  # doubled
    1.3062,  # map
)
SPREAD = (
    0.2027,  # unexplained
    0.1551,  # attached
    0.0404,  # closed
    1.0436,  # loose
    0.2913,  # weakest
    0.7677,  # noise
    0.4152,  # vertices
    0.2621,  # unseen
    0.0561,  # bend
    0.2355,  # flat
    0.8942,  # shallow
    0.5373,  # small
    0.2103,  # doubled
    0.2386,  # map
)
WEIGHT = (
    3.581,  # whole
    0.3048,  # unexplained
    -0.7302,  # attached
    -0.2064,  # closed
    -0.8893,  # loose
    -0.586,  # weakest
    -0.5315,  # noise
    -0.0707,  # vertices
    -0.4555,  # unseen
    -0.7149,  # bend
    -0.2499,  # flat
    0.2634,  # shallow
    0.5364,  # small
    -1.2679,  # doubled
    -0.4717,  # map
)
BIAS = -0.8284
