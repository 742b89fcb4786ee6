"""A hoop on soft ground, which resists rolling, by an integrator of its own.

The simulation has no such ground.
"""

from __future__ import annotations

import math

import littlewood as lw
import numpy as np
import numpy.typing as npt

Reals = npt.NDArray[np.float64]

STEP = 2e-4
"""Step of the fourth-order scheme, √(R/g)."""


def rolling_on_soft_ground(
    hoop: lw.Hoop, start: dict[str, float], time: Reals, arm: float
) -> tuple[Reals, Reals]:
    """Return θ and x at the given times, up to the instant at which the ground no longer presses.

    Balances of momentum of the whole body about its mass centre, with the normal force shifted
    forward by `arm` (R):

    m x̄″ = F, m ȳ″ = N − m, Î θ″ = N h sin θ + F (1 + h cos θ) − arm N sign(θ′).

    Parameters
    ----------
    hoop : Hoop
        The hoop.
    start : dict
        `theta`, `theta_rate`, `slip`, `x`.
    time : ndarray
        Times, from that of the start.
    arm : float
        Coefficient of rolling resistance, R.
    """
    mass, h, about_centre = hoop.mass, hoop.h, hoop.inertia_about_mass_centre

    def forces(state: Reals, sliding: float) -> tuple[float, float, float, float]:
        """Return θ″, x″, N, F."""
        theta, rate = state[0], state[1]
        sin, cos = math.sin(theta), math.cos(theta)
        turn = -arm * math.copysign(1.0, rate) if rate != 0.0 else 0.0
        # Unknowns θ″, x″, N, F.
        rows = np.array(
            [
                [about_centre, 0.0, -(h * sin + turn), -(1.0 + h * cos)],
                [-mass * h * cos, mass, 0.0, -1.0],
                [mass * h * sin, 0.0, 1.0, 0.0],
                [0.0, 0.0, hoop.mu_k * sliding, 1.0] if sliding else [1.0, 1.0, 0.0, 0.0],
            ]
        )
        right = np.array([0.0, -mass * h * sin * rate**2, mass - mass * h * cos * rate**2, 0.0])
        found = np.linalg.solve(rows, right)
        return float(found[0]), float(found[1]), float(found[2]), float(found[3])

    def rates(state: Reals, sliding: float) -> Reals:
        turning, moving, _, _ = forces(state, sliding)
        return np.array([state[1], turning, state[3], moving])

    state = np.array(
        [start["theta"], start["theta_rate"], start["x"], start["slip"] - start["theta_rate"]]
    )
    sliding = math.copysign(1.0, start["slip"]) if start["slip"] else 0.0
    found, now, at = [], float(time[0]), 0
    while at < time.size:
        _, _, normal, friction = forces(state, sliding)
        if normal <= 0.0:
            break
        if not sliding and abs(friction) > hoop.mu_s * normal:
            sliding = -math.copysign(1.0, friction)
        while at < time.size and time[at] < now + 0.5 * STEP:
            found.append(
                (state[0] + state[1] * (time[at] - now), state[2] + state[3] * (time[at] - now))
            )
            at += 1
        one = rates(state, sliding)
        two = rates(state + 0.5 * STEP * one, sliding)
        three = rates(state + 0.5 * STEP * two, sliding)
        four = rates(state + STEP * three, sliding)
        state = state + STEP / 6.0 * (one + 2.0 * two + 2.0 * three + four)
        now += STEP
        if sliding and sliding * (state[1] + state[3]) < 0.0:
            # It sticks if static friction can hold it, or slides back.
            state[3] = -state[1]
            _, _, normal, friction = forces(state, 0.0)
            sliding = 0.0 if abs(friction) <= hoop.mu_s * normal else -math.copysign(1.0, friction)
    theta, x = np.array(found).reshape(-1, 2).T
    return theta, x
