"""The report of a fit: one page of HTML that needs nothing else, and prints on one sheet of A4."""

from __future__ import annotations

import base64
import dataclasses
import itertools
from collections.abc import Iterator
from html import escape
from typing import TYPE_CHECKING

import numpy as np

from ..plot import canvas, history, outcomes
from ..style import INK, LINE, MODE_COLOURS, PAPER
from ..sweep.many import outcome_map
from ..tables import QUANTITIES
from ..trajectory import Trajectory
from .estimate import Estimate
from .result import FitResult

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
# Doubts that are there with their words; of more, the names.
_DOUBTS = 6
# Heights of the picture of the track, and of a doubt, inches.
_HEIGHT, _LEAST_HEIGHT, _DOUBT_HEIGHT = 3.8, 2.4, 0.3

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
        fitted, forces, more = (
            result.plot(with_doubts=False),
            _forces(result.motion),
            _more_friction(result.motion),
        )
    # Doubts take the room of the pictures, so that one sheet is enough.
    fitted.set_size_inches(
        _WIDTH, max(_LEAST_HEIGHT, _HEIGHT - _DOUBT_HEIGHT * min(len(result.doubts), _DOUBTS))
    )
    doubts = "".join(
        f'<p class="doubt"><b>Doubt: {escape(one.name)}.</b> {escape(one.message)}</p>'
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
<div class="beside">
<div>
<h2>Forces</h2>
<img alt="normal force and friction over time" src="{_svg(forces, "Forces of the fitted motion")}">
</div>
<div>
<h2>What your hoop would do with more friction</h2>
<img alt="outcomes by friction and rate of the start"
  src="{_svg(more, "Outcomes with more friction")}">
</div>
</div>
<p>{escape(_sentence(result.motion))}</p>
</body>
</html>
"""


def _rows(result: FitResult) -> Iterator[str]:
    for name, estimate in result.estimates.items():
        if name in QUANTITIES:
            yield _row(QUANTITIES[name].sign, QUANTITIES[name].long_name, estimate)
    if result.hoop.units is not None and "inertia" in result.estimates:
        one, unit = result.estimates["inertia"], result.hoop.units.inertia_kg_m2
        quantity = QUANTITIES["inertia_kg_m2"]
        si = Estimate(one.value * unit, one.std_error * unit, one.identifiable)
        yield _row(quantity.sign, f"the same in {quantity.unit_sign}", si)


def _row(sign: str, meaning: str, estimate: Estimate) -> str:
    if not estimate.identifiable:
        value, interval = "not identifiable", ""
    else:
        value = str(estimate)
        digits = len(value.split(" ")[0].partition(".")[2])
        low, high = estimate.interval()
        interval = f"{low:.{digits}f} to {high:.{digits}f}"
    return (
        f'<tr><td class="number"><i>{escape(sign)}</i></td><td>{escape(meaning)}</td>'
        f'<td class="number">{value}</td><td class="number">{interval}</td></tr>\n'
    )


def _facts(result: FitResult) -> str:
    hoop, frames = result.hoop, result.track.time.size
    known = [
        (QUANTITIES[name].sign, getattr(hoop, name)) for name in ("mass_ratio", "offset", "slope")
    ]
    words = ", ".join(f"{sign} = {value:.4g}" for sign, value in known)
    if hoop.units is not None:
        words += f", R = {hoop.units.length_m:.4g} m; the unit of τ is {hoop.units.time_s:.4g} s"
    sizes = ", ".join(
        f"{QUANTITIES[name].sign if name in QUANTITIES else name} {noise.sigma:.2g}"
        for name, noise in result.noise.items()
    )
    return (
        f"Held: {escape(words)}. {frames} frames; errors of a frame: {escape(sizes)} (rad, R); "
        f"μₛ is at least {result.mu_s_at_least:.3g}. Motion: {escape(result.motion.outcome.label)}."
    )


def _forces(motion: Trajectory) -> Figure:
    figure = canvas.sheet(0.5 * _WIDTH, 2.1)
    axes = history(motion, figure.add_subplot(), quantities=("normal", "friction"))
    axes.set_ylabel(canvas.words(axes, "force  (m₂g)"))
    return figure


def _more_friction(motion: Trajectory) -> Figure:
    """Draw the outcome for any friction and any rate at the start."""
    hoop = dataclasses.replace(motion.hoop, restitution=None, restitution_law=None)
    start = motion.start
    most = max(_MOST_FRICTION, 1.2 * hoop.mu_s)
    rates = abs(start.theta_rate) + 2.0
    found = outcome_map(
        hoop,
        mu=np.linspace(0.0, most, _GRID[0]),
        theta_rate=np.linspace(-rates, rates, _GRID[1]),
        theta=start.theta,
        slip=start.slip,
        max_transitions=200,
    )
    figure = canvas.sheet(0.5 * _WIDTH, 2.1)
    axes = outcomes(found, figure.add_subplot(), x="mu", y="theta_rate")
    axes.plot(
        [hoop.mu_k, hoop.mu_s], [start.theta_rate] * 2, "|-", color=PAPER, lw=3.0, ms=9, mew=3.0
    )
    axes.plot([hoop.mu_k, hoop.mu_s], [start.theta_rate] * 2, "|-", color=INK, lw=1.2, ms=8)
    axes.annotate(
        "yours",
        (hoop.mu_s, start.theta_rate),
        xytext=(4, 4),
        textcoords="offset points",
        bbox={"boxstyle": "round,pad=0.1", "facecolor": PAPER, "edgecolor": "none", "alpha": 0.8},
    )
    return figure


def _sentence(motion: Trajectory) -> str:
    hoop, start = motion.hoop, motion.start
    more = dataclasses.replace(
        hoop, units=hoop.units, mu_s=_MORE * hoop.mu_s, mu_k=_MORE * hoop.mu_k
    )
    until = motion.until
    then = more.simulate(**{name: getattr(start, name) for name in vars(start)}, until=until)

    def course(one: Trajectory) -> str:
        words = []
        for mode, phases in itertools.groupby(phase.mode for phase in one.phases):
            bounces = len(list(phases)) - 1
            words.append(
                mode
                if bounces == 0 or mode != "flight"
                else f"{mode} with {bounces} bounce{'s' * (bounces > 1)}"
            )
        return ", ".join(words[:_NAMED]) + ", …" * (len(words) > _NAMED)

    return (
        f"Your hoop: {course(motion)}. With half as much friction more (μₛ = {more.mu_s:.3g}, μₖ = "
        f"{more.mu_k:.3g}) "
        f"and the same start: {course(then)}. In the map μₛ = μₖ = μ, up to the first landing."
    )


def _svg(figure: Figure, title: str) -> str:
    from ..plot.sheet import svg

    return (
        "data:image/svg+xml;base64," + base64.b64encode(svg(figure, title, title).encode()).decode()
    )


def _jpeg(content: bytes) -> str:
    return "data:image/jpeg;base64," + base64.b64encode(content).decode()
