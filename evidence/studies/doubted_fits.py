"""Doubted fits: how often a fit of a faulty film is wrong, and says nothing."""

from __future__ import annotations

import csv
from collections import Counter

from scipy.stats import binomtest

from .film.faults import FAULTS, WRONG
from .page import table
from .study import PAGES, Study

WEAK = ("interval", "sequences")
"""Doubts that good tracks raise, too: they speak of one interval or one slip, not of the film."""


def rows_of(fault: str) -> list[dict[str, str]]:
    """Return the lines of a fault in the table of fits."""
    with (PAGES / "doubted-fits" / "films.csv").open(encoding="utf-8") as file:
        return [row for row in csv.DictReader(file) if row["fault"] == fault]


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
    """Return a line for each fault."""
    lines = []
    for name, film in FAULTS.items():
        rows = rows_of(name)
        said = Counter(doubt for row in rows for doubt in doubts_of(row))
        lines.append(
            [
                " ".join((film.__doc__ or name).split()).rstrip("."),
                str(sum(map(is_wrong, rows))),
                str(sum(bool(doubts_of(row)) for row in rows)),
                str(silent(rows)),
                str(unsaid(rows)),
                ", ".join(f"`{doubt}` {count}" for doubt, count in said.most_common(1)),
            ]
        )
    return table(
        [
            "fault",
            "wrong",
            "doubted",
            "wrong and not doubted",
            "wrong without any doubt",
            "most raised",
        ],
        lines,
    )


def result() -> str:
    """How many fits of all faulty films are wrong without a doubt."""
    rows = [row for name in FAULTS if name != "none" for row in rows_of(name)]
    return f"{silent(rows)} of {len(rows)}"


def alarms() -> str:
    """How many fits of good tracks are doubted."""
    rows = rows_of("none")
    return f"{sum(bool(doubts_of(row)) for row in rows)} of {len(rows)}"


def weak() -> str:
    """How many fits of good tracks raise the weak doubts."""
    rows = rows_of("none")
    return f"{sum(bool(row['doubts']) for row in rows)} of {len(rows)}"


SEEN = 17
"""Films of each fault that had been looked at when the last limit of a doubt was set."""


def at_most(rows: list[dict[str, str]]) -> float:
    """Return the share of unsaid wrong fits that so many films leave possible, at 95 %.

    This is Clopper and Pearson's bound.
    """
    return float(binomtest(unsaid(rows), len(rows), alternative="less").proportion_ci(0.95).high)


def fresh() -> str:
    """How many fits of new films are wrong without any doubt.

    And what these films, not seen before, leave possible.
    """
    rows = {
        name: [row for row in rows_of(name) if int(row["film"]) >= SEEN]
        for name in FAULTS
        if name != "none"
    }
    together = [row for one in rows.values() for row in one]
    worst = max(map(at_most, rows.values()))
    return (
        f"{unsaid(together)} of {len(together)} are wrong without any doubt, so at most "
        f"{at_most(together):.1%} of all "
        f"and at most {worst:.1%} of any one fault"
    )


STUDY = Study(
    name="doubted-fits",
    texts={"result": result, "faults": of_faults, "alarms": alarms, "weak": weak, "fresh": fresh},
    pictures={},
)
"""Fits of films with a fault that the fit does not know of."""
