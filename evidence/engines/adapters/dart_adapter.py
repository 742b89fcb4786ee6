"""DART (dartpy): a sphere on a large box.

It is on a planar joint at the geometric centre, off which the mass centre is.

engine: DART
contact: rigid
settings: default careful
requires: dartpy==6.20.0 numpy==2.4.6
limits: friction=least force=1.00,+0 rolling=none rolling_small=none rolling_slow=none
limits default: bounce=0.3
limits careful: radius=10
docs: https://dartsim.github.io/

default: as the package comes: Dantzig's method, which bounds friction by the normal force that
there would be without it, although the friction of a hoop presses it to the plane, or lifts it.
careful: the solver NSGS, to 1e-10 or 1000 sweeps, and R is 10 m, for the sake of restitution at low
speeds.
Cannot express: mu_s and mu_k (one coefficient, the same for both shapes; restitution is the product
of theirs). A hoop does not bounce if it were slower than 0.1 m/s after it: 0.1 sqrt(gR) by default,
0.01 sqrt(gR) in the careful setting.
"""

import dartpy as dart
import numpy as np
from adapter import main, stepped

RADII = {"default": None, "careful": 10.0}
THICK = 10.0


def shaped(body, shape, friction, restitution):
    """Give a body a shape."""
    node = body.createShapeNode(shape)
    node.createCollisionAspect()
    surface = node.createDynamicsAspect()
    surface.setFrictionCoeff(friction)
    surface.setRestitutionCoeff(restitution)
    return node


def simulate(case, step, setting):
    """Yield rows."""
    radius, mu = RADII[setting] or case.radius, case.one_coefficient()
    size = radius / case.radius
    world = dart.simulation.World()
    along, away = case.gravity
    world.setGravity([along * size, 0.0, away * size])
    world.setTimeStep(step)
    if setting == "careful":
        options = dart.constraint.NsgsFrictionSolver.Options()
        options.tolerance, options.maxSweeps = 1e-10, 1000
        world.getConstraintSolver().setBoxedLcpSolver(dart.constraint.NsgsFrictionSolver(options))
    plane = dart.dynamics.Skeleton("plane")
    _, ground = plane.createWeldJointAndBodyNodePair()
    box = shaped(
        ground,
        dart.dynamics.BoxShape([200.0 * radius, 200.0 * radius, THICK * radius]),
        case.friction_of_plane(mu),
        1.0,
    )
    box.setRelativeTranslation([0.0, 0.0, -0.5 * THICK * radius])
    hoop = dart.dynamics.Skeleton("hoop")
    joint, body = hoop.createPlanarJointAndBodyNodePair()
    # Its coordinates are z, x and the angle about y, which is clockwise where x is to the right and
    # z upwards.
    joint.setZXPlane()
    shaped(body, dart.dynamics.SphereShape(radius), mu, case.restitution)
    centre = np.array([0.0, 0.0, case.h * size])
    body.setInertia(dart.dynamics.Inertia(case.mass, centre, case.inertia * size**2 * np.eye(3)))
    world.addSkeleton(plane)
    world.addSkeleton(hoop)
    hoop.setPositions([radius, 0.0, -case.theta])
    hoop.setVelocities([case.gap_rate * size, case.x_rate * size, -case.theta_rate])

    def row(time):
        height, x, turned = hoop.getPositions()
        rise, along, turning = hoop.getVelocities()
        there = (time, x / size, height / size, -turned, along / size, rise / size, -turning)
        return case.forced(there, force)

    def force():
        contacts = world.getLastCollisionResult().getContacts()
        return sum(abs(contact.force[2]) for contact in contacts) / size

    yield from stepped(case, step, world.step, row)


if __name__ == "__main__":
    main(simulate)
