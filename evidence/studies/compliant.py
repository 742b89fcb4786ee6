"""A hoop on a plane that yields: a spring and a damper in place of the rigid contact.

Nothing here decides on a mode: the force of the plane, Coulomb's force and the couple are functions
of the state, and a stiff integrator follows them.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt
from scipy.integrate import solve_ivp

Array = npt.NDArray[np.float64]

SMOOTH = 0.05
"""Velocities, times the root of the stiffness, within which Coulomb's laws are smoothed."""


@dataclass(frozen=True, kw_only=True)
class Yielding:
    """A level hoop on a spring of the stiffness k, with the damping ζ of its critical one."""

    mass: float
    h: float
    inertia: float
    mu: float
    chi: float
    stiffness: float
    damping: float

    def change(self, _time: float, state: Array) -> list[float]:
        """Return the rates of gap, its rate, θ, θ′, η′, impulses of N and F, and loss."""
        gap, gap_rate, theta, rate, slip = state[:5]
        drag = 2.0 * self.damping * math.sqrt(self.stiffness * self.mass)
        normal = max(0.0, -self.stiffness * gap - drag * gap_rate)
        small = SMOOTH / math.sqrt(self.stiffness)
        friction = -self.mu * normal * math.tanh(slip / small)
        couple = -self.chi * normal * math.tanh(rate / small)
        s, c = math.sin(theta), math.cos(theta)
        arm, lever = self.h * s, 1.0 + self.h * c
        turn = (arm * normal + lever * friction + couple) / self.inertia
        return [
            gap_rate,
            normal / self.mass - 1.0 + self.h * c * rate * rate + arm * turn,
            rate,
            turn,
            friction / self.mass + lever * turn - arm * rate * rate,
            normal,
            friction,
            -couple * rate,
        ]

    def jam(self, theta: float, rate: float) -> Array:
        """Return the states from closed contact without slip to the greatest depth."""

        def deepest(_time: float, state: Array) -> float:
            return float(state[1])

        event: Any = deepest
        event.direction, event.terminal = 1.0, True
        # The plane bears a thousandth of a unit of force: the side to which the contact closes.
        begin = [-1e-3 / self.stiffness, 0.0, theta, rate, 0.0, 0.0, 0.0, 0.0]
        found = solve_ivp(
            self.change,
            (0.0, 400.0 / math.sqrt(self.stiffness)),
            begin,
            method="Radau",
            rtol=1e-9,
            atol=1e-13,
            events=event,
        )
        if found.status != 1:
            raise ValueError("the contact does not open again")
        result: Array = found.y
        return result
