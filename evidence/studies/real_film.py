"""A real film: how far it tells the coefficients of its hoop.

Measured on films whose truth is known.
"""

from __future__ import annotations

import csv
import math
from typing import TYPE_CHECKING

import numpy as np
from littlewood.plot.sheet import panels

from .film.command import ALL
from .film.hard import HARD
from .film.resistance import resistance_rows
from .film.throws import FREE
from .film.videos import film_of, fitted, track_of
from .page import table
from .pictures import calibration, part_within
from .study import PAGES, Study

if TYPE_CHECKING:
    from matplotlib.figure import Figure

NAMES = {"mu_s": "μs", "mu_k": "μk", "inertia": "inertia", "restitution": "e"}
LOSSES = NAMES | {"rolling_resistance": "χ"}


def rows_of(name: str) -> list[dict[str, float]]:
    """Return the lines of a table of fits that stands beside the pictures."""
    with (PAGES / "real-film" / f"{name}.csv").open(encoding="utf-8") as file:
        return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]


def pulls(rows: list[dict[str, float]], name: str) -> list[float]:
    """Return errors over standard errors, of the films that tell a coefficient."""
    told = [row for row in rows if math.isfinite(row[f"{name}_error"])]
    return [(row[f"{name}_value"] - row[f"{name}_true"]) / row[f"{name}_error"] for row in told]


def coverage() -> list[str]:
    """How often intervals of videos contain the truth."""
    rows = rows_of("videos")
    lines = []
    for quantity, label in (NAMES | {"exposure_s": "exposure, s"}).items():
        values = pulls(rows, quantity)
        error = float(np.median([row[f"{quantity}_error"] for row in rows]))
        lines.append(
            [label, str(len(values)), f"{100.0 * part_within(values, 0.95):.0f} %", f"{error:.1e}"]
        )
    return table(
        [
            "coefficient",
            "films that determine it",
            "truth in the 95 % interval",
            "median standard error",
        ],
        lines,
    )


def by_exposure(long: bool) -> str:
    """How often 95 % intervals contain the truth if films are exposed for a wrong time.

    For more or less than half of it.
    """
    rows = [
        row for row in rows_of("videos") if (row["exposure_s_true"] * row["rate"] > 0.5) == long
    ]
    parts = [100.0 * part_within(pulls(rows, name), 0.95) for name in FREE]
    return ", ".join(f"{part:.0f}" for part in parts) + f" % of {len(rows)}"


def result() -> str:
    """How often the 95 % intervals of videos contain the truth, over the coefficients."""
    rows = rows_of("videos")
    parts = [100.0 * part_within(pulls(rows, name), 0.95) for name in FREE]
    return f"{min(parts):.0f} to {max(parts):.0f} %"


def beyond(name: str, limit: float) -> str:
    """In how many films that tell a coefficient it is wrong.

    By more than so many standard errors.
    """
    values = pulls(rows_of("videos"), name)
    return f"{sum(abs(value) > limit for value in values)} of {len(values)}"


FILM = 4
"""Number of the film that is made and fitted."""


def of_fits() -> str:
    """How far fits of a film are off, with and without the constants of the camera."""
    film, track = film_of(FILM), track_of(film_of(FILM))
    parts = []
    for more in ({}, {"calibration": ()}):
        estimates = fitted(film, track, **more).estimates
        off = [
            (estimates[name].value - getattr(film.thrown.hoop, name)) / estimates[name].std_error
            for name in FREE
        ]
        parts.append(", ".join(f"{value:+.1f}" for value in off).replace("-", "−"))
    return f"{parts[0]}, and without the constants of the camera {parts[1]}"


def calibrated() -> Figure:
    """How often intervals of the videos contain the truth."""
    figure, (axis,) = panels(1)
    rows = rows_of("videos")
    calibration(axis, {name: pulls(rows, name) for name in NAMES}, len(rows), "through the video")
    return figure


def sequences() -> str:
    """In how many films the fit ends with the true sequence of phases."""
    rows = rows_of("videos")
    return f"{sum(int(row['sequence_found']) for row in rows)} of {len(rows)}"


