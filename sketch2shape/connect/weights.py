"""Weights of the cues of `regularity`, log odds: negative makes a ring more probable.

Fitted by scripts/fit_regularity.py to its own random faces.
"""

EDGE_WEIGHTS = {
    "length": 5.969,
    "length2": -2.266,
    "clear": 1.914,
    "gabriel": -0.497,
    "hull": -0.081,
    "swept": 0.223,
    "rank": 0.246,
}
PAIR_WEIGHTS = {
    "parallel": -0.564,
    "parallel_loose": -0.663,
    "in_line": 0.310,
    "parallel_equal": -0.348,
    "equal": -0.267,
    "perpendicular": 0.185,
    "symmetric": -2.369,
    "spike": -0.152,
    "sharp": 0.700,
    "acute": -0.893,
    "straight": 3.206,
    "right": -0.707,
    "near": 2.178,
}
