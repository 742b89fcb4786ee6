"""The checker: follows the motion of a certificate again, and compares every number.

It uses other means than the maker.

    python3 checker.py CERTIFICATE ...

This file is all of it, and needs Python 3.10 or later alone: it takes nothing of the maker, of the
rest of the package, or of the certificate but its inputs. It writes the certificate that these
inputs have, by the conditions of docs/theory/contact.md, and refuses any other text.
docs/checker.md lists the rules. To read it, begin at the end, with :func:`check` and :class:`Walk`;
what they use comes before them:

intervals, series, complex discs; the equations of motion; the text of a number; what a certificate
may say; phases and their guards, zeros of guards, steps, a phase to its end; which motion follows;
impacts, and infinitely many of them.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import math
import operator
import re
import sys
import time as clock
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field, fields, replace
from fractions import Fraction
from functools import cached_property, lru_cache
from math import isqrt
from pathlib import Path
from threading import RLock
from typing import Any, TypeAlias, TypeVar

__all__ = [
    "Refused",
    "Unreadable",
    "check",
    "digest",
    "intact",
    "read",
    "read_file",
    "valid",
    "valid_case",
]


MOST_BYTES = 1 << 28
"""Most bytes of a file that is read."""


class Refused(Exception):
    """What in a certificate is not so."""


class Unreadable(Exception):
    """What is no JSON, or no file."""


class Inconclusive(Exception):
    """More bits are needed to tell."""


class TooLong(Exception):
    """A motion that takes too many steps with any number of bits."""


# Intervals in fixed point, with Python's integers alone.
#
# A range is (middle ± radius) 2^−bits with integers, and each operation rounds outwards.


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


_ONE_AT_A_TIME = RLock()


@contextmanager
def precision(bits: int) -> Iterator[None]:
    """Compute with this many bits; other threads wait."""
    with _ONE_AT_A_TIME:
        before, Range.bits = Range.bits, bits
        try:
            yield
        finally:
            Range.bits = before


def _range(value: Range | int) -> Range:
    return value if isinstance(value, Range) else Range(value << Range.bits)


def between(low: Range, high: Range) -> Range:
    """Return the range from the lower end of one to the upper end of another."""
    bottom, top = low.m - low.r, high.m + high.r
    return Range((bottom + top) // 2, (top - bottom) // 2 + 1)


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


# Power series in s, 0 ≤ s ≤ 1, whose coefficients are ranges and are computed when they are asked
# for.
#
# A series knows how its next coefficient follows from those of others. So a differential equation
# is written as it stands: an :class:`Integral` of a series that is made of the integral itself.


Term: TypeAlias = "Series | Range | int"
Rule: TypeAlias = Callable[[int], tuple[int, int]]
"""Middle and radius of the coefficient of an order, all lower ones being there."""


class Series:
    """Middles and radii of the coefficients.

    Also the sum of their sizes so far, and the largest radius.
    """

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
                return m * factor.m >> bits, (
                    abs(m) * factor.r + r * (abs(factor.m) + factor.r) >> bits
                ) + 2

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
            radius = (
                found.total * other.worst
                + (other.total - abs(other.m[0]) - other.r[0]) * found.worst
            )
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
    return Series(
        lambda k: (first.m, first.r) if k == 0 else (slope.m, slope.r) if k == 1 else (0, 0)
    )


def _constant(value: Range | int) -> Series:
    one = value if isinstance(value, Range) else Range(value << Range.bits)
    return line(one, Range(0))


def at(coefficients: Iterable[Range], s: Range) -> Range:
    """Return the value of a polynomial whose coefficients come from the highest down."""
    total = Range(0)
    for one in coefficients:
        total = total * s + one
    return total


# Functions of θ and θ′ on discs of the complex plane around a real point: in floats, each rounded
# up with a margin.
#
# They tell how far a solution reaches, how large it is there, and how fast two solutions part.


class Wide(Exception):
    """A disc is too wide: a divisor may be 0, or an angle goes too far."""


@dataclass(frozen=True)
class Disc:
    """Values within the radius of the centre, and bounds of the derivatives by θ and θ′."""

    c: float
    r: float = 0.0
    by_theta: float = 0.0
    by_rate: float = 0.0

    @property
    def size(self) -> float:
        """The largest absolute value."""
        return abs(self.c) + self.r

    def __add__(self, other: Disc | int) -> Disc:
        other = _disc(other)
        return _rounded(
            self.c + other.c,
            self.r + other.r,
            self.by_theta + other.by_theta,
            self.by_rate + other.by_rate,
        )

    __radd__ = __add__

    def __neg__(self) -> Disc:
        return Disc(-self.c, self.r, self.by_theta, self.by_rate)

    def __sub__(self, other: Disc | int) -> Disc:
        return self + (-other)

    def __rsub__(self, other: int) -> Disc:
        return -self + other

    def __mul__(self, other: Disc | int) -> Disc:
        other = _disc(other)
        mine, its = self.size, other.size
        return _rounded(
            self.c * other.c,
            abs(self.c) * other.r + self.r * its,
            self.by_theta * its + mine * other.by_theta,
            self.by_rate * its + mine * other.by_rate,
        )

    __rmul__ = __mul__

    def __truediv__(self, other: Disc) -> Disc:
        size = abs(other.c)
        least = size * 0.999999 - other.r
        if least <= 1e-12:
            raise Wide
        square = least * least
        return self * _rounded(
            1 / other.c, other.r / (size * least), other.by_theta / square, other.by_rate / square
        )


def _disc(value: Disc | int) -> Disc:
    return value if isinstance(value, Disc) else Disc(float(value))


def _rounded(c: float, r: float, by_theta: float = 0.0, by_rate: float = 0.0) -> Disc:
    more = 1 + 1e-12
    return Disc(c, r * more + abs(c) * 1e-14 + 1e-250, by_theta * more, by_rate * more)


def around(value: Range, more: float = 0.0) -> Disc:
    """Return the disc around a range, with so much more as radius."""
    return _rounded(float(value), more + float(Range(value.r)))


def angle_and_rate(theta: Disc, rate: Disc) -> tuple[Disc, Disc, Disc]:
    """Return sin θ, cos θ and θ′.

    With z from the centre, sin (θ + z) − sin θ = sin θ (cos z − 1) + cos θ sin z.
    """
    if theta.r > 3:
        raise Wide
    sin, cos = math.sin(theta.c), math.cos(theta.c)
    bend, turn, most = (
        math.cosh(theta.r) - 1 + 1e-14,
        math.sinh(theta.r) + 1e-14,
        math.cosh(theta.r),
    )
    s, c = abs(sin) * bend + abs(cos) * turn, abs(cos) * bend + abs(sin) * turn
    return (
        _rounded(sin, s, min(most, abs(cos) + c)),
        _rounded(cos, c, min(most, abs(sin) + s)),
        Disc(rate.c, rate.r, 0.0, 1.0),
    )


# The hoop and the equations of its contact, written once for ranges, for series and for discs.
#
# m, Î and h are mass, inertia about the mass centre and its distance from the centre, ℓ = m h; s,
# c, ω are sin θ, cos θ and θ′; σ is the direction of slip. The plane rises to the right by α; of
# gravity cos α is normal to it (`down`), and sin α points back along it (`back`). (2.11) to (2.18)
# are the equations of the paper, docs/theory derives them. With rolling resistance a couple −ς χ N
# acts, ς the sign of θ′ (`rotation`, 0 without): docs/theory/rolling-resistance.md.


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
    down: Value
    back: Value
    chi: Value

    def converted(self, to: Callable[[Range], Value]) -> Body:
        """Return the same with numbers of another kind."""
        return Body(*(to(getattr(self, field.name)) for field in fields(self)))

    def weight(self, c: Value, omega: Value) -> Value:
        """Return w = cos α − h c ω²: without forces the rim has the acceleration −w."""
        return self.down - self.h * c * omega * omega

    def drag(self, sigma: int) -> Value:
        """Return σ μk cos α + sin α, by which η′ − (…) ω falls in a unit of time."""
        return self.mu_k * sigma * self.down + self.back

    def arm(self, s: Value, c: Value, sigma: int) -> Value:
        """Return 1 + h c + σ μk h s: η′ − (…) ω + (σ μk cos α + sin α) τ is constant in a slide."""
        return 1 + self.h * c + self.mu_k * self.h * s * sigma

    def solvability(self, s: Value, c: Value, sigma: int, rotation: int = 0) -> Value:
        """Return P = Î + m h s q."""
        return self.inertia + self.m * self.h * s * self.q(s, c, sigma, rotation)

    def q(self, s: Value, c: Value, sigma: int, rotation: int = 0) -> Value:
        """Return q = h s − σ μk (1 + h c) − ς χ."""
        arm = self.h * s - self.mu_k * sigma * (1 + self.h * c)
        return arm - self.chi * rotation if rotation else arm

    def pressing(self, s: Value, c: Value, rotation: int = 0) -> Value:
        """Return D = Î + m (1 + h²) + 2 ℓ c, less ς χ ℓ s."""
        constant = self.inertia + self.m * (1 + self.h * self.h)
        found = 2 * (self.offset * c) + constant
        return found - self.chi * rotation * (self.offset * s) if rotation else found

    def rolling(self, s: Value, c: Value, omega: Value, rotation: int = 0) -> Value:
        """Return θ″ of rolling (2.11).

        It is (ℓ s (cos α + ω²) + (m + ℓ c) sin α − ς χ m w)/D.
        """
        turning = (
            self.offset * s * (self.down + omega * omega) + (self.offset * c + self.m) * self.back
        )
        if rotation:
            turning = turning - self.chi * rotation * self.m * self.weight(c, omega)
        return turning / self.pressing(s, c, rotation)

    def sliding(self, s: Value, c: Value, omega: Value, sigma: int, rotation: int = 0) -> Value:
        """Return θ″ of sliding, m q w/P (2.16)."""
        pull = self.m * self.q(s, c, sigma, rotation) * self.weight(c, omega)
        return pull / self.solvability(s, c, sigma, rotation)

    def normal(self, s: Value, c: Value, omega: Value, sigma: int, rotation: int = 0) -> Value:
        """Return N of sliding, m Î w/P."""
        pressed = self.m * self.inertia * self.weight(c, omega)
        return pressed / self.solvability(s, c, sigma, rotation)

    def gliding(self, s: Value, c: Value, omega: Value) -> Value:
        """Return θ″ of gliding, where the height of the particle falls freely: w/(h s) (3.17)."""
        return self.weight(c, omega) / (self.h * s)

    def forces(self, s: Value, c: Value, omega: Value, alpha: Value) -> tuple[Value, Value]:
        """Return N and F of rolling with θ″, as Newton has them (2.12).

        N − m cos α = m ȳ″ and F − m sin α = m x̄″.
        """
        u = omega * omega
        normal = self.m * self.down - self.offset * (s * alpha + c * u)
        return normal, self.offset * (s * u - c * alpha) - self.m * alpha + self.m * self.back

    def compliances(self, s: Value, c: Value) -> tuple[Value, Value, Value]:
        """Return A, B and C: what impulses along and across do to the velocities of the rim."""
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


# The text of a number that is enclosed, by the rule of the format; the checker's own reading of
# that rule.


def text_of(value: Range) -> list[str]:
    """Return 30 digits and ⌊d + 1/1000⌋ + 1 of their error d in hundredths of the last.

    All numbers between both ends have to agree.
    """
    low, high = value.ends()
    if low == high == 0:
        return ["0", "0"]
    if max(-low, high) <= Fraction(1, 10**40):
        return ["0", "1e-40"]
    if low <= 0 <= high:
        raise Inconclusive("a number is not told apart from 0")
    one, other = _digits(low), _digits(high)
    # If the digits themselves are a number between the ends, its error is 0.
    if one != other or (low <= Fraction(one[0]) <= high and not one[1].startswith("1e")):
        raise Inconclusive("the digits of a number are not decided")
    return one


def _digits(x: Fraction) -> list[str]:
    size, power = abs(x), 0
    power = len(str(size.numerator)) - len(str(size.denominator))
    while Fraction(10) ** power > size:
        power -= 1
    unit = Fraction(10) ** (power - 29)
    count = round(x / unit)
    error = int(100 * abs(x / unit - count) + Fraction(1, 1000)) + 1
    digits = str(abs(count))
    if len(digits) == 31:
        digits, power = digits[:30], power + 1
    sign = "-" if x < 0 else ""
    digits = digits.rstrip("0")
    if 0 <= power <= 29:
        digits = digits.ljust(power + 1, "0")
        tail = digits[power + 1 :]
        body = digits[: power + 1] + ("." + tail if tail else "")
    elif -5 <= power < 0:
        body = "0." + "0" * (-power - 1) + digits
    else:
        body = digits[0] + ("." + digits[1:] if len(digits) > 1 else "") + f"e{power}"
    return [sign + body, f"{error}e{power - 31}"]


# What a certificate may say: truth/certificate.schema.json in Python, and what a schema cannot
# state of its case.

Shape: TypeAlias = Callable[[Any, str], None]
"""Refuses a value, found at a place, that has another shape."""


def _shown(value: Any) -> str:
    """Return a value for a message."""
    if isinstance(value, (dict, list)):
        return "an object" if isinstance(value, dict) else "a list"
    text = ascii(value)
    return text if len(text) <= 60 else text[:57] + "…"


def _must(holds: bool, value: Any, where: str, what: str) -> None:
    if not holds:
        raise Refused(f"{where or 'the case'} = {_shown(value)} must {what}")


def _text(pattern: str = "") -> Shape:
    def shape(value: Any, where: str) -> None:
        _must(isinstance(value, str), value, where, "be a text")
        _must(
            not pattern or re.fullmatch(pattern, value) is not None,
            value,
            where,
            f"be of the form {pattern}",
        )

    return shape


def _one_of(*values: Any) -> Shape:
    def shape(value: Any, where: str) -> None:
        known = any(
            value == one and isinstance(value, bool) == isinstance(one, bool) for one in values
        )
        _must(
            known,
            value,
            where,
            f"be one of {', '.join(map(str, values))}" if len(values) > 1 else f"be {values[0]}",
        )

    return shape


def _number(
    least: float | None = None, above: float | None = None, most: float | None = None
) -> Shape:
    def shape(value: Any, where: str) -> None:
        _must(
            isinstance(value, (int, float)) and not isinstance(value, bool),
            value,
            where,
            "be a number",
        )
        _must(least is None or value >= least, value, where, f"be at least {least}")
        _must(above is None or value > above, value, where, f"be above {above}")
        _must(most is None or value <= most, value, where, f"be at most {most}")

    return shape


def _object(required: Mapping[str, Shape], optional: Mapping[str, Shape] | None = None) -> Shape:
    shapes = {**required, **(optional or {})}

    def shape(value: Any, where: str) -> None:
        _must(isinstance(value, dict), value, where, "be an object")
        for key in required:
            _must(key in value, value, where, f"have {key}")
        for key, one in value.items():
            _must(key in shapes, value, where, f"not have {_shown(key)}")
            shapes[key](one, f"{where}.{key}" if where else key)

    return shape


def _objects(every: Shape) -> Shape:
    """Return the shape of an object with any names, of whose values each has a shape."""

    def shape(value: Any, where: str) -> None:
        _must(isinstance(value, dict), value, where, "be an object")
        for key, one in value.items():
            every(one, f"{where}.{_shown(key)}")

    return shape


def _list(every: Shape) -> Shape:
    def shape(value: Any, where: str) -> None:
        _must(isinstance(value, list), value, where, "be a list")
        for number, one in enumerate(value):
            every(one, f"{where}[{number}]")

    return shape


def _ball(value: Any, where: str) -> None:
    _list(_text())(value, where)
    _must(len(value) == 2, value, where, "have a midpoint and a radius")
    _text("-?[0-9]+([.][0-9]+)?(e-?[0-9]+)?")(value[0], f"{where}[0]")
    _text("[0-9]+(e-?[0-9]+)?")(value[1], f"{where}[1]")


def _count(value: Any, where: str) -> None:
    whole = isinstance(value, (int, float)) and not isinstance(value, bool) and value % 1 == 0
    _must(whole and value >= 0, value, where, "be a whole number, at least 0")


STEEPEST = 1.5707963267948966
"""The greatest double below π/2."""


def _of_hoop(numbers: Mapping[str, Shape], rolling_resistance: str) -> Shape:
    friction, others = (
        {"mu_s": _number(0), "mu_k": _number(0)},
        {"slope": _number(-STEEPEST, most=STEEPEST), rolling_resistance: _number(0)},
    )
    impacts = {
        "restitution": _number(0, most=1),
        "restitution_law": _one_of("energetic", "poisson", "newton"),
    }
    plain, bouncing = (
        _object({**numbers, **friction}, others),
        _object({**numbers, **friction, **impacts}, others),
    )

    def shape(value: Any, where: str) -> None:
        (bouncing if isinstance(value, dict) and impacts.keys() & value.keys() else plain)(
            value, where
        )

    return shape


_HOOPS = {
    "dimensionless": _of_hoop(
        {"mass_ratio": _number(0), "offset": _number(0, most=1), "inertia": _number(0)},
        "rolling_resistance",
    ),
    "si": _of_hoop(
        {
            "disc_mass_kg": _number(0),
            "particle_mass_kg": _number(above=0),
            "radius_m": _number(above=0),
            "offset_m": _number(0),
            "inertia_kg_m2": _number(0),
            "gravity_m_per_s2": _number(above=0),
        },
        "rolling_resistance_m",
    ),
}


def _case(value: Any, where: str) -> None:
    start = {"theta": _number(), "theta_rate": _number(), "slip": _number(), "gap_rate": _number(0)}
    units = _one_of(*_HOOPS)
    until = (
        _one_of(None)
        if isinstance(value, dict) and value.get("until") is None
        else _number(above=0)
    )
    if isinstance(value, dict) and "units" in value:
        units(value["units"], f"{where}.units" if where else "units")
    hoop = (
        _HOOPS[value["units"]]
        if isinstance(value, dict) and "units" in value
        else _objects(_text())
    )
    names = {"name": _text(), "family": _text(), "units": units}
    _object({**names, "hoop": hoop, "start": _object(start), "until": until})(value, where)


_MODES = (
    "rolling",
    "sliding",
    "gliding",
    "flight",
    "skidding",
    "rest",
    "inconsistent",
    "ambiguous",
)
_MODE = _one_of(*_MODES)
_DIRECTION = _one_of(-1, 0, 1)
_ROTATION = {"rotation": _DIRECTION}
_BALLS = _objects(_ball)
_CERTIFICATE: dict[str, Shape] = {
    "format": _one_of("littlewood-certificate"),
    "version": _one_of(2),
    "certified": _one_of(True, False),
    "case": _case,
    "digest": _text("[0-9a-f]{64}"),
}
_MOTION: dict[str, Shape] = {
    "initial": _object({"mode": _MODE, "direction": _DIRECTION, "evidence": _BALLS}, _ROTATION),
    "phases": _list(
        _object({"mode": _MODE, "direction": _DIRECTION, "samples": _list(_BALLS)}, _ROTATION)
    ),
    "events": _list(
        _object(
            {
                "cause": _text(),
                "to": _one_of(*_MODES, None),
                "direction": _DIRECTION,
                "state": _BALLS,
                "evidence": _BALLS,
            },
            {
                "impact": _object(
                    {
                        "case": _text(),
                        "normal_impulse": _ball,
                        "friction_impulse": _ball,
                        "energy_lost": _ball,
                    },
                    {"before": _BALLS},
                ),
                **_ROTATION,
            },
        )
    ),
    "end": _object(
        {"kind": _text()},
        {
            "state": _BALLS,
            "half_swings": _count,
            "recurrence": _one_of("rest", "libration", "rotation"),
            "period": _ball,
        },
    ),
    "energy": _object(
        {"start": _ball, "lost_in_slides": _ball, "lost_in_impacts": _ball},
        {"lost_in_rolling_resistance": _ball},
    ),
}


def valid(certificate: Any) -> None:
    """Refuse what has not the shape of a certificate, as truth/certificate.schema.json has it."""
    certified = isinstance(certificate, dict) and certificate.get("certified") is True
    _object(_CERTIFICATE | (_MOTION if certified else {"reason": _text()}))(
        certificate, "certificate"
    )


def valid_case(case: Any, where: str = "") -> None:
    """Refuse a case out of bounds, or with a number that is not the shortest text of its double."""
    _case(case, where)
    hoop, start, dot = case["hoop"], case["start"], f"{where}." if where else ""
    numbers = [("hoop." + key, value) for key, value in hoop.items() if key != "restitution_law"]
    numbers += [("start." + key, value) for key, value in start.items()] + [
        ("until", case["until"])
    ]
    for key, value in numbers:
        finite = value is None or (abs(value) <= sys.float_info.max and float(value) == value)
        _must(finite, value, dot + key, "be finite, and exactly a double")
        if isinstance(value, Written):
            double = float.__repr__(value)
            _must(
                value.text == double,
                value,
                dot + key,
                f"be written {double}, the shortest text of its double",
            )
    mass, own, offset, radius = (
        (hoop["disc_mass_kg"], hoop["inertia_kg_m2"], hoop["offset_m"], hoop["radius_m"])
        if case["units"] == "si"
        else (hoop["mass_ratio"], hoop["inertia"], hoop["offset"], 1)
    )
    names = {"si": ("offset_m", "inertia_kg_m2"), "dimensionless": ("offset", "inertia")}[
        case["units"]
    ]
    _must(offset <= radius, offset, f"{dot}hoop.{names[0]}", f"be at most the radius, {radius}")
    _must(
        hoop["mu_k"] <= hoop["mu_s"],
        hoop["mu_k"],
        f"{dot}hoop.mu_k",
        f"be at most mu_s = {hoop['mu_s']}",
    )
    _must(
        (mass == 0) == (own == 0),
        own,
        f"{dot}hoop.{names[1]}",
        f"be 0 if the mass of the hoop, {mass}, is, and else not",
    )
    if mass == 0:
        _must(
            offset == radius,
            offset,
            f"{dot}hoop.{names[0]}",
            f"be the radius, {radius}: the hoop has no mass",
        )
        _must(
            start["gap_rate"] == 0,
            start["gap_rate"],
            f"{dot}start.gap_rate",
            "be 0: the hoop has no mass",
        )
        slope = hoop.get("slope", 0)
        _must(slope == 0, slope, f"{dot}hoop.slope", "be 0: the hoop has no mass")


class Written(float):
    """A number of JSON that shows itself as the file writes it.

    Other texts read as the same double.
    """

    def __new__(cls, text: str) -> Written:
        """Read the text."""
        found = super().__new__(cls, text)
        found.text = text
        return found

    text: str

    def __repr__(self) -> str:
        return self.text


def read(text: bytes | str) -> Any:
    """Read JSON strictly: no names twice, no NaN, and other numbers than integers with texts.

    Raises
    ------
    Unreadable
        With the reason.
    """

    def once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        found = dict(pairs)
        if len(found) != len(pairs):
            raise Unreadable("a name stands twice in an object")
        return found

    def never(name: str) -> Any:
        raise Unreadable(f"{name} is no number of JSON")

    try:
        decoded = text if isinstance(text, str) else text.decode()
        return json.loads(
            decoded,
            object_pairs_hook=once,
            parse_constant=never,
            parse_float=Written,
            # An integer would lose the sign of -0.
            parse_int=lambda digits: Written(digits) if digits == "-0" else int(digits),
        )
    except RecursionError:
        raise Unreadable("objects and lists lie too deep in each other") from None
    except ValueError as error:
        raise Unreadable(f"this is no JSON: {error}") from None


# What a case says, as ranges.

LOSSES = ("lost_in_slides", "lost_in_impacts", "lost_in_rolling_resistance")
"""Energies that a motion loses; the last one with rolling resistance only."""


class Given:
    """The body, the start, the law of restitution, where to stop, and the unit of each number."""

    def __init__(self, case: Mapping[str, Any]) -> None:
        hoop, start, of = case["hoop"], case["start"], Range.of
        if case["units"] == "si":
            mass, length, gravity = (
                Fraction(hoop[k]) for k in ("particle_mass_kg", "radius_m", "gravity_m_per_s2")
            )
            ratio, offset = (
                Fraction(hoop["disc_mass_kg"]) / mass,
                Fraction(hoop["offset_m"]) / length,
            )
            own = Fraction(hoop["inertia_kg_m2"]) / (mass * length * length)
        else:
            mass = length = gravity = Fraction(1)
            ratio, offset, own = (Fraction(hoop[k]) for k in ("mass_ratio", "offset", "inertia"))
        m = 1 + ratio
        h = offset / m
        # About the mass centre: the hoop at the distance h, the particle at the distance ℓ − h.
        inertia = own + ratio * h**2 + (offset - h) ** 2
        self.level = hoop.get("slope", 0) == 0
        back, down = sine_and_cosine(of(Fraction(hoop.get("slope", 0))))
        mu_s, mu_k = (of(Fraction(hoop[name])) for name in ("mu_s", "mu_k"))
        chi = Fraction(hoop.get("rolling_resistance", 0))
        if case["units"] == "si":
            chi = Fraction(hoop.get("rolling_resistance_m", 0)) / length
        self.body = Body(of(m), of(h), of(inertia), of(offset), mu_s, mu_k, down, back, of(chi))
        self.resists = chi != 0
        self.massless = ratio == 0 and own == 0
        # What rolls without friction.
        self.balanced, self.equal = offset == 0 and self.level, hoop["mu_s"] == hoop["mu_k"]
        self.restitution = (
            None if hoop.get("restitution") is None else of(Fraction(hoop["restitution"]))
        )
        self.law = hoop.get("restitution_law")
        self.clock = of(length / gravity).sqrt()
        speed = of(length * gravity).sqrt()
        self.until = None if case["until"] is None else of(Fraction(case["until"])) / self.clock
        zero = Range(0)
        self.start = State(
            zero,
            of(Fraction(start["theta"])),
            of(Fraction(start["theta_rate"])) * self.clock,
            of(Fraction(start["slip"])) / speed,
            zero,
            zero,
            of(Fraction(start["gap_rate"])) / speed,
        )
        self.scale = {"time": self.clock, "period": self.clock, "theta_rate": 1 / self.clock}
        self.scale |= dict.fromkeys(("slip", "gap_rate"), speed) | dict.fromkeys(
            ("x", "gap"), of(length)
        )
        self.scale |= dict.fromkeys(("normal", "friction"), of(mass * gravity))
        self.scale |= dict.fromkeys(("normal_impulse", "friction_impulse"), of(mass) * speed)
        energies = ("energy", "energy_lost", "start", "couple", *LOSSES)
        self.scale |= dict.fromkeys(energies, of(mass * gravity * length))


# The phases: for each kind of motion the equation of θ, its guards, and the state that belongs to
# θ, θ′ and a time.
#
# | phase | θ″ | guards: it lasts while they are positive |
# |---|---|---|
# | rolling | (ℓ s (cos α + ω²) + (m + ℓ c) sin α)/D | μs N − F, μs N + F |
# | rolling, massless | the same | 1 − ω² (the sign of N), μs (1 + c) ± (s − ς χ) |
# | sliding | m q w/P | σ η′, w, P (N = m Î w/P) |
# | gliding | w/(h s) | σ η′, until the particle falls to the plane (:func:`fall`) |
# | flight | 0 | the gap |
# | skidding | 0 | σ η′ |
#
# With rolling resistance all phases that turn on the plane have ς θ′ for one more guard, and a hoop
# that rests has none: it rests for ever.
#
# Slip and place are no further unknowns. A slide has m x̄″ = −σ μk N − m sin α, N = m (ȳ″ + cos α);
# so with f = σ μk of a slide, else 0, and d = f cos α + sin α,
#
#     η′ = ω (1 + h c + f h s) − d τ + const,    x = h s − f (1 + h c) − d τ²/2 + const τ + const.


ROLLING, SLIDING, GLIDING, FLIGHT = "rolling", "sliding", "gliding", "flight"
SKIDDING, REST = "skidding", "rest"
SLIP, CONTACT, SOLVABLE, GAP, NORMAL = "slip", "contact", "solvability", "gap", "normal"
UP, DOWN = "margin_positive", "margin_negative"
PLANE, TIME, TURNING = "particle_at_plane", "time_limit", "turning_point"


class Phase:
    """A phase from a state on; its slip or its gap begins with a zero of the order given."""

    def __init__(
        self,
        given: Given,
        start: State,
        mode: str,
        sigma: int = 0,
        order: int = 0,
        rotation: int = 0,
    ) -> None:
        self.body, self.massless, self.start, self.mode = given.body, given.massless, start, mode
        self.sigma, self.order, self.rotation = sigma, order, rotation
        # Where it begins to turn, θ′ has a simple zero.
        self.turning_order = 1 if start.rate.is_zero() else 0
        self.rubs = sigma if mode in (SLIDING, SKIDDING) else 0
        self.drag = given.body.drag(self.rubs)
        self.sin, self.cos = s, c = sine_and_cosine(start.theta)
        body, omega = self.body, start.rate
        f = body.mu_k * self.rubs
        self.slip_constant = start.slip - omega * body.arm(s, c, self.rubs)
        self.along = start.slip - (1 + body.h * c) * omega - f * body.h * s * omega
        self.place = start.x - body.h * s + f * (1 + body.h * c)
        self.rise = start.gap_rate - body.h * s * omega
        self.in_discs = body.converted(around)

    def acceleration(self, body: Body, s: Value, c: Value, omega: Value) -> Value:
        """Return θ″ for numbers of any kind."""
        if self.mode == ROLLING:
            return body.rolling(s, c, omega, self.rotation)
        if self.mode == SLIDING:
            return body.sliding(s, c, omega, self.sigma, self.rotation)
        return body.gliding(s, c, omega)

    def guards(
        self,
        body: Body,
        angle: tuple[Value, Value, Value],
        alpha: Value,
        tau: Value,
        slip_constant: Value,
    ) -> dict[str, Value]:
        """Return the guards for numbers of any kind.

        At sin θ, cos θ, θ′, at θ″ and a time from the start.
        """
        s, c, omega = angle
        turns = {TURNING: omega * self.rotation} if self.rotation else {}
        if self.mode == ROLLING and self.massless:
            # F/N = −(s − ς χ)/(1 + c), and N has the sign of 1 − ω²: where N vanishes F does, too.
            grip, need = body.mu_s * (1 + c), s
            if self.rotation:
                need = s - body.chi * self.rotation
            return {NORMAL: 1 - omega * omega, UP: grip + need, DOWN: grip - need} | turns
        if self.mode == ROLLING:
            normal, friction = body.forces(s, c, omega, alpha)
            margins = {UP: body.mu_s * normal - friction, DOWN: body.mu_s * normal + friction}
            return margins | turns
        found = {SLIP: self._slip(body, angle, tau, slip_constant) * self.sigma}
        if self.mode == SLIDING:
            solvable = body.solvability(s, c, self.sigma, self.rotation)
            found |= {CONTACT: body.weight(c, omega), SOLVABLE: solvable}
        return found | turns

    def _slip(
        self, body: Body, angle: tuple[Value, Value, Value], tau: Value, constant: Value
    ) -> Value:
        s, c, omega = angle
        return omega * body.arm(s, c, self.rubs) - body.drag(self.rubs) * tau + constant

    def state(self, tau: Range, theta: Range, omega: Range) -> State:
        """Return the state at a time from the start."""
        body, start = self.body, self.start
        s, c = sine_and_cosine(theta)
        gap = gap_rate = Range(0)
        if self.mode == ROLLING:
            slip, x = Range(0), start.x - (theta - start.theta)
        else:
            f = body.mu_k * self.rubs
            slip = self._slip(body, (s, c, omega), tau, self.slip_constant)
            x = (
                self.place
                + self.along * tau
                + body.h * s
                - f * (1 + body.h * c)
                - self.drag * (tau * tau / 2)
            )
        if self.mode == FLIGHT:
            # The mass centre is thrown. What sin and cos grow by, without the radius of the angle.
            half, _ = sine_and_cosine(omega * tau / 2)
            s, c = sine_and_cosine(start.theta + omega * tau / 2)
            sin_grows, cos_grows = 2 * half * c, -(2 * half * s)
            slip = start.slip + body.h * cos_grows * omega - body.back * tau
            x = start.x + self.along * tau + body.h * sin_grows - body.back * (tau * tau / 2)
            gap = self.thrown(tau) - body.h * cos_grows
            gap_rate = start.gap_rate - body.down * tau + body.h * sin_grows * omega
        return State(start.time + tau, theta, omega, slip, x, gap, gap_rate)

    def thrown(self, tau: Range) -> Range:
        """Return how far the mass centre has risen from the plane in a flight."""
        risen: Range = self.rise * tau - self.body.down * (tau * tau / 2)
        return risen

    def forces(self, state: State) -> tuple[Range, Range]:
        """Return N and F at a state of the phase."""
        if self.mode in (GLIDING, FLIGHT):
            return Range(0), Range(0)
        body, (s, c), omega = self.body, sine_and_cosine(state.theta), state.rate
        if self.mode == ROLLING:
            return body.forces(s, c, omega, body.rolling(s, c, omega, self.rotation))
        if self.mode == REST:
            return body.m * body.down, body.m * body.back
        normal: Range = body.m * body.down
        if self.mode == SLIDING:
            normal = body.normal(s, c, omega, self.sigma, self.rotation)
        return normal, -(body.mu_k * normal) * self.sigma

    def couple(self, state: State, forces: tuple[Range, Range]) -> Range:
        """Return the couple of rolling resistance: what keeps the angle where it does not turn."""
        (normal, friction), body = forces, self.body
        if self.mode in (SKIDDING, REST):
            s, c = sine_and_cosine(state.theta)
            arms: Range = body.h * s * normal + (1 + body.h * c) * friction
            return -arms
        resisted: Range = body.chi * self.rotation * normal
        return -resisted


def energy(body: Body, state: State) -> Range:
    """Return kinetic and potential energy, of the mass centre and about it."""
    s, c = sine_and_cosine(state.theta)
    along = state.slip - state.rate - body.h * c * state.rate
    up = state.gap_rate - body.h * s * state.rate
    kinetic: Any = body.m * (along * along + up * up) + body.inertia * state.rate * state.rate
    up, ahead = body.m * state.gap + body.offset * c, body.m * state.x - body.offset * s
    found: Range = kinetic / 2 + body.down * up + body.back * ahead
    return found


def fall(start: State, sigma: int) -> State | None:
    """Return the end of a glide in which the particle falls to the plane.

    Its slip does not come to rest before.

    Y = cos θ falls freely with V = Y′, and η′ = v − side V √((1 + Y)/(1 − Y)), whose last term is
    at most r √((1 + Y0)/(1 − Y0)) from here on, r the speed at the plane.
    """
    s, c = sine_and_cosine(start.theta)
    falls = s * start.rate
    if not exceeds(falls, 0) or float(c) > -0.5:
        return None
    r = (falls * falls + 2 * (1 + c)).sqrt()
    drift = start.slip - (1 + c) * start.rate
    if not exceeds(drift * sigma, r * ((1 + c) / (1 - c)).sqrt()):
        return None
    time = r - falls
    turns = round(float(start.theta) / 6.283185307179586)
    theta = pi() * (2 * turns + s.sign())
    return replace(
        start,
        time=start.time + time,
        theta=theta,
        rate=Range(0),
        slip=drift,
        x=start.x + drift * time - s,
    )


# Guards, and their zeros: what stays positive as long as a phase lasts.
#
# A guard is a polynomial in s, 0 ≤ s ≤ 1, and a bound on what it leaves out. A zero of known order
# at the start of a phase has been divided out of it.

Interval: TypeAlias = tuple[Range, Range]
"""Two places in a step."""


@dataclass(frozen=True)
class Guard:
    """A function of s: its polynomial, and how far it is off at most, itself and its derivative."""

    coefficients: list[Range]
    off: Range
    slope_off: Range

    def value(self, s: Range) -> Range:
        """Enclose the value."""
        return at(reversed(self.coefficients), s).widened(self.off)

    def slope(self, low: Range, high: Range) -> Range:
        """Enclose the derivative between two points.

        In the middle, and the second derivative by its coefficients.
        """
        numbered = list(enumerate(self.coefficients))
        middle, half = (low + high) / 2, ((high - low) / 2).largest()
        first = at((one * k for k, one in reversed(numbered[1:])), middle)
        second = at(
            (one.largest() * (k * (k - 1)) for k, one in reversed(numbered[2:])), high.largest()
        )
        return first.widened((second * half).largest()).widened(self.slope_off)

    def integral(self, last: Range) -> Range:
        """Enclose the integral from 0 to a point."""
        numbered = list(enumerate(self.coefficients))
        found = at((one / (k + 1) for k, one in reversed(numbered)), last) * last
        return found.widened((self.off * last).largest())

    def between(self, low: Range, high: Range) -> Range:
        """Enclose the values between two points."""
        middle, half = (low + high) / 2, ((high - low) / 2).largest()
        return self.value(middle).widened((self.slope(low, high).largest() * half).largest())


def first_zero(guards: Mapping[str, Guard]) -> tuple[list[Interval], tuple[str, Range] | None]:
    """Return where in a step all guards are positive, and the first zero of one, if there is one.

    The intervals are taken in order, and each is left only with a proof: every guard is enclosed
    and positive there, or monotone and positive at both ends; or all but one are, and that one
    falls and changes its sign.
    """
    free: list[Interval] = []
    work = [(Range(0), Range(1 << Range.bits))]
    while work:
        low, high = work.pop()
        doubtful: dict[str, bool] = {}
        for name, guard in guards.items():
            if exceeds(guard.between(low, high), 0):
                continue
            slope, first, last = guard.slope(low, high), guard.value(low), guard.value(high)
            falls, rises = exceeds(0 - slope, 0), exceeds(slope, 0)
            if (falls or rises) and exceeds(first, 0) and exceeds(last, 0):
                continue
            doubtful[name] = falls and exceeds(first, 0) and exceeds(0 - last, 0)
        if not doubtful:
            free.append((low, high))
            continue
        name = next(iter(doubtful))
        if len(doubtful) == 1 and doubtful[name]:
            return free, (name, zero(guards[name], low, high, 1))
        work += _halves(low, high, f"whether {' or '.join(doubtful)} vanishes is not decided")
    return free, None


def _halves(low: Range, high: Range, unless: str) -> list[Interval]:
    """Return both halves, the first last."""
    if (high - low).m < 1 << (Range.bits // 4):
        raise Inconclusive(unless)
    middle = Range((low.m + high.m) // 2)
    return [(middle, high), (low, middle)]


def zero(guard: Guard, low: Range, high: Range, side: int) -> Range:
    """Return the one zero of a guard between two points.

    At the first it has the sign `side`.

    Bisection until the slope has one sign, then Newton's method on enclosures, with bisection where
    it does not narrow them.
    """
    while not exceeds(0 - guard.slope(low, high) * side, 0):
        after, before = _halves(low, high, "a zero is not simple")
        low, high = after if guard.value(after[0]).sign() == side else before
    while True:
        width = high.m - low.m
        middle = Range((low.m + high.m) // 2)
        found = middle - guard.value(middle) / guard.slope(low, high)
        low, high = Range(max(found.m - found.r, low.m)), Range(min(found.m + found.r, high.m))
        if low.m > high.m:
            raise Inconclusive("a zero is not where it has to be")
        if 2 * (high.m - low.m) > width:
            middle = Range((low.m + high.m) // 2)
            value = guard.value(middle) * side
            if exceeds(value, 0):
                low = middle
            elif exceeds(0 - value, 0):
                high = middle
            else:
                return Range(middle.m, (high.m - low.m) // 2 + 1)


# A step of a phase on the plane: Taylor's series of θ in time, with a proof of how far it is off.
#
# *How large.* If |θ″| ≤ M as long as |θ′(z) − θ′| ≤ b and |z| ≤ ρ, and M ρ ≤ b, the solution exists
# on that disc of the complex plane and stays within these bounds (Picard), which bound its
# coefficients (Cauchy). The step goes to ρ/8, so that what n terms leave out is bounded by 8⁻ⁿ.
#
# *How far apart.* The series is that of the middle of the start. Where the derivatives of θ″ by θ
# and θ′ are at most a and b, the distances of another solution from it grow at most as those of
# δθ′ = δω, δω′ = a δθ + b δω.


SHARE = 8
"""Radius of the disc over the length of the step."""


_TERMS = 80
"""Terms of the series of how far solutions part."""


@dataclass(frozen=True)
class Apart:
    """How far solutions are apart, in last bits."""

    theta: float
    rate: float

    def after(self, time: float, alpha: Disc) -> Apart:
        """Return the same after a time t: the exponential series of the matrix M of the distances.

        Where s ≥ 1 and s² ≥ a + b s, M takes (1, s) to at most s (1, s). So in the norm max(|δθ|,
        |δω|/s) the term of the order k is at most s t/k of the one before, and if s t ≤ n/2 all
        from the n-th on are less than that one.
        """
        a, b = alpha.by_theta, alpha.by_rate
        fastest = max(1.0, 1.000001 * (b + math.sqrt(b * b + 4 * a)) / 2)
        if not fastest * time <= _TERMS / 2:
            raise Inconclusive("solutions part too fast")
        theta, rate = self.theta, self.rate
        all_theta, all_rate = theta, rate
        for k in range(1, _TERMS):
            theta, rate = rate * time / k, (a * theta + b * rate) * time / k
            all_theta, all_rate = all_theta + theta, all_rate + rate
        if not (all_theta < 1e280 and all_rate < 1e280):
            raise Inconclusive("solutions part too far")
        rest = max(theta, rate / fastest)
        # What is left out, and rounding.
        return Apart(all_theta * (1 + 1e-12) + rest, all_rate * (1 + 1e-12) + rest * fastest)

    @property
    def as_number(self) -> float:
        """A bound of both."""
        return math.ldexp(max(self.theta, self.rate) + 1, -Range.bits) * 1.001


class Step:
    """A step from θ and θ′ at a time of a phase, to ρ/8 or to an end."""

    def __init__(
        self, phase: Phase, tau: Range, theta: Range, rate: Range, guess: float, end: Range | None
    ) -> None:
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
        self.theta_series, self.rate_series, self.angle, self.alpha = (
            theta,
            omega,
            (s, c, omega),
            alpha,
        )
        # Within the step the disc is smaller, and so is the distance.
        near = self.rho / SHARE * 1.000001
        spread = self._spread(near)
        if spread is None:
            raise Inconclusive("the step is too short")
        parted = self.apart.after(
            near, self._acceleration(angle_and_rate(*self._region(near, spread)))
        )
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
        series = phase.guards(
            phase.body, self.angle, self.alpha, line(self.tau, self.length), phase.slip_constant
        )
        tau, constant = (around(*one) for one in ((self.tau, self.rho), (phase.slip_constant,)))
        sizes = phase.guards(phase.in_discs, angle, self._acceleration(angle), tau, constant)
        orders = {SLIP: phase.order, TURNING: phase.turning_order} if self.tau.is_zero() else {}
        return {
            name: self._guard(series[name], sizes[name], orders.get(name, 0)) for name in series
        }

    def rubbed(self, last: Range) -> Range:
        """Return the energy that friction of a slide takes up to a place in the step.

        It is the integral of μk N |η′|.
        """
        phase, sigma, rotation = self.phase, self.phase.sigma, self.phase.rotation

        def power(body: Body, angle: tuple[Value, Value, Value], slip: Value) -> Value:
            return body.normal(*angle, sigma, rotation) * slip * body.mu_k

        # The guard of slip, before its zero is divided out.
        tau, constant = (around(*one) for one in ((self.tau, self.rho), (phase.slip_constant,)))
        series = phase.guards(
            phase.body, self.angle, self.alpha, line(self.tau, self.length), phase.slip_constant
        )[SLIP]
        size = phase.guards(
            phase.in_discs, self._angle, self._acceleration(self._angle), tau, constant
        )[SLIP]
        whole = self._guard(
            power(phase.body, self.angle, series), power(phase.in_discs, self._angle, size), 0
        )
        return whole.integral(last) * self.length

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

        A function with a zero of order k where s = 0, over s^k, is at most as large as where |s| =
        base, over base^k; so is what the middle of the start changes, in which lower coefficients
        have to be left out.
        """
        coefficients = [series[k] for k in range(self.terms)]
        off = on_disc.by_theta * self._parted.theta + on_disc.by_rate * self._parted.rate
        off += sum(
            float(one.largest().m) * self.base**k for k, one in enumerate(coefficients[:order])
        )
        apart, rest = int(off / self.base**order * 1.001) + 1, self._rest(on_disc.size)
        return Guard(
            coefficients[order:], Range(apart + rest), Range(apart + rest * 2 * self.terms)
        )

    def _rest(self, size: float) -> int:
        """Return what n terms leave out of a function of this size where |z| ≤ ρ, in last bits."""
        return (
            int(
                1.2
                * 2.0 ** (Range.bits + math.log2(size + 1e-30) - self.terms * math.log2(self.base))
            )
            + 1
        )


