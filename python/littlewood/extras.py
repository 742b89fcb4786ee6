"""Optional dependencies: imported when they are needed, with a clear word where one is missing."""

from __future__ import annotations

import importlib
from typing import Any

_EXTRA_OF = {
    "xarray": "xarray",
    "pandas": "xarray",
    "dask": "dask",
    "dask.array": "dask",
    "distributed": "dask",
    "zarr": "dask",
    "matplotlib": "plot",
    "matplotlib.pyplot": "plot",
    "matplotlib.animation": "plot",
    "scipy": "fit",
    "scipy.optimize": "fit",
    "tqdm": "progress",
    "tqdm.auto": "progress",
}


def require(module: str) -> Any:
    """Import an optional dependency.

    Parameters
    ----------
    module : str
        Name of the module.

    Returns
    -------
    module

    Raises
    ------
    ImportError
        If it is not installed; the message names the extra of this package that brings it.
    """
    try:
        return importlib.import_module(module)
    except ModuleNotFoundError as error:
        if error.name is None or error.name.split(".")[0] != module.split(".")[0]:
            raise
        extra = _EXTRA_OF[module]
        raise ImportError(
            f'this needs {module.split(".")[0]}, which is not installed: pip install "littlewood[{extra}]"',
            name=error.name,
        ) from error
