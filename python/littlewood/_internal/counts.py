"""Counts that a user gives: whole numbers between two bounds."""

from __future__ import annotations

import operator
from typing import SupportsIndex

from .. import _core

__all__ = ["checked_count", "checked_limits"]


def checked_count(
    name: str, value: SupportsIndex, least: int, most: int, hint: str | None = None
) -> int:
    """Return a whole number.

    Refuse one beyond its bounds, before anything is computed or allocated.
    """
    try:
        count = operator.index(value)
    except TypeError:
        raise TypeError(f"{name} = {value!r} must be a whole number") from None
    if count < least:
        raise ValueError(f"{name} = {count} must not be less than {least}")
    if count > most:
        raise ValueError(f"{name} = {count} must not exceed {most}" + (f"; {hint}" if hint else ""))
    return count


def checked_limits(max_transitions: SupportsIndex, max_slides: SupportsIndex) -> tuple[int, int]:
    """Return the limits of a motion that are counts; refuse those beyond their bounds."""
    return (
        checked_count("max_transitions", max_transitions, 0, _core.MOST_COUNT),
        checked_count("max_slides", max_slides, 0, _core.MOST_COUNT),
    )
