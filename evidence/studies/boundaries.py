"""Boundaries between sequences of the first turn: frictions at which two events coincide.

They are on lines of γ and θ′.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from .turns import Floats, Texts, Turn, first_turn, names_of

WIDTH = 1e-12
"""Part of the friction to which a boundary is told."""

AWAY = (1e-12, 1e-11, 1e-10)
"""Parts of the friction by which a side is left, where it has another sequence when it is
simulated."""

NOTHING = 1e-9
"""Part of the friction below which the distance of two boundaries is none: there the order of two
events is rounded."""

NOT_TOLD = "not told"

Line = tuple[float, float]
"""γ, and the part of 1/√γ that θ′ at the top is."""


def rate_of(gamma: Floats, part: Floats) -> Floats:
    """Return θ′ at the top."""
    return part / np.sqrt(gamma)


@dataclass(frozen=True)
class Boundary:
    """A friction at which the sequence changes on a line, between two that are next to each other.

    Parameters
    ----------
    gamma, part : float
        The line.
    low, high : float
        Frictions on both sides.
    below, above : str
        Sequences there, with their stops.
    """

    gamma: float
    part: float
    low: float
    high: float
    below: str
    above: str

    @property
    def mu(self) -> float:
        """The friction."""
        return 0.5 * (self.low + self.high)

    @property
    def rate(self) -> float:
        """θ′ at the top."""
        return self.part / math.sqrt(self.gamma)

    @property
    def sides(self) -> tuple[str, str]:
        """The sequences with stops below and above."""
        return self.below, self.above

    @property
    def turns(self) -> tuple[Turn, Turn]:
        """The turns below and above, as near to the boundary as the simulation has them.

        It rounds otherwise.
        """
        return self._turn(self.low, self.below, -1.0), self._turn(self.high, self.above, 1.0)

    def _turn(self, mu: float, name: str, away: float) -> Turn:
        turns = [first_turn(self.gamma, mu, self.rate, len(name.split()[0]))]
        for width in AWAY:
            if turns[-1].name == name:
                return turns[-1]
            turns.append(
                first_turn(self.gamma, mu * (1.0 + away * width), self.rate, len(name.split()[0]))
            )
        return turns[-1] if turns[-1].name == name else turns[0]

    @cached_property
    def kind(self) -> str:
        """What coincides: told by the phases that only one of the sides has."""
        (one, stop), (other, other_stop) = (
            self.below.split(maxsplit=1),
            self.above.split(maxsplit=1),
        )
        shorter, longer = sorted((one.rstrip("F"), other.rstrip("F")), key=len)
        if shorter == longer:
            return "two stops"
        if stop != other_stop:
            return NOT_TOLD
        more = len(longer) - len(shorter)
        places = [
            place
            for place in range(len(shorter) + 1)
            if longer[:place] + longer[place + more :] == shorter
        ]
        kinds = {place: _kind(longer, place, more, stop) for place in places}
        told = {place: kind for place, kind in kinds.items() if kind != NOT_TOLD}
        if len(set(told.values())) < 2:
            return next(iter(told.values()), NOT_TOLD)
        # Phases of the same names: those are more that begin with the shortest.
        durations = next(turn for turn in self.turns if turn.word.rstrip("F") == longer).durations
        return told[min(told, key=lambda place: durations[place])]


def _kind(word: str, place: int, more: int, stop: str) -> str:
    """Return what coincides where phases of a sequence, from a place on, have no duration."""
    phases, before = word[place : place + more], word[place - 1 : place]
    if more == 1:
        if place + 1 == len(word) and stop != "lifts off":
            return "an event at the stop"
        return "a roll without duration" if phases == "R" else "a slide without duration"
    if phases == f"R{before}":
        return "a slip that touches zero"
    if before == "R" and set(phases[::2]) <= set("+-") and set(phases[1::2]) == {"R"}:
        return "a slip out of nothing"
    return NOT_TOLD


def boundaries(
    lines: Sequence[Line],
    least: float | Floats,
    most: float | Floats,
    count: int,
    width: float = WIDTH,
) -> list[Boundary]:
    """Return where the sequence changes between neighbours of a scan.

    Line by line, with rising friction.

    Each is told to a part of μ, the last digits by default; all lines are halved at once. Every
    line may have limits of its own.
    """
    if not len(lines):
        return []
    line_gamma, line_part = np.array(lines, dtype=float).T
    every = np.ones(len(lines))
    frictions = np.geomspace(least * every, most * every, count, axis=1)
    rates = np.repeat(rate_of(line_gamma, line_part), count)
    scanned = names_of(np.repeat(line_gamma, count), frictions.ravel(), rates).reshape(
        len(lines), count
    )
    line, place = np.nonzero(scanned[:, 1:] != scanned[:, :-1])
    low, high = frictions[line, place], frictions[line, place + 1]
    below, above = scanned[line, place], scanned[line, place + 1]
    found: list[tuple[int, float, float, str, str]] = []
    while len(line):
        done = high - low < width * high
        found += zip(line[done], low[done], high[done], below[done], above[done], strict=True)
        line, low, high, below, above = (
            line[~done],
            low[~done],
            high[~done],
            below[~done],
            above[~done],
        )
        middle = 0.5 * (low + high)
        names = names_of(line_gamma[line], middle, rate_of(line_gamma[line], line_part[line]))
        left, right = np.flatnonzero(names != below), np.flatnonzero(names != above)
        line = np.concatenate((line[left], line[right]))
        low, high = (
            np.concatenate((low[left], middle[right])),
            np.concatenate((middle[left], high[right])),
        )
        below, above = (
            np.concatenate((below[left], names[right])),
            np.concatenate((names[left], above[right])),
        )
    return _merged(
        [Boundary(*lines[k], float(a), float(b), str(c), str(d)) for k, a, b, c, d in sorted(found)]
    )


def _merged(found: list[Boundary]) -> list[Boundary]:
    """Join boundaries between which there is nothing."""
    joined: list[Boundary] = []
    for one in found:
        last = joined[-1] if joined else None
        if (
            last
            and (last.gamma, last.part) == (one.gamma, one.part)
            and one.low - last.high < NOTHING * one.low
        ):
            joined[-1] = Boundary(one.gamma, one.part, last.low, one.high, last.below, one.above)
        else:
            joined.append(one)
    return [one for one in joined if one.below != one.above]


def points_between(
    gamma: Floats,
    part: Floats,
    guess: Floats,
    sides: Sequence[tuple[str, str]],
    widths: Sequence[float],
    tolerance: float,
) -> Floats:
    """Return the friction near each guess at which one sequence passes into another, or NaN.

    It is looked for in intervals that grow: in the least that has both sequences at its ends no
    third is hidden.
    """
    found = np.full(len(guess), math.nan)
    below, above = (
        np.array([one for one, _ in sides], dtype="U32"),
        np.array([one for _, one in sides], dtype="U32"),
    )
    rate = rate_of(gamma, part)
    for width in widths:
        one = np.flatnonzero(np.isnan(found))
        low, high = guess[one] / (1.0 + width), guess[one] * (1.0 + width)
        one, low, high = _halved(one, low, high, (gamma, rate), (below, above), tolerance)
        found[one] = 0.5 * (low + high)
    return found


Places = np.ndarray[tuple[int], np.dtype[np.intp]]


def _halved(
    one: Places,
    low: Floats,
    high: Floats,
    line: tuple[Floats, Floats],
    sides: tuple[Texts, Texts],
    tolerance: float,
) -> tuple[Places, Floats, Floats]:
    """Return the intervals whose ends and middles have only the two sequences.

    They are halved to a tolerance.
    """
    (gamma, rate), (below, above) = line, sides
    if not len(one):
        return one, low, high
    fits = (names_of(gamma[one], low, rate[one]) == below[one]) & (
        names_of(gamma[one], high, rate[one]) == above[one]
    )
    one, low, high = one[fits], low[fits], high[fits]
    while len(one) and np.any(high - low > tolerance * high):
        middle = 0.5 * (low + high)
        names = names_of(gamma[one], middle, rate[one])
        is_below, fits = names == below[one], (names == below[one]) | (names == above[one])
        low, high = np.where(is_below, middle, low), np.where(is_below, high, middle)
        one, low, high = one[fits], low[fits], high[fits]
    return one, low, high
