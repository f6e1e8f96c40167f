"""How sure an answer is, fitted: a logistic regression of right and wrong on what speaks for and against it.

The even half of the drawings is fitted; the odd half only tells how well that holds.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

import numpy as np
from scipy.optimize import minimize

from evaluation.markdown import percent, table
from evaluation.outcome import SURE
from sketch2shape.evidence import Weights
from sketch2shape.model import Floats

Bounds = tuple[float | None, float | None]
"""Least and largest weight of a term; None where there is none."""
FREE: Bounds = (None, None)
FOR: Bounds = (0.0, None)
AGAINST: Bounds = (None, 0.0)

RIDGE = 2.0
"""Penalty on the square of a weight: that of two answers that contradict it."""
DIGITS = 4
"""Decimals of the fitted numbers: as many as are written."""
LEAST_SPREAD = 10.0**-DIGITS
"""Standard deviation of a witness at least: one that is always the same says nothing, and no spread is written as 0."""


class Answer(NamedTuple):
    """An answer of a search.

    witnesses : (w,) float, what speaks for and against it
    right     : is it what was drawn?
    half      : "even" or "odd", the drawing's
    """

    witnesses: Floats
    right: bool
    half: str


def fitted(
    answers: Sequence[Answer],
    terms: Callable[[Floats, Weights], Floats],
    bounds: Sequence[Bounds],
    *,
    bias: Bounds = FREE,
    scale: Weights | None = None,
) -> Weights:
    """Mean and standard deviation of each witness, weight of each term, and the bias.

    answers : all that are to be fitted, of either half
    terms   : (k, w) witnesses and their mean and spread to (k, t) what is weighed
    bounds  : t of them, between which the weights have to lie
    bias    : between which it has to lie
    scale   : whose mean and spread are taken; those of the answers where it is None
    """
    if not answers:
        raise ValueError("no answer was found: there is nothing to fit")
    x = np.nan_to_num(np.array([a.witnesses for a in answers]))
    right = np.array([a.right for a in answers], float)
    flat = scale or Weights(tuple(x.mean(axis=0)), tuple(np.maximum(x.std(axis=0), LEAST_SPREAD)))
    z = np.column_stack([terms(x, flat), np.ones(len(x))])

    def loss(w: Floats) -> tuple[float, Floats]:
        t = z @ w
        held = np.append(w[:-1], 0.0)
        cost = float(np.logaddexp(0.0, np.where(right > 0, -t, t)).sum() + 0.5 * RIDGE * held @ held)
        return cost, z.T @ (1.0 / (1.0 + np.exp(-t)) - right) + RIDGE * held

    w = minimize(loss, np.zeros(z.shape[1]), jac=True, method="L-BFGS-B", bounds=[*bounds, bias]).x
    centre, spread, weight = (tuple(round(float(v), DIGITS) for v in p) for p in (flat.centre, flat.spread, w[:-1]))
    return Weights(centre, spread, weight, round(float(w[-1]), DIGITS))


def module_text(about: str, weights: Weights, witnesses: Sequence[str], terms: Sequence[str]) -> str:
    """The module that holds these weights.

    about     : its docstring
    witnesses : names of the w witnesses
    terms     : names of the t that are weighed
    """
    lines = [f'"""{about}"""', ""]
    told = (
        ("CENTRE", weights.centre, witnesses),
        ("SPREAD", weights.spread, witnesses),
        ("WEIGHT", weights.weight, terms),
    )
    for name, values, names in told:
        lines += [f"{name} = (", *(f"    {v},  # {w}" for v, w in zip(values, names, strict=True)), ")"]
    return "\n".join([*lines, f"BIAS = {weights.bias}"]) + "\n"


def promise(groups: Mapping[str, Sequence[Answer]], confidence: Callable[[Floats], float]) -> str:
    """How far the confidence keeps its promise in each group and half, as a table.

    confidence : (w,) witnesses to the probability 0..1 that such an answer is right
    """
    rows = []
    for name, answers in groups.items():
        for half in ("even", "odd"):
            some = [a for a in answers if a.half == half]
            right = sum(a.right for a in some)
            sure = [a for a in some if confidence(a.witnesses) >= SURE]
            kept = sum(a.right for a in sure)
            counts = [str(len(some)), percent(right, len(some)), str(len(sure))]
            rows.append([name, half, *counts, percent(kept, len(sure)), percent(kept, right)])
    head = ["set", "half", "answers", "right %", "sure", "of those right %", "of the right ones sure %"]
    return table(head, rows)
