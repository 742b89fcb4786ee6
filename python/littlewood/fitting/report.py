"""The report of a fit: one page of HTML that needs nothing else, and prints on one sheet of A4."""

from __future__ import annotations

import base64
import dataclasses
import itertools
import math
from collections.abc import Iterator
from html import escape
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from ..plot import canvas, history, outcomes
from ..style import FAINT, FINE, INK, LINE, MODE_COLOURS, PAPER
from ..sweep.many import outcome_map
from ..tables import QUANTITIES
from ..trajectory import Trajectory
from .estimate import Estimate
from .fall import fall_of
from .result import FitResult
from .shares import shares

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["report_html"]

# Width of what is printed, inches: A4 less its margins.
_WIDTH = 7.3
# By how much the friction is greater in the sentence about more of it, and the largest in its map.
_MORE = 1.5
_MOST_FRICTION = 1.5
# How many phases the sentence names.
_NAMED = 8
_GRID = (161, 101)
# How long motions of the map are followed where rolling resistance is small: they roll to and fro
# thousands of times, and jump early or not at all. √(R/g).
_FOLLOWED = 30.0
# Doubts that are there with their words; of more, the names.
_DOUBTS = 6
# Heights of the picture of the track, and of a doubt, inches.
_HEIGHT, _LEAST_HEIGHT, _DOUBT_HEIGHT = 2.9, 2.1, 0.27
# Heights of the picture of what says what: of its axis, and of each number.
_AXIS_HEIGHT, _ROW_HEIGHT = 0.45, 0.19
# Of forces and of more friction a fit with more doubts says nothing.
_FEW_DOUBTS = 3
# So many columns of frames, and a mode is named from this part on.
_COLUMNS, _NAMED_PART = 60, 0.05

_STYLE = f"""
body {{ max-width: 190mm; margin: 4mm auto; color: {INK}; background: {PAPER};
  font: 9.5pt/1.3 system-ui, "DejaVu Sans", sans-serif; }}
h1 {{ font-size: 14pt; margin: 0 0 1mm; }}
h2 {{ font-size: 10pt; margin: 2mm 0 0.5mm; }}
p {{ margin: 0.5mm 0; }}
img {{ display: block; width: 100%; }}
table {{ border-collapse: collapse; font-variant-numeric: tabular-nums; }}
td, th {{ padding: 0 2.5mm 0 0; text-align: left; font-weight: normal; vertical-align: top; }}
th {{ border-bottom: 1px solid {LINE}; }}
.beside {{ display: grid; grid-template-columns: minmax(0, 1fr) minmax(0, 1fr);
  gap: 4mm; align-items: start; }}
.number {{ white-space: nowrap; }}
.doubt {{ font-size: 7.5pt; line-height: 1.2; border-left: 1mm solid {MODE_COLOURS["sliding"]};
  padding-left: 2mm; }}
.small {{ font-size: 8pt; }}
.photo {{ max-height: 48mm; width: auto; max-width: 100%; }}
@page {{ size: A4; margin: 8mm 10mm; }}
@media print {{ body {{ margin: 0; max-width: none; }} }}
"""


def report_html(result: FitResult, *, title: str, photo: bytes | None = None) -> str:
    """Return the report of a fit, a page with all pictures in it.

    The photo is a JPEG of film and fitted motion.
    """
    shown = (
        ""
        if photo is None
        else f'<img class="photo" alt="the film and the fitted motion" src="{_jpeg(photo)}">'
    )
    with canvas.look(25.4 * _WIDTH):
        fitted, told = result.plot(with_doubts=False), _told(result)
        pictures = _of_forces(result.motion) + _of_friction(result) if _may_say(result) else ""
    # Doubts take the room of the pictures, so that one sheet is enough.
    fitted.set_size_inches(
        _WIDTH, max(_LEAST_HEIGHT, _HEIGHT - _DOUBT_HEIGHT * min(len(result.doubts), _DOUBTS))
    )
    doubts = "".join(
        f'<p class="doubt"><b>Doubt: {escape(one.name)}.</b> {escape(_in_signs(one.message))}</p>'
        for one in result.doubts[:_DOUBTS]
    )
    if len(result.doubts) > _DOUBTS:
        doubts += (
            f'<p class="doubt">Further doubts: '
            f"{', '.join(one.name for one in result.doubts[_DOUBTS:])}.</p>"
        )
    return f"""<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{escape(title)}</title>
<style>{_STYLE}</style>
</head>
<body>
<h1>{escape(title)}</h1>
<table>
<tr><th></th><th></th><th>value</th><th>95 % interval</th></tr>
{"".join(_rows(result))}
</table>
<div class="{"beside" if shown else ""}">
{shown}
<p class="small">{" ".join((_facts(result), *map(escape, result.track.notes)))}</p>
</div>
{doubts or "<p>The fit has no doubts.</p>"}
<h2>Track, fitted motion, residuals</h2>
<img alt="measured and fitted motion over time, and residuals"
  src="{_svg(fitted, "Track, fitted motion, residuals")}">
{told}
<div class="beside">
{pictures}
</div>
<p>{escape(_sentence(result))}</p>
</body>
</html>
"""


