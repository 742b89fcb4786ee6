"""A flight."""

import gmpy2
from gmpy2 import mpfr

from .arithmetic import Tie
from .roots import first_fall

LONGEST = 200_000  # intervals in which a landing is looked for


def flight(hoop, state, gap_rate, until):
    """A flight to the landing: as `smooth`, with the rate of the gap at its end."""
    theta, rate, slip, x = state
    h, down = hoop.h, hoop.down
    s0, c0 = gmpy2.sin_cos(theta)
    up = gap_rate - h * s0 * rate  # of the mass centre
    along = slip - rate - h * c0 * rate

    def gap(t):
        return up * t - down * t * t / 2 - h * (gmpy2.cos(theta + rate * t) - c0)

    def gap_slope(t):
        return up - down * t + h * rate * gmpy2.sin(theta + rate * t)

    # Between these times the mass centre is so high that the gap is open at every angle.
    high = up * up - 2 * down * h * (1 - c0)
    opens, closes = (
        ((up - gmpy2.sqrt(high)) / down, (up + gmpy2.sqrt(high)) / down)
        if up > 0 and high > 0
        else (None, None)
    )
    quick = 0.1 / (1 + abs(rate))
    t, landing = quick * 2.0**-60, None
    limit = mpfr(until)
    if gap(mpfr(t)) <= 0:
        raise Tie("lands at once")
    for _ in range(LONGEST):
        if opens is not None and opens < t < closes:
            t = closes * (1 - mpfr(2) ** -100)
        further = min(2 * t, t + quick)
        landing = first_fall(gap, gap_slope, mpfr(t), mpfr(further), 1)
        t = further
        if landing is not None or t > limit:
            break
    else:
        raise Tie("too long a flight")
    last = landing if landing is not None and landing <= limit else limit
    theta_last = theta + rate * last
    s, c = gmpy2.sin_cos(theta_last)
    mass_centre = x - h * s0 + along * last - hoop.along * last**2 / 2
    new = theta_last, rate, along - hoop.along * last + rate + h * c * rate, mass_centre + h * s
    return ("landing" if last is landing else None), last, new, up - down * last + h * rate * s
