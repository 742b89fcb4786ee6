"""Friction, inertia and restitution from a tracked motion, by least squares."""

from __future__ import annotations

import itertools
import math
import warnings
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from .._internal.elementwise import Reals, real
from .._internal.extras import progress_bar
from ..hoop import Hoop
from ..trajectory import Trajectory
from .calibration import checked
from .diagnostics import Doubt, doubts_of_residuals
from .estimate import Estimate
from .noise import Noise
from .problem import FINE, LEAST_INERTIA, OF_HOOP, ROUGH, Problem
from .profile import rise
from .result import FitResult, FitWarning, IdentifiabilityWarning
from .track import Track

__all__ = ["fit"]


# The coefficient of restitution says how a motion goes on that would end at its landing: it is
# asked for.
_BY_DEFAULT = ("mu_s", "mu_k", "inertia")
# Coefficients and inertias that are tried first, because a motion depends smoothly on them only as
# long as the sequence of its phases is the same.
_TRY_MU_K = (0.05, 0.12, 0.2, 0.3, 0.4, 0.55, 0.75, 1.0)
_TRY_STEP = (0.01, 0.05, 0.1, 0.2, 0.4)
_TRY_INERTIA = (0.6, 0.8, 1.0, 1.25, 1.6)
_TRY_SLIP = (0.0, -3.0, -2.0, -1.2, -0.5, 0.5, 1.2, 2.0, 3.0)
_BEST = 6
# How many frames tell which guesses are the best.
_FRAMES_OF_GUESS = 50
# Parts of the track over which a coefficient of restitution is sought, and how many guesses are
# followed over each.
_PARTS = (0.5, 0.6, 0.7, 0.8, 0.9, 1.0)
_BEST_OF_PART = 4
_STEPS_OF_SEARCH = 60
# A guess foretells a longer part where the residuals there are, on average, at most so many times
# those of the part it fits.
_FORETELLS = 2.0
# Guesses that differ by less lead to the same minimum.
_SAME = 1e-3
# How often the errors are estimated from the residuals, at most.
_TURNS = 12
# Neighbours of a fit whose sequences are looked at, how far they are in standard errors, how many
# other sequences are fitted, and the probability from which one is named.
_NEIGHBOURS = 40
_SPREAD = 3.0
_MOVES = (1.0, 2.0, 4.0, 8.0)
_LEAST_MOVE = 0.01
_RIVALS = 2
_STEPS_OF_RIVAL = 15
_RIVAL = 0.01
# A parameter is at a bound if it is nearer to it than this part of its standard error.
_AT_BOUND = 0.01
# The profile likelihood is looked at so many standard errors away; a normal interval is wrong where
# it rises by so many times more, or less, than a parabola: then the interval is wrong by a factor
# of two, or more.
_PROFILED = 2.0
_OTHER_RISE = 4.0
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
    free : iterable of {"mu_s", "mu_k", "inertia", "restitution", "slope"}, optional
        Parameters to estimate; the first three by default. With "restitution", or with a hoop that
        has one, the track may continue after a landing. The slope of the plane is that of `hoop`,
        or with "slope" its first guess, which should be right to about 0.1 rad.
    slips_at_start : bool, optional
        Whether to estimate the slip velocity at the start; otherwise it is 0.
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
        sliding and impacts, not by flight; the coefficient of restitution by impacts alone.

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
    likelihood, over a grid of s/σ and T. With another `loss` errors are taken for independent. Of a
    constant of the camera 0 ± 0.1 is known beforehand; they are displacements of what is seen, to
    first order: floor (0, 1), turn (−y, x), scale (x, y), stretch (x, −y), shear (y, x),
    perspective_x (x², x y), perspective_y (x y, y²), all that is between two homographies but a
    shift along x; middle_x and middle_y add cos θ and sin θ to the angle. A frame shows the mean
    over its exposure, which begins at its time.

    A parameter counts as not identifiable where the residuals do not depend on it apart from the
    others, where its standard error would exceed its value (or half of its range, for the
    coefficient of restitution), or where the fit ends at the bound μs = μk: there the motion
    depends on μs to second order only. The exact simulation makes the residuals smooth in all
    parameters as long as the sequence of phases is the same, and each impact of the same kind; over
    the sequences the fit starts from several places.

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
    first = _first_guess(track, hoop.slope, given)
    names = [*(name for name in OF_HOOP if name in free), "start_theta", "start_theta_rate"]
    names += ["start_x"] if track.x is not None else []
    names += ["start_slip"] if slips_at_start else []
    measured = sum(int(np.isfinite(values).sum()) for values in track.channels.values())
    if measured <= len(names):
        raise ValueError(
            f"{measured} measurements are not enough for {len(names)} unknowns: {', '.join(names)}"
        )
    camera = checked(track.calibration if calibration is None else calibration, track.channels)
    known = {name: Noise(real(value, f"sigma of {name}")) for name, value in (sigma or {}).items()}
    noise = dict.fromkeys(track.channels, Noise(1.0)) | known
    problem = Problem(track, hoop, tuple(names), first, noise, slips_at_start)
    parts, best_of_part = (_PARTS, _BEST_OF_PART) if "restitution" in names else ((1.0,), _BEST)
    total = len(parts) * best_of_part * search + _TURNS + 1
    with progress_bar(total, "steps", progress) as show:
        done = itertools.count(1)

        def step() -> None:
            show(next(done))

        others: list[Reals] = []
        if search:
            unknowns, *others = _search(problem, loss, start or {}, parts, best_of_part, step)
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
            best, sequences = _compared(problem, best, others)
        else:
            sequences = {problem.motion(best.x).sequence: 1.0}
        # Fewer guesses, or turns, may have been enough.
        show(total)
    return _result(problem, best, sequences, known, loss)


