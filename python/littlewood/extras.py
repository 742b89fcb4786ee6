"""Optional dependencies: imported when they are needed, with a clear word where one is missing."""

from __future__ import annotations

import importlib
from typing import Any

_EXTRA_OF = {
    "xarray": "xarray",
    "pandas": "xarray",
    "dask": "dask",
    "matplotlib": "plot",
    "scipy": "fit",
    "tqdm": "progress",
    "anywidget": "lab",
    "flint": "certify",
    "cv2": "video",
    "jax": "jax",
    "torch": "torch",
}
"""The extra that brings a package."""


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
        package = module.split(".")[0]
        if error.name is None or error.name.split(".")[0] != package:
            raise
        message = f'this needs {package}, which is not installed: pip install "littlewood[{_EXTRA_OF[package]}]"'
        raise ImportError(message, name=error.name) from error
