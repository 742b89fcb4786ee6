"""A motion as a video shows it: times, angles, positions of the centre."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from .._internal.elementwise import Reals, reals
from .._internal.text_table import TableFileError
from .calibration import checked
from .table_options import PlaneLike, TableOptions
from .track_file import read_track

if TYPE_CHECKING:
    from ..units import Units

__all__ = ["TableFileError", "Track", "track_of_table"]


def _column(name: str, values: npt.ArrayLike | None, count: int) -> Reals | None:
    if values is None:
        return None
    # A masked value was not seen.
    column = np.array(reals(values, name))
    if column.shape != (count,):
        raise ValueError(
            f"{name} has shape {column.shape}, time has ({count},): they must be the same"
        )
    return column


@dataclass(frozen=True, eq=False)
class Track:
    """A tracked motion, dimensionless. NaN where tracking failed.

    Parameters
    ----------
    time : array_like
        Times τ, √(R/g), of shape (n,), growing.
    theta : array_like, optional
        Angle θ of the particle from the normal of the plane, counterclockwise, rad, shape (n,). It
        may jump by 2π.
    x : array_like, optional
        Position of the geometric centre along the plane, to the right, R, shape (n,).
    y : array_like, optional
        Distance of the geometric centre from the plane, R, shape (n,): 1 in contact.
    level : bool, optional
        Whether the axes are those of a level camera instead: `x` to the right and `y` upwards from
        a point of the plane, and `theta` from the upward vertical. On a level plane the two are the
        same.
    errors : mapping, optional
        Standard errors of `theta`, `x`, `y`, frame by frame, if the tracker estimates them. A fit
        uses their ratios only, and finds their size from the residuals.
    exposure : float, optional
        Exposure of a frame from its time on, √(R/g), over which the track is the mean. 0 for
        instants.
    calibration : iterable of str, optional
        Constant errors of the camera that a fit estimates: names of :func:`fit`.
    notes : iterable of str, optional
        What is to be known of how it was measured, as sentences.

    Raises
    ------
    ValueError
        If times do not grow, shapes differ, there is neither `theta` nor `x`, an error is not
        positive where something was seen, or there is no such exposure or calibration.
    """

    time: Reals
    theta: Reals | None = None
    x: Reals | None = None
    y: Reals | None = None
    errors: Mapping[str, Reals] | None = None
    exposure: float = 0.0
    calibration: tuple[str, ...] = ()
    level: bool = False
    notes: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        time = np.array(reals(self.time, "time"))
        if time.ndim != 1 or not np.all(np.isfinite(time)):
            raise ValueError("time must be a list of finite numbers")
        falls = np.flatnonzero(np.diff(time) <= 0.0)
        if falls.size:
            i = int(falls[0])
            raise ValueError(
                f"time[{i + 1}] = {time[i + 1]} must be greater than time[{i}] = {time[i]}"
            )
        object.__setattr__(self, "time", time)
        for name in ("theta", "x", "y"):
            column = _column(name, getattr(self, name), time.size)
            object.__setattr__(self, name, column)
            if column is not None and np.any(np.isinf(column)):
                i = int(np.flatnonzero(np.isinf(column))[0])
                raise ValueError(
                    f"{name}[{i}] = {column[i]} must be finite, or NaN where it was not seen"
                )
            if column is not None and not np.any(np.isfinite(column)):
                raise ValueError(f"{name} has no finite value: leave it out if it was not tracked")
        if self.theta is None and self.x is None:
            raise ValueError("a track needs theta or x")
        if self.theta is not None:
            seen = np.isfinite(self.theta)
            self.theta[seen] = np.unwrap(self.theta[seen])
        if self.errors is not None:
            object.__setattr__(self, "errors", self._checked(self.errors))
        if not (self.exposure >= 0.0 and math.isfinite(self.exposure)):
            raise ValueError(f"exposure = {self.exposure} must be finite and not negative")
        object.__setattr__(self, "notes", tuple(self.notes))
        object.__setattr__(self, "calibration", checked(self.calibration, self.channels))

    def _checked(self, errors: Mapping[str, npt.ArrayLike]) -> Mapping[str, Reals]:
        unknown = [name for name in errors if name not in self.channels]
        if unknown:
            raise ValueError(
                f"errors has {', '.join(unknown)}, the track has {', '.join(self.channels)}"
            )
        found = {}
        for name, values in errors.items():
            column = _column(f"errors of {name}", values, self.time.size)
            assert column is not None
            if np.any(~(column > 0.0) & np.isfinite(self.channels[name])):
                raise ValueError(f"an error of {name} is not positive where {name} was seen")
            found[name] = column
        return found

    def as_seen(self, plane: Mapping[str, Any], slope: Any) -> dict[str, Any]:
        """Return θ, x and y of the coordinates of the plane in the axes of the track.

        Parameters
        ----------
        plane : mapping
            `theta`, `x` and `y`.
        slope : float
            Angle by which the plane rises to the right, rad.
        """
        if not self.level:
            return dict(plane)
        sin, cos, x, y = np.sin(slope), np.cos(slope), plane["x"], plane["y"]
        return {"theta": plane["theta"] + slope, "x": x * cos - y * sin, "y": x * sin + y * cos}

    def relative_errors(self, name: str) -> Reals:
        """Return the errors of a channel over their median; 1 without errors."""
        if self.errors is None or name not in self.errors:
            return np.ones(self.time.size)
        seen = np.isfinite(self.channels[name])
        return self.errors[name] / float(np.median(self.errors[name][seen]))

    @classmethod
    def from_si(
        cls,
        units: Units,
        *,
        time_s: npt.ArrayLike,
        theta_rad: npt.ArrayLike | None = None,
        x_m: npt.ArrayLike | None = None,
        y_m: npt.ArrayLike | None = None,
        level: bool = False,
    ) -> Track:
        """Make a track from SI units.

        Parameters
        ----------
        units : Units
            Those of the hoop, `hoop.units`.
        time_s, theta_rad, x_m, y_m : array_like
            As those of :class:`Track`, in s, rad, m and m.
        level : bool, optional
            As that of :class:`Track`.

        Returns
        -------
        Track
        """

        def over(name: str, values: npt.ArrayLike | None, unit: float) -> Reals | None:
            return None if values is None else reals(values, name) / unit

        return cls(
            reals(time_s, "time_s") / units.time_s,
            over("theta_rad", theta_rad, 1.0),
            over("x_m", x_m, units.length_m),
            over("y_m", y_m, units.length_m),
            level=level,
        )

    @classmethod
    def from_csv(
        cls,
        path: str | Path,
        units: Units | None = None,
        *,
        level: bool = False,
        centre: str | None = None,
        marker: str | None = None,
        run: int | str | None = None,
        fps: float | None = None,
        plane: PlaneLike | None = None,
        length_unit: str | None = None,
        time_unit: str | None = None,
        dimensionless: bool = False,
        ignore: Iterable[str] = (),
    ) -> Track:
        """Read a track from a table of numbers with a line of names.

        Spreadsheets and trackers write such tables.

        Parameters
        ----------
        path : str or Path
            The file. Its columns are `time`, `theta`, `x`, `y`, or in SI units `time_s`,
            `theta_rad` (or `theta_deg`), `x_m`, `y_m`; an empty cell is a frame in which something
            was not seen. Exports of Tracker, Kinovea, PASCO Capstone and Vernier's Logger Pro and
            Graphical Analysis are read as they are.
        units : Units, optional
            Those of the hoop; SI columns need them. Names without units are in SI then if the
            height of the centre says so, and refused if it does not.
        level : bool, optional
            As that of :class:`Track`.
        centre, marker : str, optional
            Names of the points that are the centre of the hoop and the marker of its particle, in
            exports that name points. A single point is the centre, unless its name says marker; of
            two the names may say it ("centre", "marker").
        run : int or str, optional
            Number or name of the run or data set, in exports with several.
        fps : float, optional
            Rate at which frames were taken, 1/s. Files that have numbers of frames and no times
            need it; the rows of others must be a frame apart.
        plane : littlewood.video.Plane, optional
            The plane of the motion in a frame: the positions are in pixels.
        length_unit : {"m", "cm", "mm"}, optional
            Unit of positions whose names do not have it; m by default if the sizes agree with the
            radius of the hoop.
        time_unit : {"s", "ms", "us", "frame"}, optional
            Unit of times whose names do not have it. Kinovea writes any of them by its
            preferences, and needs it, or `fps`, which tells it; others are in s.
        dimensionless : bool, optional
            Whether names without units are dimensionless although the hoop has units.
        ignore : iterable of str, optional
            Columns to pass over. Velocities and other quantities that are computed from the track
            are passed over anyhow; any other unknown column is refused.

        Returns
        -------
        Track

        Raises
        ------
        littlewood.fitting.TableFileError
            With file, line, column, value and hint, for what cannot be read: nothing is left out in
            silence.
        """
        options = TableOptions(
            level=level,
            centre=centre,
            marker=marker,
            run=run,
            fps=fps,
            plane=plane,
            length_unit=length_unit,
            time_unit=time_unit,
            dimensionless=dimensionless,
            ignore=tuple(ignore),
        )
        return track_of_table(path, units, options)

    @property
    def channels(self) -> dict[str, Reals]:
        """The measured channels, by name."""
        found = {"theta": self.theta, "x": self.x, "y": self.y}
        return {name: values for name, values in found.items() if values is not None}

    def until(self, time: float) -> Track:
        """Return the part up to a time τ, √(R/g)."""
        return self._of(self.time <= time)

    def every(self, step: int) -> Track:
        """Return each so manieth frame, or all where a channel is seen in none of them."""
        chosen = np.arange(self.time.size) % step == 0
        seen = [np.isfinite(values[chosen]).any() for values in self.channels.values()]
        return self._of(chosen) if all(seen) else self

    def _of(self, frames: npt.NDArray[np.bool_]) -> Track:
        kept = {name: values[frames] for name, values in self.channels.items()}
        errors = self.errors and {name: values[frames] for name, values in self.errors.items()}
        theta, x, y = (kept.get(name) for name in ("theta", "x", "y"))
        return replace(self, time=self.time[frames], theta=theta, x=x, y=y, errors=errors)


def track_of_table(path: str | Path, units: Units | None, options: TableOptions) -> Track:
    """Read a track from a table, as :meth:`Track.from_csv` does."""
    found = read_track(path, units, options)
    if not found.is_si or units is None:
        return Track(found.time, found.theta, found.x, found.y, level=options.level)
    track = Track.from_si(
        units,
        time_s=found.time,
        theta_rad=found.theta,
        x_m=found.x,
        y_m=found.y,
        level=options.level,
    )
    return replace(track, notes=found.notes)
