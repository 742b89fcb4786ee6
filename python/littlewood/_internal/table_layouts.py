"""The layouts of tables that programs write: how a file begins, and how it is read."""

from __future__ import annotations

import csv
import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from .text_table import MISSING, NUMBER, TableFileError, TextTable, lines_of

__all__ = ["KINOVEA", "PLAIN", "TRACKER", "VERNIER", "read_text_table"]

KINOVEA, TRACKER, VERNIER, PLAIN = "Kinovea", "Tracker", "Vernier", ""
"""Layouts whose names leave something open: of units, or of the runs of an experiment."""

_SEPARATORS = {"\t": "tabs", ";": "semicolons", ",": "commas"}
# So many lines tell the layout.
_FIRST_LINES = 4
# What becomes of pixels that other programs write.
_OWN_TABLE = (
    "write a table with the columns frame, centre/x_px, centre/y_px, marker/x_px, marker/y_px, and "
    "leave cells empty where a point was not seen"
)


@dataclass(frozen=True)
class _Layout:
    """A layout: the name of its program, how a file begins, and how it is read.

    A layout that is not read has a reason instead, and what to do.
    """

    name: str
    begins: re.Pattern[str]
    read: Callable[[_Layout, str, list[str]], TextTable] | None = None
    reason: str = ""
    hint: str = ""


def read_text_table(path: str | Path) -> TextTable:
    """Read a table: names in its first line, one row a line; refuse a file that is none.

    Tabs, semicolons, commas or spaces separate the cells, a point or a comma marks decimals; a
    byte-order mark, quotes, comments, a line of units, and the lines that trackers and spreadsheets
    put before the names are understood.
    """
    file, lines = str(path), lines_of(path)
    first = "".join(f"{line}\n" for line in [one for one in lines if one.strip()][:_FIRST_LINES])
    layout = next(one for one in _LAYOUTS if one.begins.match(first))
    if layout.read is None:
        raise TableFileError(file, layout.reason, line=1, hint=layout.hint)
    return layout.read(layout, file, lines)


def _names_then_rows(layout: _Layout, file: str, lines: list[str]) -> TextTable:
    """Read a line of names, and rows."""
    head = _head(lines)
    if head is None:
        raise TableFileError(
            file, "is empty", hint="a table has a line of names, such as time_s,theta_deg,x_m"
        )
    if head > 0 and lines[head - 1].startswith("#") and _has_numbers(lines[head]):
        # As NumPy writes names.
        head -= 1
        lines = [*lines[:head], lines[head].lstrip("# "), *lines[head + 1 :]]
    # The line of names decides: numbers may have decimal commas.
    separator = _separator(lines[head])
    names = _without_empty_end(_cells(lines[head], separator))
    if _has_numbers(lines[head]):
        raise TableFileError(
            file,
            "has no line of names",
            line=head + 1,
            hint="write one above the numbers, such as time_s,theta_rad,x_m,y_m",
        )
    return _with_rows(layout, file, lines, head, names, [""] * len(names), separator)


def _has_numbers(line: str) -> bool:
    """Whether all cells of a line are numbers."""
    return all(NUMBER.fullmatch(cell) for cell in _cells(line, _separator(line)))


def _points_then_names(layout: _Layout, file: str, lines: list[str]) -> TextTable:
    """Read Tracker's export: a line of the points, each over its columns, the names, and rows."""
    head = _head(lines)
    assert head is not None
    separator = lines[head][0]
    split = _exact_cells if separator == " " else _cells
    names = _without_empty_end(split(lines[head + 1], separator))
    if separator == " ":
        owners = _owners_by_spaces(file, head, lines[head], len(names) - 1)
    else:
        owners = split(lines[head], separator)[1:]
    points, owner = [""], ""
    for k in range(len(names) - 1):
        owner = owners[k] if k < len(owners) and owners[k] else owner
        points.append(owner)
    return _with_rows(layout, file, lines, head + 1, names, points, separator)


