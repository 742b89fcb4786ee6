"""Nimble: DART made differentiable, a sphere on a box.

A slide is in the plane, and a hinge at its centre.

engine: Nimble
contact: rigid
settings: default
requires: cuda-bindings==13.5.0 cuda-pathfinder==1.9.1 cuda-toolkit==13.2.2 filelock==4.3.1
  fsspec==2026.9.0 Jinja2==3.1.6 MarkupSafe==3.0.4 mpmath==1.3.0 networkx==3.6.1
  nimblephysics==0.10.52.1 numpy==1.26.4 nvidia-cublas==13.4.1.3 nvidia-cuda-cccl==13.3.5.0.6
  nvidia-cuda-cupti==13.2.86 nvidia-cuda-nvrtc==13.2.86 nvidia-cuda-runtime==13.2.86
  nvidia-cudnn-cu13==9.26.0.51 nvidia-cufft==12.2.0.57 nvidia-cufile==1.17.1.22
  nvidia-cusolver==12.2.0.11 nvidia-cusparse==12.7.10.12 nvidia-cusparselt-cu13==0.8.1
  nvidia-nccl-cu13==2.30.7 nvidia-nvjitlink==13.5.37 nvidia-nvshmem-cu13==3.7.2 nvidia-nvtx==13.2.86
  sympy==1.14.0 torch==2.15.0 triton==3.9.0 typing_extensions==4.16.0
gradients: theta_rate slip
limits: bounce=0.3 friction=least force=1.00,+0 rolling=none rolling_small=none rolling_slow=none
docs: https://nimblephysics.org/docs/

default: as the package comes: friction cones as boxes, overlaps corrected by no more than it does
by itself.
Cannot express: mu_s and mu_k (one coefficient, the least of two bodies); rolling friction.
Restitution is the product of those of both bodies, above a speed. Its solver has absolute
constants: in the first case masses of 1 g instead of 1 kg make the error 0.15 R for 0.0045 R, and
with masses of 1000 t the hoop sinks into the plane. Derivatives are those of each step with respect
to its state, which the engine has in closed form, multiplied on. With a planar joint they are wrong
in flight already, and differ from differences of one of its own steps.
"""

import math

import nimblephysics as nimble
import numpy as np
from adapter import main, rows_of, stepped

THICK = 10.0
"""Of the box, in R."""
CARRIER = 1e-9
"""Of the body between the joints, the mass over that of the hoop."""


def shaped(body, shape, friction, restitution):
    """Give a body a shape."""
    node = body.createShapeNode(shape)
    node.createCollisionAspect()
    body.setFrictionCoeff(friction)
    body.setRestitutionCoeff(restitution)
    return node


def world_of(case, step):
    """A world with the hoop in the plane of x and y, its coordinates those of the mass centre."""
    world = nimble.simulation.World()
    world.setTimeStep(step)
    world.setGravity([*case.gravity, 0.0])
    floor = nimble.dynamics.Skeleton()
    joint, body = floor.createWeldJointAndBodyNodePair()
    place = nimble.math.Isometry3()
    place.set_translation([0.0, -0.5 * THICK * case.radius, 0.0])
    joint.setTransformFromParentBodyNode(place)
    mu, bounce = case.one_coefficient(), math.sqrt(case.restitution)
    box = nimble.dynamics.BoxShape([size * case.radius for size in (400.0, THICK, 20.0)])
    shaped(body, box, case.friction_of_plane(mu), bounce)
    world.addSkeleton(floor)
    hoop = nimble.dynamics.Skeleton()
    _, carrier = hoop.createTranslationalJoint2DAndBodyNodePair()
    light = CARRIER * case.mass
    carrier.setInertia(
        nimble.dynamics.Inertia(light, np.zeros(3), light * case.radius**2 * np.eye(3))
    )
    joint, body = hoop.createRevoluteJointAndBodyNodePair(carrier)
    joint.setAxis([0.0, 0.0, 1.0])
    body.setInertia(
        nimble.dynamics.Inertia(case.mass, np.array([0.0, case.h, 0.0]), case.inertia * np.eye(3))
    )
    shaped(body, nimble.dynamics.SphereShape(case.radius), mu, bounce)
    world.addSkeleton(hoop)
    world.setPositions([0.0, case.radius, case.theta])
    world.setVelocities([case.x_rate, case.gap_rate, case.theta_rate])
    return world


def simulate(case, step, _):
    """Yield rows."""
    world = world_of(case, step)

    def row(time):
        return case.forced((time, *world.getPositions(), *world.getVelocities()), force)

    def force():
        contacts = world.getLastCollisionResult().getContacts()
        return sum(abs(contact.force[1]) for contact in contacts)

    yield from stepped(case, step, world.step, row)


STARTS = {"slip": (1.0, 0.0, 0.0), "theta_rate": (-1.0, 0.0, 1.0)}
"""Derivatives of the rates at the start."""


def gradient(case, step, _):
    """Yield rows of derivatives."""
    world = world_of(case, step)
    state = np.array([0.0, 0.0, 0.0, *STARTS[case.gradient]])
    count, each = rows_of(case, step)
    yield 0.0, 0.0, 0.0
    for i in range(1, count * each + 1):
        snapshot = nimble.neural.forwardPass(world)
        parts = [
            [snapshot.getPosPosJacobian(world), snapshot.getVelPosJacobian(world)],
            [snapshot.getPosVelJacobian(world), snapshot.getVelVelJacobian(world)],
        ]
        state = np.block(parts) @ state
        if i % each == 0:
            yield i * step, state[0], state[2]


if __name__ == "__main__":
    main(simulate, gradient)
