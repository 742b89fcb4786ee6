"""Friction, inertia and restitution from a tracked motion, by least squares."""

from __future__ import annotations

import itertools
import math
import warnings
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from pathlib import Path
from statistics import NormalDist
from typing import Any

import numpy as np
import numpy.typing as npt

from .._internal.elementwise import Reals, real
from .._internal.extras import progress_bar, require
from ..hoop import Hoop
from ..trajectory import Trajectory
from .calibration import checked
from .diagnostics import Doubt, doubts_of_residuals
from .estimate import Estimate
from .fall import never_flies
from .given import checked_errors, errors_of_given, unseen
from .noise import Noise, error_of_frames
from .problem import FINE, OF_HOOP, RESISTANCE_BEFOREHAND, ROUGH, Problem
from .profile import rise
from .result import FitResult, FitWarning, IdentifiabilityWarning
from .search import STEPS, explains, first_guess, guesses_followed
from .sequences import Compared, compared
from .track import Track

__all__ = ["fit"]


# The coefficient of restitution says how a motion goes on that would end at its landing: it is
# asked for. Rolling resistance is not: every hoop has some, and a fit without it makes up for the
# loss by friction and inertia.
_BY_DEFAULT = ("mu_s", "mu_k", "inertia", "rolling_resistance")
# What has no value that is smaller than its standard error.
_POSITIVE = ("mu_s", "mu_k", "inertia")
# How often the errors are estimated from the residuals, at most.
_TURNS = 12
# The probability from which another sequence is named.
_RIVAL = 0.05
# A start whose slip seems to be at most so large, √(g R), may roll.
_MAY_ROLL = 0.5
# Errors of places before constants of the camera are estimated, R.
_PLANE = 0.01
# A parameter is at a bound if it is nearer to it than this part of its standard error.
_AT_BOUND = 0.01
# The profile likelihood is looked at so many standard errors away; a normal interval is wrong where
# it rises by so many times more, or less, than a parabola: then the interval is wrong by a factor
# of two, or more.
_PROFILED = 2.0
_OTHER_RISE = 4.0
# Two parameters that are so correlated are told apart badly.
_RELATED = 0.9
# Degrees of freedom of a variance that is known; so many samples tell that an error is smaller.
_MANY, _TELLING = 1e6, 100.0
_FAR_BELOW = -20.0
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
    errors: Mapping[str, float] | None = None,
    progress: bool = False,
) -> FitResult:
    r"""Estimate friction, inertia and restitution of a hoop from a tracked motion.

    The start (angle, rate, position, optionally slip velocity) is estimated, too. Masses and the
    place of the particle are taken from `hoop`: they are weighed and measured.

    Parameters
    ----------
    track : Track, str or Path
        The track, or its CSV file (:meth:`Track.from_csv`).
    hoop : Hoop
        The hoop with what is known; its values of what is free are a first guess. Its law of
        restitution is taken as it is.
    free : iterable of str, optional
        Parameters to estimate: "mu_s", "mu_k", "inertia", "rolling_resistance", which are the
        default, "restitution" and "slope". With "restitution", or with a hoop that has one, the
        track may continue after a landing. The slope of the plane is that of `hoop`, or with
        "slope" its first guess, which should be right to about 0.1 rad.
    slips_at_start : bool, optional
        Whether to estimate the slip velocity at the start; otherwise it is 0. Where a start that
        rolls is the more probable, it is 0 as well, and no `start_slip` is estimated.
    start : mapping, optional
        First guesses of `theta`, `theta_rate`, `slip`, `x` where the first frames do not determine
        them.
    sigma : mapping, optional
        Standard deviations of the measurements of `theta` (rad), `x` and `y` (R), which are then
        taken for independent. By default the errors of each channel are estimated from the
        residuals, as a part that differs from frame to frame and one that changes slowly. Where the
        track has errors of single frames, they are those of a frame whose error is the median.
    until : float, optional
        Last time τ, √(R/g), that is used. Without a coefficient of restitution leave out what comes
        after the landing, which is not simulated then.
    loss : {"linear", "soft_l1", "huber", "cauchy", "arctan"}, optional
        As :func:`scipy.optimize.least_squares` has it; all but the first bear outliers.
    search : bool, optional
        Whether to begin at many places. Without it the fit begins at the values of `hoop` and
        `start` alone, which is many times as fast, and finds the sequence of phases only if they
        have it.
    calibration : iterable of str, optional
        Constant errors of the camera to estimate (as `camera_floor`, …): "floor" (the height of the
        centre), "turn", "scale", "stretch", "shear", "perspective_x" and "perspective_y" of the
        frame, "marker" (the angle), "middle_x" and "middle_y" (the centre against the marker), and
        "exposure" (exposure time). By default all for a track of :func:`track_video`, none for
        others. Those that no channel determines are omitted.
    errors : mapping, optional
        How well what was weighed and measured is known, as standard errors: "mass_ratio", "offset",
        "inertia" and what else of the hoop is held as parts of its values, "slope" in rad, "clock"
        as a part of all times, "rolling_resistance" in R, and constants of the camera as
        "camera_scale", …. Standard errors then include what they may have wrong, as far as the
        track does not tell it. By default they are right; :data:`littlewood.fitting.USUAL_ERRORS`
        are those of scales, rulers and telephones.
    progress : bool, optional
        Whether to show a progress bar (tqdm).

    Returns
    -------
    FitResult

    Warns
    -----
    littlewood.fitting.FitWarning
        For each doubt that the fit has (:data:`littlewood.fitting.DOUBTS`), which the result, its
        table and its picture name, too.
    littlewood.fitting.IdentifiabilityWarning
        If the motion does not depend on something that is free. μs enters by the instant of a slip
        out of rolling alone (a motion without one gives only a lower bound, the friction that
        rolling needed), μk by slides and by impacts that slip; the inertia enters by rolling,
        sliding and impacts, not by flight; the coefficient of restitution by impacts alone; rolling
        resistance by what the hoop loses while it turns in contact, which on a ramp that it only
        rolls down a smaller slope explains as well.

    Raises
    ------
    ValueError
        For unknown names, or fewer measurements than unknowns.

    Notes
    -----
    With the errors e of a channel at the times t, of the covariance

    .. math:: V_{ij} = \sigma^2 w_i^2 \delta_{ij} + s^2 e^{-|t_i - t_j|/T},

    w being the errors that the track has over their median, the fit minimises eᵀV⁻¹e, and the
    covariance of the estimates is (JᵀV⁻¹J)⁻¹ with the derivatives J of all channels by all
    unknowns, those of the camera among them. σ, s and T are those of the largest restricted
    likelihood, over a grid of s/σ and T. With another `loss` errors are taken for independent.
    Beforehand a constant of the camera is 0 ± 0.1, and rolling resistance 0 ± 0.05, so that where a
    track does not tell it the intervals of the others bear it. Constants of the camera are
    displacements of what is seen, to first order: floor (0, 1), turn (−y, x), scale (x, y), stretch
    (x, −y), shear (y, x), perspective_x (x², x y), perspective_y (x y, y²), all that is between two
    homographies but a shift along x; middle_x and middle_y add cos θ and sin θ to the angle. A
    frame shows the mean over its exposure, which begins at its time.

    A parameter counts as not identifiable where the residuals do not depend on it apart from the
    others, where its standard error would exceed its value (or half of its range, for the
    coefficient of restitution), where the track tells less of it than is known beforehand (rolling
    resistance), or where the fit ends at the bound μs = μk: there the motion depends on μs to
    second order only. The exact simulation makes the residuals smooth in all parameters as long as
    the sequence of phases is the same, and each impact of the same kind; over the sequences the fit
    starts from several places.

    Examples
    --------
    >>> import numpy as np, littlewood as lw
    >>> hoop = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4)
    >>> time = np.linspace(0, 2.0, 200)
    >>> seen = hoop.simulate(theta=2.5, theta_rate=3)(time)
    >>> result = lw.fit(lw.Track(time, theta=seen.theta, x=seen.x), hoop)
    >>> abs(result.hoop.mu_s - 0.5) < 1e-6
    True
    """
    if not isinstance(track, Track):
        track = Track.from_csv(track, hoop.units)
    if until is not None:
        track = track.until(until)
    free = tuple(free)
    unknown = [name for name in free if name not in OF_HOOP]
    if unknown or not free:
        raise ValueError(f"free = {free} must name some of {', '.join(OF_HOOP)}")
    unknown = [name for name in (sigma or {}) if name not in track.channels]
    if unknown:
        raise ValueError(
            f"sigma has {', '.join(unknown)}, the track has {', '.join(track.channels)}"
        )
    given = {name: real(value, f"start of {name}") for name, value in (start or {}).items()}
    first = first_guess(track, hoop.slope, given)
    names = [*(name for name in OF_HOOP if name in free), "start_theta", "start_theta_rate"]
    names += ["start_x"] if track.x is not None else []
    names += ["start_slip"] if slips_at_start else []
    measured = sum(int(np.isfinite(values).sum()) for values in track.channels.values())
    if measured <= len(names):
        raise ValueError(
            f"{measured} measurements are not enough for {len(names)} unknowns: {', '.join(names)}"
        )
    told = checked_errors(errors or {})
    camera = checked(track.calibration if calibration is None else calibration, track.channels)
    known = {name: Noise(real(value, f"sigma of {name}")) for name, value in (sigma or {}).items()}
    # Before constants of the camera are estimated, places are known to a per cent.
    unsure = _PLANE if camera else 0.0
    noise = {
        name: Noise(math.hypot(error_of_frames(values[np.isfinite(values)]), unsure))
        for name, values in track.channels.items()
    }
    problem = Problem(track, hoop, tuple(names), first, noise | known, slips_at_start)
    flies = not never_flies(track, hoop)
    total = STEPS * search + _TURNS + 1
    with progress_bar(total, "steps", progress) as show:
        done = itertools.count(1)

        def step() -> None:
            show(next(done))

        others: list[Reals] = []
        if search:
            problem, unknowns, *others = _searched(problem, loss, given, flies, step)
        elif camera:
            # Without its constants the fit would leave the sequence of phases of a good guess.
            unknowns = problem.guess()
        else:
            unknowns = problem.refine(problem.guess(), loss).x
        if camera:
            problem, unknowns = problem.with_camera(camera, unknowns)
            # A hundred times as large as the errors, at first they would be taken for them.
            unknowns = problem.camera_of(unknowns)
        # Weights from residuals, and again with those weights, until they remain.
        for turn in range(_TURNS):
            noise = problem.noise_of(unknowns, known, loss, turn > 0)
            is_last = turn == _TURNS - 1 or (
                turn > 1 and all(one.is_close(problem.noise[name]) for name, one in noise.items())
            )
            problem = replace(problem, noise=noise)
            tolerance, most = (FINE, 50) if is_last else (ROUGH, 30)
            best = problem.refine(unknowns, loss, tolerance, most)
            unknowns = best.x
            step()
            if is_last:
                break
        if loss == "linear":
            found = compared(problem, best, others, slips_at_start, flies)
        else:
            found = Compared(problem, best, {problem.motion(best.x).sequence: 1.0}, None)
        # Fewer guesses, or turns, may have been enough.
        show(total)
    return _result(found, known, loss, told)


