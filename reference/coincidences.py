"""Motions that start beside a curve on which two events coincide, to 40 digits, against the library.

    python3 -m pip install gmpy2 python-flint
    python3 coincidences.py                      all starts: writes coincidences.json beside this file
    python3 coincidences.py --starts 20 [NAME]   so many of each family, or of one: prints, writes nothing

Needs cargo: the library's answers are those of the example `transitions` of the core, built from this checkout.

What is independent here.  Rolling and sliding are integrated by Taylor series of the balances of momentum and of moment
of momentum themselves, solved order by order for (theta'', N, F); no reduced equation, no first integral, no elliptic
integral.  A gliding hoop hangs on a particle in free fall: the rests of its slip are the roots of a polynomial of
degree six in the time, all of them, from Arb.  The gap of a flight is that of a rigid body whose mass centre falls.
Every event is a root in a step of the series in which the signs at eight points and at the extrema between them are
known.  Inputs are IEEE doubles and taken exactly.

What is compared.  The sequence of modes, causes and directions of slip, and time, angle, rate, slip velocity and place
at each transition.  A number that the doubles of the start do not determine to its last digit cannot be right to its
last digit: its unit is 2^-52 of itself (of a place, at least 2^-52 of the radius) or, where that is more, the largest change among SHAKES repetitions in which
every number of the hoop and of the state at the start of each phase is changed by 2^-52 of itself, up or down (zeros
and offset = 1, which are exact by their nature, stay).  Errors are given in these units.  A start whose sequence changes
in such a repetition is not decided by its doubles; there the library has to give one of the sequences that occur.

Units: mass of the particle, radius and gravity are 1.
"""
import argparse
import gc
import json
import math
import multiprocessing
import os
import pickle
import random
import subprocess
import sys
import time
from operator import mul

import flint
import gmpy2
from gmpy2 import mpfr

HERE = os.path.dirname(os.path.abspath(__file__))
STARTS = 50                      # of each family, unless QUICK has more of it
SHAKES = 2
MORE_SHAKES = 12                 # of starts with an error above SUSPECT units, which few repetitions may have made small
SUSPECT = 32.0
MOST = 6                         # transitions that are followed
LONGEST = 100                    # steps of a series in a phase
KEPT = 15                        # starts of each family that the file keeps with their numbers
ULP = 2.0**-52
LIMIT = 64.0                     # units beyond which a number is listed
FINE = (220, 42, 1e-42)          # bits, order of the series, error of a step
COARSE = (220, 20, 1e-22)        # for repetitions, which need only a difference
NUMBERS = ("time", "theta", "theta_rate", "slip", "x")


class Tie(Exception):
    """Two events that 40 digits do not tell apart, or a state without a motion of its own."""


class Work:
    bits, order, error = FINE

    @classmethod
    def use(cls, setting):
        cls.bits, cls.order, cls.error = setting
        gmpy2.get_context().precision = cls.bits


class Hoop:
    """Mass, place of the mass centre and inertia about it, from the hoop and the particle."""

    def __init__(self, mass_ratio, offset, inertia, mu_s, mu_k):
        self.numbers = mass_ratio, offset, inertia, mu_s, mu_k
        m1, self.l, izz, self.mu_s, self.mu_k = map(mpfr, self.numbers)
        self.m = m1 + 1
        self.h = self.l / self.m
        self.i = izz + m1 * self.h**2 + (self.l - self.h)**2
        self.massless = mass_ratio == 0 and inertia == 0
        if self.massless:
            self.i = mpfr(0)


# ---------------------------------------------------------------- series


def conv(a, b, k):
    """Coefficient k of the product of two series."""
    return sum(map(mul, a[:k + 1], b[k::-1]))


