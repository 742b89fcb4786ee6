"""Zeros of functions."""

from __future__ import annotations

import math
from collections.abc import Callable


def zero(function: Callable[[float], float], low: float, high: float) -> float:
    """Return a zero between two signs, to the last digit, by halving."""
    sign = math.copysign(1.0, function(low))
    while True:
        middle = 0.5 * (low + high)
        if middle in (low, high):
            return middle
        if function(middle) * sign > 0.0:
            low = middle
        else:
            high = middle
