"""PhysX 5, as SAPIEN has it (on the processor): a sphere on a plane.

Its mass centre is off its centre.

The motion stays plane by symmetry.

engine: PhysX (SAPIEN)
contact: rigid
settings: default careful
requires: certifi==2026.10.19.post1 charset-normalizer==3.5.3 idna==3.20 importlib_resources==7.1.0
  lxml==6.1.3 networkx==3.6.1 numpy==2.4.6 opencv-python==5.0.0.93 pyperclip==1.11.0
  requests==2.34.2 sapien==3.0.3 setuptools==65.5.0 transforms3d==0.4.2 urllib3==2.8.0
limits: own_turn=100 turn=1e+03 friction=mean force=1.00,+0 rolling=none rolling_small=none
  rolling_slow=none
limits default: damping=0,0.049 bounce=3
limits careful: damping=0,0.05
docs: https://nvidia-omniverse.github.io/PhysX/physx/5.1.0/docs/RigidBodyDynamics.html

default: as the package comes: the solver TGS, 10 position and 1 velocity iterations, restitution
above 2 m/s.
careful: 100 position iterations, restitution above 1e-4 m/s.
Can express: mu_s and mu_k. Restitution acts above a speed. Everything is in single precision.
"""

import math
import warnings

from adapter import main, stepped

warnings.filterwarnings("ignore", message="Failed to find system libvulkan")

import sapien  # noqa: E402
from sapien import physx  # noqa: E402


def turned(angle):
    """The quaternion of an angle about the y axis, from x to z."""
    return [math.cos(angle / 2), 0.0, -math.sin(angle / 2), 0.0]


def simulate(case, step, setting):
    """Yield rows."""
    config = physx.get_scene_config()
    config.gravity = [case.gravity[0], 0.0, case.gravity[1]]
    if setting == "careful":
        config.bounce_threshold = 1e-4
    physx.set_scene_config(config)
    scene = sapien.Scene([physx.PhysxCpuSystem()])
    scene.set_timestep(step)
    material = physx.PhysxMaterial(case.mu_s, case.mu_k, case.restitution)
    other = case.friction_of_plane(case.mu_k)
    ground = material
    if other != case.mu_k:
        ground = physx.PhysxMaterial(other, other, case.restitution)
    # The normal of its planes is along x.
    floor = sapien.Pose([0, 0, 0], [math.sqrt(0.5), 0.0, -math.sqrt(0.5), 0.0])
    for shape, component in (
        (physx.PhysxCollisionShapePlane(ground), physx.PhysxRigidStaticComponent()),
        (
            physx.PhysxCollisionShapeSphere(case.radius, material),
            physx.PhysxRigidDynamicComponent(),
        ),
    ):
        if isinstance(component, physx.PhysxRigidStaticComponent):
            shape.local_pose = floor
        component.attach(shape)
        entity = sapien.Entity()
        entity.add_component(component)
        if isinstance(component, physx.PhysxRigidDynamicComponent):
            entity.set_pose(sapien.Pose([0, 0, case.radius], turned(case.theta)))
            body = component
        scene.add_entity(entity)
    body.mass = case.mass
    body.inertia = [case.inertia] * 3
    body.cmass_local_pose = sapien.Pose([0, 0, case.h])
    if not case.is_untouched:
        body.linear_damping = body.angular_damping = 0.0
        body.sleep_threshold = 0.0
        body.max_angular_velocity = 1e3
    if setting == "careful":
        body.solver_position_iterations = 100
    vx, vz = case.mass_centre_rates()
    body.linear_velocity = [vx, 0.0, vz]
    body.angular_velocity = [0.0, -case.theta_rate, 0.0]
    turns = case.theta

    def row(time):
        nonlocal turns
        pose = body.entity.pose
        # A quaternion knows an angle up to whole turns.
        angle = 2.0 * math.atan2(-pose.q[2], pose.q[0])
        turns += math.remainder(angle - turns, math.tau)
        (vx, _, vy), (_, turning, _) = body.linear_velocity, body.angular_velocity
        rates = case.centre_rates(turns, float(vx), float(vy), -float(turning))
        there = (time, float(pose.p[0]), float(pose.p[2]), turns, *rates)
        return case.forced(there, force)

    def force():
        points = (point for contact in scene.get_contacts() for point in contact.points)
        return sum(abs(float(point.impulse[2])) for point in points) / step

    yield from stepped(case, step, scene.step, row)


if __name__ == "__main__":
    main(simulate)