def series(hoop, state, sigma):
    """Taylor series of theta, theta', eta', N and F from a state: rolling for sigma None, else sliding.

    Mass centre at (x - h sin theta, 1 + h cos theta); contact point from it at (h sin theta, -1 - h cos theta).
    m xG'' = F, m yG'' = N - m, I theta'' = h sin theta N + (1 + h cos theta) F.
    """
    m, h, i = hoop.m, hoop.h, hoop.i
    th, w, eta = [state[0]], [state[1]], [state[2]]
    sn, cs = gmpy2.sin_cos(state[0])
    s, c, a, u, n, f = [sn], [cs], [], [], [], []
    lever = [1 + h * cs]
    friction = None if sigma is None else -hoop.mu_k * sigma
    if sigma is not None:
        q = [h * sn + friction * lever[0]]
        weight = i + m * h * sn * q[0]
    else:
        weight = i + m * (h * sn)**2 + m * lever[0]**2
    for k in range(Work.order):
        u.append(conv(w, w, k))
        cu, su = conv(c, u, k), conv(s, u, k)
        sa, ca = (sum(map(mul, a, s[k:0:-1])), sum(map(mul, a, c[k:0:-1]))) if k else (0, 0)
        n0 = -m * h * (sa + cu) + (m if k == 0 else 0)
        f0 = -m * h * (ca - su)
        if sigma is None:
            low = h * sum(map(mul, s[1:], n[::-1])) + sum(map(mul, lever[1:], f[::-1])) if k else 0
            ak = (low + h * s[0] * n0 + lever[0] * f0) / weight
            nk = n0 - m * h * s[0] * ak
            f.append(f0 - m * lever[0] * ak)
            eta.append(mpfr(0))
        else:
            low = sum(map(mul, q[1:], n[::-1])) if k else 0
            ak = (low + q[0] * n0) / weight
            nk = n0 - m * h * s[0] * ak
            f.append(friction * nk)
            eta.append((ak + h * (ca + c[0] * ak - su) + f[k] / m) / (k + 1))
        a.append(ak)
        n.append(nk)
        th.append(w[k] / (k + 1))
        s.append(conv(w, c, k) / (k + 1))
        c.append(-conv(w, s, k) / (k + 1))
        w.append(ak / (k + 1))
        lever.append(h * c[k + 1])
        if sigma is not None:
            q.append(h * s[k + 1] + friction * lever[k + 1])
    return th, w, eta, n, f


def reach(parts):
    """Length of a step by the last two coefficients of each part."""
    length = 1e3
    for part in parts:
        allowed = math.log2(Work.error * max(1.0, abs(float(part[0]))))
        for k in (len(part) - 1, len(part) - 2):
            if part[k]:
                length = min(length, 2.0**((allowed - float(gmpy2.log2(abs(part[k])))) / k))
    return 0.9 * length


def value(p, t):
    v = mpfr(0)
    for coefficient in reversed(p):
        v = v * t + coefficient
    return v


def slope(p):
    return [k * coefficient for k, coefficient in enumerate(p)][1:]


def root(f, slope_of_f, low, high, sign):
    """Root of f between low and high, where sign*f goes from plus to minus: bisection, then Newton."""
    a, b = low, high
    for _ in range(40):
        t = (a + b) / 2
        if sign * f(t) > 0:
            a = t
        else:
            b = t
    t = (a + b) / 2
    for _ in range(8):
        step = f(t) / slope_of_f(t)
        near = t - step
        if not (low <= near <= high):
            break
        t = near
        if abs(step) < mpfr(10)**-40 * (abs(t) + mpfr(10)**-30):
            break
    else:
        return t
    for _ in range(2):
        t -= f(t) / slope_of_f(t)
    return t


def first_fall(f, df, low, high, parts=8):
    """First time in (low, high] at which f, positive behind low, falls through zero, extrema between points included."""
    width = high - low
    before = low
    slope_before = df(low)
    for k in range(1, parts + 1):
        t = high if k == parts else low + width * k / parts
        here, slope_here = f(t), df(t)
        if here <= 0:
            top = before
            if slope_before > 0:
                top = root(df, lambda x: (df(x + 1e-25) - df(x - 1e-25)) / 2e-25, before, t, 1)
            return root(f, df, top, t, 1)
        if slope_before < 0 < slope_here:
            a, b = before, t
            for _ in range(int(Work.bits * 0.9)):
                middle = (a + b) / 2
                if df(middle) < 0:
                    a = middle
                else:
                    b = middle
            lowest = f(a)
            if abs(lowest) < 1e-38:
                raise Tie("touches")
            if lowest < 0:
                return root(f, df, before, a, 1)
        before, slope_before = t, slope_here
    return None


def fall_of(p, length, known=0):
    """The same for a polynomial on (0, length], with `known` roots at 0 divided out."""
    p = p[known:]
    numbers = [abs(float(v)) for v in p]
    if p[0] > 0:
        total, power = 0.0, 1.0
        for v in numbers[1:]:
            power *= length
            total += v * power
        if numbers[0] > 1.001 * total:
            return None
    elif p[0] < 0:
        raise Tie("an event is over where its phase begins")
    d = slope(p)
    return first_fall(lambda t: value(p, t), lambda t: value(d, t), mpfr(0), mpfr(length))


# ---------------------------------------------------------------- phases


def rolling_forces(hoop, theta, rate):
    """(theta'', N, F) that rolling would need, by elimination."""
    s, c = gmpy2.sin_cos(theta)
    m, h, u, g = hoop.m, hoop.h, rate * rate, 1 + hoop.h * c
    n0, f0 = m - m * h * c * u, m * h * s * u
    a = (h * s * n0 + g * f0) / (hoop.i + m * (h * s)**2 + m * g * g)
    return a, n0 - m * h * s * a, f0 - m * g * a


