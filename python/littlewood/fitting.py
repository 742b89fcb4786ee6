"""Friction, inertia and restitution from a tracked motion, by least squares."""

from __future__ import annotations

import itertools
import math
import warnings
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from .calibration import checked, kinks, means, shown
from .extras import require
from .fit_result import Estimate, FitResult, IdentifiabilityWarning
from .hoop import Hoop
from .noise import Noise, Whitening, estimate_noise
from .track import Track
from .trajectory import Trajectory

__all__ = ["fit"]

_Reals = npt.NDArray[np.float64]

_OF_HOOP = ("mu_s", "mu_k", "inertia", "restitution")
# The coefficient of restitution says how a motion goes on that would end at its landing: it is asked for.
_BY_DEFAULT = ("mu_s", "mu_k", "inertia")
# Least inertia that is tried: without any, a hoop without mass is another body, with other equations.
_LEAST_INERTIA = 1e-6
# Largest coefficient of friction and inertia that are tried: beyond them a motion no longer depends on them.
_LARGEST_FRICTION = 1e3
_LARGEST_INERTIA = 1e6
# Coefficients and inertias that are tried first, because a motion depends smoothly on them only as long as the sequence
# of its phases is the same.
_TRY_MU_K = (0.05, 0.12, 0.2, 0.3, 0.4, 0.55, 0.75, 1.0)
_TRY_STEP = (0.01, 0.05, 0.1, 0.2, 0.4)
_TRY_INERTIA = (0.6, 0.8, 1.0, 1.25, 1.6)
_TRY_RESTITUTION = (0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9)
_BEST = 6
# Parts of the track over which a coefficient of restitution is sought, and how many guesses are followed over each.
_PARTS = (0.5, 0.6, 0.7, 0.8, 0.9, 1.0)
_BEST_OF_PART = 4
# How often the errors are estimated from the residuals.
_TURNS = 4
# By which part the sum of squares still changes in the last step: on the way, and at the end.
_ROUGH, _FINE = 1e-6, 1e-12
# What the constants of a camera are before the film is seen: 0 ± 0.1, R or rad. A film tells them far better as a rule;
# where it does not, they stay reasonable. An exposure is anything between none and the time between two pictures.
_CAMERA = "camera_"
_EXPOSURE = "camera_exposure"
_PRIOR = 0.1
_DEPENDENT = "the motion does not depend on it, apart from the others"


