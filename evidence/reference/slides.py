"""Reference slides over many turns, to 25 digits.

    python3 -m pip install mpmath gmpy2        (gmpy2 only makes it faster)
    python3 slides.py                          writes slides.json beside this file
    python3 slides.py NAME ...                 prints these, writes nothing

What is independent here.  None of the reduced equations of motion is used, no map of turns, and no
first integral: at each angle the balances of linear momentum of the mass centre (two), the balance
of moment about it and F = -mu_k sigma N are solved as a linear system in (theta'', eta'', N).
While the slip keeps its sign these are linear in u = theta'^2, so that du/dtheta = 2 theta'' is a
linear equation with periodic coefficients.  It is solved in Fourier series with 45 digits, u =
e(theta) (r(theta) + C exp(lambda theta)); lambda may be as small as 1e-15, which costs as many
digits.  Time and slip are integrals of 1/theta' and eta''/theta' over the angle, by Gauss's rule on
20 panels a turn, over sums of turns by the Euler-Maclaurin formula.  Events are looked for at 320
places of each turn in which one can be.

Units and signs as in the package `follower`; a motion with theta' < 0 is seen in a mirror, (theta,
eta) -> (-theta, -eta).
"""

import json
import multiprocessing
import os
import sys

import mpmath as mp
from mpmath import mpf

DIGITS = 25  # significant digits written
HARMONICS = 256  # points of the Fourier series
PANELS, NODES = 20, 16  # of a turn, of a panel

# name: (mass_ratio, offset, inertia, mu), (theta, theta_rate, slip)
SLIDES = {
    "rotates_and_slows_down": ((1.0, 1.0, 1.0, 1e-4), (1.0, 1.2, 1.5)),
    "rotates_faster_and_faster": ((1.0, 1.0, 1.0, 1e-4), (1.0, 0.8, -2.5)),
    "rotates_until_it_lifts_off": ((1.0, 1.0, 1.0, 1e-3), (0.5, -1.3, 9.0)),
    "turns_and_librates": ((1.0, 1.0, 1.0, 1e-3), (0.3, 0.9, 3.0)),
    "librates": ((0.5, 0.7, 0.4, 1e-4), (2.0, 0.4, 2.0)),
    "librates_far": ((2.0, 1.0, 0.5, 3e-4), (0.2, -0.1, -4.0)),
    "turns_and_rotates_back": ((1.0, 0.001, 1.0, 0.01), (0.0, 5.0, 40.0)),
    "nearly_balanced": ((2.09, 2.4e-7, 3.6e5, 1.6e-3), (2.1, 774.3, -0.58)),
    "light": ((0.1, 0.8, 0.2, 1e-4), (1.0, 0.95, -2.0)),
    "heavy": ((10.0, 1.0, 40.0, 1e-5), (3.0, -1.0, 0.5)),
    "rim_particle_alone": ((0.0, 1.0, 1.0, 2e-4), (0.1, 0.9, -3.0)),
    "four_million_time_units": ((0.2387, 0.001, 1e9, 3e-7), (-5.16, 4.59, 1.33)),
}


