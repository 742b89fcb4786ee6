"""Starts of a hoop that has inertia, or that rolls, beside a curve."""

import math

import gmpy2
from follower.contact import drift
from follower.hoop import Hoop, rolling_forces, unloaded
from follower.roots import highest
from gmpy2 import mpfr

from .draws import beside, frictions, signed, solvable
from .orbit import demand, rolled, travel


def grazing_slip(dice, body):
    """The largest friction demand on a rolling orbit is the coefficient of static friction."""
    hoop = Hoop(*body, 0, 0)
    theta, rate = dice.uniform(-3.1, 3.1), signed(dice, 0.2, 2.5)
    way = 1 if rate > 0 else -1
    path = [theta + way * 0.02 * k for k in range(1, 300)]
    values = []
    for angle in path:
        u = rolled(hoop, mpfr(theta), mpfr(rate), mpfr(angle))
        if u <= 0.01:
            break
        values.append(demand(hoop, mpfr(angle), u))
    tops = [
        k
        for k in range(2, len(values) - 1)
        if values[k][0] > max(values[k - 1][0], values[k + 1][0])
        and all(v[1] > 0 for v in values[: k + 2])
        and values[k][0] > 1.001 * max(v[0] for v in values[: k - 1])
    ]
    if not tops:
        return None
    k = dice.choice(tops)

    def at(angle):
        return demand(hoop, angle, rolled(hoop, mpfr(theta), mpfr(rate), angle))[0]

    mu_s = float(at(highest(at, mpfr(path[k - 1]), mpfr(path[k + 1])))) * (1 + beside(dice))
    mu_k = solvable(body, mu_s * dice.uniform(0.2, 0.95))
    return (*body, mu_s, mu_k), (theta, rate, 0.0, 0.0), travel(hoop, theta, rate, path[k]) + 0.4


def turning_on_slip_curve(dice, body):
    """A libration that turns back where the friction demand is the coefficient."""
    hoop = Hoop(*body, 0, 0)
    turn = signed(dice, 0.3, 3.0)
    bottom = math.copysign(math.pi, turn)
    theta = turn + (bottom - turn) * dice.uniform(0.02, 0.5)
    u = rolled(hoop, mpfr(turn), mpfr(0), mpfr(theta))
    rate = -math.copysign(float(gmpy2.sqrt(u)), turn)
    ratio, n = demand(hoop, mpfr(turn), mpfr(0))
    if n <= 0:
        return None
    mu_s = float(ratio) * (1 + beside(dice))
    mu_k = solvable(body, mu_s * dice.uniform(0.2, 0.95))
    return (*body, mu_s, mu_k), (theta, rate, 0.0, 0.0), travel(hoop, theta, rate, turn) + 0.4


def slid_back(dice, numbers, sigma, state, longest=0.8):
    """Where a slide began that leads to a state."""
    hoop = Hoop(*numbers)
    duration = dice.uniform(0.05, longest)
    began = drift(hoop, "sliding", sigma, tuple(map(mpfr, state)), -mpfr(duration))
    if began is None or sigma * began[2] <= 0 or unloaded(hoop, began[0], began[1]) <= 0:
        return None
    return [float(v) for v in began], duration


def stick_at_lift_off(dice, body):
    """The slip comes to rest where the normal force of the slide vanishes."""
    numbers = (*body, *frictions(dice, body))
    hoop = Hoop(*numbers)
    theta = signed(dice, 0.05, 1.5)
    rate = -math.copysign(float(1 / gmpy2.sqrt(hoop.h * gmpy2.cos(mpfr(theta)))), theta)
    back = slid_back(dice, numbers, 1 if theta > 0 else -1, (theta, rate, 0.0), 0.5)
    if back is None:
        return None
    (theta, rate, slip), duration = back
    return numbers, (theta, rate, slip + beside(dice), 0.0), duration + 0.4


def reversal_or_stick(dice, body):
    """The slip comes to rest where the friction demand is the coefficient of static friction."""
    hoop = Hoop(*body, 0, 0)
    theta, rate = dice.uniform(-3.0, 3.0), signed(dice, 0, 2.5)
    _, n, f = rolling_forces(hoop, mpfr(theta), mpfr(rate))
    if n <= 0.01:
        return None
    mu_s = float(abs(f) / n)
    numbers = (*body, mu_s * (1 + beside(dice)), solvable(body, mu_s * dice.uniform(0.1, 0.95)))
    back = slid_back(dice, numbers, 1 if f > 0 else -1, (theta, rate, 0.0))
    return back and (numbers, (*back[0], 0.0), back[1] + 0.4)


