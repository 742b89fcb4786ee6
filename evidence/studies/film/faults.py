"""`python -m evidence.studies.film.faults FIRST LAST [KIND FAULT]`: fits of tracks with a fault.

It prints a line of CSV for each, of all kinds of motion and all faults unless one is named.

The fit does not know of the fault. Film number k of a kind and a fault is made with the seed k; the
first of each stand in docs/studies/doubted-fits/films.csv.
"""

from __future__ import annotations

import itertools
import math
import sys
import warnings
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import littlewood as lw
import numpy as np
import numpy.typing as npt
from littlewood.fitting.fall import fall_of

from .command import KINDS, is_of, random_motions
from .throws import FREE, SECONDS, throw

Reals = npt.NDArray[np.float64]

NOISE_M, NOISE_RAD = 0.001, 0.004
"""Standard deviations of the tracker's errors."""

WRONG = 3.0
"""An answer is wrong if the truth of an identifiable parameter is so many standard errors away, or
more."""

CAUSES = ("held", "camera")
"""Doubts that name a cause."""

HEAD = (
    "kind",
    "fault",
    "film",
    "worst",
    "doubts",
    "named",
    *(f"{name}_{what}" for name in FREE for what in ("true", "value", "error")),
)


@dataclass
class Film:
    """A track, and what its fit is told.

    Parameters
    ----------
    motion : Trajectory
        The exact motion.
    hoop : Hoop
        The hoop as its builder knows it; coefficients are the true ones.
    time, theta, x, y : ndarray
        The exact track: θ, and the centre in the plane, dimensionless by the units of `hoop`.
    start : dict
        The true start.
    slips : bool
        Whether it starts with a slip.
    rate : float
        Frames a second.
    free : tuple of str
        What is fitted.
    """

    motion: lw.Trajectory
    hoop: lw.Hoop
    time: Reals
    theta: Reals
    x: Reals
    y: Reals
    start: dict[str, Any]
    slips: bool
    rate: float
    free: tuple[str, ...] = FREE

    def through(self, image: Callable[[Reals, Reals], tuple[Reals, Reals]]) -> None:
        """See centre and marker through a map of the plane."""
        x, y = image(self.x, self.y)
        marker_x, marker_y = image(self.x - np.sin(self.theta), self.y + np.cos(self.theta))
        seen = np.arctan2(x - marker_x, marker_y - y)
        self.theta = self.theta + np.mod(seen - self.theta + math.pi, math.tau) - math.pi
        self.x, self.y = x, y


def _filmed(motion: lw.Trajectory, rate: float, time: Reals) -> Film:
    seen, first = motion(time), motion.start
    start = {"theta": first.theta, "theta_rate": first.theta_rate, "slip": first.slip, "x": first.x}
    slips = first.slip != 0.0
    return Film(motion, motion.hoop, time, seen.theta, seen.x, seen.centre_y, start, slips, rate)


def good_film(kind: str, random: np.random.Generator, rate: float) -> Film:
    """Return a film without a fault of a kind of motion."""
    if kind == "throw":
        motion, seconds = throw(random).motion, SECONDS
    else:
        motion = next(one for one in random_motions(random) if is_of(kind, one))
        seconds = motion.end_time * motion.hoop.require_units().time_s
    time = np.arange(int(seconds * rate)) / rate / motion.hoop.require_units().time_s
    return _filmed(motion, rate, time)


def _of_other_hoop(film: Film, **other: Any) -> Film:
    """Return the film of a hoop of which its builder does not know something."""
    motion = replace(film.hoop, **other, units=film.hoop.units).simulate(
        **film.start, until=float(film.time[-1]) + 0.01
    )
    return replace(_filmed(motion, film.rate, film.time), hoop=film.hoop)


def none(film: Film, random: np.random.Generator) -> Film:
    """No fault."""
    return film


def scale(film: Film, random: np.random.Generator) -> Film:
    """The scale is wrong by 3 %."""
    film.through(lambda x, y: (1.03 * x, 1.03 * y))
    return film


