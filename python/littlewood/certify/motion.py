"""A motion followed in balls: phases, events, and how it ends."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from fractions import Fraction

from .balls import Ball, Beyond, Undecided, arb, ball, ends, sign
from .body import Body, Next, State, decide
from .case import Case
from .flight import Flight
from .gliding import PLANE, Glide, decide_massless
from .impact import Impact, impact
from .incline import SAMPLED, Incline
from .phase import TIME, Followed, Piece, follow
from .rolling import SIDES, Roll
from .settling import Rest, rest_of_bounces
from .sliding import CONTACT, SLIP, SOLVABLE, Slide

LISTED = 1e-3
"""Bounces whose gap opens more slowly are not listed: they are part of the settlement."""

MOST_PIECES = 20_000
"""Pieces of phases, impacts and events after which a motion is given up, whatever the precision."""


@dataclass(frozen=True)
class Phase:
    """A phase: mode, direction of slip, samples."""

    mode: str
    direction: int
    start: State
    end: State | None
    samples: list[tuple[State, Ball, Ball]] = field(default_factory=list)
    """States with normal force and friction."""


@dataclass(frozen=True)
class Event:
    """A transition."""

    cause: str
    before: State
    after: State
    to: str | None
    direction: int
    evidence: dict[str, Ball]
    impact: Impact | None = None


@dataclass
class Motion:
    """A motion with all its phases and events."""

    body: Body
    initial: Next
    phases: list[Phase] = field(default_factory=list)
    events: list[Event] = field(default_factory=list)
    ending: str = ""
    end: State | None = None
    detail: dict[str, object] = field(default_factory=dict)


@dataclass
class _Bouncing:
    """Bounces that are no longer listed."""

    before: State
    normal: Ball = field(default_factory=lambda: arb(0))
    friction: Ball = field(default_factory=lambda: arb(0))


class Walk:
    """Follows a motion from its start."""

    def __init__(self, case: Case) -> None:
        self.case, self.body = case, Body(case)
        theta, rate, slip, gap_rate = (ball(Fraction(value)) for value in case.start)
        _, length, gravity = (ball(scale) for scale in case.scales())
        self.clock, speed = (length / gravity).sqrt(), (length * gravity).sqrt()
        self.state = State(arb(0), theta, rate * self.clock, slip / speed, arb(0), arb(0), gap_rate / speed)
        self.until = None if case.until is None else ball(Fraction(case.until)) / self.clock
        self.pieces = 0
        self.restitution = None if case.restitution is None else ball(Fraction(case.restitution))

    def follow(self) -> Motion:
        """Follow the motion to its end."""
        state, body = self.state, self.body
        if not state.gap_rate.is_zero():
            now = Next("flight", 0, {"gap_rate": state.gap_rate}, 1)
        else:
            now = self._decide(state)
        motion = Motion(body, now)
        bouncing: _Bouncing | None = None
        while not motion.ending:
            try:
                self._count(1)
                match now.mode:
                    case "rolling":
                        state, now = self._roll(motion, state)
                    case "sliding":
                        state, now = self._slide(motion, state, now)
                    case "gliding":
                        state, now = self._glide(motion, state, now)
                    case "flight":
                        state, now, bouncing = self._fly(motion, state, now, bouncing)
                    case "inconsistent" if self.restitution is not None:
                        state, now, bouncing = self._hit(motion, "jam", state)
                    case _:
                        motion.ending, motion.end = now.mode, state
            except (Undecided, Beyond) as error:
                time, theta = (f"{float(one.mid()):.9g}" for one in (state.time * self.clock, state.theta))
                place = f"{now.mode} from time {time} on, theta {theta}, after {len(motion.events)} events"
                raise type(error)(f"{error}; {place}") from error
        return motion

    def _count(self, pieces: int) -> None:
        """Count pieces of phases, impacts and events."""
        self.pieces += pieces
        if self.pieces > MOST_PIECES:
            raise Beyond(f"the motion takes more than {MOST_PIECES} pieces")

    def _follow(self, start: Ball, pieces: Iterator[Piece]) -> Followed:
        """Follow pieces, and count them."""
        found = follow(start, pieces, self.until, MOST_PIECES - self.pieces)
        self._count(len(found.pieces))
        return found

    def _roll(self, motion: Motion, state: State) -> tuple[State, Next]:
        body = self.body
        if not body.is_level:
            return self._roll_on_slope(motion, state)
        roll = Roll(body, state)
        slip = roll.slip()
        end = None if slip is None else roll.at_slip(slip)
        if self.until is not None and (end is None or sign(end.time - self.until, "the time that is left") > 0):
            end, slip = roll.at_time(self.until - state.time), None
            motion.ending, motion.end = TIME, end
        elif end is None:
            motion.ending = "rolls_forever"
            motion.detail = {"recurrence": roll.kind} | ({} if roll.kind == "rest" else {"period": roll.period()})
        last = end.time if end is not None else state.time + 4
        samples = []
        for time in self._times(state.time, last, 4):
            one = roll.at_time(time - state.time)
            samples.append((one, *body.rolling_forces(one.theta, one.rate)))
        motion.phases.append(Phase("rolling", 0, state, end, samples))
        if end is None or slip is None:
            return state, motion.initial
        end = end.at_rest()
        if body.is_massless:
            following = decide_massless(body, end, "friction" if slip.direction else "normal")
        else:
            following = decide(body, end, slip.direction)
        cause = "slip" if slip.direction else "normal_force_zero"
        motion.events.append(Event(cause, end, end, following.mode, following.direction, following.evidence))
        return end, following

    def _roll_on_slope(self, motion: Motion, state: State) -> tuple[State, Next]:
        body = self.body
        roll = Incline(body, state, self.until is not None)
        found = self._follow(state.time, roll.pieces())
        end = found.end if found.guard else None
        samples = []
        for time in self._times(state.time, state.time + SAMPLED if end is None else end.time, 4):
            one = found.at(state.time, time)
            samples.append((one, *body.rolling_forces(one.theta, one.rate)))
        motion.phases.append(Phase("rolling", 0, state, end, samples))
        if end is None:
            motion.ending = "rolls_forever"
            motion.detail = {"recurrence": "libration", "period": roll.period()}
            return state, motion.initial
        if found.guard == TIME:
            motion.ending, motion.end = TIME, end
            return end, motion.initial
        following = decide(body, end, -SIDES[found.guard])
        motion.events.append(Event("slip", end, end, following.mode, following.direction, following.evidence))
        return end, following

    def _decide(self, state: State) -> Next:
        return decide_massless(self.body, state) if self.body.is_massless else decide(self.body, state)

    def _glide(self, motion: Motion, state: State, now: Next) -> tuple[State, Next]:
        glide = Glide(state, now.direction, now.order)
        found = self._follow(state.time, glide.pieces())
        zero = arb(0)
        samples = [(glide.at_time(time), zero, zero) for time in self._times(state.time, found.end.time, 4)]
        end = found.end
        if found.guard == PLANE:
            end = glide.state(arb(0), at_end=True)
        elif found.guard == SLIP:
            end = end.at_rest()
        motion.phases.append(Phase("gliding", now.direction, state, end, samples))
        if found.guard == TIME:
            motion.ending, motion.end = TIME, end
            return end, now
        if found.guard == PLANE:
            cause = motion.ending = "particle_at_plane"
            motion.end = end
            motion.events.append(Event(cause, end, end, None, 0, {}))
            return end, now
        following = self._decide(end)
        cause = "stick" if following.mode == "rolling" else "reversal"
        motion.events.append(Event(cause, end, end, following.mode, following.direction, following.evidence))
        return end, following

    def _slide(self, motion: Motion, state: State, now: Next) -> tuple[State, Next]:
        body, sigma = self.body, now.direction
        found = self._follow(state.time, Slide(body, state, sigma, now.order).pieces())
        samples = []
        for time in self._times(state.time, found.end.time, 4):
            one = found.at(state.time, time)
            samples.append((one, *body.sliding_forces(one.theta, one.rate, sigma)))
        end = found.end
        if found.guard == SLIP:
            end = end.at_rest()
        motion.phases.append(Phase("sliding", sigma, state, end, samples))
        if found.guard == TIME:
            motion.ending, motion.end = TIME, end
            return end, now
        if found.guard == SOLVABLE:
            raise Beyond("the slide runs into P = 0, where its force is unbounded")
        if found.guard == CONTACT:
            opens = -body.h * end.theta.sin() * end.rate**3
            if not opens > 0:
                raise Undecided("whether the gap opens is not decided")
            following = Next("flight", 0, {"gap_third_derivative": opens}, 3)
            motion.events.append(Event("lift_off", end, end, "flight", 0, following.evidence))
            return end, following
        following = decide(body, end)
        cause = "reversal" if following.mode == "sliding" else "stick"
        if following.mode == "flight":
            raise Undecided("a slide comes to rest where the plane does not hold the rim")
        motion.events.append(Event(cause, end, end, following.mode, following.direction, following.evidence))
        return end, following

    def _fly(
        self, motion: Motion, state: State, now: Next, bouncing: _Bouncing | None
    ) -> tuple[State, Next, _Bouncing | None]:
        body = self.body
        if bouncing is not None and not body.is_level:
            raise Beyond("bounces on a slope are not proved to settle")
        if bouncing is not None and self.restitution is not None:
            rest = rest_of_bounces(body, state, self.restitution, self.case.law)
            if rest is not None:
                return self._settle(motion, bouncing, rest)
        flight = Flight(body, state, now.order)
        if bouncing is not None and self.restitution is not None:
            landing = flight.short()
            if self.until is not None and not landing.time < self.until:
                raise Undecided("time is up while bounces accumulate")
            unit = flight.unit(landing)
            hit = impact(body, unit or landing, self.restitution, self.case.law)
            if unit is not None:
                hit = hit.times(state.gap_rate, state.rate)
            bouncing.normal += hit.normal
            bouncing.friction += hit.friction
            if not hit.after.gap_rate > 0:
                raise Undecided("bounces end one by one")
            return hit.after, Next("flight", 0, {}, 1), bouncing
        found = self._follow(state.time, flight.pieces())
        samples = [
            (found.at(state.time, time), arb(0), arb(0))
            for time in self._times(state.time, found.end.time, 4 if now.order > 1 else 2)
        ]
        motion.phases.append(Phase("flight", 0, state, found.end, samples))
        end = found.end
        if found.guard == TIME:
            motion.ending, motion.end = TIME, end
            return end, now, None
        landing = flight.landing(end)
        if self.restitution is None:
            motion.events.append(Event("landing", landing, landing, None, 0, {"gap_rate": landing.gap_rate}))
            motion.ending, motion.end = "landing", landing
            return landing, now, None
        return self._hit(motion, "landing", landing)

    def _hit(self, motion: Motion, cause: str, before: State) -> tuple[State, Next, _Bouncing | None]:
        assert self.restitution is not None
        hit = impact(self.body, before, self.restitution, self.case.law)
        after = hit.after
        if after.gap_rate.is_zero():
            following = decide(self.body, after)
        else:
            if not after.gap_rate > 0:
                raise Undecided("whether the gap opens after an impact is not decided")
            following = Next("flight", 0, {"gap_rate": after.gap_rate}, 1)
        motion.events.append(
            Event(cause, before, after, following.mode, following.direction, hit.evidence | following.evidence, hit)
        )
        slow = following.mode == "flight" and following.order == 1
        slow = slow and sign(after.gap_rate - LISTED, "the gap rate after an impact, less the least that is listed") < 0
        return after, following, _Bouncing(after) if slow else None

    def _times(self, start: Ball, end: Ball, count: int) -> list[Ball]:
        """Return multiples of a power of two strictly between two times, at least so many and about twice as many."""
        low, high = ends(start * self.clock)[1], ends(end * self.clock)[0]
        if high - low < Fraction(1, 2**10):
            return []
        step = Fraction(1)
        while step * (count + 1) > high - low:
            step /= 2
        while step * 2 * (count + 1) <= high - low:
            step *= 2
        first = low // step + 1
        found = []
        while first * step < high:
            found.append(ball(first * step) / self.clock)
            first += 1
        return found

    def _settle(self, motion: Motion, bouncing: _Bouncing, rest: Rest) -> tuple[State, Next, None]:
        end, body = rest.end, self.body
        if self.until is not None and not end.time < self.until:
            raise Undecided("whether bounces settle before the time limit is not decided")
        following = decide(body, end)
        lost = body.energy(bouncing.before) - body.energy(end)
        normal, friction = bouncing.normal + rest.normal, bouncing.friction + rest.friction
        hit = Impact("sticks" if rest.sticks else "slides", normal, friction, lost, end, {})
        motion.phases.append(Phase("flight", 0, bouncing.before, end))
        motion.events.append(Event("settle", end, end, following.mode, following.direction, following.evidence, hit))
        return end, following, None
