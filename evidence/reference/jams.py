"""Slides that run towards P = 0: whether they jam, stick or lift off, to 25 digits.

    python3 -m pip install mpmath gmpy2        (gmpy2 only makes it faster)
    python3 jams.py                            writes jams.json beside this file

What is independent here.  Newton's and Euler's equations are solved for the forces at each angle,
and rate, slip and time are integrated in s = -ln(xi), xi being the distance of the angle from that
of P = 0, by the extrapolated midpoint rule of Gragg, with 80 digits, to xi = 1e-32.  The first
integral of sliding is not used.  From there on the angle does not change any more, and a slide is
an impulse: rate and slip change in the ratio in which they answer to it.  What of the force is left
then falls as C xi^lambda - (tan(theta)/(lambda - 1)) xi, the equation of w to the first order in
xi.

Units and angles as in bounces.py.  All slides have a positive slip; their mirror images have the
other one.
"""

import json
import os
import random

import mpmath as mp
from mpmath import mpf

mp.mp.dps = 80
DIGITS = 25
LAST = mpf(32) * mp.log(10)
COLUMNS = 12
LARGEST_ERROR = mpf(10) ** -32


class Hoop:
    """Mass, place of the mass centre, inertia about it, and friction.

    From the hoop and the particle.
    """

    def __init__(self, mass_ratio, offset, inertia, mu):
        m1, l, izz, self.mu = map(mpf, (mass_ratio, offset, inertia, mu))
        self.m = m1 + 1
        self.h = l / self.m
        self.i = izz + m1 * self.h**2 + (l - self.h) ** 2

    def impulses(self, theta):
        """Change of rate, slip and rate of the gap by a unit of normal impulse.

        Friction acts against a positive slip.
        """
        c, s = mp.cos_sin(theta)
        spin = (self.h * s - self.mu * (1 + self.h * c)) / self.i
        return spin, -self.mu / self.m + (1 + self.h * c) * spin, 1 / self.m + self.h * s * spin

    def zero(self):
        """The upper angle in (0, pi) at which the gap does not answer to an impulse, or none."""
        f = lambda theta: self.impulses(theta)[2]
        grid = [mp.pi * k / 400 for k in range(1, 400)]
        for low, high in zip(grid, grid[1:]):
            if f(low) < 0 <= f(high):
                return mp.findroot(f, (low, high), solver="anderson", tol=mpf(10) ** -95)
        return None


class Slide:
    """From the right towards the upper zero: u, slip and time as functions of s.

    The angle is theta = zero + exp(-s).
    """

    def __init__(self, hoop, zero):
        self.hoop, self.zero = hoop, zero

    def slope(self, s, y):
        b, (u, _, _) = self.hoop, y
        xi = mp.exp(-s)
        theta = self.zero + xi
        c, sn = mp.cos_sin(theta)
        spin, slip, gap = b.impulses(theta)
        # Accelerations without a force of the plane, and the force that keeps the gap closed.
        normal = (1 - b.h * c * u) / gap
        d_theta, d_slip = spin * normal, slip * normal - b.h * sn * u
        rate = -mp.sqrt(u)
        return (-2 * d_theta * xi, -d_slip / rate * xi, -xi / rate)

    def step(self, s, y, width):
        """A step, and how well the last two extrapolations agree."""
        table = []
        for column in range(COLUMNS):
            n = 2 * (column + 1)
            h = width / n
            before = y
            f = self.slope(s, y)
            now = tuple(a + h * d for a, d in zip(y, f))
            for k in range(1, n):
                f = self.slope(s + k * h, now)
                before, now = now, tuple(a + 2 * h * d for a, d in zip(before, f))
            f = self.slope(s + width, now)
            row = [tuple((a + b + h * d) / 2 for a, b, d in zip(before, now, f))]
            for k in range(1, column + 1):
                factor = mpf(n) ** 2 / mpf(2 * (column + 1 - k)) ** 2 - 1
                row.append(
                    tuple(a + (a - b) / factor for a, b in zip(row[k - 1], table[-1][k - 1]))
                )
            table.append(row)
        end, other = table[-1][-1], table[-1][-2]
        return end, max(abs(a - b) for a, b in zip(end, other))

    def force(self, s, y):
        return 1 - self.hoop.h * mp.cos(self.zero + mp.exp(-s)) * y[0]

    def path(self, start, u):
        """Nodes (s, (u, slip spent so far, time)) to the lift-off, or to xi = 1e-32.

        None where it turns back.
        """
        s, y, width = -mp.log(start - self.zero), (u, mpf(0), mpf(0)), mpf(1) / 2
        nodes = [(s, y)]
        while s < LAST:
            width = min(width, LAST - s)
            try:
                end, error = self.step(s, y, width)
                turns = any(mp.im(a) for a in end) or end[0] <= 0
            except (ValueError, TypeError, ZeroDivisionError):
                turns = True
            if turns:
                if width < mpf(10) ** -3:
                    return None
                width /= 2
                continue
            factor = (LARGEST_ERROR / max(error, mpf(10) ** -60)) ** (mpf(1) / (2 * COLUMNS))
            if error <= LARGEST_ERROR:
                s, y = s + width, end
                nodes.append((s, y))
                if self.force(s, y) <= 0:
                    return nodes
            width *= min(max(factor * mpf("0.9"), mpf("0.2")), mpf(2))
        return nodes

    def within(self, node, width, f):
        """The zero of f(s, y) within a step."""
        s, y = node
        state = lambda part: (s + part, self.step(s, y, part)[0])
        part = mp.findroot(
            lambda part: f(*state(part)),
            (mpf(0), width),
            solver="anderson",
            tol=mpf(10) ** -60,
            maxsteps=60,
        )
        return state(part)


