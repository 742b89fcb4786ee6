"""What a fit minimises: residuals as a function of the unknowns."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import numpy.typing as npt

from .._internal.elementwise import Reals
from .._internal.extras import require
from ..hoop import Hoop
from ..trajectory import Trajectory
from .calibration import shown
from .estimate import Estimate
from .exposure import Exposures
from .noise import Noise, estimate_noise, whitenings
from .track import Track

__all__ = ["CLOCK", "FINE", "LEAST_INERTIA", "OF_HOOP", "ROUGH", "Problem"]


OF_HOOP = ("mu_s", "mu_k", "inertia", "restitution", "rolling_resistance", "slope")
# What is weighed and measured, and a stretch of all times: a fit asks whether the track contradicts
# them.
_MEASURED = ("mass_ratio", "offset")
CLOCK = "clock"
# Least inertia that is tried: without any, a hoop without mass is another body, with other
# equations.
LEAST_INERTIA = 1e-6
# Largest coefficient of friction and inertia that are tried: beyond them a motion no longer depends
# on them.
_LARGEST_FRICTION = 1e3
_LARGEST_INERTIA = 1e6
_STEEPEST = 1.57
# Largest coefficient of rolling resistance that is tried: a hoop then hardly turns. The first guess
# where the hoop has none, because a minimum is sought from within the bounds.
_LARGEST_RESISTANCE = 1.0
_TRY_RESISTANCE = 0.002
# Largest rate and slip of the start, √(g/R) and √(g R): no film shows a hoop that is as fast.
_FASTEST = 1e3
_CAMERA = "camera_"
_EXPOSURE = "camera_exposure"
_SLIP = "start_slip"
# Bounds of what may be held.
_HELD = {"mu_k": (0.0, math.inf), "inertia": (LEAST_INERTIA, math.inf), "restitution": (0.0, 1.0)}
_HELD[_EXPOSURE] = (0.0, math.inf)
_HELD |= {"slope": (-_STEEPEST, _STEEPEST), "mass_ratio": (0.0, math.inf), "offset": (0.0, 1.0)}
_HELD["rolling_resistance"] = (0.0, _LARGEST_RESISTANCE)
# Times that stand still, or run backwards, are no film.
_HELD[CLOCK] = (-0.5, 1.0)
# Part of a value, or of 1, by which differences for derivatives go to either side.
_STEP = 6e-6
# An imaginary step: what a camera shows has no difference that could be rounded.
_IMAGINARY = 1e-100
_TRY_RESTITUTION = (0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9)
# By which part the sum of squares still changes in the last step: on the way, and at the end.
ROUGH, FINE = 1e-6, 1e-12
_MOST_STEPS = 100
# What the constants of a camera are before the video is seen: 0 ± 0.1, R or rad. A video tells them
# far better as a rule; where it does not, they stay reasonable. An exposure is anything from none
# to the time between two frames.
_PRIOR = 0.1
RESISTANCE_BEFOREHAND = 0.05
"""What rolling resistance is before the track is seen: 0 ± 0.05, and not negative. A hoop on a hard
floor has less than 0.02, on a carpet 0.05. A track on which it rolls tells it far better; one that
does not leaves to the other unknowns what this does to them."""


def _camera_of(values: Mapping[str, Any]) -> dict[str, float]:
    """Return the constants of the camera by their names without a prefix."""
    return {
        name.removeprefix(_CAMERA): value
        for name, value in values.items()
        if name.startswith(_CAMERA)
    }


@dataclass(eq=False)
class Problem:
    """Residuals as a function of the unknowns.

    These are, by their `names`, those of the hoop, of the start, and last those of the camera.
    `first` is the guess of the start; the hoop `slips` there or not.
    """

    track: Track
    hoop: Hoop
    names: tuple[str, ...]
    first: dict[str, float]
    noise: dict[str, Noise]
    slips: bool

    holdable = (*OF_HOOP, *_MEASURED, CLOCK)
    """What is either free or held, but for the camera."""

    def __post_init__(self) -> None:
        self._seen = {name: np.isfinite(values) for name, values in self.track.channels.items()}
        self._white = {
            name: whitenings(
                [self.noise[name]],
                self.track.time[seen],
                self.track.relative_errors(name)[seen],
            )[0]
            for name, seen in self._seen.items()
        }
        step = self._longest = float(np.median(np.diff(self.track.time)))
        beforehand = {_EXPOSURE: (0.5 * step, step / math.sqrt(12.0))}
        beforehand["rolling_resistance"] = (0.0, RESISTANCE_BEFOREHAND)
        told = [
            (k, *beforehand.get(name, (0.0, _PRIOR)))
            for k, name in enumerate(self.names)
            if name.startswith(_CAMERA) or name in beforehand
        ]
        self._told = np.array([k for k, _, _ in told], dtype=np.intp)
        self._before = np.array([mean for _, mean, _ in told])
        self._deviation = np.array([deviation for _, _, deviation in told])
        self._last: tuple[tuple[float, ...], Exposures] | None = None
        self._last_derivatives: tuple[bytes, dict[str, Reals]] | None = None

    def with_camera(self, camera: tuple[str, ...], unknowns: Reals) -> tuple[Problem, Reals]:
        """Return the same with constants of the camera among the unknowns, and these."""
        names = self.names + tuple(_CAMERA + name for name in camera)
        found = replace(self, names=names)
        return found, np.concatenate([unknowns, found._before[-len(camera) :]])

    def camera_of(self, unknowns: Reals) -> Reals:
        """Return the unknowns with the constants of the camera that belong to the others."""
        rest = len(self.names) - len(self.camera_names)

        def scaled(constants: Reals) -> Reals:
            return self.scaled(np.concatenate([unknowns[:rest], constants]))

        low, high = self.bounds()
        bounds = (low[rest:], high[rest:])
        found = require("scipy.optimize").least_squares(
            scaled, unknowns[rest:], bounds=bounds, x_scale="jac"
        )
        return np.concatenate([unknowns[:rest], found.x])

    @property
    def camera_names(self) -> list[str]:
        """The constants of the camera, the last of the unknowns."""
        return [name for name in self.names if name.startswith(_CAMERA)]

    def guess(self, **values: float) -> Reals:
        """Return the unknowns at a guess.

        `mu_s` is stored as its excess over `mu_k`, which must not be negative.
        """
        known = {name: getattr(self.hoop, name) for name in OF_HOOP} | values
        if known["restitution"] is None:
            known["restitution"] = _TRY_RESTITUTION[0]
        known["rolling_resistance"] = known["rolling_resistance"] or _TRY_RESISTANCE
        known["mu_s"] = (
            max(known["mu_s"] - known["mu_k"], 1e-6) if "mu_k" in self.names else known["mu_s"]
        )
        known |= {f"start_{name}": value for name, value in {**self.first, **values}.items()}
        return np.array([known[name] for name in self.names])

    def other_restitutions(self, guess: Reals) -> list[Reals]:
        """Return a guess with other coefficients of restitution, if that is free."""
        if "restitution" not in self.names:
            return []
        place = self.names.index("restitution")
        return [np.insert(np.delete(guess, place), place, e) for e in _TRY_RESTITUTION]

    def rolling(self) -> Problem:
        """Return the same for a hoop that does not slip at the start."""
        names = tuple(name for name in self.names if name != _SLIP)
        return replace(self, names=names, slips=False)

    def slipping(self) -> Problem:
        """Return the same for a hoop that slips at the start."""
        place = len(self.names) - len(self.camera_names)
        names = (*self.names[:place], _SLIP, *self.names[place:])
        return replace(self, names=names, slips=True)

    def freed(self, name: str) -> Problem:
        """Return the same with something among the unknowns that is held."""
        place = len(self.names) - len(self.camera_names)
        return replace(self, names=(*self.names[:place], name, *self.names[place:]))

    def moved(self, unknowns: Reals, to: Problem, **more: float) -> Reals:
        """Return the unknowns as those of another problem, which may have more."""
        known = dict(zip(self.names, unknowns, strict=True)) | more
        return np.array([known[name] for name in to.names])

    def part(self, part: float) -> Problem:
        """Return the same for the first part of the track."""
        begin, end = float(self.track.time[0]), float(self.track.time[-1])
        return (
            self
            if part == 1.0
            else replace(self, track=self.track.until(begin + part * (end - begin)))
        )

    def sparse(self, frames: int) -> Problem:
        """Return the same for frames all over the track, of which there are about so many."""
        step = max(1, self.track.time.size // frames)
        return replace(self, track=self.track.every(step))

    def bounds(self) -> tuple[list[float], list[float]]:
        """Return the least and the largest values of the unknowns."""
        within = {
            "mu_s": (0.0 if "mu_k" in self.names else self.hoop.mu_k, _LARGEST_FRICTION),
            "mu_k": (0.0, _LARGEST_FRICTION if "mu_s" in self.names else self.hoop.mu_s),
            "inertia": (LEAST_INERTIA, _LARGEST_INERTIA),
            "restitution": (0.0, 1.0),
            "rolling_resistance": _HELD["rolling_resistance"],
            "slope": (-_STEEPEST, _STEEPEST),
            "start_theta_rate": (-_FASTEST, _FASTEST),
            _SLIP: (-_FASTEST, _FASTEST),
            _EXPOSURE: (0.0, self._longest),
        }
        within |= {name: _HELD[name] for name in (*_MEASURED, CLOCK)}
        pairs = [within.get(name, (-math.inf, math.inf)) for name in self.names]
        return [low for low, _ in pairs], [high for _, high in pairs]

    def limits(self, name: str) -> tuple[float, float]:
        """Return the least and the largest value of a parameter.

        It is that of the parameter, not of the unknown that stands for it.
        """
        if name == "mu_s" and "mu_k" in self.names:
            return 0.0, _LARGEST_FRICTION
        low, high = self.bounds()
        place = self.names.index(name)
        return low[place], high[place]

    def values(self, unknowns: Reals) -> dict[str, Any]:
        """Return everything by name; a coefficient of restitution may be absent."""
        found = {name: getattr(self.hoop, name) for name in (*OF_HOOP, *_MEASURED)}
        found |= {f"start_{name}": value for name, value in self.first.items()}
        found[_EXPOSURE] = self.track.exposure
        found[CLOCK] = 0.0
        found |= dict(zip(self.names, map(float, unknowns), strict=True))
        if "mu_s" in self.names and "mu_k" in self.names:
            found["mu_s"] += found["mu_k"]
        return found

    def unknowns_of(self, values: Mapping[str, Any]) -> Reals:
        """Return the unknowns that stand for everything by name, within their bounds."""
        known = dict(values)
        if "mu_s" in self.names and "mu_k" in self.names:
            known["mu_s"] -= known["mu_k"]
        low, high = self.bounds()
        return np.asarray(np.clip([known[name] for name in self.names], low, high))

    def estimate_of(self, name: str, best: Any) -> Estimate:
        """Return the value of a parameter at a minimum, and its standard error."""
        along = np.array([float(one == name) for one in self.names])
        if name == "mu_s" and "mu_k" in self.names:
            along[self.names.index("mu_k")] = 1.0
        variance = float(along @ np.linalg.pinv(best.jac.T @ best.jac) @ along)
        return Estimate(float(self.values(best.x)[name]), math.sqrt(max(variance, 0.0)), True)

    def motion(self, unknowns: Reals) -> Trajectory:
        """Return the motion while the video was taken."""
        return self._pictures(self.values(unknowns)).motion

    def _motion_of(self, values: dict[str, Any]) -> Trajectory:
        hoop = replace(
            self.hoop,
            units=self.hoop.units,
            **{name: values[name] for name in (*OF_HOOP, *_MEASURED)},
        )
        begin, end = float(self.track.time[0]), float(self.track.time[-1])
        return hoop.simulate(
            theta=values["start_theta"],
            theta_rate=values["start_theta_rate"],
            slip=values["start_slip"] if self.slips else 0.0,
            x=values["start_x"],
            time=begin,
            until=begin + (end - begin) * (1.0 + values[CLOCK]) + values[_EXPOSURE],
        )

    def residuals(self, unknowns: Reals) -> dict[str, Reals]:
        """Return what was measured less what the camera would have shown, by channel."""
        return self.residuals_of(self.values(unknowns))

    def residuals_of(self, values: dict[str, Any]) -> dict[str, Reals]:
        """Return the residuals for everything by name."""
        positions = self._pictures(values).positions
        found = shown(self.track.as_seen(positions, values["slope"]), _camera_of(values))
        return {name: measured - found[name] for name, measured in self.track.channels.items()}

    def _pictures(self, values: dict[str, Any]) -> Exposures:
        """Return the pictures, the same for all constants of the camera but the exposure."""
        key = tuple(
            value
            for name, value in values.items()
            if not name.startswith(_CAMERA) or name == _EXPOSURE
        )
        if self._last is None or self._last[0] != key:
            begin = self.track.time[0]
            time = begin + (self.track.time - begin) * (1.0 + values[CLOCK])
            self._last = key, Exposures(self._motion_of(values), time, values[_EXPOSURE])
        return self._last[1]

    def seen(self, by_channel: dict[str, Reals]) -> dict[str, Reals]:
        """Return values, or columns of them, of the frames in which a channel was seen."""
        return {name: values[self._seen[name]] for name, values in by_channel.items()}

    def scaled(self, unknowns: Reals) -> Reals:
        """Return the residuals as numbers that are independent and of size 1.

        Those of what is known beforehand follow.
        """
        residuals = self.residuals(unknowns)
        parts = [
            self._white[name](residual[self._seen[name]]) for name, residual in residuals.items()
        ]
        return np.concatenate([*parts, (unknowns[self._told] - self._before) / self._deviation])

    def cost(self, unknowns: Reals) -> float:
        """Return half the sum of squares, as a fit has it."""
        scaled = self.scaled(unknowns)
        return 0.5 * float(scaled @ scaled)

    def misfit(self, unknowns: Reals) -> float:
        """Return the mean size of the residuals."""
        return float(np.mean(np.abs(self.scaled(unknowns))))

    def reduced_chi_square(self, unknowns: Reals) -> float:
        """Return the sum of squares over the number of measurements less that of unknowns."""
        white = self.scaled(unknowns)[: -self._before.size or None]
        return float(white @ white) / max(1, white.size - unknowns.size)

    def noise_of(
        self, unknowns: Reals, known: dict[str, Noise], loss: str, correlated: bool
    ) -> dict[str, Noise]:
        """Estimate the errors of each channel from the residuals."""
        relative = {
            name: self.track.relative_errors(name)[seen] for name, seen in self._seen.items()
        }
        residuals = self.seen(self.residuals(unknowns))
        if loss != "linear":
            typical = {
                name: float(np.sqrt(np.mean(np.square(residuals[name] / relative[name]))))
                for name in relative
            }
            return {name: Noise(max(value, 1e-12)) for name, value in typical.items()} | known
        times = {name: self.track.time[seen] for name, seen in self._seen.items()}
        slopes = self.seen(self.derivatives(unknowns))
        return estimate_noise(times, relative, residuals, slopes, known, correlated)

    def derivatives(self, unknowns: Reals) -> dict[str, Reals]:
        """Return the derivatives of the residuals of each channel by the unknowns.

        They are those of the motion, where it has them; else differences within bounds.
        """
        key = unknowns.tobytes()
        if self._last_derivatives is None or self._last_derivatives[0] != key:
            self._last_derivatives = key, self._derivatives(unknowns)
        return self._last_derivatives[1]

    def _derivatives(self, unknowns: Reals) -> dict[str, Reals]:
        found = self._exact(self.values(unknowns))
        low, high = self.bounds()
        is_known = np.all([np.isfinite(rows).all(axis=0) for rows in found.values()], axis=0)
        for k in np.flatnonzero(~is_known):
            step = _STEP * max(1.0, abs(unknowns[k]))
            ends = max(unknowns[k] - step, low[k]), min(unknowns[k] + step, high[k])
            below, above = (
                self.residuals(np.concatenate([unknowns[:k], [end], unknowns[k + 1 :]]))
                for end in ends
            )
            for name, rows in found.items():
                rows[:, k] = (above[name] - below[name]) / (ends[1] - ends[0])
        return found

    def _exact(self, values: dict[str, Any]) -> dict[str, Reals]:
        """Return the derivatives by the unknowns; NaN by those by which the motion has none."""
        pictures, camera = self._pictures(values), _camera_of(values)
        names = [name for name in self.names if not name.startswith(_CAMERA)]
        of_motion = [name for name in names if name not in (*_MEASURED, CLOCK)]
        known = pictures.derivatives([name.removeprefix("start_") for name in of_motion])
        # What is weighed or measured is freed by a doubt alone: differences are good enough.
        change = {
            channel: np.column_stack(
                [
                    rows[:, of_motion.index(name)]
                    if name in of_motion
                    else np.full(rows.shape[0], np.nan)
                    for name in names
                ]
            )
            for channel, rows in known.items()
        }
        if "mu_s" in names and "mu_k" in names:
            # The unknown is the excess of mu_s over mu_k.
            for rows in change.values():
                rows[:, names.index("mu_k")] += rows[:, names.index("mu_s")]
        if _EXPOSURE in self.names:
            names.append(_EXPOSURE)
            for channel, column in pictures.derivatives_by_exposure().items():
                change[channel] = np.column_stack([change[channel], column])
        step = 1j * _IMAGINARY
        moved = {
            channel: rows[:, None] + step * np.nan_to_num(change[channel])
            for channel, rows in pictures.positions.items()
        }
        slope = values["slope"] + step * np.array([name == "slope" for name in names])
        seen = shown(self.track.as_seen(moved, slope), camera)
        is_known = np.all([np.isfinite(rows).all(axis=0) for rows in change.values()], axis=0)
        # What a camera has wrong is proportional to its constants.
        still = self.track.as_seen(pictures.positions, values["slope"])
        by_camera = {
            name: shown(still, {name.removeprefix(_CAMERA): 1.0})
            for name in self.names
            if name not in names
        }
        found = {}
        for channel in self.track.channels:
            rows = np.where(is_known, -seen[channel].imag / _IMAGINARY, np.nan)
            columns = dict(zip(names, rows.T, strict=True))
            columns |= {name: still[channel] - one[channel] for name, one in by_camera.items()}
            found[channel] = np.column_stack([columns[name] for name in self.names])
        return found

    def jacobian(self, unknowns: Reals) -> Reals:
        """Return the derivatives of :meth:`scaled`."""
        parts = [*self.whitened(self.derivatives(unknowns)).values()]
        return np.vstack([*parts, np.eye(unknowns.size)[self._told] / self._deviation[:, None]])

    def whitened(self, by_channel: dict[str, Reals]) -> dict[str, Reals]:
        """Return what was seen as numbers whose errors are independent and of size 1."""
        return {name: self._white[name](rows) for name, rows in self.seen(by_channel).items()}

    def derivative_by(self, name: str, values: dict[str, Any]) -> dict[str, Reals] | None:
        """Return the derivatives of the residuals by something that is held.

        None without a motion on both sides.
        """
        value = values.get(name, 0.0)
        low, high = _HELD.get(name, (-math.inf, math.inf))
        if value is None or value < low:
            return None
        step = _STEP * max(1.0, abs(value))
        low = values["mu_k"] if name == "mu_s" else low
        high = values["mu_s"] if name == "mu_k" else high
        ends = max(value - step, low), min(value + step, high)
        if ends[0] >= ends[1]:
            return None
        below, above = (self.residuals_of(values | {name: end}) for end in ends)
        return {
            channel: (above[channel] - below[channel]) / (ends[1] - ends[0]) for channel in below
        }

    def may_move(self, name: str, value: float, direction: float) -> bool:
        """Whether something that is held may become larger or smaller, by the sign."""
        low, high = _HELD.get(name, (-math.inf, math.inf))
        return value < high if direction > 0.0 else value > low

    def fixed(self, name: str, values: dict[str, Any]) -> tuple[Problem, Reals] | None:
        """Return the same with a parameter of the hoop fixed, and a guess of the others.

        None where no hoop has it.
        """
        value, values = values[name], values | {"mu_k": max(values["mu_k"], 0.0)}
        if values["mu_s"] < values["mu_k"]:
            # The other coefficient gives way, if it may.
            other = "mu_k" if name == "mu_s" else "mu_s"
            if other not in self.names:
                return None
            values[other] = value
        held = {one: values[one] for one in OF_HOOP if one == name or one not in self.names}
        held |= {"mu_s": max(values["mu_s"], values["mu_k"]), "mu_k": values["mu_k"]}
        hoop = replace(self.hoop, units=self.hoop.units, **held)
        found = replace(self, hoop=hoop, names=tuple(one for one in self.names if one != name))
        return found, found.unknowns_of(values)

    def refine(
        self, unknowns: Reals, loss: str, tolerance: float = FINE, most: int = _MOST_STEPS
    ) -> Any:
        """Minimise from a guess, in so many steps or until the sum of squares hardly changes.

        What the residuals do not depend on stays as it is: steps along it would lead from bound to
        bound, and shorten those of the others.
        """
        found, seen = None, np.zeros(unknowns.size, dtype=bool)
        while True:
            depend = np.any(self.jacobian(unknowns) != 0.0, axis=0)
            if found is not None and not np.any(depend & ~seen):
                return found
            seen = seen | depend
            found = self._refined(unknowns, seen, loss, tolerance, most)
            unknowns = found.x

    def _refined(
        self,
        unknowns: Reals,
        seen: npt.NDArray[np.bool_],
        loss: str,
        tolerance: float,
        most: int,
    ) -> Any:
        """Minimise over some of the unknowns; the result is that over all of them."""
        low, high = map(np.array, self.bounds())

        def whole(some: Reals) -> Reals:
            found = unknowns.copy()
            found[seen] = some
            return found

        found = require("scipy.optimize").least_squares(
            lambda some: self.scaled(whole(some)),
            unknowns[seen],
            bounds=(low[seen], high[seen]),
            jac=lambda some: self.jacobian(whole(some))[:, seen],
            x_scale="jac",
            loss=loss,
            ftol=tolerance,
            xtol=tolerance,
            gtol=tolerance,
            max_nfev=most,
        )
        found.x = whole(found.x)
        for name in ("jac", "active_mask"):
            some = found[name]
            found[name] = np.zeros((*some.shape[:-1], unknowns.size))
            found[name][..., seen] = some
        return found