def slide_acceleration(hoop, theta, rate, sigma):
    """(eta'', N, P) of a slide."""
    s, c = gmpy2.sin_cos(theta)
    m, h, u, g = hoop.m, hoop.h, rate * rate, 1 + hoop.h * c
    friction = -hoop.mu_k * sigma
    q = h * s + friction * g
    p = hoop.i + m * h * s * q
    a = q * (m - m * h * c * u) / p
    n = m - m * h * (s * a + c * u)
    return a + h * (c * a - s * u) + friction * n / m, n, p


def unloaded(hoop, theta, rate):
    """1 - h cos theta theta'^2: negative where free fall of the mass centre would lift the rim."""
    return 1 - hoop.h * gmpy2.cos(theta) * rate * rate


def at_rest(hoop, state):
    """(mode, direction) that follows at eta' = 0."""
    theta, rate = state[0], state[1]
    _, n, f = rolling_forces(hoop, theta, rate)
    margin = hoop.mu_s * n - abs(f)
    if min(abs(n), abs(margin)) < 1e-38:
        raise Tie("on the static limit")
    if n > 0 and margin > 0:
        return "rolling", 0
    if hoop.massless:
        return "gliding", None
    ways = []
    for sigma in (1, -1):
        acceleration, normal, p = slide_acceleration(hoop, theta, rate, sigma)
        if p <= 0:
            raise Tie("Painleve")
        if normal > 0 and sigma * acceleration > 0:
            ways.append(sigma)
    lifts = unloaded(hoop, theta, rate) < 0
    if len(ways) + lifts != 1:
        raise Tie("not one motion")
    return ("sliding", ways[0]) if ways else ("flight", 0)


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


def circle(th):
    """Series of sine and cosine."""
    s, c = ([v] for v in gmpy2.sin_cos(th[0]))
    rate = slope(th)
    for k in range(len(th) - 1):
        s.append(conv(rate, c, k) / (k + 1))
        c.append(-conv(rate, s, k) / (k + 1))
    return s, c


def arb(v):
    """An mpfr as an exact number of Arb."""
    mantissa, exponent = v.as_mantissa_exp() if v else (0, 0)
    return flint.arb(int(mantissa)) * flint.arb(2)**int(exponent)


def number(v):
    """The middle of a ball."""
    man, exp = v.mid().man_exp()
    return gmpy2.mul_2exp(mpfr(int(man)), int(exp)) if int(exp) >= 0 else gmpy2.div_2exp(mpfr(int(man)), -int(exp))


def all_roots(p):
    """Balls that hold the roots of a polynomial, one each."""
    for bits in (4 * Work.bits, 16 * Work.bits):
        flint.ctx.prec = bits
        try:
            return flint.acb_poly([arb(v) for v in p]).roots(tol=flint.arb(2)**(-Work.bits))
        except ValueError:
            pass
    raise Tie("a double root")


