"""An impact: velocities are lines in the normal impulse, between the ends of slip and rotation."""

from __future__ import annotations

import itertools
import math

import numpy as np

from .balances import Tie, contact
from .choice import NEAR, begins, holds, more_held, signs


def responses(hoop, theta, mode):
    """Return (dx′, dθ′, dv, F, K) by a unit of normal impulse, v the rate of the gap."""
    arm, lever, m = hoop.h * math.sin(theta), 1 + hoop.h * math.cos(theta), hoop.m
    # The mass centre moves with x′ − h cos θ θ′ along and v − h sin θ θ′ across.
    rows = [
        [m, -m * (lever - 1), 0, -1, 0],
        [0, -m * arm, m, 0, 0],
        [0, hoop.i, 0, -lever, -1],
        [0, 0, 0, 1, 0] if mode.slips else [1, 1, 0, 0, 0],
        [0, 0, 0, 0, 1] if mode.turns else [0, 1, 0, 0, 0],
    ]
    right = [
        0,
        1,
        arm,
        -hoop.mu_k * mode.slips if mode.slips else 0,
        -hoop.chi * mode.turns if mode.turns else 0,
    ]
    return np.linalg.solve(np.array(rows, dtype=float), right).tolist()


def segment(hoop, theta, rate, slip):
    """Return (mode, dθ′, dη′, dv) of the segment that follows."""
    found = []
    for pair in itertools.product(signs(slip), signs(rate)):
        mode = contact(*pair, False)
        along, turn, opens, friction, couple = responses(hoop, theta, mode)
        if mode.slips == 0:
            if not holds(friction, hoop.mu_s):
                continue
        elif not slip and not begins(mode.slips, along + turn):
            continue
        if mode.turns == 0:
            if not holds(couple, hoop.chi):
                continue
        elif not rate and not begins(mode.turns, turn):
            continue
        changes = (turn if mode.turns else 0.0, along + turn if mode.slips else 0.0, opens)
        found.append((mode, *changes))
    found = [one for one in found if not any(more_held(other[0], one[0]) for other in found)]
    if len(found) != 1:
        raise Tie(f"{len(found)} segments of an impact")
    return found[0]


def impact(hoop, state, e, law):
    """Return θ′, η′ and the rate of the gap after an impact, and the last segment."""
    rate, slip, v = state.rate, state.slip, state.opening
    closing, p, work, pressed = -v, 0.0, 0.0, None
    for _ in range(20):
        mode, turn, along, opens = segment(hoop, state.theta, rate, slip)
        ahead = []
        if slip and along * slip < 0:
            ahead.append((-slip / along, "slip"))
        if rate and turn * rate < 0 and hoop.chi:
            ahead.append((-rate / turn, "rate"))
        if pressed is None:
            if opens > 0:
                ahead.append((-v / opens, "pressed"))
        elif law == "poisson":
            ahead.append(((1 + e) * pressed[0] - p, "over"))
        elif law == "newton":
            ahead.append(((e * closing - v) / opens, "over"))
        else:
            left = -e * e * pressed[1] - work
            square = v * v + 2 * opens * left
            ahead.append(((math.sqrt(square) - v) / opens, "over"))
        ahead.sort()
        if not ahead or ahead[0][0] < 0:
            raise Tie("an impact without end")
        if len(ahead) > 1 and ahead[1][0] - ahead[0][0] < NEAR * ahead[0][0]:
            raise Tie("two ends of a segment at once")
        if pressed is not None and opens < 0:
            raise Tie("a gap that closes twice")
        step, what = ahead[0]
        after = v + opens * step
        work += step * (v + after) / 2
        p, v, rate, slip = p + step, after, rate + turn * step, slip + along * step
        if what == "slip":
            slip = 0.0
        elif what == "rate":
            rate = 0.0
        elif what == "pressed":
            v, pressed, work = 0.0, (p, work), 0.0
            if e == 0:
                return rate, slip, 0.0, mode
        else:
            return rate, slip, v, mode
    raise Tie("an impact without end")
