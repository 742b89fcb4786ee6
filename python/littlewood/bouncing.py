"""Motions that bounce for ever."""

from __future__ import annotations

from dataclasses import dataclass

from .motion import Start

__all__ = ["BouncingOrbit"]


@dataclass(frozen=True)
class BouncingOrbit:
    """A motion with two symmetric flights a turn and without slip at any impact; it needs e = 1.

    :meth:`littlewood.Hoop.bouncing_orbit` makes it.

    Attributes
    ----------
    angle : float
        Angle φ of the impacts, 0 < φ < π, rad: from θ = −φ the hoop flies over the top to φ, and on
        to 2π − φ.
    top_rate, bottom_rate : float
        Rates θ′ of the flights over the top and under the bottom, √(g/R).
    gap_rate : float
        Rate at which the gap opens after each impact, √(gR).
    friction : float
        Coefficient of static friction that sticking in the impacts needs.
    period : float
        Time of a turn, √(R/g).
    start : littlewood.Start
        Start of the flight over the top.
    """

    angle: float
    top_rate: float
    bottom_rate: float
    gap_rate: float
    friction: float
    period: float
    start: Start