def glide(hoop, state, known, until):
    """A glide to its first event, as `smooth`; the direction is that of the glide itself."""
    theta, rate, slip, x = state
    l = hoop.l
    s, c = gmpy2.sin_cos(theta)
    if s == 0:
        raise Tie("at the top")
    side = 1 if s > 0 else -1
    vx = slip - rate * (1 + l * c)                                                # of the particle
    vy = -l * s * rate
    height = [l * c, vy, mpfr(-0.5)]                                              # l cos theta in the time
    times = []
    for level in (-l, l):
        half = vy * vy + 2 * (l * c - level)
        if half > 0:
            times += [v for v in (vy - gmpy2.sqrt(half), vy + gmpy2.sqrt(half)) if v > 0 and
                      (level < 0 or v == vy - gmpy2.sqrt(half))]
        if level > 0 and abs(half) < 1e-38:
            raise Tie("just reaches the top")
    end = min(times)
    at_top = vy > 0 and vy * vy + 2 * (l * c - l) > 0

    def multiply(p, q):
        out = [mpfr(0)] * (len(p) + len(q) - 1)
        for i, a in enumerate(p):
            for j, b in enumerate(q):
                out[i + j] += a * b
        return out

    # With y = l cos theta, (l sin theta)^2 = l^2 - y^2 and eta' l sin theta = vx l sin theta + (t - vy)(1 + y): where it
    # vanishes, vx^2 (l^2 - y^2) = (t - vy)^2 (1 + y)^2. On the rim both sides have the factor 1 + y.
    above, lever = [-v for v in height], [1 + height[0], height[1], height[2]]
    above[0] = l - l * c
    rim = l == 1
    arm = above if rim else multiply(above, [l + height[0], height[1], height[2]])
    drive = multiply([-vy, mpfr(1)], [-vy, mpfr(1)])
    sextic = [-v for v in multiply(drive, lever if rim else multiply(lever, lever))]
    for k, v in enumerate(arm):
        sextic[k] += vx * vx * v
    for _ in range(known):
        # At rest at the start, and so at the same height again: the roots 0 and 2 vy are divided out.
        sextic = sextic[1:]
        for k in range(len(sextic) - 2, -1, -1):
            sextic[k] += 2 * vy * sextic[k + 1]
        if abs(sextic[0]) > 1e-30 * max(map(abs, sextic)):
            raise AssertionError("not at rest at the start")
        sextic = sextic[1:]

    def position(t):
        y = value(height, t)
        sine = side * gmpy2.sqrt(l * l - y * y)                                   # l sin theta
        turn_rate = (t - vy) / sine
        turned = gmpy2.atan2(sine, y)
        return turned, turn_rate, vx + turn_rate * (1 + y), sine

    lap = gmpy2.rint((theta - gmpy2.atan2(s, c)) / (2 * gmpy2.const_pi()))
    turn = 2 * gmpy2.const_pi() * lap
    rests = [vy] if vx == 0 and 0 < vy < end else []                              # eta' = theta' (1 + l cos theta)
    for z in () if vx == 0 else all_roots(sextic):
        if not z.imag.contains(0):
            continue
        t = number(z.real)
        if 1e-40 < t < end - 1e-38 * (1 + end) and vx * side * (t - vy) < 0:
            rests.append(t)
    rests.sort()
    if any(b - a < 1e-30 for a, b in zip(rests, rests[1:])):
        raise Tie("touches")
    first = rests[0] if rests else None
    direction = 1 if position((first or end) / 2)[2] > 0 else -1
    mass_centre = x - l * s
    if first is not None and first < until:
        turned, turn_rate, _, sine = position(first)
        return "stick", first, (turn + turned, turn_rate, mpfr(0), mass_centre + vx * first + sine), direction
    if end >= until:
        turned, turn_rate, now, sine = position(mpfr(until))
        return None, mpfr(until), (turn + turned, turn_rate, now, mass_centre + vx * until + sine), direction
    place = mass_centre + vx * end
    infinite = mpfr("inf")
    if at_top:
        return "particle_at_top", end, (turn, -side * infinite, -side * infinite, place), direction
    return ("particle_at_plane" if rim else "particle_at_bottom", end,
            (turn + side * gmpy2.const_pi(), side * infinite, vx if rim else side * infinite, place), direction)


def flight(hoop, state, gap_rate, until):
    """A flight to the landing."""
    theta, rate, slip, x = state
    h = hoop.h
    s0, c0 = gmpy2.sin_cos(theta)
    up = gap_rate - h * s0 * rate                                                 # of the mass centre
    along = slip - rate - h * c0 * rate

    def gap(t):
        return up * t - t * t / 2 - h * (gmpy2.cos(theta + rate * t) - c0)

    def gap_slope(t):
        return up - t + h * rate * gmpy2.sin(theta + rate * t)

    quick = 0.1 / (1 + abs(rate))
    t, landing = quick * 2.0**-60, None
    limit = mpfr(until)
    if gap(mpfr(t)) <= 0:
        raise Tie("lands at once")
    while landing is None:
        further = mpfr(min(2 * t, t + quick))
        landing = first_fall(gap, gap_slope, mpfr(t), further, 1)
        t = further
        if landing is None and t > limit:
            break
    last = landing if landing is not None and landing <= limit else limit
    theta_last = theta + rate * last
    s, c = gmpy2.sin_cos(theta_last)
    mass_centre = x - h * s0 + along * last
    new = theta_last, rate, along + rate + h * c * rate, mass_centre + h * s
    return ("landing" if last is landing else None), last, new, 0


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


# ---------------------------------------------------------------- starts


def signed(dice, low, high):
    return dice.uniform(low, high) * dice.choice((-1, 1))


def beside(dice):
    """A distance of 1e-12 to 1e-4, to either side."""
    return 10.0**dice.uniform(-12, -4) * dice.choice((-1, 1))


def heavy(dice):
    """A hoop with inertia, without friction: thin, of any kind, light, or with the particle inside a light one."""
    kind = dice.randrange(5)
    m = dice.uniform(0.2, 4)
    if kind == 0:
        return m, 1.0, m
    if kind < 3:
        return m, dice.uniform(0.2, 1), dice.uniform(0.1, 3)
    light = 10.0**dice.uniform(-4, -1)
    return (0.0, 1.0, light) if kind == 3 else (light, dice.uniform(0.4, 1), light)


