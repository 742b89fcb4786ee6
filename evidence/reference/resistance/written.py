"""Motions as they are written: decimal strings of 30 digits."""

from gmpy2 import mpfr

from .balances import FLIGHT, answer
from .motion import sample

DIGITS = 30
NUMBERS = ("mass_ratio", "offset", "inertia", "mu_s", "mu_k", "rolling_resistance", "slope")
START = ("theta", "theta_rate", "slip", "gap_rate")
PLACE = ("theta", "theta_rate", "slip", "x")


def text(v):
    """A number; zero but for rounding is 0.0."""
    return f"{{0:.{DIGITS}g}}".format(v) if abs(v) > mpfr("1e-38") else "0.0"


def mode(one):
    """A mode, the sign of eta' while it slips, and that of theta' while it turns in contact."""
    return {"mode": one.name, "direction": one.slips, "turning": one.turns}


def place(time, state):
    return {"time": text(time), **dict(zip(PLACE, map(text, state)))}


def lost(energies):
    return {name: text(v) for name, v in energies._asdict().items()}


def landing(before, found):
    """Velocities at an impact, and its segments: the signs of slip and spin of each."""
    out = {"gap_rate": text(before.opening)}
    if found is None:
        return out
    after = found.after
    velocities = {"theta_rate": after.rate, "slip": after.slip, "gap_rate": after.opening}
    return {
        **out,
        "segments": found.segments,
        "after": {name: text(v) for name, v in velocities.items()},
    }


def transition(row):
    to = None if row.to is None else mode(row.to)
    out = {"cause": row.cause, **place(row.time, row.state), "lost": lost(row.lost), "to": to}
    return {**out, **landing(*row.landing)} if row.landing else out


def middle(body, part):
    """A sample at a double near the middle of a phase; none if doubles do not resolve it."""
    time = float((part.begin + part.end) / 2)
    if not part.begin < time < part.end:
        return None
    state, forces, energy, gap, gap_rate = sample(body, part, mpfr(time))
    out = place(mpfr(time), state) | {
        name: text(v) for name, v in zip(("normal", "friction", "couple"), forces)
    }
    out["energy"] = text(energy)
    return out | {"gap": text(gap), "gap_rate": text(gap_rate)} if part.mode is FLIGHT else out


def at_rest(body, motion):
    """Forces and couple of a hoop that rests."""
    if motion.ended != "rests":
        return {}
    found = answer(body, motion.modes[0], motion.state)
    return {name: text(getattr(found, name)) for name in ("normal", "friction", "couple")}


def given(family, one):
    return {
        "family": family,
        "hoop": dict(zip(NUMBERS, one.hoop)),
        "start": dict(zip(START, one.start)),
        "until": one.until,
        "restitution": one.bounce and one.bounce[0],
        "law": one.bounce and one.bounce[1],
    }


def entry(family, one, body, motion):
    """A motion: what is given, phases, transitions, how it ended, and where its energy went."""
    return {
        **given(family, one),
        "phases": [mode(part.mode) | {"sample": middle(body, part)} for part in motion.phases],
        "transitions": [transition(row) for row in motion.transitions],
        "impacts": motion.bounces,
        "ended": motion.ended,
        "possible": [mode(one) for one in motion.modes],
        "end": place(motion.time, motion.state) | at_rest(body, motion),
        "lost": lost(motion.lost),
    }
