"""Starts of a massless hoop beside a curve."""

import math

import gmpy2
from follower.hoop import Hoop
from gmpy2 import mpfr

from .draws import beside, signed
from .orbit import rolled


def type_ii(dice, body):
    """Friction and normal force of rolling give way together."""
    l = body[1]
    theta = signed(dice, 0.1, 2.8)
    c = math.cos(theta)
    if l + c <= 0.02:
        return None
    hoop = Hoop(*body, 0, 0)
    u = (1 + hoop.l * gmpy2.cos(mpfr(theta))) / (hoop.l * (hoop.l + gmpy2.cos(mpfr(theta))))
    mu_s = float(hoop.l * gmpy2.sin(mpfr(abs(theta))) / (1 + hoop.l * gmpy2.cos(mpfr(theta))))
    start = theta * dice.uniform(-0.5, 0.98)
    v = rolled(hoop, mpfr(theta), gmpy2.sqrt(u), mpfr(start))
    if v <= 0:
        return None
    rate = math.copysign(float(gmpy2.sqrt(v)), theta) * (1 + beside(dice))
    return (*body, mu_s, mu_s * dice.random()), (start, rate, 0.0, 0.0), 8.0


def fallen_back(dice, body, theta, rate, slip):
    """Where a glide began that leads to a state."""
    l = mpfr(body[1])
    s, c = gmpy2.sin_cos(mpfr(theta))
    side, t = (1 if s > 0 else -1), mpfr(-dice.uniform(0.02, 0.8))
    vy, vx = -l * s * rate, mpfr(slip) - rate * (1 + l * c)
    y = l * c + vy * t - t * t / 2
    if not -l < y < l:
        return None
    sine = side * gmpy2.sqrt(l * l - y * y)
    turn_rate = (t - vy) / sine
    return [float(v) for v in (gmpy2.atan2(sine, y), turn_rate, vx + turn_rate * (1 + y))]


def gliding_rest_on_slip_curve(dice, body):
    """The slip of a glide comes to rest on the slip curve of rolling."""
    theta, rate = signed(dice, 0.1, 3.0), signed(dice, 0.05, 3)
    mu_s = body[1] * math.sin(abs(theta)) / (1 + body[1] * math.cos(theta)) * (1 + beside(dice))
    back = fallen_back(dice, body, theta, rate, 0)
    return back and ((*body, mu_s, mu_s * dice.random()), (*back, 0.0), 8.0)


def gliding_slip_that_touches_rest(dice, body):
    """The slip of a glide touches zero: N = 0 of rolling, and eta' = 0."""
    l, theta = mpfr(body[1]), signed(dice, 0.1, 3.0)
    c = gmpy2.cos(mpfr(theta))
    if l + c < 0.02:
        return None
    rate = gmpy2.sqrt((1 + l * c) / (l * (l + c))) * dice.choice((-1, 1))
    back = fallen_back(dice, body, theta, rate, 0)
    if back is None:
        return None
    mu_s = dice.uniform(0.05, 3)
    return (*body, mu_s, mu_s * dice.random()), (back[0], back[1], back[2] + beside(dice), 0.0), 8.0


def particle_that_just_reaches_the_top(dice, body):
    theta = signed(dice, 0.01, 3.0)
    rate = -math.copysign((2 / (body[1] * (1 + math.cos(theta)))) ** 0.5, theta) * (
        1 + beside(dice)
    )
    mu_s = dice.uniform(0.05, 3)
    return (
        (*body, mu_s, mu_s * dice.random()),
        (theta, rate, dice.choice((0.0, dice.uniform(-3, 3))), 0.0),
        8.0,
    )


def gliding_rest_at_turning_point(dice, body):
    theta = signed(dice, 0.2, 3.0)
    rate = -math.copysign(
        dice.uniform(0.05, 0.99) * (2 / (body[1] * (1 + math.cos(theta)))) ** 0.5, theta
    )
    slip = rate * (1 + body[1] * math.cos(theta)) + beside(dice)
    mu_s = dice.uniform(0.05, 3)
    return (*body, mu_s, mu_s * dice.random()), (theta, rate, slip, 0.0), 8.0


def gliding_rest_at_the_bottom(dice, body):
    """A particle next to its lowest place, or one close to the rim at large rates."""
    mu_s = dice.uniform(0.05, 3)
    if dice.random() < 0.5:
        theta = math.copysign(math.pi, signed(dice, 1, 2)) + beside(dice)
        rate, slip = signed(dice, 0, 3), dice.choice((0.0, dice.uniform(-3, 3)))
    else:
        body = 0.0, 1 - 10.0 ** dice.uniform(-12, -2), 0.0
        theta, rate = signed(dice, 0.1, 3.1), signed(dice, 1, 1) * 10.0 ** dice.uniform(0, 3)
        slip = dice.choice((0.0, dice.uniform(-3, 3)))
    return (*body, mu_s, mu_s * dice.random()), (theta, rate, slip, 0.0), 8.0


def massless_start_beside_a_curve(dice, body):
    """The slip curve, the curve N = 0, or eta' = 0."""
    l, theta = body[1], signed(dice, 0.05, 3.0)
    cone = l * math.sin(abs(theta)) / (1 + l * math.cos(theta))
    mu_s, rate, slip = dice.uniform(0.05, 3), signed(dice, 0, 2), 0.0
    kind = dice.randrange(3)
    if kind == 0:
        mu_s = cone * (1 + beside(dice))
    elif kind == 1:
        if l + math.cos(theta) < 0.02:
            return None
        rate = (
            ((1 + l * math.cos(theta)) / (l * (l + math.cos(theta)))) ** 0.5
            * dice.choice((-1, 1))
            * (1 + beside(dice))
        )
    else:
        slip = beside(dice)
    return (*body, mu_s, mu_s * dice.random()), (theta, rate, slip, 0.0), 5.0
