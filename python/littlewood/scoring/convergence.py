"""How fast the errors of a solver fall with its step."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .._internal.terminal import printable
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
    steps : tuple of float
        Their steps, √(R/g).
    order : float
        Exponent p of the law largest error = c step^p through them, by least squares of the
        logarithms.
    """

    scores: tuple[Score, ...]
    steps: tuple[float, ...]
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
            f"{step:>12.3g}{one.largest_error:>16.2e}{len(one.missed):>8}{len(one.spurious):>10}"
            for step, one in zip(self.steps, self.scores, strict=True)
        ]
        return printable("\n".join([*lines, f"order of convergence  {self.order:.2f}"]))


def convergence(scores: Sequence[Score], steps: Sequence[float] | None = None) -> Convergence:
    """Return the order of convergence of scores with different steps.

    Parameters
    ----------
    scores : sequence of Score
        At least two, with different steps.
    steps : sequence of float, optional
        Steps of the solver, √(R/g), one for each score; by default those between the rows of the
        records, of which a solver may have made several.

    Returns
    -------
    Convergence

    Raises
    ------
    ValueError
        If there are fewer than two steps, one is not positive, or a largest error is zero.
    """
    given = [one.record.step for one in scores] if steps is None else list(steps)
    if len(given) != len(scores):
        raise ValueError(
            f"{len(given)} steps, and {len(scores)} scores: there must be one for each"
        )
    if not all(0.0 < step < np.inf for step in given):
        raise ValueError(
            f"steps {', '.join(map(str, given))} sqrt(R/g) must be positive and finite"
        )
    ordered = sorted(zip(given, scores, strict=True), key=lambda pair: -pair[0])
    sizes = np.array([step for step, _ in ordered])
    errors = np.array([one.largest_error for _, one in ordered])
    if np.unique(sizes).size < 2:
        raise ValueError(
            f"{np.unique(sizes).size} different steps: an order of convergence needs at least two"
        )
    if not np.all(errors > 0.0):
        raise ValueError(
            f"the largest error at step {sizes[errors == 0.0][0]} sqrt(R/g) is 0: it has no "
            f"logarithm"
        )
    order = float(np.polyfit(np.log(sizes), np.log(errors), 1)[0])
    return Convergence(tuple(one for _, one in ordered), tuple(sizes.tolist()), order)
