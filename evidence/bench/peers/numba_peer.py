"""numba: Runge and Kutta's method of order 4 with a fixed step.

Events are located on a shortened last step.
"""

import numpy as np
from numba import njit

from physics import (
    AT_ONCE, CONTACT, FAILED, FIGURE_3, FREE, LATER, MOST_PHASES, NOT_ONE, ROLL,
    grid, mode_after, mode_at_rest, rolling, slip_margins, sliding, weight,
)  # fmt: skip
from worker import outcome_map, serve, trajectory


@njit
def accelerations(mode, theta, rate):
    if mode == ROLL:
        return rolling(theta, rate)[0], 0.0
    acceleration, slip, _ = sliding(theta, rate, float(mode))
    return acceleration, slip


@njit
def margins(mode, theta, rate, slip):
    if mode == ROLL:
        return slip_margins(theta, rate)
    return weight(theta, rate), slip * mode


@njit
def step(mode, state, h):
    theta, rate, slip, x = state
    a1, b1 = accelerations(mode, theta, rate)
    a2, b2 = accelerations(mode, theta + h / 2 * rate, rate + h / 2 * a1)
    a3, b3 = accelerations(mode, theta + h / 2 * (rate + h / 2 * a1), rate + h / 2 * a2)
    a4, b4 = accelerations(mode, theta + h * (rate + h / 2 * a2), rate + h * a3)
    turned = h * rate + h * h / 6 * (a1 + a2 + a3)
    slid = h * slip + h * h / 6 * (b1 + b2 + b3)
    after = rate + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)
    return theta + turned, after, slip + h / 6 * (b1 + 2 * b2 + 2 * b3 + b4), x + slid - turned


@njit
def locate(mode, state, h, event):
    """Length of the step on which the margin falls to 0: false position, Illinois variant."""
    low, high = 0.0, h
    at_low = margins(mode, state[0], state[1], state[2])[event]
    end = step(mode, state, h)
    at_high = margins(mode, end[0], end[1], end[2])[event]
    if at_low <= 0.0:
        return 0.0
    side = 0
    while high - low > 1e-16:
        h = (low * at_high - high * at_low) / (at_high - at_low)
        end = step(mode, state, h)
        at = margins(mode, end[0], end[1], end[2])[event]
        if abs(at) < 1e-16 or h == low or h == high:
            break
        if at < 0.0:
            high, at_high = h, at
            at_low *= 0.5 if side < 0 else 1.0
            side = -1
        else:
            low, at_low = h, at
            at_high *= 0.5 if side > 0 else 1.0
            side = 1
    return h


@njit
def motion(theta, rate, h, until, times):
    """Outcome of a motion; the first events go to `times`."""
    mode = mode_at_rest(theta, rate)
    if mode == FREE:
        return AT_ONCE
    time, phases, fresh = 0.0, 0, True
    state = (theta, rate, 0.0, 0.0)
    while time < until:
        if mode == NOT_ONE or phases >= MOST_PHASES:
            return FAILED
        after = step(mode, state, h)
        first, second = margins(mode, after[0], after[1], after[2])
        # The slip velocity is 0 where a slide starts; that is no event.
        if first >= 0.0 and (second >= 0.0 or (fresh and mode != ROLL)):
            state, fresh = after, False
            time += h
            continue
        event = 0 if first < 0.0 else 1
        part = locate(mode, state, h, event)
        theta, rate, _, x = step(mode, state, part)
        state, fresh = (theta, rate, 0.0, x), True
        time += part
        if phases < times.size:
            times[phases] = time
        phases += 1
        if mode != ROLL and event == 0:
            return LATER
        mode = mode_after(mode, event, theta, rate)
        if mode == FREE:
            return LATER
    return CONTACT


TIMES = np.zeros(3)


def figure_3():
    motion(*FIGURE_3, 0.01, 10.0, TIMES)
    return TIMES


def trajectories(_):
    return [trajectory("numba RK4, step 0.01", figure_3)]


def maps(cells):
    motion(1.0, 1.0, 0.002, 1.0, TIMES)
    outcome = lambda theta, rate: motion(theta, rate, 0.002, 50.0, TIMES)
    return [outcome_map("numba RK4, step 0.002", grid(cells, slice(None)), outcome)]


serve(trajectory=trajectories, map=maps)
