"""Weights of the witnesses; see `calibration`.

They were fitted to recorded searches, by the method of `scripts/fit_confidence.py` (its regression, its bounds, the
even half of each set), not by a run of that script as it stands; a run of it writes this module anew.
"""

CENTRE = (
    0.1172,  # unexplained
    0.0663,  # attached
    0.0044,  # closed
    0.5639,  # loose
    0.1285,  # weakest
    0.5363,  # noise
    1.6744,  # vertices
    0.1261,  # unseen
    0.0295,  # bend
    0.0618,  # flat
    3.0381,  # shallow
    4.894,  # small
    0.0756,  # doubled
    1.2761,  # map
)
SPREAD = (
    0.173,  # unexplained
    0.1151,  # attached
    0.0175,  # closed
    0.9761,  # loose
    0.2428,  # weakest
    0.7781,  # noise
    0.3873,  # vertices
    0.2077,  # unseen
    0.0564,  # bend
    0.2408,  # flat
    0.8924,  # shallow
    0.5662,  # small
    0.1947,  # doubled
    0.1795,  # map
)
WEIGHT = (
    2.9074,  # whole
    0.0,  # unexplained
    -0.6326,  # attached
    -0.4112,  # closed
    -0.8906,  # loose
    -0.594,  # weakest
    -0.5998,  # noise
    0.0101,  # vertices
    -0.0628,  # unseen
    -0.5526,  # bend
    -0.2132,  # flat
    0.6766,  # shallow
    0.5915,  # small
    -1.4469,  # doubled
    -0.3196,  # map
)
BIAS = 0.2338