def _searched(
    problem: Problem,
    loss: str,
    given: Mapping[str, float],
    flies: bool,
    step: Callable[[], None],
) -> tuple[Any, ...]:
    """Search from a rolling start, where it may be one, and from one that slips.

    Return the problem with the start that explains the track, and where guesses end.
    """
    if not problem.slips or "slip" in given or abs(problem.first["slip"]) > _MAY_ROLL:
        return problem, *guesses_followed(problem, loss, given, flies, step)
    rolling = problem.rolling()
    found = guesses_followed(rolling, loss, given, flies, step)
    if explains(rolling, found[0]):
        return rolling, *found
    slipping = guesses_followed(problem, loss, given, flies, step)
    if rolling.cost(found[0]) <= problem.cost(slipping[0]):
        return rolling, *found
    return problem, *slipping


def _bounds_met(problem: Problem, best: Any, covariance: Reals) -> list[str]:
    """Return the parameters of the hoop that end at their bounds."""
    low, high = problem.bounds()
    met = []
    for k, name in enumerate(problem.names):
        near = _AT_BOUND * min(math.sqrt(max(covariance[k, k], 0.0)), 1.0) + 1e-9
        if name in OF_HOOP and (best.x[k] - low[k] <= near or high[k] - best.x[k] <= near):
            met.append(name)
    return met