def tilt(film: Film, random: np.random.Generator) -> Film:
    """The camera, 3.4 m away, is turned aside by 5°, and its picture is taken for a square one."""
    middle, distance, angle = 0.5 * float(film.x.min() + film.x.max()), 3.4 / 0.3, math.radians(5.0)

    def image(x: Reals, y: Reals) -> tuple[Reals, Reals]:
        depth = distance + (x - middle) * math.sin(angle)
        return middle + distance * (x - middle) * math.cos(angle) / depth, 1.0 + distance * (
            y - 1.0
        ) / depth

    film.through(image)
    return film


def roll(film: Film, random: np.random.Generator) -> Film:
    """The camera is rolled by 2° about its axis."""
    sin, cos = math.sin(math.radians(2.0)), math.cos(math.radians(2.0))
    film.through(lambda x, y: (cos * x - sin * y, sin * x + cos * y))
    return film


def marker(film: Film, random: np.random.Generator) -> Film:
    """The marker is 3° beside the particle."""
    film.theta = film.theta + math.radians(3.0)
    return film


def dropped(film: Film, random: np.random.Generator) -> Film:
    """At three instants the phone leaves out two frames, and numbers on."""
    lost = random.choice(np.arange(10, film.time.size - 10), 3, replace=False)
    kept = np.setdiff1d(np.arange(film.time.size), np.concatenate([lost, lost + 1]))
    film.time = film.time[: kept.size]
    film.theta, film.x, film.y = film.theta[kept], film.x[kept], film.y[kept]
    return film


