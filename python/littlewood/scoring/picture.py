"""Pictures of scores."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..extras import require
from ..plot.canvas import axis_label, phase_slices, plain, sign
from ..style import FAINT, INK, LINE, MODE_COLOURS, MODE_DASHES

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from .convergence import Convergence
    from .score import Score

__all__ = ["draw", "draw_convergence"]

_LINES = {"x": "solid", "y": (0.0, (5.0, 2.0)), "theta": (0.0, (1.0, 1.5))}
_COLUMNS = {"x": "x", "y": "centre_y", "theta": "theta"}

_LEAST = 1e-16
"""What is smaller is drawn as this: a logarithm has no zero, and nothing is known better."""

_HEADROOM = 1e6
"""Room over the lines for the names of events, as a factor."""


def draw(score: Score) -> Figure:
    """Draw the paths of both motions, and the errors over time."""
    figure: Figure = require("matplotlib.figure").Figure(figsize=(9.0, 6.2), layout="constrained")
    path, errors = figure.subplots(2, 1, height_ratios=(1.2, 1.0))
    _paths(score, path)
    _errors(score, errors)
    return figure


def _paths(score: Score, axes: Axes) -> None:
    until = float(score.record.time[-1])
    samples = score.motion.sample(1001, until)
    named: set[str] = set()
    for mode, part in phase_slices(samples):
        axes.plot(
            samples.x[part],
            samples.centre_y[part],
            color=MODE_COLOURS[mode],
            linestyle=MODE_DASHES[mode],
            linewidth=3.5,
            alpha=0.7,
            label=None if mode in named else f"exact: {mode}",
        )
        named.add(mode)
    axes.plot(score.record.x, score.record.y, color=INK, linewidth=0.9, label="solver")
    axes.set_xlabel(axis_label("x"))
    axes.set_ylabel(axis_label("centre_y"))
    if np.ptp(score.record.y) < 1e-6:
        axes.set_ylim(0.9, 1.1)
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=5, frameon=False, handlelength=3.0)
    plain(axes)


def _errors(score: Score, axes: Axes) -> None:
    for name, line in _LINES.items():
        values = np.maximum(np.abs(score.errors[name]), _LEAST)
        axes.plot(score.record.time, values, color=INK, linestyle=line, linewidth=1.3, label=sign(_COLUMNS[name]))
    axes.set_yscale("log")
    for event in score.events:
        if event.exact is not None:
            axes.axvline(event.exact, color=LINE, linewidth=0.8, zorder=0)
        at = event.exact if event.found is None else event.found
        if at is not None and event.verdict in ("missed", "spurious"):
            # What was missed, and what is none, is the news.
            axes.axvline(at, color=FAINT, linewidth=0.8, linestyle=(0.0, (2.0, 2.0)), zorder=0)
            axes.annotate(
                f"{event.kind.replace('_', '-')}: {event.verdict}",
                (at, 1.0),
                xycoords=("data", "axes fraction"),
                xytext=(2, -2),
                textcoords="offset points",
                rotation=90,
                va="top",
                fontsize=8,
                color=INK,
            )
    axes.set_xlim(float(score.record.time[0]), float(score.record.time[-1]))
    low, high = axes.get_ylim()
    axes.set_ylim(low, high * (_HEADROOM if score.missed or score.spurious else 1.0))
    axes.set_xlabel(axis_label("time"))
    axes.set_ylabel("error  (R, rad)")
    axes.legend(loc="lower right", frameon=False, ncols=3, handlelength=3.0)
    plain(axes)


def draw_convergence(convergence: Convergence) -> Figure:
    """Draw the largest error over the step, with the law."""
    figure: Figure = require("matplotlib.figure").Figure(figsize=(5.0, 4.0), layout="constrained")
    axes = figure.add_subplot()
    steps = np.array(convergence.steps)
    errors = np.array([one.largest_error for one in convergence.scores])
    middle = np.exp(np.mean(np.log(errors)) - convergence.order * np.mean(np.log(steps)))
    axes.loglog(steps, middle * steps**convergence.order, color=FAINT, linewidth=1.0)
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
                fontsize=8,
                color=INK,
            )
    ticker = require("matplotlib.ticker")
    axes.xaxis.set_major_locator(ticker.FixedLocator(steps.tolist()))
    axes.xaxis.set_major_formatter(ticker.FuncFormatter(lambda value, _: f"{value:.3g}"))
    axes.xaxis.set_minor_locator(ticker.NullLocator())
    axes.yaxis.set_minor_formatter(ticker.NullFormatter())
    axes.set_xlabel(f"step  {axis_label('time')}")
    axes.set_ylabel("largest error  (R, rad)")
    axes.set_title(f"order {convergence.order:.2f}", fontsize=10)
    plain(axes)
    return figure
