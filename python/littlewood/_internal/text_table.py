"""Tables of numbers in text files, as spreadsheets and trackers write them."""

from __future__ import annotations

import csv
import itertools
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

__all__ = ["NUMBER", "TableFileError", "TextTable", "read_text_table"]

_SEPARATORS = {"\t": "tabs", ";": "semicolons", ",": "commas"}
NUMBER = re.compile(r"[+-]?(\d+([.,]\d*)?|[.,]\d+)([eE][+-]?\d+)?")
# A million rows of a dozen cells.
_MOST_BYTES = 1 << 28
_MISSING = ("", "nan", "na")
_KINOVEA = "#Kinovea Trajectory data export"
# What the first bytes say of files that look like tables to their owners.
_OTHER_FILES = {
    b"PK": "a spreadsheet or an archive: save the sheet as CSV",
    b"\xd0\xcf\x11\xe0": "a spreadsheet: save the sheet as CSV",
    b"<?xml": "a project or a web page: export the data of its track as text",
}


class TableFileError(ValueError):
    """A table that cannot be read.

    Attributes
    ----------
    path : str
        The file.
    line : int or None
        Line of the file, from 1; None where the whole file is meant.
    column : str or None
        Name of the column; None where a whole line is meant.
    value : str or None
        Text of the cell; None where a whole column is meant.
    hint : str or None
        What to do.
    """

    def __init__(
        self,
        path: str,
        reason: str,
        *,
        line: int | None = None,
        column: str | None = None,
        value: str | None = None,
        hint: str | None = None,
    ) -> None:
        place = "".join((f", line {line}" if line else "", f", column {column}" if column else ""))
        cell = "" if value is None else f"{value!r} "
        super().__init__(f"{path}{place}: {cell}{reason}" + (f"; {hint}" if hint else ""))
        self.path, self.line, self.column, self.value, self.hint = path, line, column, value, hint


@dataclass(frozen=True)
class TextTable:
    """A table as it stands in a file.

    The line of the names is `head`, `lines` are those of the rows; each cell is a text. `points`
    are the tracked points of the columns, in exports that name them; else "".
    """

    path: str
    head: int
    names: list[str]
    points: list[str]
    lines: list[int]
    rows: list[list[str]]

    def refusal(
        self, reason: str, *, column: str | None = None, hint: str | None = None
    ) -> TableFileError:
        """Return the error of the columns as the line of names has them."""
        return TableFileError(self.path, reason, line=self.head, column=column, hint=hint)

    def with_some_of(self, places: list[int]) -> TextTable:
        """Return the rows in which some of these columns are not empty."""
        return self.with_rows(
            [k for k, row in enumerate(self.rows) if any(row[place] for place in places)]
        )

    def with_rows(self, kept: list[int]) -> TextTable:
        """Return some of the rows."""
        return replace(self, lines=[self.lines[k] for k in kept], rows=[self.rows[k] for k in kept])

    def check_growing(self, place: int, numbers: Sequence[float]) -> None:
        """Refuse times, as they were read of a column, that do not grow."""
        for i, (before, after) in enumerate(itertools.pairwise(numbers)):
            if after <= before:
                raise TableFileError(
                    self.path,
                    f"must be greater than {self.rows[i][place]} of line {self.lines[i]}",
                    line=self.lines[i + 1],
                    column=self.names[place],
                    value=self.rows[i + 1][place],
                    hint="times must grow",
                )

    def numbers(self, place: int, required: bool) -> list[float]:
        """Return a column as numbers; NaN where a cell is empty, unless each row must have one."""
        cells = [row[place] for row in self.rows]
        marks: dict[str, int] = {}
        for line, cell in zip(self.lines, cells, strict=True):
            for mark in ".,":
                if mark in cell and NUMBER.fullmatch(cell):
                    marks.setdefault(mark, line)
        if len(marks) == 2:
            mark = max(marks, key=lambda one: marks[one])
            line = marks[mark]
            raise TableFileError(
                self.path,
                "has another decimal mark than the cells before",
                line=line,
                column=self.names[place],
                value=cells[self.lines.index(line)],
                hint="write all numbers with a point, or all with a comma",
            )
        found = []
        for line, cell in zip(self.lines, cells, strict=True):
            if cell.lower() in _MISSING and not required:
                found.append(float("nan"))
            elif NUMBER.fullmatch(cell):
                found.append(float(cell.replace(",", ".")))
            else:
                hint = None if required else "leave a cell empty where the point was not seen"
                raise TableFileError(
                    self.path,
                    "is not a finite number",
                    line=line,
                    column=self.names[place],
                    value=cell,
                    hint=hint,
                )
        return found


