"""Newton: two of its solvers, one with two backends, on Warp's processor device.

A sphere on a plane stays plane by symmetry.

engine: Newton (Warp)
contact: rigid
settings: default careful lox
requires: newton==1.8.0 numpy==2.4.6 warp-lang==1.19.0
rolling: SolverXPBD has separate limits, SolverKamino's backend LOX one budget, the cone
  (friction/μN)² + (couple/χRN)² ≤ 1; the coefficient, a length, is the mean of those of both
  shapes, χ R.
limits default: friction=mean force=0.95,-1 rolling=1 rolling_small=0.64 rolling_slow=1
docs: https://newton-physics.github.io/newton/

default: SolverXPBD as it comes, which corrects positions; its restitution is switched on where the
case bounces only, since with it on, and e = 0, the hoop of Figure 3 rolls where it should slide.
careful: SolverKamino as it comes, which iterates until hard contacts with friction are satisfied.
lox: SolverKamino with its backend LOX, the only one of its backends with rolling friction
(contact_spatial_friction), which is switched on where the case has some.
All in single precision, the only one that Newton has. The rolling and torsional friction that its
shapes have by default is 0 here. SolverMuJoCo, another of its solvers, is MuJoCo's method, which
has adapters of its own. SolverXPBD turns a body by 2 atan(θ′ Δτ/2) in a step: less than its θ′
says.
Cannot express: mu_s and mu_k (one coefficient). Restitution acts at any speed.
"""

import math

import newton
import numpy as np
import warp as wp
from adapter import main, refuse, stepped

# Derivatives of the kernels are not needed, and take minutes to translate.
wp.config.enable_backward = False


def solver_of(model, case, setting):
    """The solver of a setting."""
    solvers = newton.solvers
    if setting == "default":
        return solvers.SolverXPBD(model, enable_restitution=case.restitution > 0.0)
    if setting == "careful":
        if case.rolling_resistance > 0.0:
            refuse("of SolverKamino's backends LOX alone has rolling friction")
        return solvers.SolverKamino(model)
    config = solvers.SolverKamino.Config(dynamics_solver="lox")
    config.lox.contact_spatial_friction = case.rolling_resistance > 0.0
    return solvers.SolverKamino(model, config=config)


def simulate(case, step, setting):
    """Yield rows."""
    builder = newton.ModelBuilder(gravity=(case.gravity[0], 0.0, case.gravity[1]))
    if setting != "default":
        newton.solvers.SolverKamino.register_custom_attributes(builder)

    def surface(mu):
        return newton.ModelBuilder.ShapeConfig(
            density=0.0,
            mu=mu,
            restitution=case.restitution,
            mu_torsional=0.0,
            mu_rolling=case.rolling_resistance,
        )

    mu = case.one_coefficient()
    builder.add_ground_plane(cfg=surface(case.friction_of_plane(mu)))
    # Counterclockwise, with x to the right and z upwards, is about -y.
    hoop = builder.add_body(
        xform=wp.transform(
            wp.vec3(0.0, 0.0, case.radius),
            wp.quat_from_axis_angle(wp.vec3(0.0, -1.0, 0.0), case.theta),
        ),
        com=wp.vec3(0.0, 0.0, case.h),
        mass=case.mass,
        inertia=wp.mat33(case.inertia * np.eye(3)),
        lock_inertia=True,
    )
    builder.add_shape_sphere(hoop, radius=case.radius, cfg=surface(mu))
    model = builder.finalize(device="cpu")
    solver = solver_of(model, case, setting)
    before, after, control = model.state(), model.state(), model.control()
    along, upwards = case.mass_centre_rates()
    rates = np.array([along, 0.0, upwards, 0.0, -case.theta_rate, 0.0], dtype=np.float32)
    before.body_qd.assign(rates[np.newaxis])
    before.joint_qd.assign(rates)
    pipeline = newton.CollisionPipeline(model)
    contacts = pipeline.contacts()
    kinds = [solver.ObservableKind.CONTACT_F] if case.has_force else []
    seen = solver.observables(kinds, contacts=contacts)
    theta = case.theta

    def advance():
        nonlocal before, after
        before.clear_forces()
        pipeline.collide(before, contacts)
        solver.step(before, after, control, contacts, step, observables=seen)
        before, after = after, before

    def row(time):
        nonlocal theta
        x, _, y, _, turn, _, real = map(float, before.body_q.numpy()[0])
        theta += math.remainder(-2.0 * math.atan2(turn, real) - theta, 2.0 * math.pi)
        vx, _, vy, _, turning, _ = map(float, before.body_qd.numpy()[0])
        there = (time, x, y, theta, *case.centre_rates(theta, vx, vy, -turning))
        return case.forced(there, force)

    def force():
        count = int(contacts.rigid_contact_count.numpy()[0])
        return abs(float(seen.contact_f.numpy()[:count, 2].sum()))

    yield from stepped(case, step, advance, row)


if __name__ == "__main__":
    main(simulate, has_rolling_friction=True)
