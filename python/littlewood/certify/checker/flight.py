"""A step of a flight.

θ′ is constant, and the gap y = (y′ − h s ω) τ − τ²/2 − h (cos(θ + ω τ) − cos θ) has a series that is known.
"""

from __future__ import annotations

from fractions import Fraction
from functools import cached_property

from .phase import GAP, Phase
from .ranges import Range, exceeds, sine_and_cosine
from .series import at
from .zeros import Guard


class FlightStep:
    """A step from a time of a flight on; the flight begins with a zero of the gap of the order of the phase."""

    def __init__(self, phase: Phase, tau: Range, end: Range | None) -> None:
        self.phase, self.tau = phase, tau
        self.order = phase.order if tau.is_zero() else 0
        rate, opening = phase.start.rate, float(phase.start.gap_rate)
        length = Fraction(1 / (2 + 2.000001 * abs(float(rate))))
        weight = float(phase.body.weight(phase.cos, rate))
        if self.order == 1 and weight > 0:
            # A short bounce: its two zeros are told apart on a step of its own length.
            length = min(length, Fraction(3 * opening / weight))
        self.length = Range(Range.of(length).m + 1)
        if end is not None and exceeds(self.length, end - tau):
            # A little beyond, so that it covers the end.
            self.length = (end - tau).largest() + Range(1)

    def moment(self, s: Range) -> tuple[Range, Range, Range]:
        """Return time, θ and θ′ at a place in the step."""
        start, tau = self.phase.start, self.tau + self.length * s
        return tau, start.theta + start.rate * tau, start.rate

    @cached_property
    def guards(self) -> dict[str, Guard]:
        """The gap, without its zero at the start.

        Its derivatives of order k ≥ 3 are at most |ω|^k, and |ω| length < 1/2: what is left out is less than the bound
        of the last term.
        """
        phase, rate, order = self.phase, self.phase.start.rate, self.order
        now = phase.state(*self.moment(Range(0)))
        sin, cos = sine_and_cosine(now.theta)
        derivative = (cos, -sin, -cos, sin)
        gap, power = [now.gap, now.gap_rate], rate
        scale = last = one = Range(1 << Range.bits)
        while len(gap) < 4 or exceeds(last, Range(64)):
            k = len(gap)
            power = power * rate / k
            term = -(phase.body.h * derivative[k % 4] * power)
            gap.append(term - one / 2 if k == 2 else term)
            scale = scale * self.length if k > order + 1 else one
            last = (power * scale).largest()
        found, scale = [], one
        for term in gap[order:]:
            found.append(term * scale)
            scale = scale * self.length
        return {GAP: Guard(found, last + Range(1), last * (2 * k) + Range(1))}

    def landing_rate(self, s: Range) -> Range:
        """Return y′ where y = 0, in a step that begins with y = 0: less 2 y/τ, so that no radius doubles."""
        gap = self.guards[GAP]
        terms = [gap.coefficients[k] * (k - 1) for k in range(len(gap.coefficients) - 1, 1, -1)]
        return (at(terms, s) * s * s - self.phase.start.gap_rate).widened(gap.slope_off)
