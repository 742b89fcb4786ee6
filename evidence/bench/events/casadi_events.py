"""CasADi: `zero` of a DAE and the option `transition`, which writes down what it is called for."""

import casadi as ca
import numpy as np
from problems import AFTER, RESTITUTION, Stop, answer

NEVER = -1.0
OUTPUTS = 100
"""Output times of its example of a bouncing ball; what cvodes finds depends on them."""


class Peer:
    tool = f"CasADi {ca.__version__}"

    def __init__(self, setting, plugin, **options):
        self.setting, self.plugin, self.options, self.compiled = setting, plugin, options, {}

    def integrator(self, dae, after, until):
        """Of a DAE; `after(index, state)` is the state after a transition."""
        index, time = ca.MX.sym("index"), ca.MX.sym("t")
        state = ca.MX.sym("x", dae["x"].numel())
        post = {"index": index, "t": time, "x": state, "post_x": after(index, state)}
        if "p" in dae:
            post["p"] = ca.MX.sym("p", dae["p"].numel())
        transition = ca.Function("transition", post, ca.event_in(), ca.event_out())
        grid = np.linspace(0.0, until, OUTPUTS + 1)[1:]
        options = {"transition": transition, "max_events": 200, **self.options}
        return ca.integrator("run", self.plugin, dae, 0.0, grid, options)

    def first(self, system, parameter, state, until):
        """The state has the clock, the time of each event, and the state at the first."""
        count, order = len(system.margins((0.0,) * system.order, 0.0)), system.order
        if system.name not in self.compiled:
            x = ca.MX.sym("x", 2 * order + 1 + count)
            scale, top = ca.MX.sym("scale"), ca.MX.sym("top")
            y = [x[i] for i in range(order)]
            rates = ca.vertcat(*system.rates(y), 1.0, *[0.0] * (count + order)) * scale
            dae = {
                "x": x,
                "p": ca.vertcat(scale, top),
                "ode": rates,
                "zero": ca.vertcat(*system.margins(y, top)),
            }

            def after(index, now):
                times = now[order + 1 : order + 1 + count]
                is_first = ca.mmax(times) < 0.0
                noted = [
                    ca.if_else(ca.logic_and(index == i, times[i] < 0.0), now[order], times[i])
                    for i in range(count)
                ]
                kept = ca.if_else(is_first, now[:order], now[order + 1 + count :])
                return ca.vertcat(now[: order + 1], *noted, kept)

            self.compiled[system.name] = self.integrator(dae, after, 1.0)
        start = [*state, 0.0, *[NEVER] * count, *[0.0] * order]
        end = np.array(self.compiled[system.name](x0=start, p=[until, parameter])["xf"])[:, -1]
        times = end[order + 1 : order + 1 + count]
        if times.max() < 0.0:
            return None
        first = times[times >= 0.0].min()
        named = tuple(int(i) for i in np.flatnonzero(times == first))
        return Stop(float(first), tuple(map(float, end[order + 1 + count :])), named)

    def bounce(self):
        end = self.falling(AFTER, 0.5)
        height, _, _, bounces, last = (float(value) for value in np.array(end)[:, -1])
        end = "falls through" if height < -1e-6 else "goes on"
        return {"bounces": int(bounces), "last": last, "end": end}

    def derivative(self):
        height = ca.MX.sym("height")
        landing = self.falling(1.2, height)[4, -1]
        return float(ca.Function("slope", [height], [ca.jacobian(landing, height)])(0.5))

    def falling(self, until, height):
        """Height, speed, clock, bounces and the time of the last, at each output."""
        x = ca.MX.sym("x", 5)
        dae = {"x": x, "ode": ca.vertcat(x[1], -1.0, 1.0, 0.0, 0.0), "zero": x[0]}

        def after(_, now):
            return ca.vertcat(now[0], -RESTITUTION * now[1], now[2], now[3] + 1.0, now[2])

        run = self.integrator(dae, after, until)
        return run(x0=ca.vertcat(height, 0.0, 0.0, 0.0, 0.0))["xf"]


if __name__ == "__main__":
    answer(Peer("erk", "erk"))
    answer(Peer("cvodes", "cvodes"))
    tight = {"abstol": 1e-12, "reltol": 1e-12, "event_tol": 1e-12, "max_event_iter": 50}
    answer(Peer("cvodes, 1e-12", "cvodes", **tight))
