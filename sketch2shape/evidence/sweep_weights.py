"""Weights of the witnesses of sweeps, written by `scripts/fit_sweep_confidence.py`; see `sweep_calibration`."""

CENTRE = (
    0.3123,  # unexplained
    0.0722,  # attached
    0.0784,  # closed
    0.4909,  # missing
    1.1064,  # noise
    3.4396,  # gap
    1.9664,  # numbers
    0.0502,  # unseen
    2.8881,  # shallow
    5.0232,  # small
    0.4787,  # pointed
    0.1494,  # inferred
    2.0536,  # standing
    0.4299,  # holes
    0.2104,  # lone
    0.0183,  # chords
)
SPREAD = (
    0.3523,  # unexplained
    0.1463,  # attached
    0.1386,  # closed
    1.1548,  # missing
    0.9606,  # noise
    1.7682,  # gap
    0.4899,  # numbers
    0.1039,  # unseen
    1.0548,  # shallow
    0.444,  # small
    0.4995,  # pointed
    0.3565,  # inferred
    2.8719,  # standing
    1.1321,  # holes
    0.4076,  # lone
    0.1054,  # chords
)
WEIGHT = (
    -1.4164,  # unexplained
    -1.1634,  # attached
    -0.9017,  # closed
    -0.5456,  # missing
    -1.1699,  # noise
    0.8967,  # gap
    -0.5544,  # numbers
    0.0,  # unseen
    0.6476,  # shallow
    0.2882,  # small
    0.3652,  # pointed
    0.0,  # inferred
    -0.918,  # standing
    0.2131,  # holes
    -0.3682,  # lone
    -0.153,  # chords
)
BIAS = -1.8267
