"""Columns of a tracked motion: which channel each is, in which unit, of which point."""

from __future__ import annotations

import difflib
import re
from dataclasses import dataclass

from .._internal.table_layouts import VERNIER
from .._internal.text_table import TextTable
from ..tables import SAMPLE_COLUMNS
from .table_options import FRAME, UNITS, TableOptions

__all__ = ["COLUMN_OF", "Column", "columns_of", "marker_of", "time_column"]

COLUMN_OF = {"time": "time", "theta": "theta", "x": "x", "y": "centre_y"}
"""Columns of samples by the channels of a track."""

# Names in exports besides those of the columns of samples.
_ALSO = {
    "time": ("t", "timestamp", "zeit", "temps", "tiempo", "tempo"),
    "theta": ("θ", "φ", "phi", "angle", "winkel", "angolo", "ángulo"),
    "x": ("position", "x position", "position x", "x-position"),
    "y": ("y", "height", "y position", "position y", "y-position", "höhe", "hauteur", "altura"),
    FRAME: ("frame", "frames", "frame number", "frame_number"),
}
_CHANNELS = {
    **{name: channel for channel, names in _ALSO.items() for name in names},
    **{SAMPLE_COLUMNS[name].name: channel for channel, name in COLUMN_OF.items()},
}
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
# Capstone writes the run behind a name; Vernier's programs write the data set before it.
_RUN = re.compile(r"\s*run\s*#\s*(\d+)$", re.IGNORECASE)
_DATA_SET = re.compile(r"(?:(?:run|data set) )?([^:]+):\s*", re.IGNORECASE)
_IN_BRACKETS = re.compile(r"^(.*?)\s*[(\[]([^)\]]*)[)\]]$")
# A quantity over its unit, as ISO 80000 writes columns: t/s, x / m.
_OVER_UNIT = re.compile(r"^(.+?)\s*/\s*([^/]+)$")
# How units are written besides.
_UNIT_WORDS = {
    "sec": "s",
    "second": "s",
    "seconds": "s",
    "msec": "ms",
    "millisecond": "ms",
    "milliseconds": "ms",
    "radian": "rad",
    "radians": "rad",
    "degree": "deg",
    "degrees": "deg",
    "metre": "m",
    "metres": "m",
    "meter": "m",
    "meters": "m",
}
# Words in the names of points, in the languages in which schools use such programs most.
_CENTRE = ("centre", "center", "hub", "mitte", "centro")
_MARKER = ("marker", "particle", "weight", "spot", "marke", "marque", "marca")


@dataclass(frozen=True)
class Column:
    """A column of a table: `channel` is time, theta, x, y or frame.

    `point` is tracked, in exports that name them; `run` is that of an experiment with several.
    """

    place: int
    name: str
    channel: str
    unit: str | None
    point: str
    run: str | None


def columns_of(table: TextTable, options: TableOptions) -> list[Column]:
    """Return the columns that are channels; refuse those that nobody knows."""
    found: list[Column] = []
    unused = set(options.ignore)
    for place, (name, point) in enumerate(zip(table.names, table.points, strict=True)):
        if name in options.ignore:
            unused.discard(name)
            continue
        one = _recognise(table, place, name, point)
        if one is not None:
            found.append(one)
        elif not _is_derived(table, name):
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
                f"{options.say('ignore', name)} passes over it",
            )
    if unused:
        raise table.refusal(
            f"has no column {', '.join(sorted(unused))}, which is to be passed over",
            hint=f"its columns are {', '.join(table.names)}",
        )
    return _of_run(table, found, options)


def _spellings(*names: str) -> list[str]:
    """Return how columns are written in SI units."""
    units = {"time": ["s"], "theta": ["rad", "deg"], "x": ["m"], "y": ["m"]}
    return [f"{name}_{unit}" for name in names for unit in units.get(name, [])]


@dataclass(frozen=True)
class _Name:
    """What the name of a column says."""

    text: str
    unit: str | None
    run: str | None


def _parts(table: TextTable, name: str) -> _Name:
    """Take a name apart."""
    text, run = name, None
    behind = _RUN.search(name)
    before = _DATA_SET.match(name) if table.layout == VERNIER else None
    if behind:
        text, run = name[: behind.start()], behind.group(1)
    elif before:
        text, run = name[before.end() :], before.group(1)
    bracketed, over = _IN_BRACKETS.match(text), _OVER_UNIT.match(text)
    if bracketed:
        return _Name(bracketed.group(1).strip().lower(), _unit(bracketed.group(2).strip()), run)
    if over and _unit(over.group(2).strip()) in UNITS:
        return _Name(over.group(1).strip().lower(), _unit(over.group(2).strip()), run)
    stem, _, last = text.rpartition("_")
    if stem and last.lower() in UNITS:
        return _Name(stem.strip().lower(), last.lower(), run)
    return _Name(text.strip().lower(), None, run)


