"""What callers say of a table: its units, points and runs, and how they are told what to say."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Protocol

import numpy.typing as npt

from .._internal.elementwise import Reals

__all__ = [
    "FRAME",
    "LENGTH_UNITS",
    "PYTHON",
    "TIME_UNITS",
    "UNITS",
    "PlaneLike",
    "TableOptions",
    "Words",
]

FRAME = "frame"
"""The channel of numbers of frames, and the unit of times that are such numbers."""


@dataclass(frozen=True)
class _Unit:
    """A unit of times, angles (theta) or lengths: how many s, rad or m it is.

    That of pixels is None: they need a plane.
    """

    kind: str
    size: float | None


_PIXEL = _Unit("length", None)
UNITS = {
    "s": _Unit("time", 1.0),
    "ms": _Unit("time", 1e-3),
    "us": _Unit("time", 1e-6),
    "µs": _Unit("time", 1e-6),
    "ns": _Unit("time", 1e-9),
    "rad": _Unit("theta", 1.0),
    "deg": _Unit("theta", math.radians(1.0)),
    "°": _Unit("theta", math.radians(1.0)),
    "m": _Unit("length", 1.0),
    "cm": _Unit("length", 1e-2),
    "mm": _Unit("length", 1e-3),
    "px": _PIXEL,
    "pixel": _PIXEL,
    "pixels": _PIXEL,
}
"""Units in the names of columns."""

LENGTH_UNITS = tuple(name for name, unit in UNITS.items() if unit.kind == "length" and unit.size)
TIME_UNITS = ("s", "ms", "us", FRAME)
"""Units that can be said of columns whose names have none."""


class PlaneLike(Protocol):
    """What positions in pixels need: :class:`littlewood.video.Plane`."""

    def to_metres(self, u: npt.ArrayLike, v: npt.ArrayLike) -> tuple[Reals, Reals]:
        """Return the points of the plane that pixels show, x and y in m."""


@dataclass(frozen=True)
class Words:
    """How a caller writes the options: by name, with {} where the value stands."""

    forms: Mapping[str, str]
    quote: Callable[[str], str]

    def say(self, option: str, value: str | int | float = "") -> str:
        """Return an option with its value, for a hint."""
        text = self.quote(value) if isinstance(value, str) else f"{value:g}"
        return self.forms[option].format(text)


PYTHON = Words(
    {
        "centre": "centre={}",
        "marker": "marker={}",
        "run": "run={}",
        "fps": "fps={}",
        "plane": "plane=video.Plane.from_points(…)",
        "length_unit": "length_unit={}",
        "time_unit": "time_unit={}",
        "dimensionless": "dimensionless=True",
        "ignore": "ignore=({},)",
    },
    lambda text: json.dumps(text, ensure_ascii=False),
)
"""Options as arguments of :meth:`littlewood.Track.from_csv`."""


@dataclass(frozen=True)
class TableOptions:
    """What is said of a table: the arguments of :meth:`littlewood.Track.from_csv`."""

    level: bool = False
    centre: str | None = None
    marker: str | None = None
    run: int | str | None = None
    fps: float | None = None
    plane: PlaneLike | None = None
    length_unit: str | None = None
    time_unit: str | None = None
    dimensionless: bool = False
    ignore: tuple[str, ...] = ()
    words: Words = PYTHON

    def __post_init__(self) -> None:
        for name, known in (("length_unit", LENGTH_UNITS), ("time_unit", TIME_UNITS)):
            given = getattr(self, name)
            if given is not None and given not in known:
                raise ValueError(f"{name} = {given!r} must be one of {', '.join(known)}")
        if self.fps is not None and not (self.fps > 0.0 and math.isfinite(self.fps)):
            raise ValueError(f"fps = {self.fps} must be positive")
        if self.dimensionless and (self.length_unit or self.time_unit or self.plane):
            raise ValueError("a dimensionless table has no units, and no plane")

    def say(self, option: str, value: str | int | float = "") -> str:
        """Return an option with its value, as the caller writes it."""
        return self.words.say(option, value)
