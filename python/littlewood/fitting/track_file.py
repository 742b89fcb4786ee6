"""Columns of a tracked motion: which channel each is, in which unit, of which point."""

from __future__ import annotations

import difflib
import math
import re
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Protocol

import numpy as np
import numpy.typing as npt

from .._internal.elementwise import Reals
from .._internal.text_table import TableFileError, TextTable, read_text_table
from ..tables import SAMPLE_COLUMNS

if TYPE_CHECKING:
    from ..units import Units

__all__ = ["COLUMN_OF", "PlaneLike", "TrackFile", "read_track"]


class PlaneLike(Protocol):
    """What positions in pixels need: :class:`littlewood.video.Plane`."""

    def to_metres(self, u: npt.ArrayLike, v: npt.ArrayLike) -> tuple[Reals, Reals]:
        """Return the points of the plane that pixels show, x and y in m."""


COLUMN_OF = {"time": "time", "theta": "theta", "x": "x", "y": "centre_y"}
"""Columns of samples by the channels of a track."""

_FRAME = "frame"
_OF_MARKER = " of the marker"
_PIXELS = "px"
# Names in exports besides those of the columns of samples.
_ALSO = {
    "time": ("t",),
    "theta": ("θ", "angle"),
    "x": ("position", "x position", "position x"),
    "y": ("y", "height", "y position", "position y"),
    _FRAME: ("frame", "frames", "frame number", "frame_number"),
}
_CHANNELS = {
    **{name: channel for channel, names in _ALSO.items() for name in names},
    **{SAMPLE_COLUMNS[name].name: channel for channel, name in COLUMN_OF.items()},
}
# What a number of a unit is in s, rad or m. Pixels need a plane.
_UNITS: dict[str, tuple[str, float]] = {
    "s": ("time", 1.0),
    "ms": ("time", 1e-3),
    "rad": ("theta", 1.0),
    "deg": ("theta", math.radians(1.0)),
    "°": ("theta", math.radians(1.0)),
    "m": ("length", 1.0),
    "cm": ("length", 1e-2),
    "mm": ("length", 1e-3),
    _PIXELS: ("length", math.nan),
    "pixel": ("length", math.nan),
    "pixels": ("length", math.nan),
}
_LENGTHS = tuple(name for name, (kind, size) in _UNITS.items() if kind == "length" and size > 0.0)
# What our own tables, Tracker and Capstone write beside the channels, or compute from them.
_DERIVED = frozenset(
    [
        *(one.name for one in SAMPLE_COLUMNS.values() if one.name not in _CHANNELS),
        *"n step v vx vy |v| a ax ay |a| θv θa θr r ω α px py pθ p k l pathlength pixelx pixely "
        "index".split(),
        *(
            "velocity",
            "acceleration",
            "x velocity",
            "y velocity",
            "x acceleration",
            "y acceleration",
        ),
        *(
            "angular velocity",
            "angular acceleration",
            "velocity x",
            "velocity y",
            "acceleration x",
            "acceleration y",
        ),
    ]
)
_RUN = re.compile(r"\s*run\s*#\s*(\d+)$", re.IGNORECASE)
_IN_BRACKETS = re.compile(r"^(.*?)\s*[(\[]([^)\]]*)[)\]]$")
# Words in the names of points, in the languages in which schools use such programs most.
_CENTRE = ("centre", "center", "hub", "mitte", "centro")
_MARKER = ("marker", "particle", "weight", "spot", "marke", "marque", "marca")


@dataclass(frozen=True)
class _Column:
    """A column of a table: `channel` is time, theta, x, y or frame.

    `point` is tracked, in exports that name them.
    """

    place: int
    name: str
    channel: str
    unit: str | None
    point: str
    run: int | None


@dataclass(frozen=True)
class TrackFile:
    """The channels of a file; in s, rad and m, or dimensionless."""

    is_si: bool
    time: Reals
    theta: Reals | None
    x: Reals | None
    y: Reals | None