class SkidStep:
    """A whole skid: its slip is a line in time."""

    def __init__(self, phase: Phase, end: Range | None) -> None:
        self.phase, self.tau = phase, Range(0)
        slows = phase.drag * phase.sigma
        if slows.sign() > 0:
            # A little beyond, so that it covers the end.
            length = abs(phase.start.slip) / slows * 2 + Range(1)
            end = length if end is None or exceeds(end, length) else end
        if end is None:
            raise TooLong("a skid never ends")
        self.length = end.largest() + Range(1)

    def moment(self, s: Range) -> tuple[Range, Range, Range]:
        """Return time, θ and θ′ at a place in the step."""
        return self.length * s, self.phase.start.theta, Range(0)

    @cached_property
    def guards(self) -> dict[str, Guard]:
        """The slip, without its zero at the start."""
        phase = self.phase
        line = [phase.start.slip * phase.sigma, -(phase.drag * self.length) * phase.sigma]
        return {SLIP: Guard(line[phase.order :], Range(1), Range(1))}


# A step of a flight.
#
# θ′ is constant, and the gap y = (y′ − h s ω) τ − g τ²/2 − h (cos(θ + ω τ) − cos θ), g = cos α, has
# a series that is known. A fast hoop turns many times in a flight; while (y′ − h s ω) τ − g τ²/2 >
# h (1 − cos θ) it does not land, and one step leaps over this.


