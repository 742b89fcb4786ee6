"""The orbits of rolling that graze the limit of friction, where a slip begins to be possible."""

from __future__ import annotations

import math
from dataclasses import dataclass

from .contact import Contact
from .roots import zero

STEPS = 720
"""Parts of a turn in which minima are looked for; levels are quotients of trigonometric polynomials
of degree three."""


@dataclass(frozen=True)
class Margin:
    """The margin (μN − F) D² = a − K b of rolling with the orbit constant K.

    The other side is its mirror image.

    Parameters
    ----------
    contact : Contact
        The hoop.
    mu : float
        Coefficient of friction.
    """

    contact: Contact
    mu: float

    def terms(self, theta: float) -> tuple[tuple[float, float, float], tuple[float, float, float]]:
        """Return a and b, each with its first two derivatives by the angle."""
        hoop = self.contact
        offset, e = hoop.m * hoop.h, hoop.inertia + hoop.m * hoop.h**2
        s, c = math.sin(theta), math.cos(theta)
        d, d1, d2 = hoop.denominator(theta), -2.0 * offset * s, -2.0 * offset * c
        g = self.mu * (hoop.m + offset * c) + offset * s
        g1 = offset * (c - self.mu * s)
        g2 = -offset * (s + self.mu * c)
        a = (
            g * d * d,
            g1 * d * d + 2.0 * g * d * d1,
            g2 * d * d + 4.0 * g1 * d * d1 + 2.0 * g * (d1 * d1 + d * d2),
        )
        b = (
            offset * (self.mu * (offset * s * s + c * d) + s * (e + offset * c)),
            offset
            * (
                self.mu * (2.0 * offset * s * c - s * d + c * d1) + c * e + offset * (c * c - s * s)
            ),
            offset
            * (
                self.mu * (2.0 * offset * (c * c - s * s) - c * d - 2.0 * s * d1 + c * d2)
                - s * e
                - 4.0 * offset * s * c
            ),
        )
        return a, b

    def _turn(self, theta: float) -> float:
        """Return what has the sign of the derivative of the level a/b."""
        a, b = self.terms(theta)
        return a[1] * b[0] - a[0] * b[1]


@dataclass(frozen=True)
class Grazing:
    """An orbit on which friction touches its limit, at a minimum of the level, with θ′ ≠ 0.

    Parameters
    ----------
    energy, theta, rate : float
        Energy of the orbit, and where it touches.
    normal : float
        N there.
    rise, fall : float
        a and k: with the distance ε of the energy, the excess |F| − μN near θ is 2aε − kt².
    mobility : float
        D/(mP): slip acceleration over excess.
    """

    energy: float
    theta: float
    rate: float
    normal: float
    rise: float
    fall: float
    mobility: float

    def loss(self, mu: float) -> float:
        """Return c: with equal coefficients a slip loses c ε²."""
        return 9.0 * mu * self.normal * self.rise**2 * self.mobility / self.fall

    def slips(self, mu: float) -> float:
        """Return Λ: the number of slips times μs − μk, as that goes to zero."""
        return 0.25 * math.log(3.0) * self._scale(mu)

    def slips_from(self, mu: float, gap: float, distance: float) -> float:
        """Return the number of slips from a distance of the energy, with μs − μk = gap."""
        y = math.sqrt(2.0 * self.rise * distance / (gap * self.normal))
        v = 0.25 * (3.0 * y + math.sqrt(9.0 * y * y + 12.0)) ** 2
        sum_of_parts = math.log(3.0 * v / (v + 6.0)) / 4.0 - 0.5 / v + 1.5 / v**2
        return sum_of_parts * self._scale(mu) / gap

    def _scale(self, mu: float) -> float:
        return self.fall / (self.rise * mu * self.normal**2 * self.mobility)


def grazing_orbits(contact: Contact, mu: float, mu_k: float | None = None) -> list[Grazing]:
    """Return the orbits that touch μN with θ′ ≠ 0, the lowest first.

    Slides have the coefficient μk, by default μ.
    """
    margin = Margin(contact, mu)
    mean = contact.inertia + contact.m * (1.0 + contact.h**2)
    angles = [2.0 * math.pi * k / STEPS for k in range(STEPS + 1)]
    signs = [margin._turn(angle) for angle in angles]
    found = []
    for k in range(STEPS):
        if not signs[k] < 0.0 <= signs[k + 1]:
            continue
        theta = zero(margin._turn, angles[k], angles[k + 1])
        a, b = margin.terms(theta)
        d = contact.denominator(theta)
        if b[0] <= 0.0 or a[0] / b[0] <= d:
            continue
        constant = a[0] / b[0]
        u = constant / d - 1.0
        normal, friction = contact.rolling(theta, u)
        p = contact.solvability(theta, -math.copysign(mu if mu_k is None else mu_k, friction))
        fall = 0.5 * (a[2] - constant * b[2]) * u / d**2
        if normal > 0.0 and p > 0.0 and fall > 0.0:
            mobility = d / (contact.m * p)
            found.append(
                Grazing(
                    0.5 * (constant - mean),
                    theta,
                    math.sqrt(u),
                    normal,
                    b[0] / d**2,
                    fall,
                    mobility,
                )
            )
    return sorted(found, key=lambda one: one.energy)
