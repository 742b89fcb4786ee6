"""The follower against the certified motions, 30 digits with a radius, made by ball arithmetic.

Run it as python3 -m accuracy.certificates.
"""

import json
import sys
from pathlib import Path

import gmpy2
from follower.arithmetic import FINEST, Tie, Work
from follower.motion import NUMBERS, follow
from gmpy2 import mpfr

CERTIFICATES = Path(__file__).parents[2] / "truth" / "certificates"
MOST = 60  # events of a motion
HOOP, START = (
    ("mass_ratio", "offset", "inertia", "mu_s", "mu_k"),
    ("theta", "theta_rate", "slip", "gap_rate"),
)


def events(case):
    """The events of a case without units."""
    hoop, start = case["hoop"], case["start"]
    bounce = (
        (hoop["restitution"], hoop.get("restitution_law") or "energetic")
        if hoop.get("restitution") is not None
        else None
    )
    try:
        return follow(
            [hoop[k] for k in HOOP],
            [start[k] for k in START],
            case["until"] or 2.0**100,
            None,
            bounce,
            MOST,
        )[1]
    except Tie as tie:
        return tie.transitions


def differences(certificate):
    """(compared, differing) numbers; a sequence of its own is one that differs."""
    compared, differing = 0, 0
    for mine, theirs in zip(events(certificate["case"]), certificate["events"]):
        if theirs["cause"] == "settle":
            break
        if mine["cause"] != theirs["cause"]:
            return compared, differing + 1
        for name in NUMBERS:
            number, exact = {**mine, **mine.get("after", {})}[name], theirs["state"].get(name)
            if gmpy2.is_finite(number) and exact is not None:
                compared += 1
                # A zero by definition may be a root to 60 digits.
                differing += abs(number - mpfr(exact[0])) > mpfr(exact[1]) * 1.001 + 1e-50
    return compared, differing


def main():
    Work.use(FINEST, 400)
    motions, compared, differing = 0, 0, 0
    for path in sorted(CERTIFICATES.glob("*.json")):
        certificate = json.loads(path.read_text(encoding="utf-8"))
        case = certificate["case"]
        # `resistance` is the program for rolling resistance.
        given = case["units"] == "dimensionless" and "rolling_resistance" not in case["hoop"]
        if given and certificate["certified"]:
            some, other = differences(certificate)
            if other:
                print(path.stem, other)
            motions, compared, differing = motions + 1, compared + some, differing + other
    print(f"{motions} motions, {compared} numbers, {differing} differ")
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