class FlightStep:
    """A step from a time of a flight on.

    The flight begins with a zero of the gap of the order of the phase.
    """

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
        self.leaps = self._leap()
        if end is not None and exceeds(self.length, end - tau):
            # A little beyond, so that it covers the end.
            self.length = (end - tau).largest() + Range(1)

    def _leap(self) -> bool:
        """Whether the mass centre is too high for a landing, and stays so for long.

        Then make the step so long.
        """
        phase, tau = self.phase, float(self.tau)
        rise, least, g = (
            float(phase.rise),
            float(phase.body.h * (2 - phase.cos)),
            float(phase.body.down),
        )
        if rise * tau - g * tau * tau / 2 <= least:
            return False
        # Where the bound falls to least again: a little more than the h (1 − cos θ) that is needed.
        length = (rise + math.sqrt(max(0.0, rise * rise - 2 * g * least))) / g - tau
        if length < 4 * float(self.length):
            return False
        self.length = Range.of(Fraction(length))
        return True

    def moment(self, s: Range) -> tuple[Range, Range, Range]:
        """Return time, θ and θ′ at a place in the step."""
        start, tau = self.phase.start, self.tau + self.length * s
        return tau, start.theta + start.rate * tau, start.rate

    @cached_property
    def guards(self) -> dict[str, Guard]:
        """The gap, without its zero at the start.

        Its derivatives of order k ≥ 3 are at most h |ω|^k, and |ω| length < 1/2: what is left out
        is less than the bound of the last term.
        """
        phase, rate, order = self.phase, self.phase.start.rate, self.order
        if self.leaps:
            tau, length = self.tau, self.length
            first, down = phase.thrown(tau) - phase.body.h * (1 - phase.cos), phase.body.down
            falls = [(phase.rise - down * tau) * length, -(down * (length * length / 2))]
            return {GAP: Guard([first, *falls], Range(0), Range(0))}
        now = phase.state(*self.moment(Range(0)))
        sin, cos = sine_and_cosine(now.theta)
        derivative = (cos, -sin, -cos, sin)
        turn, half = rate * self.length, Range(1 << Range.bits - 1)
        scale = power = 2 * half
        found: list[Range] = []
        k = 0
        while k < 5 or exceeds(power.largest(), Range(64)):
            if k:
                # ω^k/k!, and a length for each order beyond that of the zero.
                power = power * (turn if k > order else rate) / k
            if k > order:
                scale = scale * self.length
            term = (
                (now.gap, now.gap_rate)[k] * scale
                if k < 2
                else -(phase.body.h * derivative[k % 4] * power)
            )
            found += (
                [term - half * scale * phase.body.down if k == 2 else term] if k >= order else []
            )
            k += 1
        last = power.largest()
        return {GAP: Guard(found, last + Range(1), last * (2 * k) + Range(1))}

    def landing_rate(self, s: Range) -> Range:
        """Return y′ where y = 0, in a step that begins with y = 0.

        It is less 2 y/τ, so that no radius doubles.
        """
        gap = self.guards[GAP]
        terms = [gap.coefficients[k] * (k - 1) for k in range(len(gap.coefficients) - 1, 1, -1)]
        return (at(terms, s) * s * s - self.phase.start.gap_rate).widened(gap.slope_off)


