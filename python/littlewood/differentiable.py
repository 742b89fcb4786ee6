"""Summaries and their derivatives for libraries that differentiate programs."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from .elementwise import Reals
from .hoop import Hoop
from .many import simulate_many
from .tables import SUMMARY_COLUMNS


class Problem:
    """Columns of summaries as functions of some quantities."""

    def __init__(self, columns: Iterable[str], hoop: Hoop | None, fixed: Mapping[str, Any]) -> None:
        self.columns = tuple(columns)
        known = [name for name, column in SUMMARY_COLUMNS.items() if column.kind == "real"]
        for name in self.columns:
            if name not in known:
                raise ValueError(f"columns has {name!r}; it can have {', '.join(known)}")
        self._hoop = hoop
        self._fixed = dict(fixed)

    def numbers(self, names: tuple[str, ...], *arrays: Any) -> tuple[Reals, ...]:
        """Return the columns, for quantities of these names as arrays of one shape."""
        return self._follow(names, arrays, ())

    def numbers_and_slopes(self, names: tuple[str, ...], *arrays: Any) -> tuple[Reals, ...]:
        """Return the columns, then the derivatives of the first by each quantity, of the second, and so on."""
        return self._follow(
            names, arrays, [f"{column}_by_{name}" for column in self.columns for name in names]
        )

    def _follow(
        self, names: tuple[str, ...], arrays: Any, derivatives: Iterable[str]
    ) -> tuple[Reals, ...]:
        taken = sorted(set(names) & set(self._fixed))
        if taken:
            raise ValueError(f"{', '.join(taken)}: given here, and fixed before")
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
