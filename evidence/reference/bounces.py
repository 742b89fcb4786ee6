"""Impacts, flights and bounces of the loaded hoop, to 25 digits.

    python3 -m pip install mpmath gmpy2        (gmpy2 only makes it faster)
    python3 bounces.py                         writes bounces.json beside this file

What is independent here.  A flight is the parabola of the mass centre and a rotation at constant
rate, evaluated naively with 80 digits; its first landing is found on a scan and refined by
bisection.  An impact has no table of cases: Newton's and Euler's equations are followed in the
normal impulse from event to event (slip ends, greatest compression, end by the law), and what a
contact at rest does next is found from what friction could do.  Bounces are followed one by one
until they are slower than 1e-32; what would still follow is shorter than 1e-28.

Units: mass of the particle, radius and gravity are 1.  theta: angle of the particle from the upward
vertical, counterclockwise; eta' = x' + theta': velocity of the lowest point of the hoop, x being
the centre of the hoop.
"""

import json
import os
import random

import mpmath as mp
from mpmath import mpf

mp.mp.dps = 80
DIGITS = 25
LAST_RATE = mpf(10) ** -32


class Hoop:
    """Mass, place of the mass centre and inertia about it, from the hoop and the particle."""

    def __init__(self, mass_ratio, offset, inertia, mu_s, mu_k):
        self.m1, self.l, self.izz, self.mu_s, self.mu_k = map(
            mpf, (mass_ratio, offset, inertia, mu_s, mu_k)
        )
        self.m = self.m1 + 1
        self.h = self.l / self.m
        self.i = self.izz + self.m1 * self.h**2 + (self.l - self.h) ** 2


class Body:
    """Velocity of the mass centre and spin at an angle: what an impulse changes."""

    def __init__(self, b, theta, vx, vy, spin):
        self.b, self.theta, self.vx, self.vy, self.spin = b, theta, vx, vy, spin
        self.px, self.py = b.h * mp.sin(theta), -1 - b.h * mp.cos(theta)

    def contact(self):
        """Velocity of the lowest point of the rim as a point of the body."""
        return self.vx - self.spin * self.py, self.vy + self.spin * self.px

    def pushed(self, friction, normal):
        b = self.b
        spin = self.spin + (self.px * normal - self.py * friction) / b.i
        return Body(b, self.theta, self.vx + friction / b.m, self.vy + normal / b.m, spin)


def rates(body, ratio):
    """Change of (slip, gap rate) by a unit of normal impulse, with so much friction."""
    (u0, w0), (u1, w1) = body.contact(), body.pushed(ratio, mpf(1)).contact()
    return u1 - u0, w1 - w0


def friction(body, slips):
    """Friction over normal impulse, against the slip.

    At rest it is what keeps it so, if static friction can.
    """
    b = body.b
    if slips:
        return -b.mu_k * slips, slips
    free, _ = rates(body, mpf(0))
    hold = -free / (rates(body, mpf(1))[0] - free)
    if abs(hold) <= b.mu_s:
        return hold, 0
    way = 1 if free > 0 else -1
    return -b.mu_k * way, way


def impact(body, e, law):
    """The body after the impact, and how its slip went: a list of -1, 0, +1."""
    u, w = body.contact()
    closing = -w
    slips = int(mp.sign(u))
    taken, given, compressed = (
        mpf(0),
        mpf(0),
        None,
    )  # work taken up and given back, impulse of compression
    total, course = mpf(0), []
    while True:
        ratio, slips = friction(body, slips)
        course.append(slips)
        u, w = body.contact()
        du, dw = rates(body, ratio)
        ahead = []
        if slips and u * slips > 0 and du * slips < 0:
            ahead.append((-u / du, "rest"))
        if compressed is None:
            if dw > 0:
                ahead.append((-w / dw, "compressed"))
        elif law == "poisson":
            ahead.append(((1 + e) * compressed - total, "end"))
        elif law == "newton":
            ahead.append(((e * closing - w) / dw, "end"))
        else:
            left = e * e * taken - given  # w p + dw p^2/2 = left
            ahead.append(((mp.sqrt(w * w + 2 * dw * left) - w) / dw, "end"))
        step, event = min(ahead)
        work = w * step + dw * step * step / 2
        if compressed is None:
            taken -= work
        else:
            given += work
        total += step
        body = body.pushed(ratio * step, step)
        if event == "rest":
            slips = 0
        elif event == "compressed":
            compressed = total
        else:
            return body, course


