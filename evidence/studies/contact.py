"""The contact of a heavy hoop: what rolling and sliding need from the plane.

By the angle and u = θ′².
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import littlewood as lw


@dataclass(frozen=True)
class Contact:
    """A heavy hoop, as far as its contact with the plane depends on it.

    Parameters
    ----------
    m, h, inertia : float
        Mass, distance of the mass centre from the centre, and moment of inertia about the mass
        centre.
    """

    m: float
    h: float
    inertia: float

    @classmethod
    def of(cls, hoop: lw.Hoop) -> Contact:
        """Return that of a hoop."""
        return cls(hoop.mass, hoop.h, hoop.inertia_about_mass_centre)

    def denominator(self, theta: float) -> float:
        """Return D: twice the kinetic energy of rolling over u."""
        return self.inertia + self.m * (1.0 + self.h * self.h + 2.0 * self.h * math.cos(theta))

    def pressure(self, theta: float, u: float) -> float:
        """Return w = 1 − h cos θ u: the plane holds the rim where it is positive."""
        return 1.0 - self.h * math.cos(theta) * u

    def compliances(self, theta: float) -> tuple[float, float, float]:
        """Return A, B and C of the contact."""
        s, lever = self.h * math.sin(theta), 1.0 + self.h * math.cos(theta)
        return (
            1.0 / self.m + lever**2 / self.inertia,
            s * lever / self.inertia,
            1.0 / self.m + s**2 / self.inertia,
        )

    def rolling(self, theta: float, u: float) -> tuple[float, float]:
        """Return N and F of rolling."""
        a, b, c = self.compliances(theta)
        w, push = self.pressure(theta, u), self.h * math.sin(theta) * u
        scale = self.m**2 * self.inertia / self.denominator(theta)
        return (a * w - b * push) * scale, (c * push - b * w) * scale

    def solvability(self, theta: float, friction: float) -> float:
        """Return P for friction = μ σ: a slide needs w/P > 0."""
        _, b, c = self.compliances(theta)
        return self.m * self.inertia * (c - friction * b)

    def energy(self, theta: float, u: float) -> float:
        """Return the energy of rolling."""
        return 0.5 * self.denominator(theta) * u + self.m * self.h * math.cos(theta)
