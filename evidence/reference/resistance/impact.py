"""An impact in the normal impulse: at most as many segments as changes of slip and spin."""

import itertools
from typing import NamedTuple

import gmpy2
from follower.arithmetic import Tie
from gmpy2 import mpfr

from .balances import TIE, contact_mode
from .choice import begins, holds_at_zero, signs, stays


class Velocities(NamedTuple):
    """What an impact changes."""

    rate: mpfr
    slip: mpfr
    opening: mpfr  # rate of the gap


class Rates(NamedTuple):
    """Changes by a unit of normal impulse, and the friction and the couple that go with it."""

    rate: mpfr
    slip: mpfr
    opening: mpfr
    friction: mpfr
    couple: mpfr


class Impact(NamedTuple):
    """Velocities after an impact, its segments, and the energy that goes to each of its causes."""

    after: Velocities
    segments: list
    resistance: mpfr
    sliding: mpfr
    restitution: mpfr


def rates(body, theta, mode):
    """Rates of a segment: an impulse acts at the contact point, a couple beside it."""
    s, c = gmpy2.sin_cos(theta)
    arm, lever = body.h * s, 1 + body.h * c

    def change(friction, couple):
        spin = (arm + lever * friction + couple) / body.i
        return spin, friction / body.m + lever * spin, 1 / body.m + arm * spin

    # Both responses are linear: what keeps the spin, the slip, or both at zero follows from three
    # trials.
    free, pushed, turned = (
        change(mpfr(0), mpfr(0)),
        change(mpfr(1), mpfr(0)),
        change(mpfr(0), mpfr(1)),
    )
    friction, couple = -body.mu_k * mode.slips, -body.chi * mode.turns
    by_friction = [b - a for a, b in zip(free, pushed)]
    by_couple = [b - a for a, b in zip(free, turned)]
    if mode.slips == 0 and mode.turns == 0:
        determinant = by_friction[0] * by_couple[1] - by_friction[1] * by_couple[0]
        friction = (free[1] * by_couple[0] - free[0] * by_couple[1]) / determinant
        couple = (free[0] * by_friction[1] - free[1] * by_friction[0]) / determinant
    elif mode.slips == 0:
        friction = -(free[1] + couple * by_couple[1]) / by_friction[1]
    elif mode.turns == 0:
        couple = -(free[0] + friction * by_friction[0]) / by_couple[0]
    spin, slip, opening = change(friction, couple)
    return Rates(
        mpfr(0) if mode.turns == 0 else spin,
        mpfr(0) if mode.slips == 0 else slip,
        opening,
        friction,
        couple,
    )


def segment(body, theta, now):
    """The segment that follows, and its rates: each is tried; what rests does so while it can."""
    found = []
    for slips, turns in itertools.product(signs(now.slip), signs(now.rate)):
        mode = contact_mode(slips, turns)
        change = rates(body, theta, mode)
        if mode.slips == 0:
            if not holds_at_zero(change.friction, body.mu_s):
                continue
        elif not now.slip and not begins(mode.slips, change.slip):
            continue
        if mode.turns == 0:
            if not holds_at_zero(change.couple, body.chi):
                continue
        elif not now.rate and not begins(mode.turns, change.rate):
            continue
        found.append((mode, change))
    found = [one for one in found if not any(stays(other[0], one[0]) for other in found)]
    if len(found) != 1:
        raise Tie(f"an impact with {len(found)} segments to choose from")
    return found[0]


def impact(body, theta, before, restitution, law):
    """An impact from its velocities before it; with the rate zero of the gap, a jam."""
    now, closing = before, -before.opening
    taken = given = total = resistance = sliding = normal = mpfr(0)
    compressed, segments = None, []
    while True:
        mode, change = segment(body, theta, now)
        if [mode.slips, mode.turns] not in segments[-1:]:
            segments.append([mode.slips, mode.turns])
        ahead = []
        if now.slip and change.slip * mode.slips < 0:
            ahead.append((-now.slip / change.slip, "slip ends"))
        if now.rate and body.chi and change.rate * mode.turns < 0:
            ahead.append((-now.rate / change.rate, "spin ends"))
        if compressed is None:
            if change.opening > 0:
                ahead.append((-now.opening / change.opening, "compressed"))
        elif law == "poisson":
            ahead.append(((1 + restitution) * compressed - total, "end"))
        elif law == "newton":
            ahead.append(((restitution * closing - now.opening) / change.opening, "end"))
        else:
            # work given back: opening p + opening' p^2/2 = e^2 taken
            left = restitution * restitution * taken - given
            square = now.opening * now.opening + 2 * change.opening * left
            ahead.append(((gmpy2.sqrt(square) - now.opening) / change.opening, "end"))
        ahead.sort()
        if not ahead or ahead[0][0] < 0:
            raise Tie("an impact without end")
        step, event = ahead[0]
        if step and len(ahead) > 1 and ahead[1][0] - step < TIE and ahead[1][1] != "end":
            raise Tie("two events of an impact at once")
        after = Velocities(*(v + step * r for v, r in zip(now, change)))
        work = step * (now.opening + after.opening) / 2
        resistance += body.chi * abs(now.rate + after.rate) / 2 * step
        sliding += body.mu_k * abs(now.slip + after.slip) / 2 * step
        normal -= work
        taken, given = (taken - work, given) if compressed is None else (taken, given + work)
        total += step
        now = after
        if event == "slip ends":
            now = now._replace(slip=mpfr(0))
        elif event == "spin ends":
            now = now._replace(rate=mpfr(0))
        elif event == "compressed":
            now, compressed = now._replace(opening=mpfr(0)), total
        else:
            if restitution == 0:
                now = now._replace(opening=mpfr(0))
            return Impact(now, segments, resistance, sliding, normal)
