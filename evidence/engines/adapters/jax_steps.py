"""What adapters of engines in JAX share.

All steps of a run are one program, with its derivatives in forward mode.

A call from Python costs far more than a step, so that a run is a scan over the rows of the record,
and in it a scan over the steps between two rows. It is translated before the first row, which takes
some seconds.
"""

import jax
import jax.numpy as jnp
from adapter import rows_of

jax.config.update("jax_platforms", "cpu")
jax.config.update("jax_enable_x64", True)

TANGENTS = {
    "theta_rate": ([-1.0, 0.0, 1.0], 0.0),
    "slip": ([1.0, 0.0, 0.0], 0.0),
    "mu_k": ([0.0, 0.0, 0.0], 1.0),
}
"""Derivatives of the rates (x', y', theta') at the start, and of friction."""


class Run:
    """A run from coordinates and rates (x, y, theta) at the start.

    `begin(coordinates, rates, friction)` returns a state and what makes the next one of it,
    `motion_of(state)` coordinates and rates of a row, and what else the adapter has in one.
    """

    def __init__(self, case, step, start, begin, motion_of):
        count, each = rows_of(case, step)

        def record(coordinates, rates, friction):
            first, advance = begin(coordinates, rates, friction)

            def next_row(state, _):
                state, _ = jax.lax.scan(lambda state, _: (advance(state), None), state, length=each)
                return state, motion_of(state)

            return jax.lax.scan(next_row, first, length=count)[1]

        self.record, self.start = record, (*map(jnp.array, start), jnp.array(case.mu_k))
        self.quantity = case.gradient
        self.times = [i * each * step for i in range(1, count + 1)]

    def ready(self):
        """Translate it; what is returned yields times, and coordinates with their rates."""
        program = jax.jit(self.record).lower(*self.start).compile()

        def rows():
            columns = (column.tolist() for column in program(*self.start))
            return zip(self.times, zip(*columns, strict=True), strict=True)

        return rows

    def gradient(self):
        """Yield rows of derivatives."""
        rates, friction = TANGENTS[self.quantity]
        tangents = jnp.zeros(3), jnp.array(rates), jnp.array(friction)
        ready = (
            jax.jit(lambda *at: jax.jvp(self.record, at, tangents)[1]).lower(*self.start).compile()
        )
        yield 0.0, 0.0, 0.0
        coordinates, *_ = ready(*self.start)
        for time, (x, _, theta) in zip(self.times, coordinates.tolist(), strict=True):
            yield time, x, theta