# A phase followed to its end, step by step: no guard has a zero before.


AnyStep: TypeAlias = "Step | FlightStep | SkidStep"


@dataclass(frozen=True)
class Turn:
    """Rolling that repeats itself after a time, turned by an angle."""

    period: Range
    angle: Range


_MOST_OF_A_GLIDE = 1000
"""Steps up to the last sample of a glide: they shrink with the distance from its end."""


@dataclass
class Followed:
    """A phase: its steps, what vanishes at its end, and the state there.

    Without an end it rolls for ever.
    """

    phase: Phase
    steps: list[AnyStep] = field(default_factory=list)
    free: list[list[Interval]] = field(default_factory=list)
    """For each step the intervals on which all guards are positive."""
    guard: str = ""
    end: State | None = None
    turn: Turn | None = None

    def _steps(self) -> Iterator[AnyStep]:
        """Yield the steps, and more of a glide whose end is known before it is reached."""
        yield from self.steps
        while self.guard == PLANE and len(self.steps) < _MOST_OF_A_GLIDE:
            last = self.steps[-1]
            assert isinstance(last, Step)
            tau, theta, rate = last.moment(Range(1 << Range.bits))
            self.steps.append(Step(self.phase, tau, theta, rate, last.rho * 1.2, None))
            yield self.steps[-1]

    def at(self, time: Range) -> State:
        """Return the state at a time."""
        start = self.phase.start
        if not self.steps:
            return replace(start, time=time)
        tau, count = time - start.time, 0
        if self.turn is not None:
            count = int(float(tau) / float(self.turn.period))
            tau = tau - self.turn.period * count
        for step in self._steps():
            if not exceeds(tau - step.tau, step.length):
                found = self.phase.state(*step.moment((tau - step.tau) / step.length))
                if self.turn is None:
                    return found
                angle = self.turn.angle * count
                return replace(found, time=time, theta=found.theta + angle, x=found.x - angle)
        raise Inconclusive("a time is not within its phase")

    def rubbed(self) -> Range:
        """Return the energy that friction of a slide takes, as its power over time."""
        total, whole = Range(0), Range(1 << Range.bits)
        assert self.end is not None
        tau = self.end.time - self.phase.start.time
        for step in self.steps:
            assert isinstance(step, Step)
            last = step is self.steps[-1]
            total += step.rubbed((tau - step.tau) / step.length if last else whole)
        return total


