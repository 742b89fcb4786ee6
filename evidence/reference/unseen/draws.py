"""Starts that nobody has seen: drawn with a seed, with all digits of their doubles."""

from __future__ import annotations

import math
import random
from typing import NamedTuple

LAWS = ("energetic", "poisson", "newton")


class Given(NamedTuple):
    """What is given of a motion."""

    hoop: tuple  # mass ratio, offset, inertia, mu_s, mu_k, rolling resistance, slope
    start: tuple  # theta, theta', eta', rate of the gap
    bounce: tuple | None  # coefficient and law of restitution
    until: float


class Draws:
    """Random numbers of one start."""

    def __init__(self, seed, number):
        self.random = random.Random(f"{seed} {number}")

    def between(self, low, high):
        return self.random.uniform(low, high)

    def sized(self, low, high):
        """Between two numbers, uniform in the logarithm."""
        return math.exp(self.random.uniform(math.log(low), math.log(high)))

    def comes(self, probability):
        return self.random.random() < probability

    def one_of(self, *values):
        return self.random.choice(values)


def friction(d, low, high):
    mu_s = d.sized(low, high)
    return mu_s, d.one_of(mu_s, mu_s * d.between(0.3, 1))


def with_resistance(seed, number):
    """Moderate hoops with rolling resistance, on level planes and slopes, one in six massless."""
    d = Draws(f"resistance {seed}", number)
    chi, (mu_s, mu_k) = d.sized(1e-3, 1), friction(d, 0.05, 2)
    slope = d.one_of(0.0, d.between(-0.5, 0.5))
    massless = d.comes(1 / 6)
    mass_ratio = 0.0 if massless else d.sized(0.01, 10)
    inertia = 0.0 if massless else mass_ratio * d.between(0.2, 1)
    offset = d.one_of(1.0, d.between(0, 1), d.between(0.2, 1))
    rate = d.one_of(0.0, d.between(-1, 1), d.between(-3, 3), d.between(-3, 3))
    slip = d.one_of(0.0, d.between(-1.5, 1.5))
    gap_rate = 0.0 if massless or d.comes(0.7) else d.between(0, 1)
    e = d.one_of(None, 0.0, 1.0, d.between(0, 1), d.between(0, 1))
    bounce = None if massless or e is None else (e, d.one_of(*LAWS))
    hoop = (mass_ratio, offset, inertia, mu_s, mu_k, chi, slope)
    start = (d.between(-math.pi, math.pi), rate, slip, gap_rate)
    return Given(hoop, start, bounce, d.between(5, 30))


def of_the_whole_range(seed, number):
    """Hoops without resistance of all sizes."""
    d = Draws(f"range {seed}", number)
    mu_s, mu_k = friction(d, 1e-6, 1e6)
    mass_ratio, offset = d.sized(1e-6, 1e6), d.one_of(1.0, d.between(0, 1), d.sized(1e-6, 1))
    inertia = d.one_of(mass_ratio, mass_ratio * d.between(0.2, 1), d.sized(1e-6, 1e6))
    slope = d.one_of(0.0, d.between(-1.5, 1.5))
    rate = d.sized(1e-6, 1e6) * d.one_of(-1, 1)
    slip = d.one_of(0.0, d.sized(1e-6, 1e6) * d.one_of(-1, 1))
    gap_rate = 0.0 if d.comes(0.7) else d.sized(1e-6, 1e3)
    e = d.one_of(None, 0.0, 1.0, d.between(0, 1), d.between(0, 1))
    bounce = None if e is None else (e, d.one_of(*LAWS))
    hoop = (mass_ratio, offset, inertia, mu_s, mu_k, 0.0, slope)
    return Given(hoop, (d.between(-math.pi, math.pi), rate, slip, gap_rate), bounce, 2.0**60)
