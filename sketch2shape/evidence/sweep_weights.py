"""Weights of the witnesses of sweeps, written by `scripts/fit_sweep_confidence.py`; see `sweep_calibration`."""

CENTRE = (
    0.1865,  # unexplained
    0.0242,  # attached
    0.0487,  # closed
    0.5145,  # missing
    1.2208,  # noise
    3.9492,  # gap
    2.1055,  # numbers
    0.0467,  # unseen
    2.82,  # shallow
    5.0159,  # small
    0.3225,  # pointed
    0.0725,  # inferred
    1.2217,  # standing
    0.5254,  # holes
    0.221,  # lone
)
SPREAD = (
    0.291,  # unexplained
    0.0854,  # attached
    0.1246,  # closed
    1.1431,  # missing
    0.9778,  # noise
    1.4818,  # gap
    0.5984,  # numbers
    0.1014,  # unseen
    1.1237,  # shallow
    0.4549,  # small
    0.4674,  # pointed
    0.2593,  # inferred
    2.4105,  # standing
    1.2111,  # holes
    0.4149,  # lone
)
WEIGHT = (
    -1.1785,  # unexplained
    -1.1767,  # attached
    -0.5405,  # closed
    -0.2077,  # missing
    -1.5127,  # noise
    0.177,  # gap
    -0.5185,  # numbers
    0.0,  # unseen
    0.5203,  # shallow
    0.6124,  # small
    0.3527,  # pointed
    0.0,  # inferred
    -0.8255,  # standing
    0.4519,  # holes
    -0.0215,  # lone
)
BIAS = -0.7678
