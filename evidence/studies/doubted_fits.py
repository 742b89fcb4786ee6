"""Doubted fits: how often a fit of a faulty film is wrong, and says nothing."""

from __future__ import annotations

import csv
import functools

from scipy.stats import binomtest

from .film.command import KINDS
from .film.faults import FAULTS, WRONG
from .page import table
from .study import PAGES, Study

WEAK = ("interval", "sequences")
"""Doubts that good tracks raise, too: they speak of one interval or one slip, not of the film."""


@functools.cache
def all_rows() -> list[dict[str, str]]:
    """Return the lines of the table of fits."""
    with (PAGES / "doubted-fits" / "films.csv").open(encoding="utf-8") as file:
        return list(csv.DictReader(file))


def rows_of(fault: str) -> list[dict[str, str]]:
    """Return the lines of a fault in the table of fits."""
    return [row for row in all_rows() if row["fault"] == fault]


def is_wrong(row: dict[str, str]) -> bool:
    """Whether the truth of an identifiable parameter is beyond so many standard errors."""
    return float(row["worst"]) > WRONG


def doubts_of(row: dict[str, str]) -> list[str]:
    """Return the doubts that speak of the film."""
    return [name for name in row["doubts"].split() if name not in WEAK]


def unsaid(rows: list[dict[str, str]]) -> int:
    """Return how many fits are wrong without any doubt."""
    return sum(is_wrong(row) and not row["doubts"] for row in rows)


def silent(rows: list[dict[str, str]]) -> int:
    """Return how many fits are wrong without a doubt about the film."""
    return sum(is_wrong(row) and not doubts_of(row) for row in rows)


def of_faults() -> list[str]:
    """Return a line for each fault, with the three kinds of motion."""
    lines = []
    for name, fault in FAULTS.items():
        cells = [" ".join((fault.__doc__ or name).split()).rstrip(".")]
        for kind in KINDS:
            rows = [row for row in rows_of(name) if row["kind"] == kind]
            doubted = sum(bool(doubts_of(row)) for row in rows)
            cells += [str(len(rows)), str(sum(map(is_wrong, rows))), str(doubted)]
            cells += [str(silent(rows)), str(unsaid(rows))]
        lines.append(cells)
    said = ["fits", "wrong", "doubted", "wrong, not doubted", "wrong, no doubt at all"]
    heads = [f"{kind}: {what}" if what == "fits" else what for kind in KINDS for what in said]
    return table(["fault", *heads], lines)


def faulty() -> list[dict[str, str]]:
    """Return the lines of tracks with a fault."""
    return [row for row in all_rows() if row["fault"] != "none"]


def result() -> str:
    """How many fits of all faulty films are wrong without a doubt of the film."""
    return f"{silent(faulty())} of {len(faulty())}"


def mute() -> str:
    """How many of them are wrong without any doubt, and what so many films leave possible."""
    return f"{unsaid(faulty())}, so at most {at_most(faulty()):.1%}"


def alarms() -> str:
    """How many good tracks of each kind are doubted, and what their doubt is."""
    words = []
    for kind in KINDS:
        rows = [row for row in rows_of("none") if row["kind"] == kind]
        unseen = sum("unseen" in doubts_of(row) for row in rows)
        more = sum(bool(set(doubts_of(row)) - {"unseen"}) for row in rows)
        words.append(f"{kind} {unseen} and {more} of {len(rows)}")
    return ", ".join(words)


def at_most(rows: list[dict[str, str]]) -> float:
    """Return the share of unsaid wrong fits that so many films leave possible, at 95 %.

    This is Clopper and Pearson's bound.
    """
    return float(binomtest(unsaid(rows), len(rows), alternative="less").proportion_ci(0.95).high)


STUDY = Study(
    name="doubted-fits",
    texts={"result": result, "faults": of_faults, "alarms": alarms, "mute": mute},
    pictures={},
)
"""Fits of films with a fault that the fit does not know of."""
