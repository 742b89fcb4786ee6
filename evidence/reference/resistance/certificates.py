"""This program against the certified motions with rolling resistance, 30 digits with a radius.

Run it as python3 -m resistance.certificates.
"""

import json
import sys
from pathlib import Path

from follower.arithmetic import FINEST, Work
from gmpy2 import mpfr

from .balances import Body
from .motion import follow

CERTIFICATES = Path(__file__).parents[2] / "truth" / "certificates"
STEPS = 400
HOOP = ("mass_ratio", "offset", "inertia", "mu_s", "mu_k", "rolling_resistance", "slope")
START = ("theta", "theta_rate", "slip", "gap_rate")
NAMES = {"turning": "turning_point"}
FOR_EVER = 1e6  # where a motion without a time limit would be stopped; all rest before


def followed(case):
    """The motion of a case."""
    hoop, start = {"slope": 0.0, **case["hoop"]}, case["start"]
    bounce = (hoop["restitution"], hoop["restitution_law"]) if "restitution" in hoop else None
    body = Body(*(hoop[name] for name in HOOP))
    return follow(body, [start[name] for name in START], case["until"] or FOR_EVER, bounce)


def numbers(row):
    """The numbers of a transition as a certificate has them: after an impact."""
    reached = row.landing[1].after if row.landing and row.landing[1] else row.state
    return {
        "time": row.time,
        "theta": row.state.theta,
        "theta_rate": reached.rate,
        "slip": reached.slip,
        "x": row.state.x,
    }


def differences(certificate):
    """(compared, differing) numbers; a sequence of its own is one that differs."""
    motion, events = followed(certificate["case"]), certificate["events"]
    mine = [(NAMES.get(row.cause, row.cause), row.to and row.to.name) for row in motion.transitions]
    if mine != [(event["cause"], event["to"]) for event in events]:
        return 0, 1
    if motion.ended != certificate["end"]["kind"]:
        return 0, 1
    energy, lost = certificate["energy"], motion.lost
    pairs = [
        (number, event["state"][name])
        for row, event in zip(motion.transitions, events)
        for name, number in numbers(row).items()
    ]
    if not any("impact" in event for event in events):
        pairs.append((lost.resistance, energy["lost_in_rolling_resistance"]))
        pairs.append((lost.sliding, energy["lost_in_slides"]))
    # A zero by definition may be a root to 60 digits.
    apart = (abs(one - mpfr(ball[0])) > mpfr(ball[1]) * 1.001 + 1e-50 for one, ball in pairs)
    return len(pairs), sum(apart)


def main():
    Work.use(FINEST, STEPS)
    motions = compared = differing = 0
    for path in sorted(CERTIFICATES.glob("*.json")):
        certificate = json.loads(path.read_text(encoding="utf-8"))
        if "rolling_resistance" in certificate["case"]["hoop"]:
            some, other = differences(certificate)
            if other:
                print(path.stem, other)
            motions, compared, differing = motions + 1, compared + some, differing + other
    print(f"{motions} motions, {compared} numbers, {differing} differ")
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
