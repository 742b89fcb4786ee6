"""Glides of the massless hoop from starts whose numbers are tiny, to 25 digits.

    python3 -m pip install mpmath gmpy2        (gmpy2 only makes it faster)
    python3 glides.py                          writes glides.json beside this file (a minute)

What is independent here.  The particle falls freely, and the hoop touches the plane below it: the
angle, its rate and the slip follow from the height of the particle as they stand, with 420 digits.
The end of the slip is the first change of its sign on a grid that is as fine at 1e-330 of the
glide as at its end, bisected.  Which motion follows comes from the momentum of a particle whose
contact force points at it.

Units: mass of the particle, radius and gravity are 1.  theta: angle of the particle from the
upward vertical, counterclockwise.
"""

import json
import os
import random

import mpmath as mp
from mpmath import mpf

mp.mp.dps = 420
DIGITS = 25
DECADES = 335
POINTS_PER_DECADE = 5


class Glide:
    """The fall of the particle from a start, and what the hoop below it does."""

    def __init__(self, offset, slope, theta, rate, slip):
        self.offset, self.theta = mpf(offset), mpf(theta)
        self.weight, self.pull = mp.cos(mpf(slope)), mp.sin(mpf(slope))
        sin, cos = mp.sin(self.theta), mp.cos(self.theta)
        self.side = 1 if sin > 0 else -1
        self.turns = mp.nint(self.theta / (2 * mp.pi) - mpf(self.side) / 4)
        self.depth = 2 * self.offset * mp.sin(self.theta / 2) ** 2
        self.rise = -self.offset * sin * rate
        self.momentum = slip - mpf(rate) * (1 + self.offset * cos)

    def at(self, time):
        """Depth of the particle below the top, height over the bottom, rate of fall."""
        fallen = time * (self.weight * time / 2 - self.rise)
        depth = self.depth + fallen
        return depth, 2 * self.offset - depth, self.weight * time - self.rise

    def scaled_slip(self, time):
        """The slip times |offset sin theta|."""
        depth, height, fall = self.at(time)
        arm = mp.sqrt(max(depth * height, mpf(0)))
        momentum = self.momentum - self.pull * time
        return momentum * arm + self.side * fall * (1 - self.offset + height)

    def end(self):
        """How the glide ends if the slip does not, and when."""
        square = self.rise**2 - 2 * self.weight * self.depth
        if self.rise > 0 and square > 0:
            return "top", 2 * self.depth / (self.rise + mp.sqrt(square))
        square = self.rise**2 + 2 * self.weight * (2 * self.offset - self.depth)
        return "bottom", (self.rise + mp.sqrt(square)) / self.weight

    def instants(self, end):
        steps = [
            mpf(10) ** (-mpf(k) / POINTS_PER_DECADE) for k in range(DECADES * POINTS_PER_DECADE)
        ]
        near = [end * step for step in steps]
        late = [end * (1 - step) for step in steps[1:]]
        turn = self.rise / self.weight
        close = steps[1 : 30 * POINTS_PER_DECADE]
        about = [turn * (1 + sign * step) for step in close for sign in (-1, 1)]
        return sorted(time for time in near + late + about + [turn] if 0 < time < end)

    def direction_and_rest(self, slip):
        """The direction of the slip that begins, and when it ends."""
        _, end = self.end()
        sign = mp.sign(slip)
        before = mpf(0)
        for time in self.instants(end):
            now = mp.sign(self.scaled_slip(time))
            if sign == 0:
                sign = now
            elif now != sign:
                low, high = before, time
                while high - low > mpf(10) ** -40 * high:
                    middle = (low + high) / 2
                    if mp.sign(self.scaled_slip(middle)) == sign:
                        low = middle
                    else:
                        high = middle
                return int(sign), (low + high) / 2
            before = time
        return int(sign), None

    def place(self, time):
        depth, height, fall = self.at(time)
        arm = mp.sqrt(depth * height)
        angle = 2 * mp.atan2(mp.sqrt(depth), mp.sqrt(height))
        return 2 * mp.pi * self.turns + self.side * angle, self.side * fall / arm


