"""The end of bouncing: an enclosure of what infinitely many bounces still do.

While the angle stays within δθ and θ′ within δω of what they are after a bounce, the rim is pulled
back with an acceleration between W1 and W2 > 0. A flight that begins with the rate v then takes
from 2v/W2 to 2v/W1 and comes back with from v √(W1/W2) to v √(W2/W1), and an impact makes of a rate
V at most e V. So rates fall at least like qⁿ, q = e √(W2/W1); if q < 1 all sums are bounded by
geometric ones. If the sums stay within δθ and δω, the assumption holds for ever (induction over the
bounces).

That an impact makes at most e V of V: for a contact that slips throughout it is the law. For one
that sticks it follows for each of the three laws from k1 > k2, the slopes of the gap rate before
and after the slip has ended. On a level plane without rolling resistance that is so: the slip of
the flight before has the sign of −h sin θ θ′², hence σB < 0 and k1 = C + μk|B| > C ≥ k2.

Where e V does not suffice, with e = 1 or with k1 ≤ k2, the impact itself has q: one that ends the
slip of its flight, as the contact sticks, makes of the rate V and the slip −(h sin θ θ′² + sin α)
T, both proportional to v, a rate that is proportional to v, too. The impact for v = 1, with balls
for V and T, has that factor for q. Over v the rate θ′ is larger the smaller v is, so that its sign
stays in all impacts if it stays in one with the largest v.

With rolling resistance the sign of θ′ must stay. Where θ′ is held at 0, rates fall by e exactly.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from .balls import Ball, Undecided, arb, flint, sign
from .body import Body, State
from .impact import impact
from .impact_resisted import impact_resisted


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
    bits = 100 + flint.ctx.prec // 4
    if not start.gap_rate < arb(2) ** -bits:
        return None
    if body.resists and start.rate.is_zero():
        found = _held(body, start, restitution)
    else:
        v = start.gap_rate.upper()
        spreads = (v * 2**16 * 4**k for k in range(40))
        tried = (_within(body, start, restitution, law, v, spread) for spread in spreads)
        found = next((one for one in tried if one is not None), None)
    if found is None and start.gap_rate < arb(2) ** (-2 * bits):
        raise Undecided("bounces are not seen to settle")
    return found


@dataclass(frozen=True)
class _Box:
    """What impacts and flights do while θ, θ′ and a gap rate of at most v stay within bounds."""

    body: Body
    theta: Ball
    rate: Ball
    least: Ball
    """The weakest pull, W1."""
    largest: Ball
    """The strongest pull, W2."""
    v: Ball

    @property
    def uneven(self) -> Ball:
        return (self.largest / self.least).sqrt()

    @property
    def drift(self) -> Ball:
        """Return by how much the slip falls in a unit of time of a flight."""
        return self.body.h * self.theta.sin() * self.rate * self.rate + self.body.back

    def ratio_of_impacts(self, e: Ball, law: str) -> Ball | None:
        """Return what an impact that sticks makes of its gap rate at most; None if undecided."""
        least, largest = self.least, self.largest
        slip = -self.drift * (2 / largest).union(2 / least)
        closing = (1 / self.uneven).union(self.uneven)
        zero = arb(0)
        landing = State(zero, self.theta, self.rate / self.v, slip, zero, zero, -closing)
        try:
            if self.body.resists:
                after = impact_resisted(self.body, landing, e, law)[0].after
            else:
                after = impact(self.body, landing, e, law).after
        except Undecided:
            return None
        return after.gap_rate.upper() if after.slip.is_zero() else None


def _within(body: Body, start: State, e: Ball, law: str, v: Ball, spread: Ball) -> Rest | None:
    one, m = arb(0, 1), body.mass
    theta, rate = start.theta + one * spread, start.rate + one * spread
    pull = body.contact(theta, rate)
    if not pull > 0 or (body.resists and not (rate > 0 or rate < 0)):
        return None
    box = _Box(body, theta, rate, pull.lower(), pull.upper(), v)
    rotation = sign(rate, "θ′ of bounces") if body.resists else 0
    sin, cos = theta.sin(), theta.cos()
    arm, lever = body.h * sin, 1 + body.h * cos
    uneven, least, drift = box.uneven, box.least, box.drift
    sticks = start.slip.is_zero()
    if sticks and not (drift > 0 or drift < 0):
        return None
    # A flight slips against its drift.
    sigma = -sign(drift, "drift") if sticks else sign(start.slip, "the slip velocity of bounces")
    q = body.q(sin, cos, sigma, rotation)
    k1 = 1 / m + arm * q / body.inertia
    press, hold, ratio = k1, body.mu_k, (e * uneven).upper()
    if sticks:
        twist = arm - body.chi * rotation
        j = body.inertia + m * lever * lever
        hold, k2 = body.mu_s, 1 / m + arm * twist / j
        slowing = body.mu_k / m - sigma * lever * q / body.inertia
        back = v * (1 / uneven)
        if not (
            abs(m * lever * twist) < body.mu_s * j
            and k1 > 0
            and slowing > 0
            and abs(drift) * 2 * v / least * k1 < (1 + e) * back * slowing
        ):
            return None
        press = k1.min(k2)
        if not (ratio < 1 and k1 > k2):
            found = box.ratio_of_impacts(e, law)
            if found is None:
                return None
            ratio = found
    if not (press > 0 and ratio < 1):
        return None
    # Each impact takes up V ≤ v √(W2/W1) and gives at most q v.
    normal = ((uneven + ratio) * v / ((1 - ratio) * press)).upper()
    friction = (hold * normal).upper()
    time = (2 * v / (least * (1 - ratio))).upper()
    spin = ((abs(arm) * normal + abs(lever) * friction + body.chi * normal) / body.inertia).upper()
    turn = (rate.abs_upper() * time).upper()
    change = (friction / m + abs(lever) * spin + abs(drift) * time).upper()
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


def _held(body: Body, start: State, e: Ball) -> Rest | None:
    """Enclose bounces without rotation, which rolling resistance holds: a geometric series.

    In the air nothing turns, so that rates fall by e, and each impact has the impulse m (1 + e) v.
    On a slope a flight of time 2 v/cos α gains the slip −sin α 2 v/cos α. Friction ends it in the
    impact, and then has as much impulse, or cannot, and the slip of all bounces keeps its sign.
    """
    if not e < 1:
        return None
    sin, cos = start.theta.sin(), start.theta.cos()
    moves = sign(start.slip, "the slip velocity of bounces")
    slides = moves or -sign(body.back, "sin α")
    if not abs(body.q(sin, cos, slides)) < body.chi:
        return None
    v = start.gap_rate
    time, normal = 2 * v / (body.down * (1 - e)), body.mass * (1 + e) * v / (1 - e)
    rubbed = body.mu_k * normal
    slip, friction = start.slip, -rubbed * slides
    gained = -body.back * time
    # That the friction of an impact exceeds what ends the slip of a flight.
    ends = rubbed - body.mass * abs(gained)
    sticks = not moves and (slides == 0 or sign(ends, "friction of a bounce") > 0)
    if sticks:
        if not abs(body.h * sin) < body.chi:
            return None
        friction = -body.mass * gained
    else:
        slip = slip + gained + friction / body.mass
        if not slip * slides > abs(gained) * (2 if moves else 0):
            return None
    far = arb(0, 1) * ((abs(start.slip) + abs(gained) + rubbed / body.mass) * time).upper()
    end = replace(
        start,
        time=start.time + time,
        slip=slip,
        x=start.x + far,
        gap=arb(0),
        gap_rate=arb(0),
    )
    return Rest(end, normal, friction, sticks)
