"""Errors of a track: some differ from frame to frame, others change slowly."""

from __future__ import annotations

import functools
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from .._internal.elementwise import Reals
from .._internal.extras import require
from .._internal.terminal import printable

__all__ = [
    "EFFICIENCY",
    "LEAST_ERROR",
    "Noise",
    "error_of_frames",
    "estimate_noise",
    "whitenings",
]


# Variances of the slow part over those of the other, and its times over the median time between two
# frames.
_RATIOS = (0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0)
_TIMES = (1.0, 2.0, 4.0, 8.0, 16.0, 32.0)
_LEAST = 1e-12
# Differences that tell what differs from frame to frame.
_ORDERS = (2, 3, 4, 5)

LEAST_ERROR = 1e-6
"""No tracker resolves a millionth of a radius."""

EFFICIENCY = 0.37
"""A median of so many values tells a standard deviation as well as this part of them would."""


@dataclass(frozen=True)
class Noise:
    """Errors of a channel: their covariance is white² δ(t, t′) + slow² exp(−|t − t′|/time).

    Attributes
    ----------
    white : float
        Standard deviation of the white noise; where the track has errors, in a frame whose error
        is the median.
    slow : float
        Standard deviation of the slow noise.
    time : float
        In which time, √(R/g), it does; 0 without such a part.
    """

    white: float
    slow: float = 0.0
    time: float = 0.0

    @property
    def sigma(self) -> float:
        """Standard deviation of an error."""
        return math.hypot(self.white, self.slow)

    def is_close(self, other: Noise) -> bool:
        """Whether the noise is that of another.

        Standard deviations may differ by a hundredth, times not at all.
        """
        return self.time == other.time and bool(
            np.allclose((self.white, self.slow), (other.white, other.slow), rtol=0.01, atol=0.0)
        )

    def __str__(self) -> str:
        slow = (
            f", of which {self.slow:.3g} changes in τ = {self.time:.2g}" if self.slow > 0.0 else ""
        )
        return printable(f"{self.sigma:.3g}{slow}")


def error_of_frames(values: Reals) -> float:
    """Return the standard deviation of what differs from frame to frame, by differences.

    A motion leaves the less of them the higher their order, and a transition a few of them alone.
    """
    found = math.inf
    for order in _ORDERS:
        change = np.diff(values, order)
        if change.size >= 5:
            # Of normal errors half are within 0.6745 standard deviations.
            size = float(np.median(np.abs(change))) / 0.6745
            found = min(found, size / math.sqrt(math.comb(2 * order, order)))
    return max(found, LEAST_ERROR) if math.isfinite(found) else float(np.std(values))


class Whitening:
    """Measurements as combinations whose errors are independent and of size 1.

    Innovations of the measurements: a Kalman filter whose state is the slow noise. With the part
    k of the slow noise that is left from frame to frame, and the part r of a measurement that is
    white, the innovations i of the measurements v are

        i[n] − k[n] r[n−1] i[n−1] = v[n] − k[n] v[n−1].
    """

    def __init__(self, kept: Reals, white: Reals, variances: Reals) -> None:
        self._kept, self._roots = kept, np.sqrt(variances)
        self._bands = np.ones((2, kept.size))
        self._bands[1, :-1] = -kept[1:] * white[:-1]

    def __call__(self, values: Reals) -> Reals:
        """Return values, or columns of them, as those combinations."""
        found = values
        if np.any(self._kept):
            found = values.copy()
            found[1:] -= (self._kept[1:] * values[:-1].T).T
            # A fit does this a hundred thousand times: LAPACK itself, without checks.
            found, _ = require("scipy.linalg.lapack").dtbtrs(self._bands, found, uplo="L", diag="U")
        return np.asarray((found.T / self._roots).T)

    @property
    def log_determinant(self) -> float:
        """Logarithm of the determinant of the covariance of the errors."""
        return 2.0 * float(np.sum(np.log(self._roots)))


def whitenings(noises: Sequence[Noise], time: Reals, relative: Reals) -> list[Whitening]:
    """Return the combinations for each noise; `relative` are the errors over the median one."""
    whites, slows, lengths = (
        np.array([getattr(one, name) for one in noises]) for name in ("white", "slow", "time")
    )
    has_slow = slows > 0.0
    elapsed = np.diff(time, prepend=-math.inf)[:, None]
    kept = np.where(has_slow, np.exp(-elapsed / np.where(has_slow, lengths, 1.0)), 0.0)
    white = np.square(whites * relative[:, None])
    variances, left = np.empty_like(kept), np.zeros(len(noises))
    for k, part in enumerate(np.square(kept)):
        before = part * left + (1.0 - part) * np.square(slows)
        variances[k] = before + white[k]
        left = before * white[k] / variances[k]
    return [*map(Whitening, kept.T, (white / variances).T, variances.T)]


