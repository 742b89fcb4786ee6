"""nosnoc (nosnoc_py): a Filippov system whose two parts are the slides.

It is integrated with switch detection (FESD).

engine: nosnoc
contact: events
settings: default careful
requires: casadi==3.8.2 contourpy==1.3.3 cycler==0.12.1 fonttools==4.68.0 kiwisolver==1.5.1
  matplotlib==3.11.2 nosnoc==0.2.0 numpy==2.4.6 packaging==26.4 pillow==13.0.0 pyparsing==3.3.3
  python-dateutil==4.0.0 scipy==1.17.1 tzdata==2026.6
docs: https://nosnoc-py.readthedocs.io/

The state is (x, theta, slip, theta rate); on the surface slip = 0 the method finds friction between
the two slides.
default: as the package comes: Radau IIA of two stages, two finite elements a step, complementarity
to 1e-8.
careful: three stages, complementarity to 1e-12.
Cannot express: mu_s and mu_k (one coefficient); and, in this set-up, a gap: flight and impacts
would need a model of its own in stretched time (time freezing). Steps of less than 1e-3 take longer
than two minutes.
"""

import casadi as ca
import nosnoc
import numpy as np
from adapter import main, refuse


def simulate(case, step, setting):
    """Yield rows."""
    case.one_coefficient()
    if case.gap_rate != 0.0 or case.restitution != 0.0:
        refuse("the set-up has no flight: it would need time freezing")
    m, h, inertia = case.mass, case.h, case.inertia
    sine = h * np.sin(case.theta)
    if abs(case.mu_k * (1.0 + h * np.cos(case.theta)) * sine) > inertia / m + sine**2:
        refuse("the set-up has no impact without a collision")
    along, away = case.gravity
    state = ca.SX.sym("state", 4)
    theta, slip, rate = state[1], state[2], state[3]
    sin, cos = h * ca.sin(theta), h * ca.cos(theta)

    def slide(sign):
        # Newton's law for the mass centre, with no acceleration of the rim away from the plane.
        free = -away - cos * rate**2
        normal = free / (
            1.0 / m + sin**2 / inertia - case.mu_k * sign * (1.0 + cos) * sin / inertia
        )
        friction = -case.mu_k * sign * normal
        turning = ((1.0 + cos) * friction + sin * normal) / inertia
        return ca.vertcat(
            slip - rate, rate, friction / m + along + (1.0 + cos) * turning - sin * rate**2, turning
        )

    options = nosnoc.NosnocOpts()
    options.terminal_time = step
    options.print_level = 0
    if setting == "careful":
        options.n_s, options.comp_tol, options.sigma_N = 3, 1e-12, 1e-12
    start = np.array([0.0, case.theta, case.slip, case.theta_rate])
    model = nosnoc.NosnocModel(
        x=state, x0=start, F=[ca.horzcat(slide(1), slide(-1))], S=[np.array([[1], [-1]])], c=[slip]
    )
    solver = nosnoc.NosnocSolver(options, model)
    yield 0.0, 0.0, 1.0, case.theta, case.x_rate, 0.0, case.theta_rate
    now = start
    for i in range(1, round(case.until / step) + 1):
        solver.set("x0", now)
        now = np.asarray(solver.solve()["x_list"][-1]).ravel()
        if -away - h * np.cos(now[1]) * now[3] ** 2 < 0.0:
            refuse(
                "the hoop leaves the plane, and the set-up has no flight: it would need time "
                "freezing"
            )
        yield i * step, now[0], 1.0, now[1], now[2] - now[3], 0.0, now[3]


if __name__ == "__main__":
    main(simulate, has_units=False)
