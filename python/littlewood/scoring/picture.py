"""Pictures of scores."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .. import _core
from .._internal.extras import require
from ..plot.canvas import axis_label, key, on_sheet, phase_slices, sheet, sign
from ..style import CURVE, FAINT, FINE, INK, LINE, LIST_DASHES, MODE_COLOURS, MODE_DASHES

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from .convergence import Convergence
    from .score import Score

__all__ = ["draw", "draw_convergence"]

_COLUMNS = {"x": "x", "y": "centre_y", "theta": "theta"}

_LEAST = 1e-16
"""What is smaller is drawn as this: a logarithm has no zero, and nothing is known better."""

_HEADROOM = 1e9
"""Room over the lines for the names of events, as a factor."""


@on_sheet
def draw(score: Score) -> Figure:
    """Draw the paths of both motions, and the errors over time."""
    figure = sheet(9.0, 6.2)
    path, errors = figure.subplots(2, 1, height_ratios=(1.2, 1.0))
    _paths(score, path)
    _errors(score, errors)
    return figure


def _paths(score: Score, axes: Axes) -> None:
    until = float(score.record.time[-1])
    samples = score.motion.sample(1001, until)
    for mode, part in phase_slices(samples):
        axes.plot(
            samples.x[part],
            samples.centre_y[part],
            color=MODE_COLOURS[mode],
            linestyle=MODE_DASHES[mode],
            linewidth=2.0 * CURVE,
            label=f"exact: {mode}",
        )
    axes.plot(score.record.x, score.record.y, color=INK, linewidth=FINE, label="solver")
    axes.set_xlabel(_core.marked(axis_label("x")))
    axes.set_ylabel(_core.marked(axis_label("centre_y")))
    if np.ptp(score.record.y) < 1e-6:
        axes.set_ylim(0.9, 1.1)
    key(axes, columns=5)


def _errors(score: Score, axes: Axes) -> None:
    for (name, column), dashes in zip(_COLUMNS.items(), LIST_DASHES, strict=False):
        values = np.maximum(np.abs(score.errors[name]), _LEAST)
        label = _core.marked(sign(column))
        axes.plot(score.record.time, values, color=INK, linestyle=dashes, label=label)
    axes.set_yscale("log")
    for event in score.events:
        if event.exact is not None:
            axes.axvline(event.exact, color=LINE, linewidth=FINE, zorder=0)
        at = event.exact if event.found is None else event.found
        if at is not None and event.verdict in ("missed", "spurious"):
            # What was missed, and what is none, is the news.
            axes.axvline(at, color=FAINT, linewidth=FINE, linestyle="dashed", zorder=0)
            axes.annotate(
                f"{event.kind.replace('_', '-')}: {event.verdict}",
                (at, 1.0),
                xycoords=("data", "axes fraction"),
                xytext=(2, -2),
                textcoords="offset points",
                rotation=90,
                va="top",
            )
    axes.set_xlim(float(score.record.time[0]), float(score.record.time[-1]))
    low, high = axes.get_ylim()
    axes.set_ylim(low, high * (_HEADROOM if score.missed or score.spurious else 1.0))
    axes.set_xlabel(_core.marked(axis_label("time")))
    axes.set_ylabel("error  (*R*, rad)")
    key(axes, columns=3)


@on_sheet
def draw_convergence(convergence: Convergence) -> Figure:
    """Draw the largest error over the step, with the law."""
    figure = sheet(5.0, 4.0)
    axes = figure.add_subplot()
    steps = np.array(convergence.steps)
    errors = np.array([one.largest_error for one in convergence.scores])
    middle = np.exp(np.mean(np.log(errors)) - convergence.order * np.mean(np.log(steps)))
    axes.loglog(steps, middle * steps**convergence.order, color=FAINT)
    axes.loglog(steps, errors, color=INK, marker="o", linewidth=0.0)
    for one, step, error in zip(convergence.scores, steps, errors, strict=True):
        wrong = len(one.missed) + len(one.spurious)
        if wrong:
            axes.annotate(
                f"{wrong} event{'s' if wrong > 1 else ''} wrong",
                (step, error),
                xytext=(-6, 4),
                textcoords="offset points",
                ha="right",
            )
    axes.margins(y=0.15)
    ticker = require("matplotlib.ticker")
    axes.xaxis.set_major_locator(ticker.FixedLocator(steps.tolist()))
    axes.xaxis.set_major_formatter(ticker.FuncFormatter(lambda value, _: f"{value:.3g}"))
    axes.xaxis.set_minor_locator(ticker.NullLocator())
    axes.yaxis.set_minor_formatter(ticker.NullFormatter())
    axes.set_xlabel(f"step  {_core.marked(axis_label('time'))}")
    axes.set_ylabel("largest error  (*R*, rad)")
    axes.set_title(f"order {convergence.order:.2f}")
    return figure
