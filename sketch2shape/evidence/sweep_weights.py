"""Weights of the witnesses of sweeps; see `sweep_calibration`.

They were fitted to the answers that the search gave; `scripts/fit_sweep_confidence.py` now also asks for those that it
keeps back, and a run of it writes this module anew.
"""

CENTRE = (
    0.0492,  # unexplained
    0.0047,  # attached
    0.0113,  # closed
    0.5302,  # missing
    0.8954,  # noise
    4.0399,  # gap
    1.8946,  # numbers
    0.0818,  # unseen
    3.6447,  # shallow
    5.1796,  # small
    0.2917,  # pointed
    0.0833,  # inferred
    0.6537,  # standing
    0.2917,  # holes
    0.3333,  # lone
)
SPREAD = (
    0.1605,  # unexplained
    0.0174,  # attached
    0.0729,  # closed
    1.2945,  # missing
    0.7806,  # noise
    1.3755,  # gap
    0.4616,  # numbers
    0.1349,  # unseen
    0.7621,  # shallow
    0.4682,  # small
    0.4545,  # pointed
    0.2764,  # inferred
    1.8043,  # standing
    0.5385,  # holes
    0.4714,  # lone
)
WEIGHT = (
    -0.2062,  # unexplained
    -0.1597,  # attached
    0.0,  # closed
    -0.6327,  # missing
    -0.374,  # noise
    0.2462,  # gap
    -0.4395,  # numbers
    -0.0514,  # unseen
    0.4873,  # shallow
    0.7925,  # small
    0.2177,  # pointed
    0.0,  # inferred
    -0.9,  # standing
    0.106,  # holes
    -0.2906,  # lone
)
BIAS = 1.2738
