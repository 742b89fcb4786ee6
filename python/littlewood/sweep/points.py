"""What a sweep is asked for: quantities over named dimensions."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from .._internal.elementwise import reals
from .._internal.extras import require
from .._internal.variables import quantity_attributes
from ..hoop import Hoop
from ..tables import AXES, FRICTION, HOOP, QUANTITIES

if TYPE_CHECKING:
    import xarray


@dataclass(frozen=True)
class Points:
    """The points of a sweep.

    The quantities that it can vary, but for those that no point has, lie over some of the
    dimensions: in memory, or in arrays of Dask.
    """

    sizes: Mapping[str, int]
    variables: Mapping[str, xarray.Variable]
    coordinates: Mapping[str, Any]
    law: str | None

    @property
    def count(self) -> int:
        """Number of points."""
        return math.prod(self.sizes.values())

    @property
    def axes(self) -> dict[str, tuple[int, ...]]:
        """The places of the dimensions of each quantity among the dimensions."""
        place = {dimension: i for i, dimension in enumerate(self.sizes)}
        return {
            name: tuple(place[str(d)] for d in one.dims) for name, one in self.variables.items()
        }

    @property
    def starts(self) -> int:
        """Number of starts of a hoop, by which it is prepared or not.

        It is decided by the dimensions alone, not by the values nor by blocks, so that the digits
        of a result do not depend on how it is cut.
        """
        of_hoops = {
            dimension
            for name in HOOP
            if name in self.variables
            for dimension in self.variables[name].dims
        }
        return math.prod(
            size for dimension, size in self.sizes.items() if dimension not in of_hoops
        )

    @property
    def is_lazy(self) -> bool:
        """Whether a quantity is an array of Dask."""
        return any(is_lazy(variable.data) for variable in self.variables.values())

    def chunked(self, chunks: Any) -> Points:
        """Cut all quantities into blocks; `chunks` as xarray takes it."""
        require("dask.array")
        # Each with the same blocks along the same dimension: found on one array over all of them.
        xr = require("xarray")
        if isinstance(chunks, Mapping):
            unknown = [str(name) for name in chunks if name not in self.sizes]
            if unknown:
                raise ValueError(
                    f"chunks has {', '.join(unknown)}; the dimensions are {', '.join(self.sizes)}"
                )
        for size in chunks.values() if isinstance(chunks, Mapping) else [chunks]:
            if isinstance(size, int) and (size == 0 or size < -1):
                raise ValueError(
                    f"chunks = {size} must be at least 1, or -1 for the whole dimension"
                )
        shape = tuple(self.sizes.values())
        probe = xr.Variable(tuple(self.sizes), np.broadcast_to(np.float64(0.0), shape)).chunk(
            chunks
        )
        blocks = probe.chunksizes
        variables = {
            name: variable.chunk({d: blocks[str(d)] for d in variable.dims})
            if variable.dims
            else variable
            for name, variable in self.variables.items()
        }
        # Indices stay in memory: xarray needs them.
        coordinates = {
            name: variable
            if variable.dims in ((), (name,))
            else variable.chunk({d: blocks[d] for d in variable.dims})
            for name, variable in self.coordinates.items()
        }
        return Points(self.sizes, variables, coordinates, self.law)


def is_lazy(data: Any) -> bool:
    """Tell whether an array is one of Dask, without importing it."""
    return hasattr(data, "__dask_graph__")


def _real(name: str, value: Any) -> Any:
    if is_lazy(value):
        reals(np.empty(0, value.dtype), name)
        return value.astype(np.float64)
    return reals(value, name)


def fill(hoop: Hoop | None, given: Mapping[str, Any]) -> dict[str, Any]:
    """Return all quantities that a sweep can vary.

    What is given, over the hoop, over the defaults of the table.

    An optional one that is not given is left out.

    Raises
    ------
    TypeError
        For an unknown name, or if a quantity is missing.
    """
    if hoop is not None and not isinstance(hoop, Hoop):
        hint = f": littlewood.case({hoop!r}).hoop is one" if isinstance(hoop, str) else ""
        raise TypeError(f"hoop = {hoop!r} must be a Hoop{hint}")
    unknown = [name for name in given if name not in (*AXES, FRICTION)]
    if unknown:
        raise TypeError(
            f"there is no quantity {', '.join(unknown)}; there are {', '.join((*AXES, FRICTION))}"
        )
    given = {name: value for name, value in given.items() if value is not None}
    if FRICTION in given:
        twice = [name for name in COEFFICIENTS if name in given]
        if twice:
            raise TypeError(
                f"{FRICTION} and {', '.join(twice)}: {FRICTION} gives both coefficients of friction"
            )
        given |= dict.fromkeys(COEFFICIENTS, given.pop(FRICTION))
    values: dict[str, Any] = {
        name: QUANTITIES[name].default for name in AXES if QUANTITIES[name].default is not None
    }
    if hoop is not None:
        values.update(
            (name, getattr(hoop, name)) for name in HOOP if getattr(hoop, name) is not None
        )
    values.update(given)
    missing = [name for name in AXES if name not in values and not QUANTITIES[name].is_optional]
    if missing:
        raise TypeError(
            f"missing: {', '.join(missing)}" + ("; give a hoop" if hoop is None else "")
        )
    return values


COEFFICIENTS = ("mu_s", "mu_k")
"""What the axis of friction gives."""

# Quantities that can contradict each other.
_BODY = ("mass_ratio", "offset", "inertia")
_RELATED = (COEFFICIENTS, _BODY, (*_BODY, "restitution"), (*_BODY, "gap_rate"))


def check_hoop(values: Mapping[str, Any], law: str | None) -> str | None:
    """Refuse a hoop without physical meaning.

    As far as that does not lie in a combination of two that vary.

    Returns the law of restitution that holds, if any.
    """
    fixed = {name for name, value in values.items() if np.ndim(value) == 0 and not is_lazy(value)}
    # The parameters that are not looked at are those of a hoop that has a meaning.
    harmless: dict[str, Any] = {
        name: 1.0 if QUANTITIES[name].default is None else QUANTITIES[name].default
        for name in HOOP
        if not QUANTITIES[name].is_optional
    }
    for related in ([name for name in names if name in values] for names in _RELATED):
        varying = [name for name in related if name not in fixed]
        if len(varying) > 1 or any(is_lazy(values[name]) for name in varying):
            continue
        known = {name: _real(name, values[name]) for name in related}
        if varying:
            known[varying[0]] = _worst(varying[0], known)
        numbers = {name: float(value) for name, value in known.items()}
        thrown = numbers.pop("gap_rate", 0.0)
        Hoop(**{**harmless, **numbers}, units=None).classify(
            theta=0.0, theta_rate=0.0, gap_rate=thrown
        )
    return Hoop(
        **harmless, restitution=1.0 if "restitution" in values else None, restitution_law=law
    ).restitution_law


def _worst(name: str, known: Mapping[str, Any]) -> Any:
    """Return the first value that breaks a relation, or one that breaks none.

    Others are refused in the computation.
    """
    values = np.asarray(getattr(known[name], "data", known[name])).ravel()
    if name == "mu_k":
        bad = values > known["mu_s"]
    elif name == "mu_s":
        bad = values < known["mu_k"]
    elif name == "restitution":
        # A massless hoop has no impacts, whatever the coefficient.
        bad = (values >= 0.0) & (values <= 1.0)
    elif name == "gap_rate":
        # Nor is it thrown.
        bad = values > 0.0
    else:
        # Only a zero can make a hoop without any inertia.
        bad = values == 0.0
    if bad.any():
        return values[np.argmax(bad)]
    harmless = {"mu_s": known.get("mu_k"), "mu_k": known.get("mu_s"), "gap_rate": 0.0}
    return harmless.get(name, 1.0)


def broadcast(values: Mapping[str, Any], law: str | None) -> Points:
    """Broadcast quantities: xarray objects by names of dimensions, arrays by position."""
    xr = require("xarray")
    named = {name: value for name, value in values.items() if isinstance(value, xr.DataArray)}
    if named:
        unnamed = [
            name for name, value in values.items() if name not in named and np.ndim(value) > 0
        ]
        if unnamed:
            raise TypeError(
                f"{', '.join(unnamed)} and {', '.join(named)} cannot be combined: "
                "give all arrays as xarray.DataArray, or none"
            )
        aligned = dict(zip(named, xr.align(*named.values(), join="exact"), strict=True))
        sizes: dict[str, int] = {}
        coordinates: dict[str, Any] = {}
        for array in aligned.values():
            sizes.update((str(dimension), size) for dimension, size in array.sizes.items())
            coordinates.update((str(name), one.variable) for name, one in array.coords.items())
        variables = {
            name: xr.Variable(aligned[name].dims, _real(name, aligned[name].data))
            if name in named
            else xr.Variable((), _real(name, value))
            for name, value in values.items()
        }
        return _with_coordinates(sizes, variables, coordinates, law)
    arrays = {name: _real(name, value) for name, value in values.items()}
    shape = np.broadcast_shapes(*(array.shape for array in arrays.values()))
    dimensions = ("start",) if len(shape) == 1 else tuple(f"dim_{i}" for i in range(len(shape)))
    variables = {}
    for name, array in arrays.items():
        own = dimensions[len(shape) - array.ndim :]
        # An axis of one value that stands for many is no dimension of this quantity.
        spread = [
            k
            for k, d in enumerate(own)
            if array.shape[k] == 1 != shape[len(shape) - array.ndim + k]
        ]
        variables[name] = xr.Variable(
            tuple(d for k, d in enumerate(own) if k not in spread),
            array.reshape(tuple(n for k, n in enumerate(array.shape) if k not in spread)),
        )
    return _with_coordinates(dict(zip(dimensions, shape, strict=True)), variables, {}, law)


def grid(values: Mapping[str, Any], law: str | None, order: Sequence[str]) -> Points:
    """Make a grid: each one-dimensional quantity is an axis of its own, in this order.

    Scalars are fixed.
    """
    xr = require("xarray")
    sizes: dict[str, int] = {}
    variables = {}
    for name, value in values.items():
        array = _real(name, value.data if isinstance(value, xr.DataArray) else value)
        if array.ndim > 1:
            raise ValueError(
                f"{name} has {array.ndim} dimensions: an axis has one, a fixed value none"
            )
        axis = FRICTION if FRICTION in order and name in COEFFICIENTS else name
        variables[name] = xr.Variable((axis,) if array.ndim else (), array)
    coordinates = {}
    for name in order:
        one = variables["mu_s" if name == FRICTION else name]
        if one.ndim:
            sizes[name] = one.size
            if name == FRICTION:
                coordinates[name] = one.compute()
                coordinates[name].attrs = quantity_attributes(name)
    return _with_coordinates(sizes, variables, coordinates, law)


def _with_coordinates(
    sizes: Mapping[str, int],
    variables: Mapping[str, Any],
    coordinates: Mapping[str, Any],
    law: str | None,
) -> Points:
    empty = [name for name, size in sizes.items() if size == 0]
    if empty:
        raise ValueError(f"{', '.join(empty)} is empty: there is nothing to simulate")
    described: dict[str, Any] = {name: one.copy(deep=False) for name, one in coordinates.items()}
    for name, one in described.items():
        if name in AXES and not one.attrs:
            one.attrs = quantity_attributes(name)
    for name in variables:
        # An index that came with the arrays stays; so does a dimension that only has the name of a
        # quantity.
        if name in sizes and (name in described or variables[name].dims != (name,)):
            continue
        described[name] = variables[name].copy(deep=False)
        described[name].attrs = quantity_attributes(name)
        if name in sizes and is_lazy(described[name].data):
            # An index cannot be lazy.
            described[name] = described[name].compute()
    return Points(sizes, variables, described, law)
