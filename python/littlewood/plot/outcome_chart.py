"""Maps of classes of outcomes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from .. import _core
from .._internal.elementwise import flat
from .._internal.extras import require
from ..style import CLASS_COLOURS, FINE, INK, MIXED
from ..tables import CLASS_LABELS, CLASSES
from .canvas import axis_label, core_ticks, on_sheet, scaled, sheet, sign, words

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

    Where outcomes change more finely than the map tells there is one tint, by the rule of the
    figures; maps of fewer than 60 motions either way tell too little for it.

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
    is_beside = True
    if axes is None:
        from .sheet import inches, wide

        is_beside = wide() > _ROOM_FOR_KEY
        axes = sheet(inches(wide()), inches(0.6 * wide() + 30.0 * (not is_beside))).add_subplot()
    values = _with_mixed(shown.to_numpy())
    axes.pcolormesh(
        shown[x].to_numpy(),
        shown[y].to_numpy(),
        values,
        cmap=colors.ListedColormap([colour for _, colour in _entries()]),
        vmin=-0.5,
        vmax=len(CLASSES) + 0.5,
        shading="nearest",
        rasterized=True,
    )
    counts = np.bincount(values.ravel(), minlength=len(CLASSES) + 1)
    # Beside a low map a key with two lines an entry would be higher than the map.
    is_low = axes.get_window_extent().height < _ROOM_FOR_TWO_LINES * axes.figure.dpi
    between = ", " if is_low else "\n"
    handles = [
        patches.Patch(
            facecolor=colour,
            edgecolor=INK,
            linewidth=scaled(FINE),
            label=f"{label}{between}{100 * counts[i] / values.size:.1f} %",
        )
        for i, (label, colour) in enumerate(_entries())
        if counts[i]
    ]
    beside: dict[str, Any] = {
        "loc": "upper left",
        "bbox_to_anchor": (1.02, 1.0),
        "labelspacing": 0.3 if is_low else 0.9,
    }
    above: dict[str, Any] = {"loc": "lower left", "bbox_to_anchor": (0.0, 1.0), "ncols": 2}
    axes.legend(handles=handles, handlelength=1.6, **(beside if is_beside else above))
    _draw_axes(axes, shown, x, y)
    return axes


_ROOM_FOR_KEY = 600.0
"""Pixels of a sheet on which a key has room beside a map."""

_ROOM_FOR_TWO_LINES = 2.0
"""Inches of the height of a map from which on the key beside it has two lines an entry."""

_TELLING = 60
"""Motions either way from which on a map tells where outcomes are mixed."""


def _entries() -> list[tuple[str, str]]:
    """Return what a map shows by its codes: the classes, and what is mixed."""
    own = [(CLASS_LABELS[name], CLASS_COLOURS[name]) for name in CLASSES]
    return [*own, ("mixed more finely\nthan drawn", MIXED)]


def _with_mixed(values: Any) -> Any:
    """Give places around which outcomes change more finely than the map tells one code."""
    if min(values.shape) < _TELLING:
        return values
    is_mixed = _core.mixed(flat(values, np.uint8), values.shape[1]).reshape(values.shape)
    is_known = values != CLASSES.index("not_computed")
    return np.where(is_mixed & is_known, np.uint8(len(CLASSES)), values)


def _draw_axes(axes: Axes, shown: xarray.DataArray, x: str, y: str) -> None:
    axes.set_xlabel(words(axes, sign(x) if x == "theta" else axis_label(x)))
    axes.set_ylabel(words(axes, sign(y) if y == "theta" else axis_label(y)))
    which: Literal["x", "y"]
    for which, name in (("x", x), ("y", y)):
        if _is_geometric(shown[name].to_numpy()):
            (axes.set_xscale if which == "x" else axes.set_yscale)("log")
        else:
            core_ticks(axes, which, "angular" if name == "theta" else "round")
