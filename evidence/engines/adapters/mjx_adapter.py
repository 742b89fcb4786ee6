"""MJX: MuJoCo's method in JAX, on the processor, in double precision.

The hoop is MuJoCo's own model.

engine: MJX (MuJoCo in JAX)
contact: compliant
settings: default careful
requires: absl-py==2.5.1 etils==1.15.0 fsspec==2026.9.0 glfw==2.11.0 jax==0.10.2 jaxlib==0.10.2
  ml_dtypes==0.6.0 mujoco==4.0.0 mujoco-core==4.0.0 mujoco-mjx==3.17.0 mujoco-studio==4.0.0
  numpy==2.4.6 opt_einsum==3.4.0 PyOpenGL==3.1.10 scipy==1.17.1 trimesh==5.2.0
  typing_extensions==4.16.0 websockets==17.4 zipp==4.1.2
gradients: theta_rate slip mu_k
rolling: as MuJoCo.
docs: https://mujoco.readthedocs.io/en/stable/mjx.html

All steps of a run are one program.

default and careful: as in mujoco_adapter.py. Derivatives are those of JAX in forward mode, through
all steps.
Cannot express: mu_s and mu_k (one coefficient); a coefficient of restitution. See there.
"""

import jax.numpy as jnp
from adapter import main
from jax_steps import Run
from mujoco import mjx
from mujoco_adapter import model_of, row_of, start_of


def run_of(case, step, setting):
    """All steps of a run."""
    model = mjx.put_model(model_of(case, step, setting))

    def begin(coordinates, rates, friction):
        both = jnp.array([case.friction_of_plane(friction), friction])
        rubbing = model.replace(geom_friction=model.geom_friction.at[:, 0].set(both))
        first = mjx.make_data(rubbing).replace(qpos=coordinates, qvel=rates)
        return first, lambda data: mjx.step(rubbing, data)

    def motion_of(data):
        return data.qpos, data.qvel, data.qfrc_constraint[1]

    return Run(case, step, start_of(case), begin, motion_of)


def simulate(case, step, setting):
    """Yield rows."""
    rows = run_of(case, step, setting).ready()
    yield row_of(case, 0.0, *start_of(case), 0.0)
    for time, at in rows():
        yield row_of(case, time, *at)


if __name__ == "__main__":
    main(simulate, lambda *run: run_of(*run).gradient(), has_rolling_friction=True)
