"""Doubted fits: how often a fit of a faulty film is wrong, and says nothing."""

from __future__ import annotations

import csv
import functools
from typing import TYPE_CHECKING

import numpy as np
from littlewood.plot.canvas import key
from littlewood.plot.sheet import panels
from littlewood.style import FINE, INK, LINE, PAPER, SOFT
from scipy.stats import binomtest

from .film.command import KINDS
from .film.faults import FAULTS, WRONG
from .page import share, table
from .study import PAGES, Study

if TYPE_CHECKING:
    from matplotlib.figure import Figure

CAUSES = {
    "scale": ("camera_scale",),
    "tilt": ("camera_perspective_x",),
    "roll": ("camera_turn", "slope"),
    "marker": ("camera_marker",),
    "ramp": ("slope", "camera_turn"),
    "soft": ("rolling_resistance",),
    "mass": ("mass_ratio",),
    "offset": ("offset",),
    "clock": ("clock", "fall"),
    "fast": ("clock", "fall"),
    "held": ("mu_s",),
}
"""What the doubts `held` and `camera` call a fault; `fall` is the check of the clock by flights."""

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
    for name in FAULTS:
        cells = [_words_of(name)]
        for kind in KINDS:
            rows = _rows_of_kind(name, kind)
            cells += [f"{sum(map(is_wrong, rows))} of {len(rows)}", share(silent(rows), len(rows))]
        lines.append(cells)
    said = ("wrong", "and not doubted")
    heads = [f"{kind}: {what}" if what == "wrong" else what for kind in KINDS for what in said]
    return table(["fault", *heads], lines)


def of_kinds() -> list[str]:
    """Return a line for each kind of motion: all faults together."""
    lines = []
    for kind in KINDS:
        rows = [row for row in faulty() if row["kind"] == kind]
        cells = [share(one(rows), len(rows)) for one in (silent, unsaid)]
        lines.append([kind, str(len(rows)), str(sum(map(is_wrong, rows))), *cells])
    return table(["kind", "fits", "wrong", "wrong, not doubted", "wrong, no doubt at all"], lines)


def of_causes() -> list[str]:
    """Return a line for each fault that has a name: how often doubts name it."""
    lines = []
    for name, causes in CAUSES.items():
        cells = [_words_of(name), ", ".join(causes)]
        for kind in KINDS:
            rows = _rows_of_kind(name, kind)
            named = sum(any(one in row["named"].split() for one in causes) for row in rows)
            cells.append(share(named, len(rows)))
        lines.append(cells)
    return table(["fault", "named as", *KINDS], lines)


def _words_of(fault: str) -> str:
    return " ".join((FAULTS[fault].__doc__ or fault).split()).rstrip(".")


def _rows_of_kind(fault: str, kind: str) -> list[dict[str, str]]:
    return [row for row in rows_of(fault) if row["kind"] == kind]


def faulty() -> list[dict[str, str]]:
    """Return the lines of tracks with a fault."""
    return [row for row in all_rows() if row["fault"] != "none"]


def result() -> str:
    """How many fits of all faulty films are wrong without a doubt of the film."""
    return f"{silent(faulty())} of {len(faulty())}"


def mute() -> str:
    """How many of them are wrong without any doubt, and what so many films leave possible."""
    return f"{unsaid(faulty())}, so at most {at_most(faulty()):.1%}"


def alarms() -> list[str]:
    """Return a line for each kind of motion: which doubts good tracks have."""
    lines = []
    for kind in KINDS:
        rows = _rows_of_kind("none", kind)
        unseen = sum("unseen" in doubts_of(row) for row in rows)
        more = sum(bool(set(doubts_of(row)) - {"unseen"}) for row in rows)
        lines.append([kind, str(len(rows)), *(share(one, len(rows)) for one in (unseen, more))])
    return table(["kind", "good tracks", "`unseen`", "another doubt of the film"], lines)


def at_most(rows: list[dict[str, str]]) -> float:
    """Return the share of unsaid wrong fits that so many films leave possible, at 95 %.

    This is Clopper and Pearson's bound.
    """
    return float(binomtest(unsaid(rows), len(rows), alternative="less").proportion_ci(0.95).high)


def picture() -> Figure:
    """How many fits are wrong, and how many are doubted, by fault."""
    figure, (axis,) = panels(1, height=480.0)
    names = list(FAULTS)
    parts = {
        "wrong, doubted": (True, True),
        "wrong, not doubted": (True, False),
        "right, doubted": (False, True),
        "right, not doubted": (False, False),
    }
    left = np.zeros(len(names))
    colours = (SOFT, INK, LINE, PAPER)
    for (label, part), colour in zip(parts.items(), colours, strict=True):
        counts = np.array(
            [
                sum((is_wrong(row), bool(doubts_of(row))) == part for row in rows_of(name))
                for name in names
            ]
        )
        axis.barh(names, counts, left=left, color=colour, edgecolor=INK, lw=FINE, label=label)
        left += counts
    axis.set_ylim(len(names) - 0.4, -0.6)
    axis.set(xlabel="fits", xlim=(0, float(left.max())))
    key(axis)
    return figure


STUDY = Study(
    name="doubted-fits",
    texts={
        "result": result,
        "mute": mute,
        "kinds": of_kinds,
        "faults": of_faults,
        "causes": of_causes,
        "alarms": alarms,
    },
    pictures={"doubts": picture},
)
"""Fits of films with a fault that the fit does not know of."""
