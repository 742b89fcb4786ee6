"""Measured data: clocks of good and of wrong tracks, and fits of good tracks by the command."""

from __future__ import annotations

import csv
import functools
from collections.abc import Iterator
from dataclasses import dataclass, replace
from statistics import NormalDist
from typing import TYPE_CHECKING

import littlewood as lw
import numpy as np
import numpy.typing as npt
from littlewood.fitting.diagnostics import _LOUD
from littlewood.fitting.fall import Fall, fall_of
from littlewood.plot.sheet import panels

from .film.clocks import OFF, RATES
from .film.command import ALL, FITS, KINDS, filmed, random_motions
from .film.resistance import resistance_rows
from .film.throws import FREE, throw
from .page import share, table
from .pictures import calibration
from .study import PAGES, Study

if TYPE_CHECKING:
    from matplotlib.figure import Figure

TRACKS = 1000
SEED = 6
"""No track of this seed was seen before the limits were set."""
THROWS = 50
NAMED = 0.01
"""From which probability on a sequence is named."""


@dataclass(frozen=True, kw_only=True)
class Checked:
    """What the check says of a track, and of the same track with a wrong clock."""

    rate: float
    noise_m: float
    good: Fall | None
    wrong: Fall | None


def _checked(
    motion: lw.Trajectory,
    rate: float,
    noise_m: float,
    noise_rad: float,
    random: np.random.Generator,
) -> Checked:
    track = filmed(motion, rate, noise_m, noise_rad, random)
    factor = (1.0 + OFF) ** random.choice([-1.0, 1.0])
    slow = replace(track, time=factor * track.time)
    hoop = motion.hoop
    return Checked(rate=rate, noise_m=noise_m, good=fall_of(track, hoop), wrong=fall_of(slow, hoop))


@functools.cache
def good_tracks() -> list[Checked]:
    """Tracks of any motion, level or on a slope, of every rate, with noise up to 3 mm."""

    def drawn() -> Iterator[Checked]:
        for number in range(TRACKS):
            random = np.random.default_rng([SEED, number])
            slope = random.choice([0.0, random.uniform(-0.2, 0.2)])
            yield _checked(
                next(random_motions(random, slope)),
                RATES[number % len(RATES)],
                random.uniform(0.0, 0.003),
                random.uniform(0.0, 0.01),
                random,
            )

    return list(drawn())


@functools.cache
def throws() -> list[Checked]:
    """Throws that land twice within a second, with noise of 1 mm and of 3 mm."""
    found = []
    for number in range(THROWS):
        random = np.random.default_rng([SEED, 1, number])
        motion = throw(random).motion
        for rate in RATES:
            for noise_m in (0.001, 0.003):
                found.append(_checked(motion, rate, noise_m, 0.004, random))
    return found


def refused() -> str:
    """How many good tracks are refused."""
    found = good_tracks()
    return f"{sum(one.good is not None and one.good.is_wrong for one in found)} of {len(found)}"


def of_rates() -> list[str]:
    """Good tracks by their rates."""
    lines = []
    for rate in RATES:
        rows = [one for one in good_tracks() if one.rate == rate]
        told = [one.good for one in rows if one.good is not None]
        pulls = np.array([(one.gravity - 1.0) / one.std_error for one in told])
        within = np.mean(np.abs(pulls) < 1.96)
        lines.append(
            [
                f"{rate:g}",
                str(len(rows)),
                str(len(told)),
                f"{100.0 * within:.0f} %",
                str(sum(one.is_wrong for one in told)),
            ]
        )
    heads = ["frames a second", "tracks", "with flights", "g in ±1.96 errors", "refused"]
    return table(heads, lines)