def massless(dice):
    return 0.0, dice.choice((1.0, dice.uniform(0.1, 1), 1 - 10.0**dice.uniform(-12, -2))), 0.0


def solvable(body, mu):
    """The largest of mu, mu/2, mu/4, ... with P > 0 at every angle."""
    while mu > 0:
        hoop = Hoop(*body, mu, mu)
        i, mh, h = float(hoop.i), float(hoop.m * hoop.h), float(hoop.h)
        angles = [math.pi * k / 200 for k in range(-200, 201)]
        if min(i + mh * math.sin(t) * (h * math.sin(t) - mu * w * (1 + h * math.cos(t)))
               for t in angles for w in (-1, 1)) > 0.05 * i:
            return mu
        mu /= 2
    return 0.0


def rolled(hoop, theta, rate, other):
    """Square of the rate at another angle of the same rolling orbit."""
    def weight(angle):
        return hoop.i + hoop.m * (1 + hoop.h**2 + 2 * hoop.h * gmpy2.cos(angle))
    return weight(theta) * (rate * rate + 1) / weight(other) - 1


def demand(hoop, theta, rate_squared):
    """|F|/N of rolling, and N."""
    _, n, f = rolling_forces(hoop, theta, gmpy2.sqrt(rate_squared))
    return abs(f) / n, n


def travel(hoop, theta, rate, other):
    """Rough time of rolling to another angle."""
    rates = [float(rolled(hoop, theta, rate, mpfr(theta + (other - theta) * (k + 0.5) / 100))) for k in range(100)]
    return abs(other - theta) / 100 * sum(max(v, 1e-4)**-0.5 for v in rates)


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
    tops = [k for k in range(2, len(values) - 1) if values[k][0] > max(values[k - 1][0], values[k + 1][0])
            and all(v[1] > 0 for v in values[:k + 2]) and values[k][0] > 1.001 * max(v[0] for v in values[:k - 1])]
    if not tops:
        return None
    k = dice.choice(tops)
    low, high = mpfr(path[k - 1]), mpfr(path[k + 1])
    golden = (gmpy2.sqrt(mpfr(5)) - 1) / 2

    def at(angle):
        return demand(hoop, angle, rolled(hoop, mpfr(theta), mpfr(rate), angle))[0]

    for _ in range(90):
        a, b = high - golden * (high - low), low + golden * (high - low)
        low, high = (low, b) if at(a) > at(b) else (a, high)
    mu_s = float(at(low)) * (1 + beside(dice))
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


def frictions(dice, body):
    mu_s = dice.uniform(0.05, 1.2)
    return mu_s, solvable(body, mu_s * dice.uniform(0.1, 0.95))


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
    """The slip velocity touches zero: there the friction demand is the coefficient of kinetic friction."""
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
        return (t * t / 2 + hoop.h * (gmpy2.cos(theta + rate * t) - gmpy2.cos(mpfr(theta)))) / t + hoop.h * rate * gmpy2.sin(mpfr(theta))

    times = [0.05 / abs(rate) * k for k in range(1, int(60 + 12 * h * rate * rate))][:900]
    values = [t / 2 + h * (math.cos(theta + rate * t) - math.cos(theta)) / t + h * rate * math.sin(theta) for t in times]
    tops = [k for k in range(1, len(values) - 1) if values[k] > values[k - 1] and values[k] > values[k + 1]
            and values[k] >= max(values[:k + 1]) and values[k] > 0.05]
    if not tops:
        return None
    k = dice.choice(tops[:4])
    low, high = mpfr(times[k - 1]), mpfr(times[k + 1])
    golden = (gmpy2.sqrt(mpfr(5)) - 1) / 2
    for _ in range(90):
        a, b = high - golden * (high - low), low + golden * (high - low)
        low, high = (low, b) if needed(a) > needed(b) else (a, high)
    v = float(needed(low)) * (1 + beside(dice))
    return (*body, 0.5, 0.4), (theta, rate, dice.uniform(-1, 1), v), 100.0


def start_beside_slip_curve(dice, body):
    hoop = Hoop(*body, 0, 0)
    theta, rate = dice.uniform(-3.0, 3.0), signed(dice, 0, 2.5)
    _, n, f = rolling_forces(hoop, mpfr(theta), mpfr(rate))
    if n <= 0.01:
        return None
    mu_s = float(abs(f) / n) * (1 + beside(dice))
    return (*body, mu_s, solvable(body, mu_s * dice.uniform(0.2, 0.95))), (theta, rate, 0.0, 0.0), 0.7


