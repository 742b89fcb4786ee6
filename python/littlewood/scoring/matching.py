"""Which event of a solver is which of the exact motion."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from .episodes import Event

__all__ = ["is_same", "match", "may_show"]

_READ_AS = {
    "graze": (),
    "jam": ("stick", "reversal", "lift_off", "impact"),
    "landing": ("landing", "impact"),
    "settle": ("landing",),
    "normal_force_zero": ("slip",),
    "reversal": ("reversal", "stick"),
}
"""How a cause can look in positions, if not only like itself."""


_AFTER_JAM = {"stick", "reversal"}
"""If a slide goes on the other way after a jam, the tolerance of slip decides which is read."""


def is_same(exact: Event, found: Event, cause: str | None = None) -> bool:
    """Whether two events are of one kind, or are a jam read in two ways."""
    return exact.kind == found.kind or (cause == "jam" and {exact.kind, found.kind} == _AFTER_JAM)


def may_show(cause: Event, read: Event) -> bool:
    """Whether a transition can look like an event that is read from positions."""
    return read.kind in _READ_AS.get(cause.kind, (cause.kind,))


def match(
    exact: Sequence[Event],
    found: Sequence[Event],
    farthest: float,
    may_be: Callable[[Event, Event], bool] = is_same,
) -> list[tuple[Event | None, Event | None]]:
    """Pair the events of the exact motion and of the solver in their order.

    Events that may be the same are a pair if they are not `farthest` apart, √(R/g). A missed event
    is paired with None, and None with a spurious one. Of all pairings this has the least sum of
    distances, one without a partner counting as `farthest`.
    """
    rows, columns = len(exact), len(found)
    cost = np.empty((rows + 1, columns + 1))
    cost[:, 0] = farthest * np.arange(rows + 1)
    cost[0, :] = farthest * np.arange(columns + 1)
    for i, one in enumerate(exact, start=1):
        for j, other in enumerate(found, start=1):
            cost[i, j] = min(cost[i - 1, j] + farthest, cost[i, j - 1] + farthest)
            distance = abs(other.time - one.time)
            if may_be(one, other) and distance <= farthest:
                cost[i, j] = min(cost[i, j], cost[i - 1, j - 1] + distance)
    pairs: list[tuple[Event | None, Event | None]] = []
    i, j = rows, columns
    while i > 0 or j > 0:
        if i > 0 and j > 0:
            one, other = exact[i - 1], found[j - 1]
            distance = abs(other.time - one.time)
            is_pair = may_be(one, other) and distance <= farthest
            if is_pair and cost[i, j] == cost[i - 1, j - 1] + distance:
                pairs.append((one, other))
                i, j = i - 1, j - 1
                continue
        if i > 0 and cost[i, j] == cost[i - 1, j] + farthest:
            pairs.append((exact[i - 1], None))
            i -= 1
        else:
            pairs.append((None, found[j - 1]))
            j -= 1
    return pairs[::-1]
