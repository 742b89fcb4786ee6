"""Rolling and sliding of a hoop with inertia, by power series in the angle turned.

For where it turns fast enough.

With u = theta'^2 the same balances of momentum are linear in u, so that u, the time and the slip
are quadratures.
"""

import math

import flint
from gmpy2 import mpfr

from .arithmetic import Work
from .roots import arb, first_fall, number, stays


class Arc:
    """One step: series in psi = |theta - theta0|.

    They are those of u, the time, the slip and the way of the contact point, and those of the
    events.
    """

    circles = {}

    def __init__(self, hoop, state, sigma):
        flint.ctx.prec, flint.ctx.cap = Work.bits, Work.order * 3 // 2
        self.terms = flint.ctx.cap
        theta, rate, slip, _ = state
        self.way = 1 if rate > 0 else -1
        down, along = arb(hoop.down), arb(hoop.along)
        m, h, i, mu = map(arb, (hoop.m, hoop.h, hoop.i, hoop.mu_s if sigma is None else hoop.mu_k))
        angle, u0 = arb(theta), arb(rate) ** 2
        s0, c0 = angle.sin(), angle.cos()
        sine, cosine = self.circle()
        s, c = s0 * cosine + self.way * c0 * sine, c0 * cosine - self.way * s0 * sine
        lever = 1 + h * c
        if sigma is None:
            # I a = h s N + (1 + h c) F with N and F linear in a and u, so (D u)' = 2 m (h s cos
            # slope + (1 + h c) sin slope).
            d = i + m * ((h * s) ** 2 + lever * lever)
            pulled = m * (h * s * down + lever * along)
            self.u = (d[0] * u0 + 2 * self.way * pulled.integral()) / d
            a = (m * h * s * self.u + pulled) / d
            n = down - h * (s * a + c * self.u)  # over m, like the next
            f = along + h * s * self.u - lever * a
            if hoop.massless:
                # F/N = -h s/(1 + h c) by the balance of moment alone; N vanishes with F.
                self.events = [
                    (mu * lever - h * s, "slip", 1),
                    (mu * lever + h * s, "slip", -1),
                    (n, "normal_force_zero", 0),
                ]
            else:
                self.events = [(mu * n + f, "slip", 1), (mu * n - f, "slip", -1)]
        else:
            q = h * s - mu * sigma * lever
            pull = m * q / (i + m * h * (s * q))
            growth = (2 * self.way * h * pull * c).integral().exp()
            self.u = (u0 + 2 * self.way * down * (pull * growth).integral()) / growth
            contact = down - h * c * self.u
            a = pull * contact
            n = down - h * (s * a + c * self.u)
            eta = lever * a - h * s * self.u - mu * sigma * n - along  # eta''
        per_rate = self.u.rsqrt()
        self.time = per_rate.integral()
        if sigma is not None:
            self.slip = (eta * per_rate).integral() + arb(slip)
            self.moved = (self.slip * per_rate).integral()
            self.events = [(sigma * self.slip, "stick", 0), (contact, "lift_off", 0)]
        else:
            self.slip = self.moved = None

    @classmethod
    def circle(cls):
        key = Work.bits, flint.ctx.cap
        if key not in cls.circles:
            psi = flint.arb_series([0, 1])
            cls.circles[key] = psi.sin(), psi.cos()
        return cls.circles[key]

    def reach(self):
        """Length of the step by the last two coefficients of each series."""
        fast = log_of(self.u[0]) / 2
        parts = [(self.u, 2 * fast), (self.time, -fast)]
        if self.slip is not None:
            parts.append((self.slip, max(log_of(self.slip[0]), fast)))
        allowed = math.log(Work.error)
        return mpfr(
            0.9
            * math.exp(
                min(
                    [0.7]
                    + [
                        (allowed + size - log_of(p[k])) / k
                        for p, size in parts
                        for k in (self.terms - 1, self.terms - 2)
                        if p[k].mid() != 0
                    ]
                )
            )
        )

    def scaled(self, p, length, known=0):
        """Coefficients of a series over a step.

        Divided by the first `known` powers of the angle.
        """
        length, power, out = arb(length), flint.arb(1), []
        for k in range(known, self.terms):
            out.append(p[k] * power)
            power *= length
        return out

    def fall(self, p, length, known):
        """First psi at which a series falls through zero.

        It is positive behind its start, but for `known` roots there.
        """
        p = self.scaled(p, length, known)
        if stays(p, 1.0):
            return None
        f, d = flint.arb_poly(p), flint.arb_poly(p).derivative()
        at = first_fall(lambda t: number(f(arb(t))), lambda t: number(d(arb(t))), mpfr(0), mpfr(1))
        return None if at is None else at * length

    def value(self, p, psi):
        return mpfr(0) if p is None else number(flint.arb_poly(self.scaled(p, psi))(1))


def log_of(v):
    """Logarithm of a size, of any exponent."""
    size = abs(v.mid())
    return -math.inf if size == 0 else float(size.log())
