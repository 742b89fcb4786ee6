"""Which sets of modes are possible at random states: a table of docs/theory/rolling-resistance.md.

    python3 -m resistance.survey [STATES]     a minute for 200,000 states a row, in doubles

The five balances of `balances.py` are solved for each mode; margins within rounding do not occur at
random states.
"""

import itertools
import sys

import numpy as np

STATES = 200_000
NAMES = {(0, 0): "rest", (0, 1): "rolling", (1, 0): "skidding", (1, 1): "sliding"}


def draw(random, count, slope, slips, turns):
    """Bodies of every weight, with friction and resistance over the whole range, and states."""

    def power(low, high):
        return 10 ** random.uniform(low, high, count)

    mass_ratio = power(-4, 0.5)
    offset = np.where(random.random(count) < 0.5, 1, random.uniform(0.1, 1, count))
    mu_s = power(-1.5, 1)
    return {
        "m": 1 + mass_ratio,
        "h": offset / (1 + mass_ratio),
        "i": mass_ratio * random.uniform(0.05, 1, count)
        + mass_ratio * offset**2 / (1 + mass_ratio),
        "mu_s": mu_s,
        "mu_k": mu_s * np.where(random.random(count) < 0.5, 1, random.uniform(0.3, 1, count)),
        "chi": power(-2, 0.8),
        "slope": random.uniform(-1.3, 1.3, count) * slope,
        "theta": random.uniform(-np.pi, np.pi, count),
        "rate": random.normal(0, 1, count) * power(-0.5, 0.7) * turns,
        "slip": random.normal(0, 1, count) * slips,
    }


def solved(b, slips, turns):
    """(x'', theta'', N, F, K) of a mode, for all states."""
    s, c, count = np.sin(b["theta"]), np.cos(b["theta"]), len(b["m"])
    m, h, u = b["m"], b["h"], b["rate"] ** 2
    matrix, known = np.zeros((count, 5, 5)), np.zeros((count, 5))
    matrix[:, 0, 0], matrix[:, 0, 1], matrix[:, 0, 3] = m, -m * h * c, -1
    matrix[:, 1, 1], matrix[:, 1, 2] = -m * h * s, -1
    matrix[:, 2, 1], matrix[:, 2, 2], matrix[:, 2, 3], matrix[:, 2, 4] = (
        b["i"],
        -h * s,
        -1 - h * c,
        -1,
    )
    known[:, 0] = -m * (h * s * u + np.sin(b["slope"]))
    known[:, 1] = m * (h * c * u - np.cos(b["slope"]))
    matrix[:, 3] = [0, 0, 0, 1, 0] if slips else [1, 1, 0, 0, 0]
    matrix[:, 4] = [0, 0, 0, 0, 1] if turns else [0, 1, 0, 0, 0]
    if slips:
        matrix[:, 3, 2] = b["mu_k"] * slips
    if turns:
        matrix[:, 4, 2] = b["chi"] * turns
    return np.linalg.solve(matrix, known[:, :, None])[:, :, 0].T


def fits(b, slips, turns):
    along, turn, normal, friction, couple = solved(b, slips, turns)
    good = normal > 0
    good &= (
        np.where(b["slip"] == 0, slips * (along + turn) > 0, np.sign(b["slip"]) == slips)
        if slips
        else ((b["slip"] == 0) & (np.abs(friction) <= b["mu_s"] * normal))
    )
    good &= (
        np.where(b["rate"] == 0, turns * turn > 0, np.sign(b["rate"]) == turns)
        if turns
        else ((b["rate"] == 0) & (np.abs(couple) <= b["chi"] * normal))
    )
    return good


def sets(b):
    """Counts of the sets of modes that are possible where what is at rest stays so while it can."""
    found = {mode: fits(b, *mode) for mode in itertools.product((0, 1, -1), repeat=2)}
    flies = b["h"] * np.cos(b["theta"]) * b["rate"] ** 2 > np.cos(b["slope"])
    rests, rolls = found[0, 0], found[0, 1] | found[0, -1]
    skids = found[1, 0] | found[-1, 0]
    for mode in found:
        if mode != (0, 0):
            found[mode] &= ~rests
        if all(mode):
            found[mode] &= ~rolls & ~skids
    names = np.full(len(flies), "", dtype=object)
    for (slips, turns), here in found.items():
        names[here] += NAMES[slips != 0, turns != 0] + " "
    names[flies] += "flight "
    values, counts = np.unique(names.astype(str), return_counts=True)
    return {value.strip() or "none": int(n) for value, n in zip(values, counts)}


def main(states):
    random = np.random.default_rng(54)
    for slope, slips, turns in itertools.product((0, 1), repeat=3):
        plane = "slope" if slope else "level"
        spin = "turns" if turns else "does not turn"
        where = f"{plane}, {'slips' if slips else 'no slip'}, {spin}"
        found = sets(draw(random, states, slope, slips, turns))
        print(where, dict(sorted(found.items(), key=lambda one: -one[1])), flush=True)


if __name__ == "__main__":
    main(int(sys.argv[1]) if sys.argv[1:] else STATES)
