"""Writes resistance.json: random motions of each family, and periodic rotations down a slope.

python3 -m resistance [FAMILY ...]         with names of families prints their events only
"""

import json
import math
import sys
from pathlib import Path

from follower.arithmetic import FINEST, Tie, Work
from gmpy2 import mpfr

from .balances import Body, State, energy
from .downhill import rotation
from .families import FAMILIES, Draws
from .motion import follow
from .written import DIGITS, entry, text

FINE = (300, 42, 1e-42)  # bits, order of the series, error of a step
BOUNCES = (500, 42, 1e-42)  # of flights of 1e-36, whose gaps are differences
STEPS = 250
AGREE = mpfr("1e-33")  # largest difference from 60 digits; a motion with more is drawn again
ROTATIONS = 8


def moved(one, setting):
    Work.use(setting, STEPS)
    body = Body(*one.hoop)
    return body, follow(body, one.start, one.until, one.bounce)


def numbers(motion):
    """All numbers of a motion that are written."""
    rows = [*motion.transitions, motion]
    return [v for row in rows for v in (row.time, *row.state, *row.lost)]


def difference(a, b):
    """Largest difference between two motions, relative above 1; infinite if their events differ."""
    shapes = [(m.ended, [(t.cause, t.to) for t in m.transitions]) for m in (a, b)]
    if shapes[0] != shapes[1]:
        return mpfr("inf")
    return max(abs(p - q) / max(1, abs(p)) for p, q in zip(numbers(a), numbers(b)))


def unaccounted(one, body, motion):
    """Energy at the start, less that at the end, less what was lost: zero but for rounding.

    None in flight, whose gap is not kept.
    """
    begin = State(*map(mpfr, one.start[:3]), mpfr(0))
    if motion.ended == "time_limit" and motion.phases[-1].mode.name == "flight":
        return mpfr(0)
    closing = motion.transitions[-1].landing[0].opening if motion.ended == "landing" else 0
    spent = energy(body, begin, 0, mpfr(one.start[3])) - energy(body, motion.state, 0, closing)
    return abs(spent - sum(motion.lost))


def motions(name):
    """The motions of a family.

    With their largest difference from 60 digits and their energy that is not accounted for.
    """
    family, draws, found = FAMILIES[name], Draws(f"rolling resistance, {name}"), []
    while len(found) < family.count:
        one = family.draw(draws)
        setting = FINE if one.bounce is None else BOUNCES
        try:
            body, motion = moved(one, setting)
            if not family.belongs(motion):
                continue
            _, again = moved(one, (setting[0] + 100, *FINEST[1:]))
        except Tie:
            continue
        apart = difference(motion, again)
        if apart < AGREE:
            Work.use(setting, STEPS)
            found.append((one, body, motion, apart))
    return found


def rotations():
    """Periodic rotations, from where the first order in the resistance has them."""
    Work.use(FINE, STEPS)
    draws, found = Draws("rolling resistance, rotations"), []
    while len(found) < ROTATIONS:
        chi, share = draws.power(-2.5, -0.5), draws.number(0.2, 0.8)
        mass_ratio, offset, inertia, *_ = draws.hoop(chi)
        heading = draws.one_of(-1, 1)
        body = Body(mass_ratio, offset, inertia, 2.0, 2.0, chi)
        a = float(body.i + body.m * (1 + body.h**2))
        kappa = a / math.sqrt(a * a - 4 * offset * offset) - 1
        most = kappa * (a + 2 * offset) / (4 * float(body.m))
        ratio = 1 + most * (1 + share / float(body.h))
        slope = round(heading * math.atan(chi * ratio), 6)
        hoop = (mass_ratio, offset, inertia, 2.0, 2.0, chi, slope)
        try:
            one = rotation(Body(*hoop), share / float(body.h), heading)
        except Tie:
            continue
        found.append((hoop, one))
    return found


def main(chosen):
    entries, apart, missing = [], mpfr(0), mpfr(0)
    for name in chosen or FAMILIES:
        for one, body, motion, difference in motions(name):
            apart = max(apart, difference)
            missing = max(missing, unaccounted(one, body, motion))
            entries.append(entry(name, one, body, motion))
        causes = [e["ended"] for e in entries if e["family"] == name]
        print(f"{name}: {len(causes)} motions, {', '.join(sorted(set(causes)))}", flush=True)
    print(f"from 60 digits: {apart:.2g}; energy not accounted for: {missing:.2g}")
    if chosen:
        for row in entries:
            causes = [event["cause"] for event in row["transitions"]]
            print(row["family"], row["end"]["time"], *causes, row["ended"])
        return
    head = {
        "made_by": "resistance",
        "written_digits": DIGITS,
        "largest_difference_from_60_digits": f"{apart:.2g}",
        "largest_energy_not_accounted_for": f"{missing:.2g}",
    }
    turns = [
        {"hoop": hoop, **{name: text(v) for name, v in one._asdict().items()}}
        for hoop, one in rotations()
    ]
    lists = {"motions": entries, "rotations": turns}
    body = ",\n".join(
        f'"{name}": [\n' + ",\n".join(json.dumps(e) for e in rows) + "\n]"
        for name, rows in lists.items()
    )
    top = ",\n".join(f'"{k}": {json.dumps(v)}' for k, v in head.items())
    path = Path(__file__).parents[1] / "resistance.json"
    path.write_text("{" + top + ",\n" + body + "}\n", encoding="ascii")


if __name__ == "__main__":
    main(sys.argv[1:])