def _in_signs(message: str) -> str:
    """Return a message with coefficients as the table has them."""
    for name, sign in (("mu_s", "μₛ"), ("mu_k", "μₖ"), (">=", "≥")):
        message = message.replace(name, sign)
    return message


def _rows(result: FitResult) -> Iterator[str]:
    for name, estimate in result.estimates.items():
        if name in QUANTITIES:
            quantity, interval = QUANTITIES[name], _interval(result, name)
            meaning = quantity.long_name
            if name == "inertia" and result.hoop.units is not None:
                unit, of_si = result.hoop.units.inertia_kg_m2, QUANTITIES["inertia_kg_m2"]
                si = Estimate(estimate.value * unit, estimate.std_error * unit, True)
                si = si if estimate.identifiable else estimate
                low, high = interval
                sign = f"{of_si.sign} ({of_si.unit_sign})"
                yield _row(sign, of_si.long_name, si, (low * unit, high * unit))
                meaning = "the same over m₂R²"
            yield _row(quantity.sign, meaning, estimate, interval)


def _interval(result: FitResult, name: str) -> tuple[float, float]:
    """Return the interval that is printed: that of the profile where a normal one is wrong.

    It is within the bounds of the parameter.
    """
    estimate = result.estimates[name]
    if not estimate.identifiable:
        return estimate.interval()
    if any(one.name == "interval" and name in one.parameters for one in result.doubts):
        return result.profile_interval(name)
    low, high = estimate.interval()
    least, most = result._problem.limits(name)
    return max(low, least), min(high, most)


def _row(sign: str, meaning: str, estimate: Estimate, ends: tuple[float, float]) -> str:
    if not estimate.identifiable:
        value, interval = "this motion does not tell it", ""
    else:
        value = str(estimate)
        digits = len(value.split(" ")[0].partition(".")[2])
        low, high = ends
        interval = f"{low:.{digits}f} to {high:.{digits}f}"
    return (
        f'<tr><td class="number"><i>{escape(sign)}</i></td><td>{escape(meaning)}</td>'
        f'<td class="number">{value}</td><td class="number">{interval}</td></tr>\n'
    )


def _facts(result: FitResult) -> str:
    hoop, frames = result.hoop, result.track.time.size
    known = [(QUANTITIES[name].sign, getattr(hoop, name)) for name in ("mass_ratio", "offset")]
    words = ", ".join(f"{sign} = {value:.4g}" for sign, value in known)
    words += f", slope {math.degrees(hoop.slope):.3g}°"
    if hoop.units is not None:
        words += f", R = {hoop.units.length_m:.4g} m; the unit of τ is {hoop.units.time_s:.4g} s"
    sizes = ", ".join(
        f"{QUANTITIES[name].sign if name in QUANTITIES else name} {noise.sigma:.2g}"
        for name, noise in result.noise.items()
    )
    said = [
        f"As told: {escape(words)}.",
        f"{frames} frames; errors of each: {escape(sizes)} (rad, R).",
    ]
    if not _knows(result, "mu_s") and result.mu_s_at_least > 0.0:
        said.append(f"μₛ is at least {result.mu_s_at_least:.3g}, which rolling needed.")
    return " ".join([*said, _of_clock(result)])


