"""The first turn without friction: where its slip is zero, by a cubic equation in c = cos θ."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from .contact import Contact

Floats = npt.NDArray[np.float64]


def quadratic(
    contact: Contact, rate: float | Floats
) -> tuple[float | Floats, float | Floats, float | Floats]:
    """Return the coefficients of 1, c and c² of a polynomial.

    Its roots are the zeros of the slip but the top.
    """
    m, h, inertia = contact.m, contact.h, contact.inertia
    energy, start = inertia * rate**2 + 2.0 * m * h, rate**2 * (1.0 + h) ** 2
    third = -2.0 * m * h**3
    second = third + h * h * (energy + start * m) - 4.0 * m * h * h
    return second + 2.0 * h * (energy - m), second, third


def degenerate_rates(contact: Contact, count: int = 2000) -> list[float]:
    """Return the rates at the top at which reversals come, by origin.

    From the top, from the bottom, or two from nothing.
    """
    m, h, inertia = contact.m, contact.h, contact.inertia
    rates = np.linspace(0.0, 1.0 / math.sqrt(h), count + 1)[1:]
    found = [
        math.sqrt(m * (1.0 + h) / (inertia + m * h * (1.0 + h))),
        math.sqrt(m / inertia) * (1.0 - h),
    ]
    constant, linear, square = (np.asarray(one) for one in quadratic(contact, rates))
    squared = linear**2 - 4.0 * constant * square
    inside = np.abs(linear) < 2.0 * np.abs(square)
    for k in np.flatnonzero((squared[1:] * squared[:-1] < 0.0) & inside[1:]):
        found.append(float(0.5 * (rates[k] + rates[k + 1])))
    return [one for one in found if one < rates[-1]]