def _result(
    found: Compared, known: Mapping[str, Noise], loss: str, told: Mapping[str, float]
) -> FitResult:
    problem, best, sequences = found.problem, found.best, found.sequences
    names = problem.names
    covariance, lost = _covariance(best.jac)
    moments = None if found.told is None else found.told.moments
    of_given = errors_of_given(problem, best, told)
    met = _bounds_met(problem, best, covariance)
    at_bound = False
    change = np.eye(len(names))
    if "mu_s" in names and "mu_k" in names:
        # The unknown is the excess of mu_s over mu_k.
        excess, kinetic = names.index("mu_s"), names.index("mu_k")
        change[excess, kinetic] = 1.0
        covariance = change @ covariance @ change.T
        of_given = change @ of_given @ change.T
        moments = None if moments is None else change @ moments @ change.T
        at_bound = best.active_mask[excess] != 0
        lost[excess] |= lost[kinetic]
    values = problem.values(best.x)
    motion = problem.motion(best.x)
    demand = _demand(motion)
    reasons = {names[i]: _DEPENDENT for i in np.flatnonzero(lost)}
    if at_bound:
        reasons |= dict.fromkeys(
            ("mu_s", "mu_k"), "the fit ends at mu_s = mu_k: here the two cannot be told apart"
        )
    for i, name in enumerate(names):
        if name == "restitution" and covariance[i, i] > 0.25:
            reasons.setdefault(name, "its standard error would exceed half of its range")
        elif name == "rolling_resistance" and covariance[i, i] > 0.5 * RESISTANCE_BEFOREHAND**2:
            reasons.setdefault(name, _hidden_resistance(names, covariance))
        elif name in _POSITIVE and covariance[i, i] > values[name] ** 2:
            reasons.setdefault(name, "its standard error would exceed its value")
    reasons |= _unseen(motion, demand)
    reasons = {name: reasons[name] for name in names if name in reasons}
    covariance = _of_no_less_than_nothing(problem, best, covariance)
    for i in (names.index(name) for name in reasons):
        covariance[i, :] = covariance[:, i] = 0.0
        covariance[i, i] = math.inf
    estimates = {
        name: Estimate(values[name], math.sqrt(covariance[i, i]), name not in reasons)
        for i, name in enumerate(names)
    }
    doubts = []
    if reasons:
        words = "; ".join(f"{name} ({reason})" for name, reason in reasons.items())
        doubts.append(
            Doubt("identifiability", f"not identifiable from this motion: {words}", tuple(reasons))
        )
    # Hardly any rolling resistance is nothing to doubt.
    ends = {
        name: values[name] for name in met if name not in reasons and name != "rolling_resistance"
    }
    if ends:
        words = ", ".join(f"{name} = {value:.4g}" for name, value in ends.items())
        doubts.append(
            Doubt(
                "bound", f"{words} is at its bound: its interval is one-sided at best", tuple(ends)
            )
        )
    second = [(sequence, part) for sequence, part in list(sequences.items())[1:] if part > _RIVAL]
    if second:
        words = ", ".join(f"{sequence} ({part:.2g})" for sequence, part in second)
        message = f"with the probability in brackets the phases are {words}, not {motion.sequence}"
        doubts.append(Doubt("sequences", message, tuple(sequence for sequence, _ in second)))
    doubts += _wrong_intervals(problem, best, covariance, estimates, loss)
    if found.told is not None and moments is not None:
        covariance = _as_sampled(covariance, moments, found.told.effective)
    covariance = covariance + of_given
    estimates = {
        name: replace(one, std_error=math.sqrt(covariance[i, i]))
        for i, (name, one) in enumerate(estimates.items())
    }
    doubts += doubts_of_residuals(problem, best.x, known, loss != "linear")
    doubts += unseen(problem, best, change, estimates, told)
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
        doubts=tuple(doubts),
        sequences=sequences,
        _problem=problem,
        _unknowns=best.x,
    )
    for doubt in doubts:
        kind = IdentifiabilityWarning if doubt.name == "identifiability" else FitWarning
        warnings.warn(kind(doubt), stacklevel=3)
    return result