def _of_clock(result: FitResult) -> str:
    """Return how well the flights of a track tell its clock."""
    fall = fall_of(result.track, result.hoop)
    if fall is None:
        return "No flight tells the clock: film a stop watch."
    return (
        f"Flights tell the clock to ± {100.0 * fall.clock_error:.2g} %; one that is off by less "
        f"than {100.0 * fall.noticed:.2g} % they may not show, as lengths are known to 1 %."
    )


def _knows(result: FitResult, *names: str) -> bool:
    """Whether the inertia is known, and other parameters, by the track or because they are held.

    Without it nothing can be said of forces, or of what a hoop would do.
    """
    estimates = result.estimates
    return all(
        name not in estimates or estimates[name].identifiable for name in ("inertia", *names)
    )


def _may_say(result: FitResult) -> bool:
    """Whether the fit is good enough for forces and for what more friction would do."""
    return _knows(result) and len(result.doubts) <= _FEW_DOUBTS


def _firsts(frames: int) -> npt.NDArray[np.intp]:
    """Return the first frames of columns of so many frames each: none is empty by rounding."""
    return np.arange(0, frames, math.ceil(frames / _COLUMNS))


def _told(result: FitResult) -> str:
    """Draw which frames tell each number, in the colours of the phases."""
    parts = shares(result)
    if not parts:
        return ""
    time, motion = result.track.time, result.motion
    begins = np.array([phase.start_time for phase in motion.phases])
    modes = np.array([phase.mode for phase in motion.phases])
    of_frames = modes[np.maximum(np.searchsorted(begins, time, side="right") - 1, 0)]
    firsts = _firsts(time.size)
    between = 0.5 * (time[firsts[1:] - 1] + time[firsts[1:]])
    edges = np.concatenate([time[:1], between, time[-1:]])
    frames = np.diff([*firsts, time.size])
    figure = canvas.sheet(_WIDTH, _AXIS_HEIGHT + _ROW_HEIGHT * len(parts))
    axes = figure.add_subplot()
    for row, (name, part) in enumerate(parts.items()):
        bottom = np.zeros(edges.size - 1)
        most = np.max(np.add.reduceat(part, firsts) / frames)
        said = {}
        for mode, colour in MODE_COLOURS.items():
            of_mode = np.where(of_frames == mode, part, 0.0)
            heights = 0.85 * np.add.reduceat(of_mode, firsts) / frames / most
            axes.bar(edges[:-1], heights, np.diff(edges), -row + bottom, align="edge", color=colour)
            bottom += heights
            said[mode] = float(of_mode.sum())
        axes.axhline(-row, color=LINE, lw=FINE)
        words = ", ".join(
            f"{mode} {100.0 * size:.0f} %"
            for mode, size in sorted(said.items(), key=lambda one: -one[1])
            if size > _NAMED_PART
        )
        axes.text(1.01, -row + 0.3, words, transform=axes.get_yaxis_transform(), va="center")
        sign = canvas.words(axes, canvas.sign(name))
        axes.text(
            -0.01, -row + 0.3, sign, transform=axes.get_yaxis_transform(), va="center", ha="right"
        )
    for transition in motion.transitions:
        if transition.time <= time[-1]:
            axes.axvline(transition.time, color=FAINT, lw=FINE, zorder=0)
    axes.set_yticks([])
    axes.set(xlim=(time[0], time[-1]), ylim=(0.0 - len(parts) + 1.0, 1.0))
    axes.set_xlabel(canvas.words(axes, canvas.axis_label("time")))
    title = "Which part of the film says what"
    return (
        f"<h2>{title}</h2>\n"
        '<p class="small">The higher a column, the more each of its frames tells of the number; '
        "its colour is what the hoop then does. A number of which few frames tell hangs on these."
        "</p>\n"
        f'<img alt="how much each part of the film tells of each number" '
        f'src="{_svg(figure, title)}">'
    )


