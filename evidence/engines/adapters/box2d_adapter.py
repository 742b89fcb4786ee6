"""Box2D 2.3 (pybox2d): a body whose mass data are set.

It has a circle beside its mass centre, on a long edge.

engine: Box2D 2.3
contact: rigid
settings: default careful
requires: Box2D==2.3.10
limits: own_turn=1.57/step turn=1.57/step friction=root force=1.00,+0 rolling=none
  rolling_small=none rolling_slow=none
limits default: own_speed=2/step speed=2/step sleep=0.01 bounce=1.05
limits careful: own_speed=0.2/step speed=0.2/step bounce=0.14 radius=10
docs: https://box2d.org/documentation/

default: R is 1 m; 8 velocity and 3 position iterations, as its manual suggests.
careful: R is 10 m, for the sake of the slop; 100 and 100 iterations.
Cannot express: mu_s and mu_k (one coefficient; that of two shapes is the root of the product of
theirs). Restitution acts above 1 m/s only, which no setting changes: 1 sqrt(gR) by default, 0.1
sqrt(gR) in the careful setting. Everything is in single precision, and a contact keeps an overlap
of 0.005 m. An edge has a skin of 0.01 m: it lies lower by that.
"""

from adapter import main, stepped
from Box2D import b2CircleShape, b2ContactListener, b2EdgeShape, b2FixtureDef, b2MassData, b2World

SETTINGS = {"default": (None, 8, 3), "careful": (10.0, 100, 100)}
SKIN = 0.01


def simulate(case, step, setting):
    """Yield rows."""
    radius, *iterations = SETTINGS[setting]
    radius = radius or case.radius
    size = radius / case.radius
    along, away = case.gravity
    world = b2World(gravity=(along * size, away * size), doSleep=case.is_untouched)
    mu = case.one_coefficient()
    edge = b2EdgeShape(vertices=[(-100.0 * radius, -SKIN), (100.0 * radius, -SKIN)])
    friction = case.friction_of_plane(mu)
    world.CreateStaticBody(fixtures=b2FixtureDef(shape=edge, friction=friction))
    # The origin of the body is the geometric centre.
    hoop = world.CreateDynamicBody(
        position=(0.0, radius),
        angle=case.theta,
        fixtures=b2FixtureDef(
            shape=b2CircleShape(radius=radius),
            density=1.0,
            friction=mu,
            restitution=case.restitution,
        ),
    )
    # Box2D takes the inertia about the origin of the body.
    about_origin = (case.inertia + case.mass * case.h**2) * size**2
    hoop.massData = b2MassData(mass=case.mass, center=(0.0, case.h * size), I=about_origin)
    vx, vy = case.mass_centre_rates()
    hoop.linearVelocity, hoop.angularVelocity = (vx * size, vy * size), case.theta_rate

    def row(time):
        place = hoop.position.x / size, hoop.position.y / size, hoop.angle
        vx, vy = hoop.linearVelocity
        rates = case.centre_rates(hoop.angle, vx / size, vy / size, hoop.angularVelocity)
        return case.forced((time, *place, *rates), lambda: sum(pushed) / step / size)

    class Listener(b2ContactListener):
        def PostSolve(self, contact, impulse):
            pushed[:] = impulse.normalImpulses

    pushed = []
    listener = Listener()  # the world keeps no reference to it
    if case.has_force:
        world.contactListener = listener

    def advance():
        pushed.clear()
        world.Step(step, *iterations)
        world.ClearForces()

    yield from stepped(case, step, advance, row)


if __name__ == "__main__":
    main(simulate)
