"""A motion: its path in the plane, and its quantities over time."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .._protocols import MotionLike
from ..samples import Samples
from ..style import BOLD, CURVE, FAINT, FINE, INK, LINE, MODE_COLOURS, MODE_DASHES
from ..tables import MODES
from .canvas import (
    axis_label,
    core_ticks,
    draw_plane,
    key,
    level,
    on_sheet,
    phase_slices,
    scaled,
    sheet,
    sign,
    words,
)
from .ground import Ground, mark_events

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_BELOW, _ABOVE = 44.0, 10.0
"""Pixels of the numbers of an axis with its name, and of the air above it."""

_ROW, _ENTRY, _LETTER = 17.0, 40.0, 6.6
"""Pixels of a row of a key, of an entry without its words, and of a letter on average."""

_WIDTHS = (CURVE, FINE, BOLD)
"""Widths of the lines of a panel, by which its quantities are told apart."""

_NOISE = 1e-11
"""What differs by less of its size is equal: forces are differences of larger numbers."""


@on_sheet
def path(motion: MotionLike, axes: Axes | None = None, *, count: int = 1001) -> Axes:
    """Draw the paths of the mass centre (thick) and the geometric centre (thin), as in Figure 3(b).

    A plane with a slope is tilted, and the axes are level. Where one scale for both axes would
    leave nothing to see there are two, which the picture says, and no hoops.

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
    from .sheet import inches, wide

    samples = motion.sample(count)
    ground = Ground(motion, samples)
    if axes is None:
        entries = path_key(motion, samples)
        above = rows_of(entries, wide() - _LEFT - 12.0) * _ROW + _ABOVE
        height = ground.height(wide() - _LEFT - 12.0)
        whole = above + height + _BELOW
        figure = sheet(inches(wide()), inches(whole))
        figure.set_layout_engine("none")
        axes = figure.add_axes(
            (_LEFT / wide(), _BELOW / whole, 1.0 - (_LEFT + 12.0) / wide(), height / whole)
        )
    draw_path(motion, samples, ground, axes)
    return axes


_LEFT = 58.0
"""Pixels to the left of the axes of a path."""


def draw_path(motion: MotionLike, samples: Samples, ground: Ground, axes: Axes) -> None:
    """Draw the path, its key and its events on axes whose place is known."""
    slope = motion.hoop.slope
    centre = level(slope, samples.x, samples.centre_y)
    mass_centre = level(slope, samples.mass_centre_x, samples.mass_centre_y)
    view = ground.view(axes)
    axes.set_xlim(view.left, view.right)
    axes.set_ylim(view.bottom, view.top)
    if view.is_round:
        axes.set_aspect("equal", anchor="W")
    draw_plane(axes, slope, scaled(CURVE))
    for mode, part in phase_slices(samples):
        style: dict[str, Any] = {
            "color": MODE_COLOURS[mode],
            "linestyle": MODE_DASHES[mode],
            "zorder": 4,
        }
        bold, fine = scaled(BOLD), scaled(FINE)
        axes.plot(mass_centre[0][part], mass_centre[1][part], linewidth=bold, **style)
        axes.plot(centre[0][part], centre[1][part], linewidth=fine, **style)
    notes = [mark_events(motion, samples, axes, view)]
    if not view.is_round:
        notes.insert(0, f"height × {view.stretch:.2g}")
    unit = words(axes, axis_label("x").removeprefix(sign("x")))
    name = words(axes, axis_label("x")) if slope == 0.0 else f"horizontal{unit}"
    axes.set_xlabel(";  ".join([name, *filter(None, notes)]))
    axes.set_ylabel(words(axes, axis_label("centre_y")) if slope == 0.0 else f"height{unit}")
    core_ticks(axes, "x")
    # Nothing is below a level plane but names.
    core_ticks(axes, "y", least=0.0 if slope == 0.0 else -np.inf)
    entries = path_key(motion, samples)
    if entries:
        width = axes.get_window_extent().width * 72.0 / axes.figure.dpi / scaled(0.75)
        key(axes, columns=columns_of(entries, width), handles=_handles(entries), borderaxespad=0.3)


def path_key(motion: MotionLike, samples: Samples) -> list[tuple[str, dict[str, Any]]]:
    """Return the entries of the key of a path: what can be seen, with its look."""
    far = np.hypot(np.diff(samples.mass_centre_x), np.diff(samples.mass_centre_y))
    across = float(np.ptp(samples.x)) + 2.0
    gone = {
        mode: sum(
            float(np.sum(far[part.start : part.stop - 1]))
            for one, part in phase_slices(samples)
            if one == mode
        )
        for mode in MODES
    }
    entries: list[tuple[str, dict[str, Any]]] = [
        (mode, {"color": MODE_COLOURS[mode], "linestyle": MODE_DASHES[mode], "linewidth": BOLD})
        for mode in MODES
        # About a pixel.
        if gone[mode] > across / 600.0
    ]
    if entries and motion.hoop.h > 0.0:
        entries += [
            ("mass centre", {"color": INK, "linewidth": BOLD}),
            ("centre *C*", {"color": INK, "linewidth": FINE}),
        ]
    return entries


