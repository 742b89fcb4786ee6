"""Types and attributes of the variables of sweeps: those of the Zarr stores of the command line."""

from __future__ import annotations

from typing import Any

import numpy as np

from . import _core
from .tables import OUTCOMES, QUANTITIES, SUMMARY_COLUMNS

CONVENTIONS = "CF-1.11"
"""Conventions that the attributes of data sets follow."""

DTYPE = np.dtype([(name, column.dtype) for name, column in SUMMARY_COLUMNS.items()])
"""A result, as one record."""

RESULTS: tuple[str, ...] = tuple(SUMMARY_COLUMNS)
"""Names of the variables of a result."""


def quantity_attributes(name: str) -> dict[str, Any]:
    """Return the attributes of a coordinate."""
    quantity = QUANTITIES[name]
    return {"long_name": quantity.long_name, "units": quantity.cf_unit, "scale": quantity.scale}


def _legend() -> dict[str, str]:
    letters = {str(code): f"{letter}: {meaning}" for code, letter, meaning in _core.PHASES}
    return {"0": "end of the sequence", **letters}


def result_attributes(name: str) -> dict[str, Any]:
    """Return the attributes of a variable of the result."""
    column = SUMMARY_COLUMNS[name]
    units = {"units": column.cf_unit, "scale": column.scale}
    # Lists of plain numbers: a store holds them, as the command line writes them.
    of_kind: dict[str, dict[str, Any]] = {
        "outcome": {"flag_values": list(OUTCOMES), "flag_meanings": " ".join(OUTCOMES.values())},
        "sequence": {
            "encoding": _core.SEQUENCE_ENCODING,
            "version": _core.SEQUENCE_VERSION,
            "legend": _legend(),
        },
        "count": units,
        "flag": {"flag_values": [0, 1], "flag_meanings": "no yes"},
        "real": units,
    }
    return {"long_name": column.long_name, **of_kind[column.kind]}
