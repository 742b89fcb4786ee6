"""Balls: real numbers with rigorous bounds on their error, their signs, and their text.

A ball's text is a function of the true number alone, not of how precisely it was computed: 30
significant digits, correctly rounded, and as radius the error of these digits in hundredths of a
unit of the last of them. So a certificate has the same bytes whatever precision made it, and a
checker that computes the number in another way has to get the same text.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from fractions import Fraction
from typing import Any, TypeAlias

from .._internal.extras import require

flint: Any = require("flint")
arb, acb, arb_poly, arb_series = flint.arb, flint.acb, flint.arb_poly, flint.arb_series

Ball: TypeAlias = Any
"""A ball, or a series of them: python-flint's types, which have no complete stubs."""


class Beyond(Exception):
    """A motion that no precision would certify: the method does not cover it."""


DIGITS = 30
"""Significant digits of a midpoint."""

FLOOR = Fraction(1, 10**40)
"""Numbers up to this that may be 0 are written as 0 with this radius."""


class Undecided(Exception):
    """A sign, a digit or an order that the working precision does not tell."""


@contextmanager
def precision(bits: int) -> Iterator[None]:
    """Compute with this many bits."""
    before = flint.ctx.prec, flint.ctx.cap
    flint.ctx.prec, flint.ctx.cap = bits, terms(bits) + 2
    try:
        yield
    finally:
        flint.ctx.prec, flint.ctx.cap = before


def terms(bits: int) -> int:
    """Return the length of Taylor series.

    A quarter of the radius of the disc gives two bits a term.
    """
    return bits // 2 + 8


def ball(value: Fraction) -> Ball:
    """Return the ball of a rational number."""
    return arb(flint.fmpq(value.numerator, value.denominator))


def sign(value: Ball, what: str) -> int:
    """Return the sign of a ball; 0 only for what is exactly 0."""
    if value > 0:
        return 1
    if value < 0:
        return -1
    if value.is_zero():
        return 0
    raise Undecided(f"the sign of {what} is not decided")


def discs(center: Ball, radius: Ball) -> Iterator[tuple[Ball, Ball]]:
    """Yield smaller and smaller radii, each with a square that holds its disc."""
    for _ in range(60):
        yield radius, acb(center + arb(0, 1) * radius, arb(0, 1) * radius)
        radius = (radius * 3 / 4).mid()


def ends(value: Ball) -> tuple[Fraction, Fraction]:
    """Return the ends of a ball, exactly."""
    if not value.is_finite():
        raise Undecided("a number is not enclosed")

    def rational(point: Ball) -> Fraction:
        man, exp = point.man_exp()
        return Fraction(int(man)) * Fraction(2) ** int(exp)

    middle, radius = rational(value.mid()), rational(value.rad())
    return middle - radius, middle + radius


def text(value: Ball) -> list[str]:
    """Return midpoint and radius as decimal strings.

    The radius is ⌊d + 1/1000⌋ + 1 of the distance d in hundredths: at least d, and not above d +
    1.001. The thousandth is there for numbers whose d is whole, such as doubles: without it, what
    encloses them would never decide it.
    """
    low, high = ends(value)
    if low == high == 0:
        return ["0", "0"]
    if low <= 0 <= high or max(abs(low), abs(high)) <= FLOOR:
        if max(-low, high) > FLOOR:
            raise Undecided("a number may be 0")
        return ["0", "1e-40"]
    found = {_of_point(low), _of_point(high)}
    # Ends on both sides of the midpoint may be as far from it, and what is between is nearer.
    middle = Fraction(next(iter(found))[0])
    if low < middle < high:
        found.add(_of_point(middle))
    if len(found) > 1:
        raise Undecided("the digits of a number are not decided")
    return list(found.pop())


def _of_point(value: Fraction) -> tuple[str, str]:
    exponent = _exponent(abs(value))
    unit = Fraction(10) ** (exponent - DIGITS + 1)
    digits = round(value / unit)
    hundredths = (100 * abs(value / unit - digits) + Fraction(1, 1000)).__floor__() + 1
    if abs(digits) == 10**DIGITS:
        digits, exponent = digits // 10, exponent + 1
    return decimal(digits, exponent), f"{hundredths}e{exponent - DIGITS - 1}"


def _exponent(value: Fraction) -> int:
    exponent = len(str(value.numerator)) - len(str(value.denominator))
    return exponent if Fraction(10) ** exponent <= value else exponent - 1


def decimal(digits: int, exponent: int) -> str:
    """Return a number whose first digit has this exponent, without zeros at its end."""
    body = str(abs(digits)).rstrip("0") or "0"
    minus = "-" if digits < 0 else ""
    if 0 <= exponent < DIGITS:
        whole, part = body[: exponent + 1].ljust(exponent + 1, "0"), body[exponent + 1 :]
        return minus + whole + ("." + part if part else "")
    if -5 <= exponent < 0:
        return f"{minus}0.{'0' * (-exponent - 1)}{body}"
    return f"{minus}{body[0]}{'.' + body[1:] if body[1:] else ''}e{exponent}"