def start_beside_lift_off_curve(dice, body):
    numbers = (*body, *frictions(dice, body))
    theta = signed(dice, 0.02, 1.5)
    rate = float(1 / gmpy2.sqrt(Hoop(*numbers).h * gmpy2.cos(mpfr(theta)))) * (1 + beside(dice)) * dice.choice((-1, 1))
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


# massless


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
    rate = -math.copysign((2 / (body[1] * (1 + math.cos(theta))))**0.5, theta) * (1 + beside(dice))
    mu_s = dice.uniform(0.05, 3)
    return (*body, mu_s, mu_s * dice.random()), (theta, rate, dice.choice((0.0, dice.uniform(-3, 3))), 0.0), 8.0


def gliding_rest_at_turning_point(dice, body):
    theta = signed(dice, 0.2, 3.0)
    rate = -math.copysign(dice.uniform(0.05, 0.99) * (2 / (body[1] * (1 + math.cos(theta))))**0.5, theta)
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
        body = 0.0, 1 - 10.0**dice.uniform(-12, -2), 0.0
        theta, rate = signed(dice, 0.1, 3.1), signed(dice, 1, 1) * 10.0**dice.uniform(0, 3)
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
        rate = ((1 + l * math.cos(theta)) / (l * (l + math.cos(theta))))**0.5 * dice.choice((-1, 1)) * (1 + beside(dice))
    else:
        slip = beside(dice)
    return (*body, mu_s, mu_s * dice.random()), (theta, rate, slip, 0.0), 5.0


def inside(dice):
    return 0.0, dice.uniform(0.1, 0.95), 0.0


FAMILIES = {
    "grazing_slip": (heavy, grazing_slip),
    "turning_on_slip_curve": (heavy, turning_on_slip_curve),
    "stick_at_lift_off": (heavy, stick_at_lift_off),
    "reversal_or_stick": (heavy, reversal_or_stick),
    "slip_that_touches_rest": (heavy, slip_that_touches_rest),
    "normal_force_that_touches_zero": (heavy, normal_force_that_touches_zero),
    "landing_that_grazes": (heavy, landing_that_grazes),
    "start_beside_slip_curve": (heavy, start_beside_slip_curve),
    "start_beside_lift_off_curve": (heavy, start_beside_lift_off_curve),
    "start_beside_vanishing_normal_force": (heavy, start_beside_vanishing_normal_force),
    "start_with_hardly_any_slip": (heavy, start_with_hardly_any_slip),
    "massless_type_ii": (massless, type_ii),
    "massless_type_ii_on_the_rim": (lambda dice: (0.0, 1.0, 0.0), type_ii),
    "gliding_rest_on_slip_curve": (massless, gliding_rest_on_slip_curve),
    "gliding_slip_that_touches_rest": (massless, gliding_slip_that_touches_rest),
    "particle_that_just_reaches_the_top": (massless, particle_that_just_reaches_the_top),
    "gliding_rest_at_turning_point": (massless, gliding_rest_at_turning_point),
    "gliding_rest_at_the_bottom": (massless, gliding_rest_at_the_bottom),
    "massless_start_beside_a_curve": (massless, massless_start_beside_a_curve),
    "massless_grazing_slip": (inside, grazing_slip),
    "massless_turning_on_slip_curve": (inside, turning_on_slip_curve),
}

# Other numbers of starts: closed forms and short series need little time.
QUICK = {
    "massless_type_ii": 2000,
    "massless_type_ii_on_the_rim": 2000,
    "gliding_rest_on_slip_curve": 4300,
    "particle_that_just_reaches_the_top": 600,
    "gliding_rest_at_turning_point": 300,
    "gliding_slip_that_touches_rest": 100,
    "massless_start_beside_a_curve": 100,
    "gliding_rest_at_the_bottom": 100,
    # Few of the orbits that are drawn have such a point.
    "massless_grazing_slip": 10,
    "massless_turning_on_slip_curve": 10,
}


# ---------------------------------------------------------------- comparison


def kind_of(motion):
    """What has to agree to the letter."""
    first, transitions, ended, _ = motion
    return first, tuple((t["cause"], t["to"], t["direction"]) for t in transitions), ended


def one(task):
    """A start of a family, its motion, and repetitions of it."""
    family, index = task
    make_hoop, make = FAMILIES[family]
    dice = random.Random(f"{family} {index}")
    for _ in range(400):
        Work.use(FINE)
        made = make(dice, make_hoop(dice))
        if not made or not all(map(math.isfinite, made[0] + made[1])):
            continue
        numbers, start, until = made
        try:
            motion = follow(numbers, start, until)
        except Tie:
            continue
        return family, index, numbers, start, until, motion, shaken(dice, numbers, start, until, SHAKES)
    raise AssertionError(f"no start of {family}")


