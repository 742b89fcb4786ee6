"""The hoop of LITTLEWOOD_HOOP, or that of figure 2, and what follows at rest.

The variable has mass ratio, offset, inertia, mu_s and mu_k.

Everything here works on floats, compiled where numba is there, so that the peers spend their time
on integrating.
"""

import math
import os

try:
    from numba import njit
except ImportError:  # the peers that do not need numba still run

    def njit(function):
        return function


MASS_RATIO, ARM, MOMENT, MU_S, MU_K = map(
    float, os.environ.get("LITTLEWOOD_HOOP", "1 1 1 0.5 0.4").split()
)
MASS = 1.0 + MASS_RATIO  # of the whole
OFFSET = ARM / MASS  # of the mass centre
INERTIA = MOMENT + MASS_RATIO * ARM * ARM / MASS  # about it
FIGURE_3 = (math.pi / 2, 2.0)
ROLLS = (0.0, 0.5)

ROLL, FREE, NOT_ONE = 0, 9, 8  # modes beside sliding, which is +1 or -1; no mode, or several
AT_ONCE, LATER, CONTACT, FAILED = 0, 1, 2, 9  # outcomes: when the hoop leaves the plane
# Slip at the start of a slide, so that the event function does not start at 0. With equal
# coefficients a slide begins without an acceleration of the slip. An event that is found too soon
# makes it an acceleration e of the wrong sign, and the slip first goes back by e^2 over twice its
# second derivative: where the seed is less, the slide ends as it begins.
SEED = 1e-16 if MU_S == MU_K else 1e-300
MOST_PHASES = 1000  # a light hoop on a rough plane has 420 to tau = 50


@njit
def rolling(theta, rate):
    """Angular acceleration, normal force and friction."""
    c, s = math.cos(theta), math.sin(theta)
    acceleration = (
        ARM
        * s
        * (rate * rate + 1.0)
        / (INERTIA + MASS * (1.0 + OFFSET * OFFSET + 2.0 * OFFSET * c))
    )
    normal = MASS - ARM * (s * acceleration + c * rate * rate)
    friction = ARM * s * rate * rate - MASS * (1.0 + OFFSET * c) * acceleration
    return acceleration, normal, friction


@njit
def sliding(theta, rate, sign):
    """Angular acceleration, slip acceleration and normal force."""
    c, s = math.cos(theta), math.sin(theta)
    q = OFFSET * s - MU_K * sign * (1.0 + OFFSET * c)
    normal = INERTIA * MASS * (1.0 - OFFSET * c * rate * rate) / (INERTIA + MASS * OFFSET * s * q)
    acceleration = normal * q / INERTIA
    slip = (
        -MU_K * sign * normal / MASS + (1.0 + OFFSET * c) * acceleration - OFFSET * s * rate * rate
    )
    return acceleration, slip, normal


@njit
def slip_margins(theta, rate):
    """Both fall through 0 where static friction gives way.

    The first leads to a slide with sign -1, the second to one with +1.
    """
    _, normal, friction = rolling(theta, rate)
    return MU_S * normal - friction, MU_S * normal + friction


@njit
def weight(theta, rate):
    """Falls through 0 where a sliding hoop lifts off."""
    return 1.0 - OFFSET * math.cos(theta) * rate * rate


@njit
def mode_at_rest(theta, rate):
    """What follows where the contact point is at rest."""
    _, normal, friction = rolling(theta, rate)
    if normal > 0.0 and abs(friction) <= MU_S * normal:
        return ROLL
    mode = FREE
    for sign in (-1, 1):
        _, slip, normal = sliding(theta, rate, float(sign))
        if normal > 0.0 and slip * sign > 0.0:
            mode = sign if mode == FREE else NOT_ONE
    # A hoop that falls on to the plane is not free: no motion is consistent there (Painleve).
    return NOT_ONE if mode == FREE and weight(theta, rate) > 0.0 else mode


@njit
def mode_after(mode, event, theta, rate):
    """What follows an event, 0 or 1 as the functions above, that ends a phase at rest."""
    way = -1 if event == 0 else 1
    if mode == ROLL and MU_S == MU_K:  # rounding decides on a slip without an acceleration
        return way
    following = mode_at_rest(theta, rate)
    if mode == ROLL and following == ROLL:  # on the limit, but for rounding
        return way
    return following


def follow(theta, rate, until, advance, slip=0.0):
    """Outcome and times of the events.

    `advance(mode, time, state, until)` returns an event or None, the time and the state.
    """
    time, state, times = 0.0, (theta, rate, slip, 0.0), []
    mode = int(math.copysign(1.0, slip)) if slip else mode_at_rest(theta, rate)
    if mode == FREE or slip and weight(theta, rate) < 0.0:
        return AT_ONCE, times
    while mode != NOT_ONE and len(times) < MOST_PHASES:
        theta, rate, _, x = state
        event, time, state = advance(mode, time, (theta, rate, slip or SEED * mode, x), until)
        slip = 0.0
        if event is None:
            return CONTACT, times
        times.append(time)
        if mode != ROLL and event == 0:
            return LATER, times
        mode = mode_after(mode, event, state[0], state[1])
        if mode == FREE:
            return LATER, times
    return FAILED, times


def listed():
    """The starts (angle, rate, slip) of the file LITTLEWOOD_STARTS, which has a header."""
    with open(os.environ["LITTLEWOOD_STARTS"]) as file:
        return [tuple(map(float, line.split(","))) for line in list(file)[1:]]


def grid(cells, pick):
    """The picked rows and columns of the square grid of starts, row after row."""
    import numpy

    thetas = numpy.linspace(-math.pi, math.pi, cells)[pick]
    rates = numpy.linspace(-4.0, 4.0, cells)[pick]
    return [(float(theta), float(rate)) for rate in rates for theta in thetas]
