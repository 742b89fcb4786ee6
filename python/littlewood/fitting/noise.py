"""Errors of a track: some differ from frame to frame, others change slowly."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from .._internal.elementwise import Reals
from .._internal.terminal import printable

__all__ = ["Noise", "Whitening", "estimate_noise"]


# Variances of the slow part over those of the other, and its times over the median time between two
# frames.
_RATIOS = (0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0)
_TIMES = (1.0, 2.0, 4.0, 8.0, 16.0, 32.0)
_LEAST = 1e-12
# Longest track whose combinations are kept as a matrix.
_DENSE = 2000


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

    def __str__(self) -> str:
        slow = (
            f", of which {self.slow:.3g} changes in τ = {self.time:.2g}" if self.slow > 0.0 else ""
        )
        return printable(f"{self.sigma:.3g}{slow}")


class Whitening:
    """Measurements as combinations whose errors are independent and of size 1.

    Innovations of the measurements: a Kalman filter whose state is the slow noise. `relative` are
    their errors over the median one.
    """

    def __init__(self, noise: Noise, time: Reals, relative: Reals) -> None:
        white = np.square(noise.white * relative)
        self._keeps: list[float] = []
        self._gains: list[float] = []
        self._matrix: Reals | None = None
        total = white
        if noise.slow > 0.0:
            total, slow, left = np.empty(time.size), noise.slow**2, 0.0
            for k, elapsed in enumerate(np.diff(time, prepend=-math.inf)):
                keep = math.exp(-elapsed / noise.time)
                before = keep * keep * left + (1.0 - keep * keep) * slow
                total[k] = before + white[k]
                left = before * white[k] / total[k]
                self._keeps.append(keep)
                self._gains.append(before / float(total[k]))
        self._roots = np.sqrt(total)

    def __call__(self, values: Reals) -> Reals:
        """Return values, or columns of them, as those combinations."""
        if not self._gains:
            return np.asarray((values.T / self._roots).T)
        if self._matrix is None and len(self._gains) <= _DENSE:
            # The same matrix serves every step of a fit.
            self._matrix = self._filtered(np.eye(len(self._gains)))
        return self._filtered(values) if self._matrix is None else np.asarray(self._matrix @ values)

    def _filtered(self, values: Reals) -> Reals:
        found, state = np.empty_like(values), 0.0 * values[0]
        for k, (keep, gain) in enumerate(zip(self._keeps, self._gains, strict=True)):
            new = values[k] - keep * state
            found[k] = new
            state = keep * state + gain * new
        return np.asarray((found.T / self._roots).T)


def estimate_noise(
    times: Mapping[str, Reals],
    relative: Mapping[str, Reals],
    residuals: Mapping[str, Reals],
    jacobians: Mapping[str, Reals],
    known: Mapping[str, Noise],
    correlated: bool,
) -> dict[str, Noise]:
    """Estimate the errors of channels by restricted likelihood: it accounts for the fitted parameters.

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
    grams: dict[str, list[tuple[Reals, float]]] = {}
    # Unknowns that the residuals do not depend on have no part in a determinant.
    all_rows = np.vstack(list(jacobians.values()))
    norms = np.linalg.norm(all_rows, axis=0)
    kept = norms > 0.0
    for name, tried in shapes.items():
        columns = np.column_stack([residuals[name], jacobians[name][:, kept] / norms[kept]])
        grams[name] = _grams(tried, times[name], relative[name], columns)
    counts = {name: residuals[name].size for name in residuals}
    best = dict.fromkeys(shapes, 0)
    scales = {
        name: 1.0
        if name in known
        else max(float(grams[name][0][0][0, 0]) / counts[name], _LEAST**2)
        for name in shapes
    }
    free = [name for name in shapes if name not in known]
    value = _likelihood(grams, counts, best, scales)
    for _ in range(20):
        before = value
        for name in free:
            found = []
            for place in range(len(shapes[name])):
                trial = best | {name: place}
                scaled = _scales(grams, counts, trial, scales, free)
                found.append((_likelihood(grams, counts, trial, scaled), place, scaled))
            value, best[name], scales = max(found, key=lambda one: one[0])
        if value <= before + 1e-6:
            break
    result = {}
    for name, place in best.items():
        root, shape = math.sqrt(scales[name]), shapes[name][place]
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


