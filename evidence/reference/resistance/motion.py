"""A motion, from phase to phase, with the energy that each cause takes."""

from typing import NamedTuple

import gmpy2
from follower.arithmetic import Tie
from follower.flight import flight
from follower.series import value
from gmpy2 import mpfr

from .balances import FLIGHT, State, answer, contact_mode, energy, rises
from .choice import fits, possible
from .impact import Velocities, impact
from .phase import phase, state_at

MOST = 400  # transitions that are followed
SLOW = mpfr("1e-4")  # rate of the gap, below which a landing is looked for near that of a parabola
SETTLED = mpfr("1e-36")  # rate of the gap, below which bounces have settled
RECORDED = mpfr(
    "1e-3"
)  # rate of the gap before an impact, below which a bounce is counted and is no transition


class Energies(NamedTuple):
    """Energy lost since the start, by its causes."""

    resistance: mpfr
    sliding: mpfr
    restitution: mpfr

    def plus(self, resistance=0, sliding=0, restitution=0):
        return Energies(
            self.resistance + resistance, self.sliding + sliding, self.restitution + restitution
        )


class Transition(NamedTuple):
    """The end of a phase: what ended it, when and where, and the mode that follows."""

    cause: str
    time: mpfr
    state: State
    lost: Energies
    to: object = None
    landing: object = None  # of a landing or a jam: its velocities and segments


class Phase(NamedTuple):
    """A phase and its parts: pieces in contact, the state and the rate of the gap of a flight."""

    mode: object
    begin: mpfr
    end: mpfr
    state: State
    gap_rate: mpfr
    pieces: list


class Motion(NamedTuple):
    """A motion to its end: `rests`, `time_limit`, `landing`, `none`, `ambiguous`."""

    transitions: list
    phases: list
    ended: str
    modes: list  # those that are possible at its end
    time: mpfr
    state: State
    lost: Energies
    bounces: int  # all impacts, those that are no transitions among them


def short_flight(body, state, gap_rate):
    """A flight so short that it is nearly one without rotation, as `flight`: Newton's iteration."""
    s, c = gmpy2.sin_cos(state.theta)
    h, rate = body.h, state.rate
    up, along = gap_rate - h * s * rate, state.slip - rate - h * c * rate
    time = -2 * gap_rate / rises(body, state)
    for _ in range(100):
        sine, cosine = gmpy2.sin_cos(state.theta + rate * time)
        gap = up * time - body.down * time * time / 2 - h * (cosine - c)
        slope = up - body.down * time + h * rate * sine
        time -= gap / slope
        if abs(gap / slope) < time * mpfr("1e-45"):
            break
    else:
        raise Tie("no landing")
    sine, cosine = gmpy2.sin_cos(state.theta + rate * time)
    fallen = body.along * time
    x = state.x + h * (sine - s) + along * time - fallen * time / 2
    then = State(state.theta + rate * time, rate, along - fallen + rate + h * cosine * rate, x)
    return "landing", time, then, up - body.down * time + h * rate * sine


def slides_after_slip(body, mode, state, way):
    """The slide that a slip begins. With equal coefficients it begins without an acceleration."""
    slide = contact_mode(way, mode.turns, body.massless)
    if body.mu_s == body.mu_k or fits(body, slide, state):
        return [slide]
    return [one for one in possible(body, state) if one.slips or one is FLIGHT]


def renamed(cause, before, after):
    """Names of the events of a slide that comes to rest: as in `motions.json`."""
    if cause != "stick" or (after.slips == 0 and after is not FLIGHT):
        return cause
    return "lift_off" if after is FLIGHT else "graze" if after.slips == before.slips else "reversal"


def kept(modes, last):
    """Of several modes those that a motion arrives at.

    It stays in contact, and holds what it held, while it can.

    `last` are the signs of slip and spin just before, in contact or at the end of an impact.
    """
    modes = [mode for mode in modes if mode is not FLIGHT] or modes
    held = [
        mode for mode in modes if any(now == before == 0 for now, before in zip(mode[1:], last))
    ]
    return held or modes


