"""A motion: its path in the plane, and its quantities over time."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from .._protocols import MotionLike
from ..samples import Samples
from ..style import BOLD, CURVE, FAINT, FINE, INK, LINE, MODE_COLOURS, MODE_DASHES, PAPER
from ..tables import CAUSE_LABELS
from .canvas import (
    axis_label,
    draw_hoop,
    draw_plane,
    key,
    level,
    on_sheet,
    phase_slices,
    pi_ticks,
    seen_heights,
    sheet,
    sign,
    words,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


@on_sheet
def path(motion: MotionLike, axes: Axes | None = None, *, count: int = 1001) -> Axes:
    """Draw the paths of the mass centre (thick) and the geometric centre (thin), as in Figure 3(b).

    A plane with a slope is tilted, and the axes are level.

    Parameters
    ----------
    motion : Trajectory
        The motion.
    axes : matplotlib.axes.Axes, optional
        Where to draw; a new figure by default.
    count : int, optional
        Number of instants.

    Returns
    -------
    matplotlib.axes.Axes
    """
    samples, slope = motion.sample(count), motion.hoop.slope
    centre = level(slope, samples.x, samples.centre_y)
    mass_centre = level(slope, samples.mass_centre_x, samples.mass_centre_y)
    x_low, x_high = float(np.min(centre[0])) - 1.2, float(np.max(centre[0])) + 1.2
    y_low, highest = seen_heights(samples, slope)
    y_high = highest + 1.15
    if axes is None:
        width = 9.0
        height = min(6.0, max(2.4, 1.1 + width * ((y_high - y_low) / (x_high - x_low) + 0.045)))
        axes = sheet(width, height).add_subplot()
    draw_plane(axes, slope)
    shown: set[str] = set()
    for mode, part in phase_slices(samples):
        style: dict[str, Any] = {
            "color": MODE_COLOURS[mode],
            "linestyle": MODE_DASHES[mode],
            "zorder": 4,
        }
        label = None if mode in shown else mode
        axes.plot(mass_centre[0][part], mass_centre[1][part], linewidth=BOLD, label=label, **style)
        axes.plot(centre[0][part], centre[1][part], linewidth=FINE, **style)
        shown.add(mode)
    _mark_hoops(motion, axes, samples, x_high - x_low)
    axes.set_xlim(x_low, x_high)
    # Room for two rows of labels, whether the width or the height of the axes decides the scale.
    room = max(0.045 * (x_high - x_low), 0.18 * (y_high - y_low))
    axes.set_ylim(y_low - room, y_high)
    axes.set_aspect("equal")
    if slope == 0.0:
        axes.set_xlabel(words(axes, axis_label("x")))
        axes.set_ylabel(words(axes, axis_label("centre_y")))
        axes.set_yticks(range(math.ceil(y_high)))
    else:
        unit = words(axes, axis_label("x").removeprefix(sign("x")))
        axes.set_xlabel(f"horizontal{unit}")
        axes.set_ylabel(f"height{unit}")
    if shown:
        key(axes, columns=4)
    return axes


def _mark_hoops(motion: MotionLike, axes: Axes, samples: Samples, span: float) -> None:
    # Bounces give way to what happens else.
    events = sorted(
        motion.transitions, key=lambda one: (one.cause, one.to_mode) == ("landing", "flight")
    )
    marks = [(motion.start.time, "start")]
    marks += [(one.time, CAUSE_LABELS[one.cause]) for one in events]
    last = motion.transitions[-1].time if motion.transitions else motion.start.time
    if not motion.transitions or motion.transitions[-1].to_mode is not None:
        last = float(samples.time[-1])
        marks.append((last, ""))
    # Labels stand in two rows; a mark that finds no room in either is left out, unless it is the
    # last.
    ends: list[list[tuple[float, float]]] = [[], []]
    slope = motion.hoop.slope
    # On a slope labels stand at the side where the plane rises.
    side = "center" if slope == 0.0 else "left" if slope > 0.0 else "right"
    for time, label in marks:
        at = int(np.argmin(np.abs(samples.time - time)))
        x, y = float(samples.x[at]), float(samples.centre_y[at])
        half = 0.5 * span * 0.0125 * (len(label) + 1)
        free = [all(x + half < a or x - half > b for a, b in row) for row in ends]
        if label and not any(free) and time != last:
            continue
        draw_hoop(axes, motion.hoop, x, y, float(samples.theta[at]), alpha=0.75)
        if label and any(free):
            row = free.index(True)
            ends[row].append((x - half, x + half))
            axes.annotate(
                label,
                level(slope, x, 0.0),
                xytext=({"center": 0, "left": 4, "right": -4}[side], -5 - 13 * row),
                textcoords="offset points",
                ha=side,
                va="top",
                color=INK,
                annotation_clip=False,
            )


@on_sheet
def history(
    motion: MotionLike,
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
        axes = sheet(7.0, 3.2).add_subplot()
    for name in quantities:
        for mode, part in phase_slices(samples):
            values = np.where(np.isfinite(samples[name][part]), samples[name][part], np.nan)
            axes.plot(
                samples.time[part],
                values,
                color=MODE_COLOURS[mode],
                linestyle=MODE_DASHES[mode],
                linewidth=CURVE,
            )
    axes.margins(y=0.15)
    _limit(axes, [samples[name] for name in quantities])
    _mark_beyond(axes, samples, quantities)
    if len(quantities) > 1:
        _name_lines(axes, samples, quantities)
    else:
        axes.set_ylabel(words(axes, axis_label(quantities[0])))
    for transition in motion.transitions:
        if transition.time <= samples.time[-1]:
            axes.axvline(transition.time, color=LINE, linewidth=FINE, zorder=0)
    axes.axhline(0.0, color=FAINT, linewidth=FINE, zorder=0)
    axes.set_xlim(float(samples.time[0]), float(samples.time[-1]))
    axes.set_xlabel(words(axes, axis_label("time")))
    if quantities == ("theta",):
        pi_ticks(axes, "y", most=7)
    return axes


def _limit(axes: Axes, lines: list[Any]) -> None:
    """Keep a rate that grows without bound (gliding) from flattening everything else."""
    values = np.concatenate([line[np.isfinite(line)] for line in lines])
    usual = float(np.quantile(np.abs(values), 0.95))
    if usual > 0.0 and float(np.max(np.abs(values))) > 4.0 * usual:
        low, high = (
            max(float(np.min(values)), -1.5 * usual),
            min(float(np.max(values)), 1.5 * usual),
        )
        axes.set_ylim(low - 0.05 * (high - low), high)


def _mark_beyond(axes: Axes, samples: Samples, quantities: tuple[str, ...]) -> None:
    """Mark each part of a line that is cut, above and below, and write the farthest value.

    A figure of the program does the same.
    """
    low, high = axes.get_ylim()
    for sign_of_side, edge, marker in ((1.0, high, 6), (-1.0, low, 7)):
        farthest: tuple[float, float, str] | None = None
        for name in quantities:
            for mode, part in phase_slices(samples):
                times, values = samples.time[part], sign_of_side * samples[name][part]
                (out,) = np.nonzero(values > sign_of_side * edge)
                for run in np.split(out, np.nonzero(np.diff(out) > 1)[0] + 1):
                    if len(run) == 0:
                        continue
                    at = int(run[np.argmax(values[run])])
                    # The tip of the triangle is at the frame.
                    axes.plot(
                        [times[at]],
                        [edge],
                        color=MODE_COLOURS[mode],
                        marker=marker,
                        linestyle="none",
                        linewidth=0.0,
                    )
                    if farthest is None or values[at] > farthest[0]:
                        farthest = float(values[at]), float(times[at]), MODE_COLOURS[mode]
        if farthest is None:
            continue
        size, time, colour = farthest
        number = "∞" if math.isinf(size) else f"{size:.4g}"
        # Above the frame no line is in the way; below it are the numbers of the other axis.
        axes.annotate(
            number if sign_of_side > 0.0 else f"−{number}",
            (time, edge),
            xytext=(0, 2) if sign_of_side > 0.0 else (6, 3),
            textcoords="offset points",
            ha="center" if sign_of_side > 0.0 else "left",
            va="bottom",
            color=colour,
            annotation_clip=False,
        )
    axes.set_ylim(low, high)


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
            words(axes, sign(name)),
            (samples.time[at], table[k, at]),
            xytext=(7, 4 if above else -4),
            textcoords="offset points",
            va="bottom" if above else "top",
            color=INK,
            bbox={
                "boxstyle": "round,pad=0.1",
                "facecolor": PAPER,
                "edgecolor": "none",
                "alpha": 0.8,
            },
        )


@on_sheet
def trajectory(motion: MotionLike) -> Figure:
    """Draw the path of a motion, and θ, the rates and the forces over time.

    Parameters
    ----------
    motion : Trajectory
        The motion.

    Returns
    -------
    matplotlib.figure.Figure
    """
    figure = sheet(9.0, 6.6)
    if not motion.phases:
        axes = figure.add_subplot()
        draw_hoop(axes, motion.hoop, motion.start.x, 1.0, motion.start.theta)
        draw_plane(axes, motion.hoop.slope)
        x, y = level(motion.hoop.slope, motion.start.x, 1.0)
        axes.set_xlim(x - 2.0, x + 2.0)
        axes.set_ylim(y - 1.3, y + 1.3)
        axes.set_aspect("equal")
        axes.set_title(f"no phase: {motion.outcome.label}")
        return figure
    grid = figure.add_gridspec(2, 3, height_ratios=(1.25, 1.0))
    path(motion, figure.add_subplot(grid[0, :]))
    bounces = any(one.impact is not None for one in motion.transitions)
    # Where a hoop only bounces there is no force that lasts.
    in_air = bounces and all(phase.mode == "flight" for phase in motion.phases)
    panels = (("theta",), ("theta_rate", "slip"), ("gap",) if in_air else ("normal", "friction"))
    for place, quantities in enumerate(panels):
        axes = history(motion, figure.add_subplot(grid[1, place]), quantities=quantities)
        axes.set_ylabel(words(axes, ",  ".join(axis_label(name) for name in quantities)))
    return figure