def _grams(
    shapes: Sequence[Noise], time: Reals, relative: Reals, columns: Reals
) -> list[tuple[Reals, float]]:
    """Return products of whitened columns, and the logarithm of the determinant, for each noise."""
    whites, slows = (
        np.square([getattr(one, name) for one in shapes]) for name in ("white", "slow")
    )
    lengths = np.array([one.time if one.slow > 0.0 else 1.0 for one in shapes])
    state, left = np.zeros((len(shapes), columns.shape[1])), np.zeros(len(shapes))
    found, totals = np.empty((len(time), *state.shape)), np.empty((len(time), len(shapes)))
    for k, elapsed in enumerate(np.diff(time, prepend=-math.inf)):
        keep = np.exp(-elapsed / lengths)
        before = keep * keep * left + (1.0 - keep * keep) * slows
        white = whites * relative[k] ** 2
        totals[k] = before + white
        left = before * white / totals[k]
        new = columns[k] - keep[:, None] * state
        found[k] = new / np.sqrt(totals[k])[:, None]
        state = keep[:, None] * state + (before / totals[k])[:, None] * new
    logs = np.sum(np.log(totals), axis=0)
    whitened = np.moveaxis(found, 1, 0)
    return [(one.T @ one, float(log)) for one, log in zip(whitened, logs, strict=True)]


def _solved(
    grams: Mapping[str, list[tuple[Reals, float]]],
    places: Mapping[str, int],
    scales: Mapping[str, float],
) -> tuple[Reals, Reals, float]:
    """Return the change of the unknowns, the inverse of their normal matrix, and the logarithm of its determinant."""
    normal = np.sum(
        [grams[name][place][0] / scales[name] for name, place in places.items()], axis=0
    )
    values, vectors = np.linalg.eigh(normal[1:, 1:])
    # What the measurements do not tell has no finite variance; this bounds it.
    values = np.maximum(values, 1e-13 * values[-1])
    inverse = (vectors / values) @ vectors.T
    return inverse @ normal[1:, 0], inverse, float(np.sum(np.log(values)))


def _scales(
    grams: Mapping[str, list[tuple[Reals, float]]],
    counts: Mapping[str, int],
    places: Mapping[str, int],
    scales: Mapping[str, float],
    free: Sequence[str],
) -> dict[str, float]:
    """Return the variances that belong to shapes: squares over the measurements less what the unknowns take of them."""
    found = dict(scales)
    for _ in range(2):
        change, inverse, _ = _solved(grams, places, found)
        row = np.concatenate([[1.0], -change])
        for name in free:
            gram = grams[name][places[name]][0]
            squares = float(row @ gram @ row)
            taken = float(np.sum(inverse * gram[1:, 1:])) / found[name]
            found[name] = max(squares / max(counts[name] - taken, 1.0), _LEAST**2)
    return found


def _likelihood(
    grams: Mapping[str, list[tuple[Reals, float]]],
    counts: Mapping[str, int],
    places: Mapping[str, int],
    scales: Mapping[str, float],
) -> float:
    """Return the logarithm of the restricted likelihood, up to a constant."""
    change, _, determinant = _solved(grams, places, scales)
    row = np.concatenate([[1.0], -change])
    total = 0.0
    for name, place in places.items():
        gram, log = grams[name][place]
        total -= (
            log + counts[name] * math.log(scales[name]) + float(row @ gram @ row) / scales[name]
        )
    return 0.5 * (total - determinant)