def slip_that_touches_rest(dice, body):
    """The slip velocity touches zero.

    There the friction demand is the coefficient of kinetic friction.
    """
    hoop = Hoop(*body, 0, 0)
    theta, rate = dice.uniform(-3.0, 3.0), signed(dice, 0, 2.5)
    _, n, f = rolling_forces(hoop, mpfr(theta), mpfr(rate))
    if n <= 0.01:
        return None
    mu_k = float(abs(f) / n)
    numbers = (*body, mu_k * dice.uniform(1.05, 2), mu_k)
    if solvable(body, mu_k) != mu_k:
        return None
    back = slid_back(dice, numbers, -1 if f > 0 else 1, (theta, rate, 0.0), 0.5)
    if back is None:
        return None
    (theta, rate, slip), duration = back
    return numbers, (theta, rate, slip + beside(dice), 0.0), duration + 0.4


def normal_force_that_touches_zero(dice, body):
    """A slide over the top at the rate at which the normal force just vanishes there."""
    numbers = (*body, *frictions(dice, body))
    hoop = Hoop(*numbers)
    rate = float(1 / gmpy2.sqrt(hoop.h)) * (1 + beside(dice)) * dice.choice((-1, 1))
    slip = signed(dice, 0.2, 2)
    if abs(rate) > 40:
        return None
    back = slid_back(dice, numbers, 1 if slip > 0 else -1, (0.0, rate, slip), 0.6)
    return back and (numbers, (*back[0], 0.0), back[1] + 0.4)


def landing_that_grazes(dice, body):
    """A hoop thrown so that its rim touches the plane on the way."""
    hoop = Hoop(*body, 0, 0)
    theta, rate = dice.uniform(-3.1, 3.1), signed(dice, 2, 12)
    h = float(hoop.h)

    def needed(t):
        return (
            t * t / 2 + hoop.h * (gmpy2.cos(theta + rate * t) - gmpy2.cos(mpfr(theta)))
        ) / t + hoop.h * rate * gmpy2.sin(mpfr(theta))

    times = [0.05 / abs(rate) * k for k in range(1, int(60 + 12 * h * rate * rate))][:900]
    values = [
        t / 2 + h * (math.cos(theta + rate * t) - math.cos(theta)) / t + h * rate * math.sin(theta)
        for t in times
    ]
    tops = [
        k
        for k in range(1, len(values) - 1)
        if values[k] > values[k - 1]
        and values[k] > values[k + 1]
        and values[k] >= max(values[: k + 1])
        and values[k] > 0.05
    ]
    if not tops:
        return None
    k = dice.choice(tops[:4])
    v = float(needed(highest(needed, mpfr(times[k - 1]), mpfr(times[k + 1])))) * (1 + beside(dice))
    return (*body, 0.5, 0.4), (theta, rate, dice.uniform(-1, 1), v), 100.0


def start_beside_slip_curve(dice, body):
    hoop = Hoop(*body, 0, 0)
    theta, rate = dice.uniform(-3.0, 3.0), signed(dice, 0, 2.5)
    _, n, f = rolling_forces(hoop, mpfr(theta), mpfr(rate))
    if n <= 0.01:
        return None
    mu_s = float(abs(f) / n) * (1 + beside(dice))
    return (
        (*body, mu_s, solvable(body, mu_s * dice.uniform(0.2, 0.95))),
        (theta, rate, 0.0, 0.0),
        0.7,
    )


def start_beside_lift_off_curve(dice, body):
    numbers = (*body, *frictions(dice, body))
    theta = signed(dice, 0.02, 1.5)
    rate = (
        float(1 / gmpy2.sqrt(Hoop(*numbers).h * gmpy2.cos(mpfr(theta))))
        * (1 + beside(dice))
        * dice.choice((-1, 1))
    )
    slip = dice.choice((0.0, dice.uniform(-2, 2)))
    return numbers, (theta, rate, slip, 0.0), 0.7


def start_beside_vanishing_normal_force(dice, body):
    """N = 0 of rolling."""
    numbers = (*body, *frictions(dice, body))
    hoop = Hoop(*numbers)
    theta = dice.uniform(-1.6, 1.6)
    n0, n1 = (rolling_forces(hoop, mpfr(theta), mpfr(rate))[1] for rate in (0, 1))
    if n1 >= n0:
        return None
    rate = float(gmpy2.sqrt(n0 / (n0 - n1))) * (1 + beside(dice)) * dice.choice((-1, 1))
    return numbers, (theta, rate, 0.0, 0.0), 0.7


def start_with_hardly_any_slip(dice, body):
    numbers = (*body, *frictions(dice, body))
    return numbers, (dice.uniform(-3.1, 3.1), signed(dice, 0, 2.5), beside(dice), 0.0), 0.7
