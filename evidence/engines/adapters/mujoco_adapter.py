"""MuJoCo: a sphere on a plane, with two slides and a hinge at the geometric centre.

The mass centre is off that centre.

engine: MuJoCo
contact: compliant
settings: default careful
requires: glfw==2.11.0 mujoco==4.0.0 mujoco-core==4.0.0 mujoco-studio==4.0.0 numpy==2.4.6
  PyOpenGL==3.1.10 websockets==17.4
rolling: one budget for friction and couple (condim 6), a pyramid by default, the cone
  (friction/μN)² + (couple/χRN)² ≤ 1 in the careful setting; its third coefficient, a length, is
  χ R.
limits: bounce=none friction=greatest force=0.00,+0
limits default: rolling=0.79 rolling_small=0.31 rolling_slow=0.0045
limits careful: rolling=0.96 rolling_small=1 rolling_slow=0.035
docs: https://mujoco.readthedocs.io/en/stable/modeling.html#solver-parameters

default: as the package comes (Euler, pyramidal cone, contacts with solref 0.02 1, which are soft).
careful: elliptic cone, impratio 10, tolerance 1e-14, and contacts whose time constant is the root
of the step: both the penetration at a landing, which falls with the time constant, and the hops of
a hoop that slides, which fall with step over time constant, then go to zero with the step. (With a
time constant of two steps, the least that MuJoCo takes, a hoop that slides hops by 0.08 R, whatever
the step.)
Cannot express: mu_s and mu_k (one coefficient); a coefficient of restitution. Contact is compliant
by design. One that is underdamped bounces, and without slip its damping ratio can be made for any
e; but friction adds to it: made for 0.5, the first bounce of the case `bounces` is 0.71 times as
fast as the landing, at steps of 1e-3 and 1e-4 alike.
"""

import math

import mujoco
from adapter import main, stepped

SCENE = """
<mujoco>
  <option timestep="{step!r}" gravity="{along!r} 0 {away!r}" {option}/>
  <default><geom condim="{condim}" friction="{mu!r} 0 {chi!r}" {geom}/></default>
  <worldbody>
    <geom type="plane" size="0 0 1" friction="{plane!r} 0 {chi!r}"/>
    <body pos="0 0 {radius!r}">
      <inertial pos="0 0 {h!r}" mass="{mass!r}" diaginertia="{inertia!r} {inertia!r} {inertia!r}"/>
      <joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 0 1"/><joint type="hinge"
      axis="0 -1 0"/> <geom type="sphere" size="{radius!r}"/>
    </body>
  </worldbody>
</mujoco>
"""


def model_of(case, step, setting):
    """The model of a case."""
    case.without_restitution()
    option = geom = ""
    if setting == "careful":
        option = 'cone="elliptic" impratio="10" iterations="200" tolerance="1e-14"'
        geom = f'solref="{max(2.0 * step, math.sqrt(step))!r} 1" solimp="0.9 0.9999 0.001"'
    return mujoco.MjModel.from_xml_string(
        SCENE.format(
            step=step,
            along=case.gravity[0],
            away=case.gravity[1],
            option=option,
            geom=geom,
            condim=6 if case.rolling_resistance > 0.0 else 3,
            mu=case.one_coefficient(),
            plane=case.friction_of_plane(case.mu_k),
            chi=case.rolling_resistance,
            radius=case.radius,
            h=case.h,
            mass=case.mass,
            inertia=case.inertia,
        )
    )


def start_of(case):
    """The coordinates of the joints and their rates at the start."""
    return (0.0, 0.0, case.theta), (case.x_rate, case.gap_rate, case.theta_rate)


def row_of(case, time, coordinates, rates, push):
    """A row of the record; what the constraints push the second slide with is the normal force."""
    x, height, theta = coordinates
    return case.forced((time, x, case.radius + height, theta, *rates), lambda: push)


def simulate(case, step, setting):
    """Yield rows."""
    model = model_of(case, step, setting)
    data = mujoco.MjData(model)
    data.qpos[:], data.qvel[:] = start_of(case)

    def row(time):
        return row_of(case, time, data.qpos, data.qvel, data.qfrc_constraint[1])

    yield from stepped(case, step, lambda: mujoco.mj_step(model, data), row)


if __name__ == "__main__":
    main(simulate, has_rolling_friction=True)
