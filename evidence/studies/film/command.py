"""`python -m evidence.studies.film.command SEED FIRST LAST`: good tracks, fitted by the command.

It prints a line of CSV for each; docs/studies/measured-data/fits.csv has those of the seed 8.

The command is told what its user weighs and measures, and begins where it does. Tracks of hoops
that nothing resists are fitted without rolling resistance; others, of which three in four hoops
have some, with it among what is estimated.
"""

from __future__ import annotations

import itertools
import math
import sys
import warnings
from collections.abc import Iterator
from dataclasses import dataclass, replace

import littlewood as lw
import numpy as np
from littlewood._commands import fit as fit_command

from .throws import FREE

KINDS = ("throw", "slide", "slips")
"""Throws that land twice; motions on the floor that slip out of rolling never, and again and
again."""
RESISTANCE = "rolling_resistance"
ALL = (*FREE, RESISTANCE)
FITS = {"estimated": ALL, "held at 0": FREE}
"""What is estimated where hoops have rolling resistance, and where it is held."""
MOST = 0.02
"""Largest coefficient of rolling resistance, over the radius: that of a soft floor."""

HEAD = (
    "kind",
    "track",
    "rate",
    "noise_m",
    "fit",
    "phases",
    "found",
    "probability",
    *(f"{name}_{what}" for name in ALL for what in ("true", "value", "error")),
)


@dataclass(frozen=True, kw_only=True)
class GoodTrack:
    """A track without a fault.

    Parameters
    ----------
    motion : Trajectory
        The exact motion, up to the last frame.
    track : Track
        It with the errors of a tracker.
    rate : float
        Frames a second.
    noise_m : float
        Standard deviation of a place, m.
    """

    motion: lw.Trajectory
    track: lw.Track
    rate: float
    noise_m: float


def laboratory_hoop(
    random: np.random.Generator, slope: float = 0.0, rolling_resistance: float = 0.0
) -> lw.Hoop:
    """Draw a hoop of a school laboratory."""
    radius, mass = random.uniform(0.2, 0.35), random.uniform(0.1, 0.4)
    mu_k = random.uniform(0.15, 0.5)
    return lw.Hoop.from_si(
        disc_mass_kg=mass,
        particle_mass_kg=random.uniform(0.15, 0.5),
        radius_m=radius,
        offset_m=radius * random.uniform(0.85, 1.0),
        inertia_kg_m2=mass * radius**2 * random.uniform(0.85, 1.0),
        mu_s=mu_k * random.uniform(1.1, 1.5),
        mu_k=mu_k,
        restitution=random.uniform(0.2, 0.7),
        slope=slope,
        rolling_resistance_m=radius * rolling_resistance,
    )


def random_motions(
    random: np.random.Generator, slope: float = 0.0, rolling_resistance: float = 0.0
) -> Iterator[lw.Trajectory]:
    """Yield motions with any start, of half a second to one and a half."""
    while True:
        hoop = laboratory_hoop(random, slope, rolling_resistance)
        until = random.uniform(0.5, 1.5) / hoop.require_units().time_s
        motion = hoop.simulate(
            theta=random.uniform(-math.pi, math.pi),
            theta_rate=random.uniform(0.5, 3.0) * random.choice([-1.0, 1.0]),
            slip=random.choice([0.0, random.uniform(-2.0, 2.0)]),
            until=until,
        )
        if motion.end_time >= until - 1e-9:
            yield motion


def filmed(
    motion: lw.Trajectory,
    rate: float,
    noise_m: float,
    noise_rad: float,
    random: np.random.Generator,
) -> lw.Track:
    """Return the track of a film of a motion."""
    units = motion.hoop.require_units()
    time = np.arange(0.0, motion.end_time, 1.0 / rate / units.time_s)
    seen, noise = motion(time), random.normal(0.0, 1.0, (3, time.size))
    length = noise_m / units.length_m
    return lw.Track(
        time,
        theta=seen.theta + noise_rad * noise[0],
        x=seen.x + length * noise[1],
        y=seen.centre_y + length * noise[2],
    )


