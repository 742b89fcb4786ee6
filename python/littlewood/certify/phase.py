"""What every phase of a motion is.

Pieces in a parameter, on each of which state and guards are analytic functions.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from .balls import Ball, Beyond, Undecided
from .body import State
from .model import Model, crossing_of, first_crossing

TIME = "time_limit"
"""The guard that falls through zero where time is up."""


@dataclass(frozen=True)
class Piece:
    """A piece of a phase between two values of its parameter."""

    low: Ball
    high: Ball
    elapsed: Model
    guards: dict[str, Model]
    state: Callable[[Ball], State]
    """The state, from the parameter."""
    swept: Model | None = None
    """In a slide with rolling resistance, ∫ cos θ θ′² |dθ|, from the parameter."""


@dataclass
class Followed:
    """A phase that has been followed to its end."""

    end: State
    guard: str
    """What vanishes there; nothing where the pieces have come to an end without."""
    pieces: list[tuple[Piece, Ball]]
    """The pieces with their ends."""

    def at(self, start: Ball, time: Ball) -> State:
        """Return the state at a time."""
        for piece, end in self.pieces:
            if not piece.state(end).time < time:
                # A little beyond the end where the time may be that of the end.
                last = end if piece.state(end).time > time else end + (end - piece.low) / 8
                return piece.state(crossing_of(piece.elapsed - (time - start), piece.low, last))
        raise Undecided("a sample is not within its phase")


def follow(start: Ball, pieces: Iterator[Piece], until: Ball | None, most: int) -> Followed:
    """Follow pieces to the first zero of a guard."""
    passed: list[tuple[Piece, Ball]] = []
    for piece in pieces:
        if len(passed) >= most:
            raise Beyond("the motion takes too many pieces")
        guards = dict(piece.guards)
        if until is not None:
            guards[TIME] = (until - start) - piece.elapsed
        crossing = first_crossing(guards, piece.low, piece.high)
        end = piece.high if crossing is None else crossing.at
        passed.append((piece, end))
        if crossing is not None:
            return Followed(piece.state(end), crossing.guard, passed)
    return Followed(passed[-1][0].state(passed[-1][1]), "", passed)
