"""Maps of classes of outcomes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .. import _core
from .._internal.elementwise import flat
from .._internal.extras import require
from ..style import CLASS_COLOURS, FINE, INK
from ..tables import CLASS_LABELS, CLASSES
from .canvas import axis_label, on_sheet, pi_ticks, sheet, sign, words

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes


def classes(dataset: xarray.Dataset) -> xarray.DataArray:
    """Return the class of each motion of a sweep, as all maps show it.

    Parameters
    ----------
    dataset : xarray.Dataset
        The result of :func:`littlewood.outcome_map` or :func:`littlewood.simulate_many`.

    Returns
    -------
    xarray.DataArray of uint8
        Codes, the places of the names in :data:`littlewood.tables.CLASSES`: motions that leave the
        plane at once, that lift off later, and those that do not, by their outcome.

    Raises
    ------
    ValueError
        For codes that are no integers: a store opened without `mask_and_scale=False`.
    """
    columns = [dataset[name] for name in ("outcome", "sequence", "lift_off_time")]
    if not all(np.issubdtype(column.dtype, np.integer) for column in columns[:2]):
        raise ValueError(
            "outcome and sequence must hold integers: open the store with mask_and_scale=False"
        )
    result = require("xarray").apply_ufunc(
        _codes, *columns, dask="parallelized", output_dtypes=[np.uint8]
    )
    result.attrs = {
        "long_name": "class of the outcome",
        "flag_values": list(range(len(CLASSES))),
        "flag_meanings": " ".join(CLASSES),
    }
    named: xarray.DataArray = result.rename("class")
    return named


def _is_geometric(values: Any) -> bool:
    """Tell whether an axis has equal factors, and not equal steps."""
    if values.size < 3 or np.min(values) <= 0.0:
        return False
    ratios, steps = np.diff(np.log(values)), np.diff(values)
    return bool(
        np.allclose(ratios, ratios[0], rtol=1e-6) and not np.allclose(steps, steps[0], rtol=1e-6)
    )


def _codes(outcome: Any, sequence: Any, lift_off_time: Any) -> Any:
    arrays = np.broadcast_arrays(outcome, sequence, lift_off_time)
    types = (np.uint8, np.uint64, np.float64)
    columns = [flat(array, dtype) for array, dtype in zip(arrays, types, strict=True)]
    return _core.classes(*columns).reshape(arrays[0].shape)


@on_sheet
def outcomes(
    dataset: xarray.Dataset, axes: Axes | None = None, *, x: str | None = None, y: str | None = None
) -> Axes:
    """Draw a map of the classes of outcomes, with a legend and the share of each class.

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
        raise ValueError(
            f"a map has two dimensions, not {shown.ndim}: {', '.join(map(str, shown.dims))}"
        )
    first, second = (str(dimension) for dimension in shown.dims)
    x = x if x is not None else (second if y == first else first)
    y = y if y is not None else (second if x == first else first)
    shown = shown.transpose(y, x)
    if axes is None:
        axes = sheet(8.0, 4.8).add_subplot()
    palette = colors.ListedColormap([CLASS_COLOURS[name] for name in CLASSES])
    values = shown.to_numpy()
    axes.pcolormesh(
        shown[x].to_numpy(),
        shown[y].to_numpy(),
        values,
        cmap=palette,
        vmin=-0.5,
        vmax=len(CLASSES) - 0.5,
        shading="nearest",
        rasterized=True,
    )
    counts = np.bincount(values.ravel(), minlength=len(CLASSES))
    handles = [
        patches.Patch(
            facecolor=CLASS_COLOURS[name],
            edgecolor=INK,
            linewidth=FINE,
            label=f"{CLASS_LABELS[name]}\n{100 * counts[i] / values.size:.1f} %",
        )
        for i, name in enumerate(CLASSES)
        if counts[i]
    ]
    axes.legend(
        handles=handles,
        loc="upper left",
        bbox_to_anchor=(1.02, 1.0),
        labelspacing=0.9,
        handlelength=1.6,
    )
    axes.set_xlabel(words(axes, sign(x) if x == "theta" else axis_label(x)))
    axes.set_ylabel(words(axes, sign(y) if y == "theta" else axis_label(y)))
    if _is_geometric(shown[x].to_numpy()):
        axes.set_xscale("log")
    if _is_geometric(shown[y].to_numpy()):
        axes.set_yscale("log")
    if x == "theta":
        pi_ticks(axes)
    if y == "theta":
        pi_ticks(axes, "y")
    return axes
