"""The phase plane of rolling."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from ..closed_form import slip_angle
from ..style import (
    CURVE_COLOURS,
    CURVE_DASHES,
    CURVE_LETTERS,
    CURVE_WIDTHS,
    HATCH,
    INK,
    MODE_COLOURS,
    MODE_DASHES,
    PAPER,
    REGION,
)
from .canvas import axis_label, new_axes, phase_slices, pi_ticks, sign

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ..hoop import Hoop
    from ..trajectory import Trajectory


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
        axes = new_axes(6.4, 4.8)
    plane = hoop.phase_plane
    angles = np.linspace(*theta, 1201)
    rates = np.linspace(*theta_rate, 801)
    inside = plane.in_rolling_region(angles, rates[:, None])
    axes.contourf(angles, rates, inside, levels=[0.5, 1.5], colors=[REGION], zorder=0)
    without = plane.normal(angles, rates[:, None]) <= 0.0
    hatched = axes.contourf(angles, rates, without, levels=[0.5, 1.5], colors="none", hatches=["////"], zorder=0)
    hatched.set_edgecolor(HATCH)
    hatched.set_linewidth(0.0)
    with_slip = [("slip_limit", plane.slip_rate(angles, side)) for side in (-1, 1)]
    for name, curve in [("normal_force_zero", plane.normal_force_rate(angles)), *with_slip]:
        for side in (1.0, -1.0):
            axes.plot(angles, side * curve, **_line(name), zorder=2)
        _name_curve(axes, name, angles, curve, theta_rate[1])
    if hoop.inertia_about_mass_centre == 0.0:
        slip = float(slip_angle(hoop.mu_s, hoop.offset))
        for side in (-1.0, 1.0):
            axes.axvline(side * slip, **_line("slip_limit"), zorder=2)
        axes.annotate(
            CURVE_LETTERS["slip_limit"],
            (slip, theta_rate[1] * 0.9),
            xytext=(4, 0),
            textcoords="offset points",
            color=CURVE_COLOURS["slip_limit"],
        )
    # Orbits through evenly spaced points at rest, and over the top; each is a level of the energy.
    starts = [(angle, 0.0) for angle in np.linspace(0.0, math.pi, levels + 2)[1:-1]]
    starts += [(0.0, rate) for rate in np.linspace(0.0, theta_rate[1], levels // 2 + 2)[1:]]
    energies = sorted({float(plane.energy(angle, rate)) for angle, rate in starts})
    surface = plane.energy(angles, rates[:, None])
    level = _line("level")
    axes.contour(
        angles,
        rates,
        surface,
        levels=energies,
        colors=[level["color"]],
        linewidths=level["linewidth"],
        linestyles=[level["linestyle"]],
        zorder=1,
    )
    separatrix = plane.separatrix_rate(angles)
    for side in (1.0, -1.0):
        axes.plot(angles, side * separatrix, **_line("separatrix"), zorder=1)
    for equilibrium in plane.equilibria:
        filled = INK if equilibrium.stability == "stable" else PAPER
        for turn in (-2 * math.pi, 0.0, 2 * math.pi):
            place = equilibrium.theta + turn
            if theta[0] <= place <= theta[1]:
                axes.plot([place], [0.0], "o", mfc=filled, mec=INK, ms=6, zorder=5, clip_on=False)
    if motion is not None:
        _over_plane(axes, motion, theta)
    axes.set_xlim(*theta)
    axes.set_ylim(*theta_rate)
    axes.set_xlabel(sign("theta"))
    axes.set_ylabel(axis_label("theta_rate"))
    pi_ticks(axes)
    return axes


def _line(curve: str) -> dict[str, Any]:
    return {"color": CURVE_COLOURS[curve], "linewidth": CURVE_WIDTHS[curve], "linestyle": CURVE_DASHES[curve]}


def _name_curve(axes: Axes, name: str, angles: Any, curve: Any, top: float) -> None:
    # Where the curve is in sight, a good way up.
    edge = len(angles) // 8
    inner = (np.arange(len(angles)) >= edge) & (np.arange(len(angles)) < len(angles) - edge)
    seen = np.flatnonzero((curve < 0.92 * top) & (curve > 0.3 * top) & inner)
    if seen.size:
        at = seen[np.argmax(curve[seen])]
        axes.annotate(
            CURVE_LETTERS[name],
            (angles[at], curve[at]),
            xytext=(5, 3),
            textcoords="offset points",
            color=CURVE_COLOURS[name],
            style="italic",
            bbox={"boxstyle": "round,pad=0.1", "facecolor": PAPER, "edgecolor": "none", "alpha": 0.8},
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
    axes.plot([reduced_start], [start.theta_rate], "o", mfc=PAPER, mec=INK, ms=7, zorder=6)
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
