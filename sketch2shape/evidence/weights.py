"""Weights of the witnesses, written by `scripts/fit_confidence.py`; see `calibration`."""

CENTRE = (
    0.0942,  # unexplained
    0.0543,  # attached
    0.0161,  # closed
    0.3644,  # loose
    0.0889,  # weakest
    0.4291,  # noise
    1.6566,  # vertices
    0.1342,  # unseen
    0.0074,  # bend
    0.0597,  # flat
    3.3479,  # shallow
    5.1096,  # small
    0.0512,  # doubled
    1.299,  # map
    0.2183,  # rival
)
SPREAD = (
    0.1737,  # unexplained
    0.103,  # attached
    0.0629,  # closed
    0.8077,  # loose
    0.1955,  # weakest
    0.685,  # noise
    0.3803,  # vertices
    0.2122,  # unseen
    0.0211,  # bend
    0.237,  # flat
    0.8445,  # shallow
    0.6341,  # small
    0.1581,  # doubled
    0.2111,  # map
    0.338,  # rival
)
WEIGHT = (
    1.3663,  # whole
    0.0,  # unexplained
    -0.1626,  # attached
    -0.6058,  # closed
    -1.2912,  # loose
    -0.6187,  # weakest
    0.0,  # noise
    -0.0728,  # vertices
    -0.3256,  # unseen
    -0.3696,  # bend
    0.0,  # flat
    0.8012,  # shallow
    1.0128,  # small
    -0.9789,  # doubled
    -0.5995,  # map
    -1.3896,  # rival
)
BIAS = 1.8505
