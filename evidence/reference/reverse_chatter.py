"""Bounces that grow out of rolling on a slope, to 25 digits.

    python3 -m pip install gmpy2 python-flint
    python3 reverse_chatter.py                 writes reverse_chatter.json beside this file

What is independent here.  Nothing knows of a ratio, of a region, or of fixed angles: flights, and
impacts of the package `follower` (here the parabola of the mass centre, there the balances in the
normal impulse from event to event), 150 digits, one after the other.  A hoop at a place of contact
without slip is thrown with the rate 1e-32: the ratio is that of its first bounce.  Where it grows,
the hoop is thrown with the rate 2^-20, and followed until a bounce is faster than 0.02.  Half of
the places are drawn so that bounces grow.

Units: mass of the particle, radius and gravity are 1.
"""

import json
import os
import random

import gmpy2
from follower.hoop import Hoop, rolling_forces, unloaded
from follower.impact import impact
from gmpy2 import mpfr

DIGITS = 25
SMALL, FIRST, LARGE = mpfr("1e-32"), mpfr(2) ** -20, mpfr("0.02")


def bounce(hoop, state, gap_rate, law):
    """The state and the rate of the gap after the next bounce, and its time."""
    theta, rate, slip, x = state
    (s, c), h = gmpy2.sin_cos(theta), hoop.h
    up, along = gap_rate - h * s * rate, slip - rate - h * c * rate  # velocity of the mass centre
    t = 2 * gap_rate / unloaded(hoop, theta, rate)
    for _ in range(
        200
    ):  # Newton's iteration on the parabola of the mass centre and the cosine of the rim below it
        gap = up * t - hoop.down * t * t / 2 + h * (c - gmpy2.cos(theta + rate * t))
        step = gap / (up - hoop.down * t + h * rate * gmpy2.sin(theta + rate * t))
        t -= step
        if abs(step) < t * mpfr("1e-60"):
            break
    else:
        raise ArithmeticError("no landing")
    turned = theta + rate * t
    s_after, c_after = gmpy2.sin_cos(turned)
    closing = up - hoop.down * t + h * rate * s_after
    landing = rate, along - hoop.along * t + rate + h * c_after * rate, closing
    new_rate, new_slip, opening = impact(hoop, turned, landing, *law)
    x += h * (s_after - s) + along * t - hoop.along * t * t / 2
    return (turned, new_rate, new_slip, x), opening, t


def draw(rng):
    """A rough hoop on a slope, with the particle uphill of the contact."""
    mass_ratio = round(10 ** rng.uniform(-1.5, 0.5), 3)
    mu_s = round(rng.uniform(0.4, 2.0), 3)
    slope = round(rng.uniform(0.1, 1.3), 3) * rng.choice((-1, 1))
    offset = round(rng.uniform(0.5, 1.0), 3)
    numbers = (
        mass_ratio,
        offset,
        round(mass_ratio * rng.uniform(0.2, 1), 4),
        mu_s,
        round(mu_s * rng.uniform(0.6, 1), 3),
        slope,
    )
    place = round(rng.uniform(0.2, 3.0), 3) * (-1 if slope > 0 else 1), round(rng.uniform(-1, 1), 3)
    return numbers, place, (round(rng.uniform(0.4, 0.95), 3), rng.choice(("energetic", "poisson")))


def rolls(hoop, theta, rate):
    """Whether static friction holds."""
    _, normal, friction = rolling_forces(hoop, theta, rate)
    return normal > 0 and abs(friction) < hoop.mu_s * normal


def text(number):
    return f"{{:.{DIGITS}g}}".format(number)


def case(numbers, place, law):
    """What becomes of a bounce, or None.

    None where static friction does not hold, or the bounce does not stick or hardly changes.
    """
    hoop = Hoop(*numbers)
    theta, rate = map(mpfr, place)
    if not rolls(hoop, theta, rate) or unloaded(hoop, theta, rate) < 0.05:
        return None
    law = mpfr(law[0]), law[1]
    state, opening, time = bounce(hoop, (theta, rate, mpfr(0), mpfr(0)), SMALL, law)
    ratio = opening / SMALL
    if state[2] != 0 or abs(ratio - 1) < 0.03:
        return None
    found = {"ratio": text(ratio)}
    if ratio > 1:
        # From a rate that a double resolves, for a comparison bounce by bounce.
        state, opening, time = (theta, rate, mpfr(0), mpfr(0)), FIRST, mpfr(0)
        rates = []
        while opening < LARGE:
            state, opening, more = bounce(hoop, state, opening, law)
            if len(rates) > 2000 or opening < (rates or [FIRST])[-1]:
                return None
            rates.append(opening)
            time += more
        end = {"time": time, **dict(zip(("theta", "theta_rate", "slip", "x"), state))}
        found.update(
            rates=[text(value) for value in rates],
            end={name: text(value) for name, value in end.items()},
        )
    return found


def main():
    gmpy2.get_context().precision = 500
    rng = random.Random(35)
    cases = {True: [], False: []}
    while min(map(len, cases.values())) < 12:
        numbers, place, law = draw(rng)
        found = case(numbers, place, law)
        if found is not None and len(cases["end" in found]) < 12:
            entry = {"hoop": numbers, "start": place, "restitution": law[0], "law": law[1], **found}
            cases["end" in found].append(entry)
    lines = ",\n  ".join(json.dumps(entry) for entry in cases[True] + cases[False])
    with open(
        os.path.join(os.path.dirname(os.path.abspath(__file__)), "reverse_chatter.json"), "w"
    ) as file:
        file.write(f'{{"cases": [\n  {lines}\n]}}\n')


if __name__ == "__main__":
    main()
