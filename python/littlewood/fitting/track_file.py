"""Tracked motions in files: the channels of a table."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from .._internal.elementwise import Reals
from .._internal.table_layouts import read_text_table
from .._internal.text_table import TableFileError, TextTable
from .table_options import TableOptions
from .track_columns import columns_of, marker_of, time_column
from .track_units import OF_MARKER, Numbers, Times, in_metres, in_radians, in_seconds, is_in_si

if TYPE_CHECKING:
    from ..units import Units

__all__ = ["TrackFile", "read_track"]


@dataclass(frozen=True)
class TrackFile:
    """The channels of a file; in s, rad and m, or dimensionless."""

    is_si: bool
    time: Reals
    theta: Reals | None
    x: Reals | None
    y: Reals | None
    notes: tuple[str, ...]


def read_track(path: str | Path, units: Units | None, options: TableOptions) -> TrackFile:
    """Read the channels of a file, as :meth:`littlewood.Track.from_csv` describes it."""
    numbers = _numbers(path, options)
    table = numbers.table
    is_si = is_in_si(numbers, units)
    if is_si and units is None:
        raise TableFileError(
            table.path, "is in SI units", hint="make the hoop by Hoop.from_si, and give its units"
        )
    if units is not None and is_si:
        times, found = in_seconds(numbers), in_metres(numbers, units.length_m)
        if "theta" in numbers.values:
            found["theta"] = in_radians(numbers, units.length_m)
    else:
        times, found = Times(numbers.times, ()), dict(numbers.values)
    table.check_growing(numbers.time.place, times.seconds.tolist())
    if "x" + OF_MARKER in found or "y" + OF_MARKER in found:
        if "theta" in found or not {"x", "y", "x" + OF_MARKER, "y" + OF_MARKER} <= set(found):
            raise table.refusal("needs x and y of both points, and no angle beside them")
        across, up = (found[name + OF_MARKER] - found[name] for name in ("x", "y"))
        found["theta"] = np.arctan2(-across, up)
    theta, x, y = (found.get(name) for name in ("theta", "x", "y"))
    return TrackFile(is_si, times.seconds, theta, x, y, times.notes)


def _numbers(path: str | Path, options: TableOptions) -> Numbers:
    """Return the numbers of the columns that are channels."""
    table = read_text_table(path)
    columns = columns_of(table, options)
    time = time_column(table, columns, options)
    marker = marker_of(table, columns, options)
    used = {
        one.channel + (OF_MARKER if one.point and one.point == marker else ""): one
        for one in columns
        if one.channel in ("theta", "x", "y")
    }
    if not used:
        raise table.refusal(
            "has neither an angle nor a position", hint="columns are theta_deg, x_m, y_m"
        )
    # Runs and trajectories differ in length.
    table = table.with_some_of([time.place, *(one.place for one in used.values())])
    values = {name: np.array(table.numbers(one.place, False)) for name, one in used.items()}
    for name, one in used.items():
        if not np.any(np.isfinite(values[name])):
            raise TableFileError(
                table.path,
                "has no number",
                column=one.name,
                hint="remove the column if it was not tracked",
            )
    _check_seen(table, values)
    times = np.array(table.numbers(time.place, True))
    return Numbers(table, options, time, used, times, values)


def _check_seen(table: TextTable, values: Mapping[str, Reals]) -> None:
    """Refuse marks of what was not seen: one whole number, not positive, in all channels of a row.

    A centre at the origin is in no contact; in the first row it may be where axes were laid.
    """
    if len(values) < 2:
        return
    all_of = np.array(list(values.values()))
    marks = np.all(all_of == all_of[0], axis=0) & (all_of[0] == np.round(all_of[0]))
    marks &= all_of[0] <= 0.0 if "y" in values else all_of[0] < 0.0
    marks[0] &= all_of[0, 0] < 0.0
    if marks.any():
        k = int(np.argmax(marks))
        raise TableFileError(
            table.path,
            f"has {all_of[0, k]:g} in all columns of the track, as programs write where they saw "
            "nothing",
            line=table.lines[k],
            hint="leave these cells empty",
        )
