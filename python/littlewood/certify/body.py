"""The hoop in balls, and the equations of its contact (docs/theory)."""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any, TypeAlias

from .balls import Ball, Undecided, arb, ball, sign
from .case import Case

Value: TypeAlias = Any
"""A ball, a series or a model."""


@dataclass(frozen=True)
class State:
    """A state, the rim at the plane where the gap is 0."""

    time: Ball
    theta: Ball
    rate: Ball
    slip: Ball
    x: Ball
    gap: Ball
    gap_rate: Ball

    def at_rest(self) -> State:
        """Return the same with no slip."""
        return replace(self, slip=arb(0))


class Body:
    """Mass, mass centre, inertia and friction."""

    def __init__(self, case: Case) -> None:
        hoop = case.dimensionless()
        self.offset = ball(hoop.offset)
        self.mass = ball(1 + hoop.mass_ratio)
        self.h = ball(hoop.offset / (1 + hoop.mass_ratio))
        self.inertia = ball(hoop.inertia + hoop.mass_ratio * hoop.offset**2 / (1 + hoop.mass_ratio))
        self.mu_s, self.mu_k = ball(hoop.mu_s), ball(hoop.mu_k)
        self.chi = ball(hoop.rolling_resistance)
        self.resists = hoop.rolling_resistance != 0
        self.is_massless = hoop.inertia == 0 and hoop.mass_ratio == 0
        self.is_level = case.slope == 0
        # Gravity towards the plane and, where it rises to the right, back along it.
        slope = ball(Fraction(case.slope))
        self.down, self.back = slope.cos(), slope.sin()
        self.is_balanced = hoop.offset == 0 and self.is_level
        self.same_friction = hoop.mu_s == hoop.mu_k
        self.constant = self.inertia + self.mass * (1 + self.h * self.h)

    def denominator(self, cos: Value) -> Value:
        """Return D."""
        return cos * (2 * self.offset) + self.constant

    def resisted_denominator(self, sin: Value, cos: Value, rotation: int) -> Value:
        """Return D_χ."""
        return self.denominator(cos) - sin * (self.offset * self.chi * rotation)

    def solvability(self, sin: Value, cos: Value, sigma: int, rotation: int = 0) -> Value:
        """Return P."""
        return sin * self.q(sin, cos, sigma, rotation) * (self.mass * self.h) + self.inertia

    def q(self, sin: Value, cos: Value, sigma: int, rotation: int = 0) -> Value:
        """Return q."""
        arm = sin * self.h - (cos * self.h + 1) * (self.mu_k * sigma)
        return arm - self.chi * rotation if rotation else arm

    def contact(self, theta: Ball, rate: Ball) -> Ball:
        """Return w."""
        return self.down - self.h * theta.cos() * rate * rate

    def rolling_acceleration(self, theta: Ball, rate: Ball, rotation: int = 0) -> Ball:
        """Return θ″ of rolling."""
        sin, cos, u = theta.sin(), theta.cos(), rate * rate
        turning = self.offset * sin * (self.down + u)
        turning += (self.mass + self.offset * cos) * self.back
        turning -= self.chi * rotation * self.mass * self.contact(theta, rate)
        return turning / self.resisted_denominator(sin, cos, rotation)

    def rolling_forces(self, theta: Ball, rate: Ball, rotation: int = 0) -> tuple[Ball, Ball]:
        """Return N and F of rolling."""
        sin, cos, u = theta.sin(), theta.cos(), rate * rate
        lever, heavy = self.mass + self.offset * cos, self.mass * self.back
        acceleration = self.rolling_acceleration(theta, rate, rotation)
        normal = self.mass * self.down - self.offset * (sin * acceleration + cos * u)
        return normal, self.offset * sin * u - lever * acceleration + heavy

    def sliding_forces(
        self, theta: Ball, rate: Ball, sigma: int, rotation: int = 0
    ) -> tuple[Ball, Ball]:
        """Return N and F of sliding."""
        p = self.solvability(theta.sin(), theta.cos(), sigma, rotation)
        normal = self.mass * self.inertia * self.contact(theta, rate) / p
        return normal, -self.mu_k * sigma * normal

    def energy(self, state: State) -> Ball:
        """Return the energy."""
        sin, cos, rate = state.theta.sin(), state.theta.cos(), state.rate
        along = state.slip - (1 + self.h * cos) * rate
        up = state.gap_rate - self.h * sin * rate
        kinetic = (self.mass * (along * along + up * up) + self.inertia * rate * rate) / 2
        up = self.mass * state.gap + self.offset * cos
        return kinetic + self.down * up + self.back * (self.mass * state.x - self.offset * sin)

    def compliance(self, theta: Ball) -> tuple[Ball, Ball, Ball]:
        """Return A, B and C."""
        arm, lever = self.h * theta.sin(), 1 + self.h * theta.cos()
        return (
            1 / self.mass + lever * lever / self.inertia,
            arm * lever / self.inertia,
            1 / self.mass + arm * arm / self.inertia,
        )


