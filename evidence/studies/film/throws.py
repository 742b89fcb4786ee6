"""Random hoops of a school laboratory, thrown so that a film tells all four coefficients."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import littlewood as lw
import numpy as np

FREE = ("mu_s", "mu_k", "inertia", "restitution")
SECONDS = 1.0


@dataclass(frozen=True)
class Throw:
    """A hoop in motion before a camera.

    Parameters
    ----------
    motion : Trajectory
        The exact motion.
    slips : bool
        Whether it starts with a slip.
    """

    motion: lw.Trajectory
    slips: bool

    @property
    def hoop(self) -> lw.Hoop:
        """The hoop with its true coefficients."""
        return self.motion.hoop

    @property
    def start(self) -> dict[str, float]:
        """The true start."""
        start = self.motion.start
        return {
            "theta": start.theta,
            "theta_rate": start.theta_rate,
            "slip": start.slip,
            "x": start.x,
        }

    @property
    def guess(self) -> lw.Hoop:
        """The hoop as its builder knows it: weighed and measured, with a thin rim's inertia."""
        inertia = 0.95 * self.hoop.mass_ratio
        return replace(
            self.hoop, mu_s=0.5, mu_k=0.3, inertia=inertia, restitution=None, restitution_law=None
        )


def throw(random: np.random.Generator) -> Throw:
    """Draw throws until one rolls, slips out of rolling, lifts off and lands twice.

    Within a second and twelve radii.
    """
    while True:
        ratio, mu_k = random.uniform(0.5, 2.0), random.uniform(0.2, 0.6)
        hoop = lw.Hoop.from_si(
            disc_mass_kg=0.25 * ratio,
            particle_mass_kg=0.25,
            radius_m=0.3,
            offset_m=random.uniform(0.25, 0.28),
            inertia_kg_m2=0.25 * ratio * 0.3**2 * random.uniform(0.85, 1.0),
            mu_s=mu_k * random.uniform(1.1, 1.5),
            mu_k=mu_k,
            restitution=random.uniform(0.2, 0.7),
        )
        slip = random.choice([0.0, random.uniform(-2.0, 2.0)])
        rate = random.uniform(0.5, 3.0) * random.choice([-1.0, 1.0])
        end = (SECONDS + 0.01) / hoop.require_units().time_s
        motion = hoop.simulate(
            theta=random.uniform(-math.pi, math.pi), theta_rate=rate, slip=slip, until=end
        )
        slid = any(transition.cause == "slip" for transition in motion.transitions)
        landed = sum(transition.impact is not None for transition in motion.transitions)
        if slid and landed >= 2 and motion.end_time >= end and abs(motion(end).x) < 12.0:
            return Throw(motion, slip != 0.0)