def shaken(dice, numbers, start, until, count):
    """Repetitions in which every number is changed by 2^-52 of itself, up or down."""
    Work.use(COARSE)
    motions = []
    for _ in range(count):
        try:
            motions.append(follow(numbers, start, until, lambda: 1 + dice.choice((-1, 1)) * mpfr(ULP)))
        except Tie:
            motions.append(None)
    return motions


def closer(result):
    """The same start with more repetitions."""
    family, index, numbers, start, until, motion, few = result
    dice = random.Random(f"{family} {index} closer")
    return *result[:6], few + shaken(dice, numbers, start, until, MORE_SHAKES)


def units(motion, shaken):
    """Of every number of every transition and of the end."""
    def rows(of):
        return of[1] + ([of[3]] if of[3] else [])
    out = []
    for k, row in enumerate(rows(motion)):
        unit = {}
        for name in NUMBERS:
            exact = row[name]
            spread = [abs(rows(other)[k][name] - exact) for other in shaken] if gmpy2.is_finite(exact) else []
            # A place is that of a body of radius 1.
            size = max(abs(exact), mpfr(1)) if name == "x" else abs(exact)
            unit[name] = float(max([mpfr(ULP) * size] + spread)) if spread else 0.0
        out.append(unit)
    return out


def parsed(line):
    """The library's answer, in the form of `follow`."""
    parts = [part.split() for part in line.split(" | ")]
    transitions = [dict(cause=p[0], to=p[1], direction=int(p[2]), **dict(zip(NUMBERS, map(float, p[3:])))) for p in parts[1:-1]]
    end = dict(zip(NUMBERS, map(float, parts[-1][1:])))
    return (parts[0][0], int(parts[0][1])), transitions, parts[-1][0], end


def library(tasks):
    """Answers of the library to starts."""
    cargo = ["cargo", "run", "--release", "--quiet", "--locked", "-p", "littlewood", "--example", "transitions"]
    lines = "".join(" ".join(map(repr, numbers + start + (until,))) + "\n" for numbers, start, until in tasks)
    run = subprocess.run(cargo, input=lines, capture_output=True, text=True, check=False, cwd=HERE)
    if run.returncode:
        sys.exit(run.stderr)
    return [parsed(line) for line in run.stdout.splitlines()]


def same_kind(answer, motion):
    """Whether the library tells of the same events."""
    first, transitions, ended, end = motion
    theirs = answer[1]
    if ended == "more":
        theirs = theirs[:MOST]
    if kind_of((first, transitions, None, None)) != kind_of((answer[0], theirs, None, None)):
        return False
    mode = transitions[-1]["to"] if transitions else first[0]
    if ended in ("rolling", "sliding", "gliding", "flight"):
        return answer[2] == "time_limit" or (answer[2] == "rolls_forever" and mode == "rolling")
    return ended == "more" or answer[2] == ended


def errors(answer, motion, unit):
    """(error in units, number, place) of every number."""
    _, transitions, ended, end = motion
    pairs = list(zip(answer[1], transitions, unit))
    if end and answer[2] == "time_limit":
        pairs.append((answer[3], end, unit[-1]))
    for place, (ours, exact, scale) in enumerate(pairs):
        for name in NUMBERS:
            mine, right = ours[name], exact[name]
            if not gmpy2.is_finite(right):
                yield (0.0 if mine == right else math.inf), name, place
            elif scale[name]:
                yield abs(float(mpfr(mine) - right)) / scale[name], name, place
            else:
                yield (0.0 if mine == right else math.inf), name, place


class Compared:
    """A start, its motion, and how the library's answer compares."""

    def __init__(self, result, answer):
        self.family, self.index, self.numbers, self.start, self.until, self.motion, shakes = result
        self.answer = answer
        self.same = same_kind(answer, self.motion)
        alike = [v for v in shakes if v and kind_of(v) == kind_of(self.motion)]
        self.decided = len(alike) == len(shakes)
        self.possible = self.same or any(v and same_kind(answer, v) for v in shakes)
        self.units = units(self.motion, alike) if self.decided else None
        self.errors = list(errors(answer, self.motion, self.units)) if self.same and self.decided else []
        self.worst = max(self.errors, default=(0.0, "", 0))

    def described(self):
        return dict(family=self.family, index=self.index, hoop=self.numbers, start=self.start, until=self.until)

    def kept(self):
        """The start, and what the library has to say of it, with the unit of each number."""
        first, transitions, ended, _ = self.motion
        return dict(self.described(), first=first, outcome=ended, transitions=[
            dict(cause=t["cause"], to=t["to"], direction=t["direction"],
                 **{n: [f"{t[n]:.20e}" if gmpy2.is_finite(t[n]) else str(float(t[n])), rounded(u[n])] for n in NUMBERS})
            for t, u in zip(transitions, self.units)])