def fit(
    track: Track | str | Path,
    hoop: Hoop,
    *,
    free: Iterable[str] = _BY_DEFAULT,
    slips_at_start: bool = False,
    start: Mapping[str, float] | None = None,
    sigma: Mapping[str, float] | None = None,
    until: float | None = None,
    loss: str = "linear",
    search: bool = True,
    calibration: Iterable[str] | None = None,
) -> FitResult:
    r"""Estimate friction, inertia and restitution of a hoop from a tracked motion.

    The start (angle, rate, position, and slip velocity if asked for) is estimated along with them. Masses and the place
    of the particle are taken from `hoop`: they are weighed and measured.

    Parameters
    ----------
    track : Track, str or Path
        What was tracked, or a CSV file of it (:meth:`Track.from_csv`).
    hoop : Hoop
        The hoop with what is known; its values of what is free are a first guess. Its law of restitution is taken as it
        is.
    free : iterable of {"mu_s", "mu_k", "inertia", "restitution"}, optional
        What to estimate; the first three by default. With "restitution", or with a hoop that has one, the track may go
        on after a landing.
    slips_at_start : bool, optional
        Whether the hoop is thrown with a slip velocity, which is then estimated, too; else it starts without slip.
    start : mapping, optional
        First guesses of `theta`, `theta_rate`, `slip`, `x` where the first frames do not tell them.
    sigma : mapping, optional
        Standard deviations of the measurements of `theta` (rad), `x` and `y` (R), which are then taken for independent.
        By default the errors of each channel are estimated from the residuals, as a part that differs from picture to
        picture and one that changes slowly. Where the track has errors of single pictures, they are those of a picture
        whose error is the median.
    until : float, optional
        Last time τ, √(R/g), that is used. Without a coefficient of restitution leave out what comes after the landing,
        which is not simulated then.
    loss : {"linear", "soft_l1", "huber", "cauchy", "arctan"}, optional
        As :func:`scipy.optimize.least_squares` has it; all but the first bear outliers.
    search : bool, optional
        Whether to begin at many places. Without it the fit begins at the values of `hoop` and `start` alone, which is
        many times as fast, and finds the sequence of phases only if they have it.
    calibration : iterable of str, optional
        What the camera may show wrong in every picture alike, which is then estimated along (as `camera_floor`, …):
        "floor" (the height of the centre), "turn", "scale", "stretch", "shear", "perspective_x" and "perspective_y" of
        the picture, "marker" (the angle), "middle_x" and "middle_y" (the centre against the marker), and "exposure"
        (how long a picture is exposed). By default that of the
        track: all of them for one of :func:`track_video`, none for others. What no channel tells of is left out.

    Returns
    -------
    FitResult

    Warns
    -----
    IdentifiabilityWarning
        If the motion does not depend on something that is free. μs enters by the instant of a slip out of rolling alone
        (a motion without one tells only that μs is at least the friction that rolling needed), μk by slides and by
        impacts that slip; the inertia enters by rolling, sliding and impacts, not by flight; the coefficient of
        restitution by impacts alone.

    Raises
    ------
    ValueError
        For unknown names, or fewer measurements than unknowns.

    Notes
    -----
    With the errors e of a channel at the times t, of the covariance

    .. math:: V_{ij} = \sigma^2 w_i^2 \delta_{ij} + s^2 e^{-|t_i - t_j|/T},

    w being the errors that the track has over their median, the fit minimises eᵀV⁻¹e, and the covariance of the
    estimates is (JᵀV⁻¹J)⁻¹ with the derivatives J of all channels by all unknowns, those of the camera among them. σ, s
    and T are those of the largest restricted likelihood, over a grid of s/σ and T. With another `loss` errors are taken
    for independent. Of a constant of the camera 0 ± 0.1 is known beforehand; they are displacements of what is seen,
    to first order: floor (0, 1), turn (−y, x), scale (x, y), stretch (x, −y), shear (y, x), perspective_x (x², x y),
    perspective_y (x y, y²), all that is between two homographies but a shift along x; middle_x and middle_y add cos θ
    and sin θ to the angle. A picture shows the mean over its exposure, which begins at its time.

    A parameter counts as not identifiable where the residuals do not depend on it apart from the others, where its
    standard error would exceed its value (or half of its range, for the coefficient of restitution), or where the fit
    ends at the bound μs = μk: there the motion depends on μs to second order only. The exact simulation makes the
    residuals smooth in all parameters as long as the sequence of phases is the same, and each impact of the same kind;
    over the sequences the fit starts from several places.

    Examples
    --------
    >>> import numpy as np, littlewood as lw
    >>> hoop = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4)
    >>> time = np.linspace(0, 2.0, 200)
    >>> seen = hoop.simulate(theta=2.5, theta_rate=3).at(time)
    >>> result = lw.fit(lw.Track(time, theta=seen.theta, x=seen.x), hoop)
    >>> abs(result.hoop.mu_s - 0.5) < 1e-6
    True
    """
    if not isinstance(track, Track):
        track = Track.from_csv(track, hoop.units)
    if until is not None:
        track = track.until(until)
    free = tuple(free)
    unknown = [name for name in free if name not in _OF_HOOP]
    if unknown or not free:
        raise ValueError(f"free = {free} must name some of {', '.join(_OF_HOOP)}")
    unknown = [name for name in (sigma or {}) if name not in track.channels]
    if unknown:
        raise ValueError(f"sigma has {', '.join(unknown)}, the track has {', '.join(track.channels)}")
    first = _first_guess(track, dict(start or {}))
    names = [*(name for name in _OF_HOOP if name in free), "start_theta", "start_theta_rate"]
    names += ["start_x"] if track.x is not None else []
    names += ["start_slip"] if slips_at_start else []
    measured = sum(int(np.isfinite(values).sum()) for values in track.channels.values())
    if measured <= len(names):
        raise ValueError(f"{measured} measurements are not enough for {len(names)} unknowns: {', '.join(names)}")
    camera = checked(track.calibration if calibration is None else calibration, track.channels)
    known = {name: Noise(float(value)) for name, value in (sigma or {}).items()}
    noise = dict.fromkeys(track.channels, Noise(1.0)) | known
    problem = _Problem(track, hoop, tuple(names), first, noise, slips_at_start)
    if search:
        unknowns = _search(problem, loss, "theta" not in track.channels and "theta" not in (start or {})).x
    elif camera:
        # Without its constants the fit would leave the sequence of phases of a good guess.
        unknowns = problem.guess()
    else:
        unknowns = problem.refine(problem.guess(), loss).x
    if camera:
        problem, unknowns = problem.with_camera(camera, unknowns)
    # Weights from residuals, and again with those weights.
    for turn in range(_TURNS):
        noise = problem.noise_of(unknowns, known, loss, turn > 0)
        problem = replace(problem, noise=noise, doubts=problem.doubts_of(unknowns))
        best = problem.refine(unknowns, loss, _FINE if turn == _TURNS - 1 else _ROUGH)
        unknowns = best.x
    return _result(problem, best)


