"""An impact, followed in the normal impulse from event to event."""

import gmpy2
from gmpy2 import mpfr

from .arithmetic import Tie


class Contact:
    """The rim at the plane.

    How slip, rate of the gap and spin answer to an impulse (friction, normal).
    """

    def __init__(self, hoop, theta):
        s, c = gmpy2.sin_cos(theta)
        self.hoop, self.arm, self.lever = hoop, hoop.h * s, 1 + hoop.h * c

    def change(self, friction):
        """Change of (spin, slip, gap rate) by a unit of normal impulse, with so much friction."""
        spin = (self.arm + self.lever * friction) / self.hoop.i
        return spin, friction / self.hoop.m + self.lever * spin, 1 / self.hoop.m + self.arm * spin

    def friction(self, slips):
        """Friction over normal impulse, and the way of the slip, which friction opposes.

        At rest it is what keeps it so, if static friction can.
        """
        if not slips:
            free = self.change(mpfr(0))[1]
            hold = -free / (self.change(mpfr(1))[1] - free)
            if abs(hold) <= self.hoop.mu_s:
                return hold, 0
            slips = 1 if free > 0 else -1
        return -self.hoop.mu_k * slips, slips


def impact(hoop, theta, velocities, restitution, law):
    """(rate, slip, gap rate) after an impact, from those before it."""
    contact = Contact(hoop, theta)
    rate, slip, opening = velocities
    closing, slips = -opening, int(gmpy2.sign(slip))
    taken, given, total, compressed = (
        mpfr(0),
        mpfr(0),
        mpfr(0),
        None,
    )  # works of compression and after it, impulses
    while True:
        ratio, slips = contact.friction(slips)
        dspin, dslip, dopening = contact.change(ratio)
        ahead = []
        if slips and slip * slips > 0 and dslip * slips < 0:
            ahead.append((-slip / dslip, "rest"))
        if compressed is None:
            if dopening > 0:
                ahead.append((-opening / dopening, "compressed"))
        elif law == "poisson":
            ahead.append(((1 + restitution) * compressed - total, "end"))
        elif law == "newton":
            ahead.append(((restitution * closing - opening) / dopening, "end"))
        else:
            left = restitution * restitution * taken - given
            ahead.append(
                ((gmpy2.sqrt(opening * opening + 2 * dopening * left) - opening) / dopening, "end")
            )
        if not ahead:
            raise Tie("an impact without end")
        step, event = min(ahead)
        if step < 0:
            raise Tie("an impact that has ended where its next part begins")
        work = opening * step + dopening * step * step / 2
        taken, given = (taken - work, given) if compressed is None else (taken, given + work)
        total += step
        rate, slip, opening = rate + dspin * step, slip + dslip * step, opening + dopening * step
        if event == "rest":
            slip, slips = mpfr(0), 0
        elif event == "compressed":
            opening, compressed = mpfr(0), total
        else:
            return rate, mpfr(0) if not slips else slip, opening
        if not slips and event != "rest":
            slip = mpfr(0)
