"""heyoka: adaptive Taylor series with terminal events, one integrator for each mode of motion.

engine: heyoka
contact: events
settings: default careful
steps: its own
requires: certifi==2026.10.18 cloudpickle==3.1.2 heyoka==7.13.2 numpy==2.4.6
docs: https://bluescarni.github.io/heyoka.py/

The modes, what follows each, and the landing are ours (hybrid.py); heyoka integrates and finds the
events. It chooses its steps itself: the step of the case is only that of the record, and errors do
not fall with it.
default: tolerance 2.2e-16.
careful: the same, with compensated sums.
Can express: mu_s and mu_k, and, by our equations, Poisson's restitution. An event function that is
zero at the start of a mode to a high order (the height at lift-off, the slip that begins) is left
alone for 0.01: a flight or a slide that takes less is not seen to end.
"""

import heyoka as hy
from adapter import main
from hybrid import FLIGHT, MODES, SIGN, Hoop

hy.set_logger_level_critical()  # its warnings go to the standard output, where the cost is
OPTIONS = {"default": {}, "careful": {"high_accuracy": True}}
WHILE = 1e-2
"""The rim is up to 1e-6 R high after it, and the slip as small: no hoop lands, or sticks,
before."""


def simulate(case, step, setting):
    """Yield rows."""
    hoop = Hoop(case)
    variables = hy.make_vars("x", "y", "theta", "slip", "gap_rate", "rate")
    zero = 0.0 * variables[0]
    falling = hy.event_direction.negative

    def events_of(mode):
        """Those functions whose zero ends a mode, by number, that are not constants.

        Some of a balanced hoop are.
        """
        ends = enumerate(hoop.ends(mode, variables, hy))
        return {
            i: end for i, end in ends if isinstance(end, hy.expression) and hy.get_variables(end)
        }

    def integrator(mode, has_events):
        rates = [zero + rate for rate in hoop.rates(mode, variables, hy)]
        ends = events_of(mode).values() if has_events else []
        events = [hy.t_event(end, direction=falling) for end in ends]
        return hy.taylor_adaptive(
            list(zip(variables, rates, strict=True)), [0.1] * 6, t_events=events, **OPTIONS[setting]
        )

    integrators = {mode: integrator(mode, True) for mode in MODES}
    free = {mode: integrator(mode, False) for mode in (FLIGHT, *SIGN)}

    def run(taylor, start, state, until):
        taylor.time, taylor.state[:] = start, state
        if taylor.with_events:
            taylor.reset_cooldowns()
        outcome, *_, dense, _ = taylor.propagate_until(until, c_output=True)
        code = int(outcome)
        event = -code - 1 if -100 < code < 0 else None
        return taylor.time, tuple(map(float, taylor.state)), event, lambda at: dense(at)

    def advance(mode, start, state, until):
        begins_with_event = (
            abs(state[3]) < 1e-12 if mode in SIGN else mode == FLIGHT and state[1] <= 1.0 + 1e-9
        )
        if not begins_with_event or start + WHILE >= until:
            end, last, event, dense = run(integrators[mode], start, state, until)
            return end, last, None if event is None else list(events_of(mode))[event], dense
        middle, between, _, early = run(free[mode], start, state, start + WHILE)
        end, last, event, late = run(integrators[mode], middle, between, until)
        event = None if event is None else list(events_of(mode))[event]
        return end, last, event, lambda at: early(at) if at <= middle else late(at)

    yield from hoop.follow(advance, step)


if __name__ == "__main__":
    main(simulate, has_units=False)
