"""Rolling resistance: its rolling, skids and rest, and which of them follows.

A couple −ς χ N acts against the rotation, ς the sign of θ′, and one of at most χ N where the hoop
does not turn. Rolling is linear in u = θ′², as a slide is, and both end where θ′ vanishes. A skid
slides without turning, with a constant acceleration.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass, replace

from .balls import Ball, Beyond, Undecided, arb, sign
from .body import Body, Next, State, Value
from .model import Model
from .phase import Followed
from .rolling import FRICTION_DOWN, FRICTION_UP, NORMAL
from .sliding import Slide

ROLLING, SLIDING, SKIDDING, REST = "rolling", "sliding", "skidding", "rest"
GLIDING = "gliding"


class ResistedRoll(Slide):
    """Rolling with resistance from a state, up to where θ′ vanishes."""

    singular = "rolling runs into D_χ = 0, where its force is unbounded"

    def __init__(self, body: Body, start: State, rotation: int) -> None:
        self.body, self.start, self.order, self.rotation = body, start, 0, rotation

    def _equation(self, sin: Value, cos: Value) -> tuple[Value, Value, Value]:
        body = self.body
        couple = body.chi * self.rotation
        f = (sin * body.h - couple) * body.down + (cos * body.h + 1) * body.back
        g = (sin + cos * couple) * body.h
        return f, g, body.resisted_denominator(sin, cos, self.rotation)

    def _guards(
        self, sin: Model, cos: Model, u: Model, rate: Model, time: Model, order: int
    ) -> dict[str, Model]:
        """Return μs N − F and μs N + F, times D_χ/m; of a massless hoop N and μs ∓ F/N."""
        body = self.body
        couple = body.chi * self.rotation
        a, d = sin * body.h, cos * body.h + 1
        if body.is_massless:
            # F/N = −(a − ς χ)/d, and both have the factor 1 − θ′².
            grip, twist = d * body.mu_s, a - couple
            return {NORMAL: 1 - u, FRICTION_UP: grip + twist, FRICTION_DOWN: grip - twist}
        along, w = a * u + body.back, body.down - cos * u * body.h
        lever = d * body.mass
        normal = (d * lever + body.inertia) * w - a * lever * along
        friction = (a * (a - couple) * body.mass + body.inertia) * along - lever * (a - couple) * w
        return {
            FRICTION_UP: normal * body.mu_s - friction,
            FRICTION_DOWN: normal * body.mu_s + friction,
        }

    def _state(self, theta: Ball, rate: Ball, elapsed: Ball) -> State:
        start, zero = self.start, arb(0)
        return State(
            start.time + elapsed, theta, rate, zero, start.x - (theta - start.theta), zero, zero
        )


@dataclass(frozen=True)
class Skid:
    """A skid from a state in a direction."""

    body: Body
    start: State
    sigma: int

    @property
    def acceleration(self) -> Ball:
        """Return η″ = −σ μk cos α − sin α."""
        return -self.body.mu_k * self.sigma * self.body.down - self.body.back

    def stop(self) -> State | None:
        """Return the state in which the slip has ended; None if it never ends."""
        slowing = -self.acceleration * self.sigma
        if sign(slowing, "what slows a skid") <= 0:
            return None
        end = self.at(self.start.time + abs(self.start.slip) / slowing)
        return replace(end, slip=arb(0))

    def at(self, time: Ball) -> State:
        """Return the state at a time."""
        start, passed = self.start, time - self.start.time
        gained = self.acceleration * passed
        return replace(
            start,
            time=time,
            slip=start.slip + gained,
            x=start.x + (start.slip + gained / 2) * passed,
        )


def resisted_forces(body: Body, now: Next, state: State) -> tuple[Ball, Ball, Ball]:
    """Return N, F and the couple in a mode with rolling resistance."""
    sigma, rotation = now.direction, now.rotation
    if now.mode in ("flight", GLIDING):
        return arb(0), arb(0), arb(0)
    if now.mode in (ROLLING, SLIDING):
        normal, friction = (
            body.rolling_forces(state.theta, state.rate, rotation)
            if now.mode == ROLLING
            else body.sliding_forces(state.theta, state.rate, sigma, rotation)
        )
        return normal, friction, -body.chi * rotation * normal
    normal = body.mass * body.down
    friction = body.mass * body.back if now.mode == REST else -body.mu_k * sigma * normal
    arm, lever = body.h * state.theta.sin(), 1 + body.h * state.theta.cos()
    return normal, friction, -(arm * normal + lever * friction)


def resisted_by_slide(body: Body, start: State, end: State, found: Followed, rotation: int) -> Ball:
    """Return the energy that resistance takes in a slide, χ ∫ N |dθ|.

    With N = m (cos α − h (s θ″ + c u)) and θ″ dθ = du/2, an integration by parts leaves ∫ c u dθ.
    """
    swept = arb(0)
    for piece, last in found.pieces:
        assert piece.swept is not None
        swept += piece.swept.value(last, last) - piece.swept.value(piece.low, piece.low)
    turned = (end.theta - start.theta) * rotation
    bends = [one.theta.sin() * one.rate * one.rate * rotation for one in (start, end)]
    swept += bends[1] - bends[0]
    return body.chi * body.mass * (body.down * turned - body.h * swept / 2)


@dataclass(frozen=True)
class Held:
    """What a motion held at zero before it arrives: its slip, its rotation."""

    slip: bool
    rotation: bool

    @classmethod
    def by(cls, mode: Next) -> Held:
        """Return what a mode holds."""
        return cls(mode.direction == 0, mode.rotation == 0)


def decide_resisted(
    body: Body, state: State, gives_way: int = 0, *, held: Held | None = None
) -> Next:
    """Decide which motion follows in contact, with rolling resistance.

    Each mode that the state allows is tried. What is at rest stays at rest while it can. A start,
    which has `held` nothing, is ambiguous if several are left; a motion that arrives stays in
    contact, and goes on holding what it held. Static friction has just given way to this direction,
    if it is not 0.
    """
    # A massless hoop has no flight: where it cannot roll it glides, with the rim at the plane.
    contact = None if body.is_massless else body.contact(state.theta, state.rate)
    w = 1 if contact is None else sign(contact, "cos α − h cos θ θ′²")
    if w == 0:
        raise Undecided("cos α − h cos θ θ′² vanishes where a motion begins")
    choice = _Choice(body, state, gives_way, w)
    if contact is not None:
        choice.evidence["contact"] = contact
    found = choice.consistent()
    if w < 0 and not (found and held is not None):
        found.append(Next("flight", 0, {}, 2))
    if held is not None and len(found) > 1:
        kept = [
            one
            for one in found
            if (held.slip and one.direction == 0) or (held.rotation and one.rotation == 0)
        ]
        found = kept or found
    match found:
        case [one]:
            one = replace(one, evidence=choice.evidence | one.evidence)
            if one.mode == ROLLING and one.evidence["rolling_solvability"] < 0:
                raise Beyond("rolling is not stable where D_χ is negative")
            return one
        case []:
            return Next("inconsistent", choice.slips, choice.evidence, rotation=choice.turns)
        case _:
            return Next("ambiguous", 0, choice.evidence)


class _Choice:
    """The modes of a state, with the numbers that decide between them."""

    def __init__(self, body: Body, state: State, gives_way: int, w: int) -> None:
        self.body, self.state, self.gives_way, self.w = body, state, gives_way, w
        self.sin, self.cos = state.theta.sin(), state.theta.cos()
        self.arm, self.lever = body.h * self.sin, 1 + body.h * self.cos
        self.slips = sign(state.slip, "the slip velocity")
        self.turns = sign(state.rate, "θ′")
        self.evidence: dict[str, Ball] = {}

    def consistent(self) -> list[Next]:
        """Return the modes whose forces and velocities obey their laws.

        One that holds more at zero excludes those that hold less.
        """
        slips = (self.slips,) if self.slips else (0, -1, 1)
        turns = (self.turns,) if self.turns else (0, -1, 1)
        signs = list(itertools.product(slips, turns))
        for zeros in (2, 1, 0):
            tried = (self._tried(*pair) for pair in signs if pair.count(0) == zeros)
            found = [mode for mode in tried if mode is not None]
            if found:
                return found
        return []

    def _tried(self, sigma: int, rotation: int) -> Next | None:
        if rotation == 0:
            return self._rest() if sigma == 0 else self._skid(sigma)
        return self._roll(rotation) if sigma == 0 else self._slide(sigma, rotation)

    def _rest(self) -> Next | None:
        body = self.body
        couple = self.arm * body.down + self.lever * body.back
        margin = {
            "rest_couple": body.chi * body.down - abs(couple),
            "rest_friction": body.mu_s * body.down - abs(body.back),
        }
        self.evidence |= margin
        # A force that is exactly 0 needs no margin.
        needs = (couple, body.back)
        for (name, left), need in zip(margin.items(), needs, strict=True):
            if not need.is_zero() and sign(left, name) <= 0:
                return None
        return Next(REST, 0, {})

    def _skid(self, sigma: int) -> Next | None:
        body = self.body
        arms = {
            name: body.q(self.sin, self.cos, sigma, side)
            for name, side in (("turning_negative", -1), ("turning_positive", 1))
        }
        if self.slips:
            self.evidence |= arms
        if sign(arms["turning_positive"], "q") > 0 or sign(arms["turning_negative"], "q") < 0:
            return None
        if not self.slips and sign(-body.mu_k * body.down - body.back * sigma, "η″ of a skid") <= 0:
            return None
        return Next(SKIDDING, sigma, {} if self.slips else arms, 0 if self.slips else 1)

    def _roll(self, rotation: int) -> Next | None:
        body, state = self.body, self.state
        if self.gives_way:
            return None
        normal, friction = body.rolling_forces(state.theta, state.rate, rotation)
        evidence = self._seen(
            {
                "rolling_solvability": body.resisted_denominator(self.sin, self.cos, rotation),
                "rolling_normal": normal,
                "rolling_friction": friction,
            }
        )
        if sign(normal, "N of rolling") <= 0:
            return None
        if not friction.is_zero() and sign(body.mu_s * normal - abs(friction), "a margin") <= 0:
            return None
        turning = body.rolling_acceleration(state.theta, state.rate, rotation)
        if not self.turns and sign(turning, "θ″ of rolling") * rotation <= 0:
            return None
        return Next(ROLLING, 0, evidence, rotation=rotation)

    def _glide(self, sigma: int, rotation: int) -> Next | None:
        """Return a glide: N = 0, so that the particle falls and η″ = (1 + c) (1 − θ′²)/s."""
        side = sign(self.sin, "sin θ")
        if side == 0:
            raise Beyond("a glide begins with the particle above or below the centre")
        if not self.turns and side != rotation:
            return None
        if self.slips:
            return Next(GLIDING, sigma, {}, 0, rotation)
        presses = sign(1 - self.state.rate * self.state.rate, "1 − θ′²")
        if presses == 0:
            raise Beyond("a glide begins without any acceleration of slip")
        return Next(GLIDING, sigma, {}, 1, rotation) if side * presses == sigma else None

    def _slide(self, sigma: int, rotation: int) -> Next | None:
        body = self.body
        if body.is_massless:
            return self._glide(sigma, rotation)
        p = body.solvability(self.sin, self.cos, sigma, rotation)
        side = "" if self.slips else "_positive" if sigma > 0 else "_negative"
        evidence = self._seen({"solvability" + side: p})
        if sign(p, "P") != self.w:
            return None
        # w and P have one sign, so that θ″ has that of q.
        q = body.q(self.sin, self.cos, sigma, rotation)
        if not self.turns and sign(q, "q") != rotation:
            return None
        order = 0 if self.slips else self._begins(sigma, rotation, p)
        if order is None:
            return None
        return Next(SLIDING, sigma, evidence, order, rotation)

    def _begins(self, sigma: int, rotation: int, p: Ball) -> int | None:
        """Return the order with which slip begins; None if it does not begin that way."""
        body, state = self.body, self.state
        denominator = body.resisted_denominator(self.sin, self.cos, rotation)
        if self.gives_way == sigma and body.same_friction:
            # η″ vanishes; the next derivative has the sign of P, as D_χ > 0 where it rolled.
            return 2 if p > 0 else None
        normal, friction = body.rolling_forces(state.theta, state.rate, rotation)
        drives = -(friction * sigma + body.mu_k * normal) * p * denominator
        return 1 if sign(drives, "the acceleration of slip") > 0 else None

    def _seen(self, numbers: dict[str, Ball]) -> dict[str, Ball]:
        """Return numbers as evidence of their mode, or keep them where only one ς is tried."""
        if not self.turns:
            return numbers
        self.evidence |= numbers
        return {}
