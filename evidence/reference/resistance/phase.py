"""A phase in contact, by Taylor series of the balances, to its first event."""

from operator import mul
from typing import NamedTuple

import gmpy2
from follower.arithmetic import Tie, Work
from follower.roots import fall_of
from follower.series import conv, reach, value
from gmpy2 import mpfr

from .balances import TIE, State, balances, inverse

SHORTEST = 1e-9  # step below which a phase runs into a singularity
SHORTEST_GLIDE = 1e-3  # the same of a glide, which ends with the particle above or below the centre


class Series(NamedTuple):
    """Series in the time of a mode from a state, and of the powers lost in it."""

    theta: list
    rate: list
    slip: list
    normal: list
    friction: list
    couple: list
    resisted: list
    slid: list


class Event(NamedTuple):
    """What ends a phase, or a step of one: its cause, None at the end of a step."""

    cause: str | None
    time: mpfr
    slips: int = 0  # the way in which a slip begins


class Piece(NamedTuple):
    """A step of a phase."""

    start: mpfr
    x: mpfr
    series: Series


def later(a, b, k):
    """Coefficient k of a product, without the newest coefficient of its first factor."""
    return sum(map(mul, a[:k], b[k:0:-1])) if k else mpfr(0)


def integral(p):
    return [mpfr(0)] + [v / (k + 1) for k, v in enumerate(p)]


def series(body, mode, state):
    """The balances, solved order by order: what is known of an order is on the right."""
    m, h = body.m, body.h
    sine, cosine = gmpy2.sin_cos(state.theta)
    solve = inverse(balances(body, mode, sine, cosine))
    theta, rate, slip = [state.theta], [state.rate], [state.slip]
    s, c, u, turn, normal, friction, couple = [sine], [cosine], [], [], [], [], []
    for k in range(Work.order):
        u.append(conv(rate, rate, k))
        level = -m * h * (conv(s, u, k) - later(turn, c, k))
        up = m * h * (conv(c, u, k) + later(turn, s, k))
        moment = h * (later(normal, s, k) + later(friction, c, k))
        if k == 0:
            level, up = level - m * body.along, up - m * body.down
        along_k, turn_k, normal_k, friction_k, couple_k = (
            row[0] * level + row[1] * up + row[2] * moment for row in solve
        )
        turn_k = mpfr(0) if mode.turns == 0 else turn_k
        turn.append(turn_k)
        normal.append(normal_k)
        friction.append(friction_k)
        couple.append(couple_k)
        theta.append(rate[k] / (k + 1))
        s.append(conv(rate, c, k) / (k + 1))
        c.append(-conv(rate, s, k) / (k + 1))
        rate.append(turn_k / (k + 1))
        slip.append(mpfr(0) if mode.slips == 0 else (along_k + turn_k) / (k + 1))
    lost = [mode.turns * body.chi * v for v in normal]
    slid = [mode.slips * body.mu_k * v for v in normal]
    return Series(
        theta,
        rate,
        slip,
        normal,
        friction,
        couple,
        integral([conv(lost, rate, k) for k in range(Work.order)]),
        integral([conv(slid, slip, k) for k in range(Work.order)]),
    )


def roots_at_start(p):
    """How many roots a velocity that begins at rest has there: one, or two if it begins flat."""
    return 0 if p[0] else 1 if abs(p[1]) > TIE else 2


def events(body, mode, parts, length):
    """(time, cause, way of a slip) of each event of a step."""
    found = []
    if mode.slips:
        slip = [mode.slips * v for v in parts.slip]
        found.append((fall_of(slip, length, roots_at_start(slip)), "stick", 0))
        if mode.name == "sliding":
            found.append((fall_of(parts.normal, length), "lift_off", 0))
    elif mode.turns and body.massless:
        # F/N is a function of the angle by the balance of moments alone, and vanishes with neither.
        found.append((fall_of(parts.normal, length), "normal_force_zero", 0))
        for way in (1, -1):
            found.append((fall_of(cone(body, mode, parts, way), length), "slip", way))
    elif mode.turns:
        for way in (1, -1):
            margin = [body.mu_s * n + way * f for n, f in zip(parts.normal, parts.friction)]
            found.append((fall_of(margin, length), "slip", way))
    if mode.turns and body.chi:
        rate = [mode.turns * v for v in parts.rate]
        found.append((fall_of(rate, length, roots_at_start(rate)), "turning", 0))
    return found


def cone(body, mode, parts, way):
    """mu_s + way F/N of a massless hoop that rolls, times its lever.

    By h s N + (1 + h c) F = -K = chi sign(theta') N.
    """
    sine, cosine = ([v] for v in gmpy2.sin_cos(parts.theta[0]))
    for k in range(Work.order - 1):
        sine.append(conv(parts.rate, cosine, k) / (k + 1))
        cosine.append(-conv(parts.rate, sine, k) / (k + 1))
    lever = [body.h * v for v in cosine]
    lever[0] += 1
    moment = [-body.h * v for v in sine]
    moment[0] += body.chi * mode.turns
    return [body.mu_s * a + way * b for a, b in zip(lever, moment)]


def first(found, length, left):
    """The first event of a step, the end of the time that is left, or the end of the step."""
    found = sorted(one for one in found if one[0] is not None and one[0] <= left)
    if len(found) > 1 and found[1][0] - found[0][0] < TIE:
        raise Tie("two events at once")
    if found:
        time, cause, way = found[0]
        return Event(cause, time, way)
    return Event("limit", left) if left <= length else Event(None, mpfr(length))


def state_at(piece, time):
    """The state at a time of a piece."""
    parts, passed = piece.series, time - piece.start
    theta = value(parts.theta, passed)
    x = piece.x + value(integral(parts.slip), passed) - (theta - parts.theta[0])
    return State(theta, value(parts.rate, passed), value(parts.slip, passed), x)


def phase(body, mode, state, begin, until):
    """A phase from a time: (event with its time, state there, pieces); rests go to the limit."""
    pieces, now = [], begin
    for _ in range(Work.steps):
        parts = series(body, mode, state)
        left = until - now
        length = reach(parts[:6])
        if length < (SHORTEST_GLIDE if mode.name == "gliding" else SHORTEST):
            raise Tie("singular")
        length = min(mpfr(length), left)
        event = first(events(body, mode, parts, length), length, left)
        piece = Piece(now, state.x, parts)
        pieces.append(piece)
        now += event.time
        state = state_at(piece, now)
        if event.cause in ("stick", "lift_off", "turning", "slip", "normal_force_zero", "limit"):
            if event.cause == "stick":
                state = state._replace(slip=mpfr(0))
            elif event.cause == "turning":
                state = state._replace(rate=mpfr(0))
            return event._replace(time=now), state, pieces
    raise Tie("too many steps")
