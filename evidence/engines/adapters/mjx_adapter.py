"""MJX: MuJoCo's method in JAX, with MuJoCo's own model of the hoop, on the processor, in double precision.

engine: MJX (MuJoCo in JAX)
contact: compliant
settings: default careful
requires: absl-py==2.5.1 etils==1.15.0 fsspec==2026.9.0 glfw==2.11.0 jax==0.10.2 jaxlib==0.10.2 ml_dtypes==0.6.0
  mujoco==4.0.0 mujoco-core==4.0.0 mujoco-mjx==3.17.0 mujoco-studio==4.0.0 numpy==2.4.6 opt_einsum==3.4.0
  PyOpenGL==3.1.10 scipy==1.17.1 trimesh==5.2.0 typing_extensions==4.16.0 websockets==17.4 zipp==4.1.2
gradients: theta_rate slip mu_k
docs: https://mujoco.readthedocs.io/en/stable/mjx.html

A call from Python costs far more than a step, so that all steps of a run are one program: a scan over the rows of the
record, and in it a scan over the steps between two rows. It is translated before the first row, which takes some
seconds whatever the number of steps.

default and careful: as in mujoco_adapter.py. Derivatives are those of JAX in forward mode, through all steps.
Cannot express: mu_s and mu_k (one coefficient); a coefficient of restitution. See there.
"""

import jax
import jax.numpy as jnp
from adapter import main, rows_of
from mujoco import mjx
from mujoco_adapter import model_of, row_of, start_of


def recorded(case, step, setting):
    """A program that returns the coordinates of all rows from (coordinates, rates, friction) at the start."""
    jax.config.update("jax_platforms", "cpu")
    jax.config.update("jax_enable_x64", True)
    model = mjx.put_model(model_of(case, step, setting))
    count, each = rows_of(case, step)

    def record(coordinates, rates, friction):
        rubbing = model.replace(geom_friction=model.geom_friction.at[:, 0].set(friction))
        data = mjx.make_data(rubbing).replace(qpos=coordinates, qvel=rates)

        def advance(data, _):
            return mjx.step(rubbing, data), None

        def next_row(data, _):
            data, _ = jax.lax.scan(advance, data, length=each)
            return data, data.qpos

        return jax.lax.scan(next_row, data, length=count)[1]

    return record, (*map(jnp.array, start_of(case)), jnp.array(case.mu_k)), each


def simulate(case, step, setting):
    """Yield rows."""
    record, start, each = recorded(case, step, setting)
    ready = jax.jit(record).lower(*start).compile()
    yield row_of(0.0, start_of(case)[0])
    for i, at in enumerate(ready(*start).tolist(), start=1):
        yield row_of(i * each * step, at)


TANGENTS = {"theta_rate": ([-1.0, 0.0, 1.0], 0.0), "slip": ([1.0, 0.0, 0.0], 0.0), "mu_k": ([0.0, 0.0, 0.0], 1.0)}
"""Derivatives of the rates at the start, and of friction."""


def gradient(case, step, setting):
    """Yield rows of derivatives, in forward mode."""
    record, start, each = recorded(case, step, setting)
    rates, friction = TANGENTS[case.gradient]
    tangents = jnp.zeros(3), jnp.array(rates), jnp.array(friction)
    ready = jax.jit(lambda *at: jax.jvp(record, at, tangents)[1]).lower(*start).compile()
    yield 0.0, 0.0, 0.0
    for i, (x, _, theta) in enumerate(ready(*start).tolist(), start=1):
        yield i * each * step, x, theta


if __name__ == "__main__":
    main(simulate, gradient)