class Walk:
    """What is known of a motion on its way."""

    def __init__(self, body, start, until, bounce):
        theta, rate, slip, gap_rate = map(mpfr, start)
        self.body, self.until, self.bounce = body, mpfr(until), bounce
        self.state, self.gap_rate = State(theta, rate, slip, mpfr(0)), gap_rate
        self.time, self.lost = mpfr(0), Energies(mpfr(0), mpfr(0), mpfr(0))
        self.transitions, self.phases = [], []
        self.bounces = 0
        self.forced = None

    def motion(self, ended, modes=()):
        """The motion as it is known now."""
        end = self.time, self.state, self.lost, self.bounces
        return Motion(self.transitions, self.phases, ended, modes, *end)

    def modes(self):
        """The modes that may follow; a motion keeps its contact while it can, a start need not."""
        if self.gap_rate > 0:
            return [FLIGHT]
        if self.forced is not None:
            modes, self.forced = self.forced, None
            return modes
        modes = possible(self.body, self.state)
        if len(modes) < 2 or not self.transitions:
            return modes
        landing = self.transitions[-1].landing
        return kept(modes, landing[1].segments[-1] if landing else self.phases[-1].mode[1:])

    def follows(self, mode):
        """Writes into the last transition the mode that follows."""
        if self.transitions and self.transitions[-1].to is None:
            last = self.transitions[-1]
            before = self.phases[-1].mode if self.phases else mode
            self.transitions[-1] = last._replace(to=mode, cause=renamed(last.cause, before, mode))

    def land(self, cause, closing):
        """An impact, or one without a collision: False without a coefficient of restitution."""
        before = Velocities(self.state.rate, self.state.slip, closing)
        if self.bounce is None:
            self.record(Transition(cause, self.time, self.state, self.lost, None, (before, None)))
            return False
        found = impact(self.body, self.state.theta, before, mpfr(self.bounce[0]), self.bounce[1])
        after, state = found.after, self.state
        lost = self.lost.plus(found.resistance, found.sliding, found.restitution)
        row = Transition(cause, self.time, state, lost, None, (before, found))
        self.lost = lost
        opening = after.opening
        self.state = state._replace(rate=after.rate, slip=after.slip)
        self.bounces += 1
        if 0 < opening < SETTLED:
            opening, row = mpfr(0), row._replace(cause="settle")
        self.gap_rate = opening
        if cause == "jam" or -closing > RECORDED or not opening:
            self.record(row)
        return True

    def record(self, row):
        self.transitions.append(row)

    def fly(self):
        """A flight to its landing; the cause, None at the limit."""
        left = self.until - self.time
        if 0 < self.gap_rate < SLOW and rises(self.body, self.state) < -(self.gap_rate**0.5):
            cause, passed, then, closing = short_flight(self.body, self.state, self.gap_rate)
        else:
            cause, passed, then, closing = flight(self.body, self.state, self.gap_rate, left)
        end = self.time + passed
        if not 0 < self.gap_rate < RECORDED:
            self.phases.append(Phase(FLIGHT, self.time, end, self.state, self.gap_rate, []))
        self.time, self.state, self.gap_rate = end, State(*then), mpfr(0)
        return cause, closing

    def touch(self, mode):
        """A phase in contact to its event."""
        event, then, pieces = phase(self.body, mode, self.state, self.time, self.until)
        self.phases.append(Phase(mode, self.time, event.time, self.state, mpfr(0), pieces))
        for piece, end in zip(pieces, [*(p.start for p in pieces[1:]), event.time]):
            passed = end - piece.start
            self.lost = self.lost.plus(
                value(piece.series.resisted, passed), value(piece.series.slid, passed)
            )
        self.time, self.state = event.time, then
        return event


def follow(body, start, until, bounce=None, most=MOST):
    """The motion from (theta, theta', eta', rate of the gap).

    With a coefficient of restitution and its law or without.
    """
    walk = Walk(body, start, until, bounce)
    try:
        return followed(walk, most)
    except Tie as tie:
        tie.transitions = walk.transitions
        raise


def followed(walk, most):
    """The motion from where the walk is."""
    body, bounce = walk.body, walk.bounce
    while len(walk.transitions) < most:
        modes = walk.modes()
        if not modes and bounce is not None and not walk.gap_rate:
            # The plane holds the rim, yet nothing is consistent: an impact without a collision.
            walk.land("jam", mpfr(0))
            continue
        if len(modes) != 1:
            return walk.motion("ambiguous" if modes else "none", modes)
        mode = modes[0]
        walk.follows(mode)
        if mode.name == "rest":
            return walk.motion("rests", modes)
        if mode is FLIGHT:
            cause, closing = walk.fly()
            if cause is None:
                return walk.motion("time_limit", modes)
            if not walk.land("landing", closing):
                return walk.motion("landing")
            continue
        event = walk.touch(mode)
        if event.cause == "limit":
            return walk.motion("time_limit", modes)
        walk.record(Transition(event.cause, walk.time, walk.state, walk.lost))
        if event.cause == "slip":
            walk.forced = slides_after_slip(body, mode, walk.state, event.slips)
        elif event.cause == "lift_off":
            walk.forced = [FLIGHT]
        elif event.cause == "normal_force_zero":
            walk.forced = [contact_mode(1, mode.turns, True)]
    raise Tie("too many transitions")


def sample(body, part, time):
    """State, forces, couple, energy, and gap at a time of a phase."""
    if part.mode is FLIGHT:
        passed = time - part.begin
        _, _, then, gap_rate = flight(body, part.state, part.gap_rate, passed)
        state, zero = State(*then), mpfr(0)
        up = part.gap_rate - body.h * gmpy2.sin(part.state.theta) * part.state.rate
        gap = up * passed - body.down * passed**2 / 2
        gap -= body.h * (gmpy2.cos(state.theta) - gmpy2.cos(part.state.theta))
        forces, total = (zero, zero, zero), energy(body, state, gap, gap_rate)
    else:
        piece = [one for one in part.pieces if one.start <= time][-1]
        state, gap, gap_rate = state_at(piece, time), None, None
        forces, total = answer(body, part.mode, state)[2:], energy(body, state)
    return state, forces, total, gap, gap_rate
