"""A hoop and a start as they are given: every number is the exact value of its double."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from .checker import Refused, valid_case


class CaseError(ValueError):
    """A case that is not one.

    The message names the value and the bound, which are those of the checker.
    """


@dataclass(frozen=True)
class Exact:
    """The dimensionless numbers of a hoop, exactly."""

    mass_ratio: Fraction
    offset: Fraction
    inertia: Fraction
    mu_s: Fraction
    mu_k: Fraction
    rolling_resistance: Fraction


HOOP = ("mass_ratio", "offset", "inertia", "mu_s", "mu_k")
HOOP_SI = (
    "disc_mass_kg",
    "particle_mass_kg",
    "radius_m",
    "offset_m",
    "inertia_kg_m2",
    "mu_s",
    "mu_k",
    "gravity_m_per_s2",
)
ROLLING_RESISTANCE = {"dimensionless": "rolling_resistance", "si": "rolling_resistance_m"}
START = ("theta", "theta_rate", "slip", "gap_rate")
LAWS = ("energetic", "poisson", "newton")
SYSTEMS = tuple(ROLLING_RESISTANCE)


@dataclass(frozen=True)
class Case:
    """A hoop, a start and where to stop; in SI units all of it is."""

    hoop: tuple[float, ...]
    start: tuple[float, float, float, float]
    until: float | None = None
    restitution: float | None = None
    law: str = LAWS[0]
    name: str = "motion"
    family: str = ""
    units: str = SYSTEMS[0]
    slope: float = 0.0
    rolling_resistance: float = 0.0

    def __post_init__(self) -> None:
        try:
            valid_case(self.written())
        except Refused as refused:
            raise CaseError(str(refused)) from None

    def names(self) -> tuple[str, ...]:
        """Return the names of the numbers of the hoop."""
        return HOOP_SI if self.units == "si" else HOOP

    def dimensionless(self) -> Exact:
        """Return the numbers of the hoop."""
        given = [Fraction(value) for value in self.hoop]
        resistance = Fraction(self.rolling_resistance)
        if self.units != "si":
            return Exact(*[*given, resistance])
        disc, particle, radius, offset, inertia, mu_s, mu_k, _ = given
        return Exact(
            disc / particle,
            offset / radius,
            inertia / (particle * radius**2),
            mu_s,
            mu_k,
            resistance / radius,
        )

    def scales(self) -> tuple[Fraction, Fraction, Fraction]:
        """Return mass, length and gravity by which the numbers of the case are measured."""
        if self.units != "si":
            return Fraction(1), Fraction(1), Fraction(1)
        return Fraction(self.hoop[1]), Fraction(self.hoop[2]), Fraction(self.hoop[7])

    def written(self) -> dict[str, Any]:
        """Return the case for a certificate."""
        hoop: dict[str, Any] = dict(zip(self.names(), self.hoop, strict=True))
        if self.rolling_resistance != 0:
            hoop[ROLLING_RESISTANCE[self.units]] = self.rolling_resistance
        if self.slope != 0:
            hoop["slope"] = self.slope
        if self.restitution is not None:
            hoop |= {"restitution": self.restitution, "restitution_law": self.law}
        return {
            "name": self.name,
            "family": self.family,
            "units": self.units,
            "hoop": hoop,
            "start": dict(zip(START, self.start, strict=True)),
            "until": self.until,
        }

    @classmethod
    def read(cls, given: Mapping[str, Any]) -> Case:
        """Read a case as :meth:`written` has it."""
        hoop, start = given.get("hoop"), given.get("start")
        if isinstance(hoop, dict) and "restitution" in hoop:
            hoop = {"restitution_law": LAWS[0], **hoop}
        if isinstance(start, dict):
            start = {"gap_rate": 0.0, **start}
        rest = {key: value for key, value in given.items() if key not in ("hoop", "start")}
        whole: dict[str, Any] = {
            "name": "motion",
            "family": "",
            "units": SYSTEMS[0],
            "until": None,
            **rest,
        }
        whole |= {
            key: value for key, value in (("hoop", hoop), ("start", start)) if value is not None
        }
        try:
            valid_case(whole)
        except Refused as refused:
            raise CaseError(str(refused)) from None
        hoop, start, units = whole["hoop"], whole["start"], whole["units"]
        theta, rate, slip, gap_rate = (float(start[name]) for name in START)
        return cls(
            tuple(float(hoop[name]) for name in (HOOP_SI if units == "si" else HOOP)),
            (theta, rate, slip, gap_rate),
            None if whole["until"] is None else float(whole["until"]),
            None if "restitution" not in hoop else float(hoop["restitution"]),
            hoop.get("restitution_law", LAWS[0]),
            whole["name"],
            whole["family"],
            units,
            float(hoop.get("slope", 0.0)),
            float(hoop.get(ROLLING_RESISTANCE[units], 0.0)),
        )
