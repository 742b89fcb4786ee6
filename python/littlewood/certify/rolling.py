"""Rolling: the margins of static friction are trigonometric polynomials in the angle, and time is a quadrature.

On an orbit the margins depend on the angle alone. They are enclosed on intervals that cover the arc ahead: up to the
first zero, or over all angles that the orbit will ever have, which proves that the hoop rolls for ever. The time is
the integral of g ≥ 0 over a phase Φ that grows by π in each half swing, or by 2π in each turn: Arb's adaptive
quadrature encloses it.
"""

from __future__ import annotations

from dataclasses import dataclass

from .balls import Ball, Undecided, acb, arb, ends, flint, sign
from .body import Body, State
from .model import Model, first_crossing, sine_and_cosine

FRICTION_UP, FRICTION_DOWN = "margin_positive", "margin_negative"
"""μs N − F and μs N + F, times D²."""

NORMAL = "normal"
"""The normal force of a massless hoop, times a positive number."""

SIDES = {FRICTION_UP: 1, FRICTION_DOWN: -1, NORMAL: 0}

WIDTH = 0.25
"""Length of the arcs by which angles are covered."""


@dataclass(frozen=True)
class Slip:
    """Where static friction gives way: the angle, the direction of slip (0 where N vanishes), and the phase Φ."""

    theta: Ball
    direction: int
    phase: Ball


