"""Rolling: D θ′² is an explicit function of the angle, and time is the quadrature of √(D/G).

G = D θ′² = 2 (E − ℓ cos α cos θ + sin α (m θ + ℓ sin θ)). Pieces and turning points are those of a
slide, but u = G/D is known without a differential equation. What has turned twice, or once around
on a level plane, repeats itself: static friction holds on all of it, there as back.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from .balls import Ball, Undecided, arb, arb_series, discs, flint, sign
from .body import Body, State
from .model import Model
from .phase import Followed, Piece
from .sliding import Slide

FRICTION_UP, FRICTION_DOWN = "margin_positive", "margin_negative"
"""μs N − F and μs N + F, times a positive number."""

NORMAL = "normal"
"""The normal force of a massless hoop, times a positive number."""

SIDES = {FRICTION_UP: 1, FRICTION_DOWN: -1, NORMAL: 0}


class Roll(Slide):
    """Rolling from a state, followed until it repeats itself."""

    def __init__(self, body: Body, start: State) -> None:
        self.body, self.start, self.order, self.rotation = body, start, 0, 0
        self.turns: list[Ball] = []
        """Times from the start at which θ′ vanishes."""
        self.period: Ball | None = None
        """The time after which it repeats itself, turned by `angle`."""
        self.angle = arb(0)
        sin, cos = start.theta.sin(), start.theta.cos()
        self.twice = start.rate * start.rate * body.denominator(cos) - 2 * self._lost(
            sin, cos, start.theta
        )
        self.rests = (
            body.is_level and start.rate.is_zero() and (body.is_balanced or start.theta.is_zero())
        )
        if (
            body.is_level
            and not self.rests
            and sign(self.twice - 2 * body.offset, "the energy over the top") == 0
        ):
            raise Undecided("the orbit is the separatrix")

    @property
    def recurrence(self) -> str:
        """How it repeats itself."""
        return "rest" if self.rests else "libration" if self.angle.is_zero() else "rotation"

    def pieces(self) -> Iterator[Piece]:
        """Yield the motion piece by piece, until it repeats itself."""
        start, whole = self.start.theta, 2 * arb.pi()
        for piece in super().pieces():
            yield piece
            low, high = (abs(piece.state(at).theta - start) for at in (piece.low, piece.high))
            if self.period is None and len(self.turns) > 1:
                self.period = (self.turns[1] - self.turns[0]) * 2
            elif self.body.is_level and not self.turns and high > whole:
                self.period = piece.elapsed.value(whole - low, whole - low)
                self.angle = whole * sign(self.start.rate, "θ′")
            if (
                self.period is not None
                and piece.elapsed.value(piece.high, piece.high) > self.period
            ):
                return

    def at(self, found: Followed, time: Ball) -> State:
        """Return the state at a time of the motion whose pieces have been followed."""
        if self.rests:
            return replace(self.start, time=time)
        if self.period is None:
            return found.at(self.start.time, time)
        count = int(float(((time - self.start.time) / self.period).mid()))
        one, angle = found.at(self.start.time, time - self.period * count), self.angle * count
        return replace(one, time=time, theta=one.theta + angle, x=one.x - angle)

    def _lost(self, sin: Ball, cos: Ball, theta: Ball) -> Ball:
        """Return the potential energy that has been lost at an angle, but for a constant."""
        body = self.body
        return (theta * body.mass + sin * body.offset) * body.back - cos * (body.offset * body.down)

    def _leaves(self, sin: Ball, cos: Ball) -> Ball:
        body = self.body
        return body.offset * sin * body.down + (body.mass + body.offset * cos) * body.back

    def _family(self, theta: Ball, u: Ball, direction: int) -> Model:
        body, n = self.body, flint.ctx.cap
        angle = arb_series([theta, direction], n)
        sin, cos = angle.sin(), angle.cos()
        series = (self._lost(sin, cos, angle) * 2 + self.twice) / body.denominator(cos)
        # At a turning point the first coefficient is 0.
        series = arb_series([u, *(series[k] for k in range(1, n))], n)
        for radius, around in discs(theta, arb(1)):
            least = abs(body.denominator(around.cos())).lower()
            if least > 0:
                size = (
                    abs(self._lost(around.sin(), around.cos(), around) * 2 + self.twice).abs_upper()
                    / least
                )
                return Model(series, arb((size + u.abs_upper()).abs_upper()), radius)
        raise Undecided("the discs of rolling are too small")

    def _turning(
        self, theta: Ball, direction: int, distance: Ball, elapsed: Ball, order: int
    ) -> tuple[Piece, Ball, Ball, Ball]:
        made = super()._turning(theta, direction, distance, elapsed, order)
        self.turns.append(made[0].elapsed.value(arb(0), arb(0)))
        return made

    def _guards(
        self, sin: Model, cos: Model, u: Model, rate: Model, time: Model, order: int
    ) -> dict[str, Model]:
        """Return μs N − F and μs N + F, times D.

        Without mass, where F/N = −tan(θ/2), that and the sign of N.
        """
        body = self.body
        if body.is_massless:
            grip = (cos + 1) * body.mu_s
            return {FRICTION_UP: grip + sin, FRICTION_DOWN: grip - sin, NORMAL: 1 - u}
        d, lever = cos * (2 * body.offset) + body.constant, cos * body.offset + body.mass
        turning = sin * body.offset * (u + body.down) + lever * body.back
        normal = d * (body.mass * body.down) - (sin * turning + cos * u * d) * body.offset
        friction = sin * u * d * body.offset - lever * turning + d * (body.mass * body.back)
        return {
            FRICTION_UP: normal * body.mu_s - friction,
            FRICTION_DOWN: normal * body.mu_s + friction,
        }

    def _state(self, theta: Ball, rate: Ball, elapsed: Ball) -> State:
        start, zero = self.start, arb(0)
        return State(
            start.time + elapsed, theta, rate, zero, start.x - (theta - start.theta), zero, zero
        )
