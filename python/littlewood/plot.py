"""Pictures in the style of the project: colours that the colour-blind tell apart, ticks at multiples of π, symbols.

Each function draws on axes of your own, or makes a figure. Nothing depends on a style sheet or a backend.
"""

from __future__ import annotations

import itertools
import math
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from .extras import require
from .motion import MODES, in_words
from .samples import COLUMNS, Samples
from .style import CLASS_COLOURS, INK, MODE_COLOURS, MODE_DASHES, PALE

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from .hoop import Hoop
    from .trajectory import Trajectory

__all__ = ["classes", "history", "outcomes", "path", "phase_plane", "pi_ticks", "trajectory"]

_LABELS = {
    "time": "τ  (√(R/g))",
    "theta": "θ",
    "theta_rate": "θ′  (√(g/R))",
    "slip": "η′  (√(gR))",
    "mass_ratio": "m₁/m₂",
    "offset": "ℓ/R",
    "inertia": "I/(m₂R²)",
    "mu_s": r"$\mu_s$",
    "mu_k": r"$\mu_k$",
    "x": "x  (R)",
    "y": "y  (R)",
}


def _new_axes(width: float, height: float) -> Axes:
    figure = require("matplotlib.figure").Figure(figsize=(width, height), layout="constrained")
    axes: Axes = figure.add_subplot()
    return axes


def _plain(axes: Axes) -> None:
    axes.spines[["top", "right"]].set_visible(False)
    axes.spines[["left", "bottom"]].set_color(INK)
    axes.tick_params(colors=INK)


def _pi(value: float) -> str:
    ratio = Fraction(value / math.pi).limit_denominator(24)
    sign = "−" if ratio < 0 else ""
    top, bottom = abs(ratio.numerator), ratio.denominator
    if top == 0:
        return "0"
    return f"{sign}{'' if top == 1 else top}π{'' if bottom == 1 else f'/{bottom}'}"


def pi_ticks(axes: Axes, which: Literal["x", "y"] = "x", most: int = 9) -> None:
    """Put the ticks of an angle at multiples of π.

    Parameters
    ----------
    axes : matplotlib.axes.Axes
        Axes with their limits set.
    which : {"x", "y"}
        Axis that shows the angle.
    most : int, optional
        Largest number of ticks.
    """
    ticker = require("matplotlib.ticker")
    low, high = sorted(axes.get_xlim() if which == "x" else axes.get_ylim())
    # Halves, thirds, quarters of π first; whole multiples where the angle turns often.
    steps = [math.pi / d for d in (12, 6, 4, 2, 1)] + [math.pi * 2**k for k in range(1, 30)]
    fitting = [step for step in steps if (high - low) / step <= most]
    if (high - low) < math.pi / 6 or not fitting:
        return
    axis = axes.xaxis if which == "x" else axes.yaxis
    axis.set_major_locator(ticker.MultipleLocator(fitting[0]))
    axis.set_major_formatter(ticker.FuncFormatter(lambda value, _: _pi(value)))


def phase_slices(samples: Samples) -> list[tuple[str, slice]]:
    """Return the parts of evenly spaced samples that lie in one phase, with their modes."""
    # A transition stands twice: the mode changes between the two, or a direction does.
    mode, direction = samples["mode"], samples["direction"]
    if not len(mode):
        return []
    cuts = np.flatnonzero((np.diff(mode) != 0) | (np.diff(direction) != 0)) + 1
    edges = [0, *cuts.tolist(), len(mode)]
    return [(MODES[mode[a]], slice(a, b)) for a, b in itertools.pairwise(edges) if mode[a] >= 0]


def _circle(axes: Axes, x: float, y: float, radius: float, **style: Any) -> None:
    axes.add_patch(require("matplotlib.patches").Circle((x, y), radius, **style))