def _of_forces(motion: Trajectory) -> str:
    figure = canvas.sheet(0.5 * _WIDTH, 1.6)
    axes = history(motion, figure.add_subplot(), quantities=("normal", "friction"))
    axes.set_ylabel(canvas.words(axes, "force  (m₂g)"))
    return (
        '<div>\n<h2>Forces</h2>\n<img alt="normal force and friction over time" '
        f'src="{_svg(figure, "Forces of the fitted motion")}">\n</div>'
    )


def _of_friction(result: FitResult) -> str:
    """Draw the outcome for any friction and any rate at the start.

    The friction of the hoop is marked as far as it is known.
    """
    motion = result.motion
    hoop = dataclasses.replace(motion.hoop, restitution=None, restitution_law=None)
    start = motion.start
    knows_static, knows_kinetic = _knows(result, "mu_s"), _knows(result, "mu_k")
    marked = ([hoop.mu_k] if knows_kinetic else []) + ([hoop.mu_s] if knows_static else [])
    most = max([_MOST_FRICTION, *(1.2 * value for value in marked)])
    rates = abs(start.theta_rate) + 2.0
    until = _FOLLOWED if hoop.rolling_resistance > 0.0 else None
    found = outcome_map(
        hoop,
        mu=np.linspace(0.0, most, _GRID[0]),
        theta_rate=np.linspace(-rates, rates, _GRID[1]),
        theta=start.theta,
        slip=start.slip,
        until=until,
        max_transitions=200,
    )
    figure = canvas.sheet(0.5 * _WIDTH, 1.6)
    axes = outcomes(found, figure.add_subplot(), x="mu", y="theta_rate")
    if marked:
        rate = [start.theta_rate] * len(marked)
        axes.plot(marked, rate, "|-", color=PAPER, lw=3.0, ms=9, mew=3.0)
        axes.plot(marked, rate, "|-", color=INK, lw=1.2, ms=8)
        axes.annotate(
            "yours",
            (marked[-1], start.theta_rate),
            xytext=(4, 4),
            textcoords="offset points",
            bbox={
                "boxstyle": "round,pad=0.1",
                "facecolor": PAPER,
                "edgecolor": "none",
                "alpha": 0.8,
            },
        )
    followed = "" if until is None else f", or τ = {until:.0f}"
    return (
        "<div>\n<h2>What your hoop would do with more friction</h2>\n"
        f'<p class="small">With μₛ = μₖ = μ, up to the first landing{followed}.</p>\n'
        '<img alt="outcomes by friction and rate of the start" '
        f'src="{_svg(figure, "Outcomes with more friction")}">\n</div>'
    )


def _course(one: Trajectory) -> str:
    words = []
    for mode, phases in itertools.groupby(phase.mode for phase in one.phases):
        bounces = len(list(phases)) - 1
        words.append(
            mode
            if bounces == 0 or mode != "flight"
            else f"{mode} with {bounces} bounce{'s' * (bounces > 1)}"
        )
    return ", ".join(words[:_NAMED]) + ", …" * (len(words) > _NAMED)


def _sentence(result: FitResult) -> str:
    """Say what the hoop did, and what it would do with more friction, where the track tells that.

    A number that the track does not tell is no ground for it.
    """
    motion = result.motion
    hoop, start = motion.hoop, motion.start
    words = f"Your hoop: {_course(motion)}. "
    if not _may_say(result):
        return f"{words}Of its forces, and of more friction, this fit says nothing."
    if _knows(result, "mu_s", "mu_k"):
        more = dataclasses.replace(
            hoop, units=hoop.units, mu_s=_MORE * hoop.mu_s, mu_k=_MORE * hoop.mu_k
        )
        then = more.simulate(
            **{name: getattr(start, name) for name in vars(start)}, until=motion.until
        )
        words += (
            f"With half as much friction more (μₛ = {more.mu_s:.3g}, μₖ = {more.mu_k:.3g}) and the "
            f"same start: {_course(then)}."
        )
    return words


def _svg(figure: Figure, title: str) -> str:
    from ..plot.sheet import svg

    return (
        "data:image/svg+xml;base64," + base64.b64encode(svg(figure, title, title).encode()).decode()
    )


def _jpeg(content: bytes) -> str:
    return "data:image/jpeg;base64," + base64.b64encode(content).decode()
