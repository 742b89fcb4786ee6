"""What starts of every kind draw: signs, distances, hoops."""

import math

from follower.hoop import Hoop


def signed(dice, low, high):
    return dice.uniform(low, high) * dice.choice((-1, 1))


def beside(dice):
    """A distance of 1e-12 to 1e-4, to either side."""
    return 10.0 ** dice.uniform(-12, -4) * dice.choice((-1, 1))


def heavy(dice):
    """A hoop with inertia, without friction.

    It is thin, of any kind, light, or has the particle inside a light one.
    """
    kind = dice.randrange(5)
    m = dice.uniform(0.2, 4)
    if kind == 0:
        return m, 1.0, m
    if kind < 3:
        return m, dice.uniform(0.2, 1), dice.uniform(0.1, 3)
    light = 10.0 ** dice.uniform(-4, -1)
    return (0.0, 1.0, light) if kind == 3 else (light, dice.uniform(0.4, 1), light)


def massless(dice):
    return 0.0, dice.choice((1.0, dice.uniform(0.1, 1), 1 - 10.0 ** dice.uniform(-12, -2))), 0.0


def inside(dice):
    return 0.0, dice.uniform(0.1, 0.95), 0.0


def solvable(body, mu):
    """The largest of mu, mu/2, mu/4, ... with P > 0 at every angle."""
    while mu > 0:
        hoop = Hoop(*body, mu, mu)
        i, mh, h = float(hoop.i), float(hoop.m * hoop.h), float(hoop.h)
        angles = [math.pi * k / 200 for k in range(-200, 201)]
        if (
            min(
                i + mh * math.sin(t) * (h * math.sin(t) - mu * w * (1 + h * math.cos(t)))
                for t in angles
                for w in (-1, 1)
            )
            > 0.05 * i
        ):
            return mu
        mu /= 2
    return 0.0


def frictions(dice, body):
    mu_s = dice.uniform(0.05, 1.2)
    return mu_s, solvable(body, mu_s * dice.uniform(0.1, 0.95))
