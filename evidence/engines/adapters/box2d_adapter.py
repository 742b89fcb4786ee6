"""Box2D 2.3 (pybox2d): a body whose mass data are set.

It has a circle beside its mass centre, on a long edge.

engine: Box2D 2.3
contact: rigid
settings: default careful
requires: Box2D==2.3.10
docs: https://box2d.org/documentation/

default: R is 1 m; 8 velocity and 3 position iterations, as its manual suggests.
careful: R is 10 m, for the sake of the slop; 100 and 100 iterations.
Cannot express: mu_s and mu_k (one coefficient; that of two shapes is the root of the product of
theirs). Restitution acts above 1 m/s only, which no setting changes: 1 sqrt(gR) by default, 0.1
sqrt(gR) in the careful setting. Everything is in single precision, and a contact keeps an overlap
of 0.005 m. An edge has a skin of 0.01 m: it lies lower by that.
"""

from adapter import main, stepped
from Box2D import b2CircleShape, b2EdgeShape, b2FixtureDef, b2MassData, b2World

SETTINGS = {"default": (1.0, 8, 3), "careful": (10.0, 100, 100)}
SKIN = 0.01


def simulate(case, step, setting):
    """Yield rows."""
    size, *iterations = SETTINGS[setting]
    along, away = case.gravity
    world = b2World(gravity=(along * size, away * size), doSleep=False)
    mu = case.one_coefficient()
    edge = b2EdgeShape(vertices=[(-100.0 * size, -SKIN), (100.0 * size, -SKIN)])
    world.CreateStaticBody(fixtures=b2FixtureDef(shape=edge, friction=mu))
    # The origin of the body is the geometric centre.
    hoop = world.CreateDynamicBody(
        position=(0.0, size),
        angle=case.theta,
        fixtures=b2FixtureDef(
            shape=b2CircleShape(radius=size), density=1.0, friction=mu, restitution=case.restitution
        ),
    )
    # Box2D takes the inertia about the origin of the body.
    about_origin = (case.inertia + case.mass * case.h**2) * size**2
    hoop.massData = b2MassData(mass=case.mass, center=(0.0, case.h * size), I=about_origin)
    vx, vy = case.mass_centre_rates()
    hoop.linearVelocity, hoop.angularVelocity = (vx * size, vy * size), case.theta_rate

    def row(time):
        return time, hoop.position.x / size, hoop.position.y / size, hoop.angle

    def advance():
        world.Step(step, *iterations)
        world.ClearForces()

    yield from stepped(case, step, advance, row)


if __name__ == "__main__":
    main(simulate)