def draw_hoop(axes: Axes, hoop: Hoop, x: float, y: float, theta: float, *, alpha: float = 1.0) -> list[Any]:
    """Draw a hoop with its particle and its mass centre; returns the artists."""
    patches, lines = require("matplotlib.patches"), require("matplotlib.lines")

    def along(distance: float) -> tuple[float, float]:
        return x - distance * math.sin(theta), y + distance * math.cos(theta)

    particle, centre = along(hoop.offset), along(hoop.h)
    style: dict[str, Any] = {"alpha": alpha, "zorder": 3}
    artists: list[Any] = [
        patches.Circle((x, y), 1.0, fill=False, edgecolor=PALE, linewidth=1.3, **style),
        lines.Line2D([x, particle[0]], [y, particle[1]], color=PALE, linewidth=1.0, **style),
        patches.Circle(particle, 0.085, facecolor=INK, edgecolor=INK, **style),
        patches.Circle(centre, 0.05, facecolor="white", edgecolor=INK, linewidth=1.0, **style),
    ]
    for artist in artists:
        axes.add_artist(artist)
    return artists


def path(motion: Trajectory, axes: Axes | None = None, *, count: int = 1001, hoops: bool = True) -> Axes:
    """Draw the paths of the mass centre (thick) and the geometric centre (thin), as in Figure 3(b).

    Parameters
    ----------
    motion : Trajectory
        The motion.
    axes : matplotlib.axes.Axes, optional
        Where to draw; a new figure by default.
    count : int, optional
        Number of instants.
    hoops : bool, optional
        Whether to draw the hoop at the start, at transitions and at the end.

    Returns
    -------
    matplotlib.axes.Axes
    """
    samples = motion.sample(count)
    x_low = float(np.min(samples.x)) - 1.2
    x_high = float(np.max(samples.x)) + 1.2
    y_high = float(np.max(samples.centre_y)) + 1.15
    if axes is None:
        width = 9.0
        axes = _new_axes(width, min(6.0, max(2.4, 1.1 + width * (y_high / (x_high - x_low) + 0.045))))
    axes.axhline(0.0, color=INK, linewidth=1.2, zorder=1)
    shown: set[str] = set()
    for mode, part in phase_slices(samples):
        style: dict[str, Any] = {"color": MODE_COLOURS[mode], "linestyle": MODE_DASHES[mode], "zorder": 4}
        label = None if mode in shown else mode
        axes.plot(samples.mass_centre_x[part], samples.mass_centre_y[part], linewidth=2.4, label=label, **style)
        axes.plot(samples.x[part], samples.centre_y[part], linewidth=1.1, **style)
        shown.add(mode)
    if hoops:
        _mark_hoops(motion, axes, samples, x_high - x_low)
    axes.set_xlim(x_low, x_high)
    # Room for two rows of labels.
    axes.set_ylim(-0.045 * (x_high - x_low) if hoops else -0.1, y_high)
    axes.set_aspect("equal")
    axes.set_xlabel(_LABELS["x"])
    axes.set_ylabel(_LABELS["y"])
    axes.set_yticks(range(math.ceil(y_high)))
    if shown:
        axes.legend(
            loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=4, frameon=False, handlelength=3.2, borderpad=0.2
        )
    _plain(axes)
    return axes


def _mark_hoops(motion: Trajectory, axes: Axes, samples: Samples, span: float) -> None:
    marks = [(motion.start.time, "start")]
    marks += [(transition.time, in_words(transition.cause)) for transition in motion.transitions]
    if not motion.transitions or motion.transitions[-1].to_mode is not None:
        marks.append((float(samples.time[-1]), ""))
    # Labels stand in two rows; a mark that finds no room in either is left out, unless it is the last.
    ends: list[list[tuple[float, float]]] = [[], []]
    for time, label in marks:
        at = int(np.argmin(np.abs(samples.time - time)))
        x, y = float(samples.x[at]), float(samples.centre_y[at])
        half = 0.5 * span * 0.0125 * (len(label) + 1)
        free = [all(x + half < a or x - half > b for a, b in row) for row in ends]
        if label and not any(free) and time != marks[-1][0]:
            continue
        draw_hoop(axes, motion.hoop, x, y, float(samples.theta[at]), alpha=0.75)
        if label and any(free):
            row = free.index(True)
            ends[row].append((x - half, x + half))
            axes.annotate(
                label,
                (x, 0.0),
                xytext=(0, -5 - 13 * row),
                textcoords="offset points",
                ha="center",
                va="top",
                fontsize=9,
                color=INK,
                annotation_clip=False,
            )