def text(x):
    return mp.nstr(mpf(x), DIGITS)


def end_of(slide, nodes, slip):
    """What ends the slide that begins with this slip."""
    hoop, zero = slide.hoop, slide.zero
    lifts = slide.force(*nodes[-1]) <= 0
    for before, after in zip(nodes, nodes[1:]):
        width = after[0] - before[0]
        event = None
        if slip + after[1][1] <= 0:
            event = "stick", slide.within(before, width, lambda s, y: slip + y[1])
        if lifts and after is nodes[-1]:
            lift = "lift_off", slide.within(before, width, slide.force)
            event = min((e for e in (event, lift) if e), key=lambda e: e[1][0])
        if event:
            kind, (s, y) = event
            return kind, s, zero + mp.exp(-s), -mp.sqrt(y[0]), slip + y[1], y[2]
    # Nothing but the impulse is left.
    s, (u, spent, time) = nodes[-1]
    spin, answer, _ = hoop.impulses(zero)
    rate, left = -mp.sqrt(u), slip + spent
    cos = mp.cos(zero)
    last = -1 / mp.sqrt(hoop.h * cos) if cos > 0 else -mp.inf
    at_last = left + answer / spin * (last - rate)
    if at_last > 0:
        power = exponent(hoop, zero)
        smooth = mp.tan(zero) / (1 - power) * mp.exp(-s)
        kind = "jam" if power < 1 and slide.force(s, (u, spent, time)) > smooth else "lift_off"
        return kind, None, zero, last, at_last, time
    return "stick", None, zero, rate - left * spin / answer, mpf(0), time


def spent(slide, nodes):
    """Slip with which the force vanishes at P = 0 as the slip does.

    None where it lifts off before, or never comes to that.
    """
    _, (u, change, _) = nodes[-1]
    cos = mp.cos(slide.zero)
    if slide.force(*nodes[-1]) <= 0 or cos <= 0:
        return None
    spin, answer, _ = slide.hoop.impulses(slide.zero)
    return -change - answer / spin * (-1 / mp.sqrt(slide.hoop.h * cos) + mp.sqrt(u))


def exponent(hoop, zero):
    """lambda, from a difference of the answer of the gap."""
    tiny = mpf(10) ** -25
    slope = (hoop.impulses(zero + tiny)[2] - hoop.impulses(zero - tiny)[2]) / (2 * tiny)
    return 2 * mp.cos(zero) / (mp.sin(zero) * slope * hoop.m)


def cases(count):
    """Hoops of all masses down to 1e-6, and slides from near and far.

    The particle is on the rim or within.
    """
    draw = random.Random(32)
    while count:
        kind = draw.random()
        if kind < 0.4:
            mass = 10 ** draw.uniform(-2, 0)
            numbers = (mass, 1.0, mass)
        elif kind < 0.7:
            numbers = (0.0, 1.0, 10 ** draw.uniform(-6, -1))
        else:
            numbers = (draw.uniform(0, 0.3), draw.uniform(0.5, 1), draw.uniform(0.001, 0.1))
        free = Hoop(*numbers, 0)
        # Friction for an angle at which P is to vanish, also above 90 degrees.
        angle = draw.uniform(0.1, 1.75)
        s, c = mp.sin(angle), mp.cos(angle)
        mu = float((free.i / free.m + free.h**2 * s**2) / (free.h * s * (1 + free.h * c)))
        hoop = Hoop(*numbers, mu)
        zero = hoop.zero()
        if zero is None:
            continue
        far = 10 ** draw.choice([draw.uniform(-12, -9), draw.uniform(-3, 0), draw.uniform(-1, 0.3)])
        theta = float(zero + far)
        if not zero < theta < 3.1:
            continue
        cos = mp.cos(theta)
        most = 1 / (hoop.h * cos) if cos > 0 else mpf(4)
        rate = -float(mp.sqrt(most * draw.uniform(0.2, 0.999)))
        slide = Slide(hoop, zero)
        nodes = slide.path(mpf(theta), mpf(rate) ** 2)
        if nodes is None:
            continue
        count -= 1
        print(count, numbers, mu, theta, rate, mp.nstr(exponent(hoop, zero), 5), len(nodes))
        yield numbers, mu, theta, rate, slide, nodes, draw


def jams():
    found = []
    for numbers, mu, theta, rate, slide, nodes, draw in cases(32):
        boundary = spent(slide, nodes)
        slips = [draw.uniform(0.05, 2.0)]
        if boundary is not None and boundary > 0:
            slips = [
                float(boundary * (1 + side * 10**-k))
                for side in (-1, 1)
                for k in (0.3, draw.uniform(2, 8), draw.uniform(8, 11))
            ]
        for slip in slips:
            kind, s, angle, last, left, time = end_of(slide, nodes, mpf(slip))
            found.append(
                {
                    "hoop": numbers,
                    "mu": mu,
                    "start": (theta, rate, slip),
                    "exponent": text(exponent(slide.hoop, slide.zero)),
                    "zero": text(slide.zero),
                    "distance": None if s is None else text(mp.exp(-s)),
                    "margin": None if boundary is None else text(slip - boundary),
                    "end": kind,
                    "time": text(time),
                    "theta": text(angle),
                    "theta_rate": text(last),
                    "slip": text(left),
                }
            )
    return found


if __name__ == "__main__":
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "jams.json")
    data = {"jams": jams()}
    with open(path, "w") as f:
        json.dump(data, f, indent=1)
        f.write("\n")
    from collections import Counter

    print(Counter((j["end"], j["distance"] is None) for j in data["jams"]))
