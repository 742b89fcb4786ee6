"""Instants of a motion, column by column."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from .motion import MODES
from .units import Units

__all__ = ["COLUMNS", "Samples"]


class Column(NamedTuple):
    """What a column holds: in words, as a symbol, its unit, its SI name, and which of the units it is measured in."""

    long_name: str
    symbol: str
    unit: str
    si_name: str
    si_unit: str
    scale: str


COLUMNS: Mapping[str, Column] = {
    "time": Column("time", "τ", "sqrt(R/g)", "time_s", "s", "time_s"),
    "theta": Column("angle of the particle from the upward vertical", "θ", "rad", "theta_rad", "rad", ""),
    "theta_rate": Column("rate of the angle", "θ′", "sqrt(g/R)", "theta_rate_rad_per_s", "rad/s", "rate_rad_per_s"),
    "slip": Column("slip velocity of the contact point", "η′", "sqrt(g R)", "slip_m_per_s", "m/s", "velocity_m_per_s"),
    "x": Column("position of the geometric centre", "x", "R", "x_m", "m", "length_m"),
    "theta_acceleration": Column(
        "angular acceleration", "θ″", "g/R", "theta_acceleration_rad_per_s2", "rad/s^2", "rate_squared"
    ),
    "slip_acceleration": Column(
        "acceleration of the slip", "η″", "g", "slip_acceleration_m_per_s2", "m/s^2", "gravity_m_per_s2"
    ),
    "normal": Column("normal force", "N", "m2 g", "normal_n", "N", "force_n"),
    "friction": Column("friction force", "F", "m2 g", "friction_n", "N", "force_n"),
    "gap": Column("height of the lowest point of the rim", "gap", "R", "gap_m", "m", "length_m"),
    "gap_rate": Column("rate of the gap", "gap′", "sqrt(g R)", "gap_rate_m_per_s", "m/s", "velocity_m_per_s"),
    "energy": Column("total energy", "E", "m2 g R", "energy_j", "J", "energy_j"),
    "centre_y": Column("height of the geometric centre", "y", "R", "centre_y_m", "m", "length_m"),
    "mass_centre_x": Column("position of the mass centre", "x̄", "R", "mass_centre_x_m", "m", "length_m"),
    "mass_centre_y": Column("height of the mass centre", "ȳ", "R", "mass_centre_y_m", "m", "length_m"),
    "particle_x": Column("position of the particle", "x₂", "R", "particle_x_m", "m", "length_m"),
    "particle_y": Column("height of the particle", "y₂", "R", "particle_y_m", "m", "length_m"),
}
"""The real columns of :class:`Samples`."""


def _to_si(values: Any, scale: str, units: Units) -> Any:
    # Rates are divided by the time, as the core does it, so that the digits are the same.
    if scale == "rate_rad_per_s":
        return values / units.time_s
    if scale == "rate_squared":
        return values / (units.time_s * units.time_s)
    return values * getattr(units, scale) if scale else values


class Samples(Mapping[str, Any]):
    """Instants of a motion: a mapping from names to arrays, which are attributes as well.

    Attributes
    ----------
    mode : ndarray of int8
        Codes of the modes, places in :data:`littlewood.MODES`; -1 outside the motion.
    direction : ndarray of int8
        Sign of the slip velocity; 0 for rolling and flight.
    time, theta, theta_rate, slip, x : ndarray
        State: √(R/g), rad, √(g/R), √(gR), R. In flight `slip` is that of a landing there.
    theta_acceleration, slip_acceleration : ndarray
        Accelerations θ″ in g/R and η″ in g.
    normal, friction : ndarray
        Contact forces N and F, m2 g.
    gap, gap_rate : ndarray
        Height of the lowest point of the rim over the plane, R, and its rate, √(gR).
    energy : ndarray
        Total energy (2.8), m2 g R.
    centre_y, mass_centre_x, mass_centre_y, particle_x, particle_y : ndarray
        Positions, R; the geometric centre is at (`x`, `centre_y`).

    Notes
    -----
    All have the shape of the times that were asked for. Outside the motion they are NaN.
    """

    def __init__(self, columns: Mapping[str, Any], shape: tuple[int, ...] | None = None) -> None:
        self._columns = dict(columns) if shape is None else {name: a.reshape(shape)[()] for name, a in columns.items()}

    def __getitem__(self, name: str) -> Any:
        return self._columns[name]

    def __getattr__(self, name: str) -> Any:
        # Only what is not found elsewhere comes here.
        if name.startswith("_") or name not in self._columns:
            raise AttributeError(f"samples have no {name!r}; they have {', '.join(self)}")
        return self._columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._columns]

    def __repr__(self) -> str:
        return f"<Samples of {np.size(self['time'])} instants: {', '.join(self)}>"

    @property
    def mode_names(self) -> npt.NDArray[np.str_]:
        """Names of the modes; empty outside the motion."""
        names: npt.NDArray[np.str_] = np.array([*MODES, ""])[self["mode"]]
        return names

    def in_si(self, units: Units) -> dict[str, Any]:
        """Return the columns in SI units, each with its unit in its name.

        Parameters
        ----------
        units : Units
            Those of the hoop.

        Returns
        -------
        dict of str to ndarray
            The names are those of the command line: `time_s`, `theta_rad`, …; `mode` and `direction` are as they were.
        """
        columns: dict[str, Any] = {"mode": self["mode"], "direction": self["direction"]}
        for name, column in COLUMNS.items():
            columns[column.si_name] = _to_si(self[name], column.scale, units)
        return columns
