"""What pictures are made of: axes, ticks at multiples of π, labels, the hoop itself."""

from __future__ import annotations

import itertools
import math
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from .. import _core
from ..extras import require
from ..samples import Samples
from ..style import FAINT, INK, PAPER
from ..tables import FRICTION, MODES, QUANTITIES, SAMPLE_COLUMNS

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ..hoop import Hoop


def sign(name: str) -> str:
    """Return the symbol of a quantity or a column of samples; a name that is neither stands for itself."""
    if name in SAMPLE_COLUMNS:
        return SAMPLE_COLUMNS[name].sign
    if name == FRICTION:
        return _core.FRICTION[1]
    return QUANTITIES[name].sign if name in QUANTITIES else name


def axis_label(name: str) -> str:
    """Return the symbol with its unit, if it has one."""
    if name in QUANTITIES:
        unit = QUANTITIES[name].unit_sign
    elif name in SAMPLE_COLUMNS:
        unit = SAMPLE_COLUMNS[name].unit_sign or ""
    else:
        unit = ""
    return f"{sign(name)}  ({unit})" if unit else sign(name)


def new_axes(width: float, height: float) -> Axes:
    """Return axes in a figure of their own, which no state machine keeps."""
    figure = require("matplotlib.figure").Figure(figsize=(width, height), layout="constrained")
    axes: Axes = figure.add_subplot()
    return axes


def plain(axes: Axes) -> None:
    """Take away what frames the picture and shows nothing."""
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
    mode, time = samples["mode"], samples["time"]
    if not len(mode):
        return []
    # A transition stands twice, and nothing else does.
    cuts = np.flatnonzero((np.diff(time) == 0.0) | (np.diff(mode) != 0)) + 1
    edges = [0, *cuts.tolist(), len(mode)]
    return [(MODES[mode[a]], slice(a, b)) for a, b in itertools.pairwise(edges) if mode[a] != _core.OUTSIDE]


def level(slope: float, x: Any, y: Any) -> tuple[Any, Any]:
    """Return coordinates along a plane and from it as a level camera sees them: to the right, and upwards."""
    sin, cos = math.sin(slope), math.cos(slope)
    return x * cos - y * sin, x * sin + y * cos


def draw_plane(axes: Axes, slope: float, width: float = 1.2) -> None:
    """Draw the plane as a level camera sees it."""
    if slope == 0.0:
        axes.axhline(0.0, color=INK, linewidth=width, zorder=1)
    else:
        axes.axline((0.0, 0.0), slope=math.tan(slope), color=INK, linewidth=width, zorder=1)


def seen_heights(samples: Samples, slope: float) -> tuple[float, float]:
    """Return the lowest height of plane and hoops, 0 on a level plane, and the highest of the centre."""
    _, heights = level(slope, samples.x, samples.centre_y)
    _, feet = level(slope, samples.x, np.zeros_like(samples.x))
    low = 0.0 if slope == 0.0 else float(min(np.min(feet), np.min(heights) - 1.0))
    return low, float(np.max(heights))


def draw_hoop(axes: Axes, hoop: Hoop, x: float, y: float, theta: float, *, alpha: float = 1.0) -> list[Any]:
    """Draw a hoop with its particle and its mass centre on its plane as a level camera sees it; returns the artists."""
    patches, lines = require("matplotlib.patches"), require("matplotlib.lines")
    x, y = level(hoop.slope, x, y)
    theta += hoop.slope

    def along(distance: float) -> tuple[float, float]:
        return x - distance * math.sin(theta), y + distance * math.cos(theta)

    particle, centre = along(hoop.offset), along(hoop.h)
    style: dict[str, Any] = {"alpha": alpha, "zorder": 3}
    artists: list[Any] = [
        patches.Circle((x, y), 1.0, fill=False, edgecolor=FAINT, linewidth=1.3, **style),
        lines.Line2D([x, particle[0]], [y, particle[1]], color=FAINT, linewidth=1.0, **style),
        patches.Circle(particle, 0.085, facecolor=INK, edgecolor=INK, **style),
        patches.Circle(centre, 0.05, facecolor=PAPER, edgecolor=INK, linewidth=1.0, **style),
    ]
    for artist in artists:
        axes.add_artist(artist)
    return artists
