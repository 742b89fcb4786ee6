"""Names, units and attributes of sweeps: those of the Zarr stores of the command line."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from . import _core

HOOP = ("mass_ratio", "offset", "inertia", "mu_s", "mu_k")
START = ("theta", "theta_rate", "slip")

QUANTITIES: Mapping[str, tuple[str, str]] = {
    "theta": ("angle of the particle from the upward vertical", "rad"),
    "theta_rate": ("rate of the angle", "sqrt(g/R)"),
    "slip": ("slip velocity of the contact point", "sqrt(g R)"),
    "mass_ratio": ("mass of the disc over mass of the particle", "1"),
    "offset": ("distance of the particle from the centre over the radius", "1"),
    "inertia": ("moment of inertia of the disc over m2 R^2", "1"),
    "mu_s": ("coefficient of static friction", "1"),
    "mu_k": ("coefficient of kinetic friction", "1"),
}
"""Long names and units of what a sweep can vary."""

OUTCOME_CODES: Mapping[str, int] = {
    **{name: code for code, name in enumerate(_core.OUTCOMES)},
    "not_computed": 254,
    "invalid": _core.INVALID,
}
"""Codes of the outcomes in arrays."""

SEQUENCE_LEGEND: Mapping[str, str] = {
    "0": "end of the sequence",
    "1": "R: rolling",
    "2": "-: sliding with negative slip velocity",
    "3": "+: sliding with positive slip velocity",
    "4": "n: gliding with negative slip velocity",
    "5": "g: gliding with positive slip velocity",
    "6": "G: gliding without slip",
    "7": "F: flight",
}

DTYPE = np.dtype(
    [
        ("outcome", np.uint8),
        ("sequence", np.uint64),
        ("transitions", np.uint32),
        ("painleve", np.uint8),
        ("end_time", np.float64),
        ("end_theta", np.float64),
        ("end_theta_rate", np.float64),
        ("end_slip", np.float64),
        ("end_x", np.float64),
        ("energy", np.float64),
        ("first_slip_time", np.float64),
        ("lift_off_time", np.float64),
        ("jump_length", np.float64),
        ("jump_height", np.float64),
    ]
)
"""A result, as one record."""

RESULTS: tuple[str, ...] = DTYPE.names or ()
"""Names of the variables of a result."""

_REALS: Mapping[str, tuple[str, str]] = {
    "end_time": ("time at the end, or where the phase begins that lasts for ever", "sqrt(R/g)"),
    "end_theta": ("angle at the end", "rad"),
    "end_theta_rate": ("rate of the angle at the end", "sqrt(g/R)"),
    "end_slip": ("slip velocity at the end", "sqrt(g R)"),
    "end_x": ("position of the geometric centre at the end", "R"),
    "energy": ("energy at the end", "m2 g R"),
    "first_slip_time": ("time of the first slip out of rolling", "sqrt(R/g)"),
    "lift_off_time": ("time of lift-off", "sqrt(R/g)"),
    "jump_length": ("length of the jump", "R"),
    "jump_height": ("height of the jump", "R"),
}


def quantity_attributes(name: str) -> dict[str, Any]:
    """Return the attributes of a coordinate."""
    long_name, unit = QUANTITIES[name]
    return {"long_name": long_name, "units": unit}


def result_attributes(name: str) -> dict[str, Any]:
    """Return the attributes of a variable of the result."""
    if name == "outcome":
        # Lists of plain numbers: a store holds them, as the command line writes them.
        return {
            "long_name": "outcome",
            "flag_values": list(OUTCOME_CODES.values()),
            "flag_meanings": " ".join(OUTCOME_CODES),
        }
    if name == "sequence":
        return {
            "long_name": "sequence of phases",
            "encoding": "3 bits a phase, the first phase lowest, up to 20 phases; bit 63 is set if there are more",
            "legend": dict(SEQUENCE_LEGEND),
        }
    if name == "transitions":
        return {"long_name": "number of transitions", "units": "1"}
    if name == "painleve":
        return {
            "long_name": "whether the motion met a Painlevé paradox",
            "flag_values": [0, 1],
            "flag_meanings": "no yes",
        }
    long_name, unit = _REALS[name]
    return {"long_name": long_name, "units": unit}
