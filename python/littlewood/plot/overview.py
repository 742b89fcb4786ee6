"""A motion on a sheet: its path, and below it what changes over time."""

from __future__ import annotations

import itertools
import textwrap
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import _core
from .._protocols import MotionLike
from ..samples import Samples
from .canvas import axis_label, checked_width, draw_hoop, draw_plane, level, look, sheet, sign
from .course import draw_history, draw_path, is_noise, limits, number, path_key, rows_of, turns
from .ground import Ground

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_INSTANTS, _MANY_INSTANTS = 1001, 16_001
"""Instants of a motion, and of one that turns so often that fewer tell nothing between."""

_RIGHT, _AIR, _NAME, _TICKS, _LETTER, _ROW = 14.0, 10.0, 24.0, 20.0, 6.6, 17.0
"""Pixels to the right of axes, above a key, of the name and the numbers of an axis, of a letter on
average, and of a row of words."""

_GAP = 8.0
"""Pixels between the path and the panels, and below them."""

_PANEL, _LOW_PANEL = 150.0, 84.0
"""Pixels of the height of panels, and of those that stand under each other."""

_CHANGING = ("theta", "theta_rate", "slip", "normal", "friction", "gap")


def trajectory(motion: MotionLike, *, width_mm: float | None = None) -> Figure:
    """Draw the path of a motion, and what changes over time: angle, rates, forces, gap.

    What does not change is said in a line below.

    Parameters
    ----------
    motion : Trajectory
        The motion.
    width_mm : float, optional
        Width in print, where the letters of ticks have 7 points; by default the figure is for a
        screen.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    PictureError
        For a width that no print has.
    """
    with look(checked_width(width_mm)):
        if not motion.phases:
            return _instant(motion, f"no phase: {motion.outcome.label}")
        samples = motion.sample(_INSTANTS)
        if samples.time[-1] <= samples.time[0]:
            return _instant(motion, f"ends at once: {motion.outcome.label}")
        if max(turns(samples[name]) for name in _CHANGING) > _INSTANTS / 8:
            samples = motion.sample(_MANY_INSTANTS)
        return _drawn(motion, samples)


def _instant(motion: MotionLike, title: str) -> Figure:
    """Draw a hoop that does not move."""
    from .sheet import inches, wide

    figure = sheet(inches(wide()), inches(min(0.6 * wide(), 360.0)))
    axes = figure.add_subplot()
    draw_hoop(axes, motion.hoop, motion.start.x, 1.0, motion.start.theta)
    draw_plane(axes, motion.hoop.slope)
    x, y = level(motion.hoop.slope, motion.start.x, 1.0)
    axes.set_xlim(x - 3.0, x + 3.0)
    axes.set_ylim(y - 1.3, y + 1.3)
    axes.set_aspect("equal")
    axes.set_title("\n".join(textwrap.wrap(title, int(wide() / _LETTER))))
    return figure


def _drawn(motion: MotionLike, samples: Samples) -> Figure:
    from .sheet import inches, wide

    shown, said = _what_changes(motion, samples)
    rows = _rows_of_panels(shown, wide())
    is_narrow = all(len(row) == 1 for row in rows) and len(rows) > 1
    height_of_panel = _LOW_PANEL if is_narrow else _PANEL
    left = _NAME + 12.0 + _LETTER * max([4, *(_widest_label(samples, name) for name in shown)])
    inner = wide() - left - _RIGHT
    ground = Ground(motion, samples)
    key = rows_of(path_key(motion, samples), inner) * _ROW + _AIR
    high = ground.height(inner)
    sentences = textwrap.wrap(said, int((wide() - 2 * _RIGHT) / _LETTER))
    between = 20.0 if is_narrow else _TICKS + 26.0
    panels = len(rows) * (height_of_panel + between) + (_NAME + _TICKS if rows else 0.0)
    whole = key + high + _NAME + _TICKS + panels + _ROW * len(sentences) + 2.0 * _GAP
    figure = sheet(inches(wide()), inches(whole))
    figure.set_layout_engine("none")

    def box(x: float, top: float, width: float, height: float) -> Any:
        return (x / wide(), 1.0 - (top + height) / whole, width / wide(), height / whole)

    axes = figure.add_axes(box(left, key, inner, high))
    draw_path(motion, samples, ground, axes)
    axes.yaxis.set_label_coords((_NAME - left) / inner, 0.5)
    top = key + high + _NAME + _TICKS + _GAP
    for row in rows:
        top += 18.0
        each = wide() / len(row)
        for place, name in enumerate(row):
            width = each - left - _RIGHT
            axes = figure.add_axes(box(place * each + left, top, width, height_of_panel))
            draw_history(motion, samples, axes, (name,))
            axes.yaxis.set_label_coords((_NAME - left) / width, 0.5)
            if row is rows[-1]:
                axes.set_xlabel(_core.marked(axis_label("time")))
            elif is_narrow:
                axes.tick_params(labelbottom=False)
        top += height_of_panel + between - 18.0
    for place, sentence in enumerate(sentences):
        y = (_ROW * (len(sentences) - place - 0.5) + 0.5 * _GAP) / whole
        figure.text(_RIGHT / wide(), y, sentence, va="center")
    return figure


def _rows_of_panels(shown: list[str], width: float) -> list[list[str]]:
    """Return the quantities in rows that are about equally full."""
    across = 3 if width >= 700.0 else 2 if width >= 480.0 else 1
    rows = -(-len(shown) // across)
    ends = [round(len(shown) * k / rows + 1e-9) for k in range(rows + 1)] if rows else []
    return [shown[a:b] for a, b in itertools.pairwise(ends)]


def _widest_label(samples: Samples, name: str) -> int:
    kind = "angular" if name == "theta" else "round"
    ticks = [row for most in (3, 6, 9) for row in _core.ticks(kind, *limits([samples[name]]), most)]
    return max((len(row["label"]) for row in ticks), default=0)


def _what_changes(motion: MotionLike, samples: Samples) -> tuple[list[str], str]:
    """Return the quantities that change, and a sentence about the others."""
    modes = {phase.mode for phase in motion.phases}
    shown, constant = [], []
    for name in _CHANGING:
        if (name == "gap" and "flight" not in modes) or (
            name in ("normal", "friction") and modes == {"flight"}
        ):
            continue
        values = samples[name][np.isfinite(samples[name])]
        if not len(values):
            continue
        if is_noise(samples, name):
            constant.append(f"{_core.marked(sign(name))} = 0")
        elif np.ptp(values) <= 1e-11 * np.max(np.abs(values)):
            constant.append(f"{_core.marked(sign(name))} = {number(float(values[0]))}")
        else:
            shown.append(name)
    return shown, f"Constant: {',  '.join(constant)}." if constant else ""
