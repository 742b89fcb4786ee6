"""`python -m evidence.studies.film.coverage FIRST LAST [search]`: fits of synthetic tracks.

It prints a line of CSV for each.

Film number k is made with the seed k. With `search` a fit begins where the builder of the hoop
would, at many places, else at the truth. docs/studies/real-film/coverage.csv has the lines of 0 to
200 without it.
"""

from __future__ import annotations

import sys
import warnings

import littlewood as lw
import numpy as np

from .throws import FREE, SECONDS, Throw, throw

NOISE_M = 0.001
NOISE_RAD = 0.004
HEAD = [
    "film",
    "rate",
    "sequence_found",
    *(f"{name}_{what}" for name in FREE for what in ("true", "value", "error")),
]


def track_of(thrown: Throw, rate: float, random: np.random.Generator) -> lw.Track:
    """Return the track of a film with so many pictures a second.

    It is the exact motion with the noise of the tracker.
    """
    units = thrown.hoop.require_units()
    time = np.arange(round(SECONDS * rate)) / rate / units.time_s
    seen = thrown.motion(time)
    noise = random.normal(0.0, 1.0, (3, time.size))
    length = NOISE_M / units.length_m
    return lw.Track(
        time,
        theta=seen.theta + NOISE_RAD * noise[0],
        x=seen.x + length * noise[1],
        y=seen.centre_y + length * noise[2],
    )


def line_of(film: int, search: bool = False) -> list[str]:
    """Fit one film; infinite errors are those of coefficients that it does not tell."""
    random = np.random.default_rng([film, 9])
    thrown, rate = throw(random), (120.0, 240.0)[film % 2]
    track = track_of(thrown, rate, random)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", lw.fitting.FitWarning)
        result = lw.fit(
            track,
            thrown.guess if search else thrown.hoop,
            free=FREE,
            slips_at_start=thrown.slips,
            start=None if search else thrown.start,
            search=search,
        )
    return cells_of(film, rate, thrown, result)


def cells_of(film: int, rate: float, thrown: Throw, result: lw.FitResult) -> list[str]:
    """Return the cells of a line: truth, estimate and standard error of every coefficient."""
    cells = [str(film), f"{rate:g}", str(int(result.motion.sequence == thrown.motion.sequence))]
    for name in FREE:
        estimate = result.estimates[name]
        cells += [
            f"{getattr(thrown.hoop, name):.7g}",
            f"{estimate.value:.7g}",
            f"{estimate.std_error:.4g}",
        ]
    return cells


def main() -> None:
    """Print the lines of the films that are asked for."""
    first, last = map(int, sys.argv[1:3])
    search = sys.argv[3:] == ["search"]
    if first == 0:
        print(",".join(HEAD), flush=True)
    for film in range(first, last):
        print(",".join(line_of(film, search)), flush=True)


if __name__ == "__main__":
    main()