def mislabelled(film: Film, random: np.random.Generator) -> Film:
    """For a tenth of the film something else, 70° on, is taken for the marker."""
    first = random.integers(0, film.time.size - film.time.size // 10)
    film.theta[first : first + film.time.size // 10] += math.radians(70.0)
    return film


def shutter(film: Film, random: np.random.Generator) -> Film:
    """Lines are exposed one after the other.

    The picture, five radii high, is read from its top in the time of a frame.
    """
    unit = film.hoop.require_units().time_s
    film = _filmed(film.motion, film.rate, film.time[:-1])
    time = film.time

    def line(y: Reals) -> Reals:
        return np.asarray((1.0 - y / 5.0) / film.rate / unit)

    of_centre = film.motion(time + line(film.y))
    marker_y = film.y + np.cos(film.theta)
    for _ in range(4):
        of_marker = film.motion(time + line(marker_y))
        marker_y = of_marker.centre_y + np.cos(of_marker.theta)
    across = of_marker.x - np.sin(of_marker.theta) - of_centre.x
    seen = np.arctan2(-across, marker_y - of_centre.centre_y)
    film.theta = film.theta + np.mod(seen - film.theta + math.pi, math.tau) - math.pi
    film.x, film.y = of_centre.x, of_centre.centre_y
    return film


def ramp(film: Film, random: np.random.Generator) -> Film:
    """The floor rises by 1.5°, and is taken for level."""
    return _of_other_hoop(film, slope=math.radians(1.5))


def soft(film: Film, random: np.random.Generator) -> Film:
    """The ground resists rolling by a hundredth of the radius."""
    return _of_other_hoop(film, rolling_resistance=0.01)


def mass(film: Film, random: np.random.Generator) -> Film:
    """The particle was weighed 5 % too heavy."""
    heavy = 1.05
    found = film.hoop
    film.hoop = replace(
        found,
        mass_ratio=found.mass_ratio / heavy,
        inertia=found.inertia / heavy,
        units=replace(found.require_units(), mass_kg=heavy * found.require_units().mass_kg),
    )
    return film


def offset(film: Film, random: np.random.Generator) -> Film:
    """The distance of the particle from the middle was measured 3 % too short."""
    film.hoop = replace(film.hoop, offset=0.97 * film.hoop.offset)
    return film


def clock(film: Film, random: np.random.Generator) -> Film:
    """The frames were taken 2 % faster than the file says."""
    film.time = 1.02 * film.time
    return film


def fast(film: Film, random: np.random.Generator) -> Film:
    """The frames were taken 4 % faster than the file says."""
    film.time = 1.04 * film.time
    return film


def held(film: Film, random: np.random.Generator) -> Film:
    """μs is not fitted, and held at 1.2 times its value."""
    film.hoop = replace(film.hoop, mu_s=1.2 * film.hoop.mu_s)
    film.free = FREE[1:]
    return film


def radius(film: Film, random: np.random.Generator) -> Film:
    """The radius was measured 1 % too large; scale, weights and clock are right."""
    film.x, film.y, film.time = film.x / 1.01, film.y / 1.01, film.time / math.sqrt(1.01)
    film.hoop = replace(
        film.hoop, offset=film.hoop.offset / 1.01, inertia=film.hoop.inertia / 1.01**2
    )
    film.start |= {
        "x": film.start["x"] / 1.01,
        "theta_rate": film.start["theta_rate"] * math.sqrt(1.01),
    }
    film.start["slip"] /= math.sqrt(1.01)
    return film


FAULTS: Mapping[str, Callable[[Film, np.random.Generator], Film]] = {
    one.__name__: one
    for one in (
        none,
        scale,
        tilt,
        roll,
        marker,
        dropped,
        mislabelled,
        shutter,
        ramp,
        soft,
        mass,
        offset,
        clock,
        fast,
        held,
        radius,
    )
}
"""Films by the name of their fault."""


def fitted(kind: str, fault: str, number: int, search: bool = False) -> tuple[Film, lw.FitResult]:
    """Fit a film by a fit that does not know of its fault."""
    random = np.random.default_rng([number, 12])
    film = FAULTS[fault](good_film(kind, random, (120.0, 240.0)[number % 2]), random)
    size = film.time.size
    noise = random.normal(0.0, 1.0, (3, size))
    length = NOISE_M / film.hoop.require_units().length_m
    track = lw.Track(
        film.time,
        theta=film.theta + NOISE_RAD * noise[0],
        x=film.x + length * noise[1],
        y=film.y + length * noise[2],
    )
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", lw.fitting.FitWarning)
        result = lw.fit(
            track,
            film.hoop,
            free=film.free,
            slips_at_start=film.slips,
            start=None if search else film.start,
            search=search,
        )
    return film, result


def line_of(kind: str, fault: str, number: int) -> list[str]:
    """Return the cells of a line: how far the worst parameter is off, doubts, parameters.

    What doubts name as the cause stands by itself, with `fall` where flights refuse the clock
    before the fit.
    """
    film, result = fitted(kind, fault, number)
    cells, worst = [], 0.0
    for name in FREE:
        estimate = result.estimates.get(name)
        true = getattr(film.hoop, name)
        if estimate is None or true is None:
            cells += ["", "", ""]
            continue
        if estimate.identifiable:
            worst = max(worst, abs(estimate.value - true) / estimate.std_error)
        cells += [f"{true:.7g}", f"{estimate.value:.7g}", f"{estimate.std_error:.4g}"]
    names = [doubt.name for doubt in result.doubts if doubt.name != "identifiability"]
    fall = fall_of(result.track, film.hoop)
    causes = ["fall"] if fall is not None and fall.is_wrong else []
    for doubt in result.doubts:
        causes += doubt.parameters if doubt.name in CAUSES else ()
    told = (" ".join(dict.fromkeys(one)) for one in (names, causes))
    return [kind, fault, str(number), f"{worst:.3g}", *told, *cells]


def main() -> None:
    """Print the lines of the films that are asked for."""
    first, last = map(int, sys.argv[1:3])
    kinds, faults = ([one] for one in sys.argv[3:5]) if sys.argv[3:] else (KINDS, FAULTS)
    print(",".join(HEAD), flush=True)
    for number in range(first, last):
        for kind, fault in itertools.product(kinds, faults):
            print(",".join(line_of(kind, fault, number)), flush=True)


if __name__ == "__main__":
    main()
