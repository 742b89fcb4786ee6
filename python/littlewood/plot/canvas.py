"""What pictures are made of: axes, ticks at multiples of π, labels, the hoop itself."""

from __future__ import annotations

import functools
import itertools
import math
from contextlib import AbstractContextManager, nullcontext
from typing import TYPE_CHECKING, Any, Literal, TypeVar, cast

import numpy as np

from .. import _core
from .._internal.extras import require
from .._protocols import HoopLike
from ..samples import Samples
from ..style import CURVE, CURVE_COLOURS, CURVE_DASHES, CURVE_WIDTHS, FAINT, INK, PAPER
from ..tables import FRICTION, MODES, QUANTITIES, SAMPLE_COLUMNS

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from .sheet import Sheet

START: dict[str, Any] = {
    "marker": "x",
    "color": INK,
    "markersize": 6.0,
    "markeredgewidth": CURVE,
    "linestyle": "none",
}
"""The mark of a start, in all pictures."""

_F = TypeVar("_F", bound="Callable[..., Any]")


def on_sheet(draw: _F) -> _F:
    """Give what a function draws the look of the project, unless it draws on axes of the caller."""

    @functools.wraps(draw)
    def dressed(subject: Any, axes: Axes | None = None, **options: Any) -> Any:
        if axes is not None:
            return draw(subject, axes, **options)
        with look():
            return draw(subject, **options)

    return cast("_F", dressed)


def look(width_mm: float | None = None) -> AbstractContextManager[Any]:
    """Give figures made in this context the look of the figures of the project.

    That is their letters, frames and lines.

    Parameters
    ----------
    width_mm : float, optional
        Width in print, where the letters of ticks have 7 points; by default figures are for a
        screen.

    Returns
    -------
    contextlib.AbstractContextManager
        As :func:`matplotlib.rc_context`; within another it changes nothing.
    """
    matplotlib = require("matplotlib")
    from .sheet import settings

    own = settings(width_mm)
    is_ours = matplotlib.rcParams["font.family"] == own["font.family"]
    context: AbstractContextManager[Any] = nullcontext() if is_ours else matplotlib.rc_context(own)
    return context


def scaled(points: float) -> float:
    """Return a length that has so many points on a screen in the look that is on."""
    from .sheet import scaled as of_look

    return of_look(points)


def checked_width(width_mm: float | None) -> float | None:
    """Return a width in print.

    Raises :class:`PictureError` for one that figures do not have.
    """
    least, most = _core.PRINT_WIDTHS_MM
    if width_mm is not None and not least <= width_mm <= most:
        raise PictureError(f"a picture is {least:g} to {most:g} mm wide, not {width_mm:g}")
    return width_mm


def sheet(width: float, height: float) -> Sheet:
    """Return a figure of a size in inches, which no state machine keeps."""
    from .sheet import Sheet

    return Sheet(figsize=(width, height))


def key(
    axes: Axes,
    heading: str | None = None,
    *,
    columns: int = 2,
    handles: list[Any] | None = None,
    **options: Any,
) -> None:
    """Put the key above the axes, below a heading.

    It covers no curve. What is drawn in pieces has one entry.
    """
    unique: dict[str, Any] = {}
    named = (
        axes.get_legend_handles_labels()
        if handles is None
        else (handles, [one.get_label() for one in handles])
    )
    for handle, label in zip(*named, strict=True):
        unique.setdefault(label, handle)
    place: dict[str, Any] = {
        "loc": "lower left",
        "bbox_to_anchor": (0.0, 1.0),
        "alignment": "left",
        "frameon": False,
    }
    legend = axes.legend(
        unique.values(), unique.keys(), title=heading, ncols=columns, **place | options
    )
    legend.get_title().set_fontsize(legend.get_texts()[0].get_fontsize())


def words(axes: Axes, sign: str) -> str:
    """Return a sign of the tables with the marks of our sheets.

    On axes of the caller it is as it stands.
    """
    from .sheet import Sheet

    return _core.marked(sign) if isinstance(axes.figure, Sheet) else sign


def sign(name: str) -> str:
    """Return the symbol of a quantity or a column of samples.

    A name that is neither stands for itself.
    """
    if name in SAMPLE_COLUMNS:
        return SAMPLE_COLUMNS[name].sign
    if name == FRICTION:
        return _core.FRICTION["sign"]
    return QUANTITIES[name].sign if name in QUANTITIES else name


def axis_label(name: str) -> str:
    """Return the symbol with its unit, if it has one."""
    known = QUANTITIES.get(name) or SAMPLE_COLUMNS.get(name)
    return (
        f"{sign(name)}  ({known.unit_sign})"
        if known is not None and known.unit_sign
        else sign(name)
    )


_ABOUT = {
    ".svg": (),
    ".pdf": ("Title", "Subject", "CreationDate"),
    ".png": ("Title", "Description"),
}
"""What formats of pictures call title and description, and a date.

The date is left out so that bytes stay the same.
"""


class PictureError(ValueError):
    """A picture that cannot be drawn as it is asked for."""


