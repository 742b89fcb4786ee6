"""The profile likelihood of a parameter: how well the others make up for a wrong value of it."""

from __future__ import annotations

import math
from statistics import NormalDist

import numpy as np

from .._internal.elementwise import Reals
from .._internal.extras import require
from .estimate import Estimate
from .problem import OF_HOOP, ROUGH, Problem

__all__ = ["profile_interval", "rise"]


# Doublings of a step before an interval has no end.
_STEPS = 40
# From where the covariance foretells the others a parabola takes two or three steps.
_STEPS_OF_RISE = 8
# The ends of an interval are found to this part of a standard error.
_CLOSE = 0.02
# Beyond this multiple of the limit the profile is as good as infinite.
_MOST = 10.0


def rise(problem: Problem, unknowns: Reals, covariance: Reals, name: str, value: float) -> float:
    """Return by how much the least sum of squares exceeds that of the fit.

    It is that where a parameter has a value.

    The covariance of the estimates says where the others go.
    """
    values = problem.values(unknowns)
    place = problem.names.index(name)
    part = (value - values[name]) / float(covariance[place, place])
    for k, other in enumerate(problem.names):
        if k != place:
            values[other] += part * float(covariance[k, place])
    restricted = problem.fixed(name, values | {name: value})
    if restricted is None:
        return math.inf
    best = problem.scaled(unknowns)
    narrower, begin = restricted
    found = narrower.refine(begin, "linear", ROUGH, _STEPS_OF_RISE)
    return 2.0 * float(found.cost) - float(best @ best)


def profile_interval(
    problem: Problem,
    unknowns: Reals,
    covariance: Reals,
    name: str,
    estimate: Estimate,
    confidence: float,
) -> tuple[float, float]:
    """Return the interval in which the profile rises by less than a square.

    It is that of the normal quantile.
    """
    if name not in OF_HOOP:
        raise ValueError(
            f"name = {name!r} must be one of "
            f"{', '.join(one for one in problem.names if one in OF_HOOP)}"
        )
    if not 0.0 < confidence < 1.0:
        raise ValueError(f"confidence = {confidence} must lie between 0 and 1")
    limit = NormalDist().inv_cdf(0.5 + 0.5 * confidence)
    low, high = problem.limits(name)
    covariance = np.where(np.isfinite(covariance), covariance, 1.0)
    unit = (
        estimate.std_error
        if math.isfinite(estimate.std_error)
        else 0.1 * max(1.0, abs(estimate.value))
    )

    def excess(value: float) -> float:
        found = math.sqrt(max(rise(problem, unknowns, covariance, name, value), 0.0))
        # An infinite one, where the hoop has no such motion, would leave nothing to interpolate.
        return min(found, _MOST * limit) - limit

    def end(sign: float, bound: float) -> float:
        inside, step = estimate.value, limit * unit
        for _ in range(_STEPS):
            outside = inside + sign * step
            if sign * (outside - bound) >= 0.0:
                outside = bound
            if excess(outside) >= 0.0:
                brentq = require("scipy.optimize").brentq
                return float(brentq(excess, inside, outside, xtol=_CLOSE * unit))
            if outside == bound:
                return bound
            inside, step = outside, 2.0 * step
        return sign * math.inf

    return end(-1.0, low), end(1.0, high)