def fourier(values):
    """Coefficients of exp(i k theta), k = 0 ... n - 1, the upper half for negative k."""
    n = len(values)
    if n == 1:
        return list(values)
    even, odd = fourier(values[::2]), fourier(values[1::2])
    turned = [mp.expjpi(mpf(-2 * k) / n) * odd[k] for k in range(n // 2)]
    return [(a + b) / 2 for a, b in zip(even, turned)] + [(a - b) / 2 for a, b in zip(even, turned)]


def series(coefficients, theta):
    """Value of a real Fourier series."""
    half = len(coefficients) // 2
    z, total = mp.expj(theta), mp.mpc(0)
    for c in reversed(coefficients[1:half]):
        total = (total + c) * z
    return (coefficients[0] + 2 * total).real


def solve(rows):
    """Three equations, by Cramer's rule."""

    def det(i, j, k):
        a, b, c = ([row[n] for row in rows] for n in (i, j, k))
        return (
            a[0] * (b[1] * c[2] - b[2] * c[1])
            - b[0] * (a[1] * c[2] - a[2] * c[1])
            + c[0] * (a[1] * b[2] - a[2] * b[1])
        )

    whole = det(0, 1, 2)
    return [det(3, 1, 2) / whole, det(0, 3, 2) / whole, det(0, 1, 3) / whole]


class Law:
    """Slides of a body in one direction of slip, seen in the direction of travel."""

    def __init__(self, hoop, sigma):
        m1, l, izz, mu = map(mpf, hoop)
        self.m = m1 + 1
        self.h = l / self.m
        self.inertia = izz + m1 * self.h**2 + (l - self.h) ** 2
        self.f, self.sigma = mu * sigma, sigma
        turn = 2 * mp.pi
        points = [turn * k / HARMONICS for k in range(HARMONICS)]
        solved = [self.balances(theta) for theta in points]
        growth = fourier([2 * s[0][1] for s in solved])
        self.rate = growth[0].real  # lambda
        half = HARMONICS // 2

        def k_of(i):
            return i if i < half else i - HARMONICS

        self.log = [mp.mpc(0)] + [c / mp.mpc(0, k_of(i)) for i, c in enumerate(growth) if i]
        drive = fourier(
            [2 * s[0][0] * mp.exp(-series(self.log, theta)) for theta, s in zip(points, solved)]
        )
        self.part = [c / (mp.mpc(0, k_of(i)) - self.rate) for i, c in enumerate(drive)]
        worst = max(
            abs(self.log[half - 1]), abs(self.part[half - 1] / self.part[1]) if self.part[1] else 0
        )
        assert worst < mpf(10) ** -26, (worst, "more harmonics")
        x = sorted(gauss(NODES))
        self.width = turn / PANELS
        self.nodes, self.weights, self.upto = (
            [],
            [w * self.width / 2 for _, w in x],
            integrals(x, self.width),
        )
        for p in range(PANELS):
            row = []
            for node, _ in x:
                theta = self.width * (p + (node + 1) / 2)
                row.append(
                    (
                        mp.exp(series(self.log, theta)),
                        series(self.part, theta),
                        mp.exp(self.rate * theta),
                        *self.balances(theta),
                    )
                )
            self.nodes.append(row)

    def balances(self, theta):
        """theta'', eta'' and N, each as (a, b) of a + b u."""
        m, h, f = self.m, self.h, self.f
        s, c = mp.sin(theta), mp.cos(theta)
        out = []
        for u in (0, 1):
            rows = [
                [-m * (1 + h * c), m, f, -m * h * s * u],
                [-m * h * s, mpf(0), mpf(-1), m * h * c * u - m],
                [self.inertia, mpf(0), -(h * s - f * (1 + h * c)), mpf(0)],
            ]
            out.append(solve(rows))
        return [(out[0][i], out[1][i] - out[0][i]) for i in range(3)]

    def level(self, theta, u):
        """C of the slide through a place."""
        return (u / mp.exp(series(self.log, theta)) - series(self.part, theta)) * mp.exp(
            -self.rate * theta
        )

    def u(self, level, theta):
        return mp.exp(series(self.log, theta)) * (
            series(self.part, theta) + level * mp.exp(self.rate * theta)
        )

    def shift(self, level, turns):
        """C of the slide whole turns further on, with the angle counted from there."""
        return level * mp.exp(self.rate * 2 * mp.pi * turns)

    def integrands(self, level, theta):
        u = self.u(level, theta)
        _, eta, _ = self.balances(theta)
        return 1 / mp.sqrt(u), (eta[0] + eta[1] * u) / mp.sqrt(u)

    def panel(self, level, p):
        """At the nodes of a panel: u, N, 1/theta', eta''/theta'."""
        out = []
        for e, r, grown, _, eta, normal in self.nodes[p]:
            u = e * (r + level * grown)
            root = mp.sqrt(u)
            out.append((u, normal[0] + normal[1] * u, 1 / root, (eta[0] + eta[1] * u) / root))
        return out

    def turn(self, level):
        """Time and change of slip of a whole turn."""
        time = slip = mpf(0)
        for p in range(PANELS):
            for w, (_, _, t, g) in zip(self.weights, self.panel(level, p)):
                time += w * t
                slip += w * g
        return mp.matrix([time, slip])

    def between(self, level, a, b, turns=False):
        """Time and change of slip from an angle to another, in a panel.

        `turns` where u = 0 at the second.
        """
        total = [mpf(0), mpf(0)]
        for x, w in RULE:
            # Towards a turning point theta = b - (b - a) y^2 takes the root out.
            y = (1 - x) / 2
            theta, weight = (
                (b - (b - a) * y * y, (b - a) * y * w)
                if turns
                else (b - (b - a) * y, (b - a) * w / 2)
            )
            for i, value in enumerate(self.integrands(level, theta)):
                total[i] += weight * value
        return total


def gauss(n):
    """Nodes and weights of Gauss's rule on [-1, 1]."""
    found = []
    for k in range(1, n + 1):
        x = mp.cos(mp.pi * (k - mpf(1) / 4) / (n + mpf(1) / 2))
        for _ in range(9):
            p, before = legendre(n, x)[-1], legendre(n, x)[-2]
            slope = n * (x * p - before) / (x * x - 1)
            x -= p / slope
        found.append((x, 2 / ((1 - x * x) * slope**2)))
    return found


def legendre(n, x):
    """P_0 ... P_n at x."""
    p = [mpf(1), x]
    for k in range(2, n + 1):
        p.append(((2 * k - 1) * x * p[-1] - (k - 1) * p[-2]) / k)
    return p


def integrals(rule, width):
    """Row i integrates the polynomial through the nodes of a panel up to node i."""
    rows = []
    values = [legendre(NODES, x) for x, _ in rule]
    for i, (xi, _) in enumerate(rule):
        row = []
        for j, (_, wj) in enumerate(rule):
            total = xi + 1
            for k in range(1, NODES):
                total += values[j][k] * (values[i][k + 1] - values[i][k - 1])
            row.append(wj * total / 2 * width / 2)
        rows.append(row)
    return rows


def sum_of_turns(law, level, count):
    """Time and change of slip of so many turns."""
    few = 32
    total = mp.matrix([0, 0])
    if count <= 8 * few:
        for n in range(count):
            total += law.turn(law.shift(level, n))
        return total
    for n in list(range(few)) + list(range(count - few, count)):
        total += law.turn(law.shift(level, n))
    # The sum over a <= n < b: the integral on stretches that keep their distance from both ends,
    # and corrections there.
    a, b = mpf(few), mpf(count - few)
    cuts, step = [a], mpf(few)
    while cuts[-1] + 2 * step < (a + b) / 2:
        cuts.append(cuts[-1] + step)
        step *= 2
    cuts += [a + b - c for c in reversed(cuts)]
    for left, right in zip(cuts, cuts[1:]):
        for x, w in RULE:
            total += law.turn(law.shift(level, (left + right + (right - left) * x) / 2)) * (
                w * (right - left) / 2
            )
    for end, sign in ((a, -1), (b, 1)):
        total += law.turn(law.shift(level, end)) * (-mpf(sign) / 2)
        slopes = derivatives(lambda n: law.turn(law.shift(level, n)), end, mpf(few) / 4)
        for k in range(1, 8):
            total += slopes[2 * k - 1] * (sign * mp.bernoulli(2 * k) / (2 * k))
    return total


def derivatives(f, x, radius):
    """Taylor coefficients about x, from the values on a circle."""
    count = 48
    values = [f(x + radius * mp.expjpi(mpf(2 * k) / count)) for k in range(count)]
    out = []
    for j in range(16):
        total = mp.matrix([0, 0])
        for k, v in enumerate(values):
            total += v * mp.expjpi(mpf(-2 * j * k) / count)
        out.append((total / (count * radius**j)).apply(mp.re))
    return out


class Run:
    """One slide, followed to its end.

    The place is an angle between 0 and one turn, with the turns before it.
    """

    def __init__(self, hoop, start):
        theta, rate, slip = map(mpf, start)
        self.sigma = int(mp.sign(slip))
        self.hoop, self.laws = hoop, {}
        self.side = int(mp.sign(rate))  # 1 with theta, -1 in the mirror
        turn = 2 * mp.pi
        psi = self.side * theta
        self.turns = int(mp.floor(psi / turn))
        self.angle = psi - self.turns * turn
        self.time, self.slip = mpf(0), self.side * slip
        self.first = self.turns
        self.level = self.law.level(self.angle, rate * rate)
        self.places, self.cause, self.passed = [], None, 0

    @property
    def law(self):
        if self.side not in self.laws:
            self.laws[self.side] = Law(self.hoop, self.side * self.sigma)
        return self.laws[self.side]

    def state(self):
        u = self.law.u(self.level, self.angle)
        rate = mp.sqrt(u) if u > 0 else mpf(0)
        return [
            self.time,
            self.side * (self.angle + 2 * mp.pi * self.turns),
            self.side * rate,
            self.side * self.slip,
        ]

    def signed(self, slip):
        return self.side * self.sigma * slip

    def move(self, angle, change):
        self.time += change[0]
        self.slip += change[1]
        self.angle = angle
        if self.angle >= 2 * mp.pi - mpf(10) ** -30:
            self.level = self.law.shift(self.level, 1)
            self.turns, self.angle = self.turns + 1, mpf(0)

    def panel(self):
        """To the end of the panel, or to a turning point.

        True if the slide goes on in this direction.
        """
        law, p = self.law, int(mp.floor(self.angle / self.law.width + mpf(10) ** -30))
        left, right = p * law.width, (p + 1) * law.width
        inside = abs(self.angle - left) < mpf(10) ** -30
        values = law.panel(self.level, p)
        ahead = [mp.re(v[0]) for (x, v) in zip(self.nodes(p), values) if x > self.angle] + [
            law.u(self.level, right)
        ]
        if min(ahead) <= 0:
            u = lambda theta: law.u(self.level, theta)
            low, high = self.angle, right
            bad = next(x for x in self.nodes(p) + [right] if x > self.angle and u(x) <= 0)
            turning = mp.findroot(u, (self.angle, bad), solver="anderson", tol=mpf(10) ** -60)
            self.events(p, turning)
            if self.cause:
                return False
            self.move(turning, law.between(self.level, self.angle, turning, True))
            assert self.signed(self.slip) > 0
            return False
        if inside:
            change = tuple(sum(w * v[i] for w, v in zip(law.weights, values)) for i in (2, 3))
            lowest = min(
                self.signed(self.slip + mp.fdot(row, [v[3] for v in values])) for row in law.upto
            )
        else:
            change = law.between(self.level, self.angle, right)
            lowest = self.signed(self.slip + change[1])
        if min(v[1] for v in values) <= 0 or min(lowest, self.signed(self.slip + change[1])) <= 0:
            self.events(p, right)
            if self.cause:
                return False
        self.move(right, change)
        return True

    def nodes(self, p):
        return [self.law.width * (p + (x + 1) / 2) for x, _ in RULE_OF_PANEL]

    def events(self, p, end):
        """The first of the events before an angle, if there is one."""
        law, found = self.law, []
        slip = lambda theta: self.signed(self.slip + law.between(self.level, self.angle, theta)[1])

        def normal(theta):
            a, b = law.balances(theta)[2]
            return a + b * law.u(self.level, theta)

        for cause, f in (("stick", slip), ("lift_off", normal)):
            low = self.angle
            for x in [x for x in self.nodes(p) if self.angle < x < end] + [end]:
                if cause == "lift_off" and law.u(self.level, x) <= 0:
                    break
                if f(x) <= 0:
                    found.append(
                        (mp.findroot(f, (low, x), solver="anderson", tol=mpf(10) ** -60), cause)
                    )
                    break
                low = x
        if found:
            at, self.cause = min(found)
            change = law.between(self.level, self.angle, at)
            self.time, self.slip, self.angle = self.time + change[0], self.slip + change[1], at

    def is_free(self, level):
        """Whether a turn has neither a turning point nor a lift-off."""
        return all(
            v[0] > 0 and v[1] > 0
            for p in range(PANELS)
            for v in map(lambda v: (mp.re(v[0]), v[1]), self.law.panel(level, p))
        )

    def lowest(self, level):
        """Least slip in a turn, less that at its beginning."""
        slip, least = mpf(0), mpf(0)
        for p in range(PANELS):
            values = [v[3] for v in self.law.panel(level, p)]
            least = min(
                [least] + [self.signed(slip + mp.fdot(row, values)) for row in self.law.upto]
            )
            slip += mp.fdot(self.law.weights, values)
        return least

    def rotate(self):
        """On in the same direction, to an event or a turning point."""
        while self.angle != 0:
            if not self.panel():
                return
        law, level = self.law, self.level
        most = 1
        while self.is_free(law.shift(level, most)) and most < 10**9:
            most *= 2
        low, high = 0, most
        while high - low > 1:
            middle = (low + high) // 2
            low, high = (middle, high) if self.is_free(law.shift(level, middle)) else (low, middle)
        most = low if most > 1 else 0
        # The last turn before that in which the slip vanishes: it falls by nearly the same from
        # turn to turn.
        known = {0: (mp.matrix([0, 0]), self.signed(self.slip) + self.lowest(level))}

        def left(n):
            if n not in known:
                base = max((k for k in known if 0 <= n - k < 64), default=0)
                change = known[base][0] + sum_of_turns(law, law.shift(level, base), n - base)
                known[n] = (
                    change,
                    self.signed(self.slip + change[1]) + self.lowest(law.shift(level, n)),
                )
            return known[n][1]

        n = 0
        for _ in range(12):
            loss = -self.signed(law.turn(law.shift(level, n))[1])
            ahead = int(mp.floor(left(n) / loss))
            if ahead == 0 or (ahead > 0 and n == most):
                break
            n = min(max(n + ahead, 0), most)
        while n < most and left(n + 1) > 0:
            n += 1
        while n > 0 and left(n) <= 0:
            n -= 1
        for part in (n // 3, 2 * n // 3):
            if part > 20:
                change = sum_of_turns(law, level, part)
                there = law.shift(level, part)
                self.places.append(
                    [
                        self.time + change[0],
                        self.side * (self.turns + part) * 2 * mp.pi,
                        self.side * mp.sqrt(law.u(there, 0)),
                        self.side * (self.slip + change[1]),
                    ]
                )
        left(n)
        self.time += known[n][0][0]
        self.slip += known[n][0][1]
        self.turns += n
        self.passed += n
        self.level = law.shift(level, n)
        while self.panel():
            pass

    def reverse(self):
        """At a turning point: the mirror."""
        self.side = -self.side
        theta = 2 * mp.pi - self.angle
        self.turns, self.angle, self.slip = -self.turns - 1, theta, -self.slip
        self.level = self.law.level(theta, mpf(0))

    def librate(self):
        """From a turning point: true if there is another within a turn.

        Whole periods are left out while the slip lasts.
        """
        law, step = self.law, self.law.width
        u = lambda theta: law.u(self.level, theta)
        ahead = next((k for k in range(1, 2 * PANELS) if u(self.angle + k * step / 2) <= 0), None)
        if ahead is None:
            return False
        a = self.angle
        b = mp.findroot(
            u,
            (a + (ahead - 1) * step / 2, a + ahead * step / 2),
            solver="anderson",
            tol=mpf(10) ** -60,
        )
        middle, half = (a + b) / 2, (b - a) / 2

        # theta = middle - half cos psi: the integrands are smooth in psi.
        def integrand(psi):
            theta = middle - half * mp.cos(psi)
            w = u(theta)
            _, eta, _ = law.balances(theta)
            dt = half * mp.sin(psi) / mp.sqrt(w)
            return dt, (eta[0] + eta[1] * w) * dt

        cuts = [mp.pi * k / 256 for k in range(257)]
        swing, profile = [mpf(0), mpf(0)], [(mpf(0), mpf(0))]
        for left, right in zip(cuts, cuts[1:]):
            for x, w in RULE:
                dt, change = integrand((left + right + (right - left) * x) / 2)
                swing[0] += w * dt * (right - left) / 2
                swing[1] += w * change * (right - left) / 2
            profile.append(tuple(swing))
        there = min(self.signed(c) for _, c in profile)
        back = min(self.signed(swing[1] + (swing[1] - c)) for _, c in profile)
        lowest = min(there, back)
        periods = max(
            0, int(mp.floor((self.signed(self.slip) + lowest) / -self.signed(2 * swing[1]))) - 1
        )
        self.time += 2 * periods * swing[0]
        self.slip += 2 * periods * swing[1]
        self.passed += periods
        self.places.append(self.state())
        # Swing by swing to the end.
        while not self.cause:
            for k, (left, right) in enumerate(zip(cuts, cuts[1:])):
                if self.signed(self.slip + profile[k + 1][1]) <= 0:

                    def partial(psi):
                        out = [mpf(0), mpf(0)]
                        for x, w in RULE:
                            dt, change = integrand((left + psi + (psi - left) * x) / 2)
                            out[0] += w * dt * (psi - left) / 2
                            out[1] += w * change * (psi - left) / 2
                        return out

                    psi = mp.findroot(
                        lambda psi: self.slip + profile[k][1] + partial(psi)[1],
                        (left, right),
                        solver="anderson",
                        tol=mpf(10) ** -60,
                    )
                    more = partial(psi)
                    self.time += profile[k][0] + more[0]
                    self.slip += profile[k][1] + more[1]
                    self.angle, self.cause = middle - half * mp.cos(psi), "stick"
                    return True
            self.time += swing[0]
            self.slip += swing[1]
            self.angle = b
            self.reverse()
            # In the mirror the profile is that of the way back.
            a, b = 2 * mp.pi - b, 2 * mp.pi - a
            middle = (a + b) / 2
            law = self.law
            profile = [(swing[0] - t, self.mirrored(swing[1] - c)) for t, c in reversed(profile)]
            swing[1] = -swing[1]
        return True

    @staticmethod
    def mirrored(change):
        return -change

    def follow(self):
        self.rotate()
        while not self.cause:
            self.reverse()
            if not self.librate():
                # Away from the turning point, where u = 0.
                p = int(mp.floor(self.angle / self.law.width)) + 1
                # Backwards from the end, towards the turning point.
                change = self.law.between(self.level, p * self.law.width, self.angle, True)
                self.move(p * self.law.width, [-change[0], -change[1]])
                assert self.signed(self.slip) > 0
                self.rotate()
        return self


def text(x):
    return mp.nstr(x, DIGITS) if abs(x) > mpf(10) ** -34 else "0.0"


def entry(name):
    hoop, start = SLIDES[name]
    run = Run(hoop, start).follow()
    keys = ("time", "theta", "theta_rate", "slip")
    print(name, run.cause, run.passed, [mp.nstr(x, 18) for x in run.state()], flush=True)
    return {
        "name": name,
        "hoop": dict(zip(("mass_ratio", "offset", "inertia", "mu"), hoop)),
        "start": dict(zip(("theta", "theta_rate", "slip"), start)),
        "places": [dict(zip(keys, map(text, place))) for place in run.places],
        "cause": run.cause,
        "passed": run.passed,
        "end": dict(zip(keys, map(text, run.state()))),
    }


def main(names):
    global RULE, RULE_OF_PANEL
    mp.mp.dps = 45
    RULE, RULE_OF_PANEL = gauss(24), sorted(gauss(NODES))
    if names:
        for name in names:
            entry(name)
        return
    with multiprocessing.Pool(4) as pool:
        slides = pool.map(entry, SLIDES, chunksize=1)
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "slides.json"), "w") as file:
        json.dump({"slides": slides}, file, indent=1)
        file.write("\n")


if __name__ == "__main__":
    main(sys.argv[1:])