def rolling_forces(offset, slope, theta, rate):
    """N and F of a particle that rolls with the hoop: the force points from the contact to it."""
    l, u = mpf(offset), mpf(rate) ** 2
    sin, cos = mp.sin(theta), mp.cos(theta)
    weight, pull = mp.cos(mpf(slope)), mp.sin(mpf(slope))
    lever = 1 + l * cos
    # x'' = -lever a + l sin u, y'' = -l sin a - l cos u; F lever + l sin N = 0.
    still = lever * (l * sin * u + pull) + l * sin * (weight - l * cos * u)
    acceleration = still / (lever**2 + (l * sin) ** 2)
    normal = weight - l * (sin * acceleration + cos * u)
    return normal, pull - lever * acceleration + l * sin * u


def rolls(hoop, theta, rate):
    """Whether it rolls from rest there; None where that is close."""
    normal, friction = rolling_forces(hoop["offset"], hoop["slope"], theta, rate)
    margin = min(normal, hoop["mu_s"] * normal - abs(friction))
    if abs(margin) < 1e-9 and not (hoop["mu_s"] == 0 and theta != 0):
        return None
    return bool(margin > 0)


def number(value):
    return mp.nstr(value, DIGITS)


def drawn(draw, kind):
    def tiny(low, high):
        return draw.choice([-1, 1]) * 10 ** draw.uniform(low, high)

    hoop = {
        "offset": draw.choice([1.0, draw.uniform(0.05, 1), draw.uniform(0.05, 1)]),
        "mu_s": draw.choice([0.0, draw.uniform(0, 1), draw.uniform(0, 1)]),
        "slope": draw.choice([0.0, 0.0, draw.uniform(-1, 1)]),
    }
    if kind == "top":
        theta = tiny(-323.3, draw.choice([-300, -140, -60, -5]))
        rate = draw.choice([0.0, tiny(-3, 1), tiny(-3, 1), tiny(-200, -3)])
        slip = draw.choice([0.0, tiny(-3, 1), tiny(-3, 1), tiny(-200, -3)])
    elif kind == "slip":
        theta = draw.uniform(-3.1, 3.1)
        rate = draw.choice([0.0, tiny(-320, -100), tiny(-3, 1)])
        slip = tiny(-320, -20)
    else:
        hoop["offset"] = 10 ** draw.uniform(-60, -1)
        fall = hoop["offset"] ** -0.5
        theta = draw.choice([draw.uniform(-3.1, 3.1), tiny(-323.3, -5)])
        rate = draw.choice([0.0, tiny(-3, 1), min(tiny(-3, 0) * fall, 1e5, key=abs)])
        slip = draw.choice([0.0, tiny(-3, 1), tiny(-200, -3), -rate * draw.uniform(0.9, 1.1)])
    return hoop, [theta, rate, slip]


def entry(draw, kind):
    hoop, start = drawn(draw, kind)
    theta, rate, slip = start
    if theta == 0 or (slip == 0 and rolls(hoop, mpf(theta), rate) is not False):
        return None
    glide = Glide(hoop["offset"], hoop["slope"], *start)
    direction, rest = glide.direction_and_rest(slip)
    cause, time = glide.end()
    found = {"kind": kind, "hoop": list(hoop.values()), "start": start, "direction": direction}
    if rest is None:
        return found | {"cause": cause, "time": number(time)}
    there = glide.place(rest)
    names = ["theta", "theta_rate"]
    state = {name: number(value) for name, value in zip(names, there)}
    follows = rolls(hoop, *there)
    return found | {"cause": "rest", "time": number(rest)} | state | {"rolls": follows}


def main():
    draw = random.Random(51)
    glides = []
    for kind, count in [("top", 160), ("slip", 80), ("offset", 60)]:
        while sum(it["kind"] == kind for it in glides) < count:
            found = entry(draw, kind)
            if found:
                glides.append(found)
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "glides.json")
    with open(path, "w", encoding="utf-8") as file:
        json.dump({"glides": glides}, file, indent=1)
        file.write("\n")


if __name__ == "__main__":
    main()
