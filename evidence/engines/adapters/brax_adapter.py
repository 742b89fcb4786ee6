"""Brax: three of its pipelines on the processor, in double precision.

The hoop is MuJoCo's model.

engine: Brax
contact: compliant
settings: spring positional generalized
requires: absl-py==2.5.1 aiofiles==25.1.0 blinker==1.9.0 brax==0.14.2 click==8.5.1 etils==1.15.0
  Flask==3.1.3 flask-cors==6.0.5 flax==0.12.8 fsspec==2026.9.0 glfw==2.11.0 humanize==4.17.0
  itsdangerous==2.2.0 jax==0.10.2 jaxlib==0.10.2 jaxopt==0.8.5 Jinja2==3.1.6 markdown-it-py==4.3.0
  MarkupSafe==3.0.4 mdurl==0.1.2 ml_collections==1.1.0 ml_dtypes==0.6.0 msgpack==1.2.4 mujoco==4.0.0
  mujoco-core==4.0.0 mujoco-mjx==3.17.0 mujoco-studio==4.0.0 numpy==2.4.6 opt_einsum==3.4.0
  optax==0.2.8 orbax-checkpoint==0.12.8 packaging==26.4 pillow==13.0.0 prometheus_client==0.26.0
  protobuf==7.36.2 psutil==7.2.2 Pygments==2.21.0 PyOpenGL==3.1.10 PyYAML==6.0.4 rich==15.0.0
  scipy==1.17.1 simplejson==4.3.0 tensorboardX==2.6.5 tensorstore==0.1.86 treescope==0.1.10
  trimesh==5.2.0 typing_extensions==4.16.0 uvloop==0.23.0 websockets==17.4 Werkzeug==3.1.9
  zipp==4.1.2
gradients: theta_rate slip mu_k
docs: https://github.com/google/brax

Its authors advise MJX instead since 2025, and keep the pipelines. All steps of a run are one
program, as with MJX.
spring: impulses with restitution and friction; positional: position-based dynamics; generalized:
constraints in joint coordinates. All as they come, but for the time step.
Cannot express: mu_s and mu_k (one coefficient); rolling friction, as its contacts know the first of
MuJoCo's coefficients only. Restitution is refused here, as the three mean
other things by it. Derivatives are those of JAX in forward mode, through all steps.
"""

import importlib
import math

import jax.numpy as jnp
from adapter import main
from brax.io import mjcf
from jax_steps import Run

SCENE = """
<mujoco>
  <option timestep="{step!r}" gravity="{along!r} 0 {away!r}"/>
  <default><geom condim="3" friction="{mu!r} 0 0"/></default>
  <worldbody>
    <geom type="plane" size="50 50 1" contype="1" conaffinity="1"/>
    <body pos="0 0 {radius!r}">
      <inertial pos="0 0 {h!r}" mass="{mass!r}" diaginertia="{inertia!r} {inertia!r} {inertia!r}"/>
      <joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 0 1"/><joint type="hinge"
      axis="0 -1 0"/> <geom type="sphere" size="{radius!r}" contype="1" conaffinity="1"/>
    </body>
  </worldbody>
</mujoco>
"""


def run_of(case, step, setting):
    """All steps of a run."""
    case.without_restitution()
    along, away = case.gravity
    given = {"step": step, "along": along, "away": away, "mu": case.one_coefficient(), "h": case.h}
    body = {"mass": case.mass, "inertia": case.inertia, "radius": case.radius}
    system = mjcf.loads(SCENE.format(**given, **body))
    pipeline = importlib.import_module(f"brax.{setting}.pipeline")
    none = jnp.zeros(system.act_size())

    def begin(coordinates, rates, friction):
        both = jnp.array([case.friction_of_plane(friction), friction])
        rubbing = system.replace(geom_friction=system.geom_friction.at[:, 0].set(both))
        return pipeline.init(rubbing, coordinates, rates), lambda state: pipeline.step(
            rubbing, state, none
        )

    start = [0.0, 0.0, case.theta], [case.x_rate, case.gap_rate, case.theta_rate]

    def motion_of(state):
        # The two others report no force.
        push = (state.qf_constraint[1],) if setting == "generalized" else ()
        return state.q, state.qd, *push

    return Run(case, step, start, begin, motion_of)


def simulate(case, step, setting):
    """Yield rows."""
    rows = run_of(case, step, setting).ready()
    turns = case.theta

    def row(time, x, height, rates, *push):
        there = time, x, case.radius + height, turns, *rates
        return case.forced(there, lambda: push[0]) if push else there

    pushed = [0.0] if setting == "generalized" else []
    yield row(0.0, 0.0, 0.0, (case.x_rate, case.gap_rate, case.theta_rate), *pushed)
    for time, ((x, height, theta), rates, *pushed) in rows():
        # Two of the pipelines know an angle up to whole turns.
        turns += math.remainder(theta - turns, math.tau)
        yield row(time, x, height, rates, *pushed)


if __name__ == "__main__":
    main(simulate, lambda *run: run_of(*run).gradient())
