"""Functions of θ and θ′ on discs of the complex plane around a real point: in floats, each rounded up with a margin.

They tell how far a solution reaches, how large it is there, and how fast two solutions part.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from .ranges import Range


class Wide(Exception):
    """A disc is too wide: a divisor may be 0, or an angle goes too far."""


@dataclass(frozen=True)
class Disc:
    """Values not farther from the centre than the radius, and bounds of the derivatives by θ and θ′."""

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
            self.c + other.c, self.r + other.r, self.by_theta + other.by_theta, self.by_rate + other.by_rate
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
        return self * _rounded(1 / other.c, other.r / (size * least), other.by_theta / square, other.by_rate / square)


def _disc(value: Disc | int) -> Disc:
    return value if isinstance(value, Disc) else Disc(float(value))


def _rounded(c: float, r: float, by_theta: float = 0.0, by_rate: float = 0.0) -> Disc:
    more = 1 + 1e-12
    return Disc(c, r * more + abs(c) * 1e-14 + 1e-250, by_theta * more, by_rate * more)


def around(value: Range, more: float = 0.0) -> Disc:
    """Return the disc around a range, with so much more as radius."""
    return _rounded(float(value), more + float(Range(value.r)))


def angle_and_rate(theta: Disc, rate: Disc) -> tuple[Disc, Disc, Disc]:
    """Return sin θ, cos θ and θ′: with z from the centre, sin (θ + z) − sin θ = sin θ (cos z − 1) + cos θ sin z."""
    if theta.r > 3:
        raise Wide
    sin, cos = math.sin(theta.c), math.cos(theta.c)
    bend, turn, most = math.cosh(theta.r) - 1 + 1e-14, math.sinh(theta.r) + 1e-14, math.cosh(theta.r)
    s, c = abs(sin) * bend + abs(cos) * turn, abs(cos) * bend + abs(sin) * turn
    return (
        _rounded(sin, s, min(most, abs(cos) + c)),
        _rounded(cos, c, min(most, abs(sin) + s)),
        Disc(rate.c, rate.r, 0.0, 1.0),
    )