def of_wrong_clocks() -> list[str]:
    """Throws with a wrong clock, by what their flights tell."""
    lines = []
    for low, high in ((0.0, 0.01), (0.01, 0.015), (0.015, 0.03), (0.03, np.inf)):
        rows = [
            one.wrong
            for one in throws()
            if one.wrong is not None and low <= one.wrong.std_error / one.wrong.gravity < high
        ]
        named = sum(one.is_wrong for one in rows)
        size = f"{100 * low:g} % to {100 * high:g} %" if high < np.inf else f"{100 * low:g} % on"
        lines.append([size, str(len(rows)), f"{100.0 * named / len(rows):.0f} %"])
    silent = sum(one.wrong is None for one in throws())
    lines.append(["no flight above 0.03 R", str(silent), "0 %"])
    return table(["standard error of g", "throws", "named"], lines)


def named() -> str:
    """How many of all throws with a wrong clock are named."""
    found = sum(one.wrong is not None and one.wrong.is_wrong for one in throws())
    return f"{found} of {len(throws())}"


def least_told() -> float:
    """Return how many standard errors of its clock a track needs, so that 95 % of such are named.

    Any test that doubts one good track in 300 of twenty tests needs so many.
    """
    return _LOUD + NormalDist().inv_cdf(0.95)


@functools.cache
def fitted_clocks() -> list[dict[str, str]]:
    """Return the lines of the table of throws with a wrong clock that were fitted."""
    with (PAGES / "measured-data" / "clocks.csv").open(encoding="utf-8") as file:
        return list(csv.DictReader(file))


def is_named(row: dict[str, str]) -> bool:
    """Whether the clock is named, by the flights before the fit or by the fit."""
    return row["by_flights"] == "1" or "clock" in row["named"].split()


def of_fitted_clocks() -> list[str]:
    """Throws with a wrong clock, by what the whole track can tell."""
    lines = []
    for words, tells in (("can tell", True), ("cannot tell", False)):
        rows = [
            row
            for row in fitted_clocks()
            if (OFF / float(row["clock_error"]) >= least_told()) == tells
        ]
        by_flights = sum(row["by_flights"] == "1" for row in rows)
        alone = sum(row["named"] == "clock" for row in rows)
        lines.append(
            [
                words,
                str(len(rows)),
                str(by_flights),
                str(alone),
                share(sum(map(is_named, rows)), len(rows)),
            ]
        )
    heads = ["the track", "throws", "named by flights", "by the fit, alone", "named"]
    return table(heads, lines)


def clocks_named() -> str:
    """How many of the fitted throws with a wrong clock are named."""
    rows = fitted_clocks()
    return f"{sum(map(is_named, rows))} of {len(rows)}"


@functools.cache
def fits() -> list[dict[str, str]]:
    """Return the lines of the table of fits."""
    with (PAGES / "measured-data" / "fits.csv").open(encoding="utf-8") as file:
        return list(csv.DictReader(file))


def pulls(rows: list[dict[str, str]], name: str) -> npt.NDArray[np.float64]:
    """Return errors over standard errors, where a coefficient is identifiable."""
    return np.array(
        [
            (float(row[f"{name}_value"]) - float(row[f"{name}_true"])) / float(row[f"{name}_error"])
            for row in rows
            if row[f"{name}_error"] not in ("", "inf")
        ]
    )


def _parts(values: npt.NDArray[np.float64]) -> list[str]:
    holds = (int(np.sum(np.abs(values) < limit)) for limit in (0.994, 1.96))
    return [str(values.size), *(share(one, values.size) for one in holds)]


def _fits_of(fit: str) -> list[dict[str, str]]:
    return [row for row in fits() if row["fit"] == fit]


def _all_pulls(fit: str) -> npt.NDArray[np.float64]:
    return np.concatenate([pulls(_fits_of(fit), name) for name in FITS[fit]])


def coverage() -> list[str]:
    """How often intervals contain the truth."""
    lines = []
    for fit, names in FITS.items():
        for name in names:
            lines.append([fit, name, *_parts(pulls(_fits_of(fit), name))])
        lines.append([fit, "all", *_parts(_all_pulls(fit))])
    heads = ["rolling resistance", "coefficient", "intervals", "68 % contain the truth", "95 %"]
    return table(heads, lines)


