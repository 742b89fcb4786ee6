"""Intervals in fixed point, with Python's integers alone.

A range is (middle ± radius) 2^−bits with integers, and each operation rounds outwards.
"""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from math import isqrt


class Inconclusive(Exception):
    """More bits are needed to tell."""


class Range:
    """An interval."""

    __slots__ = ("m", "r")
    bits = 256

    def __init__(self, m: int, r: int = 0) -> None:
        self.m, self.r = m, r

    @classmethod
    def of(cls, value: Fraction | int) -> Range:
        """Return the range of a rational number."""
        scaled = Fraction(value) * (1 << cls.bits)
        m = scaled.__floor__()
        return cls(m, 0 if m == scaled else 1)

    def ends(self) -> tuple[Fraction, Fraction]:
        """Return both ends."""
        return Fraction(self.m - self.r, 1 << self.bits), Fraction(self.m + self.r, 1 << self.bits)

    def __float__(self) -> float:
        return float(Fraction(self.m, 1 << self.bits))

    def __neg__(self) -> Range:
        return Range(-self.m, self.r)

    def __add__(self, other: Range | int) -> Range:
        if not isinstance(other, (Range, int)):
            return NotImplemented
        other = _range(other)
        return Range(self.m + other.m, self.r + other.r)

    __radd__ = __add__

    def __sub__(self, other: Range | int) -> Range:
        if not isinstance(other, (Range, int)):
            return NotImplemented
        return self + (-_range(other))

    def __rsub__(self, other: int) -> Range:
        return _range(other) - self

    def __mul__(self, other: Range | int) -> Range:
        if isinstance(other, int):
            return Range(self.m * other, self.r * abs(other))
        if not isinstance(other, Range):
            return NotImplemented
        if self.is_zero() or other.is_zero():
            return Range(0)
        r = abs(self.m) * other.r + self.r * (abs(other.m) + other.r)
        return Range(self.m * other.m >> self.bits, (r >> self.bits) + 2)

    __rmul__ = __mul__

    def __truediv__(self, other: Range | int) -> Range:
        if isinstance(other, int) and other > 0:
            return Range(self.m // other, self.r // other + (2 if self.r or self.m % other else 0))
        if not isinstance(other, (Range, int)):
            return NotImplemented
        other = _range(other)
        least = abs(other.m) - other.r
        if least <= 0:
            raise Inconclusive("a divisor may be 0")
        if self.is_zero():
            return self
        m = (self.m << self.bits) // other.m
        return Range(m, ((self.r << self.bits) + (abs(m) + 1) * other.r) // least + 2)

    def __rtruediv__(self, other: int) -> Range:
        return _range(other) / self

    def sqrt(self) -> Range:
        """Return the square root."""
        low = self.m - self.r
        if low < 0:
            raise Inconclusive("a root may be of a negative number")
        if self.r == 0:
            root = isqrt(self.m << self.bits)
            return Range(root, 0 if root * root == self.m << self.bits else 1)
        root = isqrt(low << self.bits)
        top = isqrt((self.m + self.r) << self.bits) + 1
        return Range((root + top) // 2, (top - root) // 2 + 1)

    def __abs__(self) -> Range:
        return -self if self.sign() < 0 else self

    def sign(self) -> int:
        """Return the sign; 0 only for what is exactly 0."""
        if self.m > self.r:
            return 1
        if self.m < -self.r:
            return -1
        if self.m == 0 and self.r == 0:
            return 0
        raise Inconclusive("a sign is not decided")

    def is_zero(self) -> bool:
        """Whether this is exactly 0."""
        return self.m == 0 and self.r == 0

    def largest(self) -> Range:
        """Return an upper bound of the size, exactly."""
        return Range(abs(self.m) + self.r)

    def least(self) -> Range:
        """Return the lower end, exactly."""
        return Range(self.m - self.r)

    def widened(self, by: Range) -> Range:
        """Return the range with so much more on both sides."""
        return Range(self.m, self.r + by.m + by.r)


def _range(value: Range | int) -> Range:
    return value if isinstance(value, Range) else Range(value << Range.bits)


def exceeds(one: Range, other: Range | int) -> bool:
    """Whether one is certainly greater."""
    difference = one - other
    return difference.m > difference.r


def pi() -> Range:
    """Return π by Machin's formula."""
    return _pi(Range.bits)


@lru_cache
def _pi(bits: int) -> Range:
    guard = 32
    one = 1 << (bits + guard)

    def arctan_of_inverse(n: int) -> int:
        power = total = one // n
        k, sign = 3, -1
        while power:
            power //= n * n
            total += sign * (power // k)
            k, sign = k + 2, -sign
        return total

    value = 4 * (4 * arctan_of_inverse(5) - arctan_of_inverse(239))
    return Range(value >> guard, 2)


def sine_and_cosine(angle: Range) -> tuple[Range, Range]:
    """Return sin and cos: Taylor's series after quarter turns are taken off."""
    quarter = pi() / 2
    count = round(Fraction(angle.m, quarter.m))
    rest = angle - quarter * count
    x, limit = rest.m, Range.bits
    sums, term, k = [0, 0], 1 << limit, 0
    square_terms = 0
    while term and square_terms < 4 * limit:
        sums[k % 2] += term if k % 4 < 2 else -term
        k += 1
        term = (term * x >> limit) // k if x >= 0 else -((term * -x >> limit) // k)
        square_terms += 1
    radius = rest.r + 2 * k + 4
    cos, sin = Range(sums[0], radius), Range(sums[1], radius)
    turned = [(sin, cos), (cos, -sin), (-sin, -cos), (-cos, sin)][count % 4]
    if angle.is_zero():
        return Range(0), _range(1)
    return turned