class Roll:
    """Rolling from a state."""

    def __init__(self, body: Body, start: State) -> None:
        self.body, self.start = body, start
        self.orbit = body.orbit(start.theta, start.rate)
        self.kind = self._kind()
        self.direction = self._direction()
        self.turns = arb(0)
        if self.kind == "libration":
            self._prepare_libration()
        elif self.kind == "rotation":
            self.first = arb(0)

    def _kind(self) -> str:
        body, start = self.body, self.start
        at_rest = start.rate.is_zero()
        if at_rest and (body.is_balanced or start.theta.is_zero()):
            return "rest"
        if body.is_balanced:
            return "rotation"
        surplus = sign(self.orbit - body.constant - 2 * body.offset, "the energy over the top")
        if surplus == 0:
            raise Undecided("the orbit is the separatrix")
        return "rotation" if surplus > 0 else "libration"

    def _direction(self) -> int:
        if self.kind == "rest":
            return 0
        return sign(self.start.rate, "θ′") or sign(self.start.theta.sin(), "sin θ")

    def _prepare_libration(self) -> None:
        body, start = self.body, self.start
        turn = ((self.orbit - body.constant) / (2 * body.offset)).acos()
        self.swing = arb.pi() - turn
        self.modulus = (self.swing / 2).sin()
        # The bottom about which it swings.
        half = (start.theta - arb.pi()) / (2 * arb.pi())
        turns = round(float(half.mid()))
        self.bottom = arb.pi() * (2 * turns + 1)
        z = ((start.theta - self.bottom) / 2).sin()
        root = body.denominator(start.theta.cos()).sqrt()
        psi = arb.atan2(z * 2 * body.offset.sqrt(), abs(start.rate) * root)
        self.first = psi if self.direction > 0 else arb.pi() - psi

    def slip(self) -> Slip | None:
        """Find where static friction gives way; None is the proof that it never does."""
        if self.kind == "rest":
            margins = self._margins(self.start.theta, 1)
            for name, margin in margins.items():
                if not margin.value(arb(0), arb(0)) > 0:
                    raise Undecided(f"the {name} at rest is not decided")
            return None
        if self.kind == "rotation":
            found = self._sweep(self.start.theta, self.direction, 2 * arb.pi())
            if found is None:
                return None
            theta, side = found
            return Slip(theta, -side, self.first + abs(theta - self.start.theta))
        ahead = self.bottom + self.direction * self.swing
        found = self._sweep(self.start.theta, self.direction, abs(ahead - self.start.theta), ends_at_turn=True)
        turned = 0
        if found is None:
            found = self._sweep(ahead, -self.direction, 2 * self.swing, ends_at_turn=True)
            turned = 1
        if found is None:
            return None
        theta, side = found
        psi = self._psi(theta)
        direction = self.direction * (-1 if turned else 1)
        phase = psi if direction > 0 else arb.pi() - psi
        while not phase > self.first:
            phase = phase + 2 * arb.pi()
        return Slip(theta, -side, phase)

    def _margins(self, theta: Ball, direction: int) -> dict[str, Model]:
        if self.body.is_massless:
            return self._massless_margins(theta, direction)
        sin, cos = sine_and_cosine(theta, direction, arb(1))
        return {
            name: self.body.margin(sin, cos, self.orbit, side) for name, side in ((FRICTION_UP, 1), (FRICTION_DOWN, -1))
        }

    def _massless_margins(self, theta: Ball, direction: int) -> dict[str, Model]:
        """F/N = −tan(θ/2), and N has the sign of 2 D − K: where N vanishes F does, too."""
        half_sin, half_cos = sine_and_cosine(theta / 2, arb(direction) / 2, arb(1))
        _, cos = sine_and_cosine(theta, direction, arb(1))
        mu = half_cos * self.body.mu_s
        normal = self.body.denominator(cos) * 2 - self.orbit
        return {FRICTION_UP: mu + half_sin, FRICTION_DOWN: mu - half_sin, NORMAL: normal}

    def _sweep(self, start: Ball, direction: int, length: Ball, ends_at_turn: bool = False) -> tuple[Ball, int] | None:
        """Cover the angles ahead; the first at which a margin vanishes, and its side."""
        whole, done = ends(length)[1], 0.0
        while done < whole:
            center = start + direction * arb(done)
            margins = self._margins(center, direction)
            step = arb(WIDTH)
            if done + WIDTH > whole:
                step = (length - done).upper()
            found = first_crossing(margins, arb(0), step)
            if found is not None:
                if ends_at_turn and not done + found.at < length:
                    raise Undecided("static friction gives way at the turning point")
                return center + direction * found.at, SIDES[found.guard]
            done += WIDTH
        return None

    def _psi(self, theta: Ball) -> Ball:
        z = ((theta - self.bottom) / 2).sin() / self.modulus
        return z.asin()

    def state(self, theta: Ball, elapsed: Ball, direction: int) -> State:
        """Return the state at an angle of the orbit."""
        start = self.start
        if self.kind == "rest":
            rate = arb(0)
        elif self.body.is_balanced:
            rate = start.rate
        else:
            rate = direction * (self.orbit / self.body.denominator(theta.cos()) - 1).sqrt()
        x = start.x - (theta - start.theta)
        return State(start.time + elapsed, theta, rate, arb(0), x, arb(0), arb(0))

    def at_slip(self, slip: Slip) -> State:
        """Return the state where static friction gives way."""
        direction = self.direction if self.kind == "rotation" else self._direction_at(slip.phase)
        if self.body.is_massless:
            return self._massless_at_angle(slip.theta, direction)
        return self.state(slip.theta, self.time(slip.phase), direction)

    def _direction_at(self, phase: Ball) -> int:
        """Return the direction of a libration: in the middle of a swing Φ is a multiple of π."""
        return sign(phase.cos(), "the direction of motion")

    def time(self, phase: Ball) -> Ball:
        """Return the time from the start to a phase."""
        if self.body.is_balanced:
            return (phase - self.first) / abs(self.start.rate)
        period = arb.pi() if self.kind == "libration" else 2 * arb.pi()
        count = int(float(((phase - self.first) / period).mid()))
        if count > 2:
            return self._quadrature(self.first, self.first + period) * count + self._quadrature(
                self.first + period * count, phase
            )
        return self._quadrature(self.first, phase)

    def _quadrature(self, low: Ball, high: Ball) -> Ball:
        # The ends may be balls: between their midpoints Arb integrates, and the rest is a small interval.
        a, b = low.mid(), high.mid()
        total = acb.integral(lambda z, analytic: self._g(z, analytic), acb(a), acb(b))
        if not total.real.is_finite():
            raise Undecided("a time of rolling is not enclosed")
        rest = arb(0)
        for end in (low, high):
            rest += arb(0, (self.rate_of_time(end) * end.rad()).abs_upper())
        return total.real + rest

    def _g(self, phase: Ball, analytic: bool) -> Ball:
        body = self.body
        if self.kind == "libration":
            sin = phase.sin()
            part = sin * sin * (self.modulus * self.modulus)
            bottom = body.inertia + body.mass * (1 - body.h) * (1 - body.h)
            inner = (part * (4 * body.offset) + bottom) / ((1 - part) * body.offset)
        else:
            d = (phase * self.direction + self.turning_angle()).cos() * (2 * body.offset) + body.constant
            inner = d / (self.orbit - d)
        return inner.sqrt(analytic=analytic)

    def turning_angle(self) -> Ball:
        """Return the angle at Φ = 0 of a rotation, in which Φ is the angle in the direction of motion from there on."""
        return self.start.theta - self.direction * self.first

    def _massless(self) -> tuple[Ball, Ball, Ball]:
        """Return whole turns of θ, and z + 2 z′ and z − 2 z′ at the start, z = sin(θ/2): they go like e^±τ/2."""
        start = self.start
        turn = 2 * arb.pi() * round(float((start.theta / (2 * arb.pi())).mid()))
        half = (start.theta - turn) / 2
        z, rate = half.sin(), start.rate * half.cos()
        return turn, z + rate, z - rate

    def _massless_at_time(self, elapsed: Ball) -> State:
        turn, grows, falls = self._massless()
        growth = (elapsed / 2).exp()
        z, double = (grows * growth + falls / growth) / 2, (grows * growth - falls / growth) / 2
        half = z.asin()
        return self._massless_state(turn + 2 * half, double / half.cos(), elapsed)

    def _massless_at_angle(self, theta: Ball, direction: int) -> State:
        turn, grows, falls = self._massless()
        half = (theta - turn) / 2
        rate = direction * (self.orbit / self.body.denominator(theta.cos()) - 1).sqrt()
        z, double = half.sin(), rate * half.cos()
        growth = (z + double) / grows if abs(grows) > abs(falls) else falls / (z - double)
        return self._massless_state(theta, rate, 2 * growth.log())

    def _massless_state(self, theta: Ball, rate: Ball, elapsed: Ball) -> State:
        start = self.start
        x = start.x - (theta - start.theta)
        return State(start.time + elapsed, theta, rate, arb(0), x, arb(0), arb(0))

    def rate_of_time(self, phase: Ball) -> Ball:
        """Return dτ/dΦ on a ball of phases."""
        return self._g(acb(phase), False).real

    def angle(self, phase: Ball) -> Ball:
        """Return the angle at a phase."""
        if self.kind == "libration":
            return self.bottom + 2 * (self.modulus * phase.sin()).asin()
        return self.turning_angle() + self.direction * phase

    def at_time(self, elapsed: Ball) -> State:
        """Return the state at a time."""
        if self.kind == "rest":
            return self.state(self.start.theta, elapsed, 0)
        if self.body.is_massless:
            return self._massless_at_time(elapsed)
        phase = self.phase_at(elapsed)
        if self.kind == "rotation":
            return self.state(self.angle(phase), elapsed, self.direction)
        theta = self.angle(phase)
        # θ′ from Φ: a root of K/D − 1 would lose digits near a turning point.
        root = self.body.denominator(theta.cos()).sqrt()
        rate = 2 * self.body.offset.sqrt() * self.modulus * phase.cos() / root
        x = self.start.x - (theta - self.start.theta)
        return State(self.start.time + elapsed, theta, rate, arb(0), x, arb(0), arb(0))

    def phase_at(self, elapsed: Ball) -> Ball:
        """Invert the time: Newton's method, and an enclosure of its result by dτ/dΦ near it."""
        if self.body.is_balanced:
            return self.first + elapsed * abs(self.start.rate)
        period = arb.pi() if self.kind == "libration" else 2 * arb.pi()
        whole = self._quadrature(self.first, self.first + period)
        count = int(float((elapsed / whole).mid()))
        base = self.first + period * count
        left = elapsed - whole * count
        guess = base.mid() + float(left.mid() / whole.mid()) * period.mid()
        for _ in range(200):
            error = self._quadrature(base, guess) - left
            step = (error / self.rate_of_time(guess)).mid()
            previous, guess = guess, (guess - step).mid()
            if abs(step) < 2.0**-40 and abs(step * step) * 1000 < error.rad() + arb(2) ** -(flint.ctx.prec - 20):
                break
            del previous
        error = self._quadrature(base, guess) - left
        width = arb(2) ** -(flint.ctx.prec // 3)
        width = width.max(abs(error / self.rate_of_time(guess)).upper() * 16)
        near = guess + arb(0, 1) * width
        phase = guess - error / self.rate_of_time(near)
        if not near.contains(phase):
            raise Undecided("a time of rolling is not inverted")
        return phase

    def period(self) -> Ball:
        """Return the time of one turn, or of one swing there and back."""
        if self.body.is_balanced:
            return 2 * arb.pi() / abs(self.start.rate)
        return self._quadrature(self.first, self.first + 2 * arb.pi())
