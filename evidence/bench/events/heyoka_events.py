"""heyoka: terminal events; the ball bounces in a callback, as in its documentation."""

import heyoka as hy
from problems import AFTER, BOUNCES, RESTITUTION, Stop, answer

hy.set_logger_level_critical()


class Peer:
    tool = f"heyoka {hy.__version__}"

    def __init__(self, setting, **options):
        self.setting, self.options, self.compiled = setting, options, {}

    def integrator(self, system, events):
        return hy.taylor_adaptive(
            list(zip(self.variables, self.rates(system), strict=True)),
            [0.0] * system.order,
            t_events=events,
            **self.options,
        )

    def rates(self, system):
        return [rate + 0.0 * self.variables[0] for rate in system.rates(self.variables)]

    def first(self, system, parameter, state, until):
        if system.name not in self.compiled:
            self.variables = hy.make_vars(*(f"y{i}" for i in range(system.order)))
            margins = system.margins(self.variables, hy.par[0])
            falling = hy.event_direction.negative
            events = [hy.t_event(margin, direction=falling) for margin in margins]
            self.compiled[system.name] = self.integrator(system, events)
        taylor = self.compiled[system.name]
        taylor.reset_cooldowns()
        taylor.time, taylor.state[:] = 0.0, state
        if len(taylor.pars):
            taylor.pars[:] = parameter
        code = int(taylor.propagate_until(until)[0])
        if not -100 < code < 0:
            return None
        return Stop(taylor.time, tuple(map(float, taylor.state)), (-code - 1,))

    def bounce(self):
        times = []

        def bounces(taylor, _):
            times.append(taylor.time)
            taylor.state[1] *= -RESTITUTION
            return len(times) < BOUNCES

        height, speed = hy.make_vars("y0", "y1")
        event = hy.t_event(height, callback=bounces, direction=hy.event_direction.negative)
        taylor = hy.taylor_adaptive(
            [(height, speed), (speed, -1.0 + 0.0 * height)],
            [0.5, 0.0],
            t_events=[event],
            **self.options,
        )
        taylor.propagate_until(AFTER)
        end = "falls through" if taylor.state[0] < 0.0 else "goes on"
        return {"bounces": len(times), "last": times[-1], "end": end}


if __name__ == "__main__":
    answer(Peer("default"))
    answer(Peer("tol=1e-9", tol=1e-9))
