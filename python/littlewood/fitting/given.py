"""What was weighed and measured is not exact: what its errors do to the estimates of a fit."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from .._internal.elementwise import Reals, real
from .calibration import CALIBRATION
from .diagnostics import Doubt
from .estimate import Estimate
from .problem import OF_HOOP, Problem
from .usual_errors import IN_PARTS, USUAL_ERRORS, in_units

__all__ = ["checked_errors", "errors_of_given", "unseen", "usual_in_words"]

# What is known as a part of 1, and in radians.
_PARTS = ("clock", "camera_scale", "camera_stretch", "camera_shear")
_ANGLES = ("slope", "camera_turn", "camera_marker")
_OTHERS = ("slope", "clock", "rolling_resistance", *(f"camera_{name}" for name in CALIBRATION))
# Singular values that are smaller, as a part of the largest, tell nothing.
_LOST = 1e-8
# A wrong value may be wrong by three times its usual error. One that the residuals show by so many
# standard deviations has a doubt of its own, but for one track in thirty; one that moves a result
# by so many standard errors makes it wrong.
_MOST = 3.0
_SHOWN = 6.0
_MATTERS = 2.0
# What widens an interval by less than this part of the most is not named.
_NAMED = 0.3
_LEAST = 1e-9


@dataclass(frozen=True, kw_only=True, eq=False)
class _Given:
    """What errors of what was given do to the unknowns, to first order.

    Attributes
    ----------
    names : sequence of str
        What was given.
    moves : ndarray
        By how much an error of 1 moves each unknown, a column for each.
    sizes : ndarray
        Their standard errors before the track is seen.
    shown : ndarray
        By how many standard deviations the residuals show an error of 1, apart from what the
        unknowns make up for.
    known : ndarray
        Mean products of the errors that the track leaves, with that which it shows.
    """

    names: Sequence[str]
    moves: Reals
    sizes: Reals
    shown: Reals
    known: Reals

    @property
    def covariance(self) -> Reals:
        """What they add to the covariance of the unknowns."""
        return np.asarray(self.moves @ self.known @ self.moves.T)


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
    """Return what errors of what was given add to the covariance of the unknowns."""
    return _given(problem, best, told).covariance


def _given(problem: Problem, best: Any, told: Mapping[str, float]) -> _Given:
    """Return what errors of what was given do.

    To first order: an error q moves the unknowns by −J⁺G q, with the derivatives J of the residuals
    by the unknowns, and G by what was given. The residuals tell of q what they have along G − JJ⁺G;
    the rest is as was told. The mean square of what is left of q is taken, so that the estimates
    stay where they are.
    """
    size = best.x.size
    held = problem.values(best.x)
    names, columns, sizes = [], [], []
    for name, error in told.items():
        derivative = None if name in problem.names else problem.derivative_by(name, held)
        if derivative is not None:
            names.append(name)
            columns.append(np.concatenate([*problem.whitened(derivative).values()]))
            sizes.append(in_units(name, error, float(held.get(name, 0.0))))
    if not columns:
        none = np.zeros(0)
        return _Given(
            names=names,
            moves=np.zeros((size, 0)),
            sizes=none,
            shown=none,
            known=np.zeros((0, 0)),
        )
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
    before = np.maximum(sizes, _LEAST)
    # In units of the errors the matrix is no less than that of one: rounding must not make it so.
    values, vectors = np.linalg.eigh((apart * before).T @ (apart * before))
    root = before[:, None] * vectors / np.sqrt(1.0 + np.maximum(values, 0.0))
    known = root @ root.T
    seen = -known @ (apart.T @ problem.scaled(best.x))
    return _Given(
        names=names,
        moves=moves,
        sizes=before,
        shown=np.linalg.norm(apart, axis=0),
        known=known + np.outer(seen, seen),
    )


def unseen(
    problem: Problem,
    best: Any,
    change: Reals,
    estimates: Mapping[str, Estimate],
    told: Mapping[str, float],
) -> Iterator[Doubt]:
    """Doubt parameters that a usual error of what was weighed and measured makes wrong unseen.

    `change` takes the unknowns to the parameters, and `told` are the errors that the intervals
    include: of these the person knows.
    """
    usual = {name: error for name, error in USUAL_ERRORS.items() if name not in told}
    given = _given(problem, best, usual)
    moves = change @ given.moves
    # An error of the usual size does not show, and the largest that does not makes something wrong.
    largest = np.minimum(_MOST * given.sizes, _SHOWN / np.maximum(given.shown, _LEAST))
    hidden = np.where(given.shown * given.sizes < _SHOWN, largest, 0.0)
    words: list[str] = []
    needed: dict[str, float] = {}
    for k, (name, estimate) in enumerate(estimates.items()):
        if name not in OF_HOOP or not estimate.identifiable or estimate.std_error == 0.0:
            continue
        parts = np.abs(moves[k]) * hidden
        if not np.any(parts > _MATTERS * estimate.std_error):
            continue
        added = float(moves[k] @ given.known @ moves[k])
        wider = math.hypot(estimate.std_error, math.sqrt(max(added, 0.0)))
        words.append(f"{name} {wider:.2g} in place of {estimate.std_error:.2g}")
        for i in np.flatnonzero(parts >= _NAMED * parts.max()):
            of = given.names[int(i)]
            # As its usual error is measured: in parts, or as it is.
            size = estimate.std_error / abs(float(moves[k, i])) * usual[of] / given.sizes[i]
            needed[of] = min(size, needed.get(of, math.inf))
    if words:
        most = ", ".join(
            f"{name} to {_as_size(name, size)} (usual: {_as_size(name, usual[name])})"
            for name, size in sorted(needed.items(), key=lambda one: one[1] / usual[one[0]])
        )
        yield Doubt(
            "unseen",
            "the ± hold if what was weighed and measured is right, which the track does not show. "
            f"With usual errors of it they are, of {', '.join(words)}. Measure {most}, or say how "
            "well you know it (errors; --error, --usual-errors), and the ± include it",
            tuple(needed),
        )


def usual_in_words() -> str:
    """Return the usual errors, each in its unit."""
    return ", ".join(f"{name} {_as_size(name, error)}" for name, error in USUAL_ERRORS.items())


def _as_size(name: str, size: float) -> str:
    """Return an error, of what is known in parts as a part, in the unit of its measurement."""
    if name in _ANGLES:
        return f"{math.degrees(size):.2g}°"
    return f"{100.0 * size:.2g} %" if name in (*IN_PARTS, *_PARTS) else f"{size:.2g} R"
