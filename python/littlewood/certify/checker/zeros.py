"""Guards, and their zeros: what stays positive as long as a phase lasts.

A guard is a polynomial in s, 0 ≤ s ≤ 1, and a bound on what it leaves out. A zero of known order at the start of a
phase has been divided out of it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from .ranges import Inconclusive, Range, exceeds
from .series import at


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
        """Enclose the derivative between two points: in the middle, and the second derivative by its coefficients."""
        numbered = list(enumerate(self.coefficients))
        middle, half = (low + high) / 2, ((high - low) / 2).largest()
        first = at((one * k for k, one in reversed(numbered[1:])), middle)
        second = at((one.largest() * (k * (k - 1)) for k, one in reversed(numbered[2:])), high.largest())
        return first.widened((second * half).largest()).widened(self.slope_off)

    def between(self, low: Range, high: Range) -> Range:
        """Enclose the values between two points."""
        middle, half = (low + high) / 2, ((high - low) / 2).largest()
        return self.value(middle).widened((self.slope(low, high).largest() * half).largest())


def first_zero(guards: Mapping[str, Guard]) -> tuple[str, Range] | None:
    """Return the first zero of a guard in a step, all others being positive up to it; None if all of them are."""
    work = [(Range(0), Range(1 << Range.bits))]
    while work:
        low, high = work.pop()
        doubtful, falls = [], False
        for name, guard in guards.items():
            if exceeds(guard.between(low, high), 0):
                continue
            slope, first, last = guard.slope(low, high), guard.value(low), guard.value(high)
            falls = exceeds(0 - slope, 0)
            if (falls or exceeds(slope, 0)) and exceeds(first, 0) and exceeds(last, 0):
                continue
            doubtful.append(name)
            falls = falls and exceeds(first, 0) and exceeds(0 - last, 0)
        if len(doubtful) == 1 and falls:
            return doubtful[0], zero(guards[doubtful[0]], low, high, 1)
        if doubtful:
            work += _halves(low, high, f"whether {doubtful[0]} vanishes is not decided")
    return None


def _halves(low: Range, high: Range, unless: str) -> list[tuple[Range, Range]]:
    """Return both halves, the first last."""
    if (high - low).m < 1 << (Range.bits // 4):
        raise Inconclusive(unless)
    middle = Range((low.m + high.m) // 2)
    return [(middle, high), (low, middle)]


def zero(guard: Guard, low: Range, high: Range, side: int) -> Range:
    """Return the one zero of a guard between two points, at the first of which it has the sign `side`.

    Bisection until the slope has one sign, then Newton's method on enclosures, with bisection where it does not
    narrow them.
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
