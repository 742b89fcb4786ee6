"""Which motions follow from a state in contact: all modes are tried."""

import itertools

import gmpy2
from follower.arithmetic import Tie

from .balances import FLIGHT, TIE, answer, contact_mode, rises


def signs(velocity):
    """The signs that a velocity may have just after: its own, or any where it is zero."""
    return (int(gmpy2.sign(velocity)),) if velocity else (0, 1, -1)


def satisfied(margin, what):
    """Whether a margin is positive; one that is zero but for rounding is a tie."""
    if abs(margin) < TIE:
        raise Tie(what)
    return margin > 0


def holds_at_zero(force, limit):
    """Whether a static force is within its limit. Without a limit only the force zero is."""
    if limit < TIE:
        return abs(force) < TIE
    return satisfied(limit - abs(force), "on a static limit")


def begins(sign, acceleration):
    """Whether a velocity leaves zero with this sign. An acceleration zero leaves it where it is."""
    return abs(acceleration) > TIE and sign * acceleration > 0


def fits(body, mode, state):
    """Whether forces and accelerations of a mode agree with its laws."""
    try:
        found = answer(body, mode, state)
    except Tie:
        return False
    if mode.name == "gliding":
        if abs(found.normal) > TIE:
            raise Tie("a glide with a force")
    elif not satisfied(found.normal, "no normal force"):
        return False
    if mode.slips == 0:
        if not holds_at_zero(found.friction, body.mu_s * found.normal):
            return False
    elif not state.slip and not begins(mode.slips, found.along + found.turn):
        return False
    if mode.turns == 0:
        return holds_at_zero(found.couple, body.chi * found.normal)
    return bool(state.rate) or begins(mode.turns, found.turn)


def consistent(body, state):
    """All modes that satisfy the equations and the laws of contact, flight among them."""
    modes = [
        contact_mode(slips, turns, body.massless)
        for slips, turns in itertools.product(signs(state.slip), signs(state.rate))
    ]
    modes = [mode for mode in modes if fits(body, mode, state)]
    if not body.massless and satisfied(rises(body, state), "on the lift-off curve"):
        modes.append(FLIGHT)
    return modes


def stays(mode, other):
    """Whether a mode keeps at zero what another lets go, and nothing the other way round."""
    if FLIGHT in (mode, other):
        return False
    kept, other_kept = ((v.slips == 0, v.turns == 0) for v in (mode, other))
    return kept != other_kept and all(a or not b for a, b in zip(kept, other_kept))


def possible(body, state):
    """The consistent modes, where a contact at rest stays at rest while it can."""
    modes = consistent(body, state)
    return [mode for mode in modes if not any(stays(other, mode) for other in modes)]
