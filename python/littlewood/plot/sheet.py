"""What Matplotlib draws on.

Letters, frame, ticks and lines of the figures that the compiled module draws.
"""

from __future__ import annotations

import functools
import io
import os
import re
import unicodedata
import zlib
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import matplotlib as mpl
from cycler import cycler
from matplotlib import font_manager, ticker
from matplotlib.figure import Figure
from matplotlib.text import Text

from .. import _core
from ..style import ACCENTS, HATCH, INK, LENGTHS, LIST_DASHES, PAPER

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from matplotlib.axes import Axes
    from matplotlib.backend_bases import RendererBase

T = TypeVar("T")

_MM = 25.4
# Points to a pixel on a screen, and in print, where the letters of ticks have 7 points.
_SCREEN, _PRINT = 0.75, 7.0 / LENGTHS["small"]
# Pixels of a sheet, and of the narrowest panels that stand beside each other, and of small
# multiples.
_WIDE, _NARROW, _NARROWEST = 860.0, 280.0, 170.0


def unit() -> float:
    """Return the points to a pixel of the tables: of the look that is on, or of a screen."""
    is_ours = mpl.rcParams["font.family"][:1] == [_letters()]
    return float(mpl.rcParams["font.size"]) / LENGTHS["small"] if is_ours else _SCREEN


def scaled(points: float) -> float:
    """Return a length that has so many points on a screen in the look that is on."""
    return points * unit() / _SCREEN


def wide() -> float:
    """Return the width of a sheet of this look in pixels."""
    return float(mpl.rcParams["figure.figsize"][0]) * 72.0 / unit()


def inches(pixels: float) -> float:
    """Return a length of a sheet in inches."""
    return pixels * unit() / 72.0


@functools.cache
def _letters() -> str:
    """Tell Matplotlib of the font, which it reads from a file, and return its name."""
    font = _core.font()
    file = Path(mpl.get_cachedir()) / f"littlewood-{zlib.crc32(font):08x}.ttf"
    if not file.is_file():
        beside = file.with_suffix(f".{os.getpid()}")
        beside.write_bytes(font)
        beside.replace(file)
    font_manager.fontManager.addfont(file)
    return str(font_manager.FontProperties(fname=file).get_name())


def settings(width_mm: float | None = None) -> dict[str, Any]:
    """Return settings of Matplotlib for a screen, or for a width in print.

    In print the letters of ticks have 7 points.
    """
    unit = _SCREEN if width_mm is None else _PRINT
    wide = _WIDE * unit / 72.0 if width_mm is None else width_mm / _MM
    fine, curve, tick, letter, small = (
        unit * LENGTHS[name] for name in ("fine", "curve", "tick", "letter", "small")
    )
    axis = {"direction": "out", "labelsize": small, "major.size": tick, "minor.size": 0.5 * tick}
    axis |= {
        "major.width": fine,
        "minor.width": fine,
        "major.pad": tick,
        "minor.pad": tick,
        "color": INK,
    }
    return {
        **{f"{which}tick.{name}": value for which in "xy" for name, value in axis.items()},
        "axes.axisbelow": False,
        "axes.edgecolor": INK,
        "axes.facecolor": PAPER,
        "axes.labelcolor": INK,
        "axes.labelsize": letter,
        "axes.linewidth": fine,
        "axes.prop_cycle": cycler(color=[*ACCENTS.values(), INK]),
        "axes.titlecolor": INK,
        "axes.titlelocation": "left",
        "axes.titlepad": 8.0 * unit,
        "axes.titlesize": small,
        "figure.constrained_layout.use": True,
        "figure.facecolor": PAPER,
        "figure.figsize": (wide, 0.42 * wide),
        "font.family": [_letters(), "STIXGeneral", "DejaVu Sans"],
        "font.size": small,
        "hatch.color": HATCH,
        "hatch.linewidth": fine,
        "legend.borderaxespad": 0.4,
        "legend.borderpad": 0.0,
        "legend.columnspacing": 1.5,
        "legend.fontsize": small,
        "legend.frameon": False,
        "legend.handlelength": 2.1,
        "legend.handletextpad": 0.5,
        "legend.labelcolor": INK,
        "legend.labelspacing": 0.25,
        "lines.linewidth": curve,
        "lines.solid_capstyle": "butt",
        "lines.markersize": 4.0 * unit / _SCREEN,
        "savefig.facecolor": PAPER,
        "text.color": INK,
        "text.hinting": "none",
    }


class Sheet(Figure):
    """A figure whose texts carry marks.

    `*θ*` for a symbol, `_{s}` below and `^{2}` above the line.
    """

    def draw(self, renderer: RendererBase) -> None:
        """Draw it, its texts set."""
        for axes in self.axes:
            for axis in (axes.xaxis, axes.yaxis):
                if isinstance(axis.get_major_formatter(), ticker.LogFormatter):
                    axis.set_major_formatter(
                        ticker.FuncFormatter(lambda value, _: _core.unicode(power(value)))
                    )
                    axis.set_minor_formatter(ticker.NullFormatter())
        for text in self.findobj(Text):
            text.set_text(_core.unicode(text.get_text()))
        super().draw(renderer)