def follow(given: Given, phase: Phase, most_steps: int) -> Followed:
    """Follow a phase to the zero of a guard, to the end of time, or until it repeats itself.

    Only rolling repeats itself.
    """
    run, start = Followed(phase), phase.start
    if phase.mode == REST:
        return run
    limit = None if given.until is None else given.until - start.time
    if (
        phase.mode == ROLLING
        and not given.resists
        and start.rate.is_zero()
        and given.level
        and (given.balanced or start.theta.is_zero())
    ):
        # It rests: below or above the centre, where rolling needs no friction.
        if given.until is not None:
            run.guard, run.end = TIME, replace(start, time=given.until)
        return run
    tau, theta, rate, guess = Range(0), start.theta, start.rate, 1.0
    turning = [Range(0)] if rate.is_zero() else []
    while len(run.steps) < most_steps:
        stop = limit if run.turn is None else run.turn.period
        step: AnyStep
        if phase.mode == FLIGHT:
            step = FlightStep(phase, tau, stop)
        elif phase.mode == SKIDDING:
            step = SkidStep(phase, stop)
        else:
            step = Step(phase, tau, theta, rate, guess, stop)
            guess = step.rho * 1.2
        run.steps.append(step)
        free, found = first_zero(step.guards)
        run.free.append(free)
        if found is not None and _before(step.moment(found[1])[0], limit):
            run.guard, run.end = found[0], _ended(phase, step, *found)
            return run
        tau, theta, rate = step.moment(Range(1 << Range.bits))
        repeats = phase.mode == ROLLING and not given.resists
        if isinstance(step, Step) and repeats and run.turn is None:
            run.turn = _turn(given, step, (theta, rate), start.theta, turning)
        if phase.mode == GLIDING:
            run.end = fall(phase.state(tau, theta, rate), phase.sigma)
            if run.end is not None and _before(run.end.time - start.time, limit):
                run.guard = PLANE
                return run
            run.end = None
        if run.turn is not None:
            if not exceeds(run.turn.period, tau):
                if given.until is not None:
                    run.guard, run.end = TIME, run.at(given.until)
                return run
        elif given.until is not None and limit is not None and not exceeds(limit, tau):
            run.guard, run.end = TIME, run.at(given.until)
            return run
    raise TooLong(f"a phase of {phase.mode} takes more than {most_steps} steps")


def _ended(phase: Phase, step: AnyStep, guard: str, s: Range) -> State:
    """Return the state where a guard vanishes: what vanishes with it is 0."""
    end = phase.state(*step.moment(s))
    if guard == SLIP:
        return replace(end, slip=Range(0))
    if guard == TURNING:
        return replace(end, rate=Range(0))
    if guard == GAP and isinstance(step, FlightStep):
        rate = step.landing_rate(s) if step.order == 1 else end.gap_rate
        return replace(end, gap=Range(0), gap_rate=rate)
    return end


def _before(tau: Range, limit: Range | None) -> bool:
    """Whether a time comes before the limit."""
    return limit is None or (limit - tau).sign() > 0


def _turn(
    given: Given, step: Step, ahead: tuple[Range, Range], first: Range, turning: list[Range]
) -> Turn | None:
    """Return period and angle once rolling has repeated itself.

    After a turn, or with the second turning point.
    """
    theta, rate = ahead
    low, high = Range(0), Range(1 << Range.bits)
    if not given.balanced and not step.rate.is_zero() and step.rate.sign() * rate.sign() < 0:
        s = zero(step.rate_guard(), low, high, step.rate.sign())
        turning.append(step.moment(s)[0])
        if len(turning) == 2:
            return Turn((turning[1] - turning[0]) * 2, Range(0))
    whole = 2 * pi()
    if given.level and not turning and exceeds(abs(theta - first), whole):
        side = rate.sign()
        s = zero(step.angle_guard(first + whole * side), low, high, -side)
        return Turn(step.moment(s)[0], whole * side)
    return None


# Which motion follows (docs/theory/contact.md): each is held against its conditions, and one has to
# be left.
#
# With w, P and the forces N and F of rolling: where the contact slips towards σ it slides if w > 0
# and P > 0, flies if w < 0 and P > 0, no motion is consistent if w > 0 > P and two are if both are
# negative. At rest *rolling* needs N > 0 and |F| < μs N; *sliding* towards σ needs w/P > 0 and σ
# η″ > 0, that is −(σ F + μk N) P > 0, and is left out where rolling is consistent; *flight* needs
# w < 0.


INCONSISTENT, AMBIGUOUS = "inconsistent", "ambiguous"


@dataclass(frozen=True)
class Next:
    """What follows, and the numbers that decide it.

    And the order of the zero with which its slip or its gap begins.
    """

    mode: str
    direction: int
    evidence: dict[str, Range]
    order: int = 0
    rotation: int = 0


ARRIVED = Next("", 1, {}, 0, 1)
"""What is before a motion that arrives on the plane, and held nothing."""


def decide(given: Given, state: State, gives_way: int = 0, *, before: Next | None = None) -> Next:
    """Decide what follows on the plane.

    Static friction has just given way to this direction, if it is not 0.

    Rolling and flight may both be consistent: a start, with nothing before it, is then ambiguous,
    and all else keeps its contact.
    """
    if given.resists:
        return _resisted(given, state, gives_way, before)
    body, (s, c), omega = given.body, sine_and_cosine(state.theta), state.rate
    moving = state.slip.sign()
    normal, friction = body.forces(s, c, omega, body.rolling(s, c, omega))
    forces = {"rolling_normal": normal, "rolling_friction": friction}
    if given.massless:
        return _massless(given, state, moving, forces, gives_way)
    w = body.weight(c, omega)
    evidence, presses = {"contact": w}, w.sign()
    if presses == 0:
        raise Inconclusive("w vanishes where a motion begins")
    if moving:
        p = evidence["solvability"] = body.solvability(s, c, moving)
        mode = {(1, 1): SLIDING, (-1, 1): FLIGHT, (1, -1): INCONSISTENT}.get(
            (presses, p.sign()), AMBIGUOUS
        )
        return Next(mode, moving if presses > 0 else 0, evidence, 2 if mode == FLIGHT else 0)
    evidence |= forces
    grip = body.mu_s * normal
    holds = not gives_way and normal.sign() > 0
    holds = holds and (
        given.balanced or ((grip - friction).sign() > 0 and (grip + friction).sign() > 0)
    )
    if holds and not (before is None and presses < 0):
        return Next(ROLLING, 0, evidence)
    solvable = {sigma: body.solvability(s, c, sigma) for sigma in (-1, 1)}
    evidence |= {"solvability_negative": solvable[-1], "solvability_positive": solvable[1]}
    consistent = [Next(ROLLING, 0, evidence)] if holds else []
    for sigma, p in solvable.items():
        if holds or p.sign() != presses:
            continue
        # Where static friction gives way and kinetic friction is equal, η″ = 0, and η‴ has the sign
        # of P, which is that of w.
        tie = gives_way == sigma and given.equal
        drives = p if tie else -(friction * sigma + body.mu_k * normal) * p
        if drives.sign() > 0:
            consistent.append(Next(SLIDING, sigma, evidence, 2 if tie else 1))
    if presses < 0:
        consistent.append(Next(FLIGHT, 0, evidence, 2))
    if len(consistent) == 1:
        return consistent[0]
    return Next(AMBIGUOUS if consistent else INCONSISTENT, 0, evidence)


def _massless(
    given: Given, state: State, moving: int, forces: dict[str, Range], gives_way: int
) -> Next:
    """Decide for a massless hoop: it rolls, or glides without any force."""
    if moving:
        return Next(GLIDING, moving, {})
    s, c = sine_and_cosine(state.theta)
    presses = (1 - state.rate * state.rate).sign()
    if not gives_way and presses > 0 and (given.body.mu_s * (1 + c) - abs(s)).sign() > 0:
        return Next(ROLLING, 0, forces)
    # Gliding has η″ = (1 + c) (1 − θ′²)/s.
    direction = s.sign() * presses
    if direction == 0:
        raise Inconclusive("a glide begins without any acceleration of slip")
    return Next(GLIDING, direction, forces, 1)


# Which motion follows with rolling resistance (docs/theory/rolling-resistance.md).
#
# A mode is a pair of signs, σ of the slip and ς of θ′, each 0 where it is held. Where one of them
# is 0 at the state, all three are tried: forces and couple have to obey their laws, and what begins
# has to begin with its sign. What holds more excludes what holds less.


def _resisted(given: Given, state: State, gives_way: int, before: Next | None) -> Next:
    """Decide with rolling resistance.

    Several modes are ambiguous at a start, which has nothing before it; what arrives stays in
    contact, and goes on holding what it held.
    """
    _, c = sine_and_cosine(state.theta)
    moving, turning = state.slip.sign(), state.rate.sign()
    presses, evidence = 1, {}
    # A hoop without mass stays on the plane: what does not roll glides.
    if not given.massless:
        w = evidence["contact"] = given.body.weight(c, state.rate)
        presses = w.sign()
    if presses == 0:
        raise Inconclusive("w vanishes where a motion begins")
    ways = [(moving,) if moving else (0, -1, 1), (turning,) if turning else (0, -1, 1)]
    signs = [(sigma, rotation) for sigma in ways[0] for rotation in ways[1]]
    contact = _Contact(given, state, gives_way, evidence)
    found: list[Next] = []
    for held in (2, 1, 0):
        tried = [contact.tried(*pair) for pair in signs if pair.count(0) == held]
        found = found or [one for one in tried if one is not None]
        if found:
            break
    if presses < 0 and (before is None or not found):
        found.append(Next(FLIGHT, 0, {}, 2))
    if before is not None and len(found) > 1:
        goes_on = [
            one
            for one in found
            if (one.direction == 0 == before.direction) or (one.rotation == 0 == before.rotation)
        ]
        found = goes_on or found
    if len(found) == 1:
        one = replace(found[0], evidence=evidence | found[0].evidence)
        if one.mode == ROLLING and one.evidence["rolling_solvability"].sign() < 0:
            raise Inconclusive("rolling is not stable where D is negative")
        return one
    if found:
        return Next(AMBIGUOUS, 0, evidence)
    return Next(INCONSISTENT, moving, evidence, rotation=turning)


class _Contact:
    """The modes of a state on the plane, held against their conditions one by one."""

    def __init__(
        self, given: Given, state: State, gives_way: int, evidence: dict[str, Range]
    ) -> None:
        self.given, self.state, self.gives_way, self.evidence = given, state, gives_way, evidence
        self.angle = *sine_and_cosine(state.theta), state.rate
        self.moving, self.turning = state.slip.sign(), state.rate.sign()

    def tried(self, sigma: int, rotation: int) -> Next | None:
        """Return the mode of two signs if it is consistent."""
        if rotation and sigma:
            slides = self._glides if self.given.massless else self._slides
            return slides(sigma, rotation)
        if rotation:
            return self._rolls(rotation)
        return self._skids(sigma) if sigma else self._rests()

    def _rests(self) -> Next | None:
        body, (s, c, _) = self.given.body, self.angle
        couple = body.h * s * body.down + (1 + body.h * c) * body.back
        holds = True
        for name, need, most in (
            ("rest_couple", couple, body.chi * body.down),
            ("rest_friction", body.back, body.mu_s * body.down),
        ):
            left = self.evidence[name] = most - abs(need)
            holds = holds and (need.is_zero() or left.sign() > 0)
        return Next(REST, 0, {}) if holds else None

    def _skids(self, sigma: int) -> Next | None:
        body, (s, c, _) = self.given.body, self.angle
        forward, backward = body.q(s, c, sigma, 1), body.q(s, c, sigma, -1)
        evidence = {"turning_negative": backward, "turning_positive": forward}
        if self.moving:
            self.evidence |= evidence
        if forward.sign() > 0 or backward.sign() < 0:
            return None
        if self.moving:
            return Next(SKIDDING, sigma, {})
        speeds_up = (-body.drag(sigma) * sigma).sign() > 0
        return Next(SKIDDING, sigma, evidence, 1) if speeds_up else None

    def _rolls(self, rotation: int) -> Next | None:
        body, (s, c, omega) = self.given.body, self.angle
        if self.gives_way:
            return None
        alpha = body.rolling(s, c, omega, rotation)
        normal, friction = body.forces(s, c, omega, alpha)
        pressing = body.pressing(s, c, rotation)
        evidence = {
            "rolling_solvability": pressing,
            "rolling_normal": normal,
            "rolling_friction": friction,
        }
        if self.turning:
            self.evidence |= evidence
        grip = body.mu_s * normal
        if normal.sign() <= 0 or not (
            friction.is_zero() or ((grip - friction).sign() > 0 and (grip + friction).sign() > 0)
        ):
            return None
        if not self.turning and (alpha * rotation).sign() <= 0:
            return None
        return Next(ROLLING, 0, {} if self.turning else evidence, 0, rotation)

    def _glides(self, sigma: int, rotation: int) -> Next | None:
        """Return a glide, in which nothing but the free fall of the particle turns the hoop."""
        (s, c, omega), body = self.angle, self.given.body
        if s.is_zero():
            raise Inconclusive("a glide begins with the particle above or below the centre")
        alpha = body.gliding(s, c, omega)
        if not self.turning and (alpha * rotation).sign() <= 0:
            return None
        if self.moving:
            return Next(GLIDING, sigma, {}, 0, rotation)
        # η″ = (1 + c) θ″ − s ω² = (1 + c) (1 − ω²)/s.
        side = s.sign() * (1 - omega * omega).sign()
        return Next(GLIDING, sigma, {}, 1, rotation) if side == sigma else None

    def _slides(self, sigma: int, rotation: int) -> Next | None:
        body, (s, c, omega) = self.given.body, self.angle
        p = body.solvability(s, c, sigma, rotation)
        side = "" if self.moving else "_positive" if sigma > 0 else "_negative"
        if self.turning:
            self.evidence["solvability" + side] = p
        if p.sign() * self.evidence["contact"].sign() <= 0:
            return None
        alpha = body.sliding(s, c, omega, sigma, rotation)
        if not self.turning and (alpha * rotation).sign() <= 0:
            return None
        order = 0
        if not self.moving:
            # Where static friction gives way and kinetic friction is equal, η″ = 0, and η‴ has the
            # sign of P.
            tie = self.gives_way == sigma and self.given.equal
            rubbing = body.mu_k * sigma * body.normal(s, c, omega, sigma, rotation) / body.m
            drives = (1 + body.h * c) * alpha - body.h * s * omega * omega - rubbing - body.back
            if (p if tie else drives * sigma).sign() <= 0:
                return None
            order = 2 if tie else 1
        evidence = {} if self.turning else {"solvability" + side: p}
        return Next(SLIDING, sigma, evidence, order, rotation)


