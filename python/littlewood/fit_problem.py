"""What a fit minimises: residuals as a function of the unknowns."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import numpy.typing as npt

from .calibration import means, shown
from .extras import require
from .hoop import Hoop
from .noise import Noise, Whitening, estimate_noise
from .track import Track
from .trajectory import Trajectory

__all__ = ["FINE", "LEAST_INERTIA", "OF_HOOP", "ROUGH", "Problem"]

_Reals = npt.NDArray[np.float64]

OF_HOOP = ("mu_s", "mu_k", "inertia", "restitution", "slope")
# Least inertia that is tried: without any, a hoop without mass is another body, with other equations.
LEAST_INERTIA = 1e-6
# Largest coefficient of friction and inertia that are tried: beyond them a motion no longer depends on them.
_LARGEST_FRICTION = 1e3
_LARGEST_INERTIA = 1e6
_STEEPEST = 1.57
_TRY_RESTITUTION = (0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9)
# By which part the sum of squares still changes in the last step: on the way, and at the end.
ROUGH, FINE = 1e-6, 1e-12
# What the constants of a camera are before the video is seen: 0 ± 0.1, R or rad. A video tells them far better as a
# rule; where it does not, they stay reasonable. An exposure is anything from none to the time between two frames.
_CAMERA = "camera_"
_EXPOSURE = "camera_exposure"
_PRIOR = 0.1


@dataclass(eq=False)
class Problem:
    """Residuals as a function of the unknowns.

    Parameters
    ----------
    track : Track
        What was tracked.
    hoop : Hoop
        The hoop with what is known.
    names : tuple of str
        The unknowns: of the hoop, of the start, and last those of the camera.
    first : dict
        The guess of the start.
    noise : dict
        Errors of the channels.
    slips : bool
        Whether the hoop slips at the start.
    """

    track: Track
    hoop: Hoop
    names: tuple[str, ...]
    first: dict[str, float]
    noise: dict[str, Noise]
    slips: bool

    def __post_init__(self) -> None:
        self._seen = {name: np.isfinite(values) for name, values in self.track.channels.items()}
        self._white = {
            name: Whitening(self.noise[name], self.track.time[seen], self.track.relative_errors(name)[seen])
            for name, seen in self._seen.items()
        }
        step = self._longest = float(np.median(np.diff(self.track.time)))
        camera = np.array(self._camera_names, dtype=object)
        self._before = np.where(camera == _EXPOSURE, 0.5 * step, 0.0)
        self._deviation = np.where(camera == _EXPOSURE, step / math.sqrt(12.0), _PRIOR)
        self._last: tuple[tuple[float, ...], dict[str, _Reals]] | None = None

    def with_camera(self, camera: tuple[str, ...], unknowns: _Reals) -> tuple[Problem, _Reals]:
        """Return the same with constants of the camera among the unknowns, and these."""
        names = self.names + tuple(_CAMERA + name for name in camera)
        found = replace(self, names=names)
        return found, np.concatenate([unknowns, found._before])

    def camera_of(self, unknowns: _Reals) -> _Reals:
        """Return the unknowns with the constants of the camera that belong to the others."""
        rest = len(self.names) - len(self._camera_names)

        def scaled(constants: _Reals) -> _Reals:
            return self.scaled(np.concatenate([unknowns[:rest], constants]))

        low, high = self.bounds()
        bounds = (low[rest:], high[rest:])
        found = require("scipy.optimize").least_squares(scaled, unknowns[rest:], bounds=bounds, x_scale="jac")
        return np.concatenate([unknowns[:rest], found.x])

    @property
    def _camera_names(self) -> list[str]:
        return [name for name in self.names if name.startswith(_CAMERA)]

    def guess(self, **values: float) -> _Reals:
        """Return the unknowns at a guess; `mu_s` is stored as its excess over `mu_k`, which must not be negative."""
        known = {name: getattr(self.hoop, name) for name in OF_HOOP} | values
        if known["restitution"] is None:
            known["restitution"] = _TRY_RESTITUTION[0]
        known["mu_s"] = max(known["mu_s"] - known["mu_k"], 1e-6) if "mu_k" in self.names else known["mu_s"]
        known |= {f"start_{name}": value for name, value in {**self.first, **values}.items()}
        return np.array([known[name] for name in self.names])

    def with_restitutions(self, guess: _Reals) -> list[_Reals]:
        """Return a guess as it is, and with other coefficients of restitution if that is free."""
        if "restitution" not in self.names:
            return [guess]
        place = self.names.index("restitution")
        return [guess, *(np.insert(np.delete(guess, place), place, e) for e in _TRY_RESTITUTION)]

    def part(self, part: float) -> Problem:
        """Return the same for the first part of the track."""
        begin, end = float(self.track.time[0]), float(self.track.time[-1])
        return self if part == 1.0 else replace(self, track=self.track.until(begin + part * (end - begin)))

    def bounds(self) -> tuple[list[float], list[float]]:
        """Return the least and the largest values of the unknowns."""
        low = {"mu_s": 0.0 if "mu_k" in self.names else self.hoop.mu_k, "mu_k": 0.0, "inertia": LEAST_INERTIA}
        low["restitution"] = low[_EXPOSURE] = 0.0
        low["slope"] = -_STEEPEST
        high = {"mu_s": _LARGEST_FRICTION, "mu_k": _LARGEST_FRICTION, "inertia": _LARGEST_INERTIA, "restitution": 1.0}
        high[_EXPOSURE] = self._longest
        high["slope"] = _STEEPEST
        if "mu_s" not in self.names:
            high["mu_k"] = self.hoop.mu_s
        return (
            [low.get(name, -math.inf) for name in self.names],
            [high.get(name, math.inf) for name in self.names],
        )

    def values(self, unknowns: _Reals) -> dict[str, Any]:
        """Return everything by name; a coefficient of restitution may be absent."""
        found = {name: getattr(self.hoop, name) for name in OF_HOOP}
        found |= {f"start_{name}": value for name, value in self.first.items()}
        found[_EXPOSURE] = self.track.exposure
        found |= dict(zip(self.names, map(float, unknowns), strict=True))
        if "mu_s" in self.names and "mu_k" in self.names:
            found["mu_s"] += found["mu_k"]
        return found

    def motion(self, unknowns: _Reals) -> Trajectory:
        """Simulate the motion while the video was taken."""
        values = self.values(unknowns)
        hoop = replace(self.hoop, units=self.hoop.units, **{name: values[name] for name in OF_HOOP})
        return hoop.simulate(
            theta=values["start_theta"],
            theta_rate=values["start_theta_rate"],
            slip=values["start_slip"] if self.slips else 0.0,
            x=values["start_x"],
            time=float(self.track.time[0]),
            until=float(self.track.time[-1]) + values[_EXPOSURE],
        )

    def residuals(self, unknowns: _Reals) -> dict[str, _Reals]:
        """Return what was measured less what the camera would have shown, by channel."""
        values = self.values(unknowns)
        camera = {name.removeprefix(_CAMERA): value for name, value in values.items() if name.startswith(_CAMERA)}
        # The means over exposures are the same for all other constants of the camera.
        key = tuple(value for name, value in values.items() if not name.startswith(_CAMERA) or name == _EXPOSURE)
        if self._last is None or self._last[0] != key:
            self._last = key, means(self.motion(unknowns), self.track.time, values[_EXPOSURE])
        found = shown(self.track.as_seen(self._last[1], values["slope"]), camera)
        return {name: measured - found[name] for name, measured in self.track.channels.items()}

    def scaled(self, unknowns: _Reals) -> _Reals:
        """Return the residuals as numbers that are independent and of size 1, and then the constants of the camera."""
        residuals = self.residuals(unknowns)
        parts = [self._white[name](residual[self._seen[name]]) for name, residual in residuals.items()]
        # Constants of the camera are the last of the unknowns.
        camera = unknowns[unknowns.size - self._before.size :]
        return np.concatenate([*parts, (camera - self._before) / self._deviation])

    def misfit(self, unknowns: _Reals) -> float:
        """Return the mean size of the residuals."""
        return float(np.mean(np.abs(self.scaled(unknowns))))

    def reduced_chi_square(self, unknowns: _Reals) -> float:
        """Return the sum of squares over the number of measurements less that of unknowns."""
        white = self.scaled(unknowns)[: -self._before.size or None]
        return float(white @ white) / max(1, white.size - unknowns.size)

    def noise_of(self, unknowns: _Reals, known: dict[str, Noise], loss: str, correlated: bool) -> dict[str, Noise]:
        """Estimate the errors of each channel from the residuals."""
        relative = {name: self.track.relative_errors(name)[seen] for name, seen in self._seen.items()}
        residuals = {name: residual[self._seen[name]] for name, residual in self.residuals(unknowns).items()}
        if loss != "linear":
            typical = {name: float(np.sqrt(np.mean(np.square(residuals[name] / relative[name])))) for name in relative}
            return {name: Noise(max(value, 1e-12)) for name, value in typical.items()} | known
        times = {name: self.track.time[seen] for name, seen in self._seen.items()}
        slopes = {name: columns[self._seen[name]] for name, columns in self._derivatives(unknowns).items()}
        return estimate_noise(times, relative, residuals, slopes, known, correlated)

    def _derivatives(self, unknowns: _Reals) -> dict[str, _Reals]:
        """Return the derivatives of the residuals of each channel by differences within the bounds."""
        columns: dict[str, list[_Reals]] = {name: [] for name in self.track.channels}
        low, high = self.bounds()
        for k, value in enumerate(unknowns):
            step = 6e-6 * max(1.0, abs(value))
            ends = max(value - step, low[k]), min(value + step, high[k])
            below, above = (self.residuals(np.concatenate([unknowns[:k], [end], unknowns[k + 1 :]])) for end in ends)
            for name in columns:
                columns[name].append((above[name] - below[name]) / (ends[1] - ends[0]))
        return {name: np.column_stack(values) for name, values in columns.items()}

    def refine(self, unknowns: _Reals, loss: str, tolerance: float = FINE) -> Any:
        """Minimise from a guess, until the sum of squares changes by less than a part."""
        return require("scipy.optimize").least_squares(
            self.scaled,
            unknowns,
            bounds=self.bounds(),
            jac="3-point",
            x_scale="jac",
            loss=loss,
            ftol=tolerance,
            xtol=tolerance,
            gtol=tolerance,
            max_nfev=200,
        )
