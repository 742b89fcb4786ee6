"""SciPy: DOP853 with terminal events."""

from functools import partial

import numpy as np
from scipy.integrate import solve_ivp

from physics import (
    FAILED,
    FIGURE_3,
    ROLL,
    follow,
    grid,
    listed,
    rolling,
    slip_margins,
    sliding,
    weight,
)
from worker import outcome_map, outcomes_in, serve, trajectory

COARSE = 20  # rows and columns of the map that are computed


def falling(function):
    function.terminal, function.direction = True, -1
    return function


def roll_rates(_, y):
    return y[1], rolling(y[0], y[1])[0], 0.0, -y[1]


def slide_rates(sign):
    def rates(_, y):
        acceleration, slip, _ = sliding(y[0], y[1], sign)
        return y[1], acceleration, slip, y[2] - y[1]

    return rates


MODES = {
    ROLL: (roll_rates, [falling(lambda _, y, i=i: slip_margins(y[0], y[1])[i]) for i in (0, 1)]),
    **{
        sign: (
            slide_rates(float(sign)),
            [
                falling(lambda _, y: weight(y[0], y[1])),
                falling(lambda _, y, sign=sign: y[2] * sign),
            ],
        )
        for sign in (-1, 1)
    },
}


def advance(mode, time, state, until, tolerance):
    rates, events = MODES[mode]
    found = solve_ivp(
        rates, (time, until), state, "DOP853", events=events, rtol=tolerance, atol=tolerance
    )
    if found.status < 0:
        raise RuntimeError(found.message)
    event = None if found.status == 0 else 0 if len(found.t_events[0]) else 1
    return event, found.t[-1], found.y[:, -1]


TIGHT, LOOSE = partial(advance, tolerance=1e-12), partial(advance, tolerance=1e-9)


def trajectories(_):
    return [trajectory("SciPy DOP853, 1e-12", lambda: follow(*FIGURE_3, 10.0, TIGHT)[1])]


def maps(cells):
    pick = np.linspace(0, cells - 1, COARSE).astype(int)
    outcome = lambda theta, rate: follow(theta, rate, 50.0, LOOSE)[0]
    return [outcome_map("SciPy DOP853, 1e-9", grid(cells, pick), outcome, pick.tolist())]


def regime(seconds):
    outcome = lambda theta, rate, slip: follow(theta, rate, 50.0, LOOSE, slip)[0]
    outcome(1.0, 1.0, 0.0)
    return outcomes_in("SciPy DOP853, 1e-9", listed(), outcome, FAILED, seconds)


serve(trajectory=trajectories, map=maps, regime=regime)
