"""Functions of one variable on a disc.

Taylor series with balls as coefficients, and a bound for the rest.

If a function is analytic where |s| ≤ r and not larger than M there, its coefficient of order k is
at most M/r^k (Cauchy). The series and M therefore enclose the function and its derivative where
|s| < r.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from .balls import Ball, Undecided, arb, arb_poly, arb_series, flint


@dataclass(frozen=True)
class Model:
    """A function where |s| ≤ radius: its series, and a bound for its size there."""

    series: Ball
    size: Ball
    radius: Ball

    def __add__(self, other: Model | Ball | int) -> Model:
        """Return the sum."""
        if isinstance(other, Model):
            return Model(self.series + other.series, self.size + other.size, self.radius)
        return Model(self.series + other, self.size + abs(arb(other)), self.radius)

    __radd__ = __add__

    def __neg__(self) -> Model:
        """Return the negative."""
        return Model(-self.series, self.size, self.radius)

    def __sub__(self, other: Model | Ball | int) -> Model:
        """Return the difference."""
        return self + (-other)

    def __rsub__(self, other: Ball | int) -> Model:
        """Return the difference."""
        return -self + other

    def __mul__(self, other: Model | Ball | int) -> Model:
        """Return the product."""
        if isinstance(other, Model):
            return Model(self.series * other.series, self.size * other.size, self.radius)
        return Model(self.series * other, self.size * abs(arb(other)), self.radius)

    __rmul__ = __mul__

    def integral(self, start: Ball) -> Model:
        """Return the integral with this value at s = 0."""
        return Model(
            start + self.series.integral(), self.size * self.radius + abs(start), self.radius
        )

    def without_zero(self, order: int) -> Model:
        """Divide by s^order, where the function is known to have a zero of that order at s = 0."""
        if order == 0:
            return self
        n = flint.ctx.cap - order
        series = arb_series([self.series[k + order] for k in range(n)], n)
        return Model(series, self.size / self.radius**order, self.radius)

    def of_square(self, radius: Ball) -> Model:
        """Return the function of ξ that this is of s = ξ², where |ξ| ≤ radius.

        The square of the radius is not above that of s.
        """
        n = flint.ctx.cap
        coefficients = [self.series[k // 2] if k % 2 == 0 else arb(0) for k in range(n)]
        return Model(arb_series(coefficients, n), self.size, radius)

    def value(self, low: Ball, high: Ball) -> Ball:
        """Enclose the function between two points."""
        return self._between(self._polynomial(), low, high) + self._rest(low, high)

    def slope(self, low: Ball, high: Ball) -> Ball:
        """Enclose its derivative between two points."""
        n, part = self._order(), self._part(low, high)
        rest = self.size / self.radius * part ** (n - 1) * n / (1 - part) ** 2
        return self._between(self._polynomial().derivative(), low, high) + arb(0, rest.abs_upper())

    def _order(self) -> int:
        return int(self.series.prec)

    def _polynomial(self) -> Ball:
        return arb_poly([self.series[k] for k in range(self._order())])

    def _part(self, low: Ball, high: Ball) -> Ball:
        part = low.abs_upper().max(high.abs_upper()) / self.radius
        if not part < 0.75:
            raise Undecided("a point is not within the disc of its series")
        return part

    def _rest(self, low: Ball, high: Ball) -> Ball:
        part = self._part(low, high)
        return arb(0, (self.size * part ** self._order() / (1 - part)).abs_upper())

    @staticmethod
    def _between(polynomial: Ball, low: Ball, high: Ball) -> Ball:
        both = low.union(high)
        middle, radius = both.mid(), both.rad()
        if radius.is_zero():
            return polynomial(middle)
        spread = polynomial.derivative()(both).abs_upper() * radius
        return polynomial(middle) + arb(0, spread.abs_upper())


def sine_and_cosine(theta: Ball, rate: Ball | int, radius: Ball) -> tuple[Model, Model]:
    """Return sin and cos of theta + rate s."""
    angle = arb_series([theta, rate], flint.ctx.cap)
    size = (abs(arb(rate)) * radius).cosh()
    return Model(angle.sin(), size, radius), Model(angle.cos(), size, radius)


def polynomial(coefficients: list[Ball], radius: Ball) -> Model:
    """Return a polynomial in s."""
    size = sum((abs(c) * radius**k for k, c in enumerate(coefficients)), arb(0))
    return Model(arb_series(coefficients, flint.ctx.cap), size, radius)


@dataclass(frozen=True)
class Crossing:
    """The first zero of a guard; all others are positive up to it."""

    guard: str
    at: Ball


MOST_INTERVALS = 20_000
"""Intervals after which the sign of a guard between two points counts as not decided."""


def first_crossing(
    guards: Mapping[str, Model], low: Ball, high: Ball, halvings: int | None = None
) -> Crossing | None:
    """Find the first zero between two points, or prove that there is none.

    All guards are positive at the first point, or their zero there has been divided out. Each
    interval is left with a proof: each guard is enclosed and positive on it, or monotone and
    positive at its ends, or falls through its one zero before which all others are positive.
    """
    most = 3 * flint.ctx.prec // 4 if halvings is None else halvings
    work = [(low, high, most)]
    for _ in range(MOST_INTERVALS):
        low, high, left = work.pop()
        doubtful: dict[str, bool] = {}
        for name, guard in guards.items():
            if guard.value(low, high) > 0:
                continue
            slope, first = guard.slope(low, high), guard.value(low, low)
            monotone = (slope > 0 or slope < 0) and first > 0
            last = guard.value(high, high) if monotone else arb(0)
            if last > 0:
                continue
            doubtful[name] = bool(slope < 0 and last < 0)
        if len(doubtful) == 1 and all(doubtful.values()):
            name = next(iter(doubtful))
            return Crossing(name, crossing_of(guards[name], low, high))
        if doubtful:
            if left == 0:
                raise Undecided(f"whether {' or '.join(sorted(doubtful))} vanishes is not decided")
            middle = ((low + high) / 2).mid()
            work += [(middle, high, left - 1), (low, middle, left - 1)]
        if not work:
            return None
    raise Undecided(
        f"whether {' or '.join(sorted(guards))} vanishes is not decided on {MOST_INTERVALS} "
        f"intervals"
    )


def crossing_of(guard: Model, low: Ball, high: Ball) -> Ball:
    """Return the one zero between two points, by Newton's method with enclosures."""
    root = low.union(high)
    for _ in range(200):
        middle = root.mid()
        below, above = root.lower(), root.upper()
        slope = guard.slope(below, above)
        if not (slope > 0 or slope < 0):
            raise Undecided("a zero is not simple")
        step = (middle - guard.value(middle, middle) / slope).intersection(root)
        if not step.rad() < root.rad() * 0.75:
            return step
        root = step
    return root
