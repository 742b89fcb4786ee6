"""A hoop and a start as they are given: every number is the exact value of its double."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any


class CaseError(ValueError):
    """A case that is not one: the message names the value, the bound and the unit."""


@dataclass(frozen=True)
class Exact:
    """The dimensionless numbers of a hoop, exactly."""

    mass_ratio: Fraction
    offset: Fraction
    inertia: Fraction
    mu_s: Fraction
    mu_k: Fraction


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
START = ("theta", "theta_rate", "slip", "gap_rate")
LAWS = ("energetic", "poisson", "newton")
SYSTEMS = ("dimensionless", "si")


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

    def __post_init__(self) -> None:
        if self.units not in SYSTEMS:
            raise CaseError(f"units = {self.units!r} must be one of {', '.join(SYSTEMS)}")
        named = dict(zip(self.names() + START, self.hoop + self.start, strict=True))
        for name, value in named.items():
            if not math.isfinite(value):
                raise CaseError(f"{name} = {value} must be finite")
        for name, value in named.items():
            if (name not in START and value < 0) or (name == "gap_rate" and value < 0):
                raise CaseError(f"{name} = {value} must not be negative")
        for name in ("particle_mass_kg", "radius_m", "gravity_m_per_s2"):
            if named.get(name) == 0:
                raise CaseError(f"{name} = 0 must be above 0")
        exact = self.dimensionless()
        if exact.offset > 1:
            raise CaseError(f"the offset is {float(exact.offset)} R and must be at most 1 R")
        if exact.mu_s < exact.mu_k:
            raise CaseError(f"mu_s = {named['mu_s']} must not be below mu_k = {named['mu_k']}")
        if (exact.mass_ratio == 0) != (exact.inertia == 0):
            raise CaseError("mass and inertia of the hoop must both be 0, or neither")
        if self.until is not None and not (math.isfinite(self.until) and self.until > 0):
            raise CaseError(f"until = {self.until} must be finite and above 0")
        if self.restitution is not None and not 0 <= self.restitution <= 1:
            raise CaseError(f"restitution = {self.restitution} must be from 0 to 1")
        if self.law not in LAWS:
            raise CaseError(f"restitution_law = {self.law!r} must be one of {', '.join(LAWS)}")

    def names(self) -> tuple[str, ...]:
        """Return the names of the numbers of the hoop."""
        return HOOP_SI if self.units == "si" else HOOP

    def dimensionless(self) -> Exact:
        """Return the numbers of the hoop."""
        given = [Fraction(value) for value in self.hoop]
        if self.units != "si":
            return Exact(*given)
        disc, particle, radius, offset, inertia, mu_s, mu_k, _ = given
        return Exact(disc / particle, offset / radius, inertia / (particle * radius**2), mu_s, mu_k)

    def scales(self) -> tuple[Fraction, Fraction, Fraction]:
        """Return mass, length and gravity by which the numbers of the case are measured."""
        if self.units != "si":
            return Fraction(1), Fraction(1), Fraction(1)
        return Fraction(self.hoop[1]), Fraction(self.hoop[2]), Fraction(self.hoop[7])

    def written(self) -> dict[str, Any]:
        """Return the case for a certificate."""
        hoop: dict[str, Any] = dict(zip(self.names(), self.hoop, strict=True))
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
        try:
            hoop, start = given["hoop"], given["start"]
            units = str(given.get("units", SYSTEMS[0]))
            names = HOOP_SI if units == "si" else HOOP
            theta, rate, slip = (float(start[name]) for name in START[:3])
            return cls(
                tuple(float(hoop[name]) for name in names),
                (theta, rate, slip, float(start.get("gap_rate", 0.0))),
                None if given.get("until") is None else float(given["until"]),
                None if hoop.get("restitution") is None else float(hoop["restitution"]),
                str(hoop.get("restitution_law", LAWS[0])),
                str(given.get("name", "motion")),
                str(given.get("family", "")),
                units,
            )
        except KeyError as error:
            raise CaseError(f"a case needs {error.args[0]}") from error
        except (TypeError, AttributeError) as error:
            raise CaseError(f"a case has a value of a wrong type: {error}") from error
