"""Power series in s, 0 ≤ s ≤ 1, whose coefficients are ranges and are computed when they are asked for.

A series knows how its next coefficient follows from those of others. So a differential equation is written as it
stands: an :class:`Integral` of a series that is made of the integral itself.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterable
from typing import TypeAlias

from .ranges import Range

Term: TypeAlias = "Series | Range | int"
Rule: TypeAlias = Callable[[int], tuple[int, int]]
"""Middle and radius of the coefficient of an order, all lower ones being there."""


class Series:
    """Middles and radii of the coefficients; the sum of their sizes so far, and the largest radius."""

    __slots__ = ("m", "r", "rule", "squared", "total", "worst")

    def __init__(self, rule: Rule) -> None:
        self.rule = rule
        self.m: list[int] = []
        self.r: list[int] = []
        self.total = self.worst = 0
        self.squared: Series | None = None

    def need(self, k: int) -> None:
        """Compute the coefficients up to this order."""
        while k >= len(self.m):
            m, r = self.rule(len(self.m))
            self.m.append(m)
            self.r.append(r)
            self.total += abs(m) + r
            if r > self.worst:
                self.worst = r

    def __getitem__(self, k: int) -> Range:
        self.need(k)
        return Range(self.m[k], self.r[k])

    def __add__(self, other: Term) -> Series:
        if not isinstance(other, Series):
            return self + _constant(other)

        def rule(k: int) -> tuple[int, int]:
            self.need(k)
            other.need(k)
            return self.m[k] + other.m[k], self.r[k] + other.r[k]

        return Series(rule)

    __radd__ = __add__

    def __neg__(self) -> Series:
        def rule(k: int) -> tuple[int, int]:
            self.need(k)
            return -self.m[k], self.r[k]

        return Series(rule)

    def __sub__(self, other: Term) -> Series:
        return self + (-other)

    def __rsub__(self, other: Range | int) -> Series:
        return -self + other

    def __mul__(self, other: Term) -> Series:
        bits = Range.bits
        if not isinstance(other, Series):
            factor = other if isinstance(other, Range) else Range(other << bits)

            def multiple(k: int) -> tuple[int, int]:
                self.need(k)
                m, r = self.m[k], self.r[k]
                return m * factor.m >> bits, (abs(m) * factor.r + r * (abs(factor.m) + factor.r) >> bits) + 2

            return Series(multiple)
        if other is self and self.squared is not None:
            return self.squared

        def rule(k: int) -> tuple[int, int]:
            self.need(k)
            other.need(k)
            middle = sum(map(operator.mul, self.m[: k + 1], other.m[k::-1]))
            return middle >> bits, (self.total * other.worst + other.total * self.worst >> bits) + 2

        found = Series(rule)
        if other is self:
            self.squared = found
        return found

    __rmul__ = __mul__

    def __truediv__(self, other: Series) -> Series:
        def rule(k: int) -> tuple[int, int]:
            other.need(k)
            middle = sum(map(operator.mul, found.m, other.m[k:0:-1]))
            radius = found.total * other.worst + (other.total - abs(other.m[0]) - other.r[0]) * found.worst
            one = (self[k] - Range(middle >> Range.bits, (radius >> Range.bits) + 2)) / other[0]
            return one.m, one.r

        found = Series(rule)
        return found


class Integral(Series):
    """The integral, from a value on, of a series that is named later, times a number: ds for dt."""

    __slots__ = ("of",)

    def __init__(self, first: Range, scale: Range) -> None:
        self.of: Series

        def rule(k: int) -> tuple[int, int]:
            one = self.of[k - 1] * scale / k if k else first
            return one.m, one.r

        super().__init__(rule)


def line(first: Range, slope: Range) -> Series:
    """Return first + slope s."""
    return Series(lambda k: (first.m, first.r) if k == 0 else (slope.m, slope.r) if k == 1 else (0, 0))


def _constant(value: Range | int) -> Series:
    one = value if isinstance(value, Range) else Range(value << Range.bits)
    return line(one, Range(0))


def at(coefficients: Iterable[Range], s: Range) -> Range:
    """Return the value of a polynomial whose coefficients come from the highest down."""
    total = Range(0)
    for one in coefficients:
        total = total * s + one
    return total