def history(
    motion: Trajectory,
    axes: Axes | None = None,
    *,
    quantities: tuple[str, ...] = ("theta_rate", "slip"),
    count: int = 1001,
) -> Axes:
    """Draw quantities over time, coloured by the mode of motion.

    Parameters
    ----------
    motion : Trajectory
        The motion.
    axes : matplotlib.axes.Axes, optional
        Where to draw; a new figure by default.
    quantities : tuple of str, optional
        Columns of :class:`littlewood.Samples`; each is labelled at its end.
    count : int, optional
        Number of instants.

    Returns
    -------
    matplotlib.axes.Axes
    """
    samples = motion.sample(count)
    if axes is None:
        axes = _new_axes(7.0, 3.2)
    for name in quantities:
        for mode, part in phase_slices(samples):
            values = np.where(np.isfinite(samples[name][part]), samples[name][part], np.nan)
            axes.plot(samples.time[part], values, color=MODE_COLOURS[mode], linestyle=MODE_DASHES[mode], linewidth=1.8)
    axes.margins(y=0.15)
    _limit(axes, [samples[name] for name in quantities])
    if len(quantities) > 1:
        _name_lines(axes, samples, quantities)
    else:
        axes.set_ylabel(_LABELS.get(quantities[0], COLUMNS[quantities[0]].symbol))
    for transition in motion.transitions:
        if transition.time <= samples.time[-1]:
            axes.axvline(transition.time, color=PALE, linewidth=0.6, zorder=0)
    axes.axhline(0.0, color=PALE, linewidth=0.6, zorder=0)
    axes.set_xlim(float(samples.time[0]), float(samples.time[-1]))
    axes.set_xlabel(_LABELS["time"])
    if quantities == ("theta",):
        pi_ticks(axes, "y", most=7)
    _plain(axes)
    return axes


def _limit(axes: Axes, lines: list[Any]) -> None:
    """Keep a rate that grows without bound (gliding) from flattening everything else."""
    values = np.concatenate([line[np.isfinite(line)] for line in lines])
    usual = float(np.quantile(np.abs(values), 0.95))
    if usual > 0.0 and float(np.max(np.abs(values))) > 4.0 * usual:
        low, high = max(float(np.min(values)), -1.5 * usual), min(float(np.max(values)), 1.5 * usual)
        axes.set_ylim(low - 0.05 * (high - low), high)