def columns_of(entries: list[tuple[str, dict[str, Any]]], width: float) -> int:
    """Return how many columns of a key have room in so many pixels."""
    widest = max((len(label) for label, _ in entries), default=1)
    return max(1, min(len(entries), int(width / (_ENTRY + _LETTER * widest))))


def rows_of(entries: list[tuple[str, dict[str, Any]]], width: float) -> int:
    """Return the rows of such a key."""
    return -(-len(entries) // columns_of(entries, width)) if entries else 0


def _handles(entries: list[tuple[str, dict[str, Any]]]) -> list[Any]:
    from matplotlib.lines import Line2D

    return [
        Line2D([], [], label=label, **look | {"linewidth": scaled(look["linewidth"])})
        for label, look in entries
    ]


@on_sheet
def history(
    motion: MotionLike,
    axes: Axes | None = None,
    *,
    quantities: tuple[str, ...] = ("theta_rate", "slip"),
    count: int = 1001,
) -> Axes:
    """Draw quantities over time, coloured by the mode of motion.

    What grows without bound is cut at the frame, with a mark, and its range stands above.

    Parameters
    ----------
    motion : Trajectory
        The motion.
    axes : matplotlib.axes.Axes, optional
        Where to draw; a new figure by default.
    quantities : tuple of str, optional
        Columns of :class:`littlewood.Samples`. Several have lines of several widths, and a key.
    count : int, optional
        Number of instants.

    Returns
    -------
    matplotlib.axes.Axes
    """
    samples = motion.sample(count)
    if axes is None:
        from .sheet import inches

        axes = sheet(inches(672.0), inches(307.0)).add_subplot()
    draw_history(motion, samples, axes, quantities)
    axes.set_xlabel(words(axes, axis_label("time")))
    return axes


def draw_history(
    motion: MotionLike, samples: Samples, axes: Axes, quantities: tuple[str, ...]
) -> None:
    """Draw quantities over time, without the name of the time."""
    columns = int(axes.get_window_extent().width * 72.0 / axes.figure.dpi / _COLUMN)
    shaded = [name for name in quantities if turns(samples[name]) > columns]
    low, high = limits([samples[name] for name in quantities], is_whole=bool(shaded))
    axes.set_ylim(low, high)
    begin, end = float(samples.time[0]), float(samples.time[-1])
    axes.set_xlim(begin, end if end > begin else begin + 1.0)
    looks: dict[str, dict[str, Any]] = {
        name: {"linewidth": scaled(_WIDTHS[k % len(_WIDTHS)])} for k, name in enumerate(quantities)
    }
    for name, look in looks.items():
        if name in shaded:
            _shade(axes, samples, name, columns)
            continue
        for mode, part in phase_slices(samples):
            values = np.where(np.isfinite(samples[name][part]), samples[name][part], np.nan)
            axes.plot(
                samples.time[part],
                values,
                color=MODE_COLOURS[mode],
                linestyle=MODE_DASHES[mode],
                **look,
            )
    notes = ["shaded from least to greatest"] if shaded else []
    notes += _mark_beyond(axes, samples, quantities)
    if notes:
        axes.annotate(
            ";  ".join(notes),
            (1.0, 1.0),
            xycoords="axes fraction",
            xytext=(0.0, scaled(2.0)),
            textcoords="offset points",
            ha="right",
            va="bottom",
            color=INK,
        )
    if len(quantities) > 1:
        from matplotlib.lines import Line2D

        lines = [
            Line2D([], [], color=INK, label=words(axes, axis_label(name)), **look)
            for name, look in looks.items()
        ]
        # Above the notes.
        key(axes, columns=len(lines), handles=lines, borderaxespad=1.4 if notes else 0.4)
    else:
        axes.set_ylabel(words(axes, axis_label(quantities[0])))
    _mark_times(axes, [one.time for one in motion.transitions])
    if low < 0.0 < high:
        axes.axhline(0.0, color=FAINT, linewidth=scaled(FINE), zorder=0)
    core_ticks(axes, "x")
    core_ticks(axes, "y", "angular" if quantities == ("theta",) else "round")


_COLUMN = 1.0
"""Points of a column of what is shaded, because a line would turn more than once in one."""


def turns(values: Any) -> int:
    """Return how often a quantity turns."""
    values = values[np.isfinite(values)]
    steps = np.diff(values)
    steps = steps[np.abs(steps) > _NOISE * np.max(np.abs(values), initial=0.0)]
    return int(np.count_nonzero(steps[1:] * steps[:-1] < 0.0))


def _shade(axes: Axes, samples: Samples, name: str, columns: int) -> None:
    """Fill from the least to the greatest value of each column, of each mode in its colour.

    Lines that are closer to each other than they are wide would show patterns that are not there.
    """
    begin, end = axes.get_xlim()
    edges = np.linspace(begin, end, columns + 1)
    place = np.clip(np.searchsorted(edges, samples.time, side="right") - 1, 0, columns - 1)
    values = samples[name]
    for code, mode in enumerate(MODES):
        low, high = np.full(columns, np.inf), np.full(columns, -np.inf)
        (own,) = np.nonzero((samples["mode"] == code) & np.isfinite(values))
        np.minimum.at(low, place[own], values[own])
        np.maximum.at(high, place[own], values[own])
        is_there = low <= high
        axes.bar(
            edges[:-1][is_there],
            (high - low)[is_there],
            edges[1] - edges[0],
            low[is_there],
            align="edge",
            color=MODE_COLOURS[mode],
            alpha=0.5,
            linewidth=0.0,
        )
    axes.set_xlim(begin, end)


_MOST_TIMES = 40
"""Lines at transitions in a panel at most: more are a grey wall."""


def _mark_times(axes: Axes, times: list[float]) -> None:
    """Draw a line at each transition, of those that no eye tells apart one, if they are few."""
    begin, end = axes.get_xlim()
    width = axes.get_window_extent().width * 72.0 / axes.figure.dpi
    marked = [begin]
    for time in times:
        if time <= end and (time - marked[-1]) / (end - begin) * width > 3.0:
            marked.append(time)
    for time in marked[1:] if len(marked) <= _MOST_TIMES else []:
        axes.axvline(time, color=LINE, linewidth=scaled(FINE), zorder=0)


def limits(lines: list[Any], *, is_whole: bool = False) -> tuple[float, float]:
    """Return the limits of an axis with some air around its lines.

    A constant is in the middle. A rate that grows without bound (gliding) or a force that is large
    for a moment is cut, where it would flatten everything else, unless the whole is wanted.
    """
    values = np.concatenate([line[np.isfinite(line)] for line in lines])
    if not len(values):
        return -1.0, 1.0
    low, high = float(np.min(values)), float(np.max(values))
    most = max(abs(low), abs(high))
    if high - low <= _NOISE * most or most == 0.0:
        air = 0.1 * most or 0.5
        return low - air, high + air
    usual = float(np.quantile(np.abs(values), 0.95))
    if usual > 0.0 and most > 4.0 * usual and not is_whole:
        # Air only where nothing is cut.
        down, up = max(low, -1.5 * usual), min(high, 1.5 * usual)
        air = 0.08 * (up - down)
        return down - air * (down == low), up + air * (up == high)
    air = 0.08 * (high - low)
    return low - air, high + air


def _mark_beyond(axes: Axes, samples: Samples, quantities: tuple[str, ...]) -> list[str]:
    """Mark each part of a line that is cut, and return how far it goes, in words.

    A figure of the program marks the same.
    """
    low, high = axes.get_ylim()
    ends = []
    for side, edge, marker in ((-1.0, low, 7), (1.0, high, 6)):
        farthest = -np.inf
        for name in quantities:
            for mode, part in phase_slices(samples):
                times, values = samples.time[part], side * samples[name][part]
                (out,) = np.nonzero(values > side * edge)
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
                    farthest = max(farthest, float(values[at]))
        if farthest > -np.inf:
            ends.append(f"{_SIDES[side]} {number(side * farthest)}")
    axes.set_ylim(low, high)
    return [f"goes {' '.join(ends)}"] if ends else []


_SIDES = {-1.0: "down to", 1.0: "up to"}


def number(value: float) -> str:
    """Return a number of four digits for print."""
    if np.isinf(value):
        return "∞" if value > 0.0 else "−∞"
    text = f"{value:.4g}"
    if "e" in text:
        digits, exponent = text.split("e")
        text = f"{digits}·10^{{{int(exponent)}}}"
    return text.replace("-", "−")


def is_noise(samples: Samples, name: str) -> bool:
    """Tell whether a force is nothing but rounding of larger ones."""
    if name not in ("normal", "friction"):
        return False
    most = max(float(np.max(np.abs(samples[one]))) for one in ("normal", "friction"))
    return float(np.max(np.abs(samples[name]))) <= _NOISE * most