class Flight:
    """From a state with the rim at the plane: (theta, theta', eta', gap')."""

    def __init__(self, b, state):
        self.b = b
        self.theta, self.rate, slip, gap_rate = state
        c, s = mp.cos_sin(self.theta)
        self.vx = slip - (1 + b.h * c) * self.rate
        self.vy = gap_rate - b.h * s * self.rate
        self.y0 = 1 + b.h * c
        self.start = state

    def gap(self, t):
        return self.y0 + self.vy * t - t * t / 2 - self.b.h * mp.cos(self.theta + self.rate * t) - 1

    def body(self, t):
        return Body(self.b, self.theta + self.rate * t, self.vx, self.vy - t, self.rate)

    def landing(self):
        """The first zero of the gap after the start."""
        b, (_, rate, _, opening) = self.b, self.start
        weight = 1 - b.h * mp.cos(self.theta) * rate**2
        if weight > 0 and opening / weight < mpf(10) ** -4 / (1 + abs(rate)):
            low, high = opening / weight, 4 * opening / weight
        else:
            largest = mpf(1) / 500 / (1 + abs(rate))
            # A gap that does not open at once opens by its weight.
            step = min(largest, opening / (1 + b.h * rate**2)) or largest
            low = high = mpf(0)
            while True:
                high = low + step
                if self.gap(high) < 0:
                    break
                low, step = high, min(2 * step, largest)
        assert self.gap(low) >= 0 and self.gap(high) < 0
        return mp.findroot(
            self.gap,
            (low, high),
            solver="anderson",
            tol=mpf(10) ** -150,
            maxsteps=400,
            verify=False,
        )

    def after(self, e, law):
        """Time of the landing, the state after the impact, and how the slip went."""
        t = self.landing()
        body, course = impact(self.body(t), e, law)
        u, w = body.contact()
        if course[-1] == 0:
            u = mpf(0)
        return t, (body.theta, body.spin, u, w), course


def impacts():
    """Impacts at velocities of all sizes of a double, and of a start."""
    draw = random.Random(51)

    def size(low, high):
        return 10 ** draw.uniform(low, high)

    def velocity(like=None):
        way = draw.choice((-1, 1))
        if like and draw.random() < 0.7:
            return way * like * size(-1, 1)
        return way * max(5e-324, min(1e6, size(-323.3, 6)))

    found = []
    while len(found) < 400:
        mu_s = size(-1, 0.7)
        mu_k = mu_s * draw.choice((1, draw.random()))
        light = draw.choice((0.01, 1))
        hoop = (draw.uniform(0, light), draw.uniform(0.2, 1), draw.uniform(0.1, 1) * light)
        hoop += (mu_s, mu_k)
        theta, closing = draw.uniform(-3.1, 3.1), abs(velocity())
        slip, rate = draw.choice((0.0, velocity(closing), velocity(closing))), velocity(closing)
        b, e = Hoop(*hoop), draw.choice((0.0, 1.0, draw.random()))
        law = draw.choice(("energetic", "poisson", "newton"))
        # Velocities of 1e6 have digits down to 5e-324.
        with mp.workdps(480):
            body = Body(b, mpf(theta), mpf(0), mpf(0), mpf(0))
            a, slope = rates(body, mpf(1))[0] - rates(body, mpf(0))[0], rates(body, mpf(0))[0]
            way = mp.sign(slip)
            slowing, k1 = -way * rates(body, -mu_k * way)[0], rates(body, -mu_k * way)[1]
            # Where rounding errors are not magnified.
            if min(abs(abs(slope) - mu_s * a), abs(k1), abs(slowing) if slip else 1) < 0.02:
                continue
            body.spin = mpf(rate)
            body.vx, body.vy = slip + body.spin * body.py, -mpf(closing) - body.spin * body.px
            after, course = impact(body, mpf(e), law)
            u, w = after.contact()
            normal = (after.vy - body.vy) * b.m
            numbers = (
                after.spin,
                u if course[-1] else mpf(0),
                w,
                normal,
                (after.vx - body.vx) * b.m,
            )
            found.append(
                {
                    "hoop": hoop,
                    "restitution": e,
                    "law": law,
                    "start": (theta, rate, slip, -closing),
                    "course": course,
                    "end": [mp.nstr(number, DIGITS) for number in numbers],
                }
            )
    return found