def read_track(
    path: str | Path,
    units: Units | None,
    *,
    centre: str | None,
    marker: str | None,
    run: int | None,
    fps: float | None,
    plane: PlaneLike | None,
    length_unit: str,
    ignore: Iterable[str],
) -> TrackFile:
    """Read the channels of a file, as :meth:`littlewood.Track.from_csv` describes it."""
    if length_unit not in _LENGTHS:
        raise ValueError(f"length_unit = {length_unit!r} must be one of {', '.join(_LENGTHS)}")
    if fps is not None and not (fps > 0.0 and math.isfinite(fps)):
        raise ValueError(f"fps = {fps} must be positive")
    table = read_text_table(path)
    columns = _of_run(table, _recognised(table, set(ignore)), run)
    time = _time_column(table, columns, fps)
    marker = _marker_of(table, columns, centre, marker)
    by_channel = {
        (one.channel, _OF_MARKER if one.point and one.point == marker else ""): one
        for one in columns
    }
    used = [one for one in columns if one.channel in ("theta", "x", "y")]
    if not used:
        raise table.refusal(
            "has neither an angle nor a position", hint="columns are theta_deg, x_m, y_m"
        )
    # Exports that name points, or call the time t, have units that do not stand in the file.
    is_foreign = (
        any(one.point for one in used) or time.name.lower() == "t" or time.channel == _FRAME
    )
    is_si = is_foreign or time.unit is not None or plane is not None
    if not is_si:
        odd = next((one for one in used if one.unit is not None), None)
        if odd is not None:
            raise table.refusal(
                f"is in SI units, {time.name} has no dimension",
                column=odd.name,
                hint="name the time time_s",
            )
    # Runs and trajectories differ in length.
    table = table.with_some_of([time.place, *(one.place for one in used)])
    found: dict[str, Reals] = {}
    for (channel, owner), one in by_channel.items():
        if channel in ("theta", "x", "y"):
            values = _values(table, one, is_si, is_foreign, plane, length_unit)
            if not np.any(np.isfinite(values)):
                raise TableFileError(
                    table.path,
                    "has no number",
                    column=one.name,
                    hint="remove the column if it was not tracked",
                )
            found[channel + owner] = values
    numbers = np.array(table.numbers(time.place, True))
    if time.channel == _FRAME:
        assert fps is not None
        numbers = numbers / fps
    elif is_si:
        numbers = numbers * (_UNITS[time.unit][1] if time.unit else 1.0)
    table.check_growing(time.place, numbers.tolist())
    if plane is not None:
        _to_metres(table, found, plane)
    elif not is_si:
        _not_pixels(table, by_channel, found)
    if "x" + _OF_MARKER in found or "y" + _OF_MARKER in found:
        if "theta" in found or not {"x", "y", "x" + _OF_MARKER, "y" + _OF_MARKER} <= set(found):
            raise table.refusal("needs x and y of both points, and no angle beside them")
        across, up = (found[name + _OF_MARKER] - found[name] for name in ("x", "y"))
        found["theta"] = np.arctan2(-across, up)
    if is_si and units is None:
        raise TableFileError(
            table.path, "is in SI units", hint="make the hoop by Hoop.from_si, and give its units"
        )
    return TrackFile(is_si, numbers, found.get("theta"), found.get("x"), found.get("y"))


def _recognised(table: TextTable, ignored: set[str]) -> list[_Column]:
    """Return the columns that are channels; refuse those that nobody knows."""
    found: list[_Column] = []
    unused = set(ignored)
    for place, (name, point) in enumerate(zip(table.names, table.points, strict=True)):
        if name in ignored:
            unused.discard(name)
            continue
        one = _recognise(place, name, point)
        if one is not None:
            found.append(one)
        elif not _is_derived(name):
            known = [
                *_CHANNELS,
                *(spelling for key in COLUMN_OF.values() for spelling in _spellings(key)),
            ]
            close = difflib.get_close_matches(name.lower(), known, 1)
            meant = f"is it {close[0]}? " if close else ""
            raise table.refusal(
                "is not a column of a track",
                column=repr(name),
                hint=f"{meant}Columns are {', '.join(_spellings('theta', 'time', 'x', 'y'))}; "
                f'ignore=("{name}",) passes over it',
            )
    if unused:
        missing = ", ".join(sorted(unused))
        raise table.refusal(f"has no column {missing}, which ignore names")
    return found


def _spellings(*names: str) -> list[str]:
    """Return how columns are written in SI units."""
    units = {"time": ["s"], "theta": ["rad", "deg"], "x": ["m"], "y": ["m"]}
    return [f"{name}_{unit}" for name in names for unit in units.get(name, [])]


def _bare(name: str) -> tuple[str, str | None, int | None]:
    """Return name, unit and run of a column."""
    run = _RUN.search(name)
    text = name[: run.start()] if run else name
    number = int(run.group(1)) if run else None
    bracketed = _IN_BRACKETS.match(text)
    if bracketed:
        return bracketed.group(1).strip().lower(), bracketed.group(2).strip(), number
    stem, _, last = text.rpartition("_")
    if stem and last.lower() in _UNITS:
        return stem.strip().lower(), last.lower(), number
    return text.strip().lower(), None, number


def _recognise(place: int, name: str, point: str) -> _Column | None:
    text, unit, run = _bare(name)
    if not point and "/" in text:
        # Kinovea: name of the object, of its point, and the axis.
        owner, _, text = text.rpartition("/")
        point = name[: len(owner)].removesuffix("/0")
    channel = _CHANNELS.get(text)
    if channel is None:
        return None
    if unit is not None and (
        unit not in _UNITS
        or _UNITS[unit][0] != {"x": "length", "y": "length"}.get(channel, channel)
    ):
        return None
    return _Column(place, name, channel, unit, point, run)


def _is_derived(name: str) -> bool:
    text = _bare(name)[0]
    return text in _DERIVED or any(name == one.si_name for one in SAMPLE_COLUMNS.values())


