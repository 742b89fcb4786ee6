"""Box2D 3.1 (pyb2d3): a body whose mass data are set.

It has a circle beside its mass centre, on a long segment.

engine: Box2D 3.1
contact: rigid
settings: default careful
requires: numpy==2.4.6 pyb2d3==0.11.1
rolling: separate limits; its coefficient is χ: it multiplies it by the radius of the circle.
limits: own_turn=0.785/step turn=0.785/step own_speed=400 sleep=0.01 friction=root force=none
  rolling=1 rolling_slow=1
limits default: bounce=1.05 rolling_small=0.096
limits careful: rolling_small=1.8
docs: https://box2d.org/documentation/

default: as the package comes: 4 sub-steps, restitution above 1 m/s.
careful: contacts of 240 Hz instead of 30, restitution above 1e-4 m/s.
Cannot express: mu_s and mu_k (one coefficient; that of two shapes is the root of the product of
theirs). Everything is in single precision. pyb2d3 has no forces of contacts.
"""

import math

import pyb2d3 as b2
from adapter import main, stepped

SUB_STEPS = 4


def simulate(case, step, setting):
    """Yield rows."""
    mu = case.one_coefficient()
    options = {"gravity": case.gravity}
    if setting == "careful":
        options |= {"restitution_threshold": 1e-4, "contact_hertz": 240.0}
    if not case.is_untouched:
        options["maximum_linear_speed"] = 1e6
    world = b2.World(**options)

    def surface(friction, **more):
        material = b2.surface_material(friction=friction, restitution=case.restitution, **more)
        return b2.shape_def(material=material)

    far = 100.0 * case.radius
    plane = b2.segment((-far, 0.0), (far, 0.0))
    world.create_static_body().create_shape(surface(case.friction_of_plane(mu)), plane)
    # The origin of the body is the geometric centre.
    hoop = world.create_dynamic_body(
        position=(0.0, case.radius),
        rotation=turned(case.theta),
        enable_sleep=case.is_untouched,
    )
    resists = case.rolling_resistance / case.radius
    hoop.create_shape(surface(mu, rolling_resistance=resists), b2.circle(radius=case.radius))
    hoop.mass_data = mass_data(case)
    hoop.linear_velocity, hoop.angular_velocity = case.mass_centre_rates(), case.theta_rate
    turns = case.theta

    def row(time):
        nonlocal turns
        # A rotation knows an angle up to whole turns; `hoop.angle` is right to 3e-5.
        angle = math.atan2(hoop.rotation.s, hoop.rotation.c)
        turns += math.remainder(angle - turns, math.tau)
        (x, y), (vx, vy) = hoop.position, hoop.linear_velocity
        return (time, x, y, turns, *case.centre_rates(turns, vx, vy, hoop.angular_velocity))

    yield from stepped(case, step, lambda: world.step(step, SUB_STEPS), row)


def turned(angle):
    """The rotation by an angle; `make_rot` is right to 2e-3."""
    rotation = b2.Rot()
    rotation.c, rotation.s = math.cos(angle), math.sin(angle)
    return rotation


def mass_data(case):
    """Mass, mass centre and the inertia about it."""
    data = b2.MassData()
    data.mass, data.center, data.rotational_inertia = case.mass, (0.0, case.h), case.inertia
    return data


if __name__ == "__main__":
    main(simulate, has_rolling_friction=True)