def report(compared):
    """What the file has of each family, what disagrees, and the starts that it keeps."""
    families, different, kept = {}, [], []
    for name in dict.fromkeys(c.family for c in compared):
        mine = [c for c in compared if c.family == name]
        worst = max(mine, key=lambda c: c.worst[0])
        every = sorted(e for c in mine for e, _, _ in c.errors)
        families[name] = dict(
            starts=len(mine), transitions=sum(len(c.motion[1]) for c in mine), undecided=sum(not c.decided for c in mine),
            another_sequence_of_an_undecided_start=sum(c.possible and not c.same for c in mine), numbers=len(every),
            median=rounded(every[len(every) // 2]) if every else None, above_8=sum(e > 8 for e in every),
            largest=rounded(worst.worst[0]), largest_at=dict(worst.described(), number=worst.worst[1], transition=worst.worst[2]))
        for c in mine:
            if not c.possible:
                different.append(dict(c.described(), kind="sequence", library=listed(c.answer), exact=listed(c.motion)))
            elif c.worst[0] > LIMIT:
                different.append(dict(c.described(), kind="number", number=c.worst[1], transition=c.worst[2], units=rounded(c.worst[0])))
        kept += [c.kept() for c in mine if c.errors and c.motion[1]][:KEPT]
    return families, different, kept


def rounded(v):
    return float(f"{v:.3g}")


def listed(motion):
    """A motion in words."""
    return [f"{motion[0][0]} {motion[0][1]}"] + [
        f"{t['cause']} {t['to']} {t['direction']} {float(t['time'])!r}" for t in motion[1]] + [str(motion[2])]


def remembered(path):
    """The motions of an earlier run."""
    if not path or not os.path.exists(path):
        return {}
    with open(path, "rb") as file:
        return pickle.load(file)


def write(starts, families, different, kept):
    """The file, with a line for each start that it keeps."""
    top = dict(made_by="coincidences.py", starts=starts, limit=LIMIT, families=families, disagreements=different)
    with open(os.path.join(HERE, "coincidences.json"), "w", encoding="ascii") as file:
        file.write(json.dumps(top, indent=1)[:-2] + ',\n "kept": [\n')
        file.write(",\n".join("  " + json.dumps(item, separators=(",", ":")) for item in kept) + "\n ]\n}\n")


def main():
    options = argparse.ArgumentParser()
    options.add_argument("family", nargs="?", choices=FAMILIES)
    options.add_argument("--starts", type=int)
    options.add_argument("--workers", type=int, default=os.cpu_count())
    options.add_argument("--motions", metavar="FILE", help="keep the motions in a file, or take them from there")
    options = options.parse_args()
    names = [options.family] if options.family else list(FAMILIES)
    tasks = [(name, index) for name in names for index in range(options.starts or QUICK.get(name, STARTS))]
    began = time.time()
    gc.disable()
    with multiprocessing.Pool(options.workers, maxtasksperchild=500) as pool:
        results = remembered(options.motions)
        for name in sorted(names, key=lambda name: QUICK.get(name, STARTS)):
            todo = [task for task in tasks if task[0] == name and task not in results]
            results.update(((r[0], r[1]), r) for r in pool.map(one, todo, chunksize=4))
            if options.motions and todo:
                with open(options.motions, "wb") as file:
                    pickle.dump(results, file)
        results = [results[task] for task in tasks]
        Work.use(FINE)
        answers = library([(r[2], r[3], r[4]) for r in results])
        compared = [Compared(*pair) for pair in zip(results, answers)]
        suspect = [k for k, c in enumerate(compared) if c.worst[0] > SUSPECT or not c.possible]
        for k, result in zip(suspect, pool.map(closer, [results[k] for k in suspect], chunksize=1)):
            compared[k] = Compared(result, answers[k])
    families, different, kept = report(compared)
    for name, row in families.items():
        print(f"{name:38s}", {k: v for k, v in row.items() if k != "largest_at"})
        print(" " * 38, row["largest_at"])
    for item in different:
        print(item)
    print(f"{len(results)} starts, {len(different)} disagreements, {time.time() - began:.0f} s")
    if not (options.family or options.starts):
        write(len(results), families, different, kept)


if __name__ == "__main__":
    main()
