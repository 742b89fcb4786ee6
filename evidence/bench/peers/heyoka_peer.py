"""heyoka: adaptive Taylor series with terminal events.

There is one integrator for each mode, with friction compiled in.
"""

import math
import time

import heyoka as hy
import numpy as np

from physics import (
    ARM,
    FAILED,
    FIGURE_3,
    INERTIA,
    MASS,
    MU_K,
    MU_S,
    OFFSET,
    ROLL,
    ROLLS,
    SEED,
    follow,
    grid,
    listed,
)
from worker import median_seconds, outcome_map, outcomes_in, serve, trajectory

hy.set_logger_level_critical()  # its warnings go to the standard output, where the answers are

THETA, RATE, SLIP, X = VARIABLES = hy.make_vars("theta", "rate", "slip", "x")
FALLING = hy.event_direction.negative
NO_EVENT = int(hy.taylor_outcome.time_limit)
FIRST, SECOND = -1, -2  # how heyoka numbers the events that stop it
MOST_STEPS = 1_000_000  # of a phase


def rolling():
    """Right-hand sides of the rates, and both event functions."""
    c, s = hy.cos(THETA), hy.sin(THETA)
    acceleration = (
        ARM
        * s
        * (RATE * RATE + 1.0)
        / (INERTIA + MASS * (1.0 + OFFSET * OFFSET + 2.0 * OFFSET * c))
    )
    normal = MASS - ARM * (s * acceleration + c * RATE * RATE)
    friction = ARM * s * RATE * RATE - MASS * (1.0 + OFFSET * c) * acceleration
    return (acceleration, 0.0 * SLIP), (MU_S * normal - friction, MU_S * normal + friction)


def sliding(sign):
    c, s = hy.cos(THETA), hy.sin(THETA)
    q = OFFSET * s - MU_K * sign * (1.0 + OFFSET * c)
    weight = 1.0 - OFFSET * c * RATE * RATE
    normal = INERTIA * MASS * weight / (INERTIA + MASS * OFFSET * s * q)
    acceleration = normal * q / INERTIA
    slip = (
        -MU_K * sign * normal / MASS + (1.0 + OFFSET * c) * acceleration - OFFSET * s * RATE * RATE
    )
    return (acceleration, slip), (weight, SLIP * sign)


def system(acceleration, slip):
    return list(zip(VARIABLES, (RATE, acceleration, slip, SLIP - RATE)))


class Hybrid:
    """Three integrators; Python passes the state from one to the next."""

    def __init__(self, **options):
        self.integrators = {
            mode: hy.taylor_adaptive(
                system(*rates),
                [0.1, 0.1, 0.1, 0.0],
                t_events=[hy.t_event(event, direction=FALLING) for event in events],
                **options,
            )
            for mode, (rates, events) in {
                ROLL: rolling(),
                -1: sliding(-1.0),
                1: sliding(1.0),
            }.items()
        }

    def advance(self, mode, start, state, until):
        integrator = self.integrators[mode]
        integrator.time = start
        integrator.state[:] = state
        integrator.reset_cooldowns()
        outcome = int(integrator.propagate_until(until, max_steps=MOST_STEPS)[0])
        if outcome not in (NO_EVENT, FIRST, SECOND):
            raise RuntimeError(f"heyoka stopped with outcome {outcome}")
        event = {NO_EVENT: None, FIRST: 0, SECOND: 1}[outcome]
        return event, integrator.time, integrator.state

    def figure_3(self):
        """Slide, roll, slide to lift-off, in a given order of the phases.

        No time goes to finding it.
        """
        minus, roll, plus = (self.integrators[mode] for mode in (-1, ROLL, 1))
        minus.time = 0.0
        minus.state[:] = (*FIGURE_3, -SEED, 0.0)
        minus.reset_cooldowns()
        minus.propagate_until(10.0)
        roll.time = minus.time
        roll.state[:] = minus.state
        roll.state[2] = 0.0
        roll.reset_cooldowns()
        roll.propagate_until(10.0)
        plus.time = roll.time
        plus.state[:] = roll.state
        plus.state[2] = SEED
        plus.reset_cooldowns()
        plus.propagate_until(10.0)
        return minus.time, roll.time, plus.time

    def outcome(self, theta, rate, slip=0.0):
        return follow(theta, rate, 50.0, self.advance, slip)[0]


