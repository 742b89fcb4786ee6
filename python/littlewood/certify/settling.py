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
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from .balls import Ball, arb, flint
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
    v = start.gap_rate.upper()
    spread = v * 2**16
    for _ in range(40):
        found = _within(body, start, restitution, law, v, spread)
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
