"""Instants of a motion, column by column."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _core
from ._internal.elementwise import flat
from .tables import MODE_CODES, MODES, SAMPLE_COLUMNS
from .units import Units

__all__ = ["Samples"]


# The code outside a motion is one less than the first of a mode.
_NAMES_BY_CODE: npt.NDArray[np.str_] = np.array(["", *MODES])


class Samples(Mapping[str, Any]):
    """Instants of a motion: a mapping from names to arrays, which are attributes as well.

    Attributes
    ----------
    mode : ndarray of int8
        Codes of the modes, places in :data:`littlewood.tables.MODES`; -1 outside the motion, and
        before a jam without a consistent motion.
    direction : ndarray of int8
        Sign of the slip velocity; 0 for rolling, rest and flight.
    time, theta, theta_rate, slip, x : ndarray
        State: √(R/g), rad, √(g/R), √(gR), R. In flight `slip` is that of a landing there.
    theta_acceleration, slip_acceleration : ndarray
        Accelerations θ″ in g/R and η″ in g.
    normal, friction : ndarray
        Contact forces N and F, m2 g.
    couple : ndarray
        Couple M of rolling resistance, m2 g R, positive as θ″ is.
    gap, gap_rate : ndarray
        Distance of the rim from the plane, R, and its rate, √(gR).
    energy : ndarray
        Total energy (2.8), m2 g R.
    centre_y, mass_centre_x, mass_centre_y, particle_x, particle_y : ndarray
        Positions, R; the geometric centre is at (`x`, `centre_y`).

    Notes
    -----
    All have the shape of the given times, and are NaN outside the motion.
    """

    def __init__(self, columns: Mapping[str, Any], shape: tuple[int, ...] | None = None) -> None:
        self._columns = (
            dict(columns)
            if shape is None
            else {name: a.reshape(shape)[()] for name, a in columns.items()}
        )

    def __getitem__(self, name: str) -> Any:
        return self._columns[name]

    def __getattr__(self, name: str) -> Any:
        # Only what is not found elsewhere comes here.
        if name.startswith("_"):
            raise AttributeError(name)
        if name not in self._columns:
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
        names: npt.NDArray[np.str_] = _NAMES_BY_CODE[np.asarray(self["mode"]) - _core.OUTSIDE]
        return names

    def is_in(self, mode: str) -> npt.NDArray[np.bool_]:
        """Return which instants are in this mode."""
        found: npt.NDArray[np.bool_] = np.asarray(self["mode"]) == MODE_CODES[mode]
        return found

    @property
    def is_outside(self) -> npt.NDArray[np.bool_]:
        """Which instants are outside the motion."""
        found: npt.NDArray[np.bool_] = np.asarray(self["mode"]) == _core.OUTSIDE
        return found

    def in_si(self, units: Units) -> dict[str, Any]:
        """Return the columns in SI units, each with its unit in its name.

        Parameters
        ----------
        units : Units
            Those of the hoop.

        Returns
        -------
        dict of str to ndarray
            Names as on the command line: `time_s`, `theta_rad`, …; `mode` and `direction` are
            unchanged.
        """
        columns: dict[str, Any] = {}
        for name, column in SAMPLE_COLUMNS.items():
            values = self[name]
            if column.si_name is None:
                columns[name] = values
            else:
                in_si = _core.sample_in_si(units.scales, name, flat(values))
                columns[column.si_name] = in_si.reshape(np.shape(values))[()]
        return columns
