"""Sliding: the linear equation of u = θ′² in the angle, by Taylor series.

du/dθ = 2 m q (cos α − h c u)/P has coefficients that are analytic where P ≠ 0. On a disc |z − θ| ≤
r of the complex plane on which |2 m q/P| ≤ a and |2 m h q c/P| ≤ b, Gronwall's lemma gives |u| ≤
(|u0| + a r) exp(b r), which bounds every coefficient of the series. Time is the integral of dθ/√u
where u ≠ 0. Near a turning point θt, where u has a simple zero, the parameter is ξ with θ = θt − d
ξ²: there u = ξ² V with V ≠ 0, and dτ = 2 dξ/√V is regular. Slip and place follow from two first
integrals.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from .balls import Ball, Undecided, arb, arb_series, discs, flint, sign
from .body import Body, State, Value
from .model import Model, first_crossing, polynomial, sine_and_cosine
from .phase import Piece

SLIP, CONTACT, SOLVABLE = "slip", "contact", "solvability"


class Slide:
    """A slide from a state in a direction; the slip begins with a zero of this order.

    With rolling resistance it turns in one direction, `rotation`, and ends where θ′ vanishes.
    """

    singular = "the slide runs into P = 0, where its force is unbounded"

    def __init__(self, body: Body, start: State, sigma: int, order: int, rotation: int = 0) -> None:
        self.body, self.start, self.sigma, self.order = body, start, sigma, order
        self.rotation = rotation
        self.friction = body.mu_k * sigma
        self.drag = self.friction * body.down + body.back
        sin, cos = start.theta.sin(), start.theta.cos()
        self.slip_constant = start.slip - start.rate * self._arm(sin, cos)
        # x̄ + f ȳ + (f cos α + sin α) τ²/2 = a + b τ
        self.place = start.x - body.h * sin + self.friction * (1 + body.h * cos)
        self.place_rate = (
            start.slip - (1 + body.h * cos) * start.rate - self.friction * body.h * sin * start.rate
        )

    def pieces(self) -> Iterator[Piece]:
        """Yield the slide piece by piece."""
        theta, rate, elapsed = self.start.theta, self.start.rate, arb(0)
        order = self.order
        direction = sign(rate, "θ′")
        if direction == 0:
            # From rest it turns at once.
            direction = -sign(self._leaves(theta.sin(), theta.cos()), "θ″ at rest")
            if direction == 0:
                raise Undecided("the motion begins in an equilibrium of θ")
            piece, theta, u, elapsed = self._turning(theta, direction, arb(0), elapsed, order)
            yield piece
            direction, order = -direction, 0
        else:
            u = rate * rate
        while True:
            family = self._family(theta, u, direction)
            radius, smallest, largest = self._free_of_zeros(family, u)
            turn = None
            if order == 0 and radius < family.radius / 3:
                turn = self._turning_point(family)
            if turn is not None:
                try:
                    made = self._turning(theta + direction * turn, direction, turn, elapsed, 0)
                except Undecided:
                    made = None
                if made is not None:
                    piece, theta, u, elapsed = made
                    if self.rotation:
                        # What follows beyond it has another equation.
                        yield replace(piece, high=arb(0))
                        return
                    yield piece
                    direction = -direction
                    continue
            piece, theta, u, elapsed = self._regular(
                family, theta, direction, (radius, smallest, largest), elapsed, order
            )
            yield piece
            order = 0

    def _equation(self, sin: Value, cos: Value) -> tuple[Value, Value, Value]:
        """Return f, g and p of du/dθ = 2 m (f + g u)/p."""
        body = self.body
        q = body.q(sin, cos, self.sigma, self.rotation)
        return q * body.down, q * cos * -body.h, self._solvability(sin, cos)

    def _solvability(self, sin: Value, cos: Value) -> Value:
        return self.body.solvability(sin, cos, self.sigma, self.rotation)

    def _leaves(self, sin: Ball, cos: Ball) -> Ball:
        """Return a number that has the sign of θ″ at rest."""
        f, _, p = self._equation(sin, cos)
        return f * p

    def _arm(self, sin: Ball, cos: Ball) -> Ball:
        return 1 + self.body.h * cos + self.friction * self.body.h * sin

    def _family(self, theta: Ball, u: Ball, direction: int) -> Model:
        """Return u(θ + direction s) with this value at s = 0."""
        n, twice = flint.ctx.cap, 2 * self.body.mass
        angle = arb_series([theta, direction], n)
        f, g, p = self._equation(angle.sin(), angle.cos())
        factor = (g * (twice * direction) / p).integral().exp()
        series = factor * (u + (f * (twice * direction) / p / factor).integral())
        for radius, around in discs(theta, arb(1)):
            f, g, p = self._equation(around.sin(), around.cos())
            least = abs(p).lower()
            if least > 0:
                size = (twice * abs(f)).abs_upper() / least
                growth = (twice * abs(g)).abs_upper() / least * radius
                if growth < 12:
                    bound = (u.abs_upper() + size * radius) * growth.exp()
                    return Model(
                        arb_series([series[k] for k in range(n)], n), arb(bound.abs_upper()), radius
                    )
        raise Undecided(self.singular)

    @staticmethod
    def _free_of_zeros(family: Model, first: Ball) -> tuple[Ball, Ball, Ball]:
        """Return a radius within which |u| stays away from 0.

        With it come its least and its largest value there.
        """
        radius = (family.radius * 3 / 4).mid()
        for _ in range(400):
            spread = _spread(family, radius)
            if spread < 0.9375 * first:
                return radius, (first - spread).lower(), (first + spread).upper()
            radius = (radius * 3 / 4).mid()
        raise Undecided("θ′ may be 0")

    @staticmethod
    def _turning_point(family: Model) -> Ball | None:
        try:
            found = first_crossing({"u": family}, arb(0), family.radius / 4, 24)
        except Undecided:
            return None
        return None if found is None else found.at

    def _regular(
        self,
        family: Model,
        theta: Ball,
        direction: int,
        free: tuple[Ball, Ball, Ball],
        elapsed: Ball,
        order: int,
    ) -> tuple[Piece, Ball, Ball, Ball]:
        radius, smallest, largest = free
        u = Model(family.series, largest, radius)
        root = Model(u.series.rsqrt(), 1 / smallest.sqrt(), radius)
        rate = Model(u.series.sqrt() * direction, largest.sqrt(), radius)
        time = root.integral(elapsed)
        sin, cos = sine_and_cosine(theta, direction, radius)
        high = (radius / 4).mid()

        def state(at: Ball) -> State:
            return self._state(theta + direction * at, rate.value(at, at), time.value(at, at))

        swept = (cos * u).integral(arb(0)) if self.rotation else None
        guards = self._guards(sin, cos, u, rate, time, order)
        piece = Piece(arb(0), high, time, guards, state, swept)
        return piece, theta + direction * high, u.value(high, high), time.value(high, high)

    def _turning(
        self, theta: Ball, direction: int, distance: Ball, elapsed: Ball, order: int
    ) -> tuple[Piece, Ball, Ball, Ball]:
        """Return the piece around a turning point, which is at this distance ahead."""
        family = self._family(theta, arb(0), -direction)
        v = family.without_zero(1)
        first = v.series[0]
        if not first > 0:
            raise Undecided("θ′ and θ″ vanish together")
        square, smallest, largest = self._free_of_zeros(v, first)
        radius = square.sqrt()
        v = Model(v.series, largest, square)
        root = Model(v.series.rsqrt() * 2, 2 / smallest.sqrt(), square).of_square(radius)
        speed = Model(v.series.sqrt(), largest.sqrt(), square).of_square(radius)
        xi = polynomial([arb(0), arb(1)], radius)
        rate = speed * xi * (-direction)
        u = v.of_square(radius) * polynomial([arb(0), arb(0), arb(1)], radius)
        low = -distance.sqrt() if not distance.is_zero() else arb(0)
        if not abs(low) < radius / 2:
            raise Undecided("the turning point is too far")
        time = root.integral(arb(0))
        time = time + (elapsed - time.value(low, low))
        sin, cos = (one.of_square(radius) for one in sine_and_cosine(theta, -direction, square))

        def state(at: Ball) -> State:
            return self._state(theta - direction * at * at, rate.value(at, at), time.value(at, at))

        high = (radius / 4).mid()
        # |dθ| = 2 |ξ| dξ: with resistance a piece ends or begins where ξ = 0.
        outward = 1 if distance.is_zero() else -1
        swept = (cos * u * xi * (2 * outward)).integral(arb(0)) if self.rotation else None
        guards = self._guards(sin, cos, u, rate, time, order)
        piece = Piece(low, high, time, guards, state, swept)
        return piece, theta - direction * high * high, u.value(high, high), time.value(high, high)

    def _guards(
        self, sin: Model, cos: Model, u: Model, rate: Model, time: Model, order: int
    ) -> dict[str, Model]:
        body = self.body
        arm = cos * body.h + sin * (self.friction * body.h) + 1
        slip = (rate * arm - time * self.drag + self.slip_constant) * self.sigma
        return {
            SLIP: slip.without_zero(order),
            CONTACT: body.down - cos * u * body.h,
            SOLVABLE: self._solvability(sin, cos),
        }

    def _state(self, theta: Ball, rate: Ball, elapsed: Ball) -> State:
        sin, cos = theta.sin(), theta.cos()
        slip = self.slip_constant + rate * self._arm(sin, cos) - self.drag * elapsed
        h = self.body.h
        x = self.place + self.place_rate * elapsed + h * sin
        x -= self.friction * (1 + h * cos) + self.drag * elapsed * elapsed / 2
        return State(self.start.time + elapsed, theta, rate, slip, x, arb(0), arb(0))


def _spread(function: Model, radius: Ball) -> Ball:
    """Bound |f(s) − f(0)| where |s| ≤ radius."""
    total, power, n = arb(0), arb(1), int(function.series.prec)
    for k in range(1, n):
        power = power * radius
        total += abs(function.series[k]) * power
    part = radius / function.radius
    return (total + function.size * part**n / (1 - part)).upper()