@dataclass(frozen=True)
class Next:
    """What follows, and the numbers that decide it."""

    mode: str
    direction: int
    evidence: dict[str, Ball]
    order: int = 0
    """Order of the zero of what the phase begins with: of the slip, or of the gap."""
    rotation: int = 0
    """Sign of θ′ in a phase with rolling resistance."""


def decide(body: Body, state: State, gives_way: int = 0, *, arrives: bool = True) -> Next:
    """Decide which motion follows.

    Static friction has just given way to this direction, if it is not 0.

    A motion that arrives is in contact and rolls where rolling is consistent; at a start flight may
    be, too.
    """
    sin, cos = state.theta.sin(), state.theta.cos()
    contact = body.contact(state.theta, state.rate)
    evidence = {"contact": contact}
    w = sign(contact, "cos α − h cos θ θ′²")
    if w == 0:
        raise Undecided("cos α − h cos θ θ′² vanishes where a motion begins")
    slips = sign(state.slip, "the slip velocity")
    if slips != 0:
        p = evidence["solvability"] = body.solvability(sin, cos, slips)
        match (w, sign(p, "P")):
            case (1, 1):
                return Next("sliding", slips, evidence)
            case (-1, 1):
                return Next("flight", 0, evidence, 2)
            case (1, -1):
                return Next("inconsistent", slips, evidence)
            case (-1, -1):
                return Next("ambiguous", 0, evidence)
        raise Undecided("P vanishes where a motion begins")
    normal, friction = body.rolling_forces(state.theta, state.rate)
    evidence["rolling_normal"], evidence["rolling_friction"] = normal, friction
    if gives_way:
        holds = False
    elif normal > 0 and body.mu_s * normal > abs(friction):
        holds = True
    elif normal < 0 or body.mu_s * normal < abs(friction):
        holds = False
    elif body.is_balanced and normal > 0:
        holds = True
    else:
        raise Undecided("whether static friction holds is not decided")
    if holds and (w > 0 or arrives):
        return Next("rolling", 0, evidence)
    solvable = {side: body.solvability(sin, cos, side) for side in (-1, 1)}
    evidence["solvability_negative"], evidence["solvability_positive"] = solvable[-1], solvable[1]
    consistent = [Next("rolling", 0, evidence)] if holds else []
    for side, p in solvable.items():
        # Where P and w have one sign the plane presses; and the slip has to begin.
        if holds or sign(p, "P") != w:
            continue
        if gives_way == side and body.same_friction:
            # The acceleration of slip vanishes; the next derivative has the sign of P.
            if w > 0:
                consistent.append(Next("sliding", side, evidence, 2))
        elif sign(-(friction * side + body.mu_k * normal) * p, "the acceleration of slip") > 0:
            consistent.append(Next("sliding", side, evidence, 1))
    if w < 0:
        consistent.append(Next("flight", 0, evidence, 2))
    match consistent:
        case [one]:
            return one
        case []:
            return Next("inconsistent", 0, evidence)
        case _:
            return Next("ambiguous", 0, evidence)
