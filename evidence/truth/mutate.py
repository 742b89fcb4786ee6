"""Forges certificates, and says what the checker does not refuse.

    python3 mutate.py [NAME ...]

Of each kind of place in a certificate (a place without the numbers of phases, events and samples)
one digit, or one name, is changed; and phases, events, impacts, samples and names are deleted,
merged, split, exchanged, replaced and added, as well as the last bounces before a settlement given
to it. The digest is made to fit, so that nothing but the checker can tell. Each input is also
written in other ways that read as the same double. Names are those of files in certificates/, or
the beginnings of them; without any, the certificate of each family that is checked in the shortest
time, and four more that settle.
"""

from __future__ import annotations

import argparse
import copy
import json
import math
import random
import sys
import time
from collections.abc import Callable, Iterator
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import Any, TypeAlias

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE.parents[1] / "python" / "littlewood" / "certify"))
from checker import Refused, check, digest  # noqa: E402
from checker import read as parsed  # noqa: E402

SEED = 20261122

QUICK = (
    "bounces",
    "elastic-01",
    "elastic-settling-09",
    "jam-13",
    "landing-18",
    "leaves-at-once-01",
    "lift-off-03",
    "long-rolling-08",
    "massless-16",
    "near-tie-10",
    "paper-02",
    "ramp-jump-15",
    "ramp-rests-02",
    "ramp-rolling-16",
    "ramp-settles-08",
    "ramp-sliding-14",
    "rests-elastic-07",
    "rests-landing-14",
    "rests-massless-09",
    "rests-rolling-12",
    "rests-si-05",
    "rests-sliding-18",
    "reversal-chain-17",
    "settles-sliding-04",
    "settles-sticking-02",
    "si-01",
    "slide-roll-slip-18",
    "thrown-01",
)
"""Of each family the certificate that is checked in the shortest time."""

SETTLES = ("settles-sliding-02", "settles-sliding-12", "settles-sticking-01", "settles-sticking-04")
"""More that settle."""

NAMES = {
    "mode": ("rolling", "sliding", "flight", "skidding", "rest"),
    "to": ("rolling", "sliding", "flight", "skidding", "rest"),
    "cause": ("stick", "slip", "landing", "turning_point"),
    "case": ("slides", "sticks_in_compression"),
    "kind": ("landing", "time_limit", "rests"),
    "recurrence": ("libration", "rotation"),
    "direction": (-1, 0, 1),
    "rotation": (-1, 0, 1),
    "half_swings": (0, 1, 2),
}
"""What else a name may be replaced by."""

Place = tuple[Any, ...]


def places(value: Any, path: Place = ()) -> Iterator[Place]:
    """Yield the places of all numbers and names that a certificate states."""
    found = (
        value.items()
        if isinstance(value, dict)
        else enumerate(value)
        if isinstance(value, list)
        else ()
    )
    for key, one in found:
        if isinstance(one, list) and len(one) == 2 and all(isinstance(part, str) for part in one):
            yield from ((*path, key, part) for part in (0, 1))
        elif key in NAMES and not isinstance(one, dict):
            yield (*path, key)
        elif (*path, key) != ("case",):
            yield from places(one, (*path, key))


def kind(place: Place) -> str:
    """Return a place without numbers, but for 0 and 1 of midpoint and radius."""
    names = [str(key) for key in place if isinstance(key, str)]
    return ".".join(names) + (
        "" if isinstance(place[-1], str) else (" midpoint", " radius")[place[-1]]
    )


def changed(certificate: dict[str, Any], place: Place, rng: random.Random) -> dict[str, Any]:
    """Return a certificate with one digit, or one name, changed at a place.

    Its digest fits.
    """
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
    return sealed(found)


def sealed(certificate: dict[str, Any]) -> dict[str, Any]:
    """Return a certificate with the digest that fits."""
    return certificate | {"digest": digest(certificate)}


def mutations(
    certificate: dict[str, Any], seed: int = SEED
) -> Iterator[tuple[str, dict[str, Any]]]:
    """Yield for each kind in a certificate its name and a certificate that is changed there."""
    rng = random.Random(f"{seed} {certificate['case']['name']}")
    kinds: dict[str, list[Place]] = {}
    for place in places(certificate):
        kinds.setdefault(kind(place), []).append(place)
    for name, found in sorted(kinds.items()):
        yield name, changed(certificate, rng.choice(found), rng)


