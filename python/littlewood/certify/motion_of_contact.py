"""Newton's and Euler's equations in time, by Taylor series of the checker's own: one step of a phase.

A step has the series of θ, θ′, η′, x, the gap and the guards. With |θ′(z) − θ′| ≤ b on the complex disc |z| ≤ ρ, and
|θ″| ≤ M wherever that holds, M ρ ≤ b proves that the solution exists on the disc and stays within these bounds
(Picard), which bound all coefficients (Cauchy). The step goes to an eighth of ρ. The bounds are floats with a margin
of a hundredth.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction

from .ranges import Inconclusive, Range, Series, exceeds, product, sine_and_cosine


@dataclass
class Hoop:
    """The hoop."""

    m: Range
    h: Range
    inertia: Range
    offset: Range
    mu_s: Range
    mu_k: Range

    def compliances(self, sin: Range, cos: Range) -> tuple[Range, Range, Range]:
        """Return A, B, C times m Î, which also a massless hoop has."""
        arm, lever = self.h * sin, 1 + self.h * cos
        return self.inertia + self.m * lever * lever, self.m * arm * lever, self.inertia + self.m * arm * arm


@dataclass
class State:
    """A state."""

    time: Range
    theta: Range
    rate: Range
    slip: Range
    x: Range
    gap: Range
    gap_rate: Range


@dataclass
class Guard:
    """What stays positive: its series, divided by the power of time by which it begins, and a bound on the disc."""

    series: Series
    size: float
    order: int


class Step:
    """One step of a phase."""

    def __init__(
        self, hoop: Hoop, start: State, mode: str, sigma: int, order: int, end: Range | None, shortest: bool
    ) -> None:
        self.hoop, self.start, self.mode, self.sigma = hoop, start, mode, sigma
        self.sin, self.cos = sine_and_cosine(start.theta)
        self.rho, self.spread = self._disc()
        length = Fraction(self.rho / 8)
        if shortest:
            # A short bounce: its two zeros are told apart on a step of its own length.
            w = float(1 - hoop.h * self.cos * start.rate * start.rate)
            if w > 0:
                length = min(length, Fraction(6 * float(start.gap_rate) / w))
        self.length = Range.of(length)
        if end is not None and exceeds(self.length, end - start.time):
            self.length = (end - start.time).least()
        # All that is left out is a power of length/ρ ≤ 1/base.
        longest = Fraction(max(1, self.length.m + self.length.r), 1 << Range.bits) * Fraction(1000001, 1000000)
        self.base = int(Fraction(self.rho) / longest)
        self.terms = int(Range.bits / math.log2(self.base)) + 8 + order
        self._expand(order)

    def _disc(self) -> tuple[float, float]:
        """Return ρ and b."""
        s, c, rate = abs(float(self.sin)), abs(float(self.cos)), abs(float(self.start.rate))
        if self.mode == "flight":
            return 1 / (1 + rate), 0.0
        best = (0.0, 0.0)
        for part in (0.1, 0.2, 0.4, 0.8):
            b = part * (1 + rate)
            low, high = 0.0, 2.0
            for _ in range(24):
                rho = (low + high) / 2
                if self._largest(s, c, rate + b, rho) * rho * 1.01 <= b:
                    low = rho
                else:
                    high = rho
            best = max(best, (low, b))
        if best[0] < 1e-9:
            raise Inconclusive("the step is too short")
        return best

    def _largest(self, s: float, c: float, rate: float, rho: float) -> float:
        """Bound |θ″|."""
        hoop = self.hoop
        turn = rate * rho * 1.01
        if turn > 3:
            return math.inf
        ds = s * (math.cosh(turn) - 1) + c * math.sinh(turn)
        dc = c * (math.cosh(turn) - 1) + s * math.sinh(turn)
        h, m, mu, ell = (float(v) for v in (hoop.h, hoop.m, hoop.mu_k, hoop.offset))
        w = 1 + h * (c + dc) * rate * rate
        if self.mode == "rolling":
            d = float(self._d()) - 2 * ell * dc
            return 1.01 * ell * (s + ds) * (1 + rate * rate) / d if d > 1e-12 else math.inf
        if self.mode == "gliding":
            d = h * (s - ds)
            return 1.01 * w / d if d > 1e-12 else math.inf
        d = float(self._p()) - m * h * (h * ds * (2 * s + ds) + mu * ds + mu * h * (s * dc + c * ds + ds * dc))
        q = h * (s + ds) + mu * (1 + h * (c + dc))
        return 1.01 * m * q * w / d if d > 1e-12 else math.inf

    def _d(self) -> Range:
        hoop = self.hoop
        return hoop.inertia + hoop.m * (1 + hoop.h * hoop.h) + 2 * (hoop.offset * self.cos)

    def _p(self) -> Range:
        _, b, c = self.hoop.compliances(self.sin, self.cos)
        return c - self.hoop.mu_k * b * self.sigma

    def _expand(self, order: int) -> None:
        hoop, start, n, sigma = self.hoop, self.start, self.terms, self.sigma
        h, ell = hoop.h, hoop.offset
        f = hoop.mu_k * sigma if self.mode == "sliding" else Range(0)
        s, c = Series(self.sin), Series(self.cos)
        theta, omega = Series(start.theta), Series(start.rate)
        u, cu, su, sg, cg, g = Series(), Series(), Series(), Series(), Series(), Series()
        q, w, p, sq, normal, force = Series(), Series(), Series(), Series(), Series(), Series()
        slip, x, gap = Series(start.slip), Series(start.x), Series(start.gap)
        divisor = Series()
        # The mass centre: its velocity along the plane, and its height 1 + y + h cos θ.
        along = start.slip - (1 + h * self.cos) * start.rate
        up = start.gap_rate - h * self.sin * start.rate
        one = Range(1 << Range.bits)
        flight, rolling = self.mode == "flight", self.mode == "rolling"
        for k in range(n):
            unit = one if k == 0 else Range(0)
            if flight:
                acceleration = Range(0)
            else:
                u.append(product(omega, omega, k))
                cu.append(product(c, u, k))
                w.append(unit - h * cu[k])
                if rolling:
                    su.append(product(s, u, k))
                    above = ell * (s[k] + su[k])
                    divisor.append(2 * (ell * c[k]) + (self._d() - 2 * (ell * self.cos) if k == 0 else Range(0)))
                elif self.mode == "gliding":
                    above = w[k]
                    divisor.append(h * s[k])
                else:
                    q.append(h * s[k] - f * (unit + h * c[k]))
                    sq.append(product(s, q, k))
                    p.append(hoop.m * h * sq[k] + (hoop.inertia if k == 0 else Range(0)))
                    above = hoop.m * product(q, w, k)
                    divisor = p
                g.append(Range(0))
                acceleration = (above - product(divisor, g, k)) / divisor[0]
                g.replace_last(acceleration)
            if rolling:
                sg.append(product(s, g, k))
                cg.append(product(c, g, k))
                normal.append((hoop.m if k == 0 else Range(0)) - ell * (sg[k] + cu[k]))
                force.append(ell * (su[k] - cg[k]) - hoop.m * g[k])
            theta.append(omega[k] / (k + 1))
            omega.append(acceleration / (k + 1))
            s.append(product(c, omega, k) / (k + 1))
            c.append(-product(s, omega, k) / (k + 1))
            # x′ = η′ − θ′, η′ from the velocity of the mass centre, m x̄″ = −f N = −f (m ȳ″ + m).
            x.append((slip[k] - omega[k]) / (k + 1))
            if rolling:
                slip.append(Range(0))
            else:
                slip.append(self._slip(k + 1, along, f, c, s, omega))
            if flight:
                gap.append(self._gap(k + 1, up, c))
        self.series = {"theta": theta, "theta_rate": omega, "slip": slip, "x": x, "gap": gap}
        self.half_turn = (s, c, u)
        self._bounds(f, normal, force, w, p, slip, gap, order)

    def _slip(self, k: int, along: Range, f: Range, c: Series, s: Series, omega: Series) -> Range:
        """Return coefficient k ≥ 1 of η′ = x̄′ + (1 + h c) θ′, x̄′ = const − f (ȳ′ + τ), ȳ′ = −h s θ′."""
        h = self.hoop.h
        del along
        value = omega[k] + h * product(c, omega, k) + f * h * product(s, omega, k)
        return value - f if k == 1 else value

    def _gap(self, k: int, up: Range, c: Series) -> Range:
        """Return coefficient k ≥ 1 of y = ȳ − 1 − h c, ȳ″ = −1."""
        if k == 1:
            del up
            return self.start.gap_rate
        value = -(self.hoop.h * c[k])
        return value - Range.of(Fraction(1, 2)) if k == 2 else value

    def _bounds(
        self, f: Range, normal: Series, force: Series, w: Series, p: Series, slip: Series, gap: Series, order: int
    ) -> None:
        hoop, start, rho = self.hoop, self.start, self.rho
        rate = abs(float(start.rate)) + self.spread
        turn = math.cosh(min(3.0, rate * rho))
        h, m, mu, ell = (abs(float(v)) for v in (hoop.h, hoop.m, hoop.mu_k, hoop.offset))
        largest = self.spread / rho
        speed = rate * (1 + 2 * h * turn * (1 + mu)) + mu * rho + abs(float(start.slip)) + 1
        height = 2 + abs(float(start.gap)) + abs(float(start.gap_rate)) + 4 * h * turn * (1 + rate)
        self.size = {
            "theta": abs(float(start.theta)) + rate * rho,
            "theta_rate": rate,
            "slip": 2 * speed,
            "x": abs(float(start.x)) + 4 * speed,
            "gap": height,
        }
        pressed = m + ell * turn * (largest + rate**2)
        rubbed = ell * turn * rate**2 + (m + ell * turn) * largest
        self.guards: dict[str, Guard] = {}
        if self.mode == "rolling" and hoop.inertia.is_zero():
            # F/N = −tan(θ/2), and N has the sign of 1 − θ′²: where N vanishes F does, too.
            unloads, up, down = Series(), Series(), Series()
            for k in range(self.terms):
                one = Range(1 << Range.bits if k == 0 else 0)
                grip = hoop.mu_s * (one + self.half_turn[1][k])
                unloads.append(one - self.half_turn[2][k])
                up.append(grip + self.half_turn[0][k])
                down.append(grip - self.half_turn[0][k])
            most = (1 + float(hoop.mu_s)) * (1 + turn)
            self.guards["normal"] = Guard(unloads, 1 + rate**2, 0)
            self.guards["margin_positive"] = Guard(up, most, 0)
            self.guards["margin_negative"] = Guard(down, most, 0)
            return
        if self.mode == "rolling":
            for name, side in (("margin_positive", 1), ("margin_negative", -1)):
                margin = Series()
                for k in range(self.terms):
                    margin.append(hoop.mu_s * normal[k] - force[k] * side)
                self.guards[name] = Guard(margin, float(hoop.mu_s) * pressed + rubbed, 0)
            return
        if self.mode == "flight":
            self.guards["gap"] = Guard(gap.without(order), height / rho**order, order)
            return
        signed = Series()
        for k in range(self.terms):
            signed.append(slip[k] * self.sigma)
        self.guards["slip"] = Guard(signed.without(order), 2 * speed / rho**order, order)
        if self.mode == "sliding":
            self.guards["contact"] = Guard(w, 1 + h * turn * rate**2, 0)
            self.guards["solvability"] = Guard(
                p, float(hoop.inertia) + m * h * turn * (h * turn + mu * (1 + h * turn)), 0
            )

    def value(self, guard: Guard, time: Range) -> Range:
        """Return a guard at a time from the start of the step."""
        return self._sum(guard.series, guard.size, guard.order, time)

    def slope(self, guard: Guard, low: Range, high: Range) -> Range:
        """Enclose the derivative of a guard between two times."""
        middle, half = (low + high) / 2, ((high - low) / 2).largest()
        top = high.largest()
        first, second = Range(0), Range(0)
        for k in range(len(guard.series.m) - 1, 0, -1):
            first = first * middle + guard.series[k] * k
            if k > 1:
                second = second * top + guard.series[k].largest() * (k * (k - 1))
        n = self.terms - guard.order
        more = self._rest(guard.size / self.rho**2, 2 * n * n, n - 2) + second * half
        return first.widened(more.largest())

    def between(self, guard: Guard, low: Range, high: Range) -> Range:
        """Enclose a guard between two times."""
        middle, half = (low + high) / 2, ((high - low) / 2).largest()
        slope = self.slope(guard, low, high)
        return self.value(guard, middle).widened((slope.largest() * half).largest())

    def state(self, time: Range) -> State:
        """Return the state at a time from the start of the step."""
        at = {name: self._sum(series, self.size[name], 0, time) for name, series in self.series.items()}
        gap_rate = Range(0)
        if self.mode == "flight":
            sin, _ = sine_and_cosine(at["theta"])
            gap_rate = self.start.gap_rate - time + self.hoop.h * (sin - self.sin) * self.start.rate
        else:
            at["gap"] = Range(0)
        slip = Range(0) if self.mode == "rolling" else at["slip"]
        return State(self.start.time + time, at["theta"], at["theta_rate"], slip, at["x"], at["gap"], gap_rate)

    def landing_rate(self, time: Range) -> Range:
        """Return y′ where y = 0, in the step that begins there: 2 y/τ = 0 is subtracted, so that no radius doubles."""
        gap, total = self.series["gap"], Range(0)
        for k in range(len(gap.m) - 1, 2, -1):
            total = total * time + gap[k] * (k - 2)
        rest = self._rest(self.size["gap"] / self.rho, 2 * self.terms, self.terms - 1)
        return (total * time * time - self.start.gap_rate).widened(rest)

    def _sum(self, series: Series, size: float, order: int, time: Range) -> Range:
        total = Range(0)
        for k in range(len(series.m) - 1, -1, -1):
            total = total * time + series[k]
        n = self.terms - order
        return total.widened(self._rest(size, 2, n))

    def _rest(self, size: float, factor: int, power: int) -> Range:
        """Return size times factor over base^power, rounded up."""
        return Range(int(Fraction(size) * factor * (1 << Range.bits) / self.base**power) + 2)
