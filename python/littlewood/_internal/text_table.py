"""Tables of numbers in text files, as spreadsheets and trackers write them."""

from __future__ import annotations

import itertools
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

__all__ = ["MISSING", "NUMBER", "TableFileError", "TextTable", "lines_of"]

NUMBER = re.compile(r"[+-]?(\d+([.,]\d*)?|[.,]\d+)([eE][+-]?\d+)?")
# A comma here may mark the decimals, or the thousands.
_THOUSANDS = re.compile(r"[+-]?[1-9]\d{0,2},\d{3}")
# A million rows of a dozen cells.
_MOST_BYTES = 1 << 28
# What programs write where they have no number.
MISSING = ("", "nan", "na", "n/a", "#n/a", "none", "null", "-", "--")
# What the first bytes say of files that look like tables to their owners.
_OTHER_FILES = {
    b"PK": "a spreadsheet or an archive: save the sheet as CSV",
    b"\xd0\xcf\x11\xe0": "a spreadsheet: save the sheet as CSV",
    b"<?xml": "a project or a web page: export the data of its track as text",
    b"{": "JSON: export the data of the track as CSV",
    b"\x89HDF": "HDF5: export the data of the track as CSV",
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
    are the tracked points of the columns, in exports that name them; else "". `layout` is the name
    of that which the file has, "" for none in particular.
    """

    layout: str
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
        if set(marks) == {","}:
            self._check_decimals(place)
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
            if cell.lower() in MISSING and not required:
                found.append(float("nan"))
            elif NUMBER.fullmatch(cell):
                found.append(float(cell.replace(",", ".")))
            else:
                hint = "leave a cell empty where the point was not seen"
                if required:
                    hint = "each row needs a number, such as s from the first; remove other lines"
                raise TableFileError(
                    self.path,
                    "is not a finite number",
                    line=line,
                    column=self.names[place],
                    value=cell,
                    hint=hint,
                )
        return found

    def _check_decimals(self, place: int) -> None:
        """Refuse a column whose commas may mark decimals, or thousands; another cell may tell."""
        cells = [cell for row in self.rows for cell in row if "," in cell]
        if all(_THOUSANDS.fullmatch(cell) for cell in cells if NUMBER.fullmatch(cell)):
            k = next(k for k, row in enumerate(self.rows) if _THOUSANDS.fullmatch(row[place]))
            cell = self.rows[k][place]
            raise TableFileError(
                self.path,
                f"may be {cell.replace(',', '')} or {cell.replace(',', '.')}",
                line=self.lines[k],
                column=self.names[place],
                value=cell,
                hint="write decimals with a point, and thousands without a mark",
            )


def lines_of(path: str | Path) -> list[str]:
    """Return the lines of a text file; refuse a file that is none."""
    return _text(str(path), _content(path)).splitlines()


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
            hint="save the file as UTF-8 (Excel: CSV UTF-8)",
        ) from None
