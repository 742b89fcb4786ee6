"""Bounces that accumulate: an enclosure of what infinitely many of them still do.

While θ and θ′ stay within a margin of what they are, the rim is pulled back with between W1 and W2 > 0. A flight that
begins with the gap rate v takes at most 2 v/W1 and comes back with at most v √(W2/W1), and an impact makes at most e V
of a rate V. So rates fall at least like qⁿ, q = e √(W2/W1) < 1, and sums over all bounces are at most geometric ones.
If by these sums the state stays within the margin, all of it holds for ever.

That an impact makes at most e V of V is the law where the contact slips throughout. Where it sticks, the slip of the
flight before has the sign of −h s ω², so that σ B < 0 and k1 = C + μk |B| > k2, from which it follows for each law.
"""

from __future__ import annotations

from dataclasses import dataclass

from .body import Body, State
from .ranges import Inconclusive, Range, exceeds, sine_and_cosine

SLOWEST = 150
"""Bounces are followed one by one until the gap opens more slowly than 2 to the power of minus this."""


@dataclass(frozen=True)
class Rest:
    """The end of the bounces, and their impulses."""

    end: State
    normal: Range
    friction: Range


def rest_of_bounces(body: Body, start: State, e: Range) -> Rest:
    """Enclose what follows, if the bounces settle."""
    v = start.gap_rate.largest()
    margin = v * (1 << 24)
    theta, rate = start.theta.widened(margin), start.rate.widened(margin)
    s, c = sine_and_cosine(theta)
    pull = body.weight(c, rate)
    _demand(exceeds(pull.least(), 0), "are pulled back")
    weakest, strongest = pull.least(), pull.largest()
    uneven = (strongest / weakest).sqrt()
    shrink = (e * uneven).largest()
    _demand(exceeds(Range(1 << Range.bits), shrink), "shrink")
    a, b, across = body.compliances(s, c)
    size, drift = b.largest(), (body.h * s * rate * rate).largest()
    longest = 2 * v / weakest
    time = (longest / (1 - shrink)).largest()
    closing = v * uneven / (1 - shrink)
    if start.slip.is_zero():
        # A flight slips by so little that the slip ends within the impact after it.
        _demand(exceeds(s, 0) or exceeds(-s, 0), "stick")
        _demand(exceeds(body.mu_s * a, size), "stick")
        least, back = abs(b).least(), v * (weakest / strongest).sqrt()
        pressed = (1 + e) * back * (body.mu_k * a + least)
        _demand(exceeds(pressed, drift * longest * (across + body.mu_k * size)), "stick")
        press, hold = across - b * b / a, body.mu_s
    else:
        press, hold = across - body.mu_k * b * start.slip.sign(), body.mu_k
    _demand(exceeds(press, 0), "are pressed back")
    normal = ((1 + e) * closing / press).largest()
    friction = (hold * normal).largest()
    change = (a * friction + size * normal + drift * time).largest()
    slip = start.slip
    if not slip.is_zero():
        # No slip ends within an impact: |η′|/(μk A − σ B) exceeds all impulses together.
        _demand(exceeds(abs(slip) - change, (body.mu_k * a - b * slip.sign()) * normal), "keep their slip")
        slip = slip.widened(change)
    turn = (rate.largest() * time).largest()
    spin = ((body.h * normal + (1 + body.h) * friction) / body.inertia).largest()
    _demand(exceeds(margin, turn) and exceeds(margin, spin), "stay within their margin")
    far = ((rate.largest() + abs(start.slip).largest() + change) * time).largest()
    half, zero = (time / 2).largest(), Range(0)
    end = State(
        (start.time + half).widened(half),
        start.theta.widened(turn),
        start.rate.widened(spin),
        slip,
        start.x.widened(far),
        zero,
        zero,
    )
    middle = (normal / 2).largest()
    return Rest(end, middle.widened(middle), zero.widened(friction))


def _demand(holds: bool, what: str) -> None:
    if not holds:
        raise Inconclusive(f"it is not seen that bounces {what}")
