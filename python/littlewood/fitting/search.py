"""Where a fit begins: guesses at many places, followed over a growing part of the track."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Mapping

import numpy as np

from .._internal.elementwise import Reals
from .._internal.extras import require
from .noise import EFFICIENCY
from .problem import LEAST_INERTIA, ROUGH, Problem
from .track import Track

__all__ = ["STEPS", "explains", "first_guess", "guesses_followed"]


# Coefficients and inertias that are tried first, because a motion depends smoothly on them only as
# long as the sequence of its phases is the same.
_TRY_MU_K = (0.05, 0.12, 0.2, 0.3, 0.4, 0.55, 0.75, 1.0)
_TRY_STEP = (0.01, 0.05, 0.1, 0.2, 0.4)
_TRY_INERTIA = (0.6, 0.8, 1.0, 1.25, 1.6)
_TRY_SLIP = (0.0, -3.0, -2.0, -1.2, -0.5, 0.5, 1.2, 2.0, 3.0)
# How many frames tell which guesses are the best.
_FRAMES_OF_GUESS = 50
# Parts of the track over which guesses are followed, how many over each, and how many where none of
# them foretold it. A part has this many measurements for each unknown, or more.
_PARTS = (0.15, 0.25, 0.35, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0)
_BEST, _BEST_OF_NEW = 3, 6
_ENOUGH = 3
# How many starts of guesses that failed are tried with all coefficients, and how many of these with
# all restitutions.
_STARTS, _MOST_OF_GRID = 2, 12
STEPS = len(_PARTS) * _BEST_OF_NEW
"""Guesses that are followed at most."""
_STEPS_OF_SEARCH = 40
# Guesses that differ by less lead to the same minimum.
_SAME = 1e-3
# So many frames have residuals of one sign where a guess is wrong.
_FRAMES_OF_WAVE = 8
# Of good tracks one in so many is not explained by its true motion, by chance.
_GOOD_TRACKS = 10_000


def first_guess(track: Track, slope: float, given: dict[str, float]) -> dict[str, float]:
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


def _guesses(
    problem: Problem, given: Mapping[str, float], first: Mapping[str, float]
) -> list[Reals]:
    """Return the unknowns at many places, for a start that is about the first of them."""
    free, any_angle = problem.names, problem.track.theta is None
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
        start = {**first, "theta": float(angle), "theta_rate": rate}
        if any_angle and problem.slips and "slip" not in given:
            start["slip"] = velocity + rate
        for mu_s in static:
            if kinetic <= mu_s:
                inertia = max(inertia, 2.0 * LEAST_INERTIA)
                guesses.append(problem.guess(mu_s=mu_s, mu_k=kinetic, inertia=inertia, **start))
    return guesses


def explains(problem: Problem, unknowns: Reals) -> bool:
    """Whether errors from frame to frame explain what a guess leaves of the track.

    It is the F test of the variance of the residuals against that of the frames, and that of sums
    over some frames, because residuals of another motion come in waves.
    """
    rest = problem.scaled(unknowns)
    count = rest.size // _FRAMES_OF_WAVE
    sums = np.sum(rest[: count * _FRAMES_OF_WAVE].reshape(count, _FRAMES_OF_WAVE), axis=1)
    sums /= math.sqrt(_FRAMES_OF_WAVE)
    known, fdtri = EFFICIENCY * rest.size, require("scipy.special").fdtri
    for values in (rest, sums):
        left = float(max(1, values.size - unknowns.size))
        if float(values @ values) / left >= fdtri(left, known, 1.0 - 1.0 / _GOOD_TRACKS):
            return False
    return True


def guesses_followed(
    problem: Problem, loss: str, given: Mapping[str, float], flies: bool, step: Callable[[], None]
) -> list[Reals]:
    """Refine the best of many guesses; return where they end, the best first.

    Events hang on each other: guesses are followed over a growing part of the track, and sought
    anew where what fits one part does not foretell the next. Where the track shows that the hoop
    never flies, no coefficient of restitution is sought.
    """
    guesses = _guesses(problem, given, problem.first)
    begun = False
    for part in _PARTS:
        shorter = problem.part(part)
        seen = sum(int(np.isfinite(values).sum()) for values in shorter.track.channels.values())
        if part < 1.0 and seen < _ENOUGH * len(problem.names):
            continue
        sparse = shorter.sparse(_FRAMES_OF_GUESS)
        misfits = [sparse.misfit(guess) for guess in guesses]
        if begun and explains(shorter, guesses[int(np.argmin(misfits))]) and part < 1.0:
            continue
        most = _BEST
        if not begun or not explains(sparse, guesses[int(np.argmin(misfits))]):
            most = _BEST_OF_NEW
            found = _elsewhere(sparse, guesses, misfits, begun, flies)
            guesses, misfits = guesses + found, [*misfits, *map(sparse.misfit, found)]
        # Guesses of one motion have one misfit: without an impact any restitution will do.
        _, places = np.unique(misfits, return_index=True)
        results = []
        for i in places[:most]:
            results.append(shorter.refine(guesses[i], loss, ROUGH, _STEPS_OF_SEARCH))
            step()
        results.sort(key=lambda result: float(result.cost))
        guesses, begun = _distinct([result.x for result in results]), True
    return guesses


def _elsewhere(
    problem: Problem, guesses: list[Reals], misfits: list[float], begun: bool, flies: bool
) -> list[Reals]:
    """Return other guesses: all coefficients with the best starts, and other restitutions."""
    best = [guesses[i] for i in np.argsort(misfits)]
    grid: list[Reals] = []
    for one in best[: _STARTS * begun]:
        values = problem.values(one)
        start = {name: float(values[f"start_{name}"]) for name in problem.first}
        grid += _guesses(problem, start, start)
    misfits_of_grid = [problem.misfit(one) for one in grid]
    best = best[:_MOST_OF_GRID] + [grid[i] for i in np.argsort(misfits_of_grid)[:_MOST_OF_GRID]]
    return grid + [other for one in best * flies for other in problem.other_restitutions(one)]


def _distinct(guesses: list[Reals]) -> list[Reals]:
    """Return the guesses without those that one before them leads to the minimum of."""
    kept: list[Reals] = []
    for guess in guesses:
        if not any(np.allclose(guess, other, rtol=_SAME, atol=_SAME) for other in kept):
            kept.append(guess)
    return kept
