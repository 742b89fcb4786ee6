"""`python -m evidence.studies.film.resistance FIRST LAST [videos]`: hoops that lose by rolling.

It prints two lines of CSV for each track, of all kinds in turn, or with `videos` for each film: of
the fit that estimates rolling resistance, and of the one that holds it at 0.
docs/studies/measured-data/resistance.csv has those of 100 tracks of each kind, and
docs/studies/real-film/resistance.csv those of 12 films.

Every fourth hoop has no resistance. The fits begin at the truth.
"""

from __future__ import annotations

import csv
import math
import sys
import warnings
from dataclasses import replace
from pathlib import Path

import littlewood as lw
import numpy as np

from .command import (
    ALL,
    FITS,
    KINDS,
    MOST,
    GoodTrack,
    coefficients,
    filmed,
    is_of,
    random_motions,
)
from .videos import film_of, track_of

RATES = (30.0, 60.0, 120.0, 240.0)
NOISES_M = (0.0005, 0.001, 0.002, 0.003)
SEED = 54

HEAD = (
    "kind",
    "track",
    "rate",
    "noise_m",
    "fit",
    "phases",
    "found",
    "doubts",
    *(f"{name}_{what}" for name in ALL for what in ("true", "value", "error")),
)


def resistance_rows(folder: Path) -> list[dict[str, str]]:
    """Return the lines of a table of these fits, that of tracks or that of films."""
    with (folder / "resistance.csv").open(encoding="utf-8") as file:
        return list(csv.DictReader(file))


def resisted_track(kind: str, number: int) -> GoodTrack:
    """Draw a track of a kind."""
    random = np.random.default_rng([SEED, KINDS.index(kind), number])
    resistance = 0.0 if number % 4 == 0 else random.uniform(0.0, MOST)
    motion = next(one for one in random_motions(random, 0.0, resistance) if is_of(kind, one))
    rate, noise_m = float(random.choice(RATES)), float(random.choice(NOISES_M))
    track = filmed(motion, rate, noise_m, random.choice([0.004, 0.008]), random)
    return GoodTrack(motion=motion, track=track, rate=rate, noise_m=noise_m)


def filmed_track(number: int) -> GoodTrack:
    """Film and track a throw of the study of real films, by a hoop with resistance."""
    random = np.random.default_rng([SEED, number])
    resistance = 0.0 if number % 4 == 0 else random.uniform(0.0, MOST)
    film = film_of(number, rolling_resistance=resistance)
    noise_m = math.nan
    return GoodTrack(
        motion=film.thrown.motion, track=track_of(film), rate=film.rate, noise_m=noise_m
    )


def fitted(one: GoodTrack, free: tuple[str, ...]) -> lw.FitResult:
    """Fit a track from the truth on, but for a resistance that is not known."""
    start = one.motion.start
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", lw.fitting.FitWarning)
        return lw.fit(
            one.track,
            replace(one.motion.hoop, units=one.motion.hoop.units, rolling_resistance=0.0),
            free=free,
            slips_at_start=start.slip != 0.0,
            start={name: getattr(start, name) for name in ("theta", "theta_rate", "slip", "x")},
            search=False,
        )


def lines_of(kind: str, number: int) -> list[list[str]]:
    """Return the cells of the lines of a track, or of a film."""
    one = filmed_track(number) if kind == "video" else resisted_track(kind, number)
    lines = []
    for name, free in FITS.items():
        result = fitted(one, free)
        cells = [kind, str(number), f"{one.rate:g}", f"{one.noise_m:g}", name]
        cells += [one.motion.sequence, result.motion.sequence]
        cells += [" ".join(dict.fromkeys(doubt.name for doubt in result.doubts))]
        cells += coefficients(one.motion.hoop, result)
        lines.append(cells)
    return lines


def main() -> None:
    """Print the lines of the tracks that are asked for."""
    first, last = map(int, sys.argv[1:3])
    kinds = ("video",) if sys.argv[3:] == ["videos"] else KINDS
    if first == 0:
        print(",".join(HEAD), flush=True)
    for number in range(first, last):
        for kind in kinds:
            for cells in lines_of(kind, number):
                print(",".join(cells), flush=True)


if __name__ == "__main__":
    main()
