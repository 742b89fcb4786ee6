"""The units of (2.9): SI value = dimensionless value times unit."""

from __future__ import annotations

from dataclasses import dataclass, fields

from . import _core
from ._internal.elementwise import real

__all__ = ["Units"]


@dataclass(frozen=True)
class Units:
    """Units in which a hoop measures: m2, R, √(R/g) and g in SI.

    Attributes
    ----------
    mass_kg : float
        Mass m2 of the particle, kg.
    length_m : float
        Radius R, m.
    time_s : float
        Time √(R/g), s.
    gravity_m_per_s2 : float
        Gravitational acceleration g, m/s².
    """

    mass_kg: float
    length_m: float
    time_s: float
    gravity_m_per_s2: float

    def __post_init__(self) -> None:
        for one in fields(self):
            object.__setattr__(self, one.name, real(getattr(self, one.name), one.name))

    @property
    def scales(self) -> tuple[float, float, float]:
        """m2, R and g in SI."""
        return (self.mass_kg, self.length_m, self.gravity_m_per_s2)

    @property
    def rate_rad_per_s(self) -> float:
        """Rate √(g/R), rad/s."""
        return _core.derived_units(self.scales)["rate_rad_per_s"]

    @property
    def velocity_m_per_s(self) -> float:
        """Velocity √(gR), m/s."""
        return _core.derived_units(self.scales)["velocity_m_per_s"]

    @property
    def force_n(self) -> float:
        """Force m2 g, N."""
        return _core.derived_units(self.scales)["force_n"]

    @property
    def energy_j(self) -> float:
        """Energy m2 g R, J."""
        return _core.derived_units(self.scales)["energy_j"]

    @property
    def inertia_kg_m2(self) -> float:
        """Moment of inertia m2 R², kg m²."""
        return _core.derived_units(self.scales)["inertia_kg_m2"]
