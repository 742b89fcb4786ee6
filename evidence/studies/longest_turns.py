"""`python -m evidence.studies.longest_turns FAMILY SEED TURNS`: turns with many slides.

The search prints a line of CSV.

It draws starts, and moves those with the most slides by random steps of all sizes. FAMILY is
`shift` or `rim`. docs/studies/sequences/longest.csv has the lines of the seeds 1 to 8 with
1,000,000 turns each.
"""

from __future__ import annotations

import sys

import numpy as np

from .turns import Floats, first_turn, names_of, slides_of

EACH = 4000
"""Turns between two choices of those that are moved."""

KEPT = 3000
RANGES = {
    "shift": ((0.05, 0.02, -6.0), (0.75, 1.0, 0.3)),
    "rim": ((0.02, 0.02, -6.0), (0.98, 1.0, 0.3)),
}
"""Ends of γ, of ω₀√γ and of the decimal logarithm of μ."""


def search(family: str, seed: int, turns: int) -> list[int]:
    """Return how many turns have 0, 1, … 9 slides."""
    low, high = map(np.array, RANGES[family])
    random = np.random.default_rng(seed)
    kept, most = np.empty((0, 3)), np.empty(0, dtype=int)
    counts = np.zeros(10, dtype=int)
    for _ in range(turns // EACH):
        moved = _moved(kept, most, random, EACH * 2 // 3 if len(kept) else 0)
        drawn = random.uniform(low, high, (EACH - len(moved), 3))
        starts = np.clip(np.vstack([drawn, moved]), low, high)
        slides = np.array([slides_of(name) for name in _names(starts, rim=family == "rim")])
        counts += np.bincount(slides, minlength=10)
        kept, most = np.vstack([kept, starts]), np.concatenate([most, slides])
        order = random.permutation(len(kept))
        order = order[np.argsort(-most[order], kind="stable")][:KEPT]
        kept, most = kept[order], most[order]
    return counts.tolist()


def _names(starts: Floats, *, rim: bool) -> list[str]:
    """Return the sequences of turns, however many phases they have."""
    gamma, part, exponent = starts.T
    mu, rate = 10.0**exponent, part / np.sqrt(gamma)
    names: list[str] = names_of(gamma, mu, rate, rim=rim).tolist()
    for place in [k for k, name in enumerate(names) if name == "is given up"]:
        names[place] = first_turn(gamma[place], mu[place], rate[place], rim=rim).name
    return names


def _moved(kept: Floats, most: Floats, random: np.random.Generator, count: int) -> Floats:
    """Return starts near those that are kept, those with most slides most often."""
    if not count:
        return kept
    weight = 8.0 ** (most - most.max())
    chosen = kept[random.choice(len(kept), count, p=weight / weight.sum())]
    size = 10.0 ** random.uniform(-5.0, -1.0, (count, 1))
    return chosen + size * random.normal(0.0, 1.0, (count, 3)) * [0.3, 0.3, 1.0]


if __name__ == "__main__":
    name, seed, turns = sys.argv[1:]
    print(",".join(map(str, (name, seed, turns, *search(name, int(seed), int(turns))))))
