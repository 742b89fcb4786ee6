"""Broadcasting of functions that work element by element."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

Reals = npt.NDArray[np.float64]


def reals(values: Any, name: str | None = None) -> Reals:
    """Return numbers as an array, NaN where masked.

    Refuse dates, texts and complex numbers by their `name`.
    """
    array = np.asanyarray(values)
    owner = "" if name is None else f"{name} must hold real numbers: "
    if array.dtype.kind not in "biufO":
        raise TypeError(f"{owner}{array.dtype} is not a type of real numbers")
    # NumPy would read the texts among objects as numbers.
    if array.dtype.kind == "O" and any(isinstance(one, (str, bytes)) for one in array.flat):
        raise TypeError(f"{owner}a text is not a real number")
    if np.ma.isMaskedArray(array):
        array = np.ma.filled(array.astype(np.float64), np.nan)
    try:
        return np.asarray(array, dtype=np.float64)
    except OverflowError:
        raise TypeError(f"{owner}a number is beyond the range of doubles") from None
    except (TypeError, ValueError) as error:
        raise type(error)(f"{owner}{error}") from None


def real(value: Any, name: str) -> float:
    """Return a number.

    Refuse texts, dates, complex numbers and arrays by the `name` of the argument.
    """
    if isinstance(value, float):
        return float(value)
    try:
        number = None if value is None else reals(value)
    except (TypeError, ValueError):
        number = None
    if number is None or number.ndim > 0:
        raise TypeError(f"{name} = {value!r} must be a real number")
    return float(number)


def flat(values: Any, dtype: Any = np.float64) -> npt.NDArray[Any]:
    """Return an array of one dimension, as the core takes it: of this type, and aligned.

    Arrays that come out of a file or from another process may start anywhere in memory.
    """
    return np.require(np.ravel(np.asarray(values)), dtype, "A")


def broadcast(
    function: Callable[..., Any],
    *arguments: npt.ArrayLike,
    outputs: int = 1,
    dtype: Any = np.float64,
) -> Any:
    """Call a function of one-dimensional float64 arrays on what NumPy or xarray can broadcast.

    It returns an array, or a tuple of `outputs`; `dtype` is theirs, for arrays of Dask. Scalars
    give a scalar.
    """
    xarray = sys.modules.get("xarray")
    if xarray is not None and any(
        isinstance(a, (xarray.DataArray, xarray.Variable)) for a in arguments
    ):
        return xarray.apply_ufunc(
            lambda *a: broadcast(function, *a, outputs=outputs),
            *arguments,
            output_core_dims=[[]] * outputs,
            dask="parallelized",
            output_dtypes=[dtype] * outputs,
            keep_attrs=False,
        )
    arrays = np.broadcast_arrays(*(reals(a) for a in arguments))
    shape = arrays[0].shape
    result = function(*(flat(a) for a in arrays))
    if outputs == 1:
        return result.reshape(shape)[()]
    return tuple(one.reshape(shape)[()] for one in result)