def text(x):
    return mp.nstr(mpf(x) if abs(x) > mpf(10) ** -34 else mpf(0), DIGITS)


def record(time, state):
    return dict(zip(("time", "theta", "theta_rate", "slip", "gap_rate"), map(text, (time, *state))))


def flights():
    """Ordinary, slow, fast, tiny and nearly weightless ones."""
    draw = random.Random(11)
    cases = [
        ((1.0, 1.0, 1.0), (0.3, 0.0, 0.4, 1.0)),  # does not turn
        ((1.0, 1.0, 1.0), (2.0, 1e-9, 0.0, 0.5)),
        ((1.0, 1.0, 1.0), (0.4, 1.2, 0.3, 1e-8)),  # short
        ((1.0, 1.0, 1.0), (-0.4, 1.2, 0.3, 1e-8)),
        ((1.0, 1.0, 1.0), (3.0, -1.9, 0.3, 1e-5)),
        ((1.0, 1.0, 1.0), (0.1, 1.425, 0.0, 1e-3)),  # nearly weightless at the start
        ((1.0, 1.0, 1.0), (-0.1, 1.42, 0.0, 1e-6)),
        ((1.0, 1.0, 1.0), (-0.5, 1.6, 0.0, 1e-9)),  # opens again before it closes
        ((1.0, 1.0, 1.0), (-0.9, 1.75, 0.0, 1e-4)),
        ((1.0, 1.0, 1.0), (0.9, 3.0, 0.0, 0.7)),  # many turns
        ((0.1, 1.0, 0.1), (2.0, -6.0, -0.4, 2.5)),
        ((0.1, 1.0, 0.1), (-1.0, 9.0, 0.4, 0.01)),
        ((1.0, 0.0, 1.0), (0.2, 1.3, -0.3, 0.8)),  # balanced
        ((1e-6, 1.0, 1e-6), (1.0, 2.0, 0.0, 0.3)),  # light
        ((1.0, 1.0, 1.0), (0.7, 60.0, 0.2, 1.5)),  # fast
        ((0.5, 1.0, 0.5), (2.5, -45.0, 0.2, 0.4)),
        ((1.0, 1.0, 1.0), (-1.5, 20.0, 0.2, 1.0)),  # 70 turns
    ]
    for _ in range(40):
        hoop = tuple(round(draw.uniform(0.05, 3), 3) for _ in range(1)) + (
            round(draw.uniform(0.1, 1), 3),
            round(draw.uniform(0.05, 3), 3),
        )
        gap_rate = draw.choice([draw.uniform(0, 2), 10 ** draw.uniform(-9, 0)])
        cases.append(
            (hoop, (draw.uniform(-3.2, 3.2), draw.uniform(-4, 4), draw.uniform(-1, 1), gap_rate))
        )
    found = []
    for hoop, state in cases:
        b = Hoop(*hoop, 0.5, 0.4)
        flight = Flight(b, tuple(map(mpf, state)))
        t = flight.landing()
        body = flight.body(t)
        found.append(
            {
                "hoop": hoop,
                "start": state,
                "landing": record(t, (body.theta, body.spin, *body.contact())),
            }
        )
    return found