def _name_lines(axes: Axes, samples: Samples, quantities: tuple[str, ...]) -> None:
    """Write the symbol of each line where it is in sight and far from the others."""
    low, high = axes.get_ylim()
    table = np.array([samples[name] for name in quantities])
    table = np.where(np.isfinite(table) & (table >= low) & (table <= high), table, np.nan)
    middle = slice(len(samples.time) // 20, -(len(samples.time) // 20) or None)
    for k, name in enumerate(quantities):
        others = np.delete(table, k, axis=0)
        distance = np.min(np.abs(np.nan_to_num(others, nan=high) - table[k]), axis=0)[middle]
        if not np.any(np.isfinite(distance)):
            continue
        at = middle.start + int(np.nanargmax(distance))
        above = table[k, at] >= np.nanmean(np.nan_to_num(others[:, at]))
        axes.annotate(
            COLUMNS[name].symbol,
            (samples.time[at], table[k, at]),
            xytext=(7, 4 if above else -4),
            textcoords="offset points",
            va="bottom" if above else "top",
            color=INK,
            bbox={"boxstyle": "round,pad=0.1", "facecolor": "white", "edgecolor": "none", "alpha": 0.8},
        )


def trajectory(motion: Trajectory) -> Figure:
    """Draw the path of a motion, and θ, the rates and the forces over time.

    Parameters
    ----------
    motion : Trajectory
        The motion.

    Returns
    -------
    matplotlib.figure.Figure
    """
    figure: Figure = require("matplotlib.figure").Figure(figsize=(9.5, 7.0), layout="constrained")
    if not motion.phases:
        axes = figure.add_subplot()
        draw_hoop(axes, motion.hoop, motion.start.x, 1.0, motion.start.theta)
        axes.axhline(0.0, color=INK, linewidth=1.2)
        axes.set_xlim(motion.start.x - 2.0, motion.start.x + 2.0)
        axes.set_ylim(-0.3, 2.3)
        axes.set_aspect("equal")
        axes.set_title(f"no phase: {motion.outcome}")
        return figure
    grid = figure.add_gridspec(2, 3, height_ratios=(1.25, 1.0))
    path(motion, figure.add_subplot(grid[0, :]))
    angle = history(motion, figure.add_subplot(grid[1, 0]), quantities=("theta",))
    angle.set_title("angle θ", fontsize=10)
    angle.set_ylabel("")
    rates = history(motion, figure.add_subplot(grid[1, 1]))
    rates.set_title("rate θ′ (√(g/R)) and slip η′ (√(gR))", fontsize=10)
    forces = history(motion, figure.add_subplot(grid[1, 2]), quantities=("normal", "friction"))
    forces.set_title("normal force N and friction F (m₂g)", fontsize=10)
    return figure


def phase_plane(
    hoop: Hoop,
    axes: Axes | None = None,
    *,
    theta: tuple[float, float] = (-math.pi, math.pi),
    theta_rate: tuple[float, float] = (-4.0, 4.0),
    levels: int = 9,
    motion: Trajectory | None = None,
) -> Axes:
    """Draw the plane of Figures 2(b), 4 and 5: orbits of rolling, region R, the curves f and n.

    Parameters
    ----------
    hoop : Hoop
        The hoop.
    axes : matplotlib.axes.Axes, optional
        Where to draw; a new figure by default.
    theta, theta_rate : tuple of float, optional
        Limits of the axes, rad and √(g/R).
    levels : int, optional
        Number of orbits drawn.
    motion : Trajectory, optional
        A motion to draw over it; angles are reduced to the range of the axis.

    Returns
    -------
    matplotlib.axes.Axes
    """
    if axes is None:
        axes = _new_axes(6.4, 4.8)
    plane = hoop.phase_plane
    angles = np.linspace(*theta, 1201)
    rates = np.linspace(*theta_rate, 801)
    inside = plane.in_rolling_region(angles, rates[:, None])
    axes.contourf(angles, rates, inside, levels=[0.5, 1.5], colors=["#d3eaf5"], zorder=0)
    without = plane.normal(angles, rates[:, None]) <= 0.0
    axes.contourf(angles, rates, without, levels=[0.5, 1.5], colors="none", hatches=["////"], zorder=0)
    with_slip = [("f", plane.slip_rate(angles, sign), "dashed") for sign in (-1, 1)]
    for name, curve, dashes in [("n", plane.normal_force_rate(angles), "solid"), *with_slip]:
        for sign in (1.0, -1.0):
            axes.plot(angles, sign * curve, color=INK, linewidth=1.3, linestyle=dashes, zorder=2)
        _name_curve(axes, name, angles, curve, theta_rate[1])
    if hoop.inertia_about_mass_centre == 0.0:
        slip = plane_slip_angle(hoop)
        for sign in (-1.0, 1.0):
            axes.axvline(sign * slip, color=INK, linewidth=1.3, linestyle="dashed", zorder=2)
        axes.annotate("f", (slip, theta_rate[1] * 0.9), xytext=(4, 0), textcoords="offset points", color=INK)
    # Orbits through evenly spaced points at rest, and over the top; each is a level of the energy.
    starts = [(angle, 0.0) for angle in np.linspace(0.0, math.pi, levels + 2)[1:-1]]
    starts += [(0.0, rate) for rate in np.linspace(0.0, theta_rate[1], levels // 2 + 2)[1:]]
    energies = sorted({float(_rolling_energy(hoop, angle, rate)) for angle, rate in starts})
    surface = _rolling_energy(hoop, angles, rates[:, None])
    axes.contour(angles, rates, surface, levels=energies, colors=[PALE], linewidths=0.7, linestyles="solid", zorder=1)
    separatrix = plane.separatrix_rate(angles)
    for sign in (1.0, -1.0):
        axes.plot(angles, sign * separatrix, color="#555555", linewidth=1.6, zorder=1)
    for equilibrium in plane.equilibria:
        filled = INK if equilibrium.stability == "stable" else "white"
        for turn in (-2 * math.pi, 0.0, 2 * math.pi):
            place = equilibrium.theta + turn
            if theta[0] <= place <= theta[1]:
                axes.plot([place], [0.0], "o", mfc=filled, mec=INK, ms=6, zorder=5, clip_on=False)
    if motion is not None:
        _over_plane(axes, motion, theta)
    axes.set_xlim(*theta)
    axes.set_ylim(*theta_rate)
    axes.set_xlabel(_LABELS["theta"])
    axes.set_ylabel(_LABELS["theta_rate"])
    pi_ticks(axes)
    return axes


def plane_slip_angle(hoop: Hoop) -> float:
    """Return the angle at which a massless hoop slips (3.9), rad; NaN if it never does."""
    from .closed_form import slip_angle

    return float(slip_angle(hoop.mu_s, hoop.offset))


def _rolling_energy(hoop: Hoop, theta: Any, theta_rate: Any) -> Any:
    inertia, m, h = hoop.inertia_about_mass_centre, hoop.mass, hoop.h
    twice = inertia + m * (1.0 + h * h + 2.0 * h * np.cos(theta))
    return 0.5 * twice * theta_rate * theta_rate + hoop.offset * np.cos(theta)


def _name_curve(axes: Axes, name: str, angles: Any, curve: Any, top: float) -> None:
    # Where the curve is in sight, a good way up.
    edge = len(angles) // 8
    inner = (np.arange(len(angles)) >= edge) & (np.arange(len(angles)) < len(angles) - edge)
    seen = np.flatnonzero((curve < 0.92 * top) & (curve > 0.3 * top) & inner)
    if seen.size:
        at = seen[np.argmax(curve[seen])]
        axes.annotate(
            name,
            (angles[at], curve[at]),
            xytext=(5, 3),
            textcoords="offset points",
            color=INK,
            style="italic",
            bbox={"boxstyle": "round,pad=0.1", "facecolor": "white", "edgecolor": "none", "alpha": 0.8},
            zorder=6,
        )


def _over_plane(axes: Axes, motion: Trajectory, theta: tuple[float, float]) -> None:
    samples = motion.sample(2001)
    for mode, part in phase_slices(samples):
        angle = samples.theta[part]
        turns = np.floor((angle - theta[0]) / (2 * math.pi))
        reduced = angle - 2 * math.pi * turns
        rate = np.where(np.diff(turns, append=turns[-1]) != 0, np.nan, samples.theta_rate[part])
        axes.plot(
            reduced, rate, color=MODE_COLOURS[mode], linestyle=MODE_DASHES[mode], linewidth=2.6, label=mode, zorder=4
        )
    start = motion.start
    reduced_start = (start.theta - theta[0]) % (2 * math.pi) + theta[0]
    axes.plot([reduced_start], [start.theta_rate], "o", mfc="white", mec=INK, ms=7, zorder=6)
    handles, labels = axes.get_legend_handles_labels()
    unique = dict(zip(labels, handles, strict=True))
    axes.legend(
        unique.values(),
        unique.keys(),
        loc="lower center",
        bbox_to_anchor=(0.5, 1.0),
        ncols=4,
        frameon=False,
        handlelength=3.2,
    )


def classes(dataset: xarray.Dataset) -> xarray.DataArray:
    """Sort the motions of a sweep into the classes that maps show.

    Parameters
    ----------
    dataset : xarray.Dataset
        The result of :func:`littlewood.outcome_map` or :func:`littlewood.simulate_many`.

    Returns
    -------
    xarray.DataArray of uint8
        Places in the list of classes, which `flag_meanings` names: motions that leave the plane at once, that lift off
        later, and those that do not, by their outcome.
    """
    xr = require("xarray")
    names = list(CLASS_COLOURS)
    of_outcome = {
        1: "rolls for ever",
        2: "slides for ever",
        3: "particle at the plane",
        4: "particle at the bottom",
        5: "particle at the top",
        6: "in contact at the limit",
        7: "in contact at the limit",
        8: "Painlevé paradox",
        9: "Painlevé paradox",
        10: "Painlevé paradox",
        11: "unresolved",
    }
    table = np.full(256, names.index("not a hoop"), dtype=np.uint8)
    for code, name in of_outcome.items():
        table[code] = names.index(name)
    code = xr.apply_ufunc(
        lambda outcome: table[outcome], dataset["outcome"], dask="parallelized", output_dtypes=[np.uint8]
    )
    flies = ~np.isnan(dataset["lift_off_time"])
    at_once = (dataset["sequence"] & np.uint64(7)) == 7
    result = xr.where(at_once, np.uint8(0), xr.where(flies, np.uint8(1), code)).astype(np.uint8)
    result.attrs = {
        "long_name": "what becomes of the motion",
        "flag_values": list(range(len(names))),
        "flag_meanings": " ".join(name.replace(" ", "_") for name in names),
    }
    named: xarray.DataArray = result.rename("class")
    return named


def outcomes(dataset: xarray.Dataset, axes: Axes | None = None, *, x: str | None = None, y: str | None = None) -> Axes:
    """Draw a map of what becomes of the motions, with a legend and the share of each class.

    Parameters
    ----------
    dataset : xarray.Dataset
        A result of two dimensions.
    axes : matplotlib.axes.Axes, optional
        Where to draw; a new figure by default.
    x, y : str, optional
        Dimensions of the axes; the first and the second by default.

    Returns
    -------
    matplotlib.axes.Axes
    """
    colors, patches = require("matplotlib.colors"), require("matplotlib.patches")
    shown = classes(dataset)
    if shown.ndim != 2:
        raise ValueError(f"a map has two dimensions, not {shown.ndim}: {', '.join(map(str, shown.dims))}")
    first, second = (str(dimension) for dimension in shown.dims)
    x = x if x is not None else (second if y == first else first)
    y = y if y is not None else (second if x == first else first)
    shown = shown.transpose(y, x)
    if axes is None:
        axes = _new_axes(8.0, 4.8)
    names = list(CLASS_COLOURS)
    palette = colors.ListedColormap(list(CLASS_COLOURS.values()))
    values = shown.to_numpy()
    axes.pcolormesh(
        shown[x].to_numpy(),
        shown[y].to_numpy(),
        values,
        cmap=palette,
        vmin=-0.5,
        vmax=len(names) - 0.5,
        shading="nearest",
        rasterized=True,
    )
    counts = np.bincount(values.ravel(), minlength=len(names))
    handles = [
        patches.Patch(
            facecolor=CLASS_COLOURS[name],
            edgecolor=PALE,
            label=f"{name}\n{100 * counts[i] / values.size:.1f} %",
        )
        for i, name in enumerate(names)
        if counts[i]
    ]
    axes.legend(handles=handles, loc="upper left", bbox_to_anchor=(1.02, 1.0), frameon=False, labelspacing=0.9)
    axes.set_xlabel(_LABELS.get(x, x))
    axes.set_ylabel(_LABELS.get(y, y))
    if x == "theta":
        pi_ticks(axes)
    if y == "theta":
        pi_ticks(axes, "y")
    return axes
