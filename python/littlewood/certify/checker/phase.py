"""The phases: for each kind of motion the equation of θ, its guards, and the state that belongs to θ, θ′ and a time.

| phase | θ″ | guards: it lasts while they are positive |
|---|---|---|
| rolling | ℓ s (1 + ω²)/D | μs N − F, μs N + F |
| rolling, massless | the same | 1 − ω² (the sign of N), μs (1 + c) − s, μs (1 + c) + s |
| sliding | m q w/P | σ η′, w, P (N = m Î w/P) |
| gliding | w/(h s) | σ η′, until the particle falls to the plane (:func:`fall`) |
| flight | 0 | the gap |

Slip and place are no further unknowns. Without friction the mass centre keeps its velocity along the plane, and a slide
has m x̄″ = −σ μk N, N = m (ȳ″ + 1); so with f = σ μk of a slide, else 0,

    η′ = ω (1 + h c + f h s) − f τ + const,    x = h s − f (1 + h c + τ²/2) + const τ + const.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from .body import Body, State, Value
from .discs import around
from .given import Given
from .ranges import Range, exceeds, pi, sine_and_cosine

ROLLING, SLIDING, GLIDING, FLIGHT = "rolling", "sliding", "gliding", "flight"
SLIP, CONTACT, SOLVABLE, GAP, NORMAL = "slip", "contact", "solvability", "gap", "normal"
UP, DOWN = "margin_positive", "margin_negative"
PLANE, TIME = "plane", "time_limit"


class Phase:
    """A phase from a state on; its slip or its gap begins with a zero of the order given."""

    def __init__(self, given: Given, start: State, mode: str, sigma: int = 0, order: int = 0) -> None:
        self.body, self.massless, self.start, self.mode = given.body, given.massless, start, mode
        self.sigma, self.order = sigma, order
        self.rubs = sigma if mode == SLIDING else 0
        self.sin, self.cos = s, c = sine_and_cosine(start.theta)
        body, omega = self.body, start.rate
        f = body.mu_k * self.rubs
        self.slip_constant = start.slip - omega * body.arm(s, c, self.rubs)
        self.along = start.slip - (1 + body.h * c) * omega - f * body.h * s * omega
        self.place = start.x - body.h * s + f * (1 + body.h * c)
        self.rise = start.gap_rate - body.h * s * omega
        self.in_discs = body.converted(around)

    def acceleration(self, body: Body, s: Value, c: Value, omega: Value) -> Value:
        """Return θ″ for numbers of any kind."""
        if self.mode == ROLLING:
            return body.rolling(s, c, omega)
        if self.mode == SLIDING:
            return body.sliding(s, c, omega, self.sigma)
        return body.gliding(s, c, omega)

    def guards(
        self, body: Body, angle: tuple[Value, Value, Value], alpha: Value, tau: Value, slip_constant: Value
    ) -> dict[str, Value]:
        """Return the guards for numbers of any kind, at sin θ, cos θ, θ′, at θ″ and a time from the start."""
        s, c, omega = angle
        if self.mode == ROLLING and self.massless:
            # F/N = −tan(θ/2), and N has the sign of 1 − ω²: where N vanishes F does, too.
            grip = body.mu_s * (1 + c)
            return {NORMAL: 1 - omega * omega, UP: grip + s, DOWN: grip - s}
        if self.mode == ROLLING:
            normal, friction = body.forces(s, c, omega, alpha)
            return {UP: body.mu_s * normal - friction, DOWN: body.mu_s * normal + friction}
        found = {SLIP: self._slip(body, angle, tau, slip_constant) * self.sigma}
        if self.mode == SLIDING:
            found |= {CONTACT: body.weight(c, omega), SOLVABLE: body.solvability(s, c, self.sigma)}
        return found

    def _slip(self, body: Body, angle: tuple[Value, Value, Value], tau: Value, constant: Value) -> Value:
        s, c, omega = angle
        return omega * body.arm(s, c, self.rubs) - body.mu_k * self.rubs * tau + constant

    def state(self, tau: Range, theta: Range, omega: Range) -> State:
        """Return the state at a time from the start."""
        body, start = self.body, self.start
        s, c = sine_and_cosine(theta)
        gap = gap_rate = Range(0)
        if self.mode == ROLLING:
            slip, x = Range(0), start.x - (theta - start.theta)
        else:
            f = body.mu_k * self.rubs
            slip = self._slip(body, (s, c, omega), tau, self.slip_constant)
            x = self.place + self.along * tau + body.h * s - f * (1 + body.h * c + tau * tau / 2)
        if self.mode == FLIGHT:
            # The mass centre is thrown: y + h c = … − τ²/2. What sin and cos grow by, without the radius of the angle.
            half, _ = sine_and_cosine(omega * tau / 2)
            s, c = sine_and_cosine(start.theta + omega * tau / 2)
            sin_grows, cos_grows = 2 * half * c, -(2 * half * s)
            slip = start.slip + body.h * cos_grows * omega
            gap = self.rise * tau - tau * tau / 2 - body.h * cos_grows
            gap_rate = start.gap_rate - tau + body.h * sin_grows * omega
        return State(start.time + tau, theta, omega, slip, x, gap, gap_rate)

    def forces(self, state: State) -> tuple[Range, Range]:
        """Return N and F at a state of the phase."""
        if self.mode in (GLIDING, FLIGHT):
            return Range(0), Range(0)
        body, (s, c), omega = self.body, sine_and_cosine(state.theta), state.rate
        if self.mode == ROLLING:
            return body.forces(s, c, omega, body.rolling(s, c, omega))
        normal = body.m * body.inertia * body.weight(c, omega) / body.solvability(s, c, self.sigma)
        return normal, -(body.mu_k * normal) * self.sigma


def energy(body: Body, state: State) -> Range:
    """Return kinetic and potential energy, of the mass centre and about it."""
    s, c = sine_and_cosine(state.theta)
    along = state.slip - state.rate - body.h * c * state.rate
    up = state.gap_rate - body.h * s * state.rate
    kinetic: Any = body.m * (along * along + up * up) + body.inertia * state.rate * state.rate
    found: Range = kinetic / 2 + body.m * state.gap + body.offset * c
    return found


def fall(start: State, sigma: int) -> State | None:
    """Return the end of a glide in which the particle falls to the plane, if its slip does not come to rest.

    Y = cos θ falls freely with V = Y′, and η′ = v − side V √((1 + Y)/(1 − Y)), whose last term is at most
    r √((1 + Y0)/(1 − Y0)) from here on, r the speed at the plane.
    """
    s, c = sine_and_cosine(start.theta)
    falls = s * start.rate
    if not exceeds(falls, 0) or float(c) > -0.5:
        return None
    r = (falls * falls + 2 * (1 + c)).sqrt()
    drift = start.slip - (1 + c) * start.rate
    if not exceeds(drift * sigma, r * ((1 + c) / (1 - c)).sqrt()):
        return None
    time = r - falls
    turns = round(float(start.theta) / 6.283185307179586)
    theta = pi() * (2 * turns + s.sign())
    return replace(start, time=start.time + time, theta=theta, rate=Range(0), slip=drift, x=start.x + drift * time - s)