def _first_guess(track: Track, slope: float, given: dict[str, float]) -> dict[str, float]:
    """Read the start off a parabola through the first frames.

    On a slope it is read as if the hoop were in contact.
    """
    unknown = [name for name in given if name not in ("theta", "theta_rate", "slip", "x")]
    if unknown:
        raise ValueError(f"start has {', '.join(unknown)}; it can have theta, theta_rate, slip, x")

    def parabola(values: Reals) -> tuple[float, float]:
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
    turned = slope if track.level else 0.0
    if track.x is not None:
        guess["x"], velocity = parabola((track.x + math.sin(turned)) / math.cos(turned))
        guess["theta_rate"] = -velocity
    if track.theta is not None:
        guess["theta"], guess["theta_rate"] = parabola(track.theta - turned)
        if track.x is not None:
            guess["slip"] = velocity + guess["theta_rate"]
    return guess | given


def _guesses(problem: Problem, given: Mapping[str, float]) -> list[Reals]:
    """Return the unknowns at many places."""
    free, first, any_angle = problem.names, problem.first, problem.track.theta is None
    angles, rates = [first["theta"]], [first["theta_rate"]]
    mu_k: tuple[float, ...] = (problem.hoop.mu_k, *(_TRY_MU_K if "mu_k" in free else ()))
    factors: tuple[float, ...] = _TRY_INERTIA
    steps: tuple[float, ...] = _TRY_STEP
    if any_angle:
        # A position alone says nothing of the angle, and of its rate only where the hoop rolls.
        factors, steps, mu_k = (1.0,), _TRY_STEP[2:4], mu_k[:: 1 if len(mu_k) == 1 else 2]
        if "theta" not in given:
            angles = list(np.linspace(-math.pi, math.pi, 24, endpoint=False))
        if problem.slips and "theta_rate" not in given:
            rates = [rates[0] + slip for slip in _TRY_SLIP]
    inertias = (
        [problem.hoop.inertia * factor for factor in factors]
        if "inertia" in free
        else [problem.hoop.inertia]
    )
    velocity = first["slip"] - first["theta_rate"]
    guesses = []
    for angle, rate, kinetic, inertia in itertools.product(angles, rates, mu_k, inertias):
        static = (
            (problem.hoop.mu_s, *(kinetic + step for step in steps))
            if "mu_s" in free
            else (problem.hoop.mu_s,)
        )
        start = {"theta": float(angle), "theta_rate": rate}
        if any_angle and problem.slips and "slip" not in given:
            start["slip"] = velocity + rate
        for mu_s in static:
            if kinetic <= mu_s:
                inertia = max(inertia, 2.0 * LEAST_INERTIA)
                guesses.append(problem.guess(mu_s=mu_s, mu_k=kinetic, inertia=inertia, **start))
    return guesses


