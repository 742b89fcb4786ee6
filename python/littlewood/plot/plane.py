"""The phase plane of rolling."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Protocol

import numpy as np

from .._protocols import MotionLike
from ..phase_plane import PhasePlane
from ..style import (
    BOLD,
    CURVE_COLOURS,
    CURVE_LETTERS,
    HATCH,
    INK,
    MODE_COLOURS,
    MODE_DASHES,
    PAPER,
    REGION,
)
from .canvas import (
    START,
    axis_label,
    key,
    of_curve,
    on_sheet,
    phase_slices,
    pi_ticks,
    sheet,
    sign,
    words,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class _HasPhasePlane(Protocol):
    @property
    def phase_plane(self) -> PhasePlane: ...


@on_sheet
def phase_plane(
    hoop: _HasPhasePlane,
    axes: Axes | None = None,
    *,
    theta: tuple[float, float] = (-math.pi, math.pi),
    theta_rate: tuple[float, float] = (-4.0, 4.0),
    levels: int = 9,
    motion: MotionLike | None = None,
) -> Axes:
    """Draw the plane of Figures 2(b), 4 and 5: orbits of rolling, region R, the curves f and n.

    With rolling resistance an orbit loses energy, to the right above θ′ = 0 and to the left below,
    and the thick line is the band of rest; f, n and R are those of each way.

    Parameters
    ----------
    hoop : Hoop
        The hoop.
    axes : matplotlib.axes.Axes, optional
        Where to draw; a new figure by default.
    theta, theta_rate : tuple of float, optional
        Limits of the axes, rad and √(g/R).
    levels : int, optional
        Number of orbits from rest in half a turn; half as many pass the top.
    motion : Trajectory, optional
        A motion to draw over it; angles are reduced to the range of the axis.

    Returns
    -------
    matplotlib.axes.Axes
    """
    if axes is None:
        axes = sheet(6.4, 4.8).add_subplot()
    from matplotlib.collections import LineCollection, PolyCollection

    plane = hoop.phase_plane
    most = max(map(abs, theta_rate))
    # Region R is traced in a window that reaches as far down as up.
    window = (theta, (-most, most))
    core = plane._core
    axes.add_collection(
        PolyCollection(core.rolling_region(*window), facecolors=REGION, edgecolors="none", zorder=0)
    )
    limit = core.curve("normal_force_zero", *window)
    for piece in limit["pieces"] if limit else ():
        angles, rates = zip(*piece, strict=True)
        edge = math.copysign(most, rates[0])
        axes.fill_between(
            angles,
            rates,
            edge,
            facecolor="none",
            edgecolor=HATCH,
            hatch="////",
            linewidth=0.0,
            zorder=0,
        )
    for name, order in (
        ("lift_off", 2),
        ("normal_force_zero", 2),
        ("slip_limit", 2),
        ("separatrix", 1),
        ("band_of_rest", 3),
    ):
        curve = core.curve(name, *window)
        if curve is None:
            continue
        axes.add_collection(LineCollection(curve["pieces"], **of_curve(name), zorder=order))
        letter = curve["place_of_letter"]
        if letter is not None:
            axes.text(
                letter[0],
                letter[1],
                words(axes, CURVE_LETTERS[name]),
                color=CURVE_COLOURS[name],
                size="large",
                horizontalalignment="center",
                verticalalignment="center",
                bbox={
                    "boxstyle": "round,pad=0.1",
                    "facecolor": PAPER,
                    "edgecolor": "none",
                    "alpha": 0.8,
                },
                clip_on=True,
                zorder=6,
            )
    orbits = core.orbits(*window, levels, levels // 2 + 1)
    axes.add_collection(LineCollection(orbits, **of_curve("level"), zorder=1))
    for equilibrium in plane.equilibria:
        filled = INK if equilibrium.stability == "stable" else PAPER
        for turn in (-2 * math.pi, 0.0, 2 * math.pi):
            place = equilibrium.theta + turn
            if theta[0] <= place <= theta[1]:
                axes.plot([place], [0.0], "o", mfc=filled, mec=INK, ms=5.1, zorder=5, clip_on=False)
    if motion is not None:
        _over_plane(axes, motion, theta)
    axes.set_xlim(*theta)
    axes.set_ylim(*theta_rate)
    axes.set_xlabel(words(axes, sign("theta")))
    axes.set_ylabel(words(axes, axis_label("theta_rate")))
    pi_ticks(axes)
    return axes


def _over_plane(axes: Axes, motion: MotionLike, theta: tuple[float, float]) -> None:
    samples = motion.sample(2001)
    for mode, part in phase_slices(samples):
        angle = samples.theta[part]
        turns = np.floor((angle - theta[0]) / (2 * math.pi))
        reduced = angle - 2 * math.pi * turns
        rate = np.where(np.diff(turns, append=turns[-1]) != 0, np.nan, samples.theta_rate[part])
        axes.plot(
            reduced,
            rate,
            color=MODE_COLOURS[mode],
            linestyle=MODE_DASHES[mode],
            linewidth=BOLD,
            label=mode,
            zorder=4,
        )
    start = motion.start
    reduced_start = (start.theta - theta[0]) % (2 * math.pi) + theta[0]
    axes.plot([reduced_start], [start.theta_rate], label="start", zorder=6, **START)
    key(axes, columns=5)
