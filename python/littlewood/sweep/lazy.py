"""Sweeps in blocks: lazy arrays that any scheduler of Dask can compute."""

from __future__ import annotations

import operator
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from .._internal.extras import require
from .._internal.variables import RESULTS, record
from .block import Limits, compute
from .points import Points


def lazy_columns(points: Points, limits: Limits, derivatives: Sequence[str]) -> dict[str, Any]:
    """Return the variables of a result as arrays of Dask.

    A block of points is one task, which makes records; each variable picks its field of them.
    Nothing is computed here.
    """
    da = require("dask.array")
    axes = points.axes
    dtype = record(derivatives)
    varying = [name for name, variable in points.variables.items() if variable.ndim]
    fixed = {name: float(one.data) for name, one in points.variables.items() if not one.ndim}
    arguments: list[Any] = []
    for name in varying:
        data = points.variables[name].data
        arguments += [da.asanyarray(data), axes[name]]
    # The blocks are made alike here: Dask would warn that a product of axes has more of them than
    # each axis.
    _, alike = da.core.unify_chunks(*arguments, warn=False)
    arguments[::2] = alike
    records = da.blockwise(
        _records,
        tuple(range(len(points.sizes))),
        *arguments,
        align_arrays=False,
        names=tuple(varying),
        axes=axes,
        fixed=fixed,
        law=points.law,
        limits=tuple(limits),
        starts=points.starts,
        derivatives=tuple(derivatives),
        dtype=dtype,
        meta=np.empty((0,) * len(points.sizes), dtype=dtype),
    )
    return {
        name: records.map_blocks(
            operator.itemgetter(name), dtype=dtype[name], name=f"{name}-{records.name}"
        )
        for name in (*RESULTS, *derivatives)
    }


def _records(
    *blocks: npt.NDArray[np.float64],
    names: tuple[str, ...],
    axes: Mapping[str, tuple[int, ...]],
    fixed: Mapping[str, float],
    law: str | None,
    limits: tuple[float | None, int, int, str],
    starts: int,
    derivatives: tuple[str, ...],
) -> npt.NDArray[Any]:
    arrays = dict(zip(names, blocks, strict=True))
    arrays.update((name, np.asarray(value)) for name, value in fixed.items())
    # A worker of Dask runs as many blocks at a time as it has threads: one thread for each.
    columns = compute(
        arrays, axes, law, Limits(*limits), starts, threads=1, derivatives=derivatives
    )
    records = np.empty(columns["outcome"].shape, dtype=record(derivatives))
    for name, values in columns.items():
        records[name] = values
    return records
