"""A phase followed to its end, step by step: no guard has a zero before."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import TypeAlias

from .body import State
from .flight import FlightStep
from .given import Given
from .phase import FLIGHT, GAP, GLIDING, PLANE, ROLLING, SLIP, TIME, Phase, fall
from .ranges import Inconclusive, Range, exceeds, pi
from .step import Step
from .zeros import first_zero, zero

AnyStep: TypeAlias = "Step | FlightStep"


@dataclass(frozen=True)
class Turn:
    """Rolling that repeats itself after a time, turned by an angle."""

    period: Range
    angle: Range


@dataclass
class Followed:
    """A phase: its steps, what vanishes at its end, and the state there; without an end it rolls for ever."""

    phase: Phase
    steps: list[AnyStep] = field(default_factory=list)
    guard: str = ""
    end: State | None = None
    turn: Turn | None = None

    def at(self, time: Range) -> State:
        """Return the state at a time."""
        start = self.phase.start
        if not self.steps:
            return replace(start, time=time)
        tau, count = time - start.time, 0
        if self.turn is not None:
            count = int(float(tau) / float(self.turn.period))
            tau = tau - self.turn.period * count
        for step in self.steps:
            if not exceeds(tau - step.tau, step.length):
                found = self.phase.state(*step.moment((tau - step.tau) / step.length))
                if self.turn is None:
                    return found
                angle = self.turn.angle * count
                return replace(found, time=time, theta=found.theta + angle, x=found.x - angle)
        raise Inconclusive("a time is not within its phase")


def follow(given: Given, phase: Phase, last_sample: Range | None = None) -> Followed:
    """Follow a phase to the zero of a guard, to the end of time, or until rolling repeats itself.

    A glide whose end is in closed form is followed by steps up to the last sample.
    """
    run, start = Followed(phase), phase.start
    limit = None if given.until is None else given.until - start.time
    if phase.mode == ROLLING and start.rate.is_zero() and (given.balanced or start.theta.is_zero()):
        # It rests: below or above the centre, where rolling needs no friction.
        if given.until is not None:
            run.guard, run.end = TIME, replace(start, time=given.until)
        return run
    tau, theta, rate, guess = Range(0), start.theta, start.rate, 1.0
    turning = [Range(0)] if rate.is_zero() else []
    while len(run.steps) < 100_000:
        stop = limit if run.turn is None else run.turn.period
        step: AnyStep
        if phase.mode == FLIGHT:
            step = FlightStep(phase, tau, stop)
        else:
            step = Step(phase, tau, theta, rate, guess, stop)
            guess = step.rho * 1.2
        run.steps.append(step)
        found = first_zero(step.guards)
        if found is not None and _before(step.moment(found[1])[0], limit):
            run.guard, s = found
            run.end = phase.state(*step.moment(s))
            if run.guard == SLIP:
                run.end = replace(run.end, slip=Range(0))
            if run.guard == GAP and isinstance(step, FlightStep):
                rate = step.landing_rate(s) if step.order == 1 else run.end.gap_rate
                run.end = replace(run.end, gap=Range(0), gap_rate=rate)
            return run
        tau, theta, rate = step.moment(Range(1 << Range.bits))
        if isinstance(step, Step) and phase.mode == ROLLING and run.turn is None:
            run.turn = _turn(given, step, (theta, rate), start.theta, turning)
        if phase.mode == GLIDING and (last_sample is None or exceeds(start.time + tau, last_sample)):
            run.end = fall(phase.state(tau, theta, rate), phase.sigma)
            if run.end is not None and _before(run.end.time - start.time, limit):
                run.guard = PLANE
                return run
        if run.turn is not None:
            if not exceeds(run.turn.period, tau):
                if given.until is not None:
                    run.guard, run.end = TIME, run.at(given.until)
                return run
        elif given.until is not None and limit is not None and not exceeds(limit, tau):
            run.guard, run.end = TIME, run.at(given.until)
            return run
    raise Inconclusive("a phase has too many steps")


def _before(tau: Range, limit: Range | None) -> bool:
    """Whether a time comes before the limit."""
    return limit is None or (limit - tau).sign() > 0


def _turn(given: Given, step: Step, ahead: tuple[Range, Range], first: Range, turning: list[Range]) -> Turn | None:
    """Return period and angle once rolling has repeated itself: after a turn, or with the second turning point."""
    theta, rate = ahead
    low, high = Range(0), Range(1 << Range.bits)
    if not given.balanced and not step.rate.is_zero() and step.rate.sign() * rate.sign() < 0:
        s = zero(step.rate_guard(), low, high, step.rate.sign())
        turning.append(step.moment(s)[0])
        if len(turning) == 2:
            return Turn((turning[1] - turning[0]) * 2, Range(0))
    whole = 2 * pi()
    if not turning and exceeds(abs(theta - first), whole):
        side = rate.sign()
        s = zero(step.angle_guard(first + whole * side), low, high, -side)
        return Turn(step.moment(s)[0], whole * side)
    return None
