"""Weights of the witnesses of sweeps, written by `scripts/fit_sweep_confidence.py`; see `sweep_calibration`."""

CENTRE = (
    0.2852,  # unexplained
    0.0527,  # attached
    0.0724,  # closed
    0.5412,  # missing
    1.1793,  # noise
    3.5238,  # gap
    2.0024,  # numbers
    0.0447,  # unseen
    2.8977,  # shallow
    5.0332,  # small
    0.4857,  # pointed
    0.1429,  # inferred
    2.1298,  # standing
    0.3771,  # holes
    0.2029,  # lone
)
SPREAD = (
    0.3409,  # unexplained
    0.1346,  # attached
    0.1339,  # closed
    1.2215,  # missing
    0.9911,  # noise
    1.7722,  # gap
    0.5112,  # numbers
    0.0969,  # unseen
    1.0766,  # shallow
    0.4918,  # small
    0.4998,  # pointed
    0.3499,  # inferred
    2.9353,  # standing
    1.0285,  # holes
    0.4021,  # lone
)
WEIGHT = (
    -1.3962,  # unexplained
    -0.844,  # attached
    -0.9198,  # closed
    -0.1771,  # missing
    -1.2618,  # noise
    0.517,  # gap
    -0.5668,  # numbers
    0.0,  # unseen
    0.458,  # shallow
    0.6537,  # small
    0.59,  # pointed
    0.0,  # inferred
    -0.9672,  # standing
    0.2528,  # holes
    -0.1011,  # lone
)
BIAS = -1.4665
