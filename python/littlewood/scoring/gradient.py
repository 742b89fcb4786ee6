"""Derivatives of a motion, held against the exact ones.

A differentiable solver has computed them.
"""

from __future__ import annotations

import itertools
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from .._internal.elementwise import Reals
from .._internal.terminal import printable
from .record import read_table

if TYPE_CHECKING:
    from ..trajectory import Trajectory

__all__ = ["GradientScore", "PhaseGradient", "read_gradient", "score_gradient"]


_COLUMNS = ("time", "x", "theta")


@dataclass(frozen=True)
class PhaseGradient:
    """The derivatives in one phase of the exact motion.

    Attributes
    ----------
    mode : str
        Its mode.
    begin, end : float
        The first and last instant that is compared, √(R/g).
    size : float
        Largest derivative of x or θ there.
    error : float
        Largest error of one.
    wrong_signs : float
        The part of all derivatives that have the other sign.
    """

    mode: str
    begin: float
    end: float
    size: float
    error: float
    wrong_signs: float

    @property
    def relative(self) -> float:
        """The error over the size.

        Infinite where the exact derivative is 0 and that of the solver is not.
        """
        return self.error / self.size if self.size else 0.0 if self.error == 0.0 else np.inf


@dataclass(frozen=True, eq=False)
class GradientScore:
    """How far the derivatives of a solver are from the exact ones. Everything is dimensionless.

    Attributes
    ----------
    quantity : str
        With respect to which.
    phases : tuple of PhaseGradient
        One for each phase of the exact motion with at least one instant.
    """

    quantity: str
    phases: tuple[PhaseGradient, ...]

    @property
    def largest_relative(self) -> float:
        """Largest relative error of a phase."""
        return max(phase.relative for phase in self.phases)

    def as_dict(self) -> dict[str, Any]:
        """Return all of it, as JSON can have it."""
        relative = [None if np.isinf(phase.relative) else phase.relative for phase in self.phases]
        phases = [
            asdict(phase) | {"relative": one}
            for phase, one in zip(self.phases, relative, strict=True)
        ]
        return {"quantity": self.quantity, "phases": phases}

    def __str__(self) -> str:
        lines = [
            f"{'phase':10}{'from':>10}{'to':>10}{'exact':>11}{'error':>11}"
            f"{'relative':>10}{'wrong signs':>13}"
        ]
        lines += [
            f"{phase.mode:10}{phase.begin:>10.4f}{phase.end:>10.4f}"
            f"{phase.size:>11.2e}{phase.error:>11.2e}"
            f"{phase.relative:>10.1e}{phase.wrong_signs:>13.0%}"
            for phase in self.phases
        ]
        return printable(
            "\n".join(
                [
                    *lines,
                    f"derivatives of x and theta with respect to {self.quantity} at fixed times",
                ]
            )
        )


def score_gradient(
    motion: Trajectory, time: npt.ArrayLike, x: npt.ArrayLike, theta: npt.ArrayLike, quantity: str
) -> GradientScore:
    """Hold derivatives at fixed times against the exact ones.

    Parameters
    ----------
    motion : Trajectory
        The exact motion.
    time : array_like
        Times τ, √(R/g), of shape (n,).
    x, theta : array_like
        ∂x/∂p and ∂θ/∂p at these times, shape (n,).
    quantity : str
        Name of p, such as `mu_k` or `theta_rate`.

    Returns
    -------
    GradientScore

    Raises
    ------
    ParameterError
        For a quantity that is none.
    ValueError
        If shapes differ, a number is not finite, or no instant has an exact derivative.
    """
    columns = [np.atleast_1d(np.asarray(column, dtype=np.float64)) for column in (time, x, theta)]
    for name, column in zip(_COLUMNS, columns, strict=True):
        if column.shape != columns[0].shape or column.ndim != 1:
            raise ValueError(
                f"{name} has shape {column.shape}, time has {columns[0].shape}: they must be (n,)"
            )
        if not np.all(np.isfinite(column)):
            raise ValueError(f"{name}[{np.flatnonzero(~np.isfinite(column))[0]}] must be finite")
    times, *found = columns
    if quantity in ("slip", "gap_rate") and getattr(motion.start, quantity) == 0.0:
        raise ValueError(f"the start has {quantity} = 0: motions differ on its two sides")
    data = motion.derivatives_at(times, [quantity])
    exact = np.array([data[name].sel(quantity=quantity) for name in ("x", "theta")])
    edges = [motion.start.time, *(one.time for one in motion.transitions), np.inf]
    modes = [phase.mode for phase in motion.phases]
    phases = []
    for mode, (begin, end) in zip(modes, itertools.pairwise(edges), strict=False):
        inside = (times > begin) & (times < end) & np.all(np.isfinite(exact), axis=0)
        if inside.any():
            true, mine = exact[:, inside], np.array(found)[:, inside]
            at = times[inside]
            phases.append(
                PhaseGradient(
                    mode,
                    float(at[0]),
                    float(at[-1]),
                    float(np.max(np.abs(true))),
                    float(np.max(np.abs(mine - true))),
                    float(np.mean(true * mine < 0.0)),
                )
            )
    if not phases:
        raise ValueError(f"no instant has an exact derivative with respect to {quantity}")
    return GradientScore(quantity, tuple(phases))


def read_gradient(path: str | Path) -> tuple[Reals, Reals, Reals]:
    """Read the columns time, x and theta of a table: derivatives of x and θ at fixed times."""
    columns = read_table(path, lambda *_: _COLUMNS)
    return columns["time"], columns["x"], columns["theta"]
