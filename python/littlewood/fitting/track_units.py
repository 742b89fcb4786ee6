"""Units of a tracked motion: what names say, what callers say, and what only sizes can say."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .._internal.elementwise import Reals
from .._internal.table_layouts import KINOVEA, PLAIN, TRACKER
from .._internal.text_table import TextTable
from .table_options import FRAME, LENGTH_UNITS, TIME_UNITS, UNITS, TableOptions
from .track_columns import Column

if TYPE_CHECKING:
    from ..units import Units

__all__ = ["OF_MARKER", "Numbers", "Times", "in_metres", "in_radians", "in_seconds", "is_in_si"]

OF_MARKER = " of the marker"
"""What follows the name of a channel of the marker."""

# A film has from so many to so many frames a second: other steps of time are in another unit.
_FEWEST, _MOST = 2.0, 2e4
# The steps of a table are those of a rate, to this part: programs round their times.
_STEP = 0.05
# Times above so many seconds count from 1970, not from the begin of a film.
_CALENDAR = 1e8
# Heights of a centre over its floor, radii, that no error of a camera makes: lower than a radius by
# far, or high above. And how far from the centre no marker is.
_LOWEST, _HIGHEST, _FARTHEST = 0.2, 30.0, 3.0
# The lowest heights are those in contact, a radius, to errors of a plane; one frame may be wrong.
_NEAR_FLOOR, _FEW = 1.5, 3
# From here on a height may be in radii: those of a centre are at least 1.
_RADIUS = 0.85
# Of the heights the lowest are those in contact; fewer are frames in which the tracker failed.
_IN_CONTACT = 0.1
# Whole numbers over so wide a range are counted, as pixels are.
_COUNTED = 10.0
# What a hoop turns by, over what it rolls by without a slip.
_LEAST_SPIN, _MOST_SPIN = 0.2, 2.5


@dataclass(frozen=True)
class Numbers:
    """The numbers of a table as they stand, and their columns, by channel.

    The channels of a marker end with `OF_MARKER`.
    """

    table: TextTable
    options: TableOptions
    time: Column
    columns: dict[str, Column]
    times: Reals
    values: dict[str, Reals]


@dataclass(frozen=True)
class Times:
    """Times in s, and what is to be known of them."""

    seconds: Reals
    notes: tuple[str, ...]


@dataclass(frozen=True)
class _Size:
    """A length of the track of which a hoop with a radius tells the size.

    It is at least and at most so many radii.
    """

    what: str
    value: float
    column: Column
    least: float
    most: float

    def fits(self, unit: float, radius: float) -> bool:
        """Whether it may be in a unit, m, if the radius is so many m."""
        return self.least <= self.value * unit / radius <= self.most


def is_in_si(numbers: Numbers, units: Units | None) -> bool:
    """Return whether a table is in SI units, and not dimensionless; refuse what may be either."""
    table, options, time = numbers.table, numbers.options, numbers.time
    said = time.unit is not None or time.channel == FRAME or table.layout in (KINOVEA, TRACKER)
    if options.dimensionless:
        if said:
            raise table.refusal(
                "is in SI units", column=time.name, hint=f"leave out {options.say('dimensionless')}"
            )
    elif said or options.plane or options.time_unit or options.length_unit:
        return True
    odd = next((one for one in numbers.columns.values() if one.unit is not None), None)
    if odd is not None:
        unit = next(iter(_units_by_step(numbers)), "s")
        raise table.refusal(
            f"is in SI units, {time.name} has no dimension",
            column=odd.name,
            hint=f"name the time time_{unit}, or say {options.say('time_unit', unit)}",
        )
    _check_counted(numbers)
    if options.dimensionless or units is None:
        _check_height(numbers, 1.0)
        return False
    size = _size(numbers)
    if size is not None and size.column.channel != "y":
        # How far the particle is from the centre is not known here.
        size = None
    _check_height(numbers, units.length_m)
    if size is None or not size.fits(1.0, units.length_m) or size.value > _RADIUS:
        found = "" if size is None else f": {size.what} is {size.value:g}"
        raise table.refusal(
            f"has no units{found}, the radius of the hoop {units.length_m:g} m",
            column=None if size is None else size.column.name,
            hint="write the units into the names (time_s, theta_rad, x_m, y_m), or say "
            f"{options.say('length_unit', 'm')} or {options.say('dimensionless')}",
        )
    return True


def in_seconds(numbers: Numbers) -> Times:
    """Return the times of a table in SI units."""
    table, options, time = numbers.table, numbers.options, numbers.time
    if time.unit is not None and options.time_unit not in (None, time.unit):
        raise table.refusal(
            f"is in {time.unit}",
            column=time.name,
            hint=f"leave out {options.say('time_unit', options.time_unit or '')}",
        )
    unit = FRAME if time.channel == FRAME else time.unit
    if unit is None:
        # Tracker knows no other.
        is_tracker = table.layout == TRACKER and options.time_unit is None
        unit = "s" if is_tracker else _unit_by_step(numbers)
    if unit == FRAME and options.fps is None:
        raise table.refusal(
            "has numbers of frames", column=time.name, hint=f"give {options.say('fps', 240)}"
        )
    size = _seconds(unit, options)
    if unit != FRAME and options.fps is not None:
        frames = _step(numbers.times) * size * options.fps
        if not abs(frames - 1.0) <= _STEP:
            raise table.refusal(
                f"has times {_step(numbers.times):.4g} {unit} apart, {frames:.4g} frames at "
                f"{options.fps:g} a second",
                column=time.name,
                hint=f"leave out {options.say('fps', options.fps)} if not each frame was tracked; "
                "if the film is in slow motion, give its program the rate at which it was taken, "
                "and export again",
            )
    first = float(numbers.times[0])
    if first * size < _CALENDAR:
        return Times(numbers.times * size, ())
    # Doubles would lose digits of what is small beside it.
    note = f"The times of the table count from its first row, {table.rows[0][time.place]}."
    return Times((numbers.times - first) * size, (note,))


def in_radians(numbers: Numbers, radius: float) -> Reals:
    """Return the angle of a table in SI units."""
    one, values = numbers.columns["theta"], numbers.values
    unit = one.unit
    if unit is None and numbers.table.layout == PLAIN and "x" in values:
        # Degrees would be 57 times the way over the radius, without a slip.
        rolled = np.ptp(_seen(values["x"])) * _metre(numbers, "x", radius) / radius
        if _LEAST_SPIN * rolled <= np.ptp(_seen(values["theta"])) <= _MOST_SPIN * rolled:
            unit = "rad"
    if unit is None:
        raise numbers.table.refusal(
            "has no unit", column=one.name, hint="name it theta_deg or theta_rad"
        )
    size = UNITS[unit].size
    assert size is not None
    return np.asarray(values["theta"] * size)


def in_metres(numbers: Numbers, radius: float) -> dict[str, Reals]:
    """Return the positions of a table in SI units."""
    plane, options = numbers.options.plane, numbers.options
    found = {name: one for name, one in numbers.values.items() if name != "theta"}
    if plane is None:
        _check_counted(numbers)
        metres = {name: one * _metre(numbers, name, radius) for name, one in found.items()}
        _check_height(numbers, radius)
        if "y" in metres and not options.level:
            _check_floor(numbers, np.sort(_seen(metres["y"])) / radius)
        return metres
    for name in found:
        one = numbers.columns[name]
        if one.unit is not None and UNITS[one.unit].size is not None:
            raise numbers.table.refusal(
                "is not in pixels, which a plane is for",
                column=one.name,
                hint=f"leave out {options.say('plane')}",
            )
    for owner in ("", OF_MARKER):
        if ("x" + owner in found) != ("y" + owner in found):
            raise numbers.table.refusal("has one coordinate in pixels: a plane needs x and y")
        if "x" + owner in found:
            found["x" + owner], found["y" + owner] = plane.to_metres(
                found["x" + owner], found["y" + owner]
            )
    return found


def _seen(values: Reals) -> Reals:
    return values[np.isfinite(values)]


def _seconds(unit: str, options: TableOptions) -> float:
    """Return how many seconds a unit of time is."""
    if unit == FRAME:
        return 1.0 / options.fps if options.fps else np.nan
    size = UNITS[unit].size
    assert size is not None
    return size


def _step(times: Reals) -> float:
    """Return the time from a row to the next, without those where rows are missing."""
    steps = np.diff(times)
    if not steps.size:
        return np.nan
    return float(np.mean(steps[steps <= 1.5 * np.median(steps)]))


def _rates(numbers: Numbers) -> dict[str, float]:
    """Return how many rows a second there are if times are in a unit."""
    step, options = _step(numbers.times), numbers.options
    units = (unit for unit in TIME_UNITS if unit != FRAME)
    return {unit: 1.0 / (step * _seconds(unit, options)) for unit in units}


def _units_by_step(numbers: Numbers) -> list[str]:
    """Return the units in which times may be, if the rows are frames of a film."""
    return [unit for unit, rate in _rates(numbers).items() if _FEWEST <= rate <= _MOST]


def _unit_by_step(numbers: Numbers) -> str:
    """Return the unit of times whose name has none; refuse what may be several.

    Who says it says it, if a film may have such steps. A rate tells it. Without these times are in
    seconds, but not in Kinovea, which writes what its preferences say.
    """
    table, options = numbers.table, numbers.options
    step, fps = _step(numbers.times), options.fps
    rates = _rates(numbers)
    may_be = _units_by_step(numbers)
    is_frames = abs(step - 1.0) <= _STEP
    if options.time_unit == FRAME or options.time_unit in may_be:
        return options.time_unit
    if options.time_unit is None and fps is not None:
        agree = [unit for unit, rate in rates.items() if abs(rate / fps - 1.0) <= _STEP]
        agree += [FRAME] if is_frames else []
        if agree:
            return agree[0]
    elif options.time_unit is None and table.layout != KINOVEA and "s" in may_be:
        return "s"
    said = [f"{options.say('time_unit', one)} ({rates[one]:.4g} a second)" for one in may_be]
    if is_frames:
        said.append(f"{options.say('time_unit', FRAME)} with {options.say('fps', 240)}")
    raise table.refusal(
        f"has no unit; its rows are {step:.4g} apart"
        + ("" if fps is None else f", which are no frames at {fps:g} a second"),
        column=numbers.time.name,
        hint=f"say it: {', or '.join(said or [options.say('time_unit', 's')])}",
    )


def _size(numbers: Numbers) -> _Size | None:
    """Return the length of a track whose size is known best before any fit."""
    values = numbers.values
    if "y" in values and not numbers.options.level:
        low = float(np.quantile(_seen(values["y"]), _IN_CONTACT))
        return _Size("the lowest height of the centre", low, numbers.columns["y"], 0.5, 3.0)
    if {"x", "y", "x" + OF_MARKER, "y" + OF_MARKER} <= set(values):
        apart = np.hypot(*(values[name + OF_MARKER] - values[name] for name in ("x", "y")))
        far = float(np.median(_seen(apart))) if np.any(np.isfinite(apart)) else np.nan
        return _Size("the distance of the marker", far, numbers.columns["x"], 0.12, 1.15)
    return None


def _metre(numbers: Numbers, name: str, radius: float) -> float:
    """Return how many m the unit of a position is."""
    table, options, one = numbers.table, numbers.options, numbers.columns[name]
    unit = one.unit or options.length_unit
    if unit is None:
        if table.layout != TRACKER and table.layout != KINOVEA and numbers.time.unit is not None:
            raise table.refusal(
                f"has no dimension, {numbers.time.name} is in SI units",
                column=one.name,
                hint=f"name it {one.name}_m, or say {options.say('length_unit', 'm')}; or give "
                f"the plane of the motion if these are pixels: {options.say('plane')}",
            )
        _check_size(numbers, one, radius)
        return 1.0
    size = UNITS[unit].size
    if size is None:
        raise table.refusal(
            "is in pixels",
            column=one.name,
            hint=f"give the plane of the motion: {options.say('plane')}",
        )
    return size


def _check_size(numbers: Numbers, one: Column, radius: float) -> None:
    """Refuse positions without a unit that cannot be in m, or of which nothing tells it."""
    options, size = numbers.options, _size(numbers)
    if size is None or not np.isfinite(size.value):
        # Only the way is left. In cm it would be no motion, or as metres that of no film.
        way = float(np.ptp(_seen(numbers.values[one.channel])))
        size = _Size("the way of the centre", way, one, 0.3, 30.0)
    if size.fits(1.0, radius):
        return
    others = [unit for unit in LENGTH_UNITS[1:] if size.fits(UNITS[unit].size or 1.0, radius)]
    said = [options.say("length_unit", unit) for unit in others or LENGTH_UNITS]
    raise numbers.table.refusal(
        f"has no unit; {size.what} is {size.value:g}, the radius of the hoop {radius:g} m",
        column=size.column.name,
        hint=f"say it: {' or '.join(said)}; or give the plane of the motion if these are pixels: "
        f"{options.say('plane')}",
    )


def _check_counted(numbers: Numbers) -> None:
    """Refuse whole numbers without a unit: pixels are counted."""
    options = numbers.options
    for name, values in numbers.values.items():
        one, seen = numbers.columns[name], _seen(values)
        if name == "theta" or one.unit not in (None, "m") or options.length_unit not in (None, "m"):
            continue
        if np.ptp(seen) > _COUNTED and np.all(seen == np.round(seen)):
            raise numbers.table.refusal(
                "has whole numbers without a unit, as pixels are",
                column=one.name,
                hint=f"give {options.say('plane')} for pixels, or the unit: "
                f"{options.say('length_unit', 'mm')}",
            )


def _check_height(numbers: Numbers, radius: float) -> None:
    """Refuse a hoop that is below or high above the floor, or with a marker that is outside of it.

    The radius is 1 in a dimensionless table.
    """
    options, size = numbers.options, _size(numbers)
    unit = None if size is None else UNITS[size.column.unit or options.length_unit or "m"].size
    if size is None or unit is None:
        return
    radii = size.value * unit / radius
    reason = f"is no such length: {size.what} is {size.value:g}, {radii:.3g} radii of the hoop"
    if size.column.channel == "y" and radii < _LOWEST:
        raise numbers.table.refusal(
            reason,
            column=size.column.name,
            hint="y grows upwards from the floor, on which the centre is a radius high; "
            f"{options.say('ignore', size.column.name)} leaves it out",
        )
    if radii > (_HIGHEST if size.column.channel == "y" else _FARTHEST):
        said = [options.say("length_unit", one) for one in LENGTH_UNITS]
        raise numbers.table.refusal(
            reason,
            column=size.column.name,
            hint=f"name its unit, or say {' or '.join(said)}; or give the plane of the motion if "
            f"these are pixels: {options.say('plane')}",
        )


def _check_floor(numbers: Numbers, heights: Reals) -> None:
    """Refuse heights, in radii and sorted, of which none is that in contact.

    They grow downwards, or count from elsewhere.
    """
    lowest = float(heights[min(_FEW, heights.size) - 1])
    if lowest > _NEAR_FLOOR:
        one = numbers.columns["y"]
        raise numbers.table.refusal(
            f"has no height in contact, a radius: the lowest is {lowest:.3g} radii of the hoop",
            column=one.name,
            hint="y grows upwards from the floor; move the origin of the axes there; "
            f"{numbers.options.say('ignore', one.name)} leaves it out",
        )
