"""pymunk (Chipmunk): a body with its mass centre at the origin, and a circle beside it.

engine: pymunk (Chipmunk)
contact: rigid
settings: default careful
requires: cffi==2.1.1 pycparser==3.12 pymunk==7.3.1
limits: friction=product force=0.00,+0 rolling=none rolling_small=none rolling_slow=none
limits careful: radius=100
docs: https://www.pymunk.org/en/latest/pymunk.html#pymunk.Space

default: as the package comes, ten iterations and a collision slop of 0.1, which is a tenth of the
radius here: Chipmunk is made for lengths of many units. An overlap that large is not corrected.
careful: R is 100 units, which suits its defaults, 100 iterations, no slop.
Cannot express: mu_s and mu_k (one coefficient). Restitution acts at any speed. Mass, inertia and an
offset mass centre are as wanted. Chipmunk's friction, and restitution, of two shapes are the
products of theirs: the plane has 1.
"""

import pymunk
from adapter import main, stepped


def simulate(case, step, setting):
    """Yield rows."""
    radius = case.radius if setting == "default" else 100.0
    size = radius / case.radius
    space = pymunk.Space()
    along, away = case.gravity
    space.gravity = (along * size, away * size)
    if setting == "careful":
        space.iterations, space.collision_slop = 100, 0.0
    plane = pymunk.Segment(
        space.static_body, (-1e3 * radius, -radius), (1e3 * radius, -radius), radius
    )
    plane.friction, plane.elasticity = case.friction_of_plane(1.0), 1.0
    hoop = pymunk.Body(case.mass, case.inertia * size * size)
    x, y = case.mass_centre()
    hoop.position, hoop.angle = (x * size, y * size), case.theta
    vx, vy = case.mass_centre_rates()
    hoop.velocity, hoop.angular_velocity = (vx * size, vy * size), case.theta_rate
    rim = pymunk.Circle(hoop, radius, (0.0, -case.h * size))
    rim.friction, rim.elasticity = case.one_coefficient(), case.restitution
    space.add(hoop, rim, plane)

    def row(time):
        x, y = hoop.position
        vx, vy = hoop.velocity
        there = (x / size, y / size, hoop.angle, vx / size, vy / size, hoop.angular_velocity)
        return case.forced(case.row(time, *there), force)

    def force():
        pushed = []
        hoop.each_arbiter(lambda arbiter: pushed.append(abs(arbiter.total_impulse[1])))
        return sum(pushed) / step / size

    yield from stepped(case, step, lambda: space.step(step), row)


if __name__ == "__main__":
    main(simulate)