def _owners_by_spaces(file: str, head: int, line: str, count: int) -> list[str]:
    """Return the points over `count` columns.

    As many spaces follow the name of each as it has columns; a name may have spaces in it.
    """
    text = line[1:].rstrip(" ")
    each = len(line) - len(line.rstrip(" ")) or max(count, 1)
    points = text.split(" " * each)
    if len(points) * each != count:
        raise TableFileError(
            file,
            f"has {len(points)} names of points over {count} columns",
            line=head + 1,
            hint="export the data with tabs between the cells",
        )
    return [cell for point in points for cell in (point, *[""] * (each - 1))]


def _with_rows(
    layout: _Layout,
    file: str,
    lines: list[str],
    names_at: int,
    names: list[str],
    points: list[str],
    separator: str,
) -> TextTable:
    """Read the rows below a line of names."""
    split = _exact_cells if layout.name == TRACKER and separator == " " else _cells
    numbers: list[int] = []
    rows: list[list[str]] = []
    for k in range(names_at + 1, len(lines)):
        row = split(lines[k], separator)
        if not any(row) or lines[k].startswith("#"):
            continue
        if len(row) < len(names) or any(row[len(names) :]):
            reason = f"has {len(row)} cells, the line of names has {len(names)}"
            hint = f"cells are separated by {_SEPARATORS.get(separator, 'spaces')} here"
            if len(names) == 1:
                hint = "the line of names comes first: remove what is above it"
            raise TableFileError(file, reason, line=k + 1, hint=hint)
        if not rows and _is_of_units(row):
            both = zip(names, row, strict=False)
            names = [_with_unit(name, unit.strip("()[] ")) for name, unit in both]
            continue
        numbers.append(k + 1)
        rows.append(row[: len(names)])
    if not rows:
        raise TableFileError(file, "has no rows after its line of names", line=names_at + 1)
    return TextTable(layout.name, file, names_at + 1, names, points, numbers, rows)


def _is_of_units(row: list[str]) -> bool:
    """Whether the first line below the names has their units: words, and no number."""
    words = [cell for cell in row if cell.lower() not in MISSING]
    return bool(words) and not any(NUMBER.match(cell) for cell in row)


def _with_unit(name: str, unit: str) -> str:
    """Return a name with the unit below it, unless it has that itself."""
    return name if not unit or name.lower().endswith(f"_{unit.lower()}") else f"{name} ({unit})"


def _head(lines: list[str]) -> int | None:
    """Return the first line that is no comment."""
    return next(
        (k for k, line in enumerate(lines) if line.strip() and not line.startswith(("#", "sep="))),
        None,
    )


def _separator(line: str) -> str:
    """Return what separates the names; a space where nothing else does."""
    bare = re.sub(r'"[^"]*"', "", line)
    counts = {one: bare.count(one) for one in _SEPARATORS}
    best = max(counts, key=lambda one: counts[one])
    return best if counts[best] else " "


def _cells(line: str, separator: str) -> list[str]:
    if separator == " ":
        return line.split()
    return [
        cell.strip()
        for cell in next(csv.reader([line], delimiter=separator, skipinitialspace=True), [])
    ]


def _exact_cells(line: str, separator: str) -> list[str]:
    """Return cells of which those between two separators are empty, spaces too."""
    return line.split(separator)


def _without_empty_end(names: list[str]) -> list[str]:
    while names and not names[-1]:
        names = names[:-1]
    return names