def within(limit: float) -> str:
    """How many of all intervals of a size contain the truth, by fit."""
    parts = (100.0 * np.mean(np.abs(_all_pulls(fit)) < limit) for fit in FITS)
    return " and ".join(f"{part:.0f} %" for part in parts)


def sequences() -> list[str]:
    """How often the true sequence is found, or named with its odds."""
    lines = []
    for fit in FITS:
        for kind in (*KINDS, "all"):
            rows = [row for row in _fits_of(fit) if kind in (row["kind"], "all")]
            found = sum(row["phases"] == row["found"] for row in rows)
            named = sum(
                row["phases"] == row["found"] or float(row["probability"]) > NAMED for row in rows
            )
            lines.append([fit, kind, str(len(rows)), str(found), share(named, len(rows))])
    heads = ["rolling resistance", "kind", "tracks", "found", "found or named"]
    return table(heads, lines)


WRONG = 3.0
"""A fit is wrong if it misses a coefficient that is told by more standard errors."""
WEAK = {"identifiability", "interval", "sequences"}
"""Doubts that good tracks raise, too."""


def worst(row: dict[str, str]) -> float:
    """Return by how many standard errors the worst of the coefficients is off that are told."""
    told = [name for name in ALL if row[f"{name}_error"] not in ("", "inf")]
    return max((float(abs(pulls([row], name)[0])) for name in told), default=0.0)


def of_resistance() -> list[str]:
    """How often intervals of fits that estimate rolling resistance contain the truth."""
    rows = [row for row in resistance_rows(PAGES / "measured-data") if row["fit"] == "estimated"]
    lines = []
    for name in ALL:
        told = [float(row[f"{name}_error"]) for row in rows if row[f"{name}_error"] != "inf"]
        lines.append([name, *_parts(pulls(rows, name)), f"{np.median(told):.2g}"])
    heads = ["coefficient", "intervals", "68 % contain the truth", "95 %", "median error"]
    return table(heads, lines)


def strong(row: dict[str, str]) -> set[str]:
    """Return the doubts of a fit that speak of more than one interval or one slip."""
    return set(row["doubts"].split()) - WEAK


def of_held_resistance() -> list[str]:
    """How often fits of hoops with rolling resistance are wrong, and how often in silence."""
    lines = []
    for fit in FITS:
        for kind in KINDS:
            rows = [
                row
                for row in resistance_rows(PAGES / "measured-data")
                if (row["fit"], row["kind"]) == (fit, kind)
                and float(row["rolling_resistance_true"]) > 0.0
            ]
            wrong = [row for row in rows if worst(row) > WRONG]
            silent = [row for row in wrong if not strong(row)]
            lines.append([fit, kind, *(str(len(one)) for one in (rows, wrong, silent))])
    return table(["rolling resistance", "kind", "tracks", "wrong", "wrong in silence"], lines)


def calibrated() -> Figure:
    """How often intervals of the command contain the truth, of what both fits estimate."""
    figure, axes = panels(2)
    for axis, fit in zip(axes, FITS, strict=True):
        rows = _fits_of(fit)
        errors = {name: pulls(rows, name) for name in FREE}
        calibration(axis, errors, len(rows), f"*χ* {fit}")
    return figure


STUDY = Study(
    name="measured-data",
    texts={
        "refused": refused,
        "rates": of_rates,
        "clocks": of_wrong_clocks,
        "named": named,
        "least": lambda: f"{least_told():.1f}",
        "fitted clocks": of_fitted_clocks,
        "clocks named": clocks_named,
        "coverage": coverage,
        "68": lambda: within(0.994),
        "95": lambda: within(1.96),
        "sequences": sequences,
        "resistance": of_resistance,
        "held": of_held_resistance,
    },
    pictures={"calibration": calibrated},
)
"""What may be believed of measured data."""