def hard_rows() -> list[dict[str, str]]:
    """Return the lines of the table of harder films."""
    with (PAGES / "real-film" / "hard.csv").open(encoding="utf-8") as file:
        return list(csv.DictReader(file))


def harder() -> list[str]:
    """How far tracks of harder films are off: medians over the films of a condition."""
    all_rows = hard_rows()
    lines = []
    for name, hard in HARD.items():
        rows = [row for row in all_rows if row["condition"] == name]
        tracked = [row for row in rows if row["centre_px"]]

        def part(key: str, over: str, rows: list[dict[str, str]] = tracked) -> str:
            share = sum(float(row[key]) for row in rows) / sum(float(row[over]) for row in rows)
            return f"{100.0 * share:.0f} %"

        cells = [hard.words]
        if tracked:
            cells += [part("hoops", "frames"), part("markers", "frames")]
            cells += [
                f"{np.median([float(row[key]) for row in tracked]):.2g}"
                for key in ("centre_px", "marker_px")
            ]
        else:
            cells += ["", "", "", ""]
        fitted_ones = [float(row["worst_pull"]) for row in rows if row["worst_pull"]]
        doubted = sum(bool(row["doubts"]) for row in rows)
        cells += [
            f"{len(fitted_ones)} of {len(rows)}",
            f"{max(fitted_ones):.1f}" if fitted_ones else "",
            str(doubted),
        ]
        lines.append(cells)
    heads = [
        "film",
        "hoop found",
        "marker found",
        "centre, pixels",
        "marker, pixels",
        "fitted",
        "worst",
        "doubted",
    ]
    return table(heads, lines)


def off(fit: str, name: str) -> list[float]:
    """Return by how many standard errors fits of films are off, that tell a coefficient."""
    rows = [row for row in resistance_rows(PAGES / "real-film") if row["fit"] == fit]
    return [
        (float(row[f"{name}_value"]) - float(row[f"{name}_true"])) / float(row[f"{name}_error"])
        for row in rows
        if row[f"{name}_error"] not in ("", "inf")
    ]


def resisted() -> list[str]:
    """How far fits of films of hoops that lose by rolling are off, with and without that."""
    lines = []
    rows = [row for row in resistance_rows(PAGES / "real-film") if row["fit"] == "estimated"]
    for name in ALL:
        told, held = off("estimated", name), off("held at 0", name)
        errors = [float(row[f"{name}_error"]) for row in rows if row[f"{name}_error"] != "inf"]
        inside = sum(abs(value) < 1.96 for value in told)
        lines.append(
            [
                LOSSES[name],
                f"{np.median(errors):.1e}",
                f"{inside} of {len(told)}",
                f"{np.median(np.abs(told)):.1f}, {max(map(abs, told)):.1f}",
                f"{np.median(np.abs(held)):.1f}, {max(map(abs, held)):.0f}" if held else "",
            ]
        )
    heads = [
        "coefficient",
        "median standard error",
        "truth in the 95 % interval",
        "off, standard errors: median, worst",
        "with χ held at 0",
    ]
    return table(heads, lines)


def held_doubted() -> str:
    """How many fits that hold rolling resistance at 0, where there is some, ask for it."""
    rows = [
        row
        for row in resistance_rows(PAGES / "real-film")
        if row["fit"] == "held at 0" and float(row["rolling_resistance_true"]) > 0.0
    ]
    strong = {"held", "camera", "structure"}
    return f"{sum(bool(strong & set(row['doubts'].split())) for row in rows)} of {len(rows)}"


STUDY = Study(
    name="real-film",
    texts={
        "result": result,
        "harder": harder,
        "fits": of_fits,
        "videos": coverage,
        "short": lambda: by_exposure(False),
        "long": lambda: by_exposure(True),
        "astray": lambda: beyond("exposure_s", 6.0),
        "tails": lambda: beyond("restitution", 3.0),
        "resisted": resisted,
        "held": held_doubted,
        "sequences of videos": sequences,
    },
    pictures={"calibration": calibrated},
)