def is_of(kind: str, motion: lw.Trajectory) -> bool:
    """Whether a motion is of a kind, and slides or bounces so that a fit has something to tell."""
    slips = sum(one.cause == "slip" for one in motion.transitions)
    landings = sum(one.impact is not None for one in motion.transitions)
    flies = any(phase.mode == "flight" for phase in motion.phases)
    slid = sum(phase.duration for phase in motion.phases if phase.mode == "sliding")
    if kind == "throw":
        return landings >= 2
    if flies or slid < 0.1 * motion.end_time:
        return False
    return slips == 0 if kind == "slide" else slips >= 2


def good_track(seed: int, kind: str, number: int, fit: str) -> GoodTrack:
    """Draw a track of a kind for a fit."""
    random = np.random.default_rng([seed, KINDS.index(kind), list(FITS).index(fit), number])
    resists = fit == "estimated" and number % 4 != 0
    resistance = random.uniform(0.0, MOST) if resists else 0.0
    motion = next(one for one in random_motions(random, 0.0, resistance) if is_of(kind, one))
    rate, noise_m = (
        float(random.choice([60.0, 120.0, 240.0])),
        random.choice([0.001, 0.002]),
    )
    track = filmed(motion, rate, noise_m, random.choice([0.004, 0.008]), random)
    # What happens after the last frame was not filmed.
    seen = replace(motion.hoop, units=motion.hoop.units).simulate(
        **{name: getattr(motion.start, name) for name in ("theta", "theta_rate", "slip", "x")},
        until=float(track.time[-1]),
    )
    return GoodTrack(motion=seen, track=track, rate=rate, noise_m=noise_m)


def fitted(one: GoodTrack, free: tuple[str, ...]) -> lw.fitting.FitResult:
    """Fit a track as the command does that knows what is weighed and measured."""
    hoop = one.motion.hoop
    units = hoop.require_units()
    options = fit_command._parser().parse_args(
        [
            "track.csv",
            f"--disc-mass-kg={hoop.mass_ratio * units.mass_kg}",
            f"--particle-mass-kg={units.mass_kg}",
            f"--radius-m={units.length_m}",
            f"--offset-m={hoop.offset * units.length_m}",
            f"--slope={hoop.slope}",
            "--free",
            *free,
        ]
    )
    return fit_command._fit(options, one.track, fit_command._hoop_of(options), False)


def line_of(seed: int, kind: str, number: int, fit: str) -> list[str]:
    """Return the cells of a line: sequences, and the coefficients with their intervals."""
    one = good_track(seed, kind, number, fit)
    result = fitted(one, FITS[fit])
    true = one.motion.sequence
    cells = [kind, str(number), f"{one.rate:g}", f"{one.noise_m:g}", fit]
    cells += [true, result.motion.sequence, f"{result.sequences.get(true, 0.0):.3g}"]
    return cells + coefficients(one.motion.hoop, result)


def coefficients(hoop: lw.Hoop, result: lw.fitting.FitResult) -> list[str]:
    """Return the cells of all coefficients: truth, estimate, standard error."""
    cells = []
    for name in ALL:
        true, estimate = getattr(hoop, name), result.estimates.get(name)
        cells += [f"{true:.7g}"]
        cells += (
            ["", ""] if estimate is None else [f"{estimate.value:.7g}", f"{estimate.std_error:.4g}"]
        )
    return cells


def main() -> None:
    """Print the lines of the tracks that are asked for, of all kinds and fits in turn."""
    seed, first, last = map(int, sys.argv[1:4])
    warnings.simplefilter("ignore", lw.fitting.FitWarning)
    if first == 0:
        print(",".join(HEAD), flush=True)
    for number, kind, fit in itertools.product(range(first, last), KINDS, FITS):
        print(",".join(line_of(seed, kind, number, fit)), flush=True)


if __name__ == "__main__":
    main()
