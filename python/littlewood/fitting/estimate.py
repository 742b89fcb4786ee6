"""The estimate of one parameter of a fit."""

from __future__ import annotations

import math
from dataclasses import dataclass
from statistics import NormalDist

from .._internal.terminal import printable

__all__ = ["Estimate"]


@dataclass(frozen=True)
class Estimate:
    """An estimate of one parameter.

    Attributes
    ----------
    value : float
        Estimate; where it is not identifiable, the last value of the fit.
    std_error : float
        Standard error; infinite where it is not identifiable.
    identifiable : bool
        Whether the tracked motion depends on the parameter, apart from the others.
    """

    value: float
    std_error: float
    identifiable: bool

    def interval(self, confidence: float = 0.95) -> tuple[float, float]:
        """Return the interval that contains the true value with a probability, for normal errors.

        Parameters
        ----------
        confidence : float, optional
            The probability, between 0 and 1.

        Returns
        -------
        tuple of float
            Its ends; infinite where the parameter is not identifiable.
        """
        if not 0.0 < confidence < 1.0:
            raise ValueError(f"confidence = {confidence} must lie between 0 and 1")
        if not self.identifiable:
            return -math.inf, math.inf
        half = NormalDist().inv_cdf(0.5 + 0.5 * confidence) * self.std_error
        return self.value - half, self.value + half

    def __str__(self) -> str:
        if not self.identifiable:
            return "not identifiable from this motion"
        digits = 0
        if self.std_error > 0.0:
            digits = max(0, 1 - math.floor(math.log10(self.std_error)))
        return printable(f"{self.value:.{digits}f} ± {self.std_error:.{digits}f}")
