"""Counts that a user gives: whole numbers between two bounds."""

from __future__ import annotations

import operator
from typing import SupportsIndex

__all__ = ["checked_count"]


def checked_count(name: str, value: SupportsIndex, least: int, most: int) -> int:
    """Return a count; refuse one beyond its bounds, before anything is computed or allocated.

    Raises
    ------
    TypeError
        For what is no whole number.
    ValueError
        Names the count and the bound that it breaks.
    """
    count = operator.index(value)
    if count < least:
        raise ValueError(f"{name} = {count} must not be less than {least}")
    if count > most:
        raise ValueError(f"{name} = {count} must not exceed {most}")
    return count
