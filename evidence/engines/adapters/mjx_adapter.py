"""MJX: MuJoCo's method in JAX, with MuJoCo's own model of the hoop, on the processor, in double precision.

A call from Python costs far more than a step, so that all steps of a run are one program: a scan over the rows of the
record, and in it a scan over the steps between two rows. It is translated before the first row, which takes some
seconds whatever the number of steps.

default and careful: as in mujoco_adapter.py.
Cannot express: mu_s and mu_k (one coefficient); a coefficient of restitution. See there.
"""

import jax
import jax.numpy as jnp
from adapter import main, rows_of
from mujoco import mjx
from mujoco_adapter import model_of, row_of, start_of


def simulate(case, step, setting):
    """Yield rows."""
    jax.config.update("jax_platforms", "cpu")
    jax.config.update("jax_enable_x64", True)
    model = mjx.put_model(model_of(case, step, setting))
    coordinates, rates = map(jnp.array, start_of(case))
    start = mjx.make_data(model).replace(qpos=coordinates, qvel=rates)
    count, each = rows_of(case, step)

    def advance(data, _):
        return mjx.step(model, data), None

    def next_row(data, _):
        data, _ = jax.lax.scan(advance, data, length=each)
        return data, data.qpos

    record = jax.jit(lambda data: jax.lax.scan(next_row, data, length=count)[1]).lower(start).compile()
    yield row_of(0.0, start_of(case)[0])
    for i, at in enumerate(record(start).tolist(), start=1):
        yield row_of(i * each * step, at)


if __name__ == "__main__":
    main(simulate)
