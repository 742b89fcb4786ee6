"""The end of bouncing: an enclosure of what infinitely many bounces still do.

While the angle stays within δθ and θ′ within δω of what they are after a bounce, the rim is pulled
back with an acceleration between W1 and W2 > 0. A flight that begins with the rate v then takes
from 2v/W2 to 2v/W1 and comes back with from v √(W1/W2) to v √(W2/W1), and an impact makes of a rate
V at most e V. So rates fall at least like qⁿ, q = e √(W2/W1); if q < 1 all sums are bounded by
geometric ones. If the sums stay within δθ and δω, the assumption holds for ever (induction over the
bounces).

That an impact makes at most e V of V: for a contact that slips throughout it is the law. For one
that sticks, the slip of the flight before has the sign of −h sin θ θ′², hence σB < 0 and k1 = C +
μk|B| > C ≥ k2, from which it follows for each of the three laws.

With e = 1 it is friction that takes: an impact that ends the slip of its flight, as the contact
sticks, makes of the rate V and the slip −h sin θ θ′² T, both proportional to v, a rate that is
proportional to v, too. The impact for v = 1, with balls for V and T, has that factor for q.

With rolling resistance the sign of θ′ must stay, and k1 > k2 is a condition; where θ′ is held at 0,
rates fall by e exactly.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from .balls import Ball, arb, flint, sign
from .body import Body, State
from .impact import impact


@dataclass(frozen=True)
class Rest:
    """What remains: the state at the end, and bounds of the impulses."""

    end: State
    normal: Ball
    friction: Ball
    sticks: bool


def rest_of_bounces(body: Body, start: State, restitution: Ball, law: str) -> Rest | None:
    """Enclose the end of the bounces that begin with this flight.

    None where they are not seen to come to one.

    Bounces are followed one by one down to a gap rate of 2⁻¹³⁶, and less with more than 144 bits.
    """
    if not start.gap_rate < arb(2) ** -(100 + flint.ctx.prec // 4):
        return None
    if body.resists and start.rate.is_zero():
        return _held(body, start, restitution)
    v = start.gap_rate.upper()
    spread = v * 2**16
    for _ in range(40):
        found = (
            _turning(body, start, restitution, v, spread)
            if body.resists
            else _within(body, start, restitution, law, v, spread)
        )
        if found is not None:
            return found
        spread = spread * 4
    return None


def _within(body: Body, start: State, e: Ball, law: str, v: Ball, spread: Ball) -> Rest | None:
    theta = start.theta + arb(0, 1) * spread
    rate = start.rate + arb(0, 1) * spread
    pull = body.contact(theta, rate)
    if not pull > 0:
        return None
    least, largest = pull.lower(), pull.upper()
    uneven = (largest / least).sqrt()
    ratio = (e * uneven).upper()
    if not ratio < 1 and start.slip.is_zero():
        slips = -body.h * theta.sin() * rate * rate * (2 / largest).union(2 / least)
        landing = replace(
            start, theta=theta, rate=rate, slip=slips, gap_rate=-(1 / uneven).union(uneven)
        )
        ratio = impact(body, landing, e, law).after.gap_rate.upper()
    if not ratio < 1:
        return None
    a, b, c = body.compliance(theta)
    time = (2 * v / (least * (1 - ratio))).upper()
    closing = (v * uneven / (1 - ratio)).upper()
    drift = (body.h * theta.sin() * rate * rate).abs_upper()
    if start.slip.is_zero():
        k2 = c - b * b / a
        sides = theta.sin()
        if not (sides > 0 or sides < 0) or not abs(b) < body.mu_s * a:
            return None
        k1 = c + body.mu_k * abs(b)
        slip = drift * 2 * v / least
        back = v * (least / largest).sqrt()
        if not slip * k1 < (1 + e) * back * (body.mu_k * a + abs(b)):
            return None
        normal = ((1 + e) * closing / k2).upper()
        friction = (body.mu_s * normal).upper()
        end_slip = arb(0)
    else:
        if not (start.slip > 0 or start.slip < 0):
            return None
        sigma = 1 if start.slip > 0 else -1
        k1 = c - body.mu_k * sigma * b
        if not k1 > 0:
            return None
        normal = ((1 + e) * closing / k1).upper()
        friction = (body.mu_k * normal).upper()
        change = (a * friction + abs(b) * normal + drift * time).upper()
        # No slip ends within an impact: |u|/(μk A − σ B) exceeds all impulses together.
        if not abs(start.slip) - change > (body.mu_k * a - sigma * b) * normal:
            return None
        end_slip = start.slip + arb(0, 1) * change
    turn = (rate.abs_upper() * time).upper()
    spin = ((body.h * normal + (1 + body.h) * friction) / body.inertia).upper()
    if not (turn < spread and spin < spread):
        return None
    one = arb(0, 1)
    speed = (
        rate.abs_upper() + abs(start.slip).upper() + drift * time + (a * friction + abs(b) * normal)
    ).upper()
    end = replace(
        start,
        time=start.time + time / 2 + one * time / 2,
        theta=start.theta + one * turn,
        rate=start.rate + one * spin,
        slip=end_slip,
        x=start.x + one * speed * time,
        gap=arb(0),
        gap_rate=arb(0),
    )
    return Rest(end, normal / 2 + one * normal / 2, one * friction, start.slip.is_zero())


def _held(body: Body, start: State, e: Ball) -> Rest | None:
    """Enclose bounces without rotation, which rolling resistance holds: a geometric series.

    In the air nothing turns, so that rates fall by e, and each impact has the impulse m (1 + e) v.
    """
    sigma = sign(start.slip, "the slip velocity of bounces")
    couple = abs(body.q(start.theta.sin(), start.theta.cos(), sigma))
    if not (e < 1 and couple < body.chi):
        return None
    v = start.gap_rate
    time = 2 * v / (body.down * (1 - e))
    normal = body.mass * (1 + e) * v / (1 - e)
    friction = -body.mu_k * sigma * normal
    slip = start.slip
    if sigma:
        slip = slip + friction / body.mass
        if not slip * sigma > 0:
            return None
    far = arb(0, 1) * (abs(start.slip) * time).upper()
    end = replace(
        start,
        time=start.time + time,
        slip=slip,
        x=start.x + far,
        gap=arb(0),
        gap_rate=arb(0),
    )
    return Rest(end, normal, friction, sigma == 0)


def _turning(body: Body, start: State, e: Ball, v: Ball, spread: Ball) -> Rest | None:
    """Enclose bounces with rolling resistance while θ′ keeps its sign, as without it."""
    one, m, chi = arb(0, 1), body.mass, body.chi
    theta, rate = start.theta + one * spread, start.rate + one * spread
    pull = body.contact(theta, rate)
    if not (pull > 0 and (rate > 0 or rate < 0)):
        return None
    least, largest = pull.lower(), pull.upper()
    ratio = (e * (largest / least).sqrt()).upper()
    if not ratio < 1:
        return None
    rotation = 1 if rate > 0 else -1
    sin, cos = theta.sin(), theta.cos()
    arm, lever = body.h * sin, 1 + body.h * cos
    drift = (arm * rate * rate).abs_upper()
    time = (2 * v / (least * (1 - ratio))).upper()
    closing = (v * (largest / least).sqrt() / (1 - ratio)).upper()
    sticks = start.slip.is_zero()
    if sticks and not (arm > 0 or arm < 0):
        return None
    # A flight slips against the arm.
    sigma = (-1 if arm > 0 else 1) if sticks else sign(start.slip, "the slip velocity of bounces")
    q = body.q(sin, cos, sigma, rotation)
    press = k1 = 1 / m + arm * q / body.inertia
    hold = body.mu_k
    if sticks:
        j = body.inertia + m * lever * lever
        press = 1 / m + arm * (arm - chi * rotation) / j
        hold = body.mu_s
        slowing = body.mu_k / m - sigma * lever * q / body.inertia
        back = v * (least / largest).sqrt()
        if not (
            abs(m * lever * (arm - chi * rotation)) < body.mu_s * j
            and k1 > press
            and slowing > 0
            and drift * 2 * v / least * k1 < (1 + e) * back * slowing
        ):
            return None
    if not press > 0:
        return None
    normal = ((1 + e) * closing / press).upper()
    friction = (hold * normal).upper()
    spin = ((abs(arm) * normal + abs(lever) * friction + chi * normal) / body.inertia).upper()
    turn = (rate.abs_upper() * time).upper()
    change = (friction / m + abs(lever) * spin + drift * time).upper()
    if not (turn < spread and spin < spread and (sticks or abs(start.slip) > change)):
        return None
    speed = (rate.abs_upper() + abs(start.slip).upper() + change).upper()
    end = replace(
        start,
        time=start.time + time / 2 + one * time / 2,
        theta=start.theta + one * turn,
        rate=start.rate + one * spin,
        slip=arb(0) if sticks else start.slip + one * change,
        x=start.x + one * speed * time,
        gap=arb(0),
        gap_rate=arb(0),
    )
    return Rest(end, normal / 2 + one * normal / 2, one * friction, sticks)
