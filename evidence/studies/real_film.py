"""A real film: how far a film of a hoop tells its coefficients, measured on films whose truth is known."""

from __future__ import annotations

import csv
import math
import tempfile
from functools import cache
from pathlib import Path
from statistics import NormalDist
from typing import TYPE_CHECKING

import numpy as np
from littlewood import video
from littlewood.style import FAINT, INK

from .axes import COLOURS, DASHES, panels
from .film.coverage import line_of
from .film.throws import FREE
from .film.videos import Film, film_of, fitted
from .page import table
from .study import PAGES, Study

if TYPE_CHECKING:
    import littlewood as lw
    from matplotlib.figure import Figure

LEVELS = (0.5, 0.8, 0.9, 0.95, 0.99)
NAMES = {"mu_s": "μs", "mu_k": "μk", "inertia": "inertia", "restitution": "e"}
EXPOSURE = {"exposure_s": "exposure, s"}
SHOWN = 4
"""Number of the film that is shown."""

REPEATED = 4
"""How many of the fits are computed again with the page."""


def rows_of(name: str) -> list[dict[str, float]]:
    """Return the lines of a table of fits that stands beside the pictures."""
    with (PAGES / "real-film" / f"{name}.csv").open(encoding="utf-8") as file:
        return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]


def pulls(rows: list[dict[str, float]], name: str) -> list[float]:
    """Return errors over standard errors, of the films that tell a coefficient."""
    told = [row for row in rows if math.isfinite(row[f"{name}_error"])]
    return [(row[f"{name}_value"] - row[f"{name}_true"]) / row[f"{name}_error"] for row in told]


def part_within(values: list[float], level: float) -> float:
    """Return the part of errors that are within the interval of a level."""
    half = NormalDist().inv_cdf(0.5 + 0.5 * level)
    return sum(abs(value) < half for value in values) / len(values)


def coverage(name: str, names: dict[str, str]) -> list[str]:
    """How often intervals contain the truth."""
    rows = rows_of(name)
    lines = []
    for key, label in names.items():
        values = pulls(rows, key)
        error = float(np.median([row[f"{key}_error"] for row in rows]))
        parts = [f"{100.0 * part_within(values, level):.0f} %" for level in LEVELS]
        lines.append([label, str(len(values)), *parts, f"{error:.1e}"])
    heads = [f"{100.0 * level:g} %" for level in LEVELS]
    return table(["coefficient", "films that tell it", *heads, "median standard error"], lines)


def by_exposure(long: bool) -> str:
    """How often 95 % intervals contain the truth in films that are exposed for more or less than half of the time."""
    rows = [row for row in rows_of("videos") if (row["exposure_s_true"] * row["rate"] > 0.5) == long]
    parts = [100.0 * part_within(pulls(rows, name), 0.95) for name in FREE]
    return ", ".join(f"{part:.0f}" for part in parts) + f" % of {len(rows)}"


def result() -> str:
    """How often the 95 % intervals of videos contain the truth, over the coefficients."""
    rows = rows_of("videos")
    parts = [100.0 * part_within(pulls(rows, name), 0.95) for name in FREE]
    return f"{min(parts):.0f} to {max(parts):.0f} %"


def beyond(name: str, limit: float) -> str:
    """In how many films of those that tell a coefficient it is wrong by more than so many standard errors."""
    values = pulls(rows_of("videos"), name)
    return f"{sum(abs(value) > limit for value in values)} of {len(values)}"


def lost() -> str:
    """In how many searches a coefficient that is told is wrong by more than six standard errors."""
    rows = rows_of("search")
    off = [max((abs(value) for name in FREE for value in pulls([row], name)), default=0.0) for row in rows]
    return f"{sum(value > 6.0 for value in off)} of {len(rows)}"


def repeated() -> str:
    """Whether the first fits come out as they stand in the table."""
    rows = rows_of("coverage")
    worst = 0.0
    for film in range(REPEATED):
        cells = dict(zip(rows[0], map(float, line_of(film)), strict=True))
        for key in FREE:
            if math.isfinite(rows[film][f"{key}_error"]):
                off = abs(cells[f"{key}_value"] - rows[film][f"{key}_value"]) / rows[film][f"{key}_error"]
                worst = max(worst, off)
    return f"{REPEATED} of them, made again, agree" if worst < 1e-2 else f"{REPEATED} of them, made again, differ"


@cache
def shown() -> tuple[Film, np.ndarray, video.Circle, video.Marker, lw.Track, lw.Track]:
    """The film of the pictures: what is found in one of them, its track, and that by the clicked plane."""
    film = film_of(SHOWN)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "film.avi"
        film.write(path)
        track, clicked = film.track(path, film.plane), film.track(path, film.clicked)
        picture = list(video.frames(path))[60]
        finder = video.finder_of(path, film.thrown.hoop, plane=film.plane)
    circle = finder.circle(picture)
    assert circle is not None
    marker = finder.marker(picture, circle)
    assert marker is not None
    return film, picture, circle, marker, track, clicked


def of_tracker() -> list[str]:
    """How far the track of a film is from the truth."""
    film, _, _, _, track, _ = shown()
    rows = []
    pixels = film.plane.pixels_per_metre(0.0, 0.3) * film.thrown.hoop.require_units().length_m
    for name, values in film.errors(track).items():
        seen = values[np.isfinite(values)]
        after = float(np.corrcoef(seen[:-1], seen[1:])[0, 1])
        label, unit = ("θ", "rad") if name == "theta" else (name, "R")
        scale = "" if name == "theta" else f"{pixels * float(np.sqrt(np.mean(seen**2))):.2g}"
        mean, root = float(np.mean(seen)), float(np.sqrt(np.mean(seen**2)))
        rows.append([f"{label}, {unit}", f"{mean:.1e}", f"{root:.1e}", scale, f"{after:.1f}"])
    heads = ["", "mean error", "root of the mean square", "the same in pixels", "correlation with the next picture"]
    return table(heads, rows)


