"""The rotation down a slope that repeats itself: what a turn gains from gravity, resistance takes.

theta'^2 after a turn of rolling is found by the series of the balances; nothing here uses that it
is linear in theta'^2 before it, but for the iteration, whose error is then that of rounding, and
which is checked.
"""

from typing import NamedTuple

import gmpy2
from follower.arithmetic import Tie, Work
from follower.roots import fall_of
from follower.series import reach
from gmpy2 import mpfr

from .balances import State, contact_mode
from .phase import Piece, events, first, series, state_at


class Rotation(NamedTuple):
    """theta'^2 of the periodic rotation at the top, and what else is known of it.

    Its period, how much of a difference a turn leaves, and the largest |F|/N.
    """

    square_rate: mpfr
    period: mpfr
    contraction: mpfr
    demand: mpfr


def turn(body, square_rate, heading):
    """A turn of a hoop that rolls from the top.

    (theta'^2 at the next top, time, largest |F|/N at the ends of the steps).
    """
    mode = contact_mode(0, heading)
    state = State(mpfr(0), heading * gmpy2.sqrt(square_rate), mpfr(0), mpfr(0))
    whole, time, demand = 2 * gmpy2.const_pi(), mpfr(0), mpfr(0)
    for _ in range(Work.steps):
        parts = series(body, mode, state)
        demand = max(demand, abs(parts.friction[0]) / parts.normal[0])
        length = mpfr(reach(parts[:6]))
        left = [-heading * v for v in parts.theta]
        left[0] += whole
        end = fall_of(left, length)
        event = first(events(body, mode, parts, length), length, length if end is None else end)
        if event.cause not in (None, "limit"):
            raise Tie(f"no turn: {event.cause}")
        state = state_at(Piece(mpfr(0), state.x, parts), event.time)
        time += event.time
        if end is not None:
            return state.rate * state.rate, time, demand
    raise Tie("too many steps")


def rotation(body, guess, heading):
    """The periodic rotation, by the secant rule from two turns; a third must return."""
    guess = mpfr(guess)
    step = guess / 16
    here, there = (turn(body, v, heading)[0] for v in (guess, guess + step))
    contraction = (there - here) / step
    square = (here - contraction * guess) / (1 - contraction)
    again, period, demand = turn(body, square, heading)
    if abs(again - square) > mpfr("1e-36") * (1 + square):
        raise Tie("no periodic rotation")
    return Rotation(square, period, contraction, demand)
