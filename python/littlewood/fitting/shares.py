"""Which part of a track says what: how much each frame tells of each number of a fit."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._internal.elementwise import Reals
from .problem import OF_HOOP

if TYPE_CHECKING:
    from .result import FitResult

__all__ = ["shares"]

# Singular values that are smaller, as a part of the largest, tell nothing.
_LOST = 1e-8


def shares(result: FitResult) -> dict[str, Reals]:
    """Return the parts of the frames in what is told of each identifiable parameter of the hoop.

    To first order an estimate is a sum over measurements with independent errors of size 1; the
    part of a frame is its part of the variance of that sum. The parts of a parameter sum to 1.
    """
    problem, track, names = result._problem, result.track, result._problem.names
    jacobian = problem.jacobian(result._unknowns)
    norms = np.linalg.norm(jacobian, axis=0)
    norms = np.where(norms > 0.0, norms, 1.0)
    weights = np.linalg.pinv(jacobian / norms, rcond=_LOST) / norms[:, None]
    if "mu_s" in names and "mu_k" in names:
        # The unknown is the excess of mu_s over mu_k.
        weights[names.index("mu_s")] += weights[names.index("mu_k")]
    # What is known beforehand has rows of its own, after those of the frames.
    frames = np.concatenate(
        [np.flatnonzero(np.isfinite(values)) for values in track.channels.values()]
    )
    found = {}
    for name, estimate in result.estimates.items():
        if name in OF_HOOP and estimate.identifiable:
            squares = np.square(weights[names.index(name), : frames.size])
            parts = np.bincount(frames, squares, track.time.size)
            if parts.sum() > 0.0:
                found[name] = parts / parts.sum()
    return found