class Batch:
    """Several motions in one integrator, whose parameters callbacks switch between the modes."""

    def __init__(self, lanes):
        self.lanes, self.times = lanes, []
        rolls, sign = hy.par[0], hy.par[1]
        (roll_rates, roll_events), (slide_rates, slide_events) = rolling(), sliding(sign)

        def blend(pair):
            return rolls * pair[0] + (1.0 - rolls) * pair[1]

        def switch(integrator, lane, sign_after):
            self.times.append((lane, integrator.time[lane]))
            if integrator.pars[0, lane]:
                integrator.pars[:, lane] = (0.0, sign_after)
                integrator.state[2, lane] = SEED * sign_after
                return True
            if sign_after < 0.0:
                return False  # the first event of a slide: lift-off
            integrator.pars[0, lane] = 1.0
            integrator.state[2, lane] = 0.0
            return True

        events = [
            hy.t_event_batch(
                blend(pair),
                direction=FALLING,
                callback=lambda ta, _, lane, sign=sign: switch(ta, lane, sign),
            )
            for pair, sign in zip(zip(roll_events, slide_events), (-1.0, 1.0))
        ]
        rates = map(blend, zip(roll_rates, slide_rates))
        self.integrator = hy.taylor_adaptive_batch(
            system(*rates), np.full((4, lanes), 0.1), pars=np.zeros((2, lanes)), t_events=events
        )
        self.start = np.repeat([[FIGURE_3[0]], [FIGURE_3[1]], [-SEED], [0.0]], lanes, axis=1)

    def figure_3(self):
        self.times.clear()
        self.integrator.set_time(0.0)
        self.integrator.state[:] = self.start
        self.integrator.pars[0] = 0.0
        self.integrator.pars[1] = -1.0
        self.integrator.reset_cooldowns()
        self.integrator.propagate_until(10.0)
        return [time for lane, time in self.times if lane == self.lanes - 1]


EXACT, FAST, LOOSE, BATCH = (
    Hybrid(),
    Hybrid(tol=1e-12, fast_math=True),
    Hybrid(tol=1e-9, fast_math=True),
    Batch(4),
)


def trajectories(_):
    return [
        trajectory("heyoka, tol = eps", EXACT.figure_3),
        trajectory("heyoka, fast_math, tol 1e-12", FAST.figure_3),
        trajectory("heyoka, batch of 4, tol = eps", BATCH.figure_3, each=4),
    ]


def maps(cells):
    LOOSE.outcome(1.0, 1.0)
    return [outcome_map("heyoka, fast_math, tol 1e-9", grid(cells, slice(None)), LOOSE.outcome)]


def regime(seconds):
    LOOSE.outcome(1.0, 1.0)
    return outcomes_in("heyoka, fast_math, tol 1e-9", listed(), LOOSE.outcome, FAILED, seconds)


def angle(until):
    """In pieces, whole turns and x taken off between them.

    heyoka's tolerance is relative to the largest of the state.

    In one piece the angle at 10^6 is wrong by 8e-3.
    """
    theta, rate = ROLLS
    turns, left = 0, float(until)
    while left > 0.0:
        piece = min(left, 20.0)
        event, _, (theta, rate, _, _) = EXACT.advance(ROLL, 0.0, (theta, rate, 0.0, 0.0), piece)
        if event is not None:
            raise RuntimeError("heyoka found a slip of a hoop that rolls for ever")
        whole = theta // math.tau
        theta, turns, left = theta - whole * math.tau, turns + whole, left - piece
    return turns * math.tau + theta


def rolls(until):
    if until < 1000:
        return [
            {
                "name": "heyoka, tol = eps",
                "seconds": median_seconds(lambda: angle(until)),
                "theta": angle(until),
            }
        ]
    start = time.process_time()
    theta = angle(until)
    return [{"name": "heyoka, tol = eps", "seconds": time.process_time() - start, "theta": theta}]


serve(trajectory=trajectories, map=maps, rolling=rolls, regime=regime)
