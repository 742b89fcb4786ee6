"""What a telephone resolves.

Gaps after a lift-off, heights of jumps, bounces, and errors of coefficients.
"""

from __future__ import annotations

import math
import warnings
from functools import cache
from typing import TYPE_CHECKING

import littlewood as lw
import numpy as np
from littlewood.plot.canvas import key
from littlewood.plot.sheet import listed, panels
from littlewood.style import FINE, INK
from scipy.optimize import brentq

from .page import table
from .study import Study

if TYPE_CHECKING:
    from matplotlib.figure import Figure

RADIUS_MM = 300.0
MM_PER_PX = 3000.0 / 1920.0
"""A picture of 1920 pixels shows three metres."""

RATE = 240.0
SECONDS = 0.9
READ_OUT_S, ROWS = 0.010, 1080
FREE = ("mu_s", "mu_k", "inertia", "restitution")
HOOP = lw.Hoop.from_si(
    disc_mass_kg=0.25,
    particle_mass_kg=0.25,
    radius_m=1e-3 * RADIUS_MM,
    offset_m=0.27,
    inertia_kg_m2=0.021,
    mu_s=0.5,
    mu_k=0.4,
    restitution=0.5,
)
UNITS = HOOP.require_units()
START = {"theta": math.pi / 2, "theta_rate": 2.0}


@cache
def motion() -> lw.Trajectory:
    """The throw of the lesson."""
    return HOOP.simulate(theta=START["theta"], theta_rate=START["theta_rate"])


def lift_off() -> float:
    """Return the instant at which it leaves the plane, √(R/g)."""
    return next(one.time for one in motion().transitions if one.cause == "lift_off")


def seconds_until(gap_mm: float) -> float:
    """Return how long after the lift-off a gap is open so far, s."""
    begin, gap = lift_off(), gap_mm / RADIUS_MM
    top = begin + 1.0

    def missing(time: float) -> float:
        return float(motion()(time).gap) - gap

    return (float(brentq(missing, begin, top, xtol=1e-13)) - begin) * UNITS.time_s


def of_gaps() -> list[str]:
    """How late a gap is seen."""
    lines = []
    for gap_mm in (0.01 * MM_PER_PX, 0.1 * MM_PER_PX, 1.0, MM_PER_PX, 3.0, 10.0):
        late = seconds_until(gap_mm)
        lines.append(
            [
                f"{gap_mm:.2g}",
                f"{gap_mm / MM_PER_PX:.2g}",
                f"{1e3 * late:.0f}",
                f"{RATE * late:.1f}",
            ]
        )
    return table(
        ["gap, mm", "pixels", "ms after the lift-off", f"pictures at {RATE:g} a second"], lines
    )


@cache
def heights_mm() -> np.ndarray:
    """Return the heights of the first flights of rolling starts that lift off later."""
    found = lw.outcome_map(
        HOOP,
        theta=np.linspace(-math.pi, math.pi, 301),
        theta_rate=np.linspace(-4.0, 4.0, 201),
        until=30.0,
    )
    late = found.jump_height.to_numpy()[found.lift_off_time.to_numpy() > 0.0]
    return RADIUS_MM * np.sort(late[np.isfinite(late)])


def of_jumps() -> list[str]:
    """How many jumps are lower than what can be seen."""
    heights = heights_mm()
    limits = (0.1 * MM_PER_PX, MM_PER_PX, 3.0, 10.0, 30.0)
    return table(
        ["a flight lower than", *(f"{limit:.2g} mm" for limit in limits)],
        [["of all", *(f"{100.0 * float(np.mean(heights < limit)):.0f} %" for limit in limits)]],
    )


def of_bounces() -> list[str]:
    """How long and how high the flights of the throw are."""
    impacts = [one.time for one in motion().transitions if one.impact is not None]
    lines = []
    for begin, end in zip([lift_off(), *impacts], impacts[:6], strict=False):
        gap = float(np.max(motion()(np.linspace(begin, end, 4001)).gap)) * RADIUS_MM
        lasts = (end - begin) * UNITS.time_s
        lines.append(
            [f"{1e3 * lasts:.0f}", f"{RATE * lasts:.1f}", f"{gap:.2g}", f"{gap / MM_PER_PX:.2g}"]
        )
    numbered = [[str(k), *line] for k, line in enumerate(lines, start=1)]
    return table(
        ["flight", "ms", f"pictures at {RATE:g} a second", "height, mm", "pixels"], numbered
    )


