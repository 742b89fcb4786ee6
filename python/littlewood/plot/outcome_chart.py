"""Maps of what becomes of the motions."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..extras import require
from ..style import CLASS_COLOURS, PALE
from .canvas import LABELS, new_axes, pi_ticks

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes


def classes(dataset: xarray.Dataset) -> xarray.DataArray:
    """Sort the motions of a sweep into the classes that maps show.

    Parameters
    ----------
    dataset : xarray.Dataset
        The result of :func:`littlewood.outcome_map` or :func:`littlewood.simulate_many`.

    Returns
    -------
    xarray.DataArray of uint8
        Places in the list of classes, which `flag_meanings` names: motions that leave the plane at once, that lift off
        later, and those that do not, by their outcome.
    """
    xr = require("xarray")
    names = list(CLASS_COLOURS)
    of_outcome = {
        1: "rolls for ever",
        2: "slides for ever",
        3: "particle at the plane",
        4: "particle at the bottom",
        5: "particle at the top",
        6: "in contact at the limit",
        7: "in contact at the limit",
        8: "Painlevé paradox",
        9: "Painlevé paradox",
        10: "Painlevé paradox",
        11: "unresolved",
    }
    table = np.full(256, names.index("not a hoop"), dtype=np.uint8)
    for code, name in of_outcome.items():
        table[code] = names.index(name)
    code = xr.apply_ufunc(
        lambda outcome: table[outcome], dataset["outcome"], dask="parallelized", output_dtypes=[np.uint8]
    )
    flies = ~np.isnan(dataset["lift_off_time"])
    at_once = (dataset["sequence"] & np.uint64(7)) == 7
    result = xr.where(at_once, np.uint8(0), xr.where(flies, np.uint8(1), code)).astype(np.uint8)
    result.attrs = {
        "long_name": "what becomes of the motion",
        "flag_values": list(range(len(names))),
        "flag_meanings": " ".join(name.replace(" ", "_") for name in names),
    }
    named: xarray.DataArray = result.rename("class")
    return named


def outcomes(dataset: xarray.Dataset, axes: Axes | None = None, *, x: str | None = None, y: str | None = None) -> Axes:
    """Draw a map of what becomes of the motions, with a legend and the share of each class.

    Parameters
    ----------
    dataset : xarray.Dataset
        A result of two dimensions.
    axes : matplotlib.axes.Axes, optional
        Where to draw; a new figure by default.
    x, y : str, optional
        Dimensions of the axes; the first and the second by default.

    Returns
    -------
    matplotlib.axes.Axes
    """
    colors, patches = require("matplotlib.colors"), require("matplotlib.patches")
    shown = classes(dataset)
    if shown.ndim != 2:
        raise ValueError(f"a map has two dimensions, not {shown.ndim}: {', '.join(map(str, shown.dims))}")
    first, second = (str(dimension) for dimension in shown.dims)
    x = x if x is not None else (second if y == first else first)
    y = y if y is not None else (second if x == first else first)
    shown = shown.transpose(y, x)
    if axes is None:
        axes = new_axes(8.0, 4.8)
    names = list(CLASS_COLOURS)
    palette = colors.ListedColormap(list(CLASS_COLOURS.values()))
    values = shown.to_numpy()
    axes.pcolormesh(
        shown[x].to_numpy(),
        shown[y].to_numpy(),
        values,
        cmap=palette,
        vmin=-0.5,
        vmax=len(names) - 0.5,
        shading="nearest",
        rasterized=True,
    )
    counts = np.bincount(values.ravel(), minlength=len(names))
    handles = [
        patches.Patch(
            facecolor=CLASS_COLOURS[name],
            edgecolor=PALE,
            label=f"{name}\n{100 * counts[i] / values.size:.1f} %",
        )
        for i, name in enumerate(names)
        if counts[i]
    ]
    axes.legend(handles=handles, loc="upper left", bbox_to_anchor=(1.02, 1.0), frameon=False, labelspacing=0.9)
    axes.set_xlabel(LABELS.get(x, x))
    axes.set_ylabel(LABELS.get(y, y))
    if x == "theta":
        pi_ticks(axes)
    if y == "theta":
        pi_ticks(axes, "y")
    return axes
