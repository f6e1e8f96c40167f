"""Weights of the witnesses, written by `scripts/fit_confidence.py`; see `calibration`."""

CENTRE = (
    0.1143,  # unexplained
    0.063,  # attached
    0.0214,  # closed
    0.4531,  # loose
    0.0968,  # weakest
    0.4319,  # noise
    1.6295,  # vertices
    0.1291,  # unseen
    0.0078,  # bend
    0.0716,  # flat
    3.2592,  # shallow
    5.0296,  # small
    0.0623,  # doubled
    1.3182,  # map
    0.0062,  # chords
)
SPREAD = (
    0.1905,  # unexplained
    0.1095,  # attached
    0.0735,  # closed
    0.9009,  # loose
    0.2032,  # weakest
    0.7051,  # noise
    0.3724,  # vertices
    0.2086,  # unseen
    0.0224,  # bend
    0.2578,  # flat
    0.8845,  # shallow
    0.6479,  # small
    0.1738,  # doubled
    0.2228,  # map
    0.0631,  # chords
)
WEIGHT = (
    2.0782,  # whole
    0.0,  # unexplained
    -0.7126,  # attached
    -0.51,  # closed
    -1.2294,  # loose
    -0.5082,  # weakest
    -0.5593,  # noise
    -0.141,  # vertices
    -0.1805,  # unseen
    -0.7453,  # bend
    0.0,  # flat
    0.868,  # shallow
    1.1756,  # small
    -0.713,  # doubled
    -0.7826,  # map
    -0.574,  # chords
)
BIAS = 0.8902
