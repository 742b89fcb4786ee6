"""Episodes of a motion by positions: rolling, sliding either way, flight.

The same rule reads the record of a solver and the exact motion at the same instants: what it leaves
out is in both.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from .._internal.elementwise import Reals
from .record import Record

__all__ = ["Episode", "Event", "Tolerances", "read_events"]


FLIGHT, ROLLING, FORWARD, BACKWARD, IMPACT = "flight", "rolling", "sliding +", "sliding -", "impact"
_OF_CODE = {0: ROLLING, 1: FORWARD, -1: BACKWARD, 2: FLIGHT, 3: IMPACT}

_SHORT = 3.0
"""What is shorter than so many steps of a record is not told from an instant."""

_SLACK = 1.5
"""How far a height that counts as contact explains an impact, as a factor.

A contact between two flights is an impact if it explains it, so many times over.
"""


@dataclass(frozen=True)
class Tolerances:
    """Within which a hoop counts as in contact, or as rolling.

    Attributes
    ----------
    gap : float
        Height of the rim over the plane, R.
    slip : float
        Slip velocity, √(gR).
    time : float
        An event farther from the exact one is not the same, √(R/g).
    """

    gap: float = 1e-3
    slip: float = 1e-2
    time: float = 0.25

    def __post_init__(self) -> None:
        for name, unit in (("gap", "R"), ("slip", "sqrt(g R)"), ("time", "sqrt(R/g)")):
            value = getattr(self, name)
            if not 0.0 < value < np.inf:
                raise ValueError(f"{name} = {value} {unit} must be positive and finite")


class Episode(NamedTuple):
    """A time in which a hoop does one thing."""

    what: str
    start: float
    end: float


class Event(NamedTuple):
    """A change from one to another, or an impact between two flights."""

    kind: str
    time: float


def read_events(record: Record, within: Tolerances) -> list[Event]:
    """Return the events that a record shows."""
    return _events(_episodes(record, within), record.step, within)


def _episodes(record: Record, within: Tolerances) -> list[Episode]:
    """The episodes of a record, its slip velocity being that of the middle between two instants."""
    time = record.time
    middle = 0.5 * (time[1:] + time[:-1])
    slip = record.slip_between
    gap = record.y - 1.0 if record.contact is None else np.where(record.contact, 0.0, np.inf)
    # An interval is in flight if the rim is above at both of its ends; a touch between them is
    # found below.
    is_high = np.minimum(gap[1:], gap[:-1]) > within.gap
    codes = np.where(is_high, 2.0, np.where(np.abs(slip) > within.slip, np.sign(slip), 0.0)).astype(
        np.int8
    )
    for a, b in _contacts_between_flights(is_high):
        start, end = (_crossing(time, gap, i, within.gap) for i in (a, b))
        if end - start < _SHORT * record.step + _SLACK * (
            _passage(record, a, within) + _passage(record, b, within)
        ):
            codes[a:b] = 3
    cuts = []
    changes = np.flatnonzero(np.diff(codes)).tolist()
    for i in changes:
        a, b = codes[i], codes[i + 1]
        if 2 in (a, b):
            # The interval in contact has the limit in it: it is low at its other end.
            cuts.append(_crossing(time, gap, i if b == 2 else i + 1, within.gap))
        else:
            bound = within.slip * (np.sign(slip[i + 1]) if a == 0 else np.sign(slip[i]))
            cuts.append(_between(middle[i], slip[i], middle[i + 1], slip[i + 1], bound))
    edges = [float(time[0]), *cuts, float(time[-1])]
    whats = [_OF_CODE[int(codes[at])] for at in (0, *(i + 1 for i in changes))]
    found = (Episode(*one) for one in zip(whats, edges[:-1], edges[1:], strict=True))
    return [part for episode in found for part in _parted(episode, record, within)]


def _contacts_between_flights(is_high: npt.NDArray[np.bool_]) -> list[tuple[int, int]]:
    """First interval, and that after the last, of each run in contact.

    Each begins and ends with a flight.
    """
    begins = np.flatnonzero(is_high[:-1] & ~is_high[1:]) + 1
    ends = np.flatnonzero(~is_high[:-1] & is_high[1:]) + 1
    return [(int(a), int(ends[ends > a][0])) for a in begins if np.any(ends > a)]


def _passage(record: Record, i: int, within: Tolerances) -> float:
    """How long the rim takes through the height that counts as contact.

    It has its velocity at an edge of the contact.
    """
    if record.contact is not None:
        return 0.0
    low = max(i - 1, 0)
    fall = abs(record.y[i + 1] - record.y[low]) / (record.time[i + 1] - record.time[low])
    return float(within.gap / fall) if fall > 0.0 else np.inf


def _between(a: float, at_a: float, b: float, at_b: float, bound: float) -> float:
    """Where a line through two values meets a bound between them."""
    share = (bound - at_a) / (at_b - at_a) if at_b != at_a else 0.5
    return float(a + np.clip(share, 0.0, 1.0) * (b - a))


def _crossing(time: Reals, gap: Reals, i: int, bound: float) -> float:
    if not np.all(np.isfinite(gap[i : i + 2])):
        # The solver says which instants are in contact, and not what is between them.
        return float(0.5 * (time[i] + time[i + 1]))
    return _between(time[i], gap[i], time[i + 1], gap[i + 1], bound)


def _parted(episode: Episode, record: Record, within: Tolerances) -> list[Episode]:
    """A flight between two instants.

    It is parted where lines through the heights before and behind meet on the plane.
    """
    if episode.what != FLIGHT:
        return [episode]
    time, gap = record.time, record.y - 1.0
    at = np.flatnonzero((time > episode.start) & (time < episode.end))
    touches = []
    for i in at[1:-2]:
        before = (gap[i] - gap[i - 1]) / (time[i] - time[i - 1])
        behind = (gap[i + 2] - gap[i + 1]) / (time[i + 2] - time[i + 1])
        if before < 0.0 < behind:
            touch = (gap[i + 1] - gap[i] + before * time[i] - behind * time[i + 1]) / (
                before - behind
            )
            is_between = time[i] <= touch <= time[i + 1]
            if is_between and gap[i] + before * (touch - time[i]) <= within.gap:
                touches.append(float(touch))
    parts = []
    start = episode.start
    for touch in touches:
        parts += [Episode(FLIGHT, start, touch), Episode(IMPACT, touch, touch)]
        start = touch
    return [*parts, Episode(FLIGHT, start, episode.end)]


def _events(episodes: list[Episode], step: float, within: Tolerances) -> list[Event]:
    """The events between episodes; an episode shorter than a few steps of the record is an instant.

    A contact between two flights is an impact, and a passage of the slip velocity through zero a
    reversal, or nothing.
    """
    shortest = _SHORT * step
    # A rim that counts as in contact may still fall, with a velocity of about 1 √(gR).
    falling = shortest + within.gap
    found: list[Event] = []
    # A landing is one episode, whatever the hoop does in its first steps.
    merged: list[Episode] = []
    for episode in episodes:
        if (
            merged
            and not {FLIGHT, IMPACT} & {episode.what, merged[-1].what}
            and _is_short(merged, episode, shortest)
        ):
            merged[-1] = Episode(merged[-1].what, merged[-1].start, episode.end)
        elif episode.what == ROLLING and len(merged) > 1 and _is_short(merged, merged[-1], falling):
            # At a landing that sticks the slip velocity of the flight is no sliding.
            merged[-1] = Episode(ROLLING, merged[-1].start, episode.end)
        else:
            merged.append(episode)
    before = merged[0]
    for at, episode in enumerate(merged[1:], start=1):
        behind = merged[at + 1] if at + 1 < len(merged) else None
        if episode.what == IMPACT:
            found.append(Event(IMPACT, 0.5 * (episode.start + episode.end)))
            continue
        is_short = episode.end - episode.start < shortest
        if (
            is_short
            and behind is not None
            and episode.what == ROLLING
            and FLIGHT not in (before.what, behind.what)
        ):
            if before.what != behind.what:
                found.append(Event("reversal", 0.5 * (episode.start + episode.end)))
            before = behind
            continue
        if episode.what != before.what:
            found.append(Event(_kind(before.what, episode.what), episode.start))
        before = episode
    return found


def _is_short(merged: list[Episode], episode: Episode, shortest: float) -> bool:
    after_flight = len(merged) > 1 and merged[-2].what == FLIGHT
    return after_flight and episode.end - merged[-1].start < shortest


def _kind(before: str, behind: str) -> str:
    if behind == FLIGHT:
        return "lift_off"
    if before == FLIGHT:
        return "landing"
    if behind == ROLLING:
        return "stick"
    return "slip" if before == ROLLING else "reversal"