def _trajectories(layout: _Layout, file: str, lines: list[str]) -> TextTable:
    """Read Kinovea's text for Gnuplot: T X Y of one trajectory after the other."""
    cells: dict[str, dict[str, list[str]]] = {}
    numbers: dict[str, int] = {}
    point, fresh = "", True
    for k, line in enumerate(lines[2:], start=3):
        if line.startswith("#"):
            point, fresh = line[1:].strip(), False
            if point in cells:
                raise TableFileError(
                    file,
                    f"has a second trajectory with the name {point!r}",
                    line=k,
                    hint="give each its own name in Kinovea, and export again",
                )
            cells[point] = {}
        elif not line.strip():
            fresh = True
        else:
            if fresh and (not point or cells.get(point)):
                # Older versions have no names.
                point = f"Track {len(cells) + 1}"
                cells[point] = {}
            fresh = False
            row = line.split()
            if len(row) != 3:
                raise TableFileError(file, f"has {len(row)} cells, not the three T X Y", line=k)
            if row[0] in cells[point]:
                hint = "choose milliseconds as the time code of Kinovea, and say so here"
                raise TableFileError(
                    file, "occurs twice", line=k, column="T", value=row[0], hint=hint
                )
            cells[point][row[0]] = row[1:]
            numbers.setdefault(row[0], k)
    if not numbers:
        raise TableFileError(file, "has no trajectory")
    # A time code says its unit itself.
    names, points = ["T (s)" if any(":" in at for at in numbers) else "T"], [""]
    for point in cells:
        names += ["X", "Y"]
        points += [point, point]
    rows = [
        [at, *(cell for rows in cells.values() for cell in rows.get(at, ["", ""]))]
        for at in numbers
    ]
    order = sorted(range(len(rows)), key=lambda k: _seconds(rows[k][0]))
    places = list(numbers.values())
    rows = [[repr(_seconds(rows[k][0])), *rows[k][1:]] for k in order]
    return TextTable(layout.name, file, 2, names, points, [places[k] for k in order], rows)


def _seconds(text: str) -> float:
    """Return a time of Kinovea: a number, or hours, minutes, seconds and a part of one, in seconds.

    The part is in hundredths, or in thousandths of films with more than 100 frames a second.
    """
    parts = text.split(":")
    try:
        if len(parts) == 1:
            return float(text.replace(",", "."))
        numbers = [float(part) for part in parts]
    except ValueError:
        return float("nan")
    rest = numbers.pop() / 10.0 ** len(parts[3]) if len(parts) == 4 else 0.0
    return sum(60.0**k * value for k, value in enumerate(reversed(numbers))) + rest


# The first that a file begins like is its layout.
_LAYOUTS = (
    _Layout(KINOVEA, re.compile(r"#Kinovea Trajectory data export"), _trajectories),
    _Layout(KINOVEA, re.compile(r'"?Time"?[,;\t][^\n]*/[XY]"?\s*\n'), _names_then_rows),
    _Layout(
        "DeepLabCut",
        re.compile(r"scorer[,;\t]"),
        reason="is an export of DeepLabCut: pixels, whether a point was seen or guessed",
        hint=f"{_OWN_TABLE}: where the likelihood is low",
    ),
    _Layout(
        "SLEAP",
        re.compile(r"(track,)?frame_idx,"),
        reason="is an export of SLEAP: pixels, a row for each track of a frame",
        hint=f"{_OWN_TABLE}: where the score is low",
    ),
    _Layout(
        "phyphox",
        re.compile(
            r'"?Time \(s\)"?[,;\t]"?((Linear )?Acceleration x|Absolute acceleration|Gyroscope|'
            r"Magnetic field)",
            re.I,
        ),
        reason="is an export of phyphox: what a telephone felt, without a position",
        hint="film the hoop, and track it",
    ),
    _Layout(
        "Logger Pro",
        re.compile(r"Vernier Format"),
        reason="is the text format of Logger Pro",
        hint="choose File > Export As > CSV in Logger Pro",
    ),
    # Logger Pro and Graphical Analysis: DATA SET: NAME (UNIT), with or without the spaces.
    _Layout(VERNIER, re.compile(r'"?[^,;\t"\n]+: ?Time ?\(\w+\)', re.I), _names_then_rows),
    # The names of the points begin with a separator, and the next line has names, not numbers.
    _Layout(
        TRACKER,
        re.compile(r"(#[^\n]*\n)*([,;\t]|[ ](?=\S))[^\n]*\n[^\W\d]"),
        _points_then_names,
    ),
    _Layout(PLAIN, re.compile(""), _names_then_rows),
)