def _wrong_intervals(
    problem: Problem, best: Any, covariance: Reals, estimates: Mapping[str, Estimate], loss: str
) -> list[Doubt]:
    """Compare the rise of the profile likelihood with that of a parabola.

    It is that at the ends of the normal intervals. On the side of an interval on which rolling
    resistance would be negative the likelihood ends sooner: such an interval is only too wide.
    """
    wrong: dict[str, float] = {}
    for k, (name, estimate) in enumerate(estimates.items()):
        if name not in OF_HOOP or not estimate.identifiable or loss != "linear":
            continue
        low, high = problem.limits(name)
        for sign in (-1.0, 1.0):
            value = estimate.value + sign * _PROFILED * estimate.std_error
            if low < value < high:
                found = rise(problem, best.x, covariance, name, value) / _PROFILED**2
                most = _OTHER_RISE
                if "rolling_resistance" in estimates:
                    place = list(estimates).index("rolling_resistance")
                    moved = (value - estimate.value) * covariance[place, k] / covariance[k, k]
                    if estimates["rolling_resistance"].value + moved < 0.0:
                        most = math.inf
                if not 1.0 / _OTHER_RISE < found < most:
                    wrong[name] = found
    if not wrong:
        return []
    narrow = [name for name, part in wrong.items() if part < 1.0]
    wide = [name for name, part in wrong.items() if part > 1.0]
    sentences = []
    if narrow:
        sentences.append(
            f"the ± of {', '.join(narrow)} is too small: values further away fit the track nearly "
            "as well"
        )
    if wide:
        sentences.append(
            f"the ± of {', '.join(wide)} is too large on one side at least: the track excludes "
            "values within it"
        )
    message = f"{'; '.join(sentences)} (profile_interval has the right ends)"
    return [Doubt("interval", message, tuple(wrong))]