def _search(
    problem: Problem,
    loss: str,
    given: Mapping[str, float],
    parts: Iterable[float],
    best: int,
    step: Callable[[], None],
) -> list[Reals]:
    """Refine the best of many guesses; return where they end, the best first.

    Bounces hang on each other: a coefficient of restitution is sought over a growing part of the
    track, and sought anew where what fits one part does not foretell the next.
    """
    guesses = _guesses(problem, given)
    foretold = 0.0
    for part in parts:
        shorter = problem.part(part)
        sparse = shorter.sparse(_FRAMES_OF_GUESS)
        misfits = [sparse.misfit(guess) for guess in guesses]
        if min(misfits) > foretold:
            others = [other for guess in guesses for other in problem.other_restitutions(guess)]
            guesses, misfits = guesses + others, [*misfits, *map(sparse.misfit, others)]
        # Guesses of one motion have one misfit: without an impact any restitution will do.
        _, places = np.unique(misfits, return_index=True)
        found = []
        for i in places[:best]:
            found.append(shorter.refine(guesses[i], loss, ROUGH, _STEPS_OF_SEARCH))
            step()
        found.sort(key=lambda result: float(result.cost))
        guesses = _distinct([result.x for result in found])
        foretold = _FORETELLS * shorter.misfit(guesses[0])
    return guesses


def _distinct(guesses: list[Reals]) -> list[Reals]:
    """Return the guesses without those that one before them leads to the minimum of."""
    kept: list[Reals] = []
    for guess in guesses:
        if not any(np.allclose(guess, other, rtol=_SAME, atol=_SAME) for other in kept):
            kept.append(guess)
    return kept


def _compared(problem: Problem, best: Any, others: list[Reals]) -> tuple[Any, dict[str, float]]:
    """Fit other sequences of phases.

    Return the most probable fit and the probabilities of all.
    """
    rest = len(problem.names) - len(problem.camera_names)
    random = np.random.default_rng(0)
    low, high = problem.bounds()
    # What the track does not tell is anything within about 1, as in `_evidence`.
    root = np.sqrt(np.diag(np.linalg.inv(_normal(best))))
    guesses = [np.concatenate([other[:rest], best.x[rest:]]) for other in others]
    # Neighbours within a few standard errors, in all directions and by one parameter, which may be
    # of another sequence.
    for k, name in enumerate(problem.names):
        if name in OF_HOOP:
            moves = np.zeros((2 * len(_MOVES), root.size))
            moves[:, k] = np.concatenate([_MOVES, np.negative(_MOVES)]) * max(root[k], _LEAST_MOVE)
            guesses += list(np.clip(best.x + moves, low, high))
    for _ in range(_NEIGHBOURS):
        guesses.append(np.clip(best.x + _SPREAD * root * random.normal(size=root.size), low, high))
    found = {problem.motion(best.x).sequence: best}
    nearest: dict[str, tuple[float, Reals]] = {}
    for guess in guesses:
        sequence = problem.motion(guess).sequence
        if sequence not in found:
            misfit = problem.misfit(guess)
            if sequence not in nearest or misfit < nearest[sequence][0]:
                nearest[sequence] = misfit, guess
    for _, guess in sorted(nearest.values(), key=lambda one: one[0])[:_RIVALS]:
        other = problem.refine(guess, "linear", ROUGH, _STEPS_OF_RIVAL)
        sequence = problem.motion(other.x).sequence
        if sequence not in found or other.cost < found[sequence].cost:
            found[sequence] = other
    evidence = {sequence: _evidence(one) for sequence, one in found.items()}
    most = max(evidence.values())
    weights = {
        sequence: math.exp(max(value - most, -700.0)) for sequence, value in evidence.items()
    }
    order = sorted(weights, key=lambda sequence: -weights[sequence])
    total = sum(weights.values())
    winner = found[order[0]]
    if winner is not best:
        winner = problem.refine(winner.x, "linear", FINE)
    return winner, {sequence: weights[sequence] / total for sequence in order}