class CoreTicks(ticker.Locator):
    """Ticks where the figures of the program have them, as many as have room.

    `kind` is `round` or `angular`, `most` a number of ticks for any room, and `least` where they
    begin.
    """

    axis: Any

    def __init__(self, kind: str, most: int | None, least: float) -> None:
        self.kind, self.most, self.least = kind, most, least
        # Points of a letter, which the look decides that is on now, not when it is drawn.
        self._letter = unit() * LENGTHS["small"]

    def __call__(self) -> list[float]:
        """Return the places of the ticks in sight."""
        return self.tick_values(*self.axis.get_view_interval())

    def tick_values(self, vmin: float, vmax: float) -> list[float]:
        """Return the places of the ticks of a range."""
        return [row["value"] for row in self.rows(vmin, vmax)]

    def rows(self, vmin: float, vmax: float) -> list[Any]:
        """Return places and labels of the ticks of a range."""
        low, high = sorted((max(float(vmin), self.least), max(float(vmax), self.least)))
        if self.most is not None:
            return _core.ticks(self.kind, low, high, self.most)
        axes, across = self.axis.axes, self.axis.axis_name == "x"
        box = axes.get_window_extent()
        letters = (box.width if across else box.height) * 72.0 / (axes.figure.dpi * self._letter)
        rows: list[Any] = []
        # As many as have room, two at least; numbers stand beside each other on one axis, over each
        # other on the other.
        for height in (2.0, 1.35):
            for most in range(9, 0, -1):
                rows = _core.ticks(self.kind, low, high, most)
                size = max((0.56 * len(row["label"]) + 1.2 for row in rows), default=0.0)
                if len(rows) > 1 and len(rows) * (size if across else height) <= letters:
                    return rows
        return rows[:1]


class CoreLabels(ticker.Formatter):
    """Their labels."""

    axis: Any

    def __call__(self, value: float, pos: int | None = None) -> str:
        """Return the label of a tick."""
        return self.format_ticks([value])[0]

    def format_ticks(self, values: Sequence[float]) -> list[str]:
        """Return the labels of ticks."""
        locator = self.axis.get_major_locator()
        known = {row["value"]: row["label"] for row in locator.rows(*self.axis.get_view_interval())}
        return [known.get(value, "") for value in values]


def power(value: float) -> str:
    """Return a number of one digit for print: small and large ones with a power of ten."""
    mantissa, exponent = f"{abs(value):.0e}".split("e")
    if value == 0.0 or -1 <= int(exponent) <= 1:
        return f"{value:g}".replace("-", "−")
    text = f"10^{{{int(exponent)}}}" if mantissa == "1" else f"{mantissa}·10^{{{int(exponent)}}}"
    return f"{'−' if value < 0.0 else ''}{text}".replace("-", "−")


def listed(values: Sequence[T]) -> Iterator[tuple[T, dict[str, Any]]]:
    """Return each value of a list with the colour and the dashes of its line.

    These mean nothing else.
    """
    looks = [
        {"color": colour, "linestyle": dash}
        for colour, dash in zip((*ACCENTS.values(), INK), LIST_DASHES, strict=False)
    ]
    if len(values) > len(looks):
        raise ValueError(f"{len(values)} lines in a panel: there are colours for {len(looks)}")
    return zip(values, looks, strict=False)


def panels(
    count: int,
    *,
    columns: int | None = None,
    height: float = 362.0,
    letters: bool = True,
    **options: Any,
) -> tuple[Sheet, list[Axes]]:
    """Return a sheet as wide as the settings say, with panels of a height in pixels, in rows.

    Where there are several they have letters. Small multiples stand in so many columns where there
    is room; they share axes by the `options` of :meth:`matplotlib.figure.Figure.subplots`.
    """
    wide = mpl.rcParams["figure.figsize"][0]
    unit = mpl.rcParams["font.size"] / LENGTHS["small"]
    most = max(1, int(wide * 72.0 / unit / (_NARROWEST if columns else _NARROW)))
    across = min(columns or (3 if count == 3 else 2), most, count)
    rows = -(-count // across)
    figure = Sheet(figsize=(wide, rows * height * unit / 72.0))
    axes = list(figure.subplots(rows, across, squeeze=False, **options).flat)
    for place in range(count, rows * across):
        axes[place].set_axis_off()
        # The axes above it have no others below.
        axes[place - across].tick_params(labelbottom=True)
    if count > 1 and letters:
        for one, letter in zip(axes[:count], "abcdefghijklmnopqrstuvwxyz", strict=False):
            where: dict[str, Any] = {
                "xycoords": "axes fraction",
                "textcoords": "offset points",
                "ha": "right",
            }
            one.annotate(
                f"({letter})", (0.0, 1.0), (-6.0 * unit, mpl.rcParams["axes.titlepad"]), **where
            )
    return figure, axes[:count]


def svg(figure: Figure, title: str, description: str) -> str:
    """Return an SVG with a title and a description.

    Each text is a label of its outlines, as figures have them.
    """
    file = io.StringIO()
    with mpl.rc_context({"svg.fonttype": "path", "svg.hashsalt": "littlewood"}):
        figure.savefig(
            file, format="svg", metadata=dict.fromkeys(("Date", "Creator", "Format", "Type"))
        )
    text = re.sub(r"\n(?=[LQCz])", "", file.getvalue())
    text = re.sub(
        r"<!-- (.*?) -->\s*<g ", lambda found: f'<g aria-label="{_upright(found[1])}" ', text
    )
    said = f' role="img">\n <title>{escape(title)}</title>\n <desc>{escape(description)}</desc>'
    return re.sub(r"(<svg [^>]*)>", lambda found: found[1] + said, text, count=1)


def _upright(text: str) -> str:
    """Return a text without mathematical symbols for italics and signs of our font.

    Nobody searches by these.
    """
    text = re.sub("[\ue000-\ue1ff]", lambda found: chr(ord(found[0]) & 0xFF), text)
    return re.sub(
        "[ℎ\U0001d434-\U0001d7ff]", lambda found: unicodedata.normalize("NFKC", found[0]), text
    )
