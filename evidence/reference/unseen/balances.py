"""Newton's and Euler's balances of a hoop in doubles: accelerations, forces, Taylor series."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

ORDER = 22  # of the series
EXACT = 1e-17  # what a step leaves out


class Tie(Exception):
    """Doubles do not tell which motion follows."""


class Singular(Exception):
    """A force grows without bound."""


class Hoop:
    """Mass, place of the mass centre, inertia about it, friction, resistance, and gravity."""

    def __init__(self, mass_ratio, offset, inertia, mu_s, mu_k, chi, slope):
        self.m = 1 + mass_ratio
        self.h = offset / self.m
        self.i = inertia + mass_ratio * self.h**2 + (offset - self.h) ** 2
        self.massless = mass_ratio == 0 and inertia == 0
        if self.massless:
            self.i = 0.0
        self.mu_s, self.mu_k, self.chi = mu_s, mu_k, chi
        self.down, self.along = math.cos(slope), math.sin(slope)


class State(NamedTuple):
    """Time, angle, its rate, slip velocity, place of the centre, rate of the gap."""

    time: float
    theta: float
    rate: float
    slip: float
    x: float
    opening: float = 0.0


class Mode(NamedTuple):
    """A name, and the signs of slip and θ′, 0 where held."""

    name: str
    slips: int
    turns: int


FLIGHT = Mode("flight", 0, 0)


def contact(slips, turns, massless):
    """Return the mode of two signs."""
    if slips and turns:
        return Mode("gliding" if massless else "sliding", slips, turns)
    if turns:
        return Mode("rolling", 0, turns)
    return Mode("skidding" if slips else "rest", slips, 0)


def matrix(hoop, mode, sine, cosine):
    """Return the balances of (x″, θ″, N, F, K): two of force, one of moment, two laws."""
    m, arm, lever = hoop.m, hoop.h * sine, 1 + hoop.h * cosine
    return np.array(
        [
            [m, -m * hoop.h * cosine, 0, -1, 0],
            [0, -m * arm, -1, 0, 0],
            [0, hoop.i, -arm, -lever, -1],
            [0, 0, hoop.mu_k * mode.slips, 1, 0] if mode.slips else [1, 1, 0, 0, 0],
            [0, 0, hoop.chi * mode.turns, 0, 1] if mode.turns else [0, 1, 0, 0, 0],
        ]
    )


def solved(hoop, mode, state):
    """Return (x″, θ″, N, F, K) in a mode at an instant, and the determinant."""
    sine, cosine = math.sin(state.theta), math.cos(state.theta)
    m, h, u = hoop.m, hoop.h, state.rate**2
    known = [-m * (h * sine * u + hoop.along), m * (h * cosine * u - hoop.down), 0, 0, 0]
    balances = matrix(hoop, mode, sine, cosine)
    return np.linalg.solve(balances, known).tolist()


def product(a, b, k):
    """Return the coefficient k of a product."""
    return sum(a[j] * b[k - j] for j in range(k + 1))


def but_newest(a, b, k):
    """Return the same without the newest coefficient of the first factor."""
    return sum(a[j] * b[k - j] for j in range(k))


class Series:
    """Coefficients in time from a state, order by order: what is not known yet is solved for."""

    def __init__(self, hoop, mode, state):
        m, h = hoop.m, hoop.h
        sine, cosine = math.sin(state.theta), math.cos(state.theta)
        try:
            solve = np.linalg.inv(matrix(hoop, mode, sine, cosine)).tolist()
        except np.linalg.LinAlgError as error:
            raise Singular("no regular solution") from error
        th, om, sl = [state.theta], [state.rate], [state.slip]
        s, c, u, turn, normal, friction = [sine], [cosine], [], [], [], []
        for k in range(ORDER):
            u.append(product(om, om, k))
            right = (
                -m * h * (product(s, u, k) - but_newest(turn, c, k)),
                m * h * (product(c, u, k) + but_newest(turn, s, k)),
                h * (but_newest(normal, s, k) + but_newest(friction, c, k)),
            )
            if k == 0:
                right = right[0] - m * hoop.along, right[1] - m * hoop.down, right[2]
            x2, turn_k, normal_k, friction_k, _ = (
                row[0] * right[0] + row[1] * right[1] + row[2] * right[2] for row in solve
            )
            turn_k = turn_k if mode.turns else 0.0
            turn.append(turn_k)
            normal.append(normal_k)
            friction.append(friction_k)
            th.append(om[k] / (k + 1))
            s.append(product(om, c, k) / (k + 1))
            c.append(-product(om, s, k) / (k + 1))
            om.append(turn_k / (k + 1))
            sl.append((x2 + turn_k) / (k + 1) if mode.slips else 0.0)
        self.theta, self.rate, self.slip = th, om, sl
        self.normal, self.friction, self.sin, self.cos = normal, friction, s, c
        self.mode, self.start = mode, state

    def reach(self):
        """Return a time within which the last two terms are small."""
        found = 10.0
        for p in (self.rate, self.slip, self.normal):
            size = max(1.0, abs(p[0]))
            for k in (len(p) - 1, len(p) - 2):
                if p[k]:
                    found = min(found, (EXACT * size / abs(p[k])) ** (1 / k))
        return found

    def at(self, tau):
        """Return the state after a time."""
        start, moved = self.start, [0.0] + [v / (k + 1) for k, v in enumerate(self.slip)]
        theta = value(self.theta, tau)
        return State(
            start.time + tau,
            theta,
            value(self.rate, tau),
            value(self.slip, tau) if self.mode.slips else 0.0,
            start.x + value(moved, tau) - value([0.0, *self.theta[1:]], tau),
        )


def value(p, t):
    """Return the value of a polynomial."""
    total = 0.0
    for one in reversed(p):
        total = total * t + one
    return total


def first_fall(p, length, order=0):
    """Return the first t in (0, length] where a polynomial falls through 0, None without one.

    A zero of this order at 0 is divided out. All complex roots are computed as eigenvalues, and
    those that are real and at which the sign changes are polished.
    """
    q = [v * length**k for k, v in enumerate(p)][order:]
    if not all(map(math.isfinite, q)):
        raise Singular("a series without bound")
    if q[0] > sum(map(abs, q[1:])):
        return None
    if q[0] <= 0:
        raise Tie("a guard begins at or below 0")
    while len(q) > 1 and abs(q[-1]) <= 1e-30 * max(map(abs, q)):
        q.pop()
    slope = [k * v for k, v in enumerate(q)][1:]
    for root in sorted(np.roots(q[::-1]), key=lambda z: z.real):
        if not -1e-9 < root.real < 1 + 1e-9 or abs(root.imag) > 1e-4:
            continue
        t = float(root.real)
        for _ in range(8):
            steep = value(slope, t)
            if steep == 0:
                break
            t -= value(q, t) / steep
        if abs(t - root.real) > 1e-3:
            if abs(root.imag) < 1e-9:
                raise Tie("a double root")
            continue
        if value(slope, t) < -1e-9 * sum(map(abs, q)) and 0 < t <= 1:
            return t * length
    return None
