"""Weights of the witnesses of sweeps, written by `scripts/fit_confidence.py`; see `calibration`."""

CENTRE = (
    0.05,  # unexplained
    0.03,  # attached
    0.01,  # closed
    0.5,  # missing
    0.4,  # noise
    4,  # gap
    2,  # numbers
    0.1,  # unseen
    3,  # shallow
    5,  # small
    0.3,  # pointed
    0.05,  # inferred
    0.3,  # standing
    0.2,  # holes
    0.1,  # lone
)
SPREAD = (
    0.15,  # unexplained
    0.1,  # attached
    0.05,  # closed
    1,  # missing
    0.5,  # noise
    1,  # gap
    0.5,  # numbers
    0.2,  # unseen
    0.8,  # shallow
    0.7,  # small
    0.45,  # pointed
    0.2,  # inferred
    1,  # standing
    0.4,  # holes
    0.3,  # lone
)
WEIGHT = (
    -1.5,  # unexplained
    -0.8,  # attached
    -0.6,  # closed
    -0.8,  # missing
    -0.5,  # noise
    0.6,  # gap
    -0.3,  # numbers
    -0.3,  # unseen
    0.2,  # shallow
    0.2,  # small
    0,  # pointed
    -0.5,  # inferred
    -0.4,  # standing
    0,  # holes
    -0.5,  # lone
)
BIAS = 1.5
