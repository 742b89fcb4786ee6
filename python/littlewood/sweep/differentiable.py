"""Summaries and their derivatives for libraries that differentiate programs."""

from __future__ import annotations

import inspect
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from .._internal.elementwise import Reals
from .._internal.extras import require
from ..hoop import Hoop
from ..tables import AXES, FRICTION, SUMMARY_COLUMNS
from .many import simulate_many
from .points import fill

_OPTIONS = [
    name
    for name, one in inspect.signature(simulate_many).parameters.items()
    if one.kind is inspect.Parameter.KEYWORD_ONLY and name != "derivatives"
]

FIRST_ONLY = "littlewood has first derivatives only: no Hessian, and no gradient of a gradient"
"""What is said where a second derivative is asked for."""


class Problem:
    """Columns of summaries as functions of some quantities."""

    def __init__(self, columns: Iterable[str], hoop: Hoop | None, fixed: Mapping[str, Any]) -> None:
        require("xarray")  # here: what a callback of JAX raises comes below a hundred lines of it
        self.columns = tuple(columns)
        known = [name for name, column in SUMMARY_COLUMNS.items() if column.kind == "real"]
        for name in self.columns:
            if name not in known:
                raise ValueError(f"columns has {name!r}; it can have {', '.join(known)}")
        unknown = [name for name in fixed if name not in (*AXES, FRICTION, *_OPTIONS)]
        if unknown:
            raise TypeError(
                f"nothing is named {', '.join(unknown)}; there are "
                f"{', '.join((*AXES, FRICTION, *_OPTIONS))}"
            )
        self._hoop = hoop
        self._fixed = dict(fixed)

    def check(self, values: Mapping[str, Any]) -> None:
        """Refuse names that are unknown, fixed or missing, before a library traces the call."""
        if not values:
            raise ValueError("no quantity is given: everything is fixed")
        taken = sorted(set(values) & set(self._fixed))
        if taken:
            raise ValueError(f"{', '.join(taken)}: given here, and fixed before")
        if FRICTION in values:
            raise ValueError(f"{FRICTION} has no derivative: give mu_s and mu_k the same value")
        given = {name: value for name, value in self._fixed.items() if name not in _OPTIONS}
        fill(self._hoop, given | dict.fromkeys(values, 0.0))

    def numbers(self, names: tuple[str, ...], *arrays: Any) -> tuple[Reals, ...]:
        """Return the columns, for quantities of these names as arrays of one shape."""
        return self._follow(names, arrays, ())

    def numbers_and_slopes(self, names: tuple[str, ...], *arrays: Any) -> tuple[Reals, ...]:
        """Return the columns, then their derivatives.

        Those of the first by each quantity come first, then those of the second, and so on.

        Where a column is NaN, as its event does not happen, its derivatives are 0.
        """
        count = len(self.columns)
        found = self._follow(
            names, arrays, [f"{column}_by_{name}" for column in self.columns for name in names]
        )
        owners = np.repeat(np.arange(count), len(names))
        slopes = (
            np.where(np.isnan(found[owner]), 0.0, slope)
            for owner, slope in zip(owners, found[count:], strict=True)
        )
        return (*found[:count], *slopes)

    def _follow(
        self, names: tuple[str, ...], arrays: Any, derivatives: Iterable[str]
    ) -> tuple[Reals, ...]:
        values = {
            name: np.asarray(array, dtype=np.float64)
            for name, array in zip(names, arrays, strict=True)
        }
        shape = np.broadcast_shapes(*(array.shape for array in values.values()))
        flat = {name: np.broadcast_to(array, shape).reshape(-1) for name, array in values.items()}
        derivatives = tuple(derivatives)
        found = simulate_many(self._hoop, derivatives=derivatives, **(self._fixed | flat))
        return tuple(
            found[name].to_numpy().reshape(shape) for name in (*self.columns, *derivatives)
        )
