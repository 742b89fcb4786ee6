"""SciPy: `solve_ivp` with terminal events, one right-hand side for each mode of motion.

engine: SciPy solve_ivp
contact: events
settings: default careful
steps: its own
requires: numpy==2.4.6 scipy==1.17.1
docs: https://docs.scipy.org/doc/scipy/reference/generated/scipy.integrate.solve_ivp.html

The modes, what follows each, and the landing are ours (hybrid.py); SciPy integrates and finds the
events. It chooses its steps itself: the step of the case is only that of the record, and errors do
not fall with it.
default: RK45 with the tolerances that SciPy has (rtol 1e-3, atol 1e-6).
careful: DOP853, rtol 1e-12, atol 1e-13.
Can express: mu_s and mu_k, and, by our equations, Poisson's restitution. An event function that
falls and rises again within a step is not seen; of two that are zero at once one is reported.
"""

import numpy as np
from adapter import main
from hybrid import MODES, Hoop
from scipy.integrate import solve_ivp

OPTIONS = {"default": {}, "careful": {"method": "DOP853", "rtol": 1e-12, "atol": 1e-13}}


def simulate(case, step, setting):
    """Yield rows."""
    hoop = Hoop(case)

    def event(mode, index):
        def value(_, state):
            return hoop.ends(mode, state)[index]

        value.terminal, value.direction = True, -1
        return value

    some = (0.0, 1.0, 0.0, 0.0, 0.0, 0.0)
    events = {mode: [event(mode, i) for i in range(len(hoop.ends(mode, some)))] for mode in MODES}

    def advance(mode, start, state, until):
        found = solve_ivp(
            lambda _, y: hoop.rates(mode, y),
            (start, until),
            state,
            events=events[mode],
            dense_output=True,
            **OPTIONS[setting],
        )
        if found.status < 0:
            raise RuntimeError(found.message)
        which = next((i for i, times in enumerate(found.t_events) if len(times)), None)
        return (
            found.t[-1],
            tuple(map(float, found.y[:, -1])),
            which,
            lambda at: np.asarray(found.sol(at)),
        )

    yield from hoop.follow(advance, step)


if __name__ == "__main__":
    main(simulate, has_units=False)
