"""Derivatives of the first transitions of random motions, by central differences with 40 digits.

    python3 derivatives.py        writes derivatives.json beside this file

The package `follower` follows each motion with every quantity moved by 1e-13 to both sides, from
Newton-Euler alone: the differences have 25 digits. Quantities on whose two sides the motion differs
(a slip velocity of 0, the inertia of a massless hoop, equal coefficients of friction) are left out.

Needs gmpy2 and python-flint.
"""

import json
import math
import multiprocessing
import random
from pathlib import Path

from follower.arithmetic import FINE, Tie, Work
from follower.motion import NUMBERS, follow
from gmpy2 import mpfr

HOOP, START = (
    ("mass_ratio", "offset", "inertia", "mu_s", "mu_k", "slope"),
    ("theta", "theta_rate", "slip", "gap_rate"),
)
STEP = "1e-13"
KINDS = {"usual": 20, "slope": 14, "light": 8, "massless": 12, "bounces": 10}
LAWS = ("energetic", "poisson", "newton")
MOST = 5  # transitions of a motion


def drawn(kind, rng):
    """A hoop, a start, and a coefficient and law of restitution or none."""
    mass, inertia = rng.uniform(0, 3), rng.uniform(0.05, 3)
    if kind == "light":
        mass = inertia = 10 ** rng.uniform(-4, -1)
    if kind == "massless":
        mass = inertia = 0.0
    static = rng.uniform(0.05, 1.2)
    slope = (
        rng.uniform(-1.2, 1.2)
        if kind == "slope" or kind == "massless" and rng.random() < 0.3
        else 0.0
    )
    hoop = [
        mass,
        rng.choice([1.0, rng.uniform(0.1, 1)]),
        inertia,
        static,
        static * rng.random(),
        slope,
    ]
    slip = rng.choice([0.0, rng.uniform(-2, 2)])
    start = [rng.uniform(-math.pi, math.pi), rng.uniform(-2.5, 2.5), slip, 0.0]
    if kind == "bounces" and rng.random() < 0.5:
        start[3] = rng.uniform(0, 1)
    return hoop, start, [rng.uniform(0.1, 0.9), rng.choice(LAWS)] if kind == "bounces" else None


def events(hoop, start, bounce):
    try:
        return follow(hoop, start, 60.0, bounce=bounce, most=MOST)[1]
    except Tie as tie:
        # What had not yet been followed to its next motion is not known.
        return [event for event in tie.transitions[:-1] if event["to"] != "none"]
    except (ArithmeticError, ValueError):
        return []


def numbers_of(event, after):
    return [
        event.get("after", {}).get(name, event[name]) if after else event[name] for name in NUMBERS
    ]


def differentiated(problem):
    Work.use(FINE)
    kind, hoop, start, bounce = problem
    found = events(hoop, start, bounce)
    while found and any(not float("-inf") < v < float("inf") for v in numbers_of(found[-1], False)):
        found.pop()
    if not found:
        return None
    places = [(name, 0, i) for i, name in enumerate(HOOP)] + [
        (name, 1, i) for i, name in enumerate(START)
    ]
    if bounce:
        places.append(("restitution", 2, 0))
    rows = [{"cause": event["cause"], "before": {}, "after": {}} for event in found]
    for name, group, i in places:
        value = (hoop, start, bounce)[group][i]
        if (kind == "massless" and name in ("mass_ratio", "inertia")) or (
            name in ("slip", "gap_rate") and value == 0
        ):
            continue
        step = mpfr(STEP) * max(1, abs(value))
        sides = []
        for by in (step, -step):
            moved = [list(hoop), list(start), list(bounce) if bounce else None]
            moved[group][i] = mpfr(value) + by
            sides.append(events(*moved))
        for k, row in enumerate(rows):
            if min(map(len, sides)) <= k or any(side[k]["cause"] != row["cause"] for side in sides):
                return None
            for when in ("before", "after"):
                plus, minus = (numbers_of(side[k], when == "after") for side in sides)
                row[when][name] = [float((p - m) / (2 * step)) for p, m in zip(plus, minus)]
    hoops = dict(
        zip(HOOP, hoop), restitution=bounce and bounce[0], restitution_law=bounce and bounce[1]
    )
    return {"kind": kind, "hoop": hoops, "start": dict(zip(START, start)), "events": rows}


def main():
    rng, out = random.Random(36), []
    with multiprocessing.Pool() as pool:
        for kind, count in KINDS.items():
            problems = [(kind, *drawn(kind, rng)) for _ in range(2 * count)]
            found = [row for row in pool.imap(differentiated, problems, chunksize=1) if row]
            print(kind, len(found), "of", len(problems), flush=True)
            out += found[:count]
    head = {
        "made_by": "derivatives.py",
        "working_digits": 40,
        "step": float(STEP),
        "numbers": NUMBERS,
    }
    lines = ",\n".join(json.dumps(row) for row in out)
    text = json.dumps(head)[:-1] + ', "motions": [\n' + lines + "\n]}\n"
    Path(__file__).with_name("derivatives.json").write_text(text, encoding="ascii")


if __name__ == "__main__":
    main()