# One impact, followed in its normal impulse p (docs/theory/impact.md).
#
# The gap rate v is a line in p, of slope k1 = C − σ μk B while the contact slips, up to the *bend*
# where the slip ends, bend = |η′|/(μk A − σ B); from there on of slope k2 = C + B r, r = −B/A if it
# sticks (μs A ≥ |B|), else it slips back, r = −μk sign B. Compression ends where v = 0. Restitution
# ends where v = −e v0 (Newton's law), p is 1 + e times that of compression (Poisson's), or the work
# of the normal impulse is e² times that of compression (energetic).


@dataclass(frozen=True)
class Impact:
    """The state after it, its impulses, its case, and the numbers that decide it."""

    after: State
    normal: Range
    friction: Range
    case: str
    evidence: dict[str, Range]
    last: Next = ARRIVED
    """What its last segment holds."""
    spin: Range = field(default_factory=lambda: Range(0))
    """What it adds to θ′."""


def impact(body: Body, before: State, e: Range, law: str) -> Impact:
    """Follow an impact; without a gap rate it is a jam."""
    s, c = sine_and_cosine(before.theta)
    a, b, across = body.compliances(s, c)
    sigma, v0 = before.slip.sign(), before.gap_rate
    grip = body.mu_s * a - abs(b)
    sticks = grip.sign() >= 0
    f, r = -(body.mu_k * sigma), -(b / a) if sticks else -(body.mu_k * b.sign())
    k1, k2 = across + b * f, across + b * r
    falls = b * (f - r)
    evidence = {"k1": k1, "k2": k2, "sticks": grip}
    bend: Range | None = Range(0)
    if sigma:
        slowing = evidence["slowing"] = body.mu_k * a - b * sigma
        bend = abs(before.slip) / slowing if slowing.sign() > 0 else None
    jams = sigma != 0 and k1.sign() < 0
    v1 = None if bend is None else v0 + k1 * bend
    # Whether compression, and then restitution, ends before the slip does.
    first = sigma != 0 and not jams and (v1 is None or v1.sign() > 0)
    whole = -(v0 / k1) * (1 + e) if first else None
    if whole is not None and (bend is None or (bend - whole).sign() >= 0):
        case, normal, opening, slipping = "slides", whole, -(e * v0), whole
        slip = before.slip + (a * f + b) * normal
    elif bend is None or v1 is None:
        raise Inconclusive("an impact jams for ever")
    else:
        evidence["slip_ends"], slipping = v1, bend
        # In v0 and the bend with small factors, so that radii do not grow from bounce to bounce.
        if law == "newton":
            opening = -(e * v0)
        elif law == "poisson" and whole is not None:
            opening = v0 * (1 - k2 / k1 * (1 + e)) + falls * bend
        elif law == "poisson":
            opening = -(e * (v0 + falls * bend))
        elif whole is not None:
            opening = (e * e * v0 * v0 * k2 / k1 + v1 * v1 * falls / k1).sqrt()
        elif e.is_zero():
            opening = Range(0)
        else:
            opening = e * (v0 * v0 + falls * bend * (2 * v0 + k1 * bend)).sqrt()
        normal = (opening - v0 - falls * bend) / k2
        end = "jams" if jams else ("restitution" if first else "compression")
        case = end if jams else f"{'sticks' if sticks else 'reverses'}_in_{end}"
        slip = Range(0) if sticks else before.slip + a * (f - r) * bend + (a * r + b) * normal
    friction = r * normal + (f - r) * slipping
    spin = (body.h * s * normal + (1 + body.h * c) * friction) / body.inertia
    after = replace(before, rate=before.rate + spin, slip=slip, gap=Range(0), gap_rate=opening)
    return Impact(after, normal, friction, case, evidence, spin=spin)


# An impact with rolling resistance (docs/theory/rolling-resistance.md), whose couple is −ς χ a unit
# of normal impulse, or holds the angle. With the friction f and the couple k a unit of impulse adds
# (h s + (1 + h c) f + k)/Î to θ′; what it adds to the slip and to the gap rate follows. So all
# velocities are lines between the impulses where η′ or θ′ vanishes, and the segment that follows
# there is chosen as a mode of motion is.


@dataclass(frozen=True)
class Segment:
    """Two signs, the friction and the couple a unit of impulse, and what that does."""

    signs: tuple[int, int]
    friction: Range
    couple: Range
    slip: Range
    rate: Range
    gap_rate: Range


def segment(body: Body, before: State, rates: tuple[Range, Range]) -> Segment:
    """Return the segment that begins with a slip and a rate."""
    s, c = sine_and_cosine(before.theta)
    arm, lever, zero = body.h * s, 1 + body.h * c, Range(0)
    along, across, _ = body.compliances(s, c)
    ways = [(one.sign(),) if not one.is_zero() else (0, -1, 1) for one in rates]

    def made(sigma: int, rotation: int) -> Segment | None:
        friction, couple = -(body.mu_k * sigma), -(body.chi * rotation)
        if sigma == 0:
            friction = -(across + lever * couple / body.inertia) / along if rotation else zero
        if rotation == 0:
            couple = -(arm + lever * friction)
        spin = (arm + lever * friction + couple) / body.inertia if rotation else zero
        slip = friction / body.m + lever * spin if sigma else zero
        held = [(friction, body.mu_s)] if sigma == 0 else []
        held += [(couple, body.chi)] if rotation == 0 else []
        if any(not need.is_zero() and (most - abs(need)).sign() < 0 for need, most in held):
            return None
        begins = [(slip, sigma)] if sigma and rates[0].is_zero() else []
        begins += [(spin, rotation)] if rotation and rates[1].is_zero() else []
        if any((value * sign).sign() <= 0 for value, sign in begins):
            return None
        return Segment((sigma, rotation), friction, couple, slip, spin, 1 / body.m + arm * spin)

    for zeros in (2, 1, 0):
        signs = [(a, b) for a in ways[0] for b in ways[1] if (a, b).count(0) == zeros]
        found = [one for one in (made(*pair) for pair in signs) if one is not None]
        if len(found) == 1:
            return found[0]
        if found:
            break
    raise Inconclusive("an impact has no segment, or two")


def impact_with_couple(body: Body, before: State, e: Range, law: str) -> Impact:
    """Follow an impact with rolling resistance; without a gap rate it is a jam."""
    slip, rate, v = before.slip, before.rate, before.gap_rate
    p = friction = work = spin = Range(0)
    # Impulse and work of the compression, once it has ended.
    pressed: tuple[Range, Range] | None = None
    passed: list[tuple[Segment, Range, bool]] = []
    name = ""
    while name != "over":
        now = segment(body, before, (slip, rate))
        if not passed or passed[-1][0].signs != now.signs:
            passed.append((now, p, pressed is None))
        ends = [
            (-(value / change), v - now.gap_rate * (value / change), name)
            for name, value, change in (("slip", slip, now.slip), ("rate", rate, now.rate))
            if not value.is_zero() and change.sign() * value.sign() < 0
        ]
        if pressed is not None:
            ends.append(_over(now, (p, v, work), pressed, (e, law, before.gap_rate)))
        elif now.gap_rate.sign() > 0:
            ends.append((-(v / now.gap_rate), Range(0), "pressed"))
        if not ends:
            raise Inconclusive("an impact jams for ever")
        step, opening, name = ends[0]
        for one in ends[1:]:
            if (step - one[0]).sign() > 0:
                step, opening, name = one
        work += step * (v + opening) / 2
        p, friction, v = p + step, friction + now.friction * step, opening
        spin = spin + now.rate * step
        slip = slip + now.slip * step if name != "slip" else Range(0)
        rate = rate + now.rate * step if name != "rate" else Range(0)
        if name == "pressed":
            pressed, work = (p, work), Range(0)
            name = "over" if e.is_zero() else name
    evidence = {f"k{k}": one.gap_rate for k, (one, *_) in enumerate(passed, 1)}
    evidence |= {f"segment_{k}": begin for k, (_, begin, _) in enumerate(passed[1:], 2)}
    after = replace(before, rate=rate, slip=slip, gap=Range(0), gap_rate=v)
    last = Next("", now.signs[0], {}, 0, now.signs[1])
    return Impact(after, p, friction, _case_of(passed), evidence, last, spin)


def _over(
    now: Segment,
    at: tuple[Range, Range, Range],
    pressed: tuple[Range, Range],
    law: tuple[Range, str, Range],
) -> tuple[Range, Range, str]:
    """Return the impulse after which the law ends an impact, and the gap rate there.

    From an impulse, a gap rate and the work since compression ended.
    """
    (p, v, work), (e, name, closing) = at, law
    if now.gap_rate.sign() <= 0:
        raise Inconclusive("the gap closes twice in an impact")
    if name == "poisson":
        step = pressed[0] * (1 + e) - p
        return step, v + now.gap_rate * step, "over"
    opening = -(e * closing)
    if name == "energetic":
        left = -(e * e * pressed[1]) - work
        opening = (v * v + 2 * (now.gap_rate * left)).sqrt()
    return (opening - v) / now.gap_rate, opening, "over"


def _case_of(passed: list[tuple[Segment, Range, bool]]) -> str:
    """Return what the slip does in an impact."""
    first = passed[0][0]
    if first.gap_rate.sign() < 0:
        return "jams"
    for one, _, compresses in passed:
        sigma = one.signs[0]
        if sigma == 0 or sigma != first.signs[0]:
            where = "compression" if compresses else "restitution"
            return f"{'reverses' if sigma else 'sticks'}_in_{where}"
    return "slides"


# Bounces that accumulate: an enclosure of what infinitely many of them still do.
#
# While θ and θ′ stay within a margin of what they are, the rim is pulled back with between W1 and
# W2 > 0. A flight that begins with the gap rate v takes from 2 v/W2 to 2 v/W1 and comes back with
# from v √(W1/W2) to v √(W2/W1), and an impact makes at most e V of a rate V. So rates fall at least
# like qⁿ, q = e √(W2/W1) < 1, and sums over all bounces are at most geometric ones. If by these
# sums the state stays within the margin, all of it holds for ever.
#
# That an impact makes at most e V of V is the law where the contact slips throughout. Where it
# sticks it follows for each law if k1 > k2; on a level plane, without rolling resistance, the slip
# of the flight before has the sign of −h s ω², so that σ B < 0 and k1 = C + μk |B| > k2.
#
# With e = 1, or where k1 is less, bounces still settle where friction takes enough: where the
# contact sticks in each impact, an impact is homogeneous in its rates, and that of the rate V/v and
# the slip −(h s ω² + sin α) T/v, in their bounds, says what q is.
#
# With rolling resistance θ′ has to keep its sign. Where the couple holds the angle, and θ′ = 0,
# rates fall by e exactly.


