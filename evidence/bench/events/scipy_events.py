"""SciPy: `solve_ivp` with terminal events."""

import scipy
from problems import Stop, answer
from scipy.integrate import solve_ivp


class Peer:
    tool = f"SciPy {scipy.__version__}"

    def __init__(self, setting, **options):
        self.setting, self.options = setting, options

    def first(self, system, parameter, state, until):
        def event(index):
            def margin(_, y):
                return system.margins(y, parameter)[index]

            margin.terminal, margin.direction = True, -1
            return margin

        events = [event(i) for i in range(len(system.margins(state, parameter)))]
        found = solve_ivp(
            lambda _, y: system.rates(y), (0.0, until), state, events=events, **self.options
        )
        if found.status < 0:
            raise RuntimeError(found.message)
        named = tuple(i for i, times in enumerate(found.t_events) if len(times))
        if not named:
            return None
        return Stop(float(found.t[-1]), tuple(map(float, found.y[:, -1])), named)


if __name__ == "__main__":
    answer(Peer("default: RK45"))
    answer(Peer("DOP853, 1e-12", method="DOP853", rtol=1e-12, atol=1e-13))
