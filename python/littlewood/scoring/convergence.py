"""How fast the errors of a solver fall with its step."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .score import Score

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["Convergence", "convergence"]


@dataclass(frozen=True, eq=False)
class Convergence:
    """Scores of one solver with several steps.

    Attributes
    ----------
    scores : tuple of Score
        By falling step.
    order : float
        Exponent p of the law largest error = c step^p through them, by least squares of the logarithms.
    """

    scores: tuple[Score, ...]
    order: float

    def plot(self) -> Figure:
        """Draw the largest error over the step, with the law.

        Returns
        -------
        matplotlib.figure.Figure
        """
        from .picture import draw_convergence

        return draw_convergence(self)

    def __str__(self) -> str:
        lines = [f"{'step':>12}{'largest error':>16}{'missed':>8}{'spurious':>10}"]
        lines += [
            f"{one.record.step:>12.3g}{one.largest_error:>16.2e}{len(one.missed):>8}{len(one.spurious):>10}"
            for one in self.scores
        ]
        return "\n".join([*lines, f"order of convergence  {self.order:.2f}"])


def convergence(scores: Sequence[Score]) -> Convergence:
    """Return the order of convergence of scores with different steps.

    Parameters
    ----------
    scores : sequence of Score
        At least two, with different steps.

    Returns
    -------
    Convergence

    Raises
    ------
    ValueError
        If there are fewer than two steps, or a largest error is zero.
    """
    ordered = tuple(sorted(scores, key=lambda one: -one.record.step))
    steps = np.array([one.record.step for one in ordered])
    errors = np.array([one.largest_error for one in ordered])
    if np.unique(steps).size < 2:
        raise ValueError(f"{np.unique(steps).size} different steps: an order of convergence needs at least two")
    if not np.all(errors > 0.0):
        raise ValueError(f"the largest error at step {steps[errors == 0.0][0]} sqrt(R/g) is 0: it has no logarithm")
    order = float(np.polyfit(np.log(steps), np.log(errors), 1)[0])
    return Convergence(ordered, order)