def _of_run(table: TextTable, columns: list[_Column], run: int | None) -> list[_Column]:
    """Return the columns of one run; refuse two columns of one channel."""
    runs = sorted({one.run for one in columns if one.run is not None})
    if run is not None and run not in runs:
        there = f"has runs {', '.join(map(str, runs))}" if runs else "has no runs"
        raise table.refusal(f"{there}, run = {run} is none of them")
    if run is None and len(runs) > 1:
        raise table.refusal(
            f"has runs {', '.join(map(str, runs))}", hint=f"choose one: run={runs[0]}"
        )
    chosen = [one for one in columns if one.run is None or run is None or one.run == run]
    seen: dict[tuple[str, str], _Column] = {}
    for one in chosen:
        before = seen.setdefault((one.channel, one.point), one)
        if before is not one:
            names = before.name if before.name == one.name else f"{before.name} and {one.name}"
            raise table.refusal(
                f"{names}: two columns of one quantity",
                hint=f'remove one, or name it in ignore=("{one.name}",)',
            )
    return chosen


def _time_column(table: TextTable, columns: list[_Column], fps: float | None) -> _Column:
    """Return the column of times, or that of frames if there are only those."""
    for channel in ("time", _FRAME):
        found = next((one for one in columns if one.channel == channel), None)
        if found is not None:
            if channel == _FRAME and fps is None:
                raise table.refusal(
                    "has numbers of frames and no time",
                    column=found.name,
                    hint="give the rate at which they were taken: fps=240",
                )
            return found
    raise table.refusal(
        f"no column time or time_s among {', '.join(table.names)}", hint="name the time time_s"
    )


def _marker_of(
    table: TextTable, columns: list[_Column], centre: str | None, marker: str | None
) -> str | None:
    """Return the name of the point that is the marker, if any.

    The other is the centre, and no point is left out.
    """
    names = list(dict.fromkeys(one.point for one in columns if one.point))
    for given in (centre, marker):
        if given is not None and given not in names:
            there = ", ".join(names) or "none with a name"
            raise table.refusal(f"has no point {given!r}", hint=f"its points are {there}")
    if len(names) == 2 and marker is None:
        if centre is None:
            tells = [name for name in names if any(word in name.lower() for word in _CENTRE)]
            markers = [name for name in names if any(word in name.lower() for word in _MARKER)]
            rest = [name for name in names if name not in markers]
            centre = tells[0] if len(tells) == 1 else rest[0] if len(rest) == 1 else None
        marker = next((name for name in names if centre is not None and name != centre), None)
    if {centre, marker} - {None} != set(names) and not (len(names) == 1 and marker is None):
        raise table.refusal(
            f"has the points {', '.join(names)}",
            hint='say which are the centre of the hoop and its marker: centre="…", marker="…"; '
            "export only these",
        )
    if marker is not None and len(names) == 1:
        raise table.refusal("has the marker alone", hint="track the centre, too")
    return marker


def _values(
    table: TextTable,
    one: _Column,
    is_si: bool,
    is_foreign: bool,
    plane: PlaneLike | None,
    length_unit: str,
) -> Reals:
    """Return a channel in rad, m or pixels; dimensionless as it stands."""
    values = np.array(table.numbers(one.place, False))
    if not is_si:
        return values
    if one.channel == "theta":
        if one.unit is None:
            raise table.refusal(
                "has no unit", column=one.name, hint="name it theta_deg or theta_rad"
            )
        return np.asarray(values * _UNITS[one.unit][1])
    unit = one.unit
    if unit is None and plane is None:
        if not is_foreign:
            raise table.refusal(
                "has no dimension, the time is in SI units",
                column=one.name,
                hint=f"name it {one.name}_m",
            )
        unit = length_unit
    in_pixels = unit is None or math.isnan(_UNITS[unit][1])
    if in_pixels != (plane is not None):
        reason = "is in pixels" if in_pixels else "is not in pixels, which a plane is for"
        hint = (
            "give the plane of the motion: plane=video.Plane.from_points(…)"
            if in_pixels
            else "leave plane out"
        )
        raise table.refusal(reason, column=one.name, hint=hint)
    return values if in_pixels else np.asarray(values * _UNITS[unit or length_unit][1])


def _to_metres(table: TextTable, found: dict[str, Reals], plane: PlaneLike) -> None:
    for owner in ("", _OF_MARKER):
        if ("x" + owner in found) != ("y" + owner in found):
            raise table.refusal("has one coordinate in pixels: a plane needs x and y")
        if "x" + owner in found:
            found["x" + owner], found["y" + owner] = plane.to_metres(
                found["x" + owner], found["y" + owner]
            )


def _not_pixels(
    table: TextTable, columns: dict[tuple[str, str], _Column], found: dict[str, Reals]
) -> None:
    """Refuse whole numbers without a unit: radii are not counted, pixels are."""
    for channel in ("x", "y"):
        if channel in found:
            seen = found[channel][np.isfinite(found[channel])]
            if np.ptp(seen) > 10.0 and np.all(seen == np.round(seen)):
                raise table.refusal(
                    "has whole numbers without a unit, as pixels are",
                    column=columns[channel, ""].name,
                    hint="give plane=video.Plane.from_points(…) for pixels, or name the unit: x_m",
                )
