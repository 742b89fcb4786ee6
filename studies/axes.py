"""Axes in the style of the figures of the project."""

from __future__ import annotations

from typing import TYPE_CHECKING

from littlewood.style import FAINT, INK, LINE, PAPER
from matplotlib.figure import Figure

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def panels(count: int, *, width: float = 4.3, height: float = 3.6) -> tuple[Figure, list[Axes]]:
    """Return a figure with panels side by side, each of a size in inches."""
    figure = Figure(figsize=(width * count, height), layout="constrained", facecolor=PAPER)
    axes = list(figure.subplots(1, count, squeeze=False)[0])
    for one, letter in zip(axes, "abcdefgh", strict=False):
        one.set_facecolor(PAPER)
        one.grid(color=FAINT, linewidth=0.4, alpha=0.5)
        one.tick_params(colors=INK, labelsize=9)
        for spine in one.spines.values():
            spine.set_color(LINE)
        if count > 1:
            one.set_title(f"({letter})", loc="left", fontsize=10, color=INK)
    return figure, axes
