"""A step of a phase on the plane: Taylor's series of θ in time, with a proof of how far it is off.

*How large.* If |θ″| ≤ M as long as |θ′(z) − θ′| ≤ b and |z| ≤ ρ, and M ρ ≤ b, the solution exists on that disc of the
complex plane and stays within these bounds (Picard), which bound its coefficients (Cauchy). The step goes to ρ/8, so
that what n terms leave out is bounded by 8⁻ⁿ.

*How far apart.* The series is that of the middle of the start. Where the derivatives of θ″ by θ and θ′ are at most a
and b, the distances of another solution from it grow at most as those of δθ′ = δω, δω′ = a δθ + b δω.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property

from .discs import Disc, Wide, angle_and_rate, around
from .phase import SLIP, Phase
from .ranges import Inconclusive, Range, exceeds, sine_and_cosine
from .series import Integral, Series, at, line
from .zeros import Guard

SHARE = 8
"""Radius of the disc over the length of the step."""


@dataclass(frozen=True)
class Apart:
    """How far solutions are apart, in last bits."""

    theta: float
    rate: float

    def after(self, time: float, alpha: Disc) -> Apart:
        """Return the same after a time: the exponential series of the matrix of the distances."""
        a, b = alpha.by_theta, alpha.by_rate
        theta, rate = self.theta, self.rate
        all_theta, all_rate = theta, rate
        for k in range(1, 80):
            theta, rate = rate * time / k, (a * theta + b * rate) * time / k
            all_theta, all_rate = all_theta + theta, all_rate + rate
        if not (all_theta < 1e280 and all_rate < 1e280 and (theta + rate) * 1e9 <= all_theta + all_rate):
            raise Inconclusive("solutions part too fast")
        # The terms that are left out, and rounding.
        more = (theta + rate) + 1e-12 * (all_theta + all_rate)
        return Apart(all_theta + more, all_rate + more)

    @property
    def as_number(self) -> float:
        """A bound of both."""
        return math.ldexp(max(self.theta, self.rate) + 1, -Range.bits) * 1.001


class Step:
    """A step from θ and θ′ at a time of a phase, to ρ/8 or to an end."""

    def __init__(self, phase: Phase, tau: Range, theta: Range, rate: Range, guess: float, end: Range | None) -> None:
        self.phase, self.tau = phase, tau
        self.theta, self.rate = Range(theta.m), Range(rate.m)
        self.apart = Apart(float(theta.r), float(rate.r))
        self.rho = guess
        spread = self._spread(guess)
        while spread is None:
            self.rho *= 0.85
            if self.rho < 1e-12:
                raise Inconclusive("the step is too short")
            spread = self._spread(self.rho)
        self.region = self._region(self.rho, spread)
        self.length = Range(int(self.rho / SHARE * 2.0**60) << Range.bits - 60)
        if end is not None and exceeds(self.length, end - tau):
            # A little beyond, so that it covers the end.
            self.length = (end - tau).largest() + Range(1)
        # What n terms leave out is a power of this.
        self.base = self.rho / (float(self.length) * (1 + 1e-9) + 1e-30)
        self.terms = int(Range.bits / math.log2(self.base)) + 6
        self._expand()

    def _spread(self, rho: float) -> float | None:
        """Return a bound of |θ′(z) − θ′| where |z| ≤ ρ, if there is one."""
        spread = 0.0
        for _ in range(8):
            try:
                alpha = self._acceleration(angle_and_rate(*self._region(rho, spread)))
            except Wide:
                return None
            reached = alpha.size * rho * 1.000001
            if reached <= spread:
                return spread
            spread = 1.1 * reached
        return None

    def _region(self, rho: float, spread: float) -> tuple[Disc, Disc]:
        """Return θ and θ′ where |z| ≤ ρ, of all solutions that begin in the range of the start."""
        apart = self.apart.as_number
        omega = around(self.rate, spread + apart)
        return around(self.theta, omega.size * rho * 1.000001 + apart), omega

    def _expand(self) -> None:
        length, body = self.length, self.phase.body
        sin, cos = sine_and_cosine(self.theta)
        s, c = Integral(sin, length), Integral(cos, length)
        theta, omega = Integral(self.theta, length), Integral(self.rate, length)
        alpha = self.phase.acceleration(body, s, c, omega)
        theta.of, omega.of, s.of, c.of = omega, alpha, c * omega, -(s * omega)
        self.theta_series, self.rate_series, self.angle, self.alpha = theta, omega, (s, c, omega), alpha
        # Within the step the disc is smaller, and so is the distance.
        near = self.rho / SHARE * 1.000001
        spread = self._spread(near)
        if spread is None:
            raise Inconclusive("the step is too short")
        parted = self.apart.after(near, self._acceleration(angle_and_rate(*self._region(near, spread))))
        theta_off, rate_off = self._rest(self.region[0].r), self._rest(self.region[1].r)
        self.off = Range(int(parted.theta) + 1 + theta_off), Range(int(parted.rate) + 1 + rate_off)

    def _acceleration(self, angle: tuple[Disc, Disc, Disc]) -> Disc:
        alpha: Disc = self.phase.acceleration(self.phase.in_discs, *angle)
        return alpha

    def moment(self, s: Range) -> tuple[Range, Range, Range]:
        """Return time, θ and θ′ at a place in the step."""
        powers = range(self.terms - 1, -1, -1)
        theta = at((self.theta_series[k] for k in powers), s)
        omega = at((self.rate_series[k] for k in powers), s)
        return self.tau + self.length * s, theta.widened(self.off[0]), omega.widened(self.off[1])

    @cached_property
    def guards(self) -> dict[str, Guard]:
        """The guards of the phase."""
        phase, angle = self.phase, self._angle
        series = phase.guards(phase.body, self.angle, self.alpha, line(self.tau, self.length), phase.slip_constant)
        tau, constant = (around(*one) for one in ((self.tau, self.rho), (phase.slip_constant,)))
        sizes = phase.guards(phase.in_discs, angle, self._acceleration(angle), tau, constant)
        orders = {SLIP: phase.order} if self.tau.is_zero() else {}
        return {name: self._guard(series[name], sizes[name], orders.get(name, 0)) for name in series}

    def rate_guard(self) -> Guard:
        """Return θ′ in the step."""
        return self._guard(self.rate_series, self._angle[2], 0)

    def angle_guard(self, target: Range) -> Guard:
        """Return θ in the step, less a target."""
        far = around(self.theta - target, self.region[0].r)
        return self._guard(self.theta_series - target, replace(far, by_theta=1.0), 0)

    @cached_property
    def _angle(self) -> tuple[Disc, Disc, Disc]:
        return angle_and_rate(*self.region)

    @cached_property
    def _parted(self) -> Apart:
        return self.apart.after(self.rho * 1.000001, self._acceleration(self._angle))

    def _guard(self, series: Series, on_disc: Disc, order: int) -> Guard:
        """Return a function of θ, θ′ and time along the solution, without its zero at the start.

        A function with a zero of order k where s = 0, over s^k, is at most as large as where |s| = base, over base^k;
        so is what the middle of the start changes, in which lower coefficients have to be left out.
        """
        coefficients = [series[k] for k in range(self.terms)]
        off = on_disc.by_theta * self._parted.theta + on_disc.by_rate * self._parted.rate
        off += sum(float(one.largest().m) * self.base**k for k, one in enumerate(coefficients[:order]))
        apart, rest = int(off / self.base**order * 1.001) + 1, self._rest(on_disc.size)
        return Guard(coefficients[order:], Range(apart + rest), Range(apart + rest * 2 * self.terms))

    def _rest(self, size: float) -> int:
        """Return what n terms leave out of a function of this size where |z| ≤ ρ, in last bits."""
        return int(1.2 * 2.0 ** (Range.bits + math.log2(size + 1e-30) - self.terms * math.log2(self.base))) + 1
