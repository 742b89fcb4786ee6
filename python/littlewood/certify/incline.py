"""Rolling on a slope: D θ′² is an explicit function of the angle, and time is the quadrature of √(D/G).

G = D θ′² = 2 (E − ℓ cos α cos θ + sin α (m θ + ℓ sin θ)). Pieces and turning points are those of a slide, but u = G/D
is known without a differential equation.
"""

from __future__ import annotations

from collections.abc import Iterator

from .balls import Ball, Undecided, acb, arb, arb_series, flint
from .body import Body, State
from .model import Model
from .phase import Piece
from .rolling import FRICTION_DOWN, FRICTION_UP
from .sliding import Slide

SAMPLED = 4
"""Time up to which rolling that repeats itself is followed at least: its samples are there."""


class Incline(Slide):
    """Rolling on a slope from a state; it is followed through two turning points, or without end."""

    def __init__(self, body: Body, start: State, is_endless: bool) -> None:
        self.body, self.start, self.order, self.is_endless = body, start, 0, is_endless
        self.turns: list[Ball] = []
        """Times from the start at which θ′ vanishes."""
        sin, cos = start.theta.sin(), start.theta.cos()
        self.twice = start.rate * start.rate * body.denominator(cos) - 2 * self._lost(sin, cos, start.theta)

    def pieces(self) -> Iterator[Piece]:
        """Yield the motion piece by piece, up to the second turning point at least."""
        for piece in super().pieces():
            yield piece
            past = piece.elapsed.value(piece.high, piece.high) > SAMPLED
            if past and len(self.turns) > 1 and not self.is_endless:
                return

    def period(self) -> Ball:
        """Return the time of a swing there and back: static friction holds on all of it, there as back."""
        return (self.turns[1] - self.turns[0]) * 2

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
        radius = arb(1)
        for _ in range(60):
            around = acb(theta + arb(0, 1) * radius, arb(0, 1) * radius)
            least = abs(body.denominator(around.cos())).lower()
            if least > 0:
                size = abs(self._lost(around.sin(), around.cos(), around) * 2 + self.twice).abs_upper() / least
                return Model(series, arb((size + u.abs_upper()).abs_upper()), radius)
            radius = (radius * 3 / 4).mid()
        raise Undecided("the discs of rolling are too small")

    def _turning(
        self, theta: Ball, direction: int, distance: Ball, elapsed: Ball, order: int
    ) -> tuple[Piece, Ball, Ball, Ball]:
        made = super()._turning(theta, direction, distance, elapsed, order)
        self.turns.append(made[0].elapsed.value(arb(0), arb(0)))
        return made

    def _guards(self, sin: Model, cos: Model, u: Model, rate: Model, time: Model, order: int) -> dict[str, Model]:
        """Return μs N − F and μs N + F, times D."""
        body = self.body
        d, lever = cos * (2 * body.offset) + body.constant, cos * body.offset + body.mass
        turning = sin * body.offset * (u + body.down) + lever * body.back
        normal = d * (body.mass * body.down) - (sin * turning + cos * u * d) * body.offset
        friction = sin * u * d * body.offset - lever * turning + d * (body.mass * body.back)
        return {FRICTION_UP: normal * body.mu_s - friction, FRICTION_DOWN: normal * body.mu_s + friction}

    def _state(self, theta: Ball, rate: Ball, elapsed: Ball) -> State:
        start, zero = self.start, arb(0)
        return State(start.time + elapsed, theta, rate, zero, start.x - (theta - start.theta), zero, zero)
