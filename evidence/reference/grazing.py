"""Orbits of rolling that graze the limit of static friction, to 25 digits.

    python3 -m pip install mpmath
    python3 grazing.py                         writes grazing.json beside this file

What is independent here.  N and F come from the Newton-Euler balances of a body that rolls, solved
for the angular acceleration at each angle and energy; the greatest |F|/N of an orbit is looked for
on a grid of angles, and its energy on a grid of energies from above; both are then refined with 40
digits from the equations that hold there.

Units: mass of the particle, radius and gravity are 1.  theta: angle of the particle from the upward
vertical, counterclockwise.
"""

import json
import math
import os

import mpmath as mp
from mpmath import mpf

mp.mp.dps = 40
DIGITS = 25
ANGLES = 240

# mass ratio, offset, inertia about the centre, coefficient of friction, energy below which the
# orbit is looked for
CASES = [
    (1, 1, 1, 0.5, 10.0),
    (0.25, 1, 0.25, 0.75, 10.0),
    (0, 1, 1.625, 0.75, 10.0),
    (1, 0.3125, 1, 0.03125, 10.0),
    (0.25, 1, 0.25, 0.078125, 1.0),
    (0, 1, 0.5, 0.15625, 1.0),
    (1, 0.875, 1, 0.125, 0.75),
    (0.046875, 1, 0.046875, 1.25, 0.25),
]


class Hoop:
    """Of floats to look for an orbit, of numbers of mpmath to refine it."""

    def __init__(self, mass_ratio, offset, inertia, mu):
        m1, self.l, izz, self.mu = mass_ratio, offset, inertia, mu
        self.m = 1 + m1
        self.h = self.l / self.m
        self.i = izz + m1 * self.h**2 + (self.l - self.h) ** 2

    def about_contact(self, theta):
        return self.i + self.m * (1 + self.h**2 + 2 * self.h * cos(theta))

    def square_rate(self, theta, energy):
        return 2 * (energy - self.l * cos(theta)) / self.about_contact(theta)

    def demand(self, theta, energy):
        """|F|/N of rolling: the balances are linear in the angular acceleration."""
        s, c, u = sin(theta), cos(theta), self.square_rate(theta, energy)
        m, h = self.m, self.h
        # m (x - h sin theta)'' = F with x = -theta,  m (h cos theta)'' = N - m,  i theta'' = h s
        # N + (1 + h c) F
        forces = lambda a: (m + m * h * (-s * a - c * u), m * (-(1 + h * c) * a + h * s * u))
        residual = lambda a: self.i * a - h * s * forces(a)[0] - (1 + h * c) * forces(a)[1]
        at_zero = residual(0)
        normal, friction = forces(-at_zero / (residual(1) - at_zero))
        return abs(friction) / normal if normal > 0 else math.inf

    def worst(self, energy):
        """The angle in (0, pi) at which the orbit demands most, on the grid, and how much."""
        angles = [math.pi * k / ANGLES for k in range(1, ANGLES)]
        allowed = [theta for theta in angles if self.square_rate(theta, energy) >= 0]
        turning = energy / self.l
        if -1 < turning < 1:
            allowed.append(math.acos(turning))
        theta = max(allowed, key=lambda angle: self.demand(angle, energy))
        return theta, self.demand(theta, energy)


def sin(angle):
    return math.sin(angle) if isinstance(angle, float) else mp.sin(angle)


def cos(angle):
    return math.cos(angle) if isinstance(angle, float) else mp.cos(angle)


def grazing(case, below):
    """The highest energy below this one at which the demand comes down to mu, and the angle."""
    rough = Hoop(*map(float, case))
    energy, step = float(below), 1 / 64
    while rough.worst(energy)[1] <= rough.mu:
        energy -= step
    while rough.worst(energy)[1] > rough.mu:
        energy -= step
    low, high = energy, energy + step
    for _ in range(30):
        middle = (low + high) / 2
        low, high = (low, middle) if rough.worst(middle)[1] > rough.mu else (middle, high)
    theta, hoop = rough.worst(high)[0], Hoop(*map(mpf, case))
    if abs(high) < rough.l and abs(theta - math.acos(high / rough.l)) < 1e-3:
        angle = mp.findroot(lambda t: hoop.demand(t, hoop.l * mp.cos(t)) - hoop.mu, mpf(theta))
        return hoop, angle, hoop.l * mp.cos(angle)

    def slope(t, e):
        return mp.diff(lambda angle: hoop.demand(angle, e), t)

    angle, energy = mp.findroot(
        lambda t, e: (hoop.demand(t, e) - hoop.mu, slope(t, e)),
        (mpf(theta), mpf(high)),
        tol=mpf("1e-50"),
    )
    return hoop, angle, energy


def text(value):
    return mp.nstr(value, DIGITS)


def main():
    orbits = []
    for mass_ratio, offset, inertia, mu, below in CASES:
        hoop, theta, energy = grazing((mass_ratio, offset, inertia, mu), below)
        rate = mp.sqrt(max(hoop.square_rate(theta, energy), mpf(0)))
        orbits.append(
            {
                "hoop": {
                    "mass_ratio": mass_ratio,
                    "offset": offset,
                    "inertia": inertia,
                    "mu_s": mu,
                    "mu_k": mu,
                },
                "below": below,
                "energy": text(energy),
                "theta": text(theta),
                "theta_rate": "0.0" if rate < mpf("1e-15") else text(rate),
            }
        )
    place = os.path.join(os.path.dirname(os.path.abspath(__file__)), "grazing.json")
    with open(place, "w", encoding="utf-8") as file:
        json.dump({"orbits": orbits}, file, indent=1)
        file.write("\n")


if __name__ == "__main__":
    main()