def read_text_table(path: str | Path) -> TextTable:
    """Read a table: names in its first line, one row a line; refuse a file that is none.

    Tabs, semicolons, commas or spaces separate the cells, a point or a comma marks decimals; a
    byte-order mark, quotes, and the lines that Tracker, Kinovea and spreadsheets put before the
    names are understood.
    """
    file = str(path)
    lines = _text(file, _content(path)).splitlines()
    if lines and lines[0].startswith(_KINOVEA):
        return _kinovea(file, lines)
    head = next(
        (k for k, line in enumerate(lines) if line.strip() and not line.startswith(("#", "sep="))),
        None,
    )
    if head is None:
        raise TableFileError(
            file, "is empty", hint="a table has a line of names, such as time_s,theta_deg,x_m"
        )
    # The line of names decides: numbers may have decimal commas.
    named_points = lines[head][:1] in ("\t", ";", ",")
    names_at = head + 1 if named_points else head
    if names_at >= len(lines):
        raise TableFileError(file, "has no line of names", line=head + 1)
    separator = lines[head][0] if named_points else _separator(lines[names_at])
    split = [_cells(line, separator) for line in lines]
    names = split[names_at]
    while names and not names[-1]:
        names = names[:-1]
    points = [""] * len(names)
    if named_points:
        owner = ""
        for k in range(len(names)):
            owner = split[head][k] if k < len(split[head]) and split[head][k] else owner
            points[k] = owner
        points[0] = ""
    numbers, rows = [], []
    for k in range(names_at + 1, len(lines)):
        row = split[k]
        if not any(row):
            continue
        if len(row) < len(names) or any(row[len(names) :]):
            reason = f"has {len(row)} cells, the line of names has {len(names)}"
            hint = f"cells are separated by {_SEPARATORS.get(separator, 'spaces')} here"
            raise TableFileError(file, reason, line=k + 1, hint=hint)
        numbers.append(k + 1)
        rows.append(row[: len(names)])
    if not rows:
        raise TableFileError(file, "has no rows after its line of names", line=names_at + 1)
    return TextTable(file, names_at + 1, names, points, numbers, rows)


def _content(path: str | Path) -> bytes:
    """Return what is in a file; refuse what is none, and so need not end, before it is opened."""
    if Path(path).exists() and not Path(path).is_file():
        raise TableFileError(str(path), "is a folder, a pipe or a device, not a file")
    with Path(path).open("rb") as file:
        content = file.read(_MOST_BYTES + 1)
    if len(content) > _MOST_BYTES:
        raise TableFileError(str(path), f"has more than {_MOST_BYTES} bytes")
    return content


def _text(file: str, content: bytes) -> str:
    for start, reason in _OTHER_FILES.items():
        if content.startswith(start):
            raise TableFileError(file, f"is {reason}")
    if content.startswith((b"\xff\xfe", b"\xfe\xff")):
        encoding = "utf-16"
    elif b"\0" in content:
        raise TableFileError(
            file, f"is not text: byte {content.index(0)} is 0", hint="export the track as CSV"
        )
    else:
        encoding = "utf-8-sig"
    try:
        return content.decode(encoding)
    except UnicodeDecodeError as error:
        line = content[: error.start].count(b"\n") + 1
        raise TableFileError(
            file,
            f"byte {content[error.start]:#04x} is not UTF-8",
            line=line,
            hint="save the file as UTF-8",
        ) from None


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


def _kinovea(file: str, lines: list[str]) -> TextTable:
    """Read Kinovea's text for Gnuplot: T X Y of one trajectory after the other."""
    cells: dict[str, dict[str, list[str]]] = {}
    numbers: dict[str, int] = {}
    point, fresh = "", True
    for k, line in enumerate(lines[2:], start=3):
        if line.startswith("#"):
            point, fresh = line[1:].strip(), False
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
                hint = "choose milliseconds as the time code of Kinovea"
                raise TableFileError(
                    file, "occurs twice", line=k, column="T", value=row[0], hint=hint
                )
            cells[point][row[0]] = row[1:]
            numbers.setdefault(row[0], k)
    if not numbers:
        raise TableFileError(file, "has no trajectory")
    names, points = ["T"], [""]
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
    return TextTable(file, 2, names, points, [places[k] for k in order], rows)


def _seconds(text: str) -> float:
    """Return a time of Kinovea: seconds, or hours, minutes, seconds and hundredths."""
    parts = text.split(":")
    try:
        if len(parts) == 1:
            return float(text.replace(",", "."))
        numbers = [float(part) for part in parts]
    except ValueError:
        return float("nan")
    hundredths = numbers.pop() / 100.0 if len(parts) == 4 else 0.0
    return sum(60.0**k * value for k, value in enumerate(reversed(numbers))) + hundredths
