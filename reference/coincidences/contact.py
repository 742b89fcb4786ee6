"""Rolling and sliding, by Taylor series."""

from gmpy2 import mpfr

from .arithmetic import Tie
from .hoop import slide_acceleration
from .roots import fall_of
from .series import circle, reach, series, value

LONGEST = 100                    # steps of a series in a phase


def smooth(hoop, mode, sigma, state, known, until):
    """Rolling or sliding to its first event: (cause, time, state, direction), or None for the cause at the time limit."""
    t, (theta, rate, slip, x) = mpfr(0), state
    known_slip = known
    for _ in range(LONGEST):
        th, w, eta, n, f = parts = series(hoop, (theta, rate, slip), sigma if mode == "sliding" else None)
        length = reach(parts)
        last = t + length >= until
        if last:
            length = until - t
        events = []
        if mode == "rolling":
            if hoop.massless:
                # F/N = -h s/(1 + h c) by the balance of moment alone; N vanishes with F.
                s, c = circle(th)
                cone = [[hoop.mu_s * hoop.h * ck + way * hoop.h * sk for sk, ck in zip(s, c)] for way in (1, -1)]
                for p in cone:
                    p[0] += hoop.mu_s
                # F = -N h s/(1 + h c): mu_s N + F falls first where the slip is to the positive side, s > 0
                events = [(fall_of(cone[1], length), "slip", 1), (fall_of(cone[0], length), "slip", -1),
                          (fall_of(n, length), "normal_force_zero", 0)]
            else:
                plus = [hoop.mu_s * a + b for a, b in zip(n, f)]
                minus = [hoop.mu_s * a - b for a, b in zip(n, f)]
                events = [(fall_of(plus, length), "slip", 1), (fall_of(minus, length), "slip", -1)]
        else:
            if slide_acceleration(hoop, theta, rate, sigma)[2] <= 0:
                raise Tie("Painleve")
            events = [(fall_of([sigma * v for v in eta], length, known_slip), "stick", 0),
                      (fall_of(n, length), "lift_off", 0)]
        known_slip = 0
        found = min(((at, cause, way) for at, cause, way in events if at is not None), default=None)
        at = mpfr(length) if found is None else found[0]
        close = [e for e in events if e[0] is not None and found is not None and e[0] - at < 1e-38]
        if len(close) > 1:
            raise Tie("two events at once")
        moved = value([mpfr(0)] + [v / (k + 1) for k, v in enumerate(eta)], at)
        new = value(th, at), value(w, at), value(eta, at), None
        x = x + moved - (new[0] - theta)
        theta, rate, slip, t = new[0], new[1], new[2], t + at
        if found is not None:
            return found[1], t, (theta, rate, slip, x), found[2]
        if last:
            return None, t, (theta, rate, slip, x), 0
    raise Tie("too many steps")


def drift(hoop, mode, sigma, state, duration):
    """State of rolling or sliding after a time of either sign, without events."""
    t, (theta, rate, slip) = mpfr(0), state
    sign = 1 if duration > 0 else -1
    while t != duration:
        th, w, eta, n, f = parts = series(hoop, (theta, rate, slip), sigma if mode == "sliding" else None)
        at = sign * min(mpfr(reach(parts)), abs(duration - t))
        if mode == "sliding" and t != 0 and (sigma * slip <= 0 or n[0] <= 0):
            return None
        theta, rate, slip = value(th, at), value(w, at), value(eta, at)
        t += at
    return theta, rate, slip
