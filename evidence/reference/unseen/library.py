"""What the library says of what is given, through the Python package."""

from __future__ import annotations

from typing import NamedTuple

import littlewood as lw

HOOP = ("mass_ratio", "offset", "inertia", "mu_s", "mu_k", "rolling_resistance", "slope")
START = ("theta", "theta_rate", "slip", "gap_rate")
NUMBERS = ("time", "theta", "theta_rate", "slip", "x")


class Answer(NamedTuple):
    """Transitions as (cause, next mode, direction, numbers), the first mode, and the outcome."""

    transitions: list
    first: tuple
    outcome: str


def simulated(given):
    """Simulate what is given."""
    law = {}
    if given.bounce is not None:
        law = {"restitution": given.bounce[0], "restitution_law": given.bounce[1]}
    hoop = lw.Hoop(**dict(zip(HOOP, given.hoop)), **law)
    motion = hoop.simulate(**dict(zip(START, given.start)), until=given.until)
    first = (motion.phases[0].mode, motion.phases[0].direction) if motion.phases else ("none", 0)
    return Answer(
        [
            (one.cause, one.to_mode, one.direction, [getattr(one.state, name) for name in NUMBERS])
            for one in motion.transitions
        ],
        first,
        motion.outcome.kind,
    )
