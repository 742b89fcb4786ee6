"""Colours and lines of all pictures: told apart by the colour-blind, and in grey by their dashes.

They are those of the figures, maps and films of the project, on light paper.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from . import _core

Dashes = str | tuple[float, tuple[float, ...]]
"""Dashes as Matplotlib takes them."""

LENGTHS: Mapping[str, float] = MappingProxyType(_core.lengths())
"""Widths of lines, length of a tick and sizes of letters, in pixels of 1/96 inch.

Those of ticks are small.
"""

_POINTS_PER_PIXEL = 72.0 / 96.0

FINE, CURVE, BOLD = (_POINTS_PER_PIXEL * LENGTHS[name] for name in ("fine", "curve", "bold"))
"""Widths of lines in points.

Of frames and what is beside the matter, of curves, and of emphasised ones.
"""


def _colours(group: str) -> Mapping[str, str]:
    return MappingProxyType(
        {row["name"]: row["colour"] for row in _core.swatches(False) if row["group"] == group}
    )


def _dashes(group: str) -> Mapping[str, Dashes]:
    return MappingProxyType(
        {
            row["name"]: (0.0, tuple(row["pattern"])) if row["pattern"] else "solid"
            for row in _core.dashes()
            if row["group"] == group
        }
    )


MODE_COLOURS: Mapping[str, str] = _colours("mode")
"""Colours of the modes of motion, by their names."""

MODE_DASHES: Mapping[str, Dashes] = _dashes("mode")
"""Dashes of lines that show modes of motion, by their names."""

CLASS_COLOURS: Mapping[str, str] = _colours("class")
"""Colours of the classes of outcomes in maps, by their names."""

CURVE_COLOURS: Mapping[str, str] = _colours("curve")
"""Colours of the curves of the (θ, θ′) plane.

They are slip_limit (f), normal_force_zero (n), separatrix, lift_off,
chatter, level, band_of_rest."""

CURVE_DASHES: Mapping[str, Dashes] = _dashes("curve")
"""Dashes of these curves."""

LIST_DASHES: tuple[Dashes, ...] = tuple(_dashes("dash").values())
"""Dashes of the lines of a list, by which they are told apart in grey."""

CURVE_WIDTHS: Mapping[str, float] = MappingProxyType(
    {row["name"]: _POINTS_PER_PIXEL * row["width"] for row in _core.curves()}
)
"""Widths of these curves in points."""

CURVE_LETTERS: Mapping[str, str] = MappingProxyType(
    {row["name"]: row["letter"] for row in _core.curves() if row["letter"] is not None}
)
"""Letters of the curves that have one in the paper."""

ARROW_COLOURS: Mapping[str, str] = _colours("arrow")
"""Colours of the forces, of impulses and of the slip."""

_INKS = _colours("ink")

PAPER = _INKS["paper"]
"""What everything stands on."""

INK = _INKS["ink"]
"""Letters, axes, the body."""

SOFT = _INKS["soft"]
"""Letters and lines of less weight."""

FAINT = _INKS["faint"]
"""Lines behind others."""

LINE = _INKS["line"]
"""Grids, frames."""

HATCH = _INKS["hatch"]
"""Hatches of what cannot be."""

MIXED = _INKS["mixed"]
"""Where outcomes change more finely than a map tells."""

REGION = _INKS["region"]
"""The region where the hoop can roll."""

ACCENTS: Mapping[str, str] = _colours("accent")
"""Colours that a picture gives a meaning for itself alone."""
