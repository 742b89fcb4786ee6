"""Colours and lines that all pictures share: told apart by the colour-blind, and in grey by their dashes."""

from __future__ import annotations

from collections.abc import Mapping

MODE_COLOURS: Mapping[str, str] = {
    "rolling": "#0072b2",
    "sliding": "#d55e00",
    "gliding": "#009e73",
    "flight": "#222222",
}
"""Colours of the modes of motion (Okabe and Ito), as in the figures of the project."""

MODE_DASHES: Mapping[str, str | tuple[float, tuple[float, ...]]] = {
    "rolling": "solid",
    "sliding": (0.0, (4.4, 1.9)),
    "gliding": (0.0, (1.6, 1.6)),
    "flight": (0.0, (0.9, 1.6)),
}
"""Dashes of the modes of motion."""

INK = "#222222"
PALE = "#888888"

CLASS_COLOURS: Mapping[str, str] = {
    "leaves at once": "#22225c",
    "lifts off later": "#d55e00",
    "rolls for ever": "#d3eaf5",
    "slides for ever": "#2aa198",
    "in contact at the limit": "#56b4e9",
    "particle at the plane": "#d988b8",
    "particle at the bottom": "#7a3b69",
    "particle at the top": "#f0e442",
    "Painlevé paradox": "#000000",
    "unresolved": "#777777",
    "not a hoop": "#e4e4e4",
}
"""Colours of the classes of outcomes in maps, as on the command line."""
