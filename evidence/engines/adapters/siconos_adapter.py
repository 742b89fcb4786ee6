"""Siconos (Moreau-Jean time stepping): a body of three coordinates at its mass centre.

Impacts are Newton's, with friction.

engine: Siconos
contact: rigid
settings: default careful
requires: debian:python3-siconos==4.4.0
rolling: separate limits (NewtonImpactRollingFrictionNSL); its coefficient, a length, is χ R.
limits: friction=pair force=1.00,+0 rolling=1 rolling_small=1 rolling_slow=1
docs: https://nonsmooth.gricad-pages.univ-grenoble-alpes.fr/siconos/

The relation between coordinates, gap and slip is linear and is made anew at each step: in Siconos
4.4 a relation whose Jacobian Python computes ends in a segmentation fault.
default: theta = 1/2, the solver of plane friction that Siconos chooses.
careful: the same, with the directions of gap and slip of the middle of the step, and friction
solved by Lemke's method. (Its solver by enumeration, which stood here, takes patterns whose matrix
is singular but for rounding: its motions differ from one kernel of OpenBLAS to another.)
Cannot express: mu_s and mu_k (one coefficient). Restitution is Newton's, at any speed.
"""

import math

import numpy as np
import siconos.kernel as kernel
import siconos.numerics as numerics
from adapter import main, stepped

SOLVER = {"default": [], "careful": [numerics.SICONOS_FRICTION_2D_LEMKE]}
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
        """Rows and constants of gap, slip and, where it is resisted, rotation."""
        _, _, theta = body.q()
        ahead = theta + AHEAD[setting] * step * body.velocity()[2]
        c, s = h * math.cos(ahead), h * math.sin(ahead)
        rows = [[0.0, 1.0, s], [1.0, 0.0, case.radius + c], [0.0, 0.0, 1.0]]
        # The constant is that with which the gap is right where the body is.
        constants = [-h * math.cos(theta) - case.radius - s * theta, 0.0, 0.0]
        return np.array(rows[:directions]), np.array(constants[:directions])

    e, mu, chi = case.restitution, case.friction_of_pair(), case.rolling_resistance
    directions = 3 if chi > 0.0 else 2
    if chi > 0.0:
        law = kernel.NewtonImpactRollingFrictionNSL(e, 0.0, mu, chi, 3)
        friction = kernel.RollingFrictionContact(3, numerics.SICONOS_ROLLING_FRICTION_2D_NSGS)
    else:
        law = kernel.NewtonImpactFrictionNSL(e, 0.0, mu, 2)
        friction = kernel.FrictionContact(2, *SOLVER[setting])
    relation = kernel.LagrangianLinearTIR(*contact())
    interaction = kernel.Interaction(law, relation)
    system = kernel.NonSmoothDynamicalSystem(0.0, 2.0 * case.until)
    system.insertDynamicalSystem(body)
    system.link(interaction, body)
    scheme = kernel.TimeStepping(
        system, kernel.TimeDiscretisation(0.0, step), kernel.MoreauJeanOSI(0.5), friction
    )

    def advance():
        rows, constants = contact()
        relation.setCPtr(rows)
        relation.setEPtr(constants)
        scheme.computeOneStep()
        scheme.nextStep()

    def row(time):
        there = case.row(time, *body.q(), *body.velocity())
        return case.forced(there, lambda: interaction.lambda_(1)[0] / step)

    yield from stepped(case, step, advance, row)


if __name__ == "__main__":
    main(simulate, has_rolling_friction=True)
