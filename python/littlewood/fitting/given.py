"""What was weighed and measured is not exact: what its errors do to the estimates of a fit."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from .._internal.elementwise import Reals, real
from .calibration import CALIBRATION
from .problem import Problem

__all__ = ["IN_PARTS", "checked_errors", "errors_of_given"]

IN_PARTS = ("mass_ratio", "offset", "inertia")
"""What is known as a part of its value."""

_OTHERS = ("slope", "clock", *(f"camera_{name}" for name in CALIBRATION))
# Singular values that are smaller, as a part of the largest, tell nothing.
_LOST = 1e-8


def checked_errors(given: Mapping[str, float]) -> dict[str, float]:
    """Return the errors of what was weighed and measured; refuse what makes no sense."""
    found = {}
    for name, value in given.items():
        if name not in (*IN_PARTS, *_OTHERS):
            raise ValueError(f"errors has {name}; it can have {', '.join((*IN_PARTS, *_OTHERS))}")
        found[name] = real(value, f"error of {name}")
        if not (found[name] > 0.0 and math.isfinite(found[name])):
            raise ValueError(f"error of {name} = {value} must be positive and finite")
    return found


def errors_of_given(problem: Problem, best: Any, told: Mapping[str, float]) -> Reals:
    """Return what errors of what was given add to the covariance of the unknowns.

    To first order: an error q moves the unknowns by −J⁺G q, with the derivatives J of the residuals
    by the unknowns, and G by what was given. The residuals tell of q what they have along G − JJ⁺G;
    the rest is as was told. The mean square of what is left of q is taken, so that the estimates
    stay where they are.
    """
    size = best.x.size
    values = problem.values(best.x)
    columns, sizes = [], []
    for name, error in told.items():
        derivative = None if name in problem.names else problem.derivative_by(name, values)
        if derivative is not None:
            columns.append(np.concatenate([*problem.whitened(derivative).values()]))
            sizes.append(error * (abs(float(values[name])) if name in IN_PARTS else 1.0))
    if not columns:
        return np.zeros((size, size))
    # What is known of the camera beforehand has rows of its own, after those of the residuals.
    given = np.zeros((best.jac.shape[0], len(columns)))
    given[: columns[0].size] = np.column_stack(columns)
    norms = np.linalg.norm(best.jac, axis=0)
    norms = np.where(norms > 0.0, norms, 1.0)
    basis, singular, rows = np.linalg.svd(best.jac / norms, full_matrices=False)
    kept = singular > _LOST * singular[0]
    basis, singular, rows = basis[:, kept], singular[kept], rows[kept]
    along = basis.T @ given
    moves = -(rows.T @ (along / singular[:, None])) / norms[:, None]
    apart = given - basis @ along
    known = np.linalg.inv(apart.T @ apart + np.diag(1.0 / np.square(sizes)))
    shown = -known @ (apart.T @ problem.scaled(best.x))
    return np.asarray(moves @ (known + np.outer(shown, shown)) @ moves.T)
