"""Flights of the loaded hoop over the whole range of starts, to 25 digits.

    python3 -m pip install mpmath gmpy2        (gmpy2 only makes it faster)
    python3 flights.py                         writes flights.json beside this file

What is independent here.  The height of the mass centre is a parabola in time and that of the rim
below it a cosine, added up as they stand with 110 digits; there are no series and no expansion at
the start.  The landing is the first instant at which that height vanishes: instants at which its
second derivative vanishes are written down, between them zeros of the first derivative are
bisected, and between those the height is monotone.  Turns that pass high up are skipped, by the
lowest point that a rim could have at any angle.

Units: mass of the particle, radius and gravity are 1.  The hoop itself has no mass, so that the
mass centre is at the particle, h = offset.  theta: angle of the particle from the upward vertical,
counterclockwise.
"""

import json
import os
import random

import mpmath as mp
from mpmath import mpf

mp.mp.dps = 110
DIGITS = 25


class Flight:
    """The height of the rim as a function of time, in the direction in which the hoop turns."""

    def __init__(self, h, theta, rate, gap_rate):
        self.h, self.theta, self.rate, self.gap_rate = (
            h,
            theta * mp.sign(rate or 1),
            abs(rate),
            gap_rate,
        )
        self.cos, sin = mp.cos_sin(self.theta)
        self.rise = gap_rate - h * sin * self.rate  # of the mass centre

    def gap(self, time):
        return (
            self.rise * time
            - time * time / 2
            + self.h * (self.cos - mp.cos(self.theta + self.rate * time))
        )

    def slope(self, time):
        return self.rise - time + self.h * self.rate * mp.sin(self.theta + self.rate * time)

    def curvature(self, time):
        return self.h * self.rate**2 * mp.cos(self.theta + self.rate * time) - 1

    def inflections(self, low):
        """Instants behind one at which the curvature vanishes, in order."""
        if self.h * self.rate**2 <= 1:
            return
        level = mp.acos(1 / (self.h * self.rate**2))
        turn = mp.floor((self.theta + self.rate * low - level) / (2 * mp.pi))
        while True:
            for side in (-level, level):
                time = (side + 2 * mp.pi * turn - self.theta) / self.rate
                if time > low + mpf(10) ** -40:
                    yield time
            turn += 1

    def window(self):
        """Instants before and after the landing, few turns apart.

        The rim is above the plane from soon after the start to the first.
        """
        # The rim is no lower than with the mass centre over it, and no higher than with the mass
        # centre under it.
        lowest, highest = self.h * (self.cos - 1), self.h * (self.cos + 1)
        last = self.rise + mp.sqrt(self.rise**2 + 2 * highest)
        turn = 2 * mp.pi / self.rate if self.rate else last
        square = self.rise**2 + 2 * lowest
        if self.rise > 0 and square > 0:
            opens, closes = self.rise - mp.sqrt(square), self.rise + mp.sqrt(square)
            # Over a whole turn the rim comes down to the lowest that it can be.
            if closes - opens > 3 * turn and self.first_below(0, opens + 2 * turn) is None:
                return closes - turn / 2, min(last, closes + 2 * turn)
        return mpf(0), last

    def first_below(self, low, high):
        """The first instant at which the gap falls through zero.

        From one where it is open, or from the start.
        """
        inflections = self.inflections(low)
        opens = low == 0
        a = low
        while a < high:
            b = min(next(inflections, high), high)
            ends = [a, b]
            # The gap opens from the start on.
            rises = True if opens else self.slope(a) > 0
            if rises != (self.slope(b) > 0):
                ends.insert(1, bisect(self.slope, self.curvature, a, b, rises))
            for end in ends[1:]:
                if self.gap(end) < 0:
                    return bisect(self.gap, self.slope, a, end, True)
                a = end
            opens = False
        return None

    def landing(self):
        return self.first_below(*self.window())


def bisect(function, derivative, a, b, falls):
    """The only zero between two places: Newton's method in a bracket that only shrinks."""
    x = (a + b) / 2
    for _ in range(400):
        value = function(x)
        if (value > 0) == falls:
            a = x
        else:
            b = x
        step = -value / derivative(x)
        if not a < x + step < b:
            step = (a + b) / 2 - x
        x += step
        if abs(step) <= abs(x) * mpf(10) ** -40:
            return x
    raise AssertionError("does not converge")


def log_uniform(low, high):
    return 10 ** random.uniform(low, high)


def start_of(kind):
    """A flight of a kind: h, angle, rate, rate of the gap, each a double.

    Of a lift-off the rate is exact, and the angle rounded.
    """
    while True:
        h = random.choice([log_uniform(-9, 0), random.uniform(0.05, 1)])
        sign = random.choice([-1, 1])
        rate = sign * log_uniform(-6, 6)
        turns = random.choice([0, 0, 0, random.randint(-5, 5), int(sign * log_uniform(0, 8))])
        if kind == "thrown":
            theta = random.uniform(-3.14, 3.14) + 6.283185307179586 * turns
            gap_rate = random.choice([log_uniform(-12, 6), log_uniform(-3, 1), 0.1 * h * abs(rate)])
            return h, theta, rate, gap_rate, mpf(theta)
        need = h * mpf(rate) ** 2
        if need <= 1:
            continue
        level = mp.acos(1 / need)
        exact = -sign * level + 2 * mp.pi * turns
        if kind == "lift_off":
            return h, float(exact), rate, 0.0, exact
        # Unloaded: nearer to the top.
        part = random.choice(
            [random.uniform(-1, 1), 1 - log_uniform(-9, 0), log_uniform(-9, 0) - 1]
        )
        theta = float(part * level + 2 * mp.pi * turns)
        if h * mp.cos(mpf(theta)) * mpf(rate) ** 2 > 1 + mpf(10) ** -12:
            return h, theta, rate, 0.0, mpf(theta)


def text(x):
    return mp.nstr(x, DIGITS, strip_zeros=False)


def main(counts=(("thrown", 200), ("unloaded", 100), ("lift_off", 100)), seed=5):
    random.seed(seed)
    flights = []
    for kind, count in counts:
        for _ in range(count):
            h, theta, rate, gap_rate, exact = start_of(kind)
            flight = Flight(mpf(h), exact, mpf(rate), mpf(gap_rate))
            time = flight.landing()
            flights.append(
                {
                    "kind": kind,
                    "h": h,
                    "start": [theta, rate, gap_rate],
                    "landing": {"time": text(time), "gap_rate": text(flight.slope(time))},
                }
            )
    return flights


if __name__ == "__main__":
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "flights.json")
    with open(path, "w") as file:
        json.dump({"flights": main()}, file, indent=1)
        file.write("\n")
