"""The hoop and the equations of its contact, written once for ranges, for series and for discs.

m, Î and h are mass, inertia about the mass centre and its distance from the centre, ℓ = m h; s, c, ω are sin θ, cos θ
and θ′; σ is the direction of slip. (2.11) to (2.18) are the equations of the paper, docs/theory derives them.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, fields
from typing import Any, TypeAlias

from .ranges import Range

Value: TypeAlias = Any
"""A range, a series, a disc or a slope."""


@dataclass(frozen=True)
class Body:
    """The hoop; its numbers are ranges or discs."""

    m: Value
    h: Value
    inertia: Value
    offset: Value
    mu_s: Value
    mu_k: Value

    def converted(self, to: Callable[[Range], Value]) -> Body:
        """Return the same with numbers of another kind."""
        return Body(*(to(getattr(self, field.name)) for field in fields(self)))

    def weight(self, c: Value, omega: Value) -> Value:
        """Return w = 1 − h c ω²: without forces the rim has the acceleration −w."""
        return 1 - self.h * c * omega * omega

    def arm(self, s: Value, c: Value, sigma: int) -> Value:
        """Return 1 + h c + σ μk h s: of η′ − (…) ω + σ μk τ every slide has a constant."""
        return 1 + self.h * c + self.mu_k * self.h * s * sigma

    def solvability(self, s: Value, c: Value, sigma: int) -> Value:
        """Return P = Î + m h s q."""
        return self.inertia + self.m * self.h * s * self._q(s, c, sigma)

    def _q(self, s: Value, c: Value, sigma: int) -> Value:
        return self.h * s - self.mu_k * sigma * (1 + self.h * c)

    def rolling(self, s: Value, c: Value, omega: Value) -> Value:
        """Return θ″ of rolling, ℓ s (1 + ω²)/D with D = Î + m (1 + h²) + 2 ℓ c (2.11)."""
        constant = self.inertia + self.m * (1 + self.h * self.h)
        return self.offset * s * (1 + omega * omega) / (2 * (self.offset * c) + constant)

    def sliding(self, s: Value, c: Value, omega: Value, sigma: int) -> Value:
        """Return θ″ of sliding, m q w/P (2.16)."""
        return self.m * self._q(s, c, sigma) * self.weight(c, omega) / self.solvability(s, c, sigma)

    def gliding(self, s: Value, c: Value, omega: Value) -> Value:
        """Return θ″ of gliding, where the height of the particle falls freely: w/(h s) (3.17)."""
        return self.weight(c, omega) / (self.h * s)

    def forces(self, s: Value, c: Value, omega: Value, alpha: Value) -> tuple[Value, Value]:
        """Return N and F of rolling with θ″ = α, as Newton has them: N − m = m ȳ″ and F = m x̄″ (2.12)."""
        u = omega * omega
        normal = self.m - self.offset * (s * alpha + c * u)
        return normal, self.offset * (s * u - c * alpha) - self.m * alpha

    def compliances(self, s: Value, c: Value) -> tuple[Value, Value, Value]:
        """Return A, B and C: what impulses along and across the plane do to the velocities of the rim."""
        arm, lever = self.h * s, 1 + self.h * c
        return (
            1 / self.m + lever * lever / self.inertia,
            arm * lever / self.inertia,
            1 / self.m + arm * arm / self.inertia,
        )


@dataclass(frozen=True)
class State:
    """A state."""

    time: Range
    theta: Range
    rate: Range
    slip: Range
    x: Range
    gap: Range
    gap_rate: Range
