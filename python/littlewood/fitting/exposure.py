"""The blur of a motion: what a picture shows is a mean over its exposure."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import cached_property

import numpy as np

from .._internal.derivatives import columns_at
from .._internal.elementwise import Reals
from ..samples import Samples
from ..trajectory import Trajectory

__all__ = ["Exposures"]

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(2)


class Exposures:
    """A motion as means over exposures that begin at some times, √(R/g): sums over instants.

    From transition to transition a motion is smooth: an exposure is taken in such pieces.
    """

    def __init__(self, motion: Trajectory, time: Reals, exposure: float) -> None:
        self.motion = motion
        if exposure == 0.0:
            self._instants, self._weights = time, np.ones(time.size)
            self._passed, self._firsts = np.full(time.size, 0.5), np.arange(time.size)
            return
        jumps = np.array([one.time for one in motion.transitions], dtype=np.float64)
        frames = np.searchsorted(time, jumps, side="right") - 1
        inside = (frames >= 0) & (jumps < time[frames] + exposure)
        begins = np.concatenate([time, jumps[inside]])
        owners = np.concatenate([np.arange(time.size), frames[inside]])
        order = np.lexsort((begins, owners))
        begins, owners = begins[order], owners[order]
        ends = time[owners] + exposure
        ends[:-1] = np.where(owners[1:] == owners[:-1], begins[1:], ends[:-1])
        halves = 0.5 * (ends - begins)[:, None]
        nodes = begins[:, None] + halves * (1.0 + _NODES)
        self._instants, self._weights = nodes.ravel(), (halves / exposure * _WEIGHTS).ravel()
        # By which part of its exposure an instant is later than its picture begins.
        self._passed = ((nodes - time[owners][:, None]) / exposure).ravel()
        self._firsts = _NODES.size * np.searchsorted(owners, np.arange(time.size))

    @cached_property
    def positions(self) -> dict[str, Reals]:
        """θ, x and y of the pictures."""
        return self._means(_positions(self.motion, self.motion(self._instants)))

    def derivatives(self, quantities: Sequence[str]) -> dict[str, Reals]:
        """Return the derivatives of θ, x and y of the pictures by quantities of hoop and start."""
        found = columns_at(self.motion._core, self._instants, quantities)
        return self._means({"theta": found["theta"], "x": found["x"], "y": found["gap"]})

    def derivatives_by_exposure(self) -> dict[str, Reals]:
        """Return the derivatives of θ, x and y of the pictures by the exposure."""
        at = self.motion(self._instants)
        rates = {"theta": at.theta_rate, "x": at.slip - at.theta_rate, "y": at.gap_rate}
        return self._means({name: self._passed * values for name, values in rates.items()})

    def _means(self, values: Mapping[str, Reals]) -> dict[str, Reals]:
        """Return means over exposures of what has a row for each instant."""
        return {
            name: np.add.reduceat((self._weights * rows.T).T, self._firsts)
            for name, rows in values.items()
        }


def _positions(motion: Trajectory, at: Samples) -> dict[str, Reals]:
    """Return θ, x and y; beyond its end a motion goes on evenly: a fit needs a number there."""
    found = {"theta": at.theta, "x": at.x, "y": at.centre_y}
    late = at.is_outside
    if np.any(late):
        end = motion.outcome.state
        elapsed = at.time[late] - end.time
        rate = end.theta_rate if math.isfinite(end.theta_rate) else 0.0
        found["theta"][late] = end.theta + rate * elapsed
        found["x"][late] = end.x + (end.slip - rate if math.isfinite(end.slip) else 0.0) * elapsed
        found["y"][late] = 1.0
    return found
