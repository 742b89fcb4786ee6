"""Optional dependencies: imported when they are needed, with a clear word where one is missing."""

from __future__ import annotations

import importlib
from collections.abc import Callable, Iterator
from contextlib import contextmanager
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

    If it is not installed, the error names the extra that brings it.
    """
    try:
        return importlib.import_module(module)
    except ModuleNotFoundError as error:
        package = module.split(".")[0]
        if error.name is None or error.name.split(".")[0] != package:
            raise
        message = (
            f"this needs {package}, which is not installed: pip install "
            f'"littlewood[{_EXTRA_OF[package]}]"'
        )
        raise ImportError(message, name=error.name) from error


@contextmanager
def progress_bar(total: int, unit: str, wanted: bool) -> Iterator[Callable[[int], object]]:
    """Show a bar (tqdm) while something is computed, if it is wanted.

    Yields what takes how much of `total` is done.
    """
    if not wanted:
        yield lambda done: None
        return
    with require("tqdm.auto").tqdm(total=total, unit=f" {unit}", unit_scale=True) as bar:
        yield lambda done: bar.update(done - bar.n)
