"""`python -m evidence.studies.film.faults FAULT FIRST LAST`: fits of tracks with a fault.

It prints a line of CSV for each.

The fit does not know of the fault. Film number k of a fault is made with the seed k; the first of
every fault stand in docs/studies/doubted-fits/films.csv.
"""

from __future__ import annotations

import math
import sys
import warnings
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import littlewood as lw
import numpy as np
import numpy.typing as npt

from .coverage import NOISE_M, NOISE_RAD
from .soft import rolling_on_soft_ground
from .throws import FREE, SECONDS, throw

Reals = npt.NDArray[np.float64]

WRONG = 4.0
"""An answer is wrong if the truth of an identifiable parameter is so many standard errors away, or
more."""

HEAD = (
    "fault",
    "film",
    "worst",
    "doubts",
    *(f"{name}_{what}" for name in FREE for what in ("true", "value", "error")),
)


@dataclass
class Film:
    """A track, and what its fit is told.

    Parameters
    ----------
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

    hoop: lw.Hoop
    time: Reals
    theta: Reals
    x: Reals
    y: Reals
    start: dict[str, float]
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


def _filmed(motion: lw.Trajectory, slips: bool, rate: float, time: Reals) -> Film:
    seen = motion(time)
    first = motion.start
    start = {"theta": first.theta, "theta_rate": first.theta_rate, "slip": first.slip, "x": first.x}
    return Film(motion.hoop, time, seen.theta, seen.x, seen.centre_y, start, slips, rate)


def thrown(random: np.random.Generator, rate: float) -> Film:
    """Return a film without a fault."""
    one = throw(random)
    time = np.arange(round(SECONDS * rate)) / rate / one.hoop.require_units().time_s
    return _filmed(one.motion, one.slips, rate, time)


def none(random: np.random.Generator, rate: float) -> Film:
    """No fault."""
    return thrown(random, rate)


def scale(random: np.random.Generator, rate: float) -> Film:
    """The scale is wrong by 3 %."""
    film = thrown(random, rate)
    film.through(lambda x, y: (1.03 * x, 1.03 * y))
    return film


def tilt(random: np.random.Generator, rate: float) -> Film:
    """The camera, 3.4 m away, is turned aside by 5°, and its picture is taken for a square one."""
    film = thrown(random, rate)
    middle, distance, angle = 0.5 * float(film.x.min() + film.x.max()), 3.4 / 0.3, math.radians(5.0)

    def image(x: Reals, y: Reals) -> tuple[Reals, Reals]:
        depth = distance + (x - middle) * math.sin(angle)
        return middle + distance * (x - middle) * math.cos(angle) / depth, 1.0 + distance * (
            y - 1.0
        ) / depth

    film.through(image)
    return film


def roll(random: np.random.Generator, rate: float) -> Film:
    """The camera is rolled by 2° about its axis."""
    film = thrown(random, rate)
    sin, cos = math.sin(math.radians(2.0)), math.cos(math.radians(2.0))
    film.through(lambda x, y: (cos * x - sin * y, sin * x + cos * y))
    return film


def marker(random: np.random.Generator, rate: float) -> Film:
    """The marker is 3° beside the particle."""
    film = thrown(random, rate)
    film.theta = film.theta + math.radians(3.0)
    return film


def dropped(random: np.random.Generator, rate: float) -> Film:
    """At three instants the phone leaves out two frames, and numbers on."""
    film = thrown(random, rate)
    lost = random.choice(np.arange(10, film.time.size - 10), 3, replace=False)
    kept = np.setdiff1d(np.arange(film.time.size), np.concatenate([lost, lost + 1]))
    film.time = film.time[: kept.size]
    film.theta, film.x, film.y = film.theta[kept], film.x[kept], film.y[kept]
    return film


def mislabelled(random: np.random.Generator, rate: float) -> Film:
    """For a tenth of the film something else, 70° on, is taken for the marker."""
    film = thrown(random, rate)
    first = random.integers(0, film.time.size - film.time.size // 10)
    film.theta[first : first + film.time.size // 10] += math.radians(70.0)
    return film


def shutter(random: np.random.Generator, rate: float) -> Film:
    """Lines are exposed one after the other.

    The picture, five radii high, is read from its top in the time of a frame.
    """
    one = throw(random)
    unit = one.hoop.require_units().time_s
    time = np.arange(round(SECONDS * rate) - 1) / rate / unit
    film = _filmed(one.motion, one.slips, rate, time)

    def line(y: Reals) -> Reals:
        return np.asarray((1.0 - y / 5.0) / rate / unit)

    of_centre = one.motion(time + line(film.y))
    marker_y = film.y + np.cos(film.theta)
    for _ in range(4):
        of_marker = one.motion(time + line(marker_y))
        marker_y = of_marker.centre_y + np.cos(of_marker.theta)
    across = of_marker.x - np.sin(of_marker.theta) - of_centre.x
    seen = np.arctan2(-across, marker_y - of_centre.centre_y)
    film.theta = film.theta + np.mod(seen - film.theta + math.pi, math.tau) - math.pi
    film.x, film.y = of_centre.x, of_centre.centre_y
    return film


def ramp(random: np.random.Generator, rate: float) -> Film:
    """The floor rises by 1.5°, and is taken for level."""
    film = thrown(random, rate)
    steep = replace(film.hoop, slope=math.radians(1.5))
    end = (SECONDS + 0.01) / film.hoop.require_units().time_s
    start: dict[str, Any] = film.start
    motion = steep.simulate(**start, until=end)
    film = _filmed(motion, film.slips, rate, film.time)
    film.hoop = replace(film.hoop, slope=0.0)
    return film


def soft(random: np.random.Generator, rate: float) -> Film:
    """The ground resists rolling by a hundredth of the radius.

    The film ends where the hoop leaves the ground.
    """
    while True:
        film = thrown(random, rate)
        theta, x = rolling_on_soft_ground(film.hoop, film.start, film.time, 0.01)
        if theta.size >= 40:
            film.time, film.theta, film.x, film.y = (
                film.time[: theta.size],
                theta,
                x,
                np.ones(theta.size),
            )
            film.free = FREE[:3]
            film.hoop = replace(film.hoop, restitution=None, restitution_law=None)
            return film


def clock(random: np.random.Generator, rate: float) -> Film:
    """The frames were taken 1 % faster than the file says."""
    film = thrown(random, rate)
    film.time = 1.01 * film.time
    return film


def held(random: np.random.Generator, rate: float) -> Film:
    """μs is not fitted, and held at 1.2 times its value."""
    film = thrown(random, rate)
    film.hoop = replace(film.hoop, mu_s=1.2 * film.hoop.mu_s)
    film.free = FREE[1:]
    return film


def radius(random: np.random.Generator, rate: float) -> Film:
    """The radius was measured 1 % too large; scale, weights and clock are right."""
    film = thrown(random, rate)
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


FAULTS: Mapping[str, Callable[[np.random.Generator, float], Film]] = {
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
        clock,
        held,
        radius,
    )
}
"""Films by the name of their fault."""


def fitted(fault: str, number: int, search: bool = False) -> tuple[Film, lw.FitResult]:
    """Fit a film by a fit that does not know of its fault."""
    random = np.random.default_rng([number, 12])
    film = FAULTS[fault](random, (120.0, 240.0)[number % 2])
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


def line_of(fault: str, number: int) -> list[str]:
    """Return the cells of a line: how far the worst parameter is off, doubts, parameters."""
    film, result = fitted(fault, number)
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
    return [fault, str(number), f"{worst:.3g}", " ".join(dict.fromkeys(names)), *cells]


def main() -> None:
    """Print the lines of the films that are asked for."""
    fault, first, last = sys.argv[1], *map(int, sys.argv[2:4])
    for number in range(first, last):
        print(",".join(line_of(fault, number)), flush=True)


if __name__ == "__main__":
    main()
