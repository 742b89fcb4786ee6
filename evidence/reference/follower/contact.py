"""Rolling and sliding, by Taylor series."""

import gmpy2
from gmpy2 import mpfr

from .arc import Arc
from .arithmetic import Tie, Work
from .hoop import rolling_forces, slide_acceleration
from .roots import arb, fall_of
from .series import circle, reach, series, value

SHORT = 0.01  # step in the angle, below which one in the time is longer


def smooth(hoop, mode, sigma, state, known, until):
    """Rolling or sliding to its first event: (cause, time, state, direction).

    The cause is None at the time limit.

    Rolling goes on for ever where nothing has ended it after a turn, or after there and back.
    """
    t, began, turned = mpfr(0), state[0], 0
    for _ in range(Work.steps):
        whole = hoop.along == 0 and abs(state[0] - began) > 7
        if mode == "rolling" and (whole or turned > 2):
            return "rolls_forever", t, state, 0
        a, _, p = (
            slide_acceleration(hoop, state[0], state[1], sigma)
            if mode == "sliding"
            else rolling_forces(hoop, state[0], state[1])
        )
        if mode == "sliding" and p <= 0:
            raise Tie("Painleve")
        if mode == "rolling" and state[1] == 0 == a:
            return "rolls_forever", t, state, 0
        found = None
        if state[1] ** 2 > 0.3 * abs(a):
            found = in_angle(hoop, mode, sigma, state, known, until - t)
        if found is None:
            found = in_time(hoop, mode, sigma, state, known, until - t)
        cause, at, then, way = found
        known = 0
        turned += then[1] * state[1] < 0
        t, state = t + at, then
        if cause == "limit":
            return None, t, state, 0
        if cause is not None:
            return cause, t, state, way
    raise Tie("too many steps")


def earliest(events):
    """The first of (time or None, cause, direction)."""
    events = sorted(e for e in events if e[0] is not None)
    if len(events) > 1 and events[1][0] - events[0][0] < 1e-38:
        raise Tie("two events at once")
    return events[0] if events else None


def in_angle(hoop, mode, sigma, state, known, left):
    """A step in the angle: (cause or None, its time, state, direction).

    None where such a step is short.
    """
    arc = Arc(hoop, state, sigma if mode == "sliding" else None)
    length = arc.reach()
    if length < SHORT:
        return None
    events = [
        (arc.fall(p, length, known if cause == "stick" else 0), cause, way)
        for p, cause, way in arc.events
    ]
    if arc.value(arc.time, length) >= left:
        events.append((arc.fall(arb(left) - arc.time, length, 0), "limit", 0))
    at, cause, way = earliest(events) or (length, None, 0)
    theta = state[0] + arc.way * at
    x = state[3] + arc.value(arc.moved, at) - arc.way * at
    rate = arc.way * gmpy2.sqrt(arc.value(arc.u, at))
    return cause, arc.value(arc.time, at), (theta, rate, arc.value(arc.slip, at), x), way


def in_time(hoop, mode, sigma, state, known, left):
    """A step in the time, as `in_angle`."""
    theta, rate, slip, x = state
    th, w, eta, n, f = parts = series(
        hoop, (theta, rate, slip), sigma if mode == "sliding" else None
    )
    length = reach(parts)
    last = length >= left
    if last:
        length = left
    if mode == "sliding":
        events = [
            (fall_of([sigma * v for v in eta], length, known), "stick", 0),
            (fall_of(n, length), "lift_off", 0),
        ]
    elif hoop.massless:
        # F/N = -h s/(1 + h c) by the balance of moment alone; N vanishes with F.
        s, c = circle(th)
        cone = [
            [hoop.mu_s * hoop.h * ck + way * hoop.h * sk for sk, ck in zip(s, c)] for way in (1, -1)
        ]
        for p in cone:
            p[0] += hoop.mu_s
        # F = -N h s/(1 + h c): mu_s N + F falls first where the slip is to the positive side, s > 0
        events = [
            (fall_of(cone[1], length), "slip", 1),
            (fall_of(cone[0], length), "slip", -1),
            (fall_of(n, length), "normal_force_zero", 0),
        ]
    else:
        plus = [hoop.mu_s * a + b for a, b in zip(n, f)]
        minus = [hoop.mu_s * a - b for a, b in zip(n, f)]
        events = [(fall_of(plus, length), "slip", 1), (fall_of(minus, length), "slip", -1)]
    at, cause, way = earliest(events) or (mpfr(length), "limit" if last else None, 0)
    moved = value([mpfr(0)] + [v / (k + 1) for k, v in enumerate(eta)], at)
    new = value(th, at)
    return cause, at, (new, value(w, at), value(eta, at), x + moved - (new - theta)), way


def drift(hoop, mode, sigma, state, duration):
    """State of rolling or sliding after a time of either sign, without events."""
    t, (theta, rate, slip) = mpfr(0), state
    sign = 1 if duration > 0 else -1
    while t != duration:
        th, w, eta, n, f = parts = series(
            hoop, (theta, rate, slip), sigma if mode == "sliding" else None
        )
        at = sign * min(mpfr(reach(parts)), abs(duration - t))
        if mode == "sliding" and t != 0 and (sigma * slip <= 0 or n[0] <= 0):
            return None
        theta, rate, slip = value(th, at), value(w, at), value(eta, at)
        t += at
    return theta, rate, slip
