"""Random starts, by families: how they are drawn, and what their motions must have."""

import math
import random
from typing import NamedTuple

PI = 3.141592653589793


class Given(NamedTuple):
    """What is given of a motion; the hoop's numbers are those of `Body`."""

    hoop: tuple
    start: tuple  # theta, theta', eta', rate of the gap
    until: float
    bounce: tuple | None = None


class Family(NamedTuple):
    """A family: how many motions, how one is drawn, and whether a motion belongs to it."""

    count: int
    draw: object
    belongs: object


class Draws:
    """Rounded random numbers, so that a motion can be typed."""

    def __init__(self, seed):
        self.random = random.Random(seed)

    def number(self, low, high, digits=3):
        return round(self.random.uniform(low, high), digits)

    def power(self, low, high):
        """Between powers of ten, with three significant digits."""
        return float(f"{10 ** self.random.uniform(low, high):.3g}")

    def one_of(self, *values):
        return self.random.choice(values)

    def hoop(self, chi, mu_s=(0.4, 1.2), slope=0.0, light=False):
        mass_ratio = self.power(-2, -0.7) if light else self.number(0.1, 2.5)
        inertia = round(mass_ratio * self.random.uniform(0.3, 1), 5)
        static = self.number(*mu_s)
        kinetic = self.one_of(static, round(static * self.random.uniform(0.5, 1), 3))
        return mass_ratio, self.number(0.2, 1), inertia, static, kinetic, chi, slope

    def restitution(self, *values):
        return self.one_of(*values), self.one_of("energetic", "poisson", "newton")


def names(motion):
    return {one.mode.name for one in motion.phases}


def causes(motion):
    return [one.cause for one in motion.transitions]


def rests(motion):
    return motion.ended == "rests"


def turned(motion):
    return abs(motion.state.theta - motion.phases[0].state.theta)


def segments(motion):
    """The largest number of segments of an impact."""
    return max(
        (len(t.landing[1].segments) for t in motion.transitions if t.landing and t.landing[1]),
        default=0,
    )


def librates(d):
    start = PI + d.number(0.4, 2.4) * d.one_of(-1, 1), 0.0, 0.0, 0.0
    return Given(d.hoop(d.power(-1.7, -0.7)), start, 1000.0)


def rotates(d):
    start = d.number(-3.1, 3.1), d.number(1.5, 3.5) * d.one_of(-1, 1), 0.0, 0.0
    return Given(d.hoop(d.power(-1.2, -0.4), (1.0, 2.0)), start, 1000.0)


def slips(d):
    start = d.number(-3.1, 3.1), d.number(-2.5, 2.5), d.one_of(0.0, d.number(-1, 1)), 0.0
    return Given(d.hoop(d.power(-2, -0.3), (0.1, 0.5)), start, 1000.0)


def lifts_off(d):
    start = d.number(-3.1, 3.1), d.number(-3.5, 3.5), d.one_of(0.0, d.number(-1, 1)), 0.0
    return Given(
        d.hoop(d.power(-2, -0.3), (0.1, 0.8), d.one_of(0.0, d.number(-0.3, 0.3))), start, 40.0
    )


def skids(d):
    """From a state that does not turn, or turns slowly."""
    start = d.number(-3.1, 3.1), d.one_of(0.0, d.number(-0.3, 0.3)), d.number(-1.5, 1.5), 0.0
    return Given(d.hoop(d.power(-1.3, -0.1), (0.1, 0.8)), start, 1000.0)


def on_slopes(d):
    slope = d.number(-0.35, 0.35)
    start = d.number(-3.1, 3.1), d.number(-2, 2), d.one_of(0.0, d.number(-1, 1)), 0.0
    return Given(d.hoop(d.power(-1.5, -0.3), (0.3, 1.5), slope), start, 400.0)


def downhill(d):
    """A rotation that gains what resistance takes, for some turns."""
    chi = d.power(-2, -0.5)
    mass_ratio, offset, inertia, *_ = d.hoop(chi)
    slope = round(math.atan(chi * d.random.uniform(1.1, 1.4)), 4) * d.one_of(-1, 1)
    start = PI, math.copysign(d.number(1.5, 2.5), slope), 0.0, 0.0
    return Given((mass_ratio, offset, inertia, 1.5, 1.2, chi, slope), start, d.number(8, 12, 1))


def discs(d):
    """A balanced hoop."""
    mass_ratio, _, inertia, mu_s, mu_k, chi, _ = d.hoop(d.power(-2, 0), (0.05, 0.8))
    slope = d.one_of(0.0, d.number(-0.8, 0.8))
    start = d.number(-3, 3), d.number(-2, 2), d.one_of(0.0, d.number(-2, 2)), 0.0
    return Given((mass_ratio, 0.0, inertia, mu_s, mu_k, chi, slope), start, 200.0)


