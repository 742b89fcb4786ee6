"""Which motion follows: every mode is tried, and what is at rest stays so while it can."""

from __future__ import annotations

import itertools
import math

import numpy as np

from .balances import FLIGHT, Tie, contact, solved

NEAR = 1e-10  # margins below this are not told from 0


def margin(value, size=1.0):
    """Whether a margin is positive; what doubles do not tell is a tie."""
    if abs(value) < NEAR * max(1.0, size):
        raise Tie("a margin of a mode")
    return value > 0


def signs(velocity):
    """Return the signs that a velocity may have at once after."""
    return ((velocity > 0) - (velocity < 0),) if velocity else (0, 1, -1)


def holds(force, limit):
    """Whether a static force is within its limit: of no limit only 0 is."""
    if abs(force) < NEAR:
        if 0 < limit < NEAR:
            raise Tie("a small limit")
        return True
    return margin(limit - abs(force))


def fits(hoop, mode, state):
    """Whether forces and accelerations of a mode obey its laws."""
    try:
        x2, turn, normal, friction, couple = solved(hoop, mode, state)
    except np.linalg.LinAlgError:
        return False
    if mode.name == "gliding":
        if abs(normal) > NEAR:
            raise Tie("a glide with a force")
    elif not margin(normal):
        return False
    if mode.slips == 0:
        if not holds(friction, hoop.mu_s * normal):
            return False
    elif not state.slip and not (begins(mode.slips, x2 + turn)):
        return False
    if mode.turns == 0:
        return holds(couple, hoop.chi * normal)
    return bool(state.rate) or begins(mode.turns, turn)


def begins(sign, acceleration):
    """Whether a velocity leaves 0 with a sign."""
    return abs(acceleration) > NEAR and sign * acceleration > 0


def more_held(one, other):
    """Whether a mode keeps at 0 all that another keeps, and more."""
    kept = [(a == 0, b == 0) for a, b in zip(one[1:], other[1:])]
    return all(a or not b for a, b in kept) and any(a and not b for a, b in kept)


def possible(hoop, state):
    """Return the modes that may follow on the plane."""
    tried = [
        contact(*pair, hoop.massless)
        for pair in itertools.product(signs(state.slip), signs(state.rate))
    ]
    if not hoop.chi and not state.rate:
        # Without resistance nothing holds the rate: its sign is that of its acceleration.
        tried = [mode for mode in tried if mode.turns] + [
            mode for mode in tried if not mode.turns and balanced(hoop, mode, state)
        ]
    found = [mode for mode in tried if fits(hoop, mode, state)]
    found = [mode for mode in found if not any(more_held(other, mode) for other in found)]
    lifts = hoop.h * math.cos(state.theta) * state.rate**2 - hoop.down
    if not hoop.massless and margin(lifts):
        found.append(FLIGHT)
    return found


def balanced(hoop, mode, state):
    """Whether the moment about the mass centre vanishes by itself."""
    return abs(solved(hoop, mode, state)[4]) < NEAR


def arrived(modes, before):
    """Return of several modes those that a motion on its way takes: contact, and what it held."""
    modes = [mode for mode in modes if mode is not FLIGHT] or modes
    kept = [
        mode for mode in modes if any(now == last == 0 for now, last in zip(mode[1:], before[1:]))
    ]
    return kept or modes
