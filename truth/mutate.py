"""Changes one thing of each kind in certificates, and says what the checker does not refuse.

    python3 mutate.py [NAME ...]

A kind is a place in a certificate without the numbers of phases, events and samples: the midpoint of the gap rate after
an event, say. Of each kind in a certificate one number has one digit changed, or one name is replaced by another. The
digest is made to fit, so that nothing but the checker can tell. Names are those of files in certificates/, or the
beginnings of them; without any, the certificate of each family that is checked in the shortest time.
"""

from __future__ import annotations

import argparse
import copy
import hashlib
import json
import random
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from littlewood.certify import Refused, check

HERE = Path(__file__).parent
SEED = 20261122

QUICK = (
    "elastic-01", "jam-13", "landing-18", "leaves-at-once-01", "lift-off-03", "long-rolling-08", "massless-16",
    "near-tie-10", "paper-02", "reversal-chain-17", "settles-sliding-04", "settles-sticking-02", "si-01",
    "slide-roll-slip-18", "thrown-01",
)  # fmt: skip
"""Of each family the certificate that is checked in the shortest time."""

NAMES = {
    "mode": ("rolling", "sliding", "flight"),
    "to": ("rolling", "sliding", "flight"),
    "cause": ("stick", "slip", "landing"),
    "case": ("slides", "sticks_in_compression"),
    "kind": ("landing", "time_limit"),
    "recurrence": ("libration", "rotation"),
    "direction": (-1, 0, 1),
}
"""What else a name may be replaced by."""

Place = tuple[Any, ...]


def places(value: Any, path: Place = ()) -> Iterator[Place]:
    """Yield the places of all numbers and names that a certificate states."""
    found = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, one in found:
        if isinstance(one, list) and len(one) == 2 and all(isinstance(part, str) for part in one):
            yield from ((*path, key, part) for part in (0, 1))
        elif key in NAMES and not isinstance(one, dict):
            yield (*path, key)
        elif (*path, key) != ("case",) and key != "proof":
            yield from places(one, (*path, key))


def kind(place: Place) -> str:
    """Return a place without numbers, but for 0 and 1 of midpoint and radius."""
    names = [str(key) for key in place if isinstance(key, str)]
    return ".".join(names) + ("" if isinstance(place[-1], str) else (" midpoint", " radius")[place[-1]])


def changed(certificate: dict[str, Any], place: Place, rng: random.Random) -> dict[str, Any]:
    """Return a certificate with one digit, or one name, changed at a place, and a digest that fits."""
    found = copy.deepcopy(certificate)
    at = found
    for key in place[:-1]:
        at = at[key]
    old = at[place[-1]]
    if place[-1] in NAMES:
        at[place[-1]] = rng.choice([one for one in NAMES[place[-1]] if one != old])
    else:
        where = rng.choice([k for k, letter in enumerate(old) if letter.isdigit()])
        digit = rng.choice([one for one in "0123456789" if one != old[where]])
        at[place[-1]] = old[:where] + digit + old[where + 1 :]
    rest = {key: value for key, value in found.items() if key != "digest"}
    text = json.dumps(rest, sort_keys=True, separators=(",", ":"))
    return found | {"digest": hashlib.sha256(text.encode()).hexdigest()}


def mutations(certificate: dict[str, Any], seed: int = SEED) -> Iterator[tuple[str, dict[str, Any]]]:
    """Yield for each kind in a certificate its name and a certificate that is changed there."""
    rng = random.Random(f"{seed} {certificate['case']['name']}")
    kinds: dict[str, list[Place]] = {}
    for place in places(certificate):
        kinds.setdefault(kind(place), []).append(place)
    for name, found in sorted(kinds.items()):
        yield name, changed(certificate, rng.choice(found), rng)


def accepted(certificate: dict[str, Any]) -> bool:
    """Whether the checker takes a certificate."""
    try:
        check(certificate)
    except Refused:
        return False
    return True


def read(name: str) -> dict[str, Any]:
    """Read a certificate."""
    found: dict[str, Any] = json.loads((HERE / "certificates" / f"{name}.json").read_text(encoding="utf-8"))
    return found


def main() -> int:
    """Change certificates, and check them."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("name", nargs="*", help="names, or beginnings of names; one of each family without any")
    wanted = tuple(parser.parse_args().name)
    every = sorted(path.stem for path in (HERE / "certificates").glob("*.json"))
    tried = missed = 0
    for name in [one for one in every if one.startswith(wanted)] if wanted else QUICK:
        certificate = read(name)
        if not certificate["certified"]:
            continue
        found = [(what, accepted(one)) for what, one in mutations(certificate)]
        tried += len(found)
        missed += sum(taken for _, taken in found)
        print(f"{name:24} {len(found)} kinds, not refused: {[what for what, taken in found if taken]}", flush=True)
    print(f"{tried} changes, {tried - missed} refused")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