def frictionless(d):
    """Without kinetic friction: what skids does so for ever."""
    mass_ratio, offset, inertia, mu_s, _, chi, _ = d.hoop(d.power(-1, -0.3), (0.0, 0.4))
    start = d.number(-3.1, 3.1), d.number(-1, 1), d.number(-1, 1), 0.0
    return Given((mass_ratio, offset, inertia, mu_s, 0.0, chi, 0.0), start, d.number(10, 30, 1))


def impacts(d):
    """Thrown up, with the first impacts."""
    hoop = d.hoop(d.power(-1.3, 0.2), (0.1, 1.5), d.one_of(0.0, 0.0, d.number(-0.3, 0.3)))
    start = d.number(-3.1, 3.1), d.number(-1, 1), d.number(-0.6, 0.6), d.number(0.3, 2)
    return Given(hoop, start, d.number(3, 6, 2), d.restitution(0.0, 0.3, 0.6, 0.9))


def settles(d):
    """Bounces to their end, and what follows."""
    start = d.number(-3.1, 3.1), d.number(-0.8, 0.8), d.number(-0.5, 0.5), d.number(0.05, 0.3)
    return Given(d.hoop(d.power(-1.3, 0), (0.1, 1)), start, 400.0, d.restitution(0.2, 0.4, 0.5))


def jams(d):
    """States of contact with no consistent motion, resolved by an impact without a collision."""
    hoop = d.hoop(d.power(-0.5, 0.6), (0.3, 3), light=True)
    start = d.number(-3.1, 3.1), d.number(-1.5, 1.5), d.one_of(0.0, d.number(-0.5, 0.5)), 0.0
    return Given(hoop, start, 400.0, d.restitution(0.0, 0.5))


def jams_of_rolling(d):
    """Without slip near the bottom, where a large resistance leaves rolling no normal force."""
    mass_ratio, _, inertia, *_ = d.hoop(0.0, light=True)
    mu_s = d.number(1, 4)
    start = PI + d.number(-0.6, 0.6), d.number(-1.5, 1.5), 0.0, 0.0
    hoop = mass_ratio, 1.0, inertia, mu_s, mu_s, d.power(0.2, 0.7), 0.0
    return Given(hoop, start, 400.0, d.restitution(0.0, 0.5))


def paradoxes(d):
    """The same without a law of restitution: no motion."""
    return d.one_of(jams, jams_of_rolling)(d)._replace(bounce=None)


def ambiguous(d):
    """Flight beside a slide, or beside rolling: a fast light hoop near the top."""
    mass_ratio, _, inertia, *_ = d.hoop(0.0, light=True)
    mu_s, chi = d.number(0.5, 4), d.power(-1, 0.5)
    start = (
        d.number(-1.2, 1.2),
        d.number(1, 3) * d.one_of(-1, 1),
        d.one_of(0.0, d.number(-1, 1)),
        0.0,
    )
    return Given((mass_ratio, 1.0, inertia, mu_s, mu_s, chi, 0.0), start, 400.0)


def massless(d):
    offset, mu_s = d.one_of(1.0, d.number(0.3, 1)), d.number(0.2, 1.5)
    hoop = 0.0, offset, 0.0, mu_s, round(mu_s * d.random.uniform(0.6, 1), 3), d.power(-2, -0.3), 0.0
    start = d.number(-2.8, 2.8), d.number(-0.9, 0.9), d.one_of(0.0, 0.0, d.number(-1, 1)), 0.0
    return Given(hoop, start, d.number(0.5, 6, 2))


FAMILIES = {
    "librates": Family(14, librates, lambda m: rests(m) and names(m) == {"rolling"}),
    "rotates": Family(10, rotates, lambda m: rests(m) and turned(m) > 7),
    "slips": Family(14, slips, lambda m: rests(m) and "slip" in causes(m)),
    "lifts_off": Family(10, lifts_off, lambda m: causes(m)[-2:] == ["lift_off", "landing"]),
    "skids": Family(14, skids, lambda m: rests(m) and "skidding" in names(m)),
    "on_slopes": Family(14, on_slopes, lambda m: rests(m) and len(m.phases) > 2),
    "downhill": Family(6, downhill, lambda m: m.ended == "time_limit" and turned(m) > 12),
    "discs": Family(12, discs, lambda m: len(m.phases) > 0),
    "frictionless": Family(6, frictionless, lambda m: names(m) > {"skidding"}),
    "impacts": Family(16, impacts, lambda m: segments(m) > 1),
    "impacts_of_many_segments": Family(6, impacts, lambda m: segments(m) > 2),
    "settles": Family(8, settles, lambda m: "settle" in causes(m) and rests(m)),
    "jams": Family(8, jams, lambda m: causes(m)[:1] == ["jam"]),
    "jams_of_rolling": Family(4, jams_of_rolling, lambda m: causes(m)[:1] == ["jam"]),
    "paradoxes": Family(8, paradoxes, lambda m: m.ended == "none" and not m.phases),
    "ambiguous": Family(4, ambiguous, lambda m: m.ended == "ambiguous" and not m.phases),
    "massless": Family(
        10, massless, lambda m: names(m) & {"rolling", "skidding"} and "turning" in causes(m)
    ),
}