def of_fits() -> list[str]:
    """How far fits of the shown film are off, with and without parts of the model of errors."""
    film, _, _, _, _, track = shown()
    whole = fitted(film, track)
    tried = {
        "all": whole,
        "errors independent": fitted(film, track, sigma=whole.sigma),
        "no constants of the camera": fitted(film, track, calibration=()),
    }
    rows = []
    for label, result in tried.items():
        row = [label]
        for name in FREE:
            estimate = result.estimates[name]
            off = (estimate.value - getattr(film.thrown.hoop, name)) / estimate.std_error
            row.append(f"{off:+.1f} ({estimate.std_error:.1e})" if estimate.identifiable else "not told")
        rows.append(row)
    return table(["", *NAMES.values()], rows)


def picture_found() -> Figure:
    """One picture of the film with the circle and the marker that were found, and all that was found."""
    film, picture, circle, marker, track, _ = shown()
    figure, (one,) = panels(1, width=7.2, height=4.2)
    one.grid(visible=False)
    one.imshow(picture[:, :, ::-1], interpolation="nearest")
    angles = np.linspace(0.0, math.tau, 300)
    around = circle.radius_m
    one.plot(
        *film.plane.to_pixels(circle.x_m + around * np.cos(angles), circle.y_m + around * np.sin(angles)),
        color="#ffb000",
        lw=1.4,
        dashes=(4, 2),
        label="circle that was found",
    )
    one.plot(
        *film.plane.to_pixels([marker.x_m], [marker.y_m]),
        "+",
        color="#ffb000",
        ms=12,
        mew=1.6,
        label="marker that was found",
    )
    radius = film.thrown.hoop.require_units().length_m
    assert track.x is not None and track.y is not None
    one.plot(
        *film.plane.to_pixels(track.x * radius, track.y * radius),
        ".",
        color=COLOURS[1],
        ms=2.5,
        label="centre in all pictures",
    )
    one.set(xlabel="u, pixels", ylabel="v, pixels")
    one.legend(fontsize=8, loc="upper left", framealpha=0.9)
    return figure


def residuals() -> Figure:
    """What the track has too much."""
    film, _, _, _, track, _ = shown()
    figure, axes = panels(3, width=3.6, height=3.0)
    seconds = track.time * film.thrown.hoop.require_units().time_s
    labels = {"theta": "error of θ, 10⁻³ rad", "x": "error of x, 10⁻³ R", "y": "error of y, 10⁻³ R"}
    for axis, (name, values) in zip(axes, film.errors(track).items(), strict=True):
        axis.axhline(0.0, color=INK, lw=0.8)
        axis.plot(seconds, 1e3 * values, ".", ms=3.5, color=COLOURS[0])
        for transition in film.thrown.motion.transitions:
            axis.axvline(transition.time * film.thrown.hoop.require_units().time_s, color=FAINT, lw=0.7, zorder=0)
        axis.set(xlabel="time t, s", ylabel=labels[name], xlim=(0.0, seconds[-1]))
    return figure


def calibration() -> Figure:
    """How often intervals contain the truth, against how often they say."""
    figure, (left, right) = panels(2, width=4.3, height=3.8)
    levels = np.linspace(0.02, 0.99, 98)
    styles = zip(NAMES.items(), COLOURS, DASHES, strict=False)
    for (key, label), colour, dash in styles:
        for axis, name in ((left, "coverage"), (right, "videos")):
            values = pulls(rows_of(name), key)
            parts = [100.0 * part_within(values, float(level)) for level in levels]
            axis.plot(100.0 * levels, parts, color=colour, dashes=dash, lw=1.4, label=label)
    for axis, name, title in ((left, "coverage", "independent noise"), (right, "videos", "through the video")):
        spread = 200.0 * np.sqrt(levels * (1.0 - levels) / len(rows_of(name)))
        axis.fill_between(
            100.0 * levels, 100.0 * levels - spread, 100.0 * levels + spread, color=FAINT, alpha=0.3, lw=0, label="±2σ"
        )
        axis.plot([0, 100], [0, 100], color=INK, lw=0.8)
        axis.set(xlim=(0, 100), ylim=(0, 100), xlabel="level of the interval, %", ylabel="contain the truth, %")
        axis.set_title(f"{axis.get_title(loc='left')}  {title}", loc="left", fontsize=10)
        axis.legend(frameon=False, fontsize=8, loc="upper left")
    return figure


def sequences(name: str) -> str:
    """In how many films the fit ends with the true sequence of phases."""
    rows = rows_of(name)
    return f"{sum(int(row['sequence_found']) for row in rows)} of {len(rows)}"


STUDY = Study(
    name="real-film",
    texts={
        "result": result,
        "tracker": of_tracker,
        "fits": of_fits,
        "coverage": lambda: coverage("coverage", NAMES),
        "repeated": repeated,
        "sequences": lambda: sequences("coverage"),
        "search": lambda: sequences("search"),
        "lost": lost,
        "videos": lambda: coverage("videos", NAMES | EXPOSURE),
        "short": lambda: by_exposure(False),
        "long": lambda: by_exposure(True),
        "astray": lambda: beyond("exposure_s", 6.0),
        "tails": lambda: beyond("restitution", 3.0),
        "sequences of videos": lambda: sequences("videos"),
    },
    pictures={"found": picture_found, "residuals": residuals, "calibration": calibration},
)
