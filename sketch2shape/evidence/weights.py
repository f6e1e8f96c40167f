"""Weights of the witnesses, written by `scripts/fit_confidence.py`; see `calibration`."""

CENTRE = (
    0.0977,  # unexplained
    0.0574,  # attached
    0.0163,  # closed
    0.3888,  # loose
    0.0951,  # weakest
    0.445,  # noise
    1.657,  # vertices
    0.1341,  # unseen
    0.0212,  # bend
    0.0625,  # flat
    3.3259,  # shallow
    5.1134,  # small
    0.0558,  # doubled
    1.3027,  # map
)
SPREAD = (
    0.1748,  # unexplained
    0.1065,  # attached
    0.0624,  # closed
    0.823,  # loose
    0.2068,  # weakest
    0.704,  # noise
    0.38,  # vertices
    0.2123,  # unseen
    0.0553,  # bend
    0.2421,  # flat
    0.866,  # shallow
    0.6235,  # small
    0.1671,  # doubled
    0.2214,  # map
)
WEIGHT = (
    2.4452,  # whole
    0.0,  # unexplained
    -0.56,  # attached
    -0.5297,  # closed
    -1.2773,  # loose
    -0.0411,  # weakest
    -0.5887,  # noise
    -0.0971,  # vertices
    -0.4106,  # unseen
    -0.542,  # bend
    0.0,  # flat
    0.8625,  # shallow
    0.5952,  # small
    -1.0909,  # doubled
    -0.5313,  # map
)
BIAS = 1.2115
