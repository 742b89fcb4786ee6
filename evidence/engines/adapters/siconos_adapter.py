"""Siconos (Moreau-Jean time stepping): a body of three coordinates at its mass centre.

Impacts are Newton's, with friction.

engine: Siconos
contact: rigid
settings: default careful
requires: debian:python3-siconos==4.4.0
docs: https://nonsmooth.gricad-pages.univ-grenoble-alpes.fr/siconos/

The relation between coordinates, gap and slip is linear and is made anew at each step: in Siconos
4.4 a relation whose Jacobian Python computes ends in a segmentation fault.
default: theta = 1/2, the solver of plane friction that Siconos chooses.
careful: the same, with the directions of gap and slip of the middle of the step, and friction
solved by enumeration.
Cannot express: mu_s and mu_k (one coefficient). Restitution is Newton's, at any speed.
"""

import math

import numpy as np
import siconos.kernel as kernel
import siconos.numerics as numerics
from adapter import main, stepped

SOLVER = {"default": [], "careful": [numerics.SICONOS_FRICTION_2D_ENUM]}
AHEAD = {"default": 0.0, "careful": 0.5}
"""Where in a step the directions are taken."""


def simulate(case, step, setting):
    """Yield rows."""
    h = case.h
    (x, y), (vx, vy) = case.mass_centre(), case.mass_centre_rates()
    start = np.array([x, y, case.theta]), np.array([vx, vy, case.theta_rate])
    inertia, weight = (
        np.diag([case.mass, case.mass, case.inertia]),
        case.mass * np.array([*case.gravity, 0.0]),
    )
    body = kernel.LagrangianLinearTIDS(*start, inertia)
    body.setFExtPtr(weight)

    def contact():
        """Rows and constants of gap and slip."""
        _, _, theta = body.q()
        ahead = theta + AHEAD[setting] * step * body.velocity()[2]
        c, s = h * math.cos(ahead), h * math.sin(ahead)
        # The constant is that with which the gap is right where the body is.
        return np.array([[0.0, 1.0, s], [1.0, 0.0, case.radius + c]]), np.array(
            [-h * math.cos(theta) - case.radius - s * theta, 0.0]
        )

    relation = kernel.LagrangianLinearTIR(*contact())
    law = kernel.NewtonImpactFrictionNSL(case.restitution, 0.0, case.one_coefficient(), 2)
    interaction = kernel.Interaction(law, relation)
    system = kernel.NonSmoothDynamicalSystem(0.0, 2.0 * case.until)
    system.insertDynamicalSystem(body)
    system.link(interaction, body)
    friction = kernel.FrictionContact(2, *SOLVER[setting])
    scheme = kernel.TimeStepping(
        system, kernel.TimeDiscretisation(0.0, step), kernel.MoreauJeanOSI(0.5), friction
    )

    def advance():
        rows, constants = contact()
        relation.setCPtr(rows)
        relation.setEPtr(constants)
        scheme.computeOneStep()
        scheme.nextStep()

    yield from stepped(
        case, step, advance, lambda time: case.row(time, *body.q(), *body.velocity())
    )


if __name__ == "__main__":
    main(simulate)