def slowest() -> Range:
    """Return the gap rate down to which bounces are followed one by one.

    It is 2⁻¹⁵⁰, and less with more than 192 bits.
    """
    return Range(1 << (3 * Range.bits - 408) // 4)


@dataclass(frozen=True)
class Rest:
    """The end of the bounces, and their impulses."""

    end: State
    normal: Range
    friction: Range


def rest_of_bounces(given: Given, start: State) -> Rest:
    """Enclose what follows, if the bounces settle.

    With rolling resistance θ′ keeps its sign, or its value 0.
    """
    body, e, zero = given.body, given.restitution, Range(0)
    assert e is not None
    if given.resists and start.rate.is_zero():
        return _rest_without_rotation(body, start, e)
    v = start.gap_rate.largest()
    margin = v * (1 << 24)
    theta, rate = start.theta.widened(margin), start.rate.widened(margin)
    rotation = rate.sign() if given.resists else 0
    (s, c), sticks = sine_and_cosine(theta), start.slip.is_zero()
    pull = body.weight(c, rate)
    _demand(exceeds(pull.least(), 0), "are pulled back")
    weakest, strongest = pull.least(), pull.largest()
    uneven = (strongest / weakest).sqrt()
    # In a flight the slip falls by this in a unit of time.
    drift = body.h * s * rate * rate + body.back
    sigma = -drift.sign() if sticks else start.slip.sign()
    arm, lever = body.h * s, 1 + body.h * c
    slides = 1 / body.m + arm * body.q(s, c, sigma, rotation) / body.inertia
    press, hold, shrink = slides, body.mu_k, (e * uneven).largest()
    longest = 2 * v / weakest
    if sticks:
        along = 1 / body.m + lever * lever / body.inertia
        turned = lever * (arm - body.chi * rotation) / body.inertia
        press = body.pressing(s, c, rotation) / (body.inertia * body.m * body.m * along)
        hold = body.mu_s
        _demand(exceeds(body.mu_s * along, turned.largest()), "stick")
        _demand(exceeds(slides, 0), "are pressed back")
        # The slip ends within the impact, were it to slide throughout.
        slowing = body.mu_k * along - turned * sigma
        ends = (1 + e) * (v / uneven) * slowing
        _demand(exceeds(ends, drift.largest() * longest * slides), "stick")
        if not (exceeds(1 - shrink, 0) and exceeds(slides, press)):
            shrink = _shrinking(given, start, (theta, rate, drift), (weakest, strongest))
            press = press if exceeds(slides, press) else slides.least()
    _demand(exceeds(1 - shrink, 0), "shrink")
    _demand(exceeds(press, 0), "are pressed back")
    # What comes down with v √(W2/W1) at most goes up with so much of v.
    taken = (uneven + shrink) * v / (1 - shrink)
    normal, time = (taken / press.least()).largest(), (longest / (1 - shrink)).largest()
    friction = (hold * normal).largest()
    spin = ((arm.largest() + lever.largest() * hold + body.chi) * normal / body.inertia).largest()
    change = (friction / body.m + lever.largest() * spin + drift.largest() * time).largest()
    turn = (rate.largest() * time).largest()
    _demand(exceeds(margin, turn) and exceeds(margin, spin), "stay within their margin")
    _demand(sticks or exceeds(abs(start.slip), change), "keep their slip")
    far = ((rate.largest() + start.slip.largest() + change) * time).largest()
    half, middle = (time / 2).largest(), (normal / 2).largest()
    end = State(
        (start.time + half).widened(half),
        start.theta.widened(turn),
        start.rate.widened(spin),
        zero if sticks else start.slip.widened(change),
        start.x.widened(far),
        zero,
        zero,
    )
    return Rest(end, middle.widened(middle), zero.widened(friction))


def _shrinking(
    given: Given, start: State, box: tuple[Range, Range, Range], pull: tuple[Range, Range]
) -> Range:
    """Return what the impact itself makes of a rate 1 at most, where it ends the slip of a flight.

    From θ, θ′ and the drift in their margins, and the least and the largest pull.
    """
    (theta, rate, drift), (weakest, strongest) = box, pull
    uneven = (strongest / weakest).sqrt()
    slip = -(drift * between(2 / strongest, 2 / weakest))
    landing = replace(start, theta=theta, slip=slip, gap_rate=-between(1 / uneven, uneven))
    assert given.restitution is not None
    strike = impact
    if given.resists:
        # Over the largest rate of the gap θ′ is smallest: what does not stop it there never does.
        strike, landing = impact_with_couple, replace(landing, rate=rate / start.gap_rate.largest())
    hit = strike(given.body, landing, given.restitution, given.law)
    _demand(hit.after.slip.is_zero(), "stick")
    return hit.after.gap_rate.largest()


def _rest_without_rotation(body: Body, start: State, e: Range) -> Rest:
    """Sum up bounces in which the couple holds the angle: each has e of the gap rate before it.

    On a slope a flight slips by −sin α τ. Friction of the impact after it ends that, or the slip
    keeps its sign.
    """
    _demand(exceeds(1 - e, 0), "shrink")
    (s, c), moves = sine_and_cosine(start.theta), start.slip.sign()
    sigma = moves or -body.back.sign()
    _demand(exceeds(body.chi, body.q(s, c, sigma).largest()), "hold the angle")
    whole = start.gap_rate / (1 - e)
    time, normal = 2 * whole / body.down, body.m * (1 + e) * whole
    flown, rubbed = -(body.back * time), body.mu_k * normal / body.m
    slip, change = start.slip, flown - rubbed * sigma
    if not moves and (sigma == 0 or (rubbed - abs(flown)).sign() > 0):
        _demand(exceeds(body.chi, (body.h * s).largest()), "hold the angle")
        change = Range(0)
        friction = -(body.m * flown)
    else:
        slip, friction = slip + change, -(body.m * rubbed * sigma)
        # Whatever comes first of each, a flight or an impact.
        least = 2 * abs(flown) if moves else Range(0)
        _demand(exceeds(slip * sigma, least), "keep their slip")
    far = ((start.slip.largest() + flown.largest() + rubbed.largest()) * time).largest()
    end = replace(
        start,
        time=start.time + time,
        slip=slip,
        x=start.x.widened(far),
        gap=Range(0),
        gap_rate=Range(0),
    )
    return Rest(end, normal, friction)


def _demand(holds: bool, what: str) -> None:
    if not holds:
        raise Inconclusive(f"it is not seen that bounces {what}")


def bounce(given: Given, start: State, landing: State) -> Impact:
    """Follow the impact after a flight.

    All rates of one that begins without slip are those over its gap rate v.

    So the radius of v does not grow from bounce to bounce. With φ = ω τ and the series C = (cos φ −
    1 + φ²/2)/φ⁴, S = (φ − sin φ)/φ³, Q = (1 − cos φ)/φ², y = 0 gives τ/v = 2/(w + 2 h ω³ τ (c φ C +
    s S)), and with it y′/v = 1 − (w + h ω³ τ (c φ S + s Q)) τ/v and η′/v = −h ω² (s (1 − φ² S) + c
    φ (1/2 − φ² C)) τ/v − sin α τ/v.
    """
    body, omega, tau = given.body, start.rate, landing.time - start.time
    assert given.restitution is not None
    phi = omega * tau
    strike = impact_with_couple if given.resists else impact
    if not start.slip.is_zero() or exceeds(2 * phi.largest(), 1):
        return strike(body, landing, given.restitution, given.law)
    (s, c), square = sine_and_cosine(start.theta), phi * phi
    fourth, third, second = (_rest_of_series(square, n) for n in (4, 3, 2))
    w, bend = body.weight(c, omega), body.h * omega * omega * phi
    flight = 2 / (w + 2 * bend * (c * phi * fourth + s * third))
    closing = 1 - (w + bend * (c * phi * third + s * second)) * flight
    slip = -(
        body.h
        * omega
        * omega
        * (s * (1 - square * third) + c * phi * (1 - 2 * (square * fourth)) / 2)
        * flight
    )
    slip = slip - body.back * flight
    v = start.gap_rate
    # With rolling resistance it matters when θ′ vanishes, and else only what is added to it.
    fast = omega / v if given.resists else Range(0)
    hit = strike(
        body,
        replace(landing, rate=fast, slip=slip, gap_rate=closing),
        given.restitution,
        given.law,
    )
    after = hit.after
    stops = given.resists and after.rate.is_zero()
    rate = Range(0) if stops else omega + hit.spin * v
    after = replace(after, rate=rate, slip=after.slip * v, gap_rate=after.gap_rate * v)
    return replace(hit, after=after, normal=hit.normal * v, friction=hit.friction * v)


def _rest_of_series(square: Range, first: int) -> Range:
    """Return 1/n! − φ²/(n + 2)! + φ⁴/(n + 4)! − …, |φ| < 1.

    What is left out is less than the last term.
    """
    term = total = Range(1 << Range.bits) / math.factorial(first)
    n = first
    while exceeds(term.largest(), Range(64)):
        term = -(term * square) / ((n + 1) * (n + 2))
        total, n = total + term, n + 2
    return total.widened(term.largest())


# A motion followed again from its start, and written as a certificate has it.

LISTED = Fraction(1e-3)
"""Bounces whose gap opens more slowly are one event, `settle`."""

MOST_STEPS = 100_000
"""Steps, impacts and choices after which a motion is too long."""


class Walk:
    """Follows one motion."""

    def __init__(self, case: Mapping[str, Any]) -> None:
        self.given = Given(case)
        self.phases: list[dict[str, Any]] = []
        self.events: list[dict[str, Any]] = []
        self.slides, self.impacts, self.resistance = Range(0), Range(0), Range(0)
        self.numbers = self.steps = self.half_swings = 0

    def text(self, value: Range, where: str, name: str = "") -> list[str]:
        """Return the text of a number, in the unit of the quantity of this name."""
        self.numbers += 1
        scale = self.given.scale.get(name)
        try:
            return text_of(value if scale is None else value * scale)
        except Inconclusive as error:
            raise Inconclusive(f"{where}: {error}") from None

    def texts(self, values: Mapping[str, Range], where: str) -> dict[str, list[str]]:
        """Return the texts of quantities."""
        return {
            name: self.text(value, f"{name} of {where}", name) for name, value in values.items()
        }

    def evidence(self, values: Mapping[str, Range], where: str) -> dict[str, list[str]]:
        """Return the texts of numbers that decide something; they have no units."""
        return {
            name: self.text(value, f"{name} of the evidence of {where}")
            for name, value in values.items()
        }

    def state(
        self, state: State, where: str, more: Mapping[str, Range] | None = None
    ) -> dict[str, list[str]]:
        """Return a state as a certificate has it."""
        values = {
            "time": state.time,
            "theta": state.theta,
            "theta_rate": state.rate,
            "slip": state.slip,
            "x": state.x,
            "gap": state.gap,
            "gap_rate": state.gap_rate,
            "energy": energy(self.given.body, state),
        }
        if where.endswith(PLANE):
            # θ′ is infinite there.
            del values["theta_rate"], values["energy"]
        return self.texts(values | dict(more or {}), where)

    def follow(self) -> dict[str, Any]:
        """Follow the motion to its end, and return what a certificate has of it."""
        given, state = self.given, self.given.start
        now = decide(given, state) if state.gap_rate.is_zero() else _opening(state)
        initial = {
            "mode": now.mode,
            "direction": now.direction,
            **self.rotation(now.rotation),
            "evidence": self.evidence(now.evidence, "the start"),
        }
        start = energy(given.body, state)
        end: dict[str, Any] | None = None
        slow = False
        while end is None:
            self.count(1)
            if now.mode == INCONSISTENT and given.restitution is not None:
                state, now, slow = self.hit("jam", state)
            elif now.mode == REST:
                end = self.rest(state)
            elif now.mode in (INCONSISTENT, AMBIGUOUS):
                end = {"kind": now.mode, "state": self.state(state, "the end")}
            elif slow:
                (state, now), slow = self.settle(state), False
            else:
                state, now, slow, end = self.pass_phase(state, now)
        energies = {"start": start, "lost_in_slides": self.slides, "lost_in_impacts": self.impacts}
        if given.resists:
            energies["lost_in_rolling_resistance"] = self.resistance
        return {
            "initial": initial,
            "phases": self.phases,
            "events": self.events,
            "end": end,
            "energy": self.texts(energies, "energy"),
        }

    def rotation(self, sign: int) -> dict[str, int]:
        """Return the sign of θ′ as a certificate has it: with rolling resistance."""
        return {"rotation": sign} if self.given.resists else {}

    def count(self, steps: int) -> None:
        """Count steps."""
        self.steps += steps
        if self.steps > MOST_STEPS:
            raise TooLong(f"the motion takes more than {MOST_STEPS} steps")

    def run(self, phase: Phase) -> Followed:
        """Follow a phase, and count its steps."""
        run = follow(self.given, phase, MOST_STEPS - self.steps)
        self.count(len(run.steps))
        return run

    def event(self, cause: str, state: State, following: Next | None, **more: Any) -> None:
        """Write an event."""
        where = f"event {len(self.events)}, {cause}"
        evidence = more.pop("evidence", {}) | (following.evidence if following else {})
        self.events.append(
            {
                "cause": cause,
                "to": following.mode if following else None,
                "direction": following.direction if following else 0,
                **self.rotation(following.rotation if following else 0),
                "state": self.state(state, where),
                "evidence": self.evidence(evidence, where),
            }
            | more
        )

    def pass_phase(
        self, state: State, now: Next
    ) -> tuple[State, Next, bool, dict[str, Any] | None]:
        """Follow and write a phase, and the event at its end."""
        given = self.given
        run = self.run(Phase(given, state, now.mode, now.direction, now.order, now.rotation))
        self.phase(run)
        end = run.end
        if end is None:
            turn = run.turn
            kind = "rest" if turn is None else "libration" if turn.angle.is_zero() else "rotation"
            found: dict[str, Any] = {"kind": "rolls_forever", "recurrence": kind}
            return (
                state,
                now,
                False,
                found if turn is None else found | self.texts({"period": turn.period}, "the end"),
            )
        self.losses(run, end)
        if run.guard == TURNING and now.mode == ROLLING and state.rate.is_zero():
            self.half_swings += 1
        if run.guard == TIME:
            return end, now, False, {"kind": TIME, "state": self.state(end, "the end")}
        if run.guard == GAP and given.restitution is not None:
            return *self.hit("landing", end), None
        if run.guard == GAP:
            self.event("landing", end, None, evidence={"gap_rate": end.gap_rate})
            return end, now, False, {"kind": "landing", "state": self.state(end, "the end")}
        if run.guard == PLANE:
            self.event(PLANE, end, None)
            return end, now, False, {"kind": PLANE, "state": self.state(end, "the end, " + PLANE)}
        cause, now = self.after(run.guard, end, now)
        self.event(cause, end, now)
        return end, now, False, None

    def losses(self, run: Followed, end: State) -> None:
        """Add what friction takes in a phase: of a slide that of its slip, and what is left."""
        phase, body = run.phase, self.given.body
        rolls = phase.mode == ROLLING and phase.rotation != 0
        if phase.mode not in (SLIDING, SKIDDING) and not rolls:
            return
        lost = energy(body, phase.start) - energy(body, end)
        if phase.mode == SKIDDING or not phase.rotation:
            self.slides += lost
            return
        rubbed = run.rubbed() if phase.mode == SLIDING else Range(0)
        self.slides += rubbed
        self.resistance += lost - rubbed

    def rest(self, state: State) -> dict[str, Any]:
        """Write the rest of a motion, and return its end."""
        self.phase(self.run(Phase(self.given, state, REST)))
        written = self.state(state, "the end")
        return {"kind": "rests", "state": written, "half_swings": self.half_swings}

    def phase(self, run: Followed) -> None:
        """Write a phase: without an end, samples of four units of time."""
        phase, where = run.phase, f"a sample of phase {len(self.phases)}"
        end = phase.start.time + 4 if run.end is None else run.end.time
        samples = []
        for time in self.times(
            phase.start.time, end, 3 if (phase.mode, phase.order) == (FLIGHT, 1) else 5
        ):
            state = run.at(time)
            forces = phase.forces(state)
            written = dict(zip(("normal", "friction"), forces, strict=True))
            if self.given.resists:
                written["couple"] = phase.couple(state, forces)
            samples.append(self.state(state, where, written))
        self.phases.append(
            {
                "mode": phase.mode,
                "direction": phase.sigma,
                **self.rotation(phase.rotation),
                "samples": samples,
            }
        )

    def times(self, start: Range, end: Range, parts: int) -> list[Range]:
        """Return the times of samples within a phase.

        They are all multiples of the largest power of two that is not above the length of the phase
        over `parts`, in the unit of the certificate; a phase shorter than 2⁻¹⁰ has none.
        """
        unit = self.given.clock
        first, last = (start * unit).ends()[1], (end * unit).ends()[0]
        if last - first < Fraction(1, 1024):
            return []
        part = (last - first) / parts
        step = Fraction(2) ** (part.numerator.bit_length() - part.denominator.bit_length())
        if step > part:
            step /= 2
        return [Range.of(k * step) / unit for k in range(first // step + 1, -(-last // step))]

    def after(self, guard: str, state: State, before: Next) -> tuple[str, Next]:
        """Return the cause and what follows where a guard of a phase on the plane vanishes."""
        if guard == CONTACT:
            s, _ = sine_and_cosine(state.theta)
            opens = -(self.given.body.h * s * state.rate * state.rate * state.rate)
            if opens.sign() <= 0:
                raise Refused("the gap does not open where w vanishes")
            return "lift_off", Next(FLIGHT, 0, {"gap_third_derivative": opens}, 3)
        if guard == SLIP:
            following = decide(self.given, state, before=before)
            return ("reversal" if following.direction else "stick"), following
        if guard == SOLVABLE:
            raise Refused("the slide runs into P = 0")
        if guard == NORMAL:
            turning = state.rate.sign()
            glide = Next(GLIDING, -turning, {}, 2, turning if self.given.resists else 0)
            return "normal_force_zero", glide
        if guard == TURNING:
            return TURNING, decide(self.given, state, before=before)
        return "slip", decide(self.given, state, -1 if guard == UP else 1, before=before)

    def hit(self, cause: str, before: State) -> tuple[State, Next, bool]:
        """Follow and write an impact.

        Say whether the bounces after it are too slow to be listed.
        """
        given = self.given
        assert given.restitution is not None
        follow = impact_with_couple if given.resists else impact
        hit = follow(given.body, before, given.restitution, given.law)
        after = hit.after
        now = decide(given, after, before=hit.last) if after.gap_rate.is_zero() else _opening(after)
        lost = energy(given.body, before) - energy(given.body, after)
        self.impacts += lost
        where = f"the impact of event {len(self.events)}"
        numbers = {
            "normal_impulse": hit.normal,
            "friction_impulse": hit.friction,
            "energy_lost": lost,
        }
        rates = {"theta_rate": before.rate, "slip": before.slip, "gap_rate": before.gap_rate}
        written = {
            "case": hit.case,
            **self.texts(numbers, where),
            "before": self.texts(rates, f"before {where}"),
        }
        self.event(cause, after, now, impact=written, evidence=hit.evidence)
        slow = (
            now.order == 1 and now.mode == FLIGHT and (Range.of(LISTED) - after.gap_rate).sign() > 0
        )
        return after, now, slow

    def settle(self, first: State) -> tuple[State, Next]:
        """Follow bounces one by one, enclose those that remain, and write all of them together."""
        given = self.given
        assert given.restitution is not None
        self.phases.append({"mode": FLIGHT, "direction": 0, **self.rotation(0), "samples": []})
        state, normal, friction = first, Range(0), Range(0)
        while not exceeds(slowest(), state.gap_rate):
            run = self.run(Phase(given, state, FLIGHT, 0, 1))
            if run.end is None or run.guard != GAP:
                raise Refused("bounces do not settle before the time limit")
            if exceeds(state.gap_rate, Range.of(LISTED)):
                raise Refused("bounces too slow to be listed grow again")
            hit = bounce(given, state, run.end)
            state, normal, friction = hit.after, normal + hit.normal, friction + hit.friction
        rest = rest_of_bounces(given, state)
        end, following = rest.end, decide(given, rest.end, before=ARRIVED)
        if given.until is not None and not exceeds(given.until, end.time):
            raise Inconclusive("whether bounces settle before the time limit is not decided")
        lost = energy(given.body, first) - energy(given.body, end)
        self.impacts += lost
        numbers = {
            "normal_impulse": normal + rest.normal,
            "friction_impulse": friction + rest.friction,
            "energy_lost": lost,
        }
        written = self.texts(numbers, f"the impact of event {len(self.events)}")
        case = "sticks" if end.slip.is_zero() else "slides"
        self.event("settle", end, following, impact={"case": case, **written})
        return end, following


def _opening(state: State) -> Next:
    """Return the flight of a gap that opens."""
    if state.gap_rate.sign() < 0:
        raise Inconclusive("the gap closes where a flight begins")
    return Next(FLIGHT, 0, {"gap_rate": state.gap_rate}, 1)


# The check of a certificate.

BITS = (192, 320, 512, 1024, 2048)
"""Precisions that are tried, one after the other."""


@lru_cache(maxsize=1)
def _motion(
    case: str, bits: tuple[int, ...], begin: Callable[[Mapping[str, Any]], Walk]
) -> tuple[str, Walk]:
    """Follow the motion of a case; return what a certificate has of it, as JSON, and the walk.

    The last one is kept, so that many certificates of one case are compared with it quickly.
    """
    reason = "no number of bits is allowed"
    for number in bits:
        with precision(number):
            try:
                walk = begin(json.loads(case))
                return json.dumps(walk.follow()), walk
            except TooLong as long:
                raise Refused(f"the check is inconclusive: {long}") from None
            except (Inconclusive, ArithmeticError, ValueError) as inconclusive:
                reason = f"{inconclusive} with {number} bits"
    raise Refused(f"the check is inconclusive: {reason}")


def check(certificate: Any, bits: tuple[int, ...] = BITS) -> dict[str, int]:
    """Check a certificate.

    Parameters
    ----------
    certificate : dict
        What a file of a certificate says.
    bits : tuple of int, optional
        Precisions that are tried, one after the other.

    Returns
    -------
    dict
        How many numbers, phases and events were found again.

    Raises
    ------
    Refused
        With the first thing that is not right.
    """
    walk = followed(certificate, Walk, bits)
    return {"phases": len(walk.phases), "events": len(walk.events), "numbers": walk.numbers}


W = TypeVar("W", bound=Walk)


def followed(certificate: Any, kind: type[W], bits: tuple[int, ...] = BITS) -> W:
    """Check a certificate, and return the walk that found the same.

    Its kind may keep more of it.
    """
    intact(certificate)
    case = certificate["case"]
    if not certificate["certified"]:
        raise Refused(f"nothing is certified: {certificate['reason']}")
    begin: Callable[[Mapping[str, Any]], Walk] = kind
    motion, walk = _motion(json.dumps(case), tuple(bits), begin)
    head = {"format": "littlewood-certificate", "version": 2, "certified": True}
    claimed = {key: certificate[key] for key in certificate if key != "digest"}
    _same({**head, "case": case, **json.loads(motion)}, claimed, "")
    assert isinstance(walk, kind)
    return walk


def intact(certificate: Any) -> None:
    """Refuse what has not the shape of a certificate, a case out of bounds, or another digest."""
    valid(certificate)
    valid_case(certificate["case"], "case")
    if digest(certificate) != certificate["digest"]:
        raise Refused("the digest is not that of the certificate")


def digest(certificate: Mapping[str, Any]) -> str:
    """Return the SHA-256 of a certificate without its digest."""
    rest = {key: value for key, value in certificate.items() if key != "digest"}
    return hashlib.sha256(
        json.dumps(rest, sort_keys=True, separators=(",", ":")).encode()
    ).hexdigest()


def _same(found: Any, claimed: Any, where: str) -> None:
    """Refuse what is not the same, type for type."""
    if isinstance(found, dict) and isinstance(claimed, dict):
        for key in [*found, *(key for key in claimed if key not in found)]:
            if (key in found) != (key in claimed):
                raise Refused(
                    f"{where or 'the certificate'} {'has no' if key in found else 'has'} "
                    f"{_shown(key)}"
                )
            _same(found[key], claimed[key], f"{where}.{key}" if where else key)
    elif (
        isinstance(found, list)
        and isinstance(claimed, list)
        and not isinstance((*found, "")[0], str)
    ):
        for number, (one, other) in enumerate(zip(found, claimed, strict=False)):
            _same(one, other, f"{where}[{number}]")
        if len(found) != len(claimed):
            raise Refused(f"{where} are {len(found)}, not {len(claimed)}")
    elif found != claimed or type(found) is not type(claimed):
        raise Refused(f"{where} is {_value(found)}, not {_value(claimed)}")


def _value(value: Any) -> str:
    if isinstance(value, list):
        return " ± ".join(map(str, value))
    return _shown(value)


def read_file(path: Path) -> Any:
    """Read a file of JSON; refuse what is no file, so that it ends, and one that is too long."""
    if path.exists() and not path.is_file():
        raise Unreadable("it is a folder, a pipe or a device, not a file")
    with path.open("rb") as file:
        text = file.read(MOST_BYTES + 1)
    if len(text) > MOST_BYTES:
        raise Unreadable(f"it has more than {MOST_BYTES} bytes")
    return read(text)


def main(arguments: list[str] | None = None) -> int:
    """Check files: 0; 1 if a certificate is refused; 2 if a file cannot be read."""
    parser = argparse.ArgumentParser(
        description="Checks certificates of motions of Littlewood's hoop."
    )
    parser.add_argument(
        "file", metavar="CERTIFICATE", nargs="+", type=Path, help="a certificate, as JSON"
    )
    code, right, files = 0, 0, parser.parse_args(arguments).file
    for path in files:
        began = clock.perf_counter()
        try:
            found = check(read_file(path))
        except Refused as refused:
            code = max(code, 1)
            print(f"{path}: refused: {refused}", file=sys.stderr, flush=True)
        except (Unreadable, OSError) as error:
            code = 2
            print(f"{path}: error: {error}", file=sys.stderr, flush=True)
        else:
            right += 1
            numbers, events = found["numbers"], found["events"]
            seconds = clock.perf_counter() - began
            print(
                f"{path}: {numbers} numbers of {events} events are right ({seconds:.1f} s)",
                flush=True,
            )
    if len(files) > 1:
        print(f"{right} of {len(files)} are right")
    return code


if __name__ == "__main__":
    sys.exit(main())
