"""Doubts about a fit: what the residuals, the bounds and other fits say against it."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from statistics import NormalDist
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from .._internal.elementwise import Reals
from .._internal.extras import require
from .._internal.terminal import printable
from .calibration import CALIBRATION, determined
from .problem import OF_HOOP, ROUGH

if TYPE_CHECKING:
    from .problem import Problem

__all__ = ["DOUBTS", "Doubt", "doubts_of_residuals"]


# Names of the doubts about a fit, and what they mean.
DOUBTS: Mapping[str, str] = {
    "identifiability": "a free parameter leaves no trace in the motion",
    "held": "the track contradicts a value that the fit holds",
    "unseen": "a value that the fit holds matters, and the track does not show whether it is right",
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
# Steps of a fit that finds what is held.
_STEPS_OF_FREED = 30
# A cause explains at least this part of what the squares of the residuals have too much.
_EXPLAINS = 0.4
# By how much somebody may have wrong what a fit holds: a part of it, a part of 1, an angle or R.
_IN_PARTS = ("mu_s", "mu_k", "inertia", "restitution", "mass_ratio", "offset")
_WRONG_BY = {
    **dict.fromkeys(("mu_s", "mu_k", "restitution"), 0.1),
    **dict.fromkeys(("inertia", "mass_ratio"), 0.05),
    **dict.fromkeys(("offset", "camera_scale"), 0.03),
    **dict.fromkeys(("slope", "camera_turn"), math.radians(2.0)),
    **dict.fromkeys(("camera_floor", "camera_stretch", "camera_shear"), 0.02),
    **dict.fromkeys(("camera_middle_x", "camera_middle_y"), 0.02),
    **dict.fromkeys(("camera_perspective_x", "camera_perspective_y"), 0.005),
    "rolling_resistance": 0.01,
    "clock": 0.04,
    "camera_marker": math.radians(3.0),
    "camera_exposure": 0.0,
}
_ANGLES = ("slope", "camera_turn", "camera_marker")
_PARTS = ("clock", "camera_scale", "camera_stretch", "camera_shear")
# An error that the residuals show by so many standard deviations has a doubt, but for one track in
# thirty; one that moves a result by so many standard errors makes it wrong.
_SHOWN = 6.0
_MATTERS = 2.0
# Of the errors that somebody may make this part is too small to speak of.
_LARGE = 0.3
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
    problem: Problem, unknowns: Reals, known: Iterable[str], robust: bool, told: Iterable[str]
) -> list[Doubt]:
    """Return the doubts that the residuals of a fit raise.

    `known` are the channels whose errors were given, and `told` what is held with an error that was
    given.
    """
    known = set(known)
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
    held, excess = _all_held(problem, unknowns, channels)
    found = [
        *_contradictions(problem, unknowns, held, excess),
        *_unseen(one for one in held if one.name not in told),
    ]
    found += _structure(channels)
    if not robust:
        found += [*_outliers(channels), *_misfit(channels, known, unknowns.size)]
    return found


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
    moved : mapping of str to float
        By how many standard errors an error of 1 moves each parameter of the hoop.
    """

    name: str
    value: float
    shown: float
    score: float
    is_separate: bool
    moved: Mapping[str, float]

    @property
    def hidden(self) -> float:
        """The largest error that somebody may make and that the residuals may not show.

        None where they show all but small ones.
        """
        most = _WRONG_BY[self.name] * (abs(self.value) if self.name in _IN_PARTS else 1.0)
        hidden = min(most, _SHOWN / max(self.shown, _TINY))
        return hidden if hidden >= _LARGE * most else 0.0


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
    basis, singular, rows = np.linalg.svd(free / norms, full_matrices=False)
    kept = singular > 1e-8 * singular[0]
    basis, singular, rows = basis[:, kept], singular[kept], rows[kept]
    errors = np.linalg.norm(rows / singular[:, None], axis=0) / norms
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
        along = basis.T @ slope
        apart = slope - basis @ along
        size = float(np.linalg.norm(apart))
        moved = (rows.T @ (along / singular)) / norms / np.where(errors > 0.0, errors, 1.0)
        found.append(
            _Held(
                name=name,
                value=float(values.get(name, 0.0)),
                shown=size,
                score=float(residuals @ apart) / max(size, _TINY),
                is_separate=size > _SEPARATE * float(np.linalg.norm(slope)),
                moved={
                    one: abs(float(moved[k]))
                    for k, one in enumerate(problem.names)
                    if one in problem.holdable
                },
            )
        )
    return found, float(residuals @ residuals) - residuals.size


def _unseen(held: Iterable[_Held]) -> Iterator[Doubt]:
    """Name what is held where a hidden error of it makes something else wrong."""
    words, parameters = [], []
    for one in held:
        moved, what = max(((size, name) for name, size in one.moved.items()), default=(0.0, ""))
        if moved * one.hidden > _MATTERS:
            words.append(f"{one.name} by {_as_size(one, 1.0 / moved)} ({what})")
            parameters.append(one.name)
    if words:
        yield Doubt(
            "unseen",
            "the track does not show whether these are right, and each makes the number in "
            "brackets wrong by its standard error if it is wrong itself by no more than this: "
            f"{', '.join(words)}. Measure them so well, or say how well you know them (errors; "
            "--error), so that the intervals include it",
            tuple(parameters),
        )


def _as_size(of: _Held, error: float) -> str:
    """Return an error in the unit in which it is measured."""
    if of.name in _IN_PARTS:
        return f"{100.0 * error / max(abs(of.value), _TINY):.2g} %"
    if of.name in _ANGLES:
        return f"{math.degrees(error):.2g}°"
    return f"{100.0 * error:.2g} %" if of.name in _PARTS else f"{error:.2g} R"


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
    shown = [one for one in found if abs(one.score) >= _ALSO * abs(found[0].score)][:3]
    words = []
    for one in shown:
        value, error = one.value - one.score / one.shown, 1.0 / one.shown
        if one.name in problem.holdable:
            value, error = _freed(problem, unknowns, one.name, value, error)
        words.append(f"{one.name} {value:.3g} ± {error:.1g} in place of {one.value:.3g}")
    remedy = ": put it into free" if shown[0].name in OF_HOOP else ""
    yield Doubt(
        "camera" if shown[0].name.startswith(_CAMERA) else "held",
        f"by {abs(found[0].score):.0f} standard errors the track asks for "
        f"{' or '.join(words)}{remedy}",
        tuple(one.name for one in shown),
    )


def _freed(
    problem: Problem, unknowns: Reals, name: str, value: float, error: float
) -> tuple[float, float]:
    """Return what a fit finds for something held, and its standard error.

    A score is the first step to it, which is far too short where the motion is not linear in it.
    """
    freed = problem.freed(name)
    held = float(problem.values(unknowns)[name])
    begin = problem.moved(unknowns, freed, **{name: held})
    found = freed.refine(begin, "linear", ROUGH, _STEPS_OF_FREED)
    normal = found.jac.T @ found.jac
    place = freed.names.index(name)
    variance = float(np.linalg.pinv(normal)[place, place])
    if not variance > 0.0 or not found.cost < problem.cost(unknowns):
        return value, error
    return float(found.x[place]), math.sqrt(variance)


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
