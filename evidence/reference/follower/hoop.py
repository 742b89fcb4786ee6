"""A hoop, the balances of force and moment at one instant, and what follows from rest."""

import gmpy2
from gmpy2 import mpfr

from .arithmetic import Tie


class Hoop:
    """Mass, place of the mass centre and inertia about it, from the hoop and the particle."""

    def __init__(self, mass_ratio, offset, inertia, mu_s, mu_k, slope=0):
        self.numbers = mass_ratio, offset, inertia, mu_s, mu_k, slope
        m1, self.l, izz, self.mu_s, self.mu_k, slope = map(mpfr, self.numbers)
        # Gravity along the plane, downhill to negative x, and into it.
        self.along, self.down = gmpy2.sin_cos(slope)
        self.m = m1 + 1
        self.h = self.l / self.m
        self.i = izz + m1 * self.h**2 + (self.l - self.h) ** 2
        self.massless = mass_ratio == 0 and inertia == 0
        if self.massless:
            self.i = mpfr(0)


def rolling_forces(hoop, theta, rate):
    """(theta'', N, F) that rolling would need, by elimination."""
    s, c = gmpy2.sin_cos(theta)
    m, h, u, g = hoop.m, hoop.h, rate * rate, 1 + hoop.h * c
    n0, f0 = m * hoop.down - m * h * c * u, m * h * s * u + m * hoop.along
    a = (h * s * n0 + g * f0) / (hoop.i + m * (h * s) ** 2 + m * g * g)
    return a, n0 - m * h * s * a, f0 - m * g * a


def slide_acceleration(hoop, theta, rate, sigma):
    """(eta'', N, P) of a slide."""
    s, c = gmpy2.sin_cos(theta)
    m, h, u, g = hoop.m, hoop.h, rate * rate, 1 + hoop.h * c
    friction = -hoop.mu_k * sigma
    q = h * s + friction * g
    p = hoop.i + m * h * s * q
    a = q * (m * hoop.down - m * h * c * u) / p
    n = m * hoop.down - m * h * (s * a + c * u)
    return a + h * (c * a - s * u) + friction * n / m - hoop.along, n, p


def unloaded(hoop, theta, rate):
    """cos slope - h cos theta theta'^2.

    It is negative where free fall of the mass centre would lift the rim.
    """
    return hoop.down - hoop.h * gmpy2.cos(theta) * rate * rate


def at_rest(hoop, state):
    """(mode, direction) that follows at eta' = 0."""
    theta, rate = state[0], state[1]
    _, n, f = rolling_forces(hoop, theta, rate)
    margin = hoop.mu_s * n - abs(f)
    if min(abs(n), abs(margin)) < 1e-38:
        raise Tie("on the static limit")
    if n > 0 and margin > 0:
        return "rolling", 0
    if hoop.massless:
        return "gliding", None
    ways = []
    for sigma in (1, -1):
        acceleration, normal, p = slide_acceleration(hoop, theta, rate, sigma)
        if p <= 0:
            raise Tie("Painleve")
        if normal > 0 and sigma * acceleration > 0:
            ways.append(sigma)
    lifts = unloaded(hoop, theta, rate) < 0
    if len(ways) + lifts != 1:
        raise Tie("not one motion")
    return ("sliding", ways[0]) if ways else ("flight", 0)
