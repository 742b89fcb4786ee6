"""Axes in the style of the figures of the project."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, TypeVar

from littlewood.style import ACCENTS, FAINT, INK, LINE, PAPER
from matplotlib.figure import Figure

if TYPE_CHECKING:
    from matplotlib.axes import Axes


T = TypeVar("T")

DEGREE = math.pi / 180.0

COLOURS = (*ACCENTS.values(), INK)
"""Colours of the lines of a panel."""

DASHES: tuple[tuple[float | None, float | None], ...] = ((None, None), (6, 2), (3, 1.5), (1, 1.2))
"""Their dashes, by which they are told apart in grey; the first has none."""


def styled(values: Sequence[T]) -> Iterator[tuple[T, str, tuple[float | None, float | None]]]:
    """Return each value with the colour and the dashes of its line."""
    if len(values) > min(len(COLOURS), len(DASHES)):
        msg = f"{len(values)} lines in a panel: there are colours for {len(COLOURS)} and dashes for {len(DASHES)}"
        raise ValueError(msg)
    return zip(values, COLOURS, DASHES, strict=False)


def panels(count: int, *, width: float = 4.3, height: float = 3.6) -> tuple[Figure, list[Axes]]:
    """Return a figure with panels side by side, each of a size in inches."""
    figure = Figure(figsize=(width * count, height), layout="constrained", facecolor=PAPER)
    axes = list(figure.subplots(1, count, squeeze=False)[0])
    for one, letter in zip(axes, "abcdefgh", strict=False):
        dressed(one)
        if count > 1:
            one.set_title(f"({letter})", loc="left", fontsize=10, color=INK)
    return figure, axes


def dressed(axes: Axes) -> None:
    """Give axes the colours of the project, and a faint grid."""
    axes.set_facecolor(PAPER)
    axes.grid(color=FAINT, linewidth=0.4, alpha=0.5)
    axes.tick_params(colors=INK, labelsize=9)
    for spine in axes.spines.values():
        spine.set_color(LINE)
