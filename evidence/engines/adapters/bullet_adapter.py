"""Bullet (pybullet): a sphere on a plane, its inertial frame off the geometric centre.

engine: Bullet
contact: rigid
settings: default careful
requires: numpy==2.4.6 pybullet==3.2.7
rolling: separate limits; its coefficient, a length, is χ R, times the friction of the plane.
limits: own_turn=100 turn=100 own_speed=100 speed=100 damping=0.084,0.078 friction=product
  rolling=1 rolling_small=1 rolling_slow=1
limits default: bounce=never force=0.00,+0
limits careful: force=1.00,+0
docs: https://pybullet.org/

The motion stays plane by symmetry.
default: as the package comes, but for damping and rolling friction, which are none.
careful: 1000 iterations of the solver, to a residual of 0, no slop, restitution at any speed. A
hoop that bounces has no contact before it touches, as that would brake it and leave nothing to
restore, and no overlap is corrected, as the correction would be added to the bounce.
Cannot express: mu_s and mu_k (one coefficient, the product of those of two bodies: the plane has 1;
so is that of restitution). Restitution acts above a speed, by default 0.2 m/s.
"""

import math

import pybullet as bullet
from adapter import main, stepped


def simulate(case, step, setting):
    """Yield rows."""
    bullet.connect(bullet.DIRECT)
    bullet.setGravity(case.gravity[0], 0.0, case.gravity[1])
    bullet.setPhysicsEngineParameter(fixedTimeStep=step, numSubSteps=0)
    if setting == "careful":
        bullet.setPhysicsEngineParameter(
            numSolverIterations=1000,
            solverResidualThreshold=0.0,
            contactSlop=0.0,
            restitutionVelocityThreshold=0.0,
        )
    plane = bullet.createMultiBody(0.0, bullet.createCollisionShape(bullet.GEOM_PLANE))
    bullet.changeDynamics(plane, -1, lateralFriction=case.friction_of_plane(1.0), restitution=1.0)
    hoop = bullet.createMultiBody(
        case.mass,
        bullet.createCollisionShape(bullet.GEOM_SPHERE, radius=case.radius),
        baseInertialFramePosition=(0.0, 0.0, case.h),
    )
    bullet.changeDynamics(
        hoop,
        -1,
        lateralFriction=case.one_coefficient(),
        rollingFriction=case.rolling_resistance,
        spinningFriction=0.0,
        restitution=case.restitution,
        localInertiaDiagonal=(case.inertia,) * 3,
    )
    if not case.is_untouched:
        awake = bullet.ACTIVATION_STATE_DISABLE_SLEEPING
        bullet.changeDynamics(hoop, -1, linearDamping=0.0, angularDamping=0.0)
        bullet.changeDynamics(hoop, -1, activationState=awake)
    if setting == "careful" and case.restitution > 0.0:
        bullet.setPhysicsEngineParameter(erp=0.0, contactERP=0.0)
        bullet.changeDynamics(hoop, -1, contactProcessingThreshold=0.0)
    # Counterclockwise, with x to the right and z upwards, is about -y. Bullet takes the place of
    # the mass centre.
    (x, y), (vx, vy) = case.mass_centre(), case.mass_centre_rates()
    turn = bullet.getQuaternionFromAxisAngle((0.0, -1.0, 0.0), case.theta)
    bullet.resetBasePositionAndOrientation(hoop, (x, 0.0, y), turn)
    bullet.resetBaseVelocity(hoop, (vx, 0.0, vy), (0.0, -case.theta_rate, 0.0))
    theta = case.theta

    def row(time):
        nonlocal theta
        (x, _, y), (_, b, _, d) = bullet.getBasePositionAndOrientation(hoop)
        turned = 2.0 * math.atan2(-b, d)
        theta += math.remainder(turned - theta, math.tau)
        (vx, _, vy), (_, turning, _) = bullet.getBaseVelocity(hoop)

        def force():
            return sum(contact[9] for contact in bullet.getContactPoints(hoop, plane))

        return case.forced(case.row(time, x, y, theta, vx, vy, -turning), force)

    yield from stepped(case, step, bullet.stepSimulation, row)


if __name__ == "__main__":
    main(simulate, has_rolling_friction=True)