def _of_no_less_than_nothing(problem: Problem, best: Any, covariance: Reals) -> Reals:
    """Return a covariance that knows that rolling resistance is not negative.

    Without that bound resistance has a normal error about where its derivative vanishes, which may
    be below 0. What is left of it above 0 has the mean square, about the estimate, that counts
    here; the others depend on it as before.
    """
    if "rolling_resistance" not in problem.names:
        return covariance
    place = problem.names.index("rolling_resistance")
    variance = float(covariance[place, place])
    if not 0.0 < variance < math.inf:
        return covariance
    size, value = math.sqrt(variance), float(best.x[place])
    # At its bound the sum of squares still falls: so far a step would lead below it.
    free = value - variance * float(best.jac[:, place] @ problem.scaled(best.x))
    square = _square_above_nothing(free, size, value)
    column = covariance[:, place] / variance
    return np.asarray(covariance - (variance - square) * np.outer(column, column))


def _square_above_nothing(mean: float, size: float, value: float) -> float:
    """Return the mean square distance from a value of what has a normal error and is positive."""
    above = mean / size
    # Far below 0 it is the tail of an exponential distribution.
    if above < _FAR_BELOW:
        return 2.0 * (size / above) ** 2
    ratio = NormalDist().pdf(above) / (0.5 * math.erfc(-above / math.sqrt(2.0)))
    return size**2 * (1.0 - ratio * (ratio + above)) + (mean + size * ratio - value) ** 2


def _as_sampled(covariance: Reals, moments: Reals, effective: float) -> Reals:
    """Return a covariance whose standard errors are those of samples, where these are others.

    That is where the F test of the two variances says so at 1 %: the likelihood is no parabola, or
    ends where another sequence of phases begins. Few samples among many unknowns miss what is far
    away, so that they make no error smaller.
    """
    fdtri = require("scipy.special").fdtri
    high = float(fdtri(effective, _MANY, 0.99))
    low = float(fdtri(effective, _MANY, 0.01)) if effective >= _TELLING else 0.0
    normal, sampled = np.diag(covariance), np.diag(moments)
    finite = np.isfinite(normal) & (normal > 0.0)
    ratio = np.where(finite, sampled / np.where(finite, normal, 1.0), 1.0)
    factor = np.sqrt(np.where((ratio > high) | (ratio < low), ratio, 1.0))
    found = covariance * factor * factor[:, None]
    found[~np.isfinite(covariance)] = math.inf
    return np.asarray(found)


def _unseen(motion: Trajectory, demand: float) -> dict[str, str]:
    """Return what nothing in a motion tells of, and why."""
    reasons = {}
    impacts = [
        transition.impact for transition in motion.transitions if transition.impact is not None
    ]
    if not any(transition.cause == "slip" for transition in motion.transitions):
        reasons["mu_s"] = "no slip out of rolling was seen, " + (
            f"so that only mu_s >= {demand:.4g} is known" if demand > 0.0 else "nor any rolling"
        )
    if not (
        any(phase.mode == "sliding" for phase in motion.phases)
        or any(one.before.slip != 0.0 for one in impacts)
    ):
        reasons["mu_k"] = "no slide was seen, nor an impact that slips"
    if not impacts:
        reasons["restitution"] = "no impact was seen"
    return reasons


def _hidden_resistance(names: tuple[str, ...], covariance: Reals) -> str:
    """Return why a track does not tell the rolling resistance, and what would."""
    place = names.index("rolling_resistance")
    sizes = np.sqrt(np.diag(covariance))
    related = np.abs(covariance[place]) / (sizes * sizes[place])
    related[place] = 0.0
    other = int(np.argmax(related))
    if related[other] < _RELATED:
        return "the hoop hardly turns in contact: let it roll longer"
    if names[other] == "slope":
        return "a smaller slope explains the same: let it roll up and down, or measure the slope"
    return f"{names[other]} explains the same: let it roll longer"


def _covariance(jacobian: Reals) -> tuple[Reals, npt.NDArray[np.bool_]]:
    """Return (JᵀJ)⁻¹, and which unknowns it does not tell.

    The residuals do not depend on these, alone or apart from others.
    """
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
