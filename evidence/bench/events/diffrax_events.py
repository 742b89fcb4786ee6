"""diffrax: `Event` with a direction, with and without a root finder."""

import diffrax
import jax
import jax.numpy as jnp
import optimistix
from problems import BALL, Stop, answer

jax.config.update("jax_enable_x64", True)

ROOTS = optimistix.Newton(1e-5, 1e-5, optimistix.rms_norm)
"""As in the example of `Event`."""


class Peer:
    tool = f"diffrax {diffrax.__version__}"

    def __init__(self, setting, roots, controller):
        self.setting, self.roots, self.controller, self.compiled = setting, roots, controller, {}

    def solve(self, system):
        """The solution as a function of the parameter, the state and the end."""

        def margin(index):
            return lambda t, y, args, **_: system.margins(y, args)[index]

        count = len(system.margins((0.0,) * system.order, 0.0))
        event = diffrax.Event(
            [margin(i) for i in range(count)], self.roots, direction=[False] * count
        )

        @jax.jit
        def run(parameter, state, until):
            found = diffrax.diffeqsolve(
                diffrax.ODETerm(lambda _, y, __: jnp.array(system.rates(y))),
                diffrax.Tsit5(),
                0.0,
                until,
                None,
                state,
                args=parameter,
                event=event,
                stepsize_controller=self.controller,
                throw=False,
            )
            return found.ts[-1], found.ys[-1], found.event_mask, diffrax.is_okay(found.result)

        return run

    def derivative(self):
        run = self.solve(BALL)
        time = jax.grad(lambda height: run(0.0, jnp.array([height, 0.0]), jnp.float64(3.0))[0])
        return float(time(0.5))

    def first(self, system, parameter, state, until):
        if system.name not in self.compiled:
            self.compiled[system.name] = self.solve(system)
        time, end, mask, okay = self.compiled[system.name](
            jnp.float64(parameter), jnp.array(state), jnp.float64(until)
        )
        named = tuple(i for i, happened in enumerate(mask) if happened)
        if not okay:
            raise RuntimeError("the solve failed")
        return Stop(float(time), tuple(map(float, end)), named) if named else None


if __name__ == "__main__":
    steps = diffrax.PIDController(rtol=1e-9, atol=1e-9)
    answer(Peer("no root finder, 1e-9", None, steps))
    answer(Peer("root finder 1e-5, 1e-9", ROOTS, steps))
