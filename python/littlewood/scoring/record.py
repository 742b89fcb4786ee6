"""The motion computed by a solver: times, positions of the centre, the angle."""

from __future__ import annotations

import difflib
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from .._internal.elementwise import Reals, reals
from .._internal.table_layouts import read_text_table
from .._internal.text_table import TableFileError, TextTable

if TYPE_CHECKING:
    from ..units import Units

__all__ = ["Record", "read_table"]


_FEWEST = 3
"""Instants from which velocities can be told."""

_COLUMNS = ("time", "x", "y", "theta")
_SI_COLUMNS = ("time_s", "x_m", "y_m", "theta_rad")
RATES = ("x_rate", "y_rate", "theta_rate")
_SI_RATES = ("x_rate_m_per_s", "y_rate_m_per_s", "theta_rate_rad_per_s")
_CONTACT = "contact"
_ALSO = {"centre_y": "y", "centre_y_m": "y_m"}
"""Names that `littlewood simulate --format csv` gives columns."""


@dataclass(frozen=True, eq=False)
class Record:
    """The motion computed by a solver, dimensionless.

    Parameters
    ----------
    time : array_like
        Times τ, √(R/g), of shape (n,), growing, at least three.
    x : array_like
        Position of the geometric centre along the plane, to the right, R, shape (n,).
    y : array_like
        Distance of the geometric centre from the plane, R, shape (n,): 1 in contact.
    theta : array_like
        Angle θ of the particle from the normal of the plane, counterclockwise, rad, shape (n,). A
        turn is 2π more.
    contact : array_like of bool, optional
        Whether the solver says that the rim touches the plane, shape (n,). Without it the height
        decides.
    x_rate, y_rate, theta_rate : array_like, optional
        The solver's velocities x′, y′, √(gR), and θ′, √(g/R), all three, shape (n,). Without them
        velocities are differences of positions.

    Raises
    ------
    ValueError
        If a value is not finite, times do not grow, or shapes differ.
    """

    time: Reals
    x: Reals
    y: Reals
    theta: Reals
    contact: npt.NDArray[np.bool_] | None = None
    x_rate: Reals | None = None
    y_rate: Reals | None = None
    theta_rate: Reals | None = None

    def __post_init__(self) -> None:
        given = [name for name in RATES if getattr(self, name) is not None]
        if 0 < len(given) < len(RATES):
            raise ValueError(
                f"{', '.join(given)} without the others: the rates are {', '.join(RATES)}, or none"
            )
        for name in (*_COLUMNS, *given):
            object.__setattr__(self, name, np.array(reals(getattr(self, name), name)))
        if self.contact is not None:
            object.__setattr__(self, _CONTACT, np.array(self.contact, dtype=np.bool_))
        if self.time.ndim != 1 or self.time.size < _FEWEST:
            raise ValueError(
                f"time has shape {self.time.shape}: a record needs at least {_FEWEST} instants"
            )
        for name in (*_COLUMNS, *given, *([_CONTACT] if self.contact is not None else [])):
            values = getattr(self, name)
            if values.shape != self.time.shape:
                raise ValueError(
                    f"{name} has shape {values.shape}, time has {self.time.shape}: they must be "
                    f"the same"
                )
            bad = np.flatnonzero(~np.isfinite(values))
            if bad.size:
                raise ValueError(f"{name}[{bad[0]}] = {values[bad[0]]} must be finite")
        falls = np.flatnonzero(np.diff(self.time) <= 0.0)
        if falls.size:
            i = int(falls[0])
            raise ValueError(
                f"time[{i + 1}] = {self.time[i + 1]} must be greater than time[{i}] = "
                f"{self.time[i]} sqrt(R/g)"
            )

    @property
    def step(self) -> float:
        """Median distance of two instants, √(R/g)."""
        return float(np.median(np.diff(self.time)))

    @property
    def rates(self) -> tuple[Reals, Reals, Reals] | None:
        """x′, y′ and θ′, if the solver has given them."""
        if self.x_rate is None or self.y_rate is None or self.theta_rate is None:
            return None
        return self.x_rate, self.y_rate, self.theta_rate

    @property
    def slip_between(self) -> Reals:
        """Slip velocity in the middle of two instants, √(gR)."""
        if self.rates is None:
            slip: Reals = np.diff(self.x + self.theta) / np.diff(self.time)
            return slip
        at = self.rates[0] + self.rates[2]
        return 0.5 * (at[1:] + at[:-1])

    def kept(self, which: npt.NDArray[np.bool_]) -> Record:
        """Return some of the instants."""
        columns: dict[str, Any] = {
            name: getattr(self, name) for name in (*_COLUMNS, _CONTACT, *RATES)
        }
        parts: dict[str, Any] = {
            name: None if all_ is None else all_[which] for name, all_ in columns.items()
        }
        return Record(**parts)

    @classmethod
    def from_si(
        cls,
        units: Units,
        *,
        time_s: npt.ArrayLike,
        x_m: npt.ArrayLike,
        y_m: npt.ArrayLike,
        theta_rad: npt.ArrayLike,
        contact: npt.ArrayLike | None = None,
        x_rate_m_per_s: npt.ArrayLike | None = None,
        y_rate_m_per_s: npt.ArrayLike | None = None,
        theta_rate_rad_per_s: npt.ArrayLike | None = None,
    ) -> Record:
        """Make a record from SI units.

        Parameters
        ----------
        units : Units
            Those of the hoop, `hoop.units`.
        time_s, x_m, y_m, theta_rad : array_like
            As those of :class:`Record`, in s, m, m and rad.
        contact : array_like of bool, optional
            As that of :class:`Record`.
        x_rate_m_per_s, y_rate_m_per_s, theta_rate_rad_per_s : array_like, optional
            As the rates of :class:`Record`, in m/s, m/s and rad/s.

        Returns
        -------
        Record
        """

        def over(values: npt.ArrayLike | None, unit: float) -> Reals | None:
            return None if values is None else reals(values) / unit

        return cls(
            reals(time_s) / units.time_s,
            reals(x_m) / units.length_m,
            reals(y_m) / units.length_m,
            reals(theta_rad),
            None if contact is None else np.asarray(contact, dtype=np.bool_),
            over(x_rate_m_per_s, units.velocity_m_per_s),
            over(y_rate_m_per_s, units.velocity_m_per_s),
            over(theta_rate_rad_per_s, 1.0 / units.time_s),
        )

    @classmethod
    def from_csv(cls, path: str | Path, units: Units | None = None) -> Record:
        """Read a record from a table with a line of names.

        Parameters
        ----------
        path : str or Path
            The file. Its columns are `time`, `x`, `y`, `theta`, or in SI units `time_s`, `x_m`,
            `y_m`, `theta_rad`; `contact`, 0 or 1, and the rates of :class:`Record` may be there;
            others are passed over. `y` may be called `centre_y`, as by ``littlewood simulate
            --format csv``.
        units : Units, optional
            Those of the hoop; SI columns need them.

        Returns
        -------
        Record

        Raises
        ------
        TableFileError
            With the line and the column that cannot be read.
        """
        columns: dict[str, Any] = read_table(
            path, lambda table, names: _wanted(table, names, units)
        )
        if _CONTACT in columns:
            columns[_CONTACT] = columns[_CONTACT] == 1.0
        return (
            cls(**columns) if "time" in columns or units is None else cls.from_si(units, **columns)
        )