def estimate_noise(
    times: Mapping[str, Reals],
    relative: Mapping[str, Reals],
    residuals: Mapping[str, Reals],
    jacobians: Mapping[str, Reals],
    known: Mapping[str, Noise],
    correlated: bool,
) -> dict[str, Noise]:
    """Estimate the errors of channels by restricted likelihood.

    It accounts for the fitted parameters.

    Parameters
    ----------
    times, relative, residuals, jacobians : mapping
        Of the measurements of each channel: times, errors over the median one, residuals,
        derivatives by the unknowns.
    known : mapping
        Channels whose errors are known.
    correlated : bool
        Whether errors may have a slow part.
    """
    shapes = {
        name: [known[name]] if name in known else _shapes(times[name], correlated)
        for name in residuals
    }
    # Unknowns that the residuals do not depend on have no part in a determinant.
    norms = np.linalg.norm(np.vstack(list(jacobians.values())), axis=0)
    kept = norms > 0.0
    channels = {
        name: _Channel.of(
            whitenings(tried, times[name], relative[name]),
            np.column_stack([residuals[name], jacobians[name][:, kept] / norms[kept]]),
            name not in known,
        )
        for name, tried in shapes.items()
    }
    best = dict.fromkeys(shapes, 0)
    scales: dict[str, Reals] = {
        name: np.maximum(one.products[:1, 0, 0] / one.count, _LEAST**2)
        if one.is_free
        else np.ones(1)
        for name, one in channels.items()
    }
    chosen = {name: one.at(slice(0, 1)) for name, one in channels.items()}
    value = float(_likelihood(chosen, scales)[0])
    for _ in range(20):
        before = value
        for name in (name for name, one in channels.items() if one.is_free):
            trial = chosen | {name: channels[name]}
            scaled = _scales(trial, scales)
            values = _likelihood(trial, scaled)
            place = best[name] = int(np.argmax(values))
            value = float(values[place])
            chosen[name] = channels[name].at(slice(place, place + 1))
            scales = {
                one: found[place : place + 1] if found.size > 1 else found
                for one, found in scaled.items()
            }
        if value <= before + 1e-6:
            break
    result = {}
    for name, place in best.items():
        root, shape = math.sqrt(scales[name][0]), shapes[name][place]
        result[name] = Noise(root * shape.white, root * shape.slow, shape.time)
    return result


def _shapes(time: Reals, correlated: bool) -> list[Noise]:
    """Return the noises that are tried, of a size of 1."""
    if not correlated or time.size < 8:
        return [Noise(1.0)]
    step = float(np.median(np.diff(time)))
    return [
        Noise(1.0),
        *(Noise(1.0, math.sqrt(ratio), step * length) for ratio in _RATIOS for length in _TIMES),
    ]


@dataclass(frozen=True, eq=False)
class _Channel:
    """A channel for each noise that is tried.

    Products of its whitened columns, and determinants.
    """

    products: Reals
    log_determinants: Reals
    count: int
    is_free: bool

    @classmethod
    def of(cls, tried: Sequence[Whitening], columns: Reals, is_free: bool) -> _Channel:
        whitened = [one(columns) for one in tried]
        products = np.array([rows.T @ rows for rows in whitened])
        logs = np.array([one.log_determinant for one in tried])
        return cls(products, logs, columns.shape[0], is_free)

    def at(self, places: slice) -> _Channel:
        return replace(
            self,
            products=self.products[places],
            log_determinants=self.log_determinants[places],
        )


def _solved(
    channels: Mapping[str, _Channel], scales: Mapping[str, Reals]
) -> tuple[Reals, Reals, Reals]:
    """Return the change of the unknowns, the inverse of their normal matrix, and more.

    The last is the logarithm of the determinant of that matrix.

    Each for all noises that are tried of one of the channels.
    """
    parts = (one.products / scales[name][:, None, None] for name, one in channels.items())
    normal = functools.reduce(np.add, parts)
    values, vectors = np.linalg.eigh(normal[:, 1:, 1:])
    # What the measurements do not tell has no finite variance; this bounds it.
    values = np.maximum(values, 1e-13 * values[:, -1:])
    inverse = (vectors / values[:, None, :]) @ vectors.swapaxes(1, 2)
    change = (inverse @ normal[:, 1:, :1])[:, :, 0]
    return change, inverse, np.sum(np.log(values), axis=1)


def _squares(channel: _Channel, change: Reals) -> Reals:
    """Return the sum of squares of a channel after the change of the unknowns."""
    row = np.column_stack([np.ones(change.shape[0]), -change])
    return np.asarray(np.einsum("pi,pij,pj->p", row, channel.products, row))


def _scales(channels: Mapping[str, _Channel], scales: Mapping[str, Reals]) -> dict[str, Reals]:
    """Return the variances that belong to shapes.

    Squares over the measurements less what the unknowns take of them.
    """
    found = dict(scales)
    for _ in range(2):
        change, inverse, _ = _solved(channels, found)
        for name, one in channels.items():
            if one.is_free:
                taken = np.einsum("pij,pij->p", inverse, one.products[:, 1:, 1:]) / found[name]
                left = np.maximum(one.count - taken, 1.0)
                found[name] = np.maximum(_squares(one, change) / left, _LEAST**2)
    return found


def _likelihood(channels: Mapping[str, _Channel], scales: Mapping[str, Reals]) -> Reals:
    """Return the logarithm of the restricted likelihood, up to a constant."""
    change, _, determinant = _solved(channels, scales)
    total = determinant
    for name, one in channels.items():
        total = total + one.log_determinants + one.count * np.log(scales[name])
        total = total + _squares(one, change) / scales[name]
    return -0.5 * total
