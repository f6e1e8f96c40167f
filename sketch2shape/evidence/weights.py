"""Weights of the witnesses, written by `scripts/fit_confidence.py`; see `calibration`."""

CENTRE = (
    0.1081,  # unexplained
    0.0625,  # attached
    0.0194,  # closed
    0.436,  # loose
    0.0993,  # weakest
    0.4248,  # noise
    1.6348,  # vertices
    0.1262,  # unseen
    0.0193,  # bend
    0.0694,  # flat
    3.2884,  # shallow
    5.0293,  # small
    0.0631,  # doubled
    1.32,  # map
)
SPREAD = (
    0.1791,  # unexplained
    0.1076,  # attached
    0.0693,  # closed
    0.8721,  # loose
    0.2007,  # weakest
    0.6992,  # noise
    0.3677,  # vertices
    0.206,  # unseen
    0.0485,  # bend
    0.2542,  # flat
    0.8842,  # shallow
    0.6471,  # small
    0.1775,  # doubled
    0.2243,  # map
)
WEIGHT = (
    2.2886,  # whole
    -0.0222,  # unexplained
    -0.4804,  # attached
    -0.5309,  # closed
    -1.1746,  # loose
    -0.293,  # weakest
    -0.2885,  # noise
    -0.4548,  # vertices
    0.0,  # unseen
    -0.9617,  # bend
    0.0,  # flat
    0.4564,  # shallow
    0.8066,  # small
    -0.8124,  # doubled
    -0.7999,  # map
)
BIAS = 0.941
