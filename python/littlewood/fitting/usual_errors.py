"""Usual errors of what is weighed and measured, where nobody says how well it is known."""

from __future__ import annotations

import math
from collections.abc import Mapping

__all__ = ["IN_PARTS", "USUAL_ERRORS", "in_units"]

IN_PARTS = ("mass_ratio", "offset", "inertia", "mu_s", "mu_k", "restitution")
"""What is known as a part of its value."""

USUAL_ERRORS: Mapping[str, float] = {
    **dict.fromkeys(("mu_s", "mu_k", "restitution"), 0.1),
    "inertia": 0.03,
    "mass_ratio": 0.02,
    "offset": 0.01,
    "slope": math.radians(0.5),
    "clock": 0.01,
    "rolling_resistance": 0.005,
    "camera_scale": 0.01,
    "camera_turn": math.radians(0.5),
    "camera_marker": math.radians(1.0),
}
"""Standard errors of what is held where nobody says how well it is known: of kitchen scales, a
ruler, a water level, and the rate that a telephone says."""


def in_units(name: str, error: float, value: float) -> float:
    """Return an error in the unit of what has it."""
    return error * abs(value) if name in IN_PARTS else error
