"""A motion followed in balls: phases, events, and how it ends."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import partial

from .balls import Ball, Beyond, Undecided, arb, ball, ends, sign
from .body import Body, Next, State, decide
from .case import Case
from .flight import Flight
from .gliding import PLANE, TURNING, Glide, decide_massless
from .impact import Impact, impact
from .impact_resisted import impact_of_bounce, impact_resisted
from .phase import TIME, Followed, Piece, follow
from .resisted import (
    Held,
    ResistedRoll,
    Skid,
    decide_resisted,
    resisted_by_slide,
    resisted_forces,
)
from .rolling import SIDES, Roll
from .settling import Rest, rest_of_bounces
from .sliding import CONTACT, SLIP, SOLVABLE, Slide

TURNING_POINT = "turning_point"
"""The event where θ′ vanishes in contact, with rolling resistance."""

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
    samples: list[tuple[State, tuple[Ball, ...]]] = field(default_factory=list)
    """States with normal force and friction, and with rolling resistance its couple."""
    rotation: int = 0
    resisted: Ball = field(default_factory=lambda: arb(0))
    """Energy that rolling resistance takes."""


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
    rotation: int = 0


@dataclass
class Motion:
    """A motion with all its phases and events."""

    initial: Next
    phases: list[Phase] = field(default_factory=list)
    events: list[Event] = field(default_factory=list)
    ending: str = ""
    end: State | None = None
    recurrence: str = ""
    period: Ball | None = None
    half_swings: int | None = None
    """Of a motion that comes to rest: how often it has rolled from one θ′ = 0 to the next."""


@dataclass
class _Bouncing:
    """Bounces that are no longer listed."""

    before: State
    normal: Ball = field(default_factory=lambda: arb(0))
    friction: Ball = field(default_factory=lambda: arb(0))


class Walk:
    """Follows a motion from its start."""

    def __init__(self, case: Case) -> None:
        self.body, self.law = Body(case), case.law
        theta, rate, slip, gap_rate = (ball(Fraction(value)) for value in case.start)
        mass, length, gravity = (ball(scale) for scale in case.scales())
        self.clock, speed, force = (
            (length / gravity).sqrt(),
            (length * gravity).sqrt(),
            mass * gravity,
        )
        self.scale = {
            "time": self.clock,
            "period": self.clock,
            "theta": arb(1),
            "theta_rate": 1 / self.clock,
        }
        """The units in which a certificate is written."""
        self.scale |= dict.fromkeys(("slip", "gap_rate"), speed) | dict.fromkeys(
            ("x", "gap"), length
        )
        self.scale |= dict.fromkeys(("normal_impulse", "friction_impulse"), mass * speed)
        self.scale |= dict.fromkeys(("normal", "friction"), force)
        self.scale |= dict.fromkeys(("energy", "energy_lost", "couple"), force * length)
        self.start = State(
            arb(0), theta, rate * self.clock, slip / speed, arb(0), arb(0), gap_rate / speed
        )
        self.until = None if case.until is None else ball(Fraction(case.until)) / self.clock
        self.restitution = None if case.restitution is None else ball(Fraction(case.restitution))
        self.pieces = self.half_swings = 0
        self.bouncing: _Bouncing | None = None

    def follow(self) -> Motion:
        """Follow the motion to its end."""
        state = self.start
        if state.gap_rate.is_zero():
            now = self._decide(state, arrives=False)
        else:
            now = Next("flight", 0, {"gap_rate": state.gap_rate}, 1)
        motion = self.motion = Motion(now)
        resists = self.body.resists
        phases = {
            "rolling": self._turn if resists else self._roll,
            "sliding": self._turn if resists else self._slide,
            "gliding": self._glide,
            "flight": self._fly,
            "skidding": self._skid,
            "rest": self._rest,
        }
        while not motion.ending:
            try:
                self._count(1)
                if now.mode in phases:
                    state, now = phases[now.mode](state, now)
                elif now.mode == "inconsistent" and self.restitution is not None:
                    state, now = self._hit("jam", state, self.restitution)
                else:
                    self._end(now.mode, state)
            except (Undecided, Beyond) as error:
                time, theta = (
                    f"{float(one.mid()):.9g}" for one in (state.time * self.clock, state.theta)
                )
                place = (
                    f"{now.mode} from time {time} on, theta {theta}, after "
                    f"{len(motion.events)} events"
                )
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

    def _decide(self, state: State, *, arrives: bool = True, after: Next | None = None) -> Next:
        if self.body.resists:
            return decide_resisted(self.body, state, held=None if after is None else Held.by(after))
        if self.body.is_massless:
            return decide_massless(self.body, state)
        return decide(self.body, state, arrives=arrives)

    def _end(self, kind: str, state: State) -> None:
        self.motion.ending, self.motion.end = kind, state

    def _phase(
        self,
        now: Next,
        start: State,
        end: State | None,
        at: Callable[[Ball], State],
        forces: Callable[[State], tuple[Ball, ...]] | None = None,
        count: int = 4,
        resisted: Ball | None = None,
    ) -> None:
        """Add a phase with at least so many samples.

        Without an end, those of four units of time.
        """
        times = self._times(start.time, start.time + 4 if end is None else end.time, count)
        body, zero = self.body, arb(0)
        if body.resists:
            forces = partial(resisted_forces, body, now)
        elif forces is None:
            forces = lambda _: (zero, zero)  # noqa: E731
        samples = [(one, forces(one)) for one in map(at, times)]
        lost = zero if resisted is None else resisted
        self.motion.phases.append(
            Phase(now.mode, now.direction, start, end, samples, now.rotation, lost)
        )

    def _event(
        self,
        cause: str,
        at: State,
        following: Next,
        before: State | None = None,
        hit: Impact | None = None,
    ) -> tuple[State, Next]:
        """Add an event, and return what follows it."""
        evidence = (hit.evidence if hit is not None else {}) | following.evidence
        event = Event(
            cause,
            before or at,
            at,
            following.mode or None,
            following.direction,
            evidence,
            hit,
            following.rotation,
        )
        self.motion.events.append(event)
        return at, following

    def _roll(self, state: State, now: Next) -> tuple[State, Next]:
        body = self.body
        roll = Roll(body, state)
        found = Followed(state, "", []) if roll.rests else self._follow(state.time, roll.pieces())
        end, guard = (found.end, found.guard) if found.guard else (None, "")
        if end is None and self.until is not None:
            end, guard = roll.at(found, self.until), TIME
        elif end is not None and guard != TIME:
            end = end.at_rest()
        self._phase(
            now,
            state,
            end,
            partial(roll.at, found),
            lambda one: body.rolling_forces(one.theta, one.rate),
        )
        if end is None:
            self.motion.ending = "rolls_forever"
            self.motion.recurrence, self.motion.period = roll.recurrence, roll.period
            return state, now
        if guard == TIME:
            self._end(TIME, end)
            return end, now
        side = SIDES[guard]
        if body.is_massless:
            following = decide_massless(body, end, "friction" if side else "normal")
        else:
            following = decide(body, end, -side)
        return self._event("slip" if side else "normal_force_zero", end, following)

    def _glide(self, state: State, now: Next) -> tuple[State, Next]:
        glide = Glide(state, now.direction, now.order, self.body.resists)
        found = self._follow(state.time, glide.pieces())
        end = found.end
        if found.guard == PLANE:
            end = glide.state(arb(0), at_end=True)
        elif found.guard == SLIP:
            end = end.at_rest()
        elif found.guard == TURNING:
            end = replace(end, rate=arb(0))
        self._phase(now, state, end, glide.at_time)
        if found.guard == TIME:
            self._end(TIME, end)
            return end, now
        if found.guard == PLANE:
            self._end("particle_at_plane", end)
            return self._event("particle_at_plane", end, Next("", 0, {}))
        following = self._decide(end, after=now)
        if found.guard == TURNING:
            return self._event(TURNING_POINT, end, following)
        return self._event("stick" if following.mode == "rolling" else "reversal", end, following)

    def _turn(self, state: State, now: Next) -> tuple[State, Next]:
        """Follow rolling or a slide with resistance, up to where θ′ vanishes."""
        body, sigma, rotation = self.body, now.direction, now.rotation
        rolls = now.mode == "rolling"
        phase = (
            ResistedRoll(body, state, rotation)
            if rolls
            else Slide(body, state, sigma, now.order, rotation)
        )
        found = self._follow(state.time, phase.pieces())
        end = found.end
        if found.guard == SLIP:
            end = end.at_rest()
        elif not found.guard:
            end = replace(end, rate=arb(0))
        resisted = (
            body.energy(state) - body.energy(end)
            if rolls
            else resisted_by_slide(body, state, end, found, rotation)
        )
        self._phase(now, state, end, partial(found.at, state.time), resisted=resisted)
        if found.guard == TIME:
            self._end(TIME, end)
            return end, now
        if not found.guard:
            self.half_swings += rolls and state.rate.is_zero()
            return self._event(TURNING_POINT, end, self._decide(end, after=now))
        if rolls:
            side = SIDES[found.guard]
            if side == 0:
                # η″ and N vanish, and what follows them has the sign of −θ′.
                glide = Next("gliding", -rotation, {}, 2, rotation)
                return self._event("normal_force_zero", end, glide)
            return self._event("slip", end, decide_resisted(body, end, -side, held=Held.by(now)))
        return self._end_of_slide(end, now, found.guard)

    def _skid(self, state: State, now: Next) -> tuple[State, Next]:
        skid = Skid(self.body, state, now.direction)
        end, until = skid.stop(), self.until
        if until is not None and (
            end is None or sign(until - end.time, "the time limit, less the end of a skid") < 0
        ):
            self._phase(now, state, skid.at(until), skid.at)
            self._end(TIME, skid.at(until))
            return skid.at(until), now
        if end is None:
            raise Beyond("a skid never ends")
        self._phase(now, state, end, skid.at)
        return self._end_of_slip(end, now)

    def _rest(self, state: State, now: Next) -> tuple[State, Next]:
        motion = self.motion
        self._phase(now, state, None, lambda time: replace(state, time=time))
        motion.half_swings = self.half_swings
        self._end("rests", state)
        return state, now

    def _slide(self, state: State, now: Next) -> tuple[State, Next]:
        body, sigma = self.body, now.direction
        found = self._follow(state.time, Slide(body, state, sigma, now.order).pieces())
        end = found.end.at_rest() if found.guard == SLIP else found.end
        at = partial(found.at, state.time)
        self._phase(
            now, state, end, at, lambda one: body.sliding_forces(one.theta, one.rate, sigma)
        )
        if found.guard == TIME:
            self._end(TIME, end)
            return end, now
        return self._end_of_slide(end, now, found.guard)

    def _end_of_slide(self, end: State, now: Next, guard: str) -> tuple[State, Next]:
        """Decide what follows a slide, where one of its guards vanishes."""
        if guard == SOLVABLE:
            raise Beyond(Slide.singular)
        if guard == CONTACT:
            opens = -self.body.h * end.theta.sin() * end.rate**3
            if not opens > 0:
                raise Undecided("whether the gap opens is not decided")
            return self._event(
                "lift_off", end, Next("flight", 0, {"gap_third_derivative": opens}, 3)
            )
        return self._end_of_slip(end, now)

    def _end_of_slip(self, end: State, now: Next) -> tuple[State, Next]:
        """Decide what follows where slip has ended."""
        following = self._decide(end, after=now)
        if following.mode == "flight":
            raise Undecided("a slide comes to rest where the plane does not hold the rim")
        return self._event("reversal" if following.direction else "stick", end, following)

    def _fly(self, state: State, now: Next) -> tuple[State, Next]:
        flight, e = Flight(self.body, state, now.order), self.restitution
        if self.bouncing is not None and e is not None:
            return self._bounce(flight, self.bouncing, e)
        found = self._follow(state.time, flight.pieces())
        end = found.end
        self._phase(now, state, end, partial(found.at, state.time), count=4 if now.order > 1 else 2)
        if found.guard == TIME:
            self._end(TIME, end)
            return end, now
        landing = flight.landing(end)
        if e is not None:
            return self._hit("landing", landing, e)
        self._end("landing", landing)
        return self._event("landing", landing, Next("", 0, {"gap_rate": landing.gap_rate}))

    def _hit(self, cause: str, before: State, restitution: Ball) -> tuple[State, Next]:
        body, held = self.body, None
        if body.resists:
            hit, held = impact_resisted(body, before, restitution, self.law)
        else:
            hit = impact(body, before, restitution, self.law)
        if hit.lost.is_zero():
            # All velocities are known exactly; by definition no impact loses nothing.
            hit = replace(hit, lost=arb(0, arb(2) ** -200))
        after = hit.after
        self.bouncing = None
        if after.gap_rate.is_zero():
            now = decide(body, after) if held is None else decide_resisted(body, after, held=held)
            return self._event(cause, after, now, before, hit)
        if not after.gap_rate > 0:
            raise Undecided("whether the gap opens after an impact is not decided")
        found = self._event(
            cause, after, Next("flight", 0, {"gap_rate": after.gap_rate}, 1), before, hit
        )
        if (
            sign(
                after.gap_rate - LISTED,
                "the gap rate after an impact, less the least that is listed",
            )
            < 0
        ):
            self.bouncing = _Bouncing(after)
        return found

    def _bounce(self, flight: Flight, bouncing: _Bouncing, e: Ball) -> tuple[State, Next]:
        """Follow a bounce that is not listed, or the rest of them."""
        body, state = self.body, flight.start
        if state.gap_rate > LISTED:
            raise Beyond("bounces too slow to be listed grow again")
        rest = rest_of_bounces(body, state, e, self.law)
        if rest is not None:
            return self._settle(bouncing, rest)
        landing = flight.short()
        if self.until is not None and not landing.time < self.until:
            raise Undecided("time is up while bounces accumulate")
        unit = flight.unit(landing)
        if body.resists:
            hit = impact_of_bounce(body, state, unit, landing, e, self.law)
        else:
            hit = impact(body, unit or landing, e, self.law)
            if unit is not None:
                hit = hit.times(state.gap_rate, state.rate)
        bouncing.normal += hit.normal
        bouncing.friction += hit.friction
        if not hit.after.gap_rate > 0:
            raise Undecided("bounces are not seen to settle")
        return hit.after, Next("flight", 0, {}, 1)

    def _settle(self, bouncing: _Bouncing, rest: Rest) -> tuple[State, Next]:
        end, body = rest.end, self.body
        if self.until is not None and not end.time < self.until:
            raise Undecided("whether bounces settle before the time limit is not decided")
        self.bouncing = None
        arrived = Next("", 1, {}, rotation=1)
        following = self._decide(end, after=arrived)
        lost = body.energy(bouncing.before) - body.energy(end)
        normal, friction = bouncing.normal + rest.normal, bouncing.friction + rest.friction
        hit = Impact("sticks" if rest.sticks else "slides", normal, friction, lost, end, {})
        self.motion.phases.append(Phase("flight", 0, bouncing.before, end))
        return self._event("settle", end, following, hit=hit)

    def _times(self, start: Ball, end: Ball, count: int) -> list[Ball]:
        """Return multiples of a power of two strictly between two times.

        There are at least so many, and about twice as many.
        """
        low, high = ends(start * self.clock)[1], ends(end * self.clock)[0]
        if high - low < Fraction(1, 2**10):
            return []
        step = Fraction(1)
        while step * (count + 1) > high - low:
            step /= 2
        while step * 2 * (count + 1) <= high - low:
            step *= 2
        return [ball(k * step) / self.clock for k in range(low // step + 1, -(-high // step))]