def read_table(
    path: str | Path, wanted_of: Callable[[TextTable, list[str]], Sequence[str]]
) -> dict[str, Reals]:
    """Return columns of a table by name; `wanted_of` chooses from its names."""
    table = read_text_table(path)
    names = [_ALSO.get(name, name) for name in table.names]
    twice = next((name for name in names if names.count(name) > 1), None)
    if twice is not None:
        raise table.refusal("occurs twice", column=twice)
    wanted = wanted_of(table, names)
    missing = next((name for name in wanted if name not in names), None)
    if missing is not None:
        reason = f"is missing among {', '.join(names)}"
        raise table.refusal(reason, column=missing, hint=_hint(missing, names))
    places = {name: names.index(name) for name in wanted}
    time = places[wanted[0]]
    if "event" in names:
        # `littlewood simulate` gives both sides of an event.
        rows = enumerate(table.rows)
        table = table.with_rows(
            [k for k, row in rows if k == 0 or row[time] != table.rows[k - 1][time]]
        )
    columns = {name: np.array(table.numbers(place, True)) for name, place in places.items()}
    table.check_growing(time, columns[wanted[0]].tolist())
    odd = np.flatnonzero(~np.isin(columns.get(_CONTACT, 0.0), (0.0, 1.0)))
    if odd.size:
        cell = table.rows[odd[0]][places[_CONTACT]]
        raise TableFileError(
            table.path, "must be 0 or 1", line=table.lines[odd[0]], column=_CONTACT, value=cell
        )
    if len(table.rows) < _FEWEST:
        raise TableFileError(
            table.path, f"has {len(table.rows)} instants: a record needs at least {_FEWEST}"
        )
    return columns


def _wanted(table: TextTable, names: list[str], units: Units | None) -> list[str]:
    """Names of the columns that are read."""
    has_plain = [name for name in _COLUMNS if name in names]
    has_si = [name for name in _SI_COLUMNS if name in names]
    if set(has_plain) == set(_COLUMNS):
        # A motion of `littlewood simulate` has columns of both kinds.
        has_si = []
    if has_plain and has_si:
        reason = f"is in SI units, {has_plain[0]} has no dimension"
        hint = "all must be of one kind"
        raise table.refusal(reason, column=has_si[0], hint=hint)
    if has_si and units is None:
        hint = f"a hoop with units reads it; for this one write {','.join(_COLUMNS)}"
        raise table.refusal("is in SI units, and the hoop has none", column=has_si[0], hint=hint)
    rates = _SI_RATES if has_si else RATES
    wanted = [
        *(_SI_COLUMNS if has_si else _COLUMNS),
        *(rates if any(name in names for name in rates[:2]) else ()),
    ]
    return [*wanted, *([_CONTACT] if _CONTACT in names else [])]


def _hint(missing: str, names: list[str]) -> str | None:
    """Which of the names may be meant."""
    by_lower = {name.lower(): name for name in names}
    likely = [name for name in names if name and missing.startswith(name.lower())]
    likely += [by_lower[near] for near in difflib.get_close_matches(missing, by_lower)]
    return f"is {likely[0]} meant?" if likely else None
