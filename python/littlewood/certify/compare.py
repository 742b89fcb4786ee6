"""The library's doubles against the balls of a certificate."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from ..hoop import Hoop
from ..motion import Transition
from ..trajectory import Trajectory

QUANTITIES = ("time", "theta", "theta_rate", "slip", "x")


@dataclass(frozen=True)
class Difference:
    """By how much a double of the library is off, in units of 2^−52 of its size.

    Of 1 if it is smaller.
    """

    event: int
    cause: str
    quantity: str
    ulps: float


class OtherSequence(Exception):
    """The library has other events than the certificate."""


def simulated(case: Mapping[str, Any]) -> Trajectory:
    """Follow the motion of a case, as a certificate has it, with the library."""
    given, start = dict(case["hoop"]), case["start"]
    hoop = Hoop.from_si(**given) if case["units"] == "si" else Hoop(**given)
    clock, speed, _ = _scales(hoop)
    return hoop.simulate(
        theta=start["theta"],
        theta_rate=start["theta_rate"] * clock,
        slip=start["slip"] / speed,
        gap_rate=start["gap_rate"] / speed,
        until=None if case["until"] is None else case["until"] / clock,
    )


def _scales(hoop: Hoop) -> tuple[float, float, float]:
    """Units of time, velocity and length of the case of a hoop."""
    units = hoop.units
    return (
        (1.0, 1.0, 1.0) if units is None else (units.time_s, units.velocity_m_per_s, units.length_m)
    )


def differences(certificate: Mapping[str, Any]) -> list[Difference]:
    """Compare each number of the events of a certificate with those of the library.

    It must have the same events.
    """
    motion = simulated(certificate["case"])
    clock, speed, length = _scales(motion.hoop)
    scale = {"time": clock, "theta": 1.0, "theta_rate": 1 / clock, "slip": speed, "x": length}
    found = []
    for number, (event, mine) in enumerate(_pairs(certificate["events"], motion.transitions)):
        for name in QUANTITIES:
            if name not in event["state"]:
                # An infinite rate: the particle is at the plane.
                continue
            value = getattr(mine.after, name) * scale[name]
            true = Fraction(event["state"][name][0])
            unit = max(1.0, abs(value)) * 2.0**-52
            ulps = float(abs(Fraction(value) - true) / Fraction(unit))
            found.append(Difference(number, event["cause"], name, ulps))
    return found


def _pairs(
    events: list[Mapping[str, Any]], transitions: tuple[Transition, ...]
) -> Iterator[tuple[Mapping[str, Any], Transition]]:
    rest = list(transitions)
    for event in events:
        if event["cause"] == "settle":
            # The library follows more bounces one by one.
            while rest and rest[0].cause == "landing" and rest[0].to_mode == "flight":
                rest.pop(0)
        if not rest or rest[0].cause != event["cause"] or rest[0].to_mode != event["to"]:
            raise OtherSequence(
                f"{event['cause']} is {rest[0].cause if rest else 'no event'} for the library"
            )
        yield event, rest.pop(0)
    if rest:
        raise OtherSequence(f"the library has {len(rest)} more events")
