"""`python -m evidence.studies.film.clocks FIRST LAST`: throws with a clock that is 4 % off.

It prints a line of CSV for each; docs/studies/measured-data/clocks.csv has the first.

Each is fitted as the command does, from a guess that knows nothing of friction, unless its flights
name the clock before. The standard error of the clock is that of a fit of the same track with the
right one, from the truth, that estimates it: no test can do better.
"""

from __future__ import annotations

import sys
import warnings
from dataclasses import replace

import littlewood as lw
import numpy as np
from littlewood.fitting.fall import fall_of

from .command import GoodTrack, filmed, fitted
from .faults import CAUSES
from .throws import FREE, throw

SEED = 9
"""No track of this seed was seen before the limits were set."""
RATES = (24.0, 30.0, 60.0, 120.0, 240.0)
OFF = 0.04
"""By which part a clock is wrong."""

HEAD = (
    "throw",
    "rate",
    "noise_m",
    "factor",
    "clock_error",
    "gravity",
    "gravity_error",
    "by_flights",
    "doubts",
    "named",
)


def told(track: lw.Track, motion: lw.Trajectory) -> float:
    """Return how well a track tells its clock: the standard error where all else is estimated."""
    start = motion.start
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", lw.fitting.FitWarning)
        result = lw.fit(
            track,
            motion.hoop,
            free=FREE,
            slips_at_start=start.slip != 0.0,
            start={name: getattr(start, name) for name in ("theta", "theta_rate", "slip", "x")},
            search=False,
        )
    freed = result._problem.freed("clock")
    values = result._problem.values(result._unknowns)
    best = freed.refine(freed.unknowns_of(values), "linear")
    return freed.estimate_of("clock", best).std_error


def line_of(number: int) -> list[str]:
    """Return the cells of a line: what the track can tell, and what names its clock."""
    random = np.random.default_rng([SEED, number])
    motion = throw(random).motion
    rate, noise_m = RATES[number % len(RATES)], random.uniform(0.001, 0.003)
    good = filmed(motion, rate, noise_m, 0.004, random)
    factor = 1.0 + OFF * random.choice([-1.0, 1.0])
    track = replace(good, time=factor * good.time)
    fall = fall_of(track, motion.hoop)
    is_wrong = fall is not None and fall.is_wrong
    cells = [str(number), f"{rate:g}", f"{noise_m:.3g}", f"{factor:g}"]
    cells.append(f"{told(good, motion):.3g}")
    cells += ["", ""] if fall is None else [f"{fall.gravity:.4g}", f"{fall.std_error:.3g}"]
    if is_wrong:
        return [*cells, "1", "", ""]
    one = GoodTrack(motion=motion, track=track, rate=rate, noise_m=noise_m)
    doubts = fitted(one, FREE).doubts
    causes = [name for doubt in doubts if doubt.name in CAUSES for name in doubt.parameters]
    names = (" ".join(dict.fromkeys(one)) for one in ([doubt.name for doubt in doubts], causes))
    return [*cells, "0", *names]


def main() -> None:
    """Print the lines of the throws that are asked for."""
    first, last = map(int, sys.argv[1:3])
    warnings.simplefilter("ignore", lw.fitting.FitWarning)
    if first == 0:
        print(",".join(HEAD), flush=True)
    for number in range(first, last):
        print(",".join(line_of(number)), flush=True)


if __name__ == "__main__":
    main()
