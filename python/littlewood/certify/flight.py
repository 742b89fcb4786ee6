"""Flight: θ′ is constant, the mass centre falls freely, and the gap is in closed form."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from .balls import Ball, Undecided, arb, arb_series, flint
from .body import Body, State
from .model import Model, polynomial
from .phase import Piece

GAP = "gap"


class Flight:
    """A flight from a state with no gap; the gap begins with a zero of this order."""

    def __init__(self, body: Body, start: State, order: int) -> None:
        self.body, self.start, self.order = body, start, order
        self.sin, self.cos = start.theta.sin(), start.theta.cos()
        self.rise = start.gap_rate - body.h * self.sin * start.rate
        self.centre_rate = start.slip - (1 + body.h * self.cos) * start.rate

    def pieces(self) -> Iterator[Piece]:
        """Yield the flight piece by piece."""
        speed = abs(self.start.rate).upper()
        radius = arb(1) / (1 + speed.mid()).mid() if speed > 1 else arb(1)
        radius = radius.mid()
        step = (radius / 4).mid()
        elapsed, order = arb(0), self.order
        if self.order == 1:
            # A short bounce needs a short piece, so that its two zeros are told apart by the slope.
            step = (
                step.min(arb(4) * self.start.gap_rate.mid()).mid()
                if self.start.gap_rate < 1
                else step
            )
        while True:
            gap = self._gap(elapsed, radius).without_zero(order)
            time = polynomial([elapsed, arb(1)], radius)
            yield Piece(arb(0), step, time, {GAP: gap}, self._at(elapsed))
            elapsed, order = elapsed + step, 0
            high = self._high(elapsed)
            if high is not None and high > 8 * step:
                bound = [
                    self._below(elapsed),
                    self.rise - self.body.down * elapsed,
                    -self.body.down / 2,
                ]
                time = polynomial([elapsed, arb(1)], 2 * high)
                yield Piece(
                    arb(0), high, time, {GAP: polynomial(bound, 2 * high)}, self._at(elapsed)
                )
                elapsed = elapsed + high
            step = (step * 2).mid().min((radius / 4).mid()).mid()

    def _thrown(self, elapsed: Ball) -> Ball:
        """Return how far the mass centre has risen from the plane."""
        return self.rise * elapsed - self.body.down * elapsed * elapsed / 2

    def _below(self, elapsed: Ball) -> Ball:
        """Return a lower bound of the gap, in which the height of the mass centre falls freely."""
        return self._thrown(elapsed) - self.body.h * (1 - self.cos)

    def _high(self, elapsed: Ball) -> Ball | None:
        """Return for how long the mass centre is too high for a landing.

        A fast hoop turns many times meanwhile.
        """
        least = self.body.h * (2 - self.cos)
        if not self._below(elapsed) > self.body.h:
            return None
        down = self.body.down
        return (
            (self.rise + (self.rise * self.rise - 2 * down * least).sqrt()) / down - elapsed
        ).mid()

    def _at(self, elapsed: Ball):  # type: ignore[no-untyped-def]
        return lambda at: self.state(elapsed + at)

    def _gap(self, elapsed: Ball, radius: Ball) -> Model:
        start, h = self.start, self.body.h
        n = flint.ctx.cap
        angle = arb_series([start.theta + start.rate * elapsed, start.rate], n)
        turning = Model(angle.cos() * (-h), h * (abs(start.rate) * radius).cosh(), radius)
        down = self.body.down
        rest = [self._thrown(elapsed) + h * self.cos, self.rise - down * elapsed, -down / 2]
        gap = turning + polynomial(rest, radius)
        if not elapsed.is_zero():
            return gap
        # The first two coefficients are known: sums would add radii to them.
        first = [arb(0), start.gap_rate] + [gap.series[k] for k in range(2, n)]
        return Model(arb_series(first, n), gap.size, radius)

    def state(self, elapsed: Ball) -> State:
        """Return the state at a time from the start of the flight."""
        start, h = self.start, self.body.h
        turned = start.rate * elapsed
        half, middle = (turned / 2).sin() * 2, start.theta + turned / 2
        sin_grows, cos_grows = half * middle.cos(), -half * middle.sin()
        down, back = self.body.down, self.body.back
        gap = self._thrown(elapsed) - h * cos_grows
        return State(
            start.time + elapsed,
            start.theta + turned,
            start.rate,
            start.slip + h * cos_grows * start.rate - back * elapsed,
            start.x + self.centre_rate * elapsed + h * sin_grows - back * elapsed * elapsed / 2,
            gap,
            start.gap_rate - down * elapsed + h * sin_grows * start.rate,
        )

    def short(self) -> State:
        """Return the landing of a short flight out of an impact.

        f(τ) = y/τ = v − w τ/2 − h (c C(φ) + s S(φ))/τ falls on the whole interval, as the
        derivative of its last term is at most h (|θ′|⁴ τ²/8 + |θ′|³ τ/3) cosh φ. So it has one
        zero, which Newton's method encloses.
        """
        start, h = self.start, self.body.h
        w, v, speed = self.body.contact(start.theta, start.rate), start.gap_rate, abs(start.rate)
        if not w > 0:
            raise Undecided("a short bounce is not pulled back")
        longest = (4 * v / w).upper()
        bend = h * (speed**4 * longest**2 / 8 + speed**3 * longest / 3) * (speed * longest).cosh()
        slope = -w / 2 + arb(0, 1) * bend.upper()

        def f(time: Ball) -> Ball:
            turned = start.rate * time
            return (
                v - w * time / 2 - h * (self.cos * _even(turned) + self.sin * _odd(turned)) / time
            )

        if not (slope < 0 and f(longest) < 0):
            raise Undecided("a short bounce is not short")
        guess = (2 * v / w).mid()
        for _ in range(60):
            time = guess - f(guess) / slope
            if abs(time.mid() - guess) <= time.rad():
                break
            guess = time.mid()
        return self.landing(self.state(time))

    def unit(self, at: State) -> State | None:
        """Return slip and gap rate at the landing of a short flight, over the gap rate there.

        The flight has no slip at its start.

        Written without that rate, so that its radius does not grow from bounce to bounce.
        """
        start, h = self.start, self.body.h
        phi = start.rate * (at.time - start.time)
        if not (start.slip.is_zero() and abs(phi) < 0.5):
            return None
        fourth, third, second = (_tail(phi, n) for n in (4, 3, 2))
        w, turned = self.body.contact(start.theta, start.rate), h * start.rate**2
        time = 2 / (w + 2 * turned * phi * (self.cos * phi * fourth + self.sin * third))
        closing = time * (w + turned * phi * (self.cos * phi * third + self.sin * second)) - 1
        slip = (
            -turned
            * time
            * (self.sin * (1 - phi**2 * third) + self.cos * phi * (arb(0.5) - phi**2 * fourth))
        )
        slip -= self.body.back * time
        return replace(at, rate=arb(0), slip=slip, gap_rate=-closing)

    def landing(self, at: State) -> State:
        """Return the state at the time at which the gap vanishes.

        y = 0 says what w τ is, and with it the gap rate is −v and a small term: so its radius does
        not grow from bounce to bounce.
        """
        start, h = self.start, self.body.h
        elapsed = at.time - start.time
        turned = start.rate * elapsed
        even, odd = _even(turned), _odd(turned)
        bend = h * (self.cos * even + self.sin * odd) / elapsed * 2
        bend -= h * start.rate * (self.cos * odd + self.sin * (turned / 2).sin() ** 2 * 2)
        return replace(at, gap=arb(0), gap_rate=bend - start.gap_rate)


def _even(phi: Ball) -> Ball:
    """Return cos φ − 1 + φ²/2."""
    return phi**4 * _tail(phi, 4) if abs(phi) < 0.5 else phi.cos() - 1 + phi * phi / 2


def _odd(phi: Ball) -> Ball:
    """Return φ − sin φ."""
    return phi**3 * _tail(phi, 3) if abs(phi) < 0.5 else phi - phi.sin()


def _tail(phi: Ball, first: int) -> Ball:
    """Return 1/n! − φ²/(n + 2)! + φ⁴/(n + 4)! − …, whose terms decrease."""
    term, total, n = 1 / arb(first + 1).gamma(), arb(0), first
    while True:
        total += term
        term = -term * phi * phi / ((n + 1) * (n + 2))
        n += 2
        if abs(term) < abs(total) * arb(2) ** (-flint.ctx.prec) or n > 400:
            return total + arb(0, abs(term).upper())
