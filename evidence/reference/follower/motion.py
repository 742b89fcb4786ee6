"""A motion, from phase to phase."""

import gmpy2
from gmpy2 import mpfr

from .arithmetic import Tie
from .contact import smooth
from .flight import flight
from .glide import glide
from .hoop import Hoop, at_rest, slide_acceleration, unloaded
from .impact import impact

MOST = 6  # transitions that are followed
NUMBERS = ("time", "theta", "theta_rate", "slip", "x")
SLOWEST = 2.0**-40  # rate of the gap after an impact, below which bounces have settled


def follow(numbers, start, until, noise=None, bounce=None, most=MOST, last=None):
    """The motion: (mode and direction at the start, transitions, how it ended, its end).

    `numbers` are those of the hoop; `start` has theta, its rate, the slip and the rate of the gap,
    and may have x and the time. `noise` returns a factor near 1 for each number; it is applied to
    the hoop and to the state at the start of each phase. `bounce` is the coefficient of restitution
    and its law: without it a motion ends as it lands. What follows the transition `last` is not
    asked.
    """
    shaken = (lambda v: v) if noise is None else (lambda v: v * noise())
    mass_ratio, offset, inertia, mu_s, mu_k, slope = (*numbers, 0)[:6]
    exact = mpfr(offset) if offset == 1 else shaken(mpfr(offset))
    body = exact, shaken(mpfr(mass_ratio)), shaken(mpfr(inertia))
    static = shaken(mpfr(mu_s))
    # Equal coefficients are equal by their nature.
    kinetic = static if mu_k == mu_s else shaken(mpfr(mu_k))
    hoop = Hoop(body[1], body[0], body[2], static, kinetic, shaken(mpfr(slope)))
    theta, rate, slip, gap_rate, x, time_now = map(mpfr, (*start, 0, 0)[:6])
    now, gap_rate = (theta, rate, slip, x), shaken(gap_rate)
    restitution = None if bounce is None else shaken(mpfr(bounce[0]))
    transitions = []
    first = [None]
    try:
        how, end = phases(
            hoop,
            (time_now, now, gap_rate),
            until,
            shaken,
            noise is not None,
            (restitution, bounce and bounce[1]),
            (most, last),
            first,
            transitions,
        )
    except Tie as tie:
        tie.first, tie.transitions = first[0], transitions
        raise
    return first[0], transitions, how, end


def phases(hoop, begin, until, shaken, noisy, bounce, counts, first, transitions):
    """From phase to phase: (how it ended, its end), the others in `first` and `transitions`."""
    (time_now, now, gap_rate), until = begin, mpfr(until)
    came, forced = None, None
    while True:
        now = tuple(map(shaken, now))
        time_now = shaken(time_now)
        known = 0
        if forced is not None:
            (mode, way), known, forced = forced[:2], forced[2], None
            if noisy and (mode == "flight" or hoop.massless and known == 2):
                # Still on the curve where the normal force vanishes.
                (sin, cos), l = gmpy2.sin_cos(now[0]), hoop.l
                pressed = hoop.down * (1 + l * cos) - hoop.along * l * sin
                square = (
                    hoop.down / (hoop.h * cos) if mode == "flight" else pressed / (l * (l + cos))
                )
                now = (now[0], gmpy2.copy_sign(gmpy2.sqrt(square), now[1])) + now[2:]
        elif gap_rate > 0:
            mode, way = "flight", 0
        elif now[2] == 0:
            mode, way = at_rest(hoop, now)
            known = 1
        elif hoop.massless:
            mode, way = "gliding", None
        else:
            w = unloaded(hoop, now[0], now[1])
            if abs(w) < 1e-38:
                raise Tie("on the lift-off curve")
            mode, way = ("sliding", 1 if now[2] > 0 else -1) if w > 0 else ("flight", 0)
            if slide_acceleration(hoop, now[0], now[1], 1 if now[2] > 0 else -1)[2] < 0:
                if mode == "flight":
                    raise Tie("sliding and flight")
                mode = "jam" if bounce[0] is not None else mode
        left = until - time_now
        closing = None
        if mode == "gliding":
            cause, t, then, way = glide(hoop, now, known, left)
        elif mode == "flight":
            cause, t, then, closing = flight(hoop, now, gap_rate, left)
            gap_rate = mpfr(0)
        elif mode == "jam":
            # The plane holds the rim, yet no slide is consistent: an impact without a collision
            # ends the slip.
            cause, t, then, closing = "jam", mpfr(0), now, mpfr(0)
        else:
            cause, t, then, towards = smooth(hoop, mode, way, now, known, left)
        if first[0] is None:
            first[0] = ("none", 0) if mode == "jam" else (mode, way)
        if came is not None and mode != "jam":
            if came["cause"] == "stick" and mode != "rolling":
                came["cause"] = (
                    "lift_off"
                    if mode == "flight"
                    else "graze"
                    if way == came.pop("from")
                    else "reversal"
                )
            came.update(to=mode, direction=way)
            came.pop("from", None)
        time_now, now = time_now + t, then
        end = dict(zip(NUMBERS, (time_now,) + now))
        if cause in (None, "rolls_forever"):
            return cause or mode, end
        came = {"cause": cause, "to": "none", "direction": 0, **end}
        transitions.append(came)
        if cause in ("landing", "jam") and bounce[0] is not None:
            came["gap_rate"] = closing
            rate, slip, gap_rate = impact(hoop, now[0], (now[1], now[2], closing), *bounce)
            came["after"] = dict(theta_rate=rate, slip=slip, gap_rate=gap_rate)
            if 0 < gap_rate < SLOWEST:
                raise Tie("bounces that settle")
        elif cause in ("landing", "particle_at_plane", "particle_at_bottom", "particle_at_top"):
            return cause, end
        if len(transitions) == counts[1]:
            return "last", end
        if len(transitions) == counts[0] + 1:
            transitions.pop()
            return "more", None
        if cause in ("landing", "jam"):
            now = (now[0], rate, slip, now[3])
            gap_rate = shaken(gap_rate)
            continue
        came["from"] = way
        if cause == "lift_off":
            forced = ("flight", 0, 0)
            continue
        now = (now[0], now[1], mpfr(0), now[3])
        if cause == "slip":
            # With equal coefficients the slip begins without an acceleration, too.
            order = 2 if hoop.mu_s == hoop.mu_k else 1
            forced = ("gliding", None, 1) if hoop.massless else ("sliding", towards, order)
        elif cause == "normal_force_zero":
            forced = ("gliding", None, 2)