def lists(certificate: dict[str, Any]) -> Iterator[Place]:
    """Yield the places of lists of phases, events and samples."""
    yield from (("phases",), ("events",))
    yield from (("phases", k, "samples") for k in range(len(certificate["phases"])))


def objects(certificate: dict[str, Any]) -> Iterator[Place]:
    """Yield the places of objects, but for the case."""

    def within(value: Any, path: Place) -> Iterator[Place]:
        if isinstance(value, dict):
            yield path
        for key, one in (
            value.items()
            if isinstance(value, dict)
            else enumerate(value)
            if isinstance(value, list)
            else ()
        ):
            if (*path, key) != ("case",):
                yield from within(one, (*path, key))

    yield from within(certificate, ())


EACH = 12
"""Forgeries of a name in a certificate, at most."""

Change: TypeAlias = Callable[[dict[str, Any]], Any]


def structures(
    certificate: dict[str, Any], seed: int = SEED
) -> Iterator[tuple[str, dict[str, Any]]]:
    """Yield forgeries of structure: the name of each, and the certificate."""
    rng = random.Random(f"{seed} structure {certificate['case']['name']}")
    kinds: dict[str, list[Change]] = {}
    for name, change in changes(certificate, rng):
        kinds.setdefault(name, []).append(change)
    for name, found in kinds.items():
        for change in rng.sample(found, min(EACH, len(found))):
            one = json.loads(json.dumps(certificate))
            change(one)
            one = sealed(one) if "digest" in one else one
            if one != certificate:
                yield name, one


def changes(certificate: dict[str, Any], rng: random.Random) -> Iterator[tuple[str, Change]]:
    """Yield changes of structure with their names."""
    for bounces in behind_settle(certificate):
        yield "settle", lambda c, one=bounces: c.update(copy.deepcopy(one))
    for place in lists(certificate):
        parts, name = at(certificate, place), place[-1]
        for k in range(len(parts)):
            n = rng.randrange(len(parts))
            yield f"{name} deleted", lambda c, p=place, k=k: at(c, p).pop(k)
            yield f"{name} doubled", lambda c, p=place, k=k: at(c, p).insert(k, at(c, p)[k])
            yield (
                f"{name} replaced",
                lambda c, p=place, k=k, n=n: at(c, p).__setitem__(k, at(c, p)[n]),
            )
            yield f"{name} exchanged", lambda c, p=place, k=k, n=n: exchange(at(c, p), k, n)
        yield f"{name} reversed", lambda c, p=place: at(c, p).reverse()
        yield f"{name} emptied", lambda c, p=place: at(c, p).clear()
    for k in range(len(certificate["phases"])):
        yield "phase split", lambda c, k=k: split(c, k)
        if k < len(certificate["events"]):
            yield "phase and event deleted", lambda c, k=k: (c["phases"].pop(k), c["events"].pop(k))
        if k + 1 < len(certificate["phases"]):
            yield "phases merged", lambda c, k=k: merge(c, k)
    for place in objects(certificate):
        names = list(at(certificate, place))
        for key in names:
            yield f"{key} deleted", lambda c, p=place, key=key: at(c, p).pop(key)
            other = rng.choice(names)
            yield (
                "values exchanged",
                lambda c, p=place, key=key, n=other: exchange(at(c, p), key, n),
            )
        yield "a name added", lambda c, p=place: at(c, p).update(proof={})


def at(certificate: Any, place: Place) -> Any:
    """Return what is at a place."""
    for key in place:
        certificate = certificate[key]
    return certificate


def exchange(parts: Any, one: Any, other: Any) -> None:
    """Exchange two parts."""
    parts[one], parts[other] = parts[other], parts[one]


def split(certificate: dict[str, Any], k: int) -> None:
    """Split a phase in its middle, by an event with the state of a sample."""
    phase = certificate["phases"][k]
    samples = phase["samples"]
    half = len(samples) // 2
    certificate["phases"][k : k + 1] = [
        phase | {"samples": samples[:half]},
        phase | {"samples": samples[half:]},
    ]
    state = samples[half] if samples else certificate["end"].get("state", {})
    event = {
        "cause": "stick",
        "to": phase["mode"],
        "direction": phase["direction"],
        "state": state,
        "evidence": {},
    }
    certificate["events"].insert(k, event)