@dataclass(eq=False)
class _Problem:
    """Residuals as a function of the unknowns."""

    track: Track
    hoop: Hoop
    names: tuple[str, ...]
    first: dict[str, float]
    noise: dict[str, Noise]
    slips: bool
    doubts: dict[str, _Reals] | None = None

    def __post_init__(self) -> None:
        self._seen = {name: np.isfinite(values) for name, values in self.track.channels.items()}
        self._white = {
            name: Whitening(self.noise[name], self.track.time[seen], self.relative(name)[seen])
            for name, seen in self._seen.items()
        }
        step = float(np.median(np.diff(self.track.time)))
        self._before = np.array([0.0 if name != _EXPOSURE else 0.5 * step for name in self._camera_names])
        self._deviation = np.array(
            [_PRIOR if name != _EXPOSURE else step / math.sqrt(12.0) for name in self._camera_names]
        )
        self._longest = step
        self._last: tuple[tuple[float, ...], dict[str, _Reals]] | None = None

    def relative(self, name: str) -> _Reals:
        """Return the errors of a channel over the median one, with the doubts about pictures with an impact."""
        errors = self.track.relative_errors(name)
        return errors if self.doubts is None else np.hypot(errors, self.doubts[name] / self.noise[name].white)

    def doubts_of(self, unknowns: _Reals) -> dict[str, _Reals] | None:
        """Return by how much pictures are in doubt because of impacts."""
        exposure = self._longest if _EXPOSURE in self.names else self.track.exposure
        return kinks(self.motion(unknowns), self.track.time, exposure) if exposure > 0.0 else None

    def with_camera(self, camera: tuple[str, ...], unknowns: _Reals) -> tuple[_Problem, _Reals]:
        """Return the same with constants of the camera among the unknowns, and these."""
        names = self.names + tuple(_CAMERA + name for name in camera)
        found = replace(self, names=names)
        return found, np.concatenate([unknowns, found._before])

    @property
    def _camera_names(self) -> list[str]:
        return [name for name in self.names if name.startswith(_CAMERA)]

    def guess(self, **values: float) -> _Reals:
        """Return the unknowns at a guess; `mu_s` is stored as its excess over `mu_k`, which must not be negative."""
        known = {name: getattr(self.hoop, name) for name in _OF_HOOP} | values
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

    def part(self, part: float) -> _Problem:
        """Return the same for the first part of the track."""
        begin, end = float(self.track.time[0]), float(self.track.time[-1])
        return self if part == 1.0 else replace(self, track=self.track.until(begin + part * (end - begin)))

    def bounds(self) -> tuple[list[float], list[float]]:
        low = {"mu_s": 0.0 if "mu_k" in self.names else self.hoop.mu_k, "mu_k": 0.0, "inertia": _LEAST_INERTIA}
        low["restitution"] = low[_EXPOSURE] = 0.0
        high = {"mu_s": _LARGEST_FRICTION, "mu_k": _LARGEST_FRICTION, "inertia": _LARGEST_INERTIA, "restitution": 1.0}
        high[_EXPOSURE] = self._longest
        if "mu_s" not in self.names:
            high["mu_k"] = self.hoop.mu_s
        return (
            [low.get(name, -math.inf) for name in self.names],
            [high.get(name, math.inf) for name in self.names],
        )

    def values(self, unknowns: _Reals) -> dict[str, Any]:
        """Return everything by name; a coefficient of restitution may be absent."""
        found = {name: getattr(self.hoop, name) for name in _OF_HOOP}
        found |= {f"start_{name}": value for name, value in self.first.items()}
        found[_EXPOSURE] = self.track.exposure
        found |= dict(zip(self.names, map(float, unknowns), strict=True))
        if "mu_s" in self.names and "mu_k" in self.names:
            found["mu_s"] += found["mu_k"]
        return found

    def motion(self, unknowns: _Reals) -> Trajectory:
        values = self.values(unknowns)
        hoop = replace(self.hoop, units=self.hoop.units, **{name: values[name] for name in _OF_HOOP})
        return hoop.simulate(
            theta=values["start_theta"],
            theta_rate=values["start_theta_rate"],
            slip=values["start_slip"] if self.slips else 0.0,
            x=values["start_x"],
            time=float(self.track.time[0]),
            until=float(self.track.time[-1]) + values[_EXPOSURE],
        )

    def residuals(self, unknowns: _Reals) -> dict[str, _Reals]:
        values = self.values(unknowns)
        camera = {name.removeprefix(_CAMERA): value for name, value in values.items() if name.startswith(_CAMERA)}
        # The motion is the same for all constants of the camera but the exposure.
        key = tuple(value for name, value in values.items() if not name.startswith(_CAMERA) or name == _EXPOSURE)
        if self._last is None or self._last[0] != key:
            self._last = key, means(self.motion(unknowns), self.track.time, values[_EXPOSURE])
        found = shown(self._last[1], camera)
        return {name: measured - found[name] for name, measured in self.track.channels.items()}

    def scaled(self, unknowns: _Reals) -> _Reals:
        residuals = self.residuals(unknowns)
        parts = [self._white[name](residual[self._seen[name]]) for name, residual in residuals.items()]
        # Constants of the camera are the last of the unknowns.
        camera = unknowns[unknowns.size - self._before.size :]
        return np.concatenate([*parts, (camera - self._before) / self._deviation])

    def reduced_chi_square(self, unknowns: _Reals) -> float:
        """Return the sum of squares over the number of measurements less that of unknowns."""
        white = self.scaled(unknowns)[: -self._before.size or None]
        return float(white @ white) / max(1, white.size - unknowns.size)

    def noise_of(self, unknowns: _Reals, known: dict[str, Noise], loss: str, correlated: bool) -> dict[str, Noise]:
        """Estimate the errors of each channel from the residuals."""
        relative = {name: self.relative(name)[seen] for name, seen in self._seen.items()}
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

    def refine(self, unknowns: _Reals, loss: str, tolerance: float = _FINE) -> Any:
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