def format_of(path: Path) -> str:
    """Return the format of a picture with this name.

    Raises :class:`PictureError` for another than ours.
    """
    if path.suffix.lower() not in _ABOUT:
        raise PictureError(f"{path} must end in .svg, .pdf or .png, the formats of pictures")
    return path.suffix.lower()


def save(figure: Figure, path: Path, title: str, description: str) -> None:
    """Write a figure with a title and a description.

    The text of an SVG and of a PDF can be searched.
    """
    if (kind := format_of(path)) == ".svg":
        from .sheet import svg

        path.write_text(svg(figure, title, description), encoding="utf-8")
        return
    about = dict(itertools.zip_longest(_ABOUT[kind], (title, description)))
    with require("matplotlib").rc_context({"pdf.fonttype": 42}):
        figure.savefig(path, dpi=200, metadata=about)


def core_ticks(
    axes: Axes,
    which: Literal["x", "y"],
    kind: str = "round",
    most: int | None = None,
    least: float = -math.inf,
) -> None:
    """Put the ticks of an axis where the figures of the program have them, from a value on."""
    from .sheet import CoreLabels, CoreTicks

    axis = axes.xaxis if which == "x" else axes.yaxis
    axis.set_major_locator(CoreTicks(kind, most, least))
    axis.set_major_formatter(CoreLabels())


def pi_ticks(axes: Axes, which: Literal["x", "y"] = "x", most: int = 9) -> None:
    """Put the ticks of an angle at multiples of π.

    Parameters
    ----------
    axes : matplotlib.axes.Axes
        Axes.
    which : {"x", "y"}
        Axis that shows the angle.
    most : int, optional
        Largest number of ticks.
    """
    core_ticks(axes, which, "angular", most)


def phase_slices(samples: Samples) -> list[tuple[str, slice]]:
    """Return the parts of evenly spaced samples that lie in one phase, with their modes."""
    mode, time = samples["mode"], samples["time"]
    if not len(mode):
        return []
    # A transition stands twice, and nothing else does.
    cuts = np.flatnonzero((np.diff(time) == 0.0) | (np.diff(mode) != 0)) + 1
    edges = [0, *cuts.tolist(), len(mode)]
    return [
        (MODES[mode[a]], slice(a, b))
        for a, b in itertools.pairwise(edges)
        if mode[a] != _core.OUTSIDE
    ]


def level(slope: float, x: Any, y: Any) -> tuple[Any, Any]:
    """Return coordinates along a plane and from it as a level camera sees them.

    To the right, and upwards.
    """
    sin, cos = math.sin(slope), math.cos(slope)
    return x * cos - y * sin, x * sin + y * cos


def of_curve(name: str) -> dict[str, Any]:
    """Return the look of a curve of the (θ, θ′) plane."""
    return {
        "color": CURVE_COLOURS[name],
        "linewidth": CURVE_WIDTHS[name],
        "linestyle": CURVE_DASHES[name],
    }


def draw_plane(axes: Axes, slope: float, width: float = CURVE) -> None:
    """Draw the plane as a level camera sees it."""
    if slope == 0.0:
        axes.axhline(0.0, color=INK, linewidth=width, zorder=1)
    else:
        axes.axline((0.0, 0.0), slope=math.tan(slope), color=INK, linewidth=width, zorder=1)


def seen_heights(samples: Samples, slope: float) -> tuple[float, float]:
    """Return the lowest height of plane and hoops, and the highest of the centre.

    The lowest is 0 on a level plane.
    """
    _, heights = level(slope, samples.x, samples.centre_y)
    _, feet = level(slope, samples.x, np.zeros_like(samples.x))
    low = 0.0 if slope == 0.0 else float(min(np.min(feet), np.min(heights) - 1.0))
    return low, float(np.max(heights))


def draw_hoop(
    axes: Axes, hoop: HoopLike, x: float, y: float, theta: float, *, alpha: float = 1.0
) -> list[Any]:
    """Draw a hoop with its particle and its mass centre on its plane as a level camera sees it.

    Returns the artists.
    """
    patches, lines = require("matplotlib.patches"), require("matplotlib.lines")
    x, y = level(hoop.slope, x, y)
    theta += hoop.slope

    def along(distance: float) -> tuple[float, float]:
        return x - distance * math.sin(theta), y + distance * math.cos(theta)

    particle, centre = along(hoop.offset), along(hoop.h)
    style: dict[str, Any] = {"alpha": alpha, "zorder": 3}
    artists: list[Any] = [
        patches.Circle((x, y), 1.0, fill=False, edgecolor=FAINT, linewidth=1.3, **style),
        lines.Line2D([x, particle[0]], [y, particle[1]], color=FAINT, linewidth=1.0, **style),
        patches.Circle(particle, 0.085, facecolor=INK, edgecolor=INK, **style),
        patches.Circle(centre, 0.05, facecolor=PAPER, edgecolor=INK, linewidth=1.0, **style),
    ]
    for artist in artists:
        axes.add_artist(artist)
    return artists
