"""Derivatives of a motion as data sets."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import _core
from ..tables import SAMPLE_COLUMNS
from .elementwise import reals
from .extras import require

if TYPE_CHECKING:
    import numpy.typing as npt
    import xarray

# Columns with the unit of a number of endless rolling.
_LIKE = {"period": "time", "theta_min": "theta", "theta_max": "theta"}
_REASON = {"long_name": "why there is no derivative, empty where there is one"}


def _attributes(name: str, of: str) -> dict[str, Any]:
    column = SAMPLE_COLUMNS[_LIKE.get(name, name)]
    what = name if name in _LIKE else column.long_name
    return {"long_name": f"derivative of {what}{of}", "units": "1", "scale": column.scale}


def _variables(
    rows: _core._Rows, dimensions: tuple[str, ...], shape: tuple[int, ...], of: str, prefix: str
) -> dict[str, Any]:
    found: dict[str, Any] = {
        prefix + name: (dimensions, values.reshape(shape), _attributes(name, of))
        for name, values in rows["columns"].items()
    }
    found[prefix + "reason"] = (
        dimensions,
        np.array(rows["reasons"], dtype=np.str_).reshape(shape),
        _REASON,
    )
    return found


def _dataset(
    variables: dict[str, Any], coordinates: dict[str, Any], names: list[str], title: str
) -> xarray.Dataset:
    quantity = ("quantity", names, {"long_name": "quantity of the hoop, the plane or the start"})
    attributes = {"title": title, "source": f"littlewood {_core.__version__}"}
    dataset: xarray.Dataset = require("xarray").Dataset(
        variables, coords={**coordinates, "quantity": quantity}, attrs=attributes
    )
    return dataset


def of_motion(core: _core.Trajectory, quantities: Sequence[str] | None) -> xarray.Dataset:
    """Return the derivatives of the transitions and of the outcome."""
    found = core.derivatives(quantities)
    names, reasons = found["quantities"], found["transitions"]["reasons"]
    count = len(reasons) // len(names) if names else len(core.transitions())
    variables = _variables(
        found["transitions"],
        ("transition", "quantity"),
        (count, len(names)),
        " after the transition, along it",
        "",
    )
    variables |= _variables(
        found["outcome"], ("quantity",), (len(names),), " at the end, along it", "end_"
    )
    variables |= {
        name: ("quantity", values, _attributes(name, ""))
        for name, values in found["recurrence"].items()
    }
    place = ("transition", np.arange(count), {"long_name": "index of the transition"})
    return _dataset(
        variables, {"transition": place}, names, "derivatives of the events of a motion"
    )


def columns_at(
    core: _core.Trajectory, times: npt.NDArray[np.float64], quantities: Sequence[str]
) -> dict[str, Any]:
    """Return the derivatives of state and gap at fixed times as arrays, of times by quantities."""
    columns = core.derivatives_at(times, quantities)["rows"]["columns"]
    shape = times.size, len(quantities)
    return {name: values.reshape(shape) for name, values in columns.items()}


def at_times(
    core: _core.Trajectory, times: npt.ArrayLike, quantities: Sequence[str] | None
) -> xarray.Dataset:
    """Return the derivatives of state and gap at fixed times."""
    instants = reals(times)
    if instants.ndim > 1:
        raise ValueError(f"times of shape {instants.shape} must be one time or of shape (n,)")
    found = core.derivatives_at(instants.reshape(-1), quantities)
    names = found["quantities"]
    dimensions = ("time",) * instants.ndim
    shape = (*instants.shape, len(names))
    variables = _variables(found["rows"], (*dimensions, "quantity"), shape, " at a fixed time", "")
    # That of the time itself is zero, and its name that of the instants.
    del variables["time"]
    column = SAMPLE_COLUMNS["time"]
    time = (
        dimensions,
        instants,
        {"long_name": column.long_name, "units": column.cf_unit, "scale": column.scale},
    )
    return _dataset(
        variables, {"time": time}, names, "derivatives of the states of a motion at fixed times"
    )
