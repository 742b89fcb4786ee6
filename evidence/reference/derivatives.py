"""Derivatives of the first transitions of random motions, by central differences with 40 digits.

    python3 derivatives.py        writes derivatives.json beside this file

The package `follower` follows each motion with every quantity moved by 1e-13 to both sides, from
Newton-Euler alone: the differences have 25 digits. Those with rolling resistance are followed by
the package `resistance`, which draws them, too; some of them are drawn again without it, and have
the derivative by it from within. Quantities on whose two sides the motion differs (a slip velocity
of 0, the inertia of a massless hoop, equal coefficients of friction) are left out.

Needs gmpy2 and python-flint.
"""

import json
import math
import multiprocessing
import random
from itertools import islice
from pathlib import Path

from follower.arithmetic import FINE, Tie, Work
from follower.motion import NUMBERS, follow
from gmpy2 import mpfr
from resistance.balances import FLIGHT, Body
from resistance.families import FAMILIES, Draws
from resistance.motion import follow as follow_resisted

HOOP, START = (
    ("mass_ratio", "offset", "inertia", "mu_s", "mu_k", "slope"),
    ("theta", "theta_rate", "slip", "gap_rate"),
)
RESISTED_HOOP = (*HOOP[:5], "rolling_resistance", "slope")
RESISTANCE = 5  # place of the coefficient
SLOW = 1e-2  # rate of the gap, below which bounces are no events here
STEP = "1e-13"
KINDS = {"usual": 20, "slope": 14, "light": 8, "massless": 12, "bounces": 10}
RESISTED = {
    "librates": 4,
    "slips": 6,
    "lifts_off": 4,
    "skids": 5,
    "on_slopes": 5,
    "discs": 3,
    "impacts": 6,
    "massless": 5,
}
UNRESISTED = {"librates": 2, "slips": 3, "lifts_off": 2, "impacts": 3}
LAWS = ("energetic", "poisson", "newton")
MOST = 5  # transitions of a motion
UNTIL = 8.0  # with rolling resistance


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


def resisted(kind):
    """A hoop with rolling resistance, or one without it that is to be differentiated by it."""
    draws = Draws(f"derivatives, {kind}")
    while True:
        one = FAMILIES[kind.removeprefix("resisted ").removeprefix("unresisted ")].draw(draws)
        hoop, start = list(one.hoop), list(one.start)
        if kind.startswith("unresisted"):
            hoop[RESISTANCE] = 0.0
        yield kind, hoop, start, one.bounce and list(one.bounce)


def resisted_events(hoop, start, bounce, turns):
    """The first transitions, as those of `events`; turning points only if they count."""
    try:
        motion = follow_resisted(Body(*hoop), start, UNTIL, bounce)
    except (Tie, ArithmeticError, ValueError):
        return []
    found = []
    for row in motion.transitions:
        if row.to is None and row.cause != "landing":
            break
        if row.cause == "turning" and not turns:
            continue
        cause = "turning_point" if row.cause == "turning" else row.cause
        place = dict(zip(("theta", "theta_rate", "slip", "x"), row.state))
        event = {"cause": cause, "time": row.time, **place}
        if row.landing and row.landing[1]:
            after = row.landing[1].after
            event["after"] = {"theta_rate": after.rate, "slip": after.slip}
            if row.to is FLIGHT and after.opening < SLOW:
                break
        found.append(event)
    return found[:MOST]


def events(hoop, start, bounce, turns=True):
    if len(hoop) > len(HOOP):
        return resisted_events(hoop, start, bounce, turns)
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
    has_resistance = len(hoop) > len(HOOP)
    names = RESISTED_HOOP if has_resistance else HOOP
    turns = not has_resistance or hoop[RESISTANCE] > 0
    found = events(hoop, start, bounce, turns)
    while found and any(not float("-inf") < v < float("inf") for v in numbers_of(found[-1], False)):
        found.pop()
    if not found:
        return None
    places = [(name, 0, i) for i, name in enumerate(names)] + [
        (name, 1, i) for i, name in enumerate(START)
    ]
    if not turns:
        places = [("rolling_resistance", 0, RESISTANCE)]
    elif bounce and bounce[0] > 0:
        places.append(("restitution", 2, 0))
    rows = [{"cause": event["cause"], "before": {}, "after": {}} for event in found]
    for name, group, i in places:
        value = (hoop, start, bounce)[group][i]
        if (
            (kind.endswith("massless") and name in ("mass_ratio", "inertia"))
            or (name in ("slip", "gap_rate") and value == 0)
            or (has_resistance and name in ("theta_rate", "offset") and value == 0)
            or (has_resistance and name in ("mu_s", "mu_k") and hoop[3] == hoop[4])
        ):
            continue
        step = mpfr(STEP) * max(1, abs(value))
        sides = []
        # From within, the third point is the motion itself.
        for by in (step, -step) if turns else (2 * step, step):
            moved = [list(hoop), list(start), list(bounce) if bounce else None]
            moved[group][i] = mpfr(value) + by
            sides.append(events(*moved, turns))
        for k, row in enumerate(rows):
            if min(map(len, sides)) <= k or any(side[k]["cause"] != row["cause"] for side in sides):
                return None
            for when in ("before", "after"):
                plus, minus = (numbers_of(side[k], when == "after") for side in sides)
                if turns:
                    slopes = [(p - m) / (2 * step) for p, m in zip(plus, minus)]
                else:
                    its = numbers_of(found[k], when == "after")
                    slopes = [(4 * m - p - 3 * v) / (2 * step) for p, m, v in zip(plus, minus, its)]
                row[when][name] = [float(slope) for slope in slopes]
    hoops = dict(
        zip(names, hoop), restitution=bounce and bounce[0], restitution_law=bounce and bounce[1]
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
        for prefix, counts in (("resisted", RESISTED), ("unresisted", UNRESISTED)):
            for family, count in counts.items():
                problems = list(islice(resisted(f"{prefix} {family}"), 2 * count))
                found = [row for row in pool.imap(differentiated, problems, chunksize=1) if row]
                print(prefix, family, len(found), "of", len(problems), flush=True)
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
