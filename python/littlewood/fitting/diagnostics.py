"""Doubts about a fit: what the residuals, the bounds and other fits say against it."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from statistics import NormalDist
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from .._internal.elementwise import Reals
from .._internal.extras import require
from .._internal.terminal import printable
from .calibration import CALIBRATION, determined
from .estimate import Estimate
from .noise import Noise
from .problem import CLOCK, OF_HOOP, ROUGH
from .usual_errors import USUAL_ERRORS, in_units

if TYPE_CHECKING:
    from .problem import Problem

__all__ = ["DOUBTS", "Doubt", "doubts_of_residuals"]


# Names of the doubts about a fit, and what they mean.
DOUBTS: Mapping[str, str] = {
    "identifiability": "a free parameter leaves no trace in the motion",
    "held": "the track contradicts a value that the fit holds",
    "unseen": "the ± hold if what was weighed and measured is right, which the track does not show",
    "camera": "the track shows a constant error of the camera that the fit does not estimate",
    "bound": "a free parameter ends at its bound",
    "sequences": "another sequence of phases explains the track nearly as well",
    "interval": "the ± of a parameter is too large or too small on one side at least: the track "
    "excludes more, or less, than it says",
    "structure": "residuals are not independent: the model, or the camera, is wrong by more than "
    "noise",
    "outliers": "some frames are far from the motion",
    "misfit": "the residuals are larger than the given errors",
}

_CAMERA = "camera_"
# Frames further off than so many standard deviations are outliers: of normal errors one in 10⁹ is.
_OUTLIER = 6.0
# Tests of residuals speak up beyond so many standard deviations: with some twenty tests of a track,
# one good track in 300 is doubted.
_LOUD = 4.2
_LAGS = 12
# No tracker resolves a millionth of a radius; residuals of that size are those of the arithmetic.
_LEAST_ERROR = 1e-6
# Of what else can be wrong, what explains at least this part of the best is named with it.
_ALSO = 0.8
# Of what is held, so many are named of those that explain the track by the first step.
_MOST_NAMED = 3
# Steps of a fit that finds what is held. It begins so many usual errors away, with few steps, and
# goes on from the best of these: where events hang on each other the sum of squares has many
# minima.
_STEPS_OF_FREED, _STEPS_OF_TRY, _STEPS_OF_BEST = 30, 12, 100
_TRIES = (-4.0, -2.0, 0.0, 2.0, 4.0)
# A cause explains at least this part of what the squares of the residuals have too much.
_EXPLAINS = 0.4
_TINY = 1e-300
# A derivative of which less is left beside those of the free parameters cannot be told from theirs.
_SEPARATE = 1e-3


@dataclass(frozen=True)
class Doubt:
    """A doubt about a fit.

    Attributes
    ----------
    name : str
        One of :data:`littlewood.fitting.DOUBTS`.
    message : str
        What was found.
    parameters : tuple of str
        What it is about: parameters, constants of the camera, or channels.
    """

    name: str
    message: str
    parameters: tuple[str, ...] = ()

    def __str__(self) -> str:
        return printable(f"{self.name}: {self.message}")


@dataclass(frozen=True)
class _Channel:
    """Residuals of a channel where it was seen, over relative errors.

    `sigma` is what differs from frame to frame.
    """

    frames: npt.NDArray[np.intp]
    residuals: Reals
    relative: Reals
    sigma: float

    @property
    def scaled(self) -> Reals:
        return np.asarray(self.residuals / self.sigma)


def doubts_of_residuals(
    problem: Problem, unknowns: Reals, known: Iterable[str], robust: bool
) -> list[Doubt]:
    """Return the doubts that the residuals of a fit raise.

    `known` are the channels whose errors were given.
    """
    known = set(known)
    channels = _channels_of(problem, unknowns, known)
    held, excess = _all_held(problem, unknowns, channels)
    waves = [*_structure(channels)]
    if not robust:
        waves += _outliers(channels)
        if waves:
            held = [_explaining(problem, unknowns, channels, one, known) for one in held]
        if any(one.freed is not None for one in held):
            # Beside what explains all nothing is a cause that leaves more than chance would.
            size = sum(one.residuals.size for one in channels.values())
            least = excess - _LOUD * math.sqrt(2.0 * size)
            held = [one for one in held if one.freed is not None or one.score**2 > least]
    found = [*_contradictions(problem, unknowns, held, excess), *waves]
    if not robust:
        found += _misfit(channels, known, unknowns.size)
    return found


def _channels_of(problem: Problem, unknowns: Reals, known: set[str]) -> dict[str, _Channel]:
    """Return the residuals by channel; the errors of those that are known were given."""
    residuals = problem.seen(problem.residuals(unknowns))
    relative = problem.seen({name: problem.track.relative_errors(name) for name in residuals})
    places = problem.seen(
        {name: np.arange(problem.track.time.size, dtype=np.float64) for name in residuals}
    )
    frames = {name: values.astype(np.intp) for name, values in places.items()}
    channels = {}
    for name, values in residuals.items():
        scaled = values / relative[name]
        sigma = (
            problem.noise[name].sigma
            if name in known
            else _from_frame_to_frame(scaled, frames[name])
        )
        channels[name] = _Channel(frames[name], scaled, relative[name], max(sigma, _LEAST_ERROR))
    return channels


def _from_frame_to_frame(residuals: Reals, frames: npt.NDArray[np.intp]) -> float:
    """Return the standard deviation of what differs from frame to frame: by second differences."""
    near = (frames[2:] - frames[:-2]) == 2
    # Waves leave second differences as they are.
    second = (residuals[2:] - 2.0 * residuals[1:-1] + residuals[:-2])[near]
    if second.size < 5:
        return float(np.std(residuals))
    # Of normal errors half are within 0.6745 standard deviations; a second difference has six
    # variances.
    return float(np.median(np.abs(second))) / (0.6745 * math.sqrt(6.0))


def _outliers(channels: Mapping[str, _Channel]) -> Iterator[Doubt]:
    for name, one in channels.items():
        typical = max(float(np.median(np.abs(one.residuals))) / 0.6745, one.sigma)
        far = np.flatnonzero(np.abs(one.residuals) > _OUTLIER * typical)
        if far.size:
            places = ", ".join(str(one.frames[k]) for k in far[:5]) + (
                ", …" if far.size > 5 else ""
            )
            frames = "1 frame is" if far.size == 1 else f"{far.size} frames are"
            yield Doubt(
                "outliers",
                f"{frames} more than {_OUTLIER:g} standard deviations of {name} off (number "
                f"{places}): "
                'did the tracker lose the hoop? loss="soft_l1" bears some',
                (name,),
            )


@dataclass(frozen=True, kw_only=True)
class _Held:
    """What a track says of something that the fit holds.

    Attributes
    ----------
    name : str
        Its name.
    value : float
        Its value.
    shown : float
        By how many standard deviations the residuals show an error of 1, apart from what the free
        parameters make up for.
    score : float
        By how many the residuals lean along such an error.
    is_separate : bool
        Whether they can be told from what the free parameters do.
    freed : Estimate or None
        What a fit finds that frees it, if that explains waves and outliers; `score` is then by how
        many standard deviations it is better.
    """

    name: str
    value: float
    shown: float
    score: float
    is_separate: bool
    freed: Estimate | None = None


def _all_held(
    problem: Problem, unknowns: Reals, channels: Mapping[str, _Channel]
) -> tuple[list[_Held], float]:
    """Return what is held, and what the squares of the residuals have too much."""
    weights = {name: 1.0 / (one.sigma * one.relative) for name, one in channels.items()}

    def stacked(columns: Mapping[str, Reals]) -> Reals:
        return np.concatenate(
            [(values.T * weights[name]).T for name, values in problem.seen(dict(columns)).items()]
        )

    free = stacked(problem.derivatives(unknowns))
    norms = np.linalg.norm(free, axis=0)
    norms = np.where(norms > 0.0, norms, 1.0)
    basis, singular, _ = np.linalg.svd(free / norms, full_matrices=False)
    basis = basis[:, singular > 1e-8 * singular[0]]
    residuals = np.concatenate([one.scaled for one in channels.values()])
    # Outliers have a doubt of their own.
    residuals = np.clip(residuals, -_OUTLIER, _OUTLIER)
    residuals = residuals - basis @ (basis.T @ residuals)
    values = problem.values(unknowns)
    camera = [_CAMERA + name for name in determined(CALIBRATION, channels)]
    found = []
    for name in (*problem.holdable, *camera):
        columns = None if name in problem.names else problem.derivative_by(name, values)
        if columns is None:
            continue
        slope = stacked(columns)
        apart = slope - basis @ (basis.T @ slope)
        size = float(np.linalg.norm(apart))
        found.append(
            _Held(
                name=name,
                value=float(values.get(name, 0.0)),
                shown=size,
                score=float(residuals @ apart) / max(size, _TINY),
                is_separate=size > _SEPARATE * float(np.linalg.norm(slope)),
            )
        )
    return found, float(residuals @ residuals) - residuals.size


def _contradictions(
    problem: Problem, unknowns: Reals, held: Iterable[_Held], excess: float
) -> Iterator[Doubt]:
    """Score tests of what is held.

    Whether the residuals lean along its derivative, apart from those of the fit.
    """
    # Nobody is asked for what cannot be, such as a rolling resistance that drives.
    found = sorted(
        (
            one
            for one in held
            if one.is_separate and problem.may_move(one.name, one.value, -one.score)
        ),
        key=lambda one: abs(one.score),
        reverse=True,
    )
    # What explains little of waves in the residuals is not their cause.
    if not found or abs(found[0].score) < max(_LOUD, math.sqrt(max(0.0, _EXPLAINS * excess))):
        return
    near = [one for one in found if abs(one.score) >= _ALSO * abs(found[0].score)]
    shown = [one for k, one in enumerate(near) if k < _MOST_NAMED or one.freed is not None]
    words = []
    for one in shown:
        freed = one.freed
        if freed is None:
            freed = Estimate(one.value - one.score / one.shown, 1.0 / one.shown, True)
            if one.name in problem.holdable:
                freed = _freed(problem, unknowns, one.name, freed)
        words.append(_asked(one, freed))
    remedy = ": put it into free" if shown[0].name in OF_HOOP else ""
    yield Doubt(
        "camera" if shown[0].name.startswith(_CAMERA) else "held",
        f"by {abs(found[0].score):.0f} standard errors the track asks for "
        f"{' or '.join(words)}{remedy}",
        tuple(one.name for one in shown),
    )


def _asked(one: _Held, freed: Estimate) -> str:
    """Return what a track asks for in place of what is held."""
    words = f"{one.name} {freed.value:.3g} ± {freed.std_error:.1g}"
    if one.name == "slope":
        words += f" ({math.degrees(freed.value):.2g}°)"
    words += f" in place of {one.value:.3g}"
    if one.name == CLOCK:
        other = "longer" if freed.value > 0.0 else "shorter"
        words += f" (all times {100.0 * abs(freed.value):.2g} % {other})"
    return words


def _freed(problem: Problem, unknowns: Reals, name: str, first: Estimate) -> Estimate:
    """Return what a fit finds for something held.

    A score is the `first` step to it, which is far too short where the motion is not linear in it.
    """
    freed = problem.freed(name)
    begin = freed.unknowns_of(problem.values(unknowns))
    found = freed.refine(begin, "linear", ROUGH, _STEPS_OF_FREED)
    estimate = freed.estimate_of(name, found)
    if not estimate.std_error > 0.0 or not found.cost < problem.cost(unknowns):
        return first
    return estimate


def _explaining(
    problem: Problem,
    unknowns: Reals,
    channels: Mapping[str, _Channel],
    one: _Held,
    known: set[str],
) -> _Held:
    """Return what is held with the fit that frees it, if that leaves neither waves nor outliers.

    A wrong fit may be far from the right one, where no derivative leads. All errors count as those
    from frame to frame, so that no slow noise makes up for the motion.
    """
    if one.name not in problem.holdable or not one.is_separate:
        return one
    noise = {name: Noise(channel.sigma) for name, channel in channels.items()}
    freed = replace(problem.freed(one.name), noise=noise)
    values, size = problem.values(unknowns), in_units(one.name, USUAL_ERRORS[one.name], one.value)
    low, high = freed.limits(one.name)
    places = (one.value + number * size for number in _TRIES)
    tries = [
        freed.refine(freed.unknowns_of(values | {one.name: place}), "linear", ROUGH, _STEPS_OF_TRY)
        for place in places
        if low <= place <= high
    ]
    best = min(tries, key=lambda found: float(found.cost))
    best = freed.refine(best.x, "linear", ROUGH, _STEPS_OF_BEST)
    left = _channels_of(freed, best.x, known)
    better = replace(problem, noise=noise).cost(unknowns) - float(best.cost)
    if better <= 0.0 or any((*_structure(left), *_outliers(left))):
        return one
    estimate = freed.estimate_of(one.name, best)
    score = math.copysign(math.sqrt(2.0 * better), one.value - estimate.value)
    return replace(one, score=score, freed=estimate)


def _structure(channels: Mapping[str, _Channel]) -> Iterator[Doubt]:
    limit = 2.0 * NormalDist().cdf(-_LOUD)
    for name, one in channels.items():
        count = one.residuals.size
        if count < 2 * _LAGS:
            continue
        above = one.residuals > 0.0
        ups = int(above.sum())
        downs = count - ups
        runs = 1 + int(np.count_nonzero(above[1:] != above[:-1]))
        mean = 1.0 + 2.0 * ups * downs / count
        spread = math.sqrt(max((mean - 1.0) * (mean - 2.0) / (count - 1.0), 1e-300))
        too_few = (mean - runs) / spread
        typical = max(float(np.median(np.abs(one.residuals))) / 0.6745, one.sigma)
        clipped = np.clip(one.residuals, -_OUTLIER * typical, _OUTLIER * typical)
        power = float(clipped @ clipped)
        after = [float(clipped[lag:] @ clipped[:-lag]) / power for lag in range(1, _LAGS + 1)]
        portmanteau = (
            count
            * (count + 2.0)
            * sum(r * r / (count - lag) for lag, r in enumerate(after, start=1))
        )
        # Residuals below the resolution of any tracker are those of the arithmetic.
        resolved = float(np.std(one.residuals)) > 2.0 * _LEAST_ERROR
        if resolved and (
            too_few > _LOUD or require("scipy.special").chdtrc(_LAGS, portmanteau) < limit
        ):
            size = float(np.sqrt(np.mean(np.square(one.residuals))))
            yield Doubt(
                "structure",
                f"residuals of {name} come in waves ({runs} runs of one sign, {mean:.0f} expected; "
                f"correlation "
                f"with the next {after[0]:.2f}; {size:.2g}, of which {one.sigma:.2g} differs from "
                f"frame to frame)",
                (name,),
            )


def _misfit(channels: Mapping[str, _Channel], known: set[str], unknowns: int) -> Iterator[Doubt]:
    """Compare sums of squares with given errors."""
    for name in known & set(channels):
        scaled = channels[name].scaled
        excess = (float(scaled @ scaled) - scaled.size) / math.sqrt(2.0 * scaled.size)
        if excess > _LOUD:
            ratio = math.sqrt(float(scaled @ scaled) / max(1, scaled.size - unknowns))
            yield Doubt(
                "misfit",
                f"residuals of {name} are {ratio:.2g} times as large as the given sigma",
                (name,),
            )
