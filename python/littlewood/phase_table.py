"""The phases of a motion with its impacts, as the rows of a table."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, NamedTuple

from .tables import ARROWS, CAUSE_LABELS, SAMPLE_COLUMNS

if TYPE_CHECKING:
    from .motion import Impact, Phase, State, Transition
    from .trajectory import Trajectory

TIME = SAMPLE_COLUMNS["time"]

# What is told of the start of a phase besides the time.
TOLD = [SAMPLE_COLUMNS[name] for name in ("theta", "theta_rate", "slip")]

HEADINGS = ("#", "motion", f"from {TIME.sign}", "duration", *(one.sign for one in TOLD), "lost", "ends by")

# Columns of words.
LEFT = (0, 1, 8)

# Flights of a sequence of bounces that have a row each, and how many more are worth one together.
_FIRST_FLIGHTS = 4
_LEAST_TOGETHER = 3


class Row(NamedTuple):
    """A row: the mode whose colour it has, if any, and what is written."""

    mode: str | None
    cells: tuple[str, ...]


def number(value: float) -> str:
    """Write a number of a table; one that rounds to zero has no sign."""
    return "∞" if math.isinf(value) else f"{round(value, 5) + 0.0:.5f}"


def rows(motion: Trajectory) -> Iterator[Row]:
    """Yield the rows: each phase, each impact with the state just before it, and later bounces in one row together."""
    folds = _folds(motion)
    first = told = 0
    while first < len(motion.phases):
        stop = folds.get(first, first + 1)
        # What comes before the transition that ends a phase, and ends none, is a jam that led to the phase.
        ends = _place_of_end(motion, first)
        yield from _jumps(motion.transitions[told:ends])
        told = _place_of_end(motion, stop - 1) + 1
        if stop == first + 1:
            yield _phase_row(motion, first)
            yield from _jumps(motion.transitions[ends:told])
        else:
            yield _bounces_row(motion, first, stop)
        first = stop
    yield from _jumps(motion.transitions[told:])


def _place_of_end(motion: Trajectory, i: int) -> int:
    place = motion.phases[i].ended_by
    return len(motion.transitions) if place is None else place


def _folds(motion: Trajectory) -> dict[int, int]:
    """Return where flights begin that share a row, and where they end: the later ones of many bounces."""
    folds = {}
    begin = 0
    for i, phase in enumerate(motion.phases):
        end = motion.end_of(phase)
        if end is None or (end.cause, end.to_mode) != ("landing", "flight"):
            if i + 1 - begin >= _FIRST_FLIGHTS + _LEAST_TOGETHER:
                folds[begin + _FIRST_FLIGHTS] = i + 1
            begin = i + 1
    return folds


def _ends_by(motion: Trajectory, phase: Phase) -> str:
    end = motion.end_of(phase)
    return motion.outcome.label if end is None else CAUSE_LABELS[end.cause]


def _state(state: State, duration: str) -> tuple[str, ...]:
    return (number(state.time), duration, *(number(getattr(state, one.name)) for one in TOLD))


def _lost(impacts: Iterable[Impact | None]) -> str:
    return number(math.fsum(impact.energy_lost for impact in impacts if impact is not None))


def _phase_row(motion: Trajectory, i: int) -> Row:
    phase, end = motion.phases[i], motion.end_of(motion.phases[i])
    start = _state(phase.start, number(phase.duration))
    if end is not None and end.cause == "settle":
        return Row(phase.mode, (str(i + 1), "bounces", *start, _lost([end.impact]), _ends_by(motion, phase)))
    name = f"{phase.mode} {ARROWS[phase.direction]}".strip()
    return Row(phase.mode, (str(i + 1), name, *start, number(phase.energy_lost), _ends_by(motion, phase)))


def _bounces_row(motion: Trajectory, first: int, stop: int) -> Row:
    flights = motion.phases[first:stop]
    ends = [motion.end_of(flight) for flight in flights]
    start = _state(flights[0].start, number(flights[-1].end_time - flights[0].start_time))
    lost = _lost(end.impact for end in ends if end is not None)
    words = (f"{first + 1}–{stop}", f"{len(flights)} bounces")
    return Row(flights[0].mode, (*words, *start, lost, _ends_by(motion, flights[-1])))


def _jumps(transitions: Iterable[Transition]) -> Iterator[Row]:
    """Yield the impacts among transitions; those of bounces that settle are in the row of the bounces."""
    for transition in transitions:
        if transition.impact is not None and transition.cause != "settle":
            name = "jam" if transition.cause == "jam" else "impact"
            cells = ("", name, *_state(transition.state, ""), _lost([transition.impact]), transition.impact.label)
            yield Row(None, cells)