def _first_guess(track: Track, given: dict[str, float]) -> dict[str, float]:
    """Read the start off a parabola through the first frames."""
    unknown = [name for name in given if name not in ("theta", "theta_rate", "slip", "x")]
    if unknown:
        raise ValueError(f"start has {', '.join(unknown)}; it can have theta, theta_rate, slip, x")

    def parabola(values: _Reals) -> tuple[float, float]:
        seen = np.flatnonzero(np.isfinite(values))[: max(6, len(track.time) // 8)]
        if seen.size < 3:
            raise ValueError("fewer than three frames with an angle or a position")
        time = track.time[seen] - track.time[0]
        curve = np.polyfit(time, values[seen], 2)
        for _ in range(3):
            # Outliers among the first frames would send the search astray.
            distance = np.abs(values[seen] - np.polyval(curve, time))
            kept = distance <= 4.0 * np.median(distance) + 1e-12
            if kept.sum() >= 3:
                curve = np.polyfit(time[kept], values[seen][kept], 2)
        _, rate, value = curve
        return float(value), float(rate)

    guess = {"theta": 0.0, "theta_rate": 0.0, "slip": 0.0, "x": 0.0}
    if track.x is not None:
        guess["x"], velocity = parabola(track.x)
        guess["theta_rate"] = -velocity
    if track.theta is not None:
        guess["theta"], guess["theta_rate"] = parabola(track.theta)
        if track.x is not None:
            guess["slip"] = velocity + guess["theta_rate"]
    return guess | given


def _guesses(problem: _Problem, any_angle: bool) -> list[_Reals]:
    """Return the unknowns at many places."""
    free = problem.names
    angles = np.linspace(-math.pi, math.pi, 24, endpoint=False) if any_angle else [problem.first["theta"]]
    mu_k = (problem.hoop.mu_k, *_TRY_MU_K) if "mu_k" in free else (problem.hoop.mu_k,)
    inertias = (
        [problem.hoop.inertia * factor for factor in _TRY_INERTIA] if "inertia" in free else [problem.hoop.inertia]
    )
    guesses = []
    for angle, kinetic, inertia in itertools.product(angles, mu_k, inertias):
        static = (
            (problem.hoop.mu_s, *(kinetic + step for step in _TRY_STEP)) if "mu_s" in free else (problem.hoop.mu_s,)
        )
        for mu_s in static:
            if kinetic <= mu_s:
                inertia = max(inertia, 2.0 * _LEAST_INERTIA)
                guesses.append(problem.guess(mu_s=mu_s, mu_k=kinetic, inertia=inertia, theta=float(angle)))
    return guesses


def _search(problem: _Problem, loss: str, any_angle: bool) -> Any:
    """Refine the best of many guesses.

    Bounces hang on each other: a coefficient of restitution is sought over a growing part of the track.
    """
    guesses = _guesses(problem, any_angle)
    parts, best = (_PARTS, _BEST_OF_PART) if "restitution" in problem.names else ((1.0,), _BEST)
    for part in parts:
        shorter = problem.part(part)
        guesses = [other for guess in guesses for other in problem.with_restitutions(guess)]
        costs = [float(np.sum(np.abs(shorter.scaled(guess)))) for guess in guesses]
        tolerance = _FINE if shorter is problem else _ROUGH
        found = [shorter.refine(guesses[i], loss, tolerance) for i in np.argsort(costs, kind="stable")[:best]]
        found.sort(key=lambda result: float(result.cost))
        guesses = [result.x for result in found]
    return found[0]


def _result(problem: _Problem, best: Any) -> FitResult:
    names = problem.names
    covariance, lost = _covariance(best.jac)
    at_bound = False
    if "mu_s" in names and "mu_k" in names:
        # The unknown is the excess of mu_s over mu_k.
        excess, kinetic = names.index("mu_s"), names.index("mu_k")
        change = np.eye(len(names))
        change[excess, kinetic] = 1.0
        covariance = change @ covariance @ change.T
        at_bound = best.active_mask[excess] != 0
        lost[excess] |= lost[kinetic]
    values = problem.values(best.x)
    motion = problem.motion(best.x)
    demand = _demand(motion)
    reasons = {names[i]: _DEPENDENT for i in np.flatnonzero(lost)}
    if at_bound:
        reasons |= dict.fromkeys(("mu_s", "mu_k"), "the fit ends at mu_s = mu_k: here the two cannot be told apart")
    for i, name in enumerate(names):
        if name == "restitution" and covariance[i, i] > 0.25:
            reasons.setdefault(name, "its standard error would exceed half of its range")
        elif name in _BY_DEFAULT and covariance[i, i] > values[name] ** 2:
            reasons.setdefault(name, "its standard error would exceed its value")
    reasons |= _unseen(motion, demand)
    reasons = {name: reasons[name] for name in names if name in reasons}
    for i in (names.index(name) for name in reasons):
        covariance[i, :] = covariance[:, i] = 0.0
        covariance[i, i] = math.inf
    estimates = {
        name: Estimate(values[name], math.sqrt(covariance[i, i]), name not in reasons) for i, name in enumerate(names)
    }
    result = FitResult(
        hoop=motion.hoop,
        start=motion.start,
        estimates=estimates,
        covariance=covariance,
        motion=motion,
        track=problem.track,
        residuals=problem.residuals(best.x),
        noise=dict(problem.noise),
        reduced_chi_square=problem.reduced_chi_square(best.x),
        mu_s_at_least=demand,
        message=str(best.message),
    )
    if reasons:
        words = "; ".join(f"{name} ({reason})" for name, reason in reasons.items())
        message = f"not identifiable from this motion: {words}"
        warnings.warn(IdentifiabilityWarning(message, tuple(reasons)), stacklevel=3)
    return result


def _unseen(motion: Trajectory, demand: float) -> dict[str, str]:
    """Return what nothing in a motion tells of, and why."""
    reasons = {}
    impacts = [transition.impact for transition in motion.transitions if transition.impact is not None]
    if not any(transition.cause == "slip" for transition in motion.transitions):
        reasons["mu_s"] = f"no slip out of rolling was seen, so that only mu_s >= {demand:.4g} is known"
    if not (any(phase.mode == "sliding" for phase in motion.phases) or any(one.before.slip != 0.0 for one in impacts)):
        reasons["mu_k"] = "no slide was seen, nor an impact that slips"
    if not impacts:
        reasons["restitution"] = "no impact was seen"
    return reasons


def _covariance(jacobian: _Reals) -> tuple[_Reals, npt.NDArray[np.bool_]]:
    """Return (JᵀJ)⁻¹, and which unknowns the residuals do not depend on, alone or apart from others."""
    norms = np.linalg.norm(jacobian, axis=0)
    scale = np.where(norms > 0.0, norms, 1.0)
    _, singular, rows = np.linalg.svd(jacobian / scale, full_matrices=False)
    # Differences of third order resolve the Jacobian to about 1e-10.
    lost = singular <= 1e-8 * singular[0]
    hidden = (norms == 0.0) | np.any(np.abs(rows[lost]) > 1e-3, axis=0)
    inverse = np.where(lost, 0.0, 1.0 / np.where(lost, 1.0, singular))
    root = rows.T * inverse / scale[:, None]
    return root @ root.T, hidden


def _demand(motion: Trajectory) -> float:
    """Largest |F|/N in rolling."""
    if not motion.phases:
        return 0.0
    samples = motion.sample(2001, min(motion.end_time, motion.shown_until))
    rolls = samples.is_in("rolling") & (samples.normal > 0.0)
    return float(np.max(np.abs(samples.friction[rolls]) / samples.normal[rolls], initial=0.0))
