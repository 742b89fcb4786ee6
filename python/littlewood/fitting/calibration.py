"""Constant errors of a camera."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any

import numpy as np

from .._internal.elementwise import Reals

__all__ = ["CALIBRATION", "checked", "determined", "shown"]

# Displacement (δx, δy) of a point, and the rows of its derivatives by x and y.
_Shift = Callable[[Reals, Reals], tuple[tuple[Any, Any], tuple[tuple[Any, Any], tuple[Any, Any]]]]


def _linear(xx: float, xy: float, yx: float, yy: float) -> _Shift:
    """Return the displacement by a matrix."""
    return lambda x, y: ((xx * x + xy * y, yx * x + yy * y), ((xx, xy), (yx, yy)))


# To first order these are the errors of a homography: but for a shift along x, which is one of the
# start.
_SHIFTS: dict[str, _Shift] = {
    "floor": lambda x, y: ((0.0, 1.0), ((0.0, 0.0), (0.0, 0.0))),
    "turn": _linear(0.0, -1.0, 1.0, 0.0),
    "scale": _linear(1.0, 0.0, 0.0, 1.0),
    "stretch": _linear(1.0, 0.0, 0.0, -1.0),
    "shear": _linear(0.0, 1.0, 1.0, 0.0),
    "perspective_x": lambda x, y: ((x * x, x * y), ((2.0 * x, 0.0), (y, x))),
    "perspective_y": lambda x, y: ((x * y, y * y), ((y, x), (0.0, 2.0 * y))),
}

_OF_ANGLE: dict[str, Callable[[Reals], Any]] = {
    "marker": lambda theta: 1.0,
    # The centre that was found against the marker: what moves the centre alone, or the marker by
    # its parallax.
    "middle_x": np.cos,
    "middle_y": np.sin,
}

# What shifts heights alone.
_OF_HEIGHT = {"floor"}

CALIBRATION = (*_SHIFTS, *_OF_ANGLE, "exposure")
"""Names of what a camera may show wrong in every frame alike."""


def determined(names: Iterable[str], channels: Iterable[str]) -> tuple[str, ...]:
    """Return those of some constants that some channels determine."""
    channels = set(channels)
    told = {"exposure"}
    if "x" in channels:
        told |= set(_SHIFTS) if "y" in channels else set(_SHIFTS) - _OF_HEIGHT
    if channels > {"theta"}:
        told |= set(_OF_ANGLE)
    return tuple(name for name in CALIBRATION if name in names and name in told)


def checked(names: Iterable[str], channels: Iterable[str]) -> tuple[str, ...]:
    """Return the names of a calibration in order.

    Refuse unknown ones, and those that the channels do not determine.
    """
    names, channels = tuple(names), tuple(channels)
    unknown = [name for name in names if name not in CALIBRATION]
    if unknown:
        raise ValueError(
            f"calibration has {', '.join(unknown)}; it can have {', '.join(CALIBRATION)}"
        )
    found = determined(names, channels)
    missing = [name for name in names if name not in found]
    if missing:
        there = ", ".join(channels)
        can = ", ".join(determined(CALIBRATION, channels))
        raise ValueError(
            f"calibration has {', '.join(missing)}, which {there} do not determine; they determine "
            f"{can}"
        )
    return found


def shown(means: Mapping[str, Reals], constants: Mapping[str, float]) -> dict[str, Reals]:
    """Return θ, x and y as a camera with these errors shows them; the exposure is in the means."""
    if not any(constants.values()):
        return dict(means)
    theta, x, y = means["theta"], means["x"], means["y"]
    turned, along, up = np.zeros_like(theta), 0.0, 0.0
    for name, wave in _OF_ANGLE.items():
        turned += constants.get(name, 0.0) * wave(theta)
    sine, cosine = np.sin(theta), np.cos(theta)
    for name, shift in _SHIFTS.items():
        size = constants.get(name, 0.0)
        if size != 0.0:
            (x_too, y_too), ((xx, xy), (yx, yy)) = shift(x, y)
            along, up = along + size * x_too, up + size * y_too
            # The particle is at (−sin θ, cos θ) from the centre: what displaces it across turns it.
            turned += size * (cosine * (xx * sine - xy * cosine) + sine * (yx * sine - yy * cosine))
    return {"theta": theta + turned, "x": x + along, "y": y + up}