def merge(certificate: dict[str, Any], k: int) -> None:
    """Make one phase of two, without the event between them."""
    one, other = certificate["phases"][k : k + 2]
    certificate["phases"][k : k + 2] = [one | {"samples": one["samples"] + other["samples"]}]
    del certificate["events"][k]


def behind_settle(certificate: dict[str, Any]) -> Iterator[dict[str, Any]]:
    """Yield certificates whose settlement takes in some of the last bounces before it.

    Impulses and all.
    """
    for place, event in enumerate(certificate["events"]):
        first = place
        while (
            event["cause"] == "settle"
            and first > 0
            and certificate["events"][first - 1]["cause"] == "landing"
        ):
            first -= 1
            found = copy.deepcopy(certificate)
            # The first of them stays: the bounces after it are given to the settlement.
            given = found["events"][first + 1 : place]
            for name in ("normal_impulse", "friction_impulse", "energy_lost"):
                whole = sum(
                    (Fraction(one["impact"][name][0]) for one in [*given, found["events"][place]]),
                    Fraction(0),
                )
                found["events"][place]["impact"][name] = [f"{float(whole)!r}", "1e-17"]
            del found["events"][first + 1 : place], found["phases"][first + 1 : place]
            if given:
                yield found


def inputs(certificate: dict[str, Any]) -> Iterator[Place]:
    """Yield the places of all numbers of the case."""
    case = certificate["case"]
    for part in ("hoop", "start"):
        yield from (("case", part, key) for key in case[part] if key != "restitution_law")
    if case["until"] is not None:
        yield ("case", "until")


def spellings(value: float) -> dict[str, str]:
    """Return texts that read as a double, and are not its shortest: by what is wrong with them."""
    # The sum has 28 digits, and a thousandth of the last bit is seen in the twentieth.
    beside = Decimal(repr(value)) + Decimal(repr(math.ulp(value))) / 1000
    found = {"more digits": f"{value:.17e}", "another number": str(beside)}
    assert all(float(text) == value for text in found.values())
    return found


def texts(certificate: dict[str, Any]) -> Iterator[tuple[str, str]]:
    """Yield texts of a certificate in which an input is written in another way: the digest fits."""
    marker = "an input"
    for place in inputs(certificate):
        found = copy.deepcopy(certificate)
        at(found, place[:-1])[place[-1]] = marker
        for name, text in spellings(at(certificate, place)).items():
            yield f"{place[-1]}: {name}", json.dumps(found).replace(json.dumps(marker), text)


def accepted(certificate: dict[str, Any] | str) -> bool:
    """Whether the checker takes a certificate, or the text of one."""
    try:
        check(parsed(certificate) if isinstance(certificate, str) else certificate)
    except Refused:
        return False
    return True


def read(name: str) -> dict[str, Any]:
    """Read a certificate."""
    found: dict[str, Any] = json.loads(
        (HERE / "certificates" / f"{name}.json").read_text(encoding="utf-8")
    )
    return found


def main() -> int:
    """Change certificates, and check them."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument(
        "name", nargs="*", help="names, or beginnings of names; one of each family without any"
    )
    wanted = tuple(parser.parse_args().name)
    every = sorted(path.stem for path in (HERE / "certificates").glob("*.json"))
    tried = missed = 0
    began = time.perf_counter()
    for name in [one for one in every if one.startswith(wanted)] if wanted else QUICK + SETTLES:
        certificate = read(name)
        if not certificate["certified"]:
            continue
        found = [
            (what, accepted(one))
            for forge in (mutations, structures, texts)
            for what, one in forge(certificate)
        ]
        tried += len(found)
        missed += sum(taken for _, taken in found)
        print(
            f"{name:24} {len(found)} forgeries, not refused: "
            f"{[what for what, taken in found if taken]}",
            flush=True,
        )
    print(f"{tried} forgeries, {tried - missed} refused, {time.perf_counter() - began:.0f} s")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
