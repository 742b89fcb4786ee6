"""The window in which a path is seen, and the events along it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from .._protocols import MotionLike
from ..samples import Samples
from ..style import INK
from ..tables import CAUSE_LABELS
from .canvas import draw_hoop, level, scaled, seen_heights

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_LOWEST, _HIGHEST = 96.0, 0.5
"""Pixels of the height of axes at least, and parts of their width at most."""

_SMALLEST = 7.0
"""Pixels of a radius with which a hoop can be seen."""

_EMPTY = 0.45
"""Part of the width that a path takes at least where both axes have one scale."""

_ROW, _BEGIN, _LETTER = 17.0, 5.0, 6.9
"""Pixels of a row of labels under the plane, from the plane to the first, and of a letter."""

_ROWS = 2

_PARTICLE, _LARGE = 0.085, 200.0
"""Radii by which a particle at the plane reaches below it, and pixels of the largest radius."""


@dataclass(frozen=True)
class View:
    """Limits of axes, and pixels for a radius either way."""

    left: float
    right: float
    bottom: float
    top: float
    across: float
    upwards: float

    @property
    def is_round(self) -> bool:
        """Whether both axes have one scale."""
        return self.across == self.upwards

    @property
    def stretch(self) -> float:
        """How much larger heights are drawn."""
        return self.upwards / self.across


class Ground:
    """What a path takes of the plane."""

    def __init__(self, motion: MotionLike, samples: Samples) -> None:
        slope = motion.hoop.slope
        self.is_tilted = slope != 0.0
        centre, _ = level(slope, samples.x, samples.centre_y)
        self.left, self.right = float(np.min(centre)) - 1.2, float(np.max(centre)) + 1.2
        self.bottom, highest = seen_heights(samples, slope)
        self.top = highest + 1.15

    def height(self, width: float) -> float:
        """Return how high axes of a width are best, in pixels."""
        rows = _ROWS * _ROW + _BEGIN + _PARTICLE * min(width / (self.right - self.left), _LARGE)
        wanted = width / (self.right - self.left) * (self.top - self.bottom) + rows
        most = _HIGHEST * width if width > 600.0 else 0.9 * width
        return min(max(wanted, _LOWEST), most)

    def view(self, axes: Axes) -> View:
        """Return the limits of axes: all of the path, and the rows of labels under it."""
        box = axes.get_window_extent()
        pixel = axes.figure.dpi / 72.0 * scaled(0.75)
        width, height = box.width / pixel, box.height / pixel
        across = width / (self.right - self.left)
        rows = min(_ROWS * _ROW + _BEGIN + _PARTICLE * min(across, _LARGE), 0.5 * height)
        upwards = (height - rows) / (self.top - self.bottom)
        one = min(across, upwards)
        # A slope has its angle, and a hoop that can be seen is round.
        is_alike = _EMPTY * across <= upwards <= 1.5 * across
        if self.is_tilted or one >= _SMALLEST or is_alike:
            across = upwards = one
        middle, half = 0.5 * (self.left + self.right), 0.5 * width / across
        bottom = self.bottom - rows / upwards
        return View(
            middle - half, middle + half, bottom, bottom + height / upwards, across, upwards
        )


def mark_events(motion: MotionLike, samples: Samples, axes: Axes, view: View) -> str:
    """Draw the hoop at the start and at events and name these; say how many have a name.

    A name that finds no room is left out.
    """
    # Bounces give way to what happens else.
    events = sorted(
        (one for one in motion.transitions if one.time <= samples.time[-1]),
        key=lambda one: (one.cause, one.to_mode) == ("landing", "flight"),
    )
    marks = [(motion.start.time, "start")]
    marks += [(one.time, CAUSE_LABELS[one.cause]) for one in events]
    marks.append((float(samples.time[-1]), ""))
    slope = motion.hoop.slope
    taken: list[tuple[float, float, float, float]] = []
    hoops: list[tuple[float, float]] = []
    named = 0
    for time, label in marks:
        at = int(np.argmin(np.abs(samples.time - time)))
        x, y = float(samples.x[at]), float(samples.centre_y[at])
        place = level(slope, x, y)
        is_free = all(math.dist(place, other) > 0.3 for other in hoops)
        if view.is_round and is_free:
            hoops.append(place)
            draw_hoop(axes, motion.hoop, x, y, float(samples.theta[at]), alpha=0.75)
        if label:
            named += _name(axes, label, level(slope, x, 0.0), slope, view, taken)
    every = len(events) + 1
    return "" if named == every else f"{named - 1} of {every - 1} events named"


def _name(
    axes: Axes,
    label: str,
    foot: tuple[float, float],
    slope: float,
    view: View,
    taken: list[tuple[float, float, float, float]],
) -> bool:
    """Write a label under the plane where it covers no other, or not at all."""
    size = _LETTER * len(label)
    x = (foot[0] - view.left) * view.across
    y = (foot[1] - view.bottom) * view.upwards
    # On a slope labels stand at the side where the plane rises.
    begin = x - 0.5 * size if slope == 0.0 else x + 5.0 if slope > 0.0 else x - 5.0 - size
    width = (view.right - view.left) * view.across
    begin = min(max(begin, 2.0), width - size - 2.0)
    for row in range(_ROWS):
        top = y - _BEGIN - _PARTICLE * min(view.across, _LARGE) * view.is_round - _ROW * row
        box = (begin - 4.0, begin + size + 4.0, top - _ROW, top)
        meets = any(
            box[0] < one[1] and one[0] < box[1] and box[2] < one[3] and one[2] < box[3]
            for one in taken
        )
        if meets or box[2] < -1.0:
            continue
        taken.append(box)
        options: dict[str, Any] = {"ha": "center", "va": "top", "color": INK}
        axes.text(
            view.left + (begin + 0.5 * size) / view.across,
            view.bottom + top / view.upwards,
            label,
            **options,
        )
        return True
    return False