def bounces():
    """Sequences of bounces to their end."""
    thin = (1.0, 1.0, 1.0, 0.5, 0.4)
    light = (0.125, 1.0, 0.125, 0.5, 0.4)
    slippery = (1.0, 0.6, 0.7, 0.08, 0.05)
    cases = []
    for e in (0.2, 0.5, 0.8, 0.9, 0.99):
        cases.append((thin, e, "energetic", (2.8, 1.1, 0.0, 0.02)))  # sticks each time
        cases.append((thin, e, "energetic", (2.0, 0.9, 1.5, 0.02)))  # slips each time
    for law in ("poisson", "newton"):
        for e in (0.3, 0.7):
            cases.append((thin, e, law, (2.8, 1.1, 0.01, 0.05)))
            cases.append((light, e, law, (1.0, 0.7, 0.0, 0.05)))
    for e in (0.4, 0.85):
        cases.append(
            (slippery, e, "energetic", (1.2, 1.0, 0.0, 0.03))
        )  # reverses, and slips in the end
        cases.append((light, e, "energetic", (-1.0, 1.1, -0.02, 0.03)))
        cases.append(((1.0, 0.0, 1.0, 0.5, 0.4), e, "energetic", (0.5, 0.4, 0.3, 0.2)))
    # With e = 1 friction alone makes bounces shrink, where they stick or reverse.
    rolls = (2.293298154652688, 0.869142754233778, 1.2550335485153497) + 2 * (0.49625337032117806,)
    slows = (1.7348422673698543, 0.3937041272098101, 1.28811503780063) + 2 * (0.7856205442037261,)
    for e in (1.0, 1 - 1e-12):
        cases.append((rolls, e, "poisson", (-0.8343654715312427, -2.6327833968121177, 0.0, 0.0)))
        cases.append((slows, e, "energetic", (0.9633791393074782, 3.9276452086581672, 0.0, 0.0)))
        cases.append((thin, e, "energetic", (2.8, 1.1, 0.0, 0.02)))
        cases.append((light, e, "poisson", (1.0, 0.7, 0.0, 0.05)))
    # Light hoops at the bottom: what an impact does changes within a ten thousandth of a turn.
    for inertia, e, law, mu_s, mu_k, state in (
        (
            1.9848315108045228e-07,
            0.7,
            "energetic",
            0.5,
            0.5,
            (3.1415936917102525, 18.15417179932406, 0.0, 4.972981385995499e-07),
        ),
        (
            5.379514142957841e-05,
            0.9,
            "poisson",
            1.2,
            0.6,
            (3.1415927904824628, 27.672050935894934, 0.0, 2.5688104915541483e-06),
        ),
    ):
        cases.append(((0.0, 1.0, inertia, mu_s, mu_k), e, law, state))
    ring = 7.645132811504882e-06
    cases.append(
        (
            (ring, 1.0, ring, 1.2, 0.6),
            0.7,
            "poisson",
            (3.1416000431203654, 887.8663583564115, -0.0023764263955505026, 0.003724320279507337),
        )
    )
    found = []
    for hoop, e, law, state in cases:
        b, now, time, count = Hoop(*hoop), tuple(map(mpf, state)), mpf(0), 0
        while count == 0 or now[3] > LAST_RATE:
            before = now
            t, now, course = Flight(b, now).after(mpf(e), law)
            time, count = time + t, count + 1
        found.append(
            {
                "hoop": hoop,
                "restitution": e,
                "law": law,
                "start": state,
                "bounces": count,
                "sticks": abs(now[2]) < mpf(10) ** -28,
                "ratio": text(now[3] / before[3]),
                "end": record(time, now),
            }
        )
        print(found[-1])
    return found


if __name__ == "__main__":
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "bounces.json")
    data = {"flights": flights(), "bounces": bounces(), "impacts": impacts()}
    with open(path, "w") as f:
        json.dump(data, f, indent=1)
        f.write("\n")