def _evidence(found: Any) -> float:
    """Return the logarithm of the probability of the measurements for a sequence.

    By Laplace's method.

    Beforehand each unknown is anything within about 1, in the units of the hoop.
    """
    return -float(found.cost) - 0.5 * float(np.linalg.slogdet(_normal(found))[1])


def _normal(found: Any) -> Reals:
    """Return the normal matrix of a fit, with what is known beforehand."""
    return np.asarray(found.jac.T @ found.jac + np.eye(found.x.size))


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
    problem: Problem, best: Any, sequences: dict[str, float], known: Mapping[str, Noise], loss: str
) -> FitResult:
    names = problem.names
    covariance, lost = _covariance(best.jac)
    met = _bounds_met(problem, best, covariance)
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
        reasons |= dict.fromkeys(
            ("mu_s", "mu_k"), "the fit ends at mu_s = mu_k: here the two cannot be told apart"
        )
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
        name: Estimate(values[name], math.sqrt(covariance[i, i]), name not in reasons)
        for i, name in enumerate(names)
    }
    doubts = []
    if reasons:
        words = "; ".join(f"{name} ({reason})" for name, reason in reasons.items())
        doubts.append(
            Doubt("identifiability", f"not identifiable from this motion: {words}", tuple(reasons))
        )
    ends = {name: values[name] for name in met if name not in reasons}
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
    doubts += doubts_of_residuals(problem, best.x, known, loss != "linear")
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

    It is that at the ends of the normal intervals.
    """
    wrong: dict[str, float] = {}
    for name, estimate in estimates.items():
        if name not in OF_HOOP or not estimate.identifiable or loss != "linear":
            continue
        low, high = problem.limits(name)
        for sign in (-1.0, 1.0):
            value = estimate.value + sign * _PROFILED * estimate.std_error
            if low < value < high:
                found = rise(problem, best.x, covariance, name, value) / _PROFILED**2
                if not 1.0 / _OTHER_RISE < found < _OTHER_RISE:
                    wrong[name] = found
    if not wrong:
        return []
    words = ", ".join(f"{name} ({part:.2g})" for name, part in wrong.items())
    message = (
        f"the likelihood of {words} is not that of a normal error ({_PROFILED:g} standard errors "
        f"away it falls by the "
        "number in brackets times as much): take profile_interval"
    )
    return [Doubt("interval", message, tuple(wrong))]


def _unseen(motion: Trajectory, demand: float) -> dict[str, str]:
    """Return what nothing in a motion tells of, and why."""
    reasons = {}
    impacts = [
        transition.impact for transition in motion.transitions if transition.impact is not None
    ]
    if not any(transition.cause == "slip" for transition in motion.transitions):
        reasons["mu_s"] = (
            f"no slip out of rolling was seen, so that only mu_s >= {demand:.4g} is known"
        )
    if not (
        any(phase.mode == "sliding" for phase in motion.phases)
        or any(one.before.slip != 0.0 for one in impacts)
    ):
        reasons["mu_k"] = "no slide was seen, nor an impact that slips"
    if not impacts:
        reasons["restitution"] = "no impact was seen"
    return reasons


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