def _unit(text: str) -> str:
    """Return a unit as it is called here."""
    return _UNIT_WORDS.get(text.lower(), text)


def _recognise(table: TextTable, place: int, name: str, point: str) -> Column | None:
    parts = _parts(table, name)
    text = parts.text
    if not point and "/" in text:
        # Kinovea: name of the object, of its point, and the axis.
        owner, _, text = text.rpartition("/")
        point = name[: len(owner)].removesuffix("/0")
    channel = _CHANNELS.get(text)
    if channel is None:
        return None
    kind = {"x": "length", "y": "length"}.get(channel, channel)
    if parts.unit is not None and (parts.unit not in UNITS or UNITS[parts.unit].kind != kind):
        return None
    return Column(place, name, channel, parts.unit, point, parts.run)


def _is_derived(table: TextTable, name: str) -> bool:
    text = _parts(table, name).text
    return text in _DERIVED or any(name == one.si_name for one in SAMPLE_COLUMNS.values())


def _of_run(table: TextTable, columns: list[Column], options: TableOptions) -> list[Column]:
    """Return the columns of one run; refuse two columns of one channel."""
    runs = list(dict.fromkeys(one.run for one in columns if one.run is not None))
    run = None if options.run is None else str(options.run)
    if run is not None and run not in runs:
        there = f"has runs {', '.join(runs)}" if runs else "has no runs"
        raise table.refusal(f"{there}, {options.say('run', options.run or 0)} is none of them")
    if run is None and len(runs) > 1:
        first = int(runs[0]) if runs[0].isdecimal() else runs[0]
        raise table.refusal(
            f"has runs {', '.join(runs)}", hint=f"choose one: {options.say('run', first)}"
        )
    chosen = [one for one in columns if one.run is None or run is None or one.run == run]
    seen: dict[tuple[str, str], Column] = {}
    for one in chosen:
        before = seen.setdefault((one.channel, one.point), one)
        if before is not one:
            names = before.name if before.name == one.name else f"{before.name} and {one.name}"
            raise table.refusal(
                f"{names}: two columns of one quantity",
                # Who has one name cannot name one of them.
                hint="remove one"
                + ("" if before.name == one.name else f", or {options.say('ignore', one.name)}"),
            )
    return chosen


def time_column(table: TextTable, columns: list[Column], options: TableOptions) -> Column:
    """Return the column of times, or that of frames if there are only those."""
    for channel in ("time", FRAME):
        found = next((one for one in columns if one.channel == channel), None)
        if found is not None:
            if channel == FRAME and options.fps is None:
                raise table.refusal(
                    "has numbers of frames and no time",
                    column=found.name,
                    hint=f"give the rate at which they were taken: {options.say('fps', 240)}",
                )
            return found
    raise table.refusal(
        f"no column time or time_s among {', '.join(table.names)}", hint="name the time time_s"
    )


def marker_of(table: TextTable, columns: list[Column], options: TableOptions) -> str | None:
    """Return the name of the point that is the marker, if any.

    The other is the centre, and no point is left out.
    """
    names = list(dict.fromkeys(one.point for one in columns if one.point))
    centre, marker = options.centre, options.marker
    for given in (centre, marker):
        if given is not None and given not in names:
            there = ", ".join(names) or "none with a name"
            raise table.refusal(f"has no point {given!r}", hint=f"its points are {there}")
    markers = [name for name in names if any(word in name.lower() for word in _MARKER)]
    if len(names) == 2 and marker is None:
        if centre is None:
            tells = [name for name in names if any(word in name.lower() for word in _CENTRE)]
            rest = [name for name in names if name not in markers]
            centre = tells[0] if len(tells) == 1 else rest[0] if len(rest) == 1 else None
        marker = next((name for name in names if centre is not None and name != centre), None)
    if len(names) == 1 and (marker is not None or (markers and centre is None)):
        raise table.refusal(
            f"has the point {names[0]!r} alone, which by its name is the marker",
            hint="track the centre, too; or if it is the centre: "
            f"{options.say('centre', names[0])}",
        )
    if {centre, marker} - {None} != set(names) and len(names) != 1:
        raise table.refusal(
            f"has the points {', '.join(names)}",
            hint="say which are the centre of the hoop and its marker: "
            f"{options.say('centre', '…')}, {options.say('marker', '…')}; export only these",
        )
    return marker