@cache
def ideal(rate: float, error_px: float) -> lw.FitResult:
    """Fit the exact motion at the instants of a film as if places had such errors.

    Its standard errors are those that the best tracker with these errors can reach.
    """
    time = np.arange(0.0, SECONDS, 1.0 / rate) / UNITS.time_s
    seen = motion()(time)
    size = error_px * MM_PER_PX / RADIUS_MM
    sigma = {"theta": size / HOOP.offset, "x": size, "y": size}
    track = lw.Track(time, theta=seen.theta, x=seen.x, y=seen.centre_y)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", lw.fitting.FitWarning)
        return lw.fit(
            track, HOOP, free=FREE, slips_at_start=False, start=START, sigma=sigma, search=False
        )


def of_errors() -> list[str]:
    """How well films tell the coefficients."""
    lines = []
    for rate in (60.0, 120.0, 240.0, 960.0):
        found = ideal(rate, 0.5).estimates
        cells = [
            f"{found[name].std_error:.2g}" if found[name].identifiable else "not told"
            for name in FREE
        ]
        lines.append([f"{rate:g}", *cells])
    return table(["pictures a second", "μs", "μk", "inertia", "e"], lines)


def instant() -> str:
    """How well the fit tells the instant of the lift-off, ms."""
    result = ideal(RATE, 0.5)
    names = [name.removeprefix("start_") for name in result.estimates]
    place = next(k for k, one in enumerate(result.motion.transitions) if one.cause == "lift_off")
    slopes = (
        result.motion.derivatives(names).isel(transition=place).time.sel(quantity=names).to_numpy()
    )
    error = math.sqrt(float(slopes @ result.covariance @ slopes)) * UNITS.time_s
    return f"{1e3 * error:.2g}"


def picture() -> Figure:
    """The gap after the lift-off, and the flights of the throw."""
    figure, (left, right) = panels(2)
    gaps_mm = np.geomspace(0.002, 20.0, 60)
    left.loglog([1e3 * seconds_until(float(one)) for one in gaps_mm], gaps_mm, color=INK)
    left.set(xlabel="time after the lift-off, ms", ylabel="gap, mm")
    impacts = [one.time for one in motion().transitions if one.impact is not None]
    time = np.linspace(lift_off(), impacts[5], 8001)
    gap_mm = np.maximum(motion()(time).gap, 0.0) * RADIUS_MM
    right.semilogy((time - lift_off()) * UNITS.time_s, gap_mm, color=INK)
    right.set(xlabel="time after the lift-off, s", ylabel="gap, mm", ylim=(0.02, 300.0))
    sizes = {"a pixel": MM_PER_PX, "a tenth of a pixel": 0.1 * MM_PER_PX}
    for axis in (left, right):
        for (name, size), look in listed(list(sizes.items())):
            axis.axhline(size, **{**look, "linewidth": FINE}, label=name)
        key(axis)
    return figure


def result() -> str:
    """How late a gap of a pixel is seen, ms."""
    return f"{1e3 * seconds_until(MM_PER_PX):.0f}"


def fastest_mm_per_s() -> float:
    """Return the largest velocity of a point of the rim while it is filmed."""
    seen = motion()(np.linspace(0.0, SECONDS, 4001) / UNITS.time_s)
    centre = np.hypot(seen.slip - seen.theta_rate, seen.gap_rate)
    return float(np.max(centre + np.abs(seen.theta_rate))) * UNITS.velocity_m_per_s * 1e3


def blur() -> str:
    """How far a point of the rim moves in one exposure of the whole time of a picture, pixels."""
    return f"{fastest_mm_per_s() / RATE / MM_PER_PX:.0f}"


def shutter() -> str:
    """How far the hoop moves between the lines of its top and its bottom, pixels."""
    seen = motion()(np.linspace(0.0, SECONDS, 4001) / UNITS.time_s)
    along = float(np.max(np.abs(seen.slip - seen.theta_rate))) * UNITS.velocity_m_per_s * 1e3
    part = 2.0 * RADIUS_MM / MM_PER_PX / ROWS
    return f"{along * part * READ_OUT_S / MM_PER_PX:.0f}"


def power() -> str:
    """With which power of time the gap opens.

    From its first micrometre to a tenth of a millimetre.
    """
    return f"{math.log(1e-1 / 1e-3) / math.log(seconds_until(1e-1) / seconds_until(1e-3)):.1f}"


STUDY = Study(
    name="telephone",
    texts={
        "result": result,
        "gaps": of_gaps,
        "power": power,
        "jumps": of_jumps,
        "bounces": of_bounces,
        "errors": of_errors,
        "instant": instant,
        "blur": blur,
        "shutter": shutter,
    },
    pictures={"gaps": picture},
)
