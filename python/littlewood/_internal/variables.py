"""Types and attributes of the variables of sweeps: those of the Zarr stores of the command line."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from .. import _core
from ..tables import FRICTION, OUTCOMES, QUANTITIES, SUMMARY_COLUMNS

CONVENTIONS = "CF-1.11"
"""Conventions that the attributes of data sets follow."""

RESULTS: tuple[str, ...] = tuple(SUMMARY_COLUMNS)
"""Names of the variables of a result."""


def quantity_attributes(name: str) -> dict[str, Any]:
    """Return the attributes of a coordinate."""
    if name == FRICTION:
        return {**quantity_attributes("mu_s"), "long_name": _core.FRICTION["long_name"]}
    quantity = QUANTITIES[name]
    return {"long_name": quantity.long_name, "units": quantity.cf_unit, "scale": quantity.scale}


def record(derivatives: Sequence[str]) -> np.dtype[Any]:
    """Return the type of a result with these derivatives, as one record."""
    columns = [(name, column.dtype) for name, column in SUMMARY_COLUMNS.items()]
    return np.dtype([*columns, *((name, "float64") for name in derivatives)])


def checked_derivatives(names: Iterable[str], has_restitution: bool) -> tuple[str, ...]:
    """Return names of derivatives, each once.

    Refuse unknown ones, and those of what no motion has.
    """
    names = tuple(dict.fromkeys(names))
    for name in names:
        if _core.derivative_column(name)["quantity"] == "restitution" and not has_restitution:
            raise ValueError(f"{name}: the motions have no coefficient of restitution")
    return names


def _legend() -> str:
    """Return what the codes of phases mean, as JSON.

    No file format takes an attribute with parts.
    """
    letters = {str(row["code"]): f"{row['name']}: {row['label']}" for row in _core.PHASES}
    legend = {"0": "end of the sequence", **letters}
    return json.dumps(legend, ensure_ascii=False, separators=(",", ":"))


def result_attributes(name: str) -> dict[str, Any]:
    """Return the attributes of a variable of the result."""
    if name not in SUMMARY_COLUMNS:
        derivative = _core.derivative_column(name)
        return {
            "long_name": derivative["long_name"],
            "units": derivative["unit"],
            "scale": derivative["scale"],
        }
    column = SUMMARY_COLUMNS[name]
    units = {"units": column.cf_unit, "scale": column.scale}

    def flags(codes: Mapping[int, str]) -> dict[str, Any]:
        # CF wants values of the type of the variable.
        values = np.array(list(codes), dtype=column.dtype)
        return {"flag_values": values, "flag_meanings": " ".join(codes.values())}

    of_kind: dict[str, dict[str, Any]] = {
        "outcome": flags(OUTCOMES),
        "sequence": {
            "encoding": _core.SEQUENCE_ENCODING,
            "version": _core.SEQUENCE_VERSION,
            "legend": _legend(),
        },
        "count": units,
        "flag": flags({0: "no", 1: "yes"}),
        "real": units,
    }
    return {"long_name": column.long_name, **of_kind[column.kind]}
