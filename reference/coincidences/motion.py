"""A motion, from phase to phase."""

import gmpy2
from gmpy2 import mpfr

from .arithmetic import Tie
from .contact import smooth
from .flight import flight
from .glide import glide
from .hoop import Hoop, at_rest, unloaded

MOST = 6                         # transitions that are followed
NUMBERS = ("time", "theta", "theta_rate", "slip", "x")


def follow(numbers, start, until, noise=None):
    """The motion: (mode and direction at the start, transitions, how it ended).

    `noise` returns a factor near 1 for each number; it is applied to the hoop and to the state at the start of each phase.
    """
    shaken = (lambda v: v) if noise is None else (lambda v: v * noise())
    mass_ratio, offset, inertia, mu_s, mu_k = numbers
    exact = mpfr(offset) if offset == 1 else shaken(mpfr(offset))
    hoop = Hoop(shaken(mpfr(mass_ratio)), exact, shaken(mpfr(inertia)), shaken(mpfr(mu_s)), shaken(mpfr(mu_k)))
    now, gap_rate = tuple(map(mpfr, start[:3])) + (mpfr(0),), shaken(mpfr(start[3]))
    time_now, until = mpfr(0), mpfr(until)
    transitions, first, came = [], None, None
    forced = None
    while True:
        now = tuple(map(shaken, now))
        time_now = shaken(time_now)
        known = 0
        if forced is not None:
            (mode, way), known, forced = forced[:2], forced[2], None
            if noise is not None and (mode == "flight" or known == 2):
                # Still on the curve where the normal force vanishes.
                cos, l = gmpy2.cos(now[0]), hoop.l
                square = 1 / (hoop.h * cos) if mode == "flight" else (1 + l * cos) / (l * (l + cos))
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
        left = until - time_now
        if mode == "gliding":
            cause, t, then, way = glide(hoop, now, known, left)
        elif mode == "flight":
            cause, t, then, _ = flight(hoop, now, gap_rate, left)
            gap_rate = mpfr(0)
        else:
            cause, t, then, towards = smooth(hoop, mode, way, now, known, left)
        if first is None:
            first = mode, way
        if came is not None:
            if came["cause"] == "stick" and mode != "rolling":
                came["cause"] = "lift_off" if mode == "flight" else "graze" if way == came.pop("from") else "reversal"
            came.update(to=mode, direction=way)
            came.pop("from", None)
        time_now, now = time_now + t, then
        if cause is None:
            return first, transitions, mode, dict(zip(NUMBERS, (time_now,) + now))
        came = {"cause": cause, "to": "none", "direction": 0, **dict(zip(NUMBERS, (time_now,) + now))}
        transitions.append(came)
        if cause in ("landing", "particle_at_plane", "particle_at_bottom", "particle_at_top"):
            return first, transitions, cause, dict(zip(NUMBERS, (time_now,) + now))
        if len(transitions) == MOST + 1:
            return first, transitions[:MOST], "more", None
        came["from"] = way
        if cause == "slip":
            now = (now[0], now[1], mpfr(0), now[3])
            forced = ("gliding", None, 1) if hoop.massless else ("sliding", towards, 1)
        elif cause == "normal_force_zero":
            now = (now[0], now[1], mpfr(0), now[3])
            forced = ("gliding", None, 2)
        elif cause == "lift_off":
            forced = ("flight", 0, 0)
        else:
            now = (now[0], now[1], mpfr(0), now[3])
