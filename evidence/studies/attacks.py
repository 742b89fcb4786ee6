"""`python -m evidence.studies.attacks [NAME…] [--tries N]`: random search against the theorems.

Motions, modes and impacts are those of evidence/reference/unseen, which shares no code with the
library. The tries and what they found stand in docs/studies/attacks.csv, from where the pages have
them; a test tries a few.
"""

from __future__ import annotations

import argparse
import csv
import math
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from .study import PAGES

sys.path.insert(0, str(Path(__file__).parents[1] / "reference"))
from unseen import balances, choice, draws, impact, walk  # type: ignore[import-not-found]

TABLE = PAGES / "attacks.csv"

SEED = 59

Random = np.random.Generator


class OffTopicError(Exception):
    """A draw that the theorem does not speak of."""


def require(condition: bool) -> None:
    """Leave out a draw."""
    if not condition:
        raise OffTopicError


def sized(random: Random, low: float, high: float) -> float:
    """Draw a number uniformly in its logarithm."""
    return float(math.exp(random.uniform(math.log(low), math.log(high))))


@dataclass(frozen=True, kw_only=True)
class Body:
    """A hoop of the draws, and per unit of its mass."""

    mass_ratio: float
    offset: float
    inertia: float
    mu_s: float
    mu_k: float
    chi: float = 0.0
    slope: float = 0.0

    @property
    def hoop(self) -> Any:
        """The hoop of the independent program, which takes its numbers in this order."""
        return balances.Hoop(*vars(self).values())

    @property
    def h(self) -> float:
        """Distance of the mass centre."""
        return self.offset / (1.0 + self.mass_ratio)

    @property
    def rho(self) -> float:
        """Î/m."""
        return float(self.hoop.i / self.hoop.m)

    def follow(
        self,
        theta: float,
        rate: float,
        slip: float = 0.0,
        gap_rate: float = 0.0,
        *,
        until: float = 8.0,
        e: float | None = None,
        most: int = 20,
    ) -> Any:
        """Follow a motion by the independent program."""
        numbers = tuple(vars(self).values())
        bounce = None if e is None else (e, "energetic")
        start = (theta, rate, slip, gap_rate)
        try:
            found = walk.follow(draws.Given(numbers, start, bounce, until), most)
        except (ArithmeticError, np.linalg.LinAlgError, ValueError) as error:
            raise OffTopicError from error
        require(not found.ended.startswith("tie"))
        return found


def any_body(random: Random, **more: float) -> Body:
    """Draw a hoop; μs is the larger of two coefficients or equal."""
    ratio, mu_s = sized(random, 0.01, 10.0), sized(random, 0.05, 2.0)
    given = {
        "mass_ratio": ratio,
        "offset": float(random.choice([1.0, random.uniform(0.1, 1.0)])),
        "inertia": ratio * random.uniform(0.2, 1.0),
        "mu_s": mu_s,
        "mu_k": mu_s * float(random.choice([1.0, random.uniform(0.4, 1.0)])),
    }
    return Body(**{**given, **more})


def thin(random: Random, low: float, high: float, **more: float) -> Body:
    """Draw a thin hoop with the particle on its rim, and friction over its Painlevé threshold."""
    gamma = 1.0 - sized(random, 1e-3, 0.9)
    ratio = 1.0 / gamma - 1.0
    mu = math.sqrt((1.0 - gamma) * (1.0 + gamma)) / gamma * sized(random, low, high)
    given = {"mass_ratio": ratio, "offset": 1.0, "inertia": ratio, "mu_s": mu, "mu_k": mu}
    return Body(**{**given, **more})


def least_p(body: Body, mu: float) -> float:
    """Return the least P/m over all angles and directions."""
    theta = np.linspace(0.0, math.pi, 721)
    a, d = body.h * np.sin(theta), 1.0 + body.h * np.cos(theta)
    return float(np.min(body.rho + a * (a - mu * d - body.chi)))


def one_angle(random: Random) -> str:
    """The turn in the air depends on the angle of lift-off alone."""
    body = any_body(random)
    walked = body.follow(
        random.uniform(-3.0, 3.0), random.normal() / math.sqrt(body.h), random.normal()
    )
    causes = [one.cause for one in walked.events]
    require("lift_off" in causes and causes[-1] == "landing")
    off, on = (walked.events[k].state for k in (causes.index("lift_off"), -1))
    require(causes.index("lift_off") == len(causes) - 2)
    angle, turned = abs(math.remainder(off.theta, 2.0 * math.pi)), abs(on.theta - off.theta)
    missed = math.sin(angle) * (turned - math.sin(turned)) - math.cos(angle) * (
        math.cos(turned) - 1.0 + 0.5 * turned**2
    )
    return "" if abs(missed) < 1e-9 * (1.0 + turned**3) else f"{body} misses {missed:.1e}"


def jams(body: Body, walked: Any) -> bool:
    """Whether a slide that ran next to P = 0 jams: the first integral leaves slip there."""
    if walked.ended != "singular: sliding":
        return False
    state, side = walked.state, walked.mode.slips
    theta, slip, rate = side * state.theta, side * state.slip, side * state.rate
    s, c = math.sin(theta), math.cos(theta)
    lever = 1.0 + body.h * c + body.mu_k * body.h * s
    return c > 0.0 and slip - lever * (rate + 1.0 / math.sqrt(body.h * c)) > 0.0


def jam_bounds(random: Random) -> str:
    """A slide jams between two frictions only."""
    body = any_body(random)
    # P = 0 for a slip to the right at a random angle next to those that matter.
    h, rho, theta = body.h, body.rho, random.uniform(0.05, 2.0)
    s, c = math.sin(theta), math.cos(theta)
    mu = (rho + h * h * s * s) / (h * s * (1.0 + h * c))
    require(mu < 20.0)
    body = Body(**{**vars(body), "mu_s": mu, "mu_k": mu})
    near = sized(random, 0.1, 1.0)
    rate, slip = -random.uniform(0.1, 1.0) / math.sqrt(h), sized(random, 1.0, 30.0)
    walked = body.follow(theta + near, rate, slip, most=1)
    require(walked.ended == "singular: sliding" and not walked.events and jams(body, walked))
    # On the way into a jam N grows without bound; where a lift-off is next to P = 0 it falls.
    earlier = body.follow(theta + near, rate, slip, until=walked.state.time - 1e-5, most=1)
    before, after = (
        balances.solved(body.hoop, walked.mode, one.state)[2] for one in (earlier, walked)
    )
    require(after > before)
    # Where it is, which may be another zero of P than the one that was drawn.
    s, c = math.sin(walked.state.theta), math.cos(walked.state.theta)
    growth = h * h * s * s * (h + c) - rho * (c + h * (2.0 * c * c - 1.0))
    exponent = 2.0 * rho * c * (1.0 + h * c) / growth
    # Next to the ends the slip or the contact ends nearer to P = 0 than doubles tell.
    require(growth < 0.0 or not (-0.3 < exponent <= 0.0 or 1.0 <= exponent < 1.3))
    return "" if growth > 0.0 and 0.0 < exponent < 1.0 else f"{body} jams with λ = {exponent:.3f}"


def jam_without_slip(random: Random) -> str:
    """A slide of a rim hoop that begins without slip does not jam."""
    body = thin(random, 1.0, 30.0)
    walked = body.follow(random.uniform(-math.pi, math.pi), random.normal() * sized(random, 0.1, 3))
    return f"{body} jams" if jams(body, walked) else ""


def bounce_of_light_hoops(random: Random) -> str:
    """A bounce with |V| < 2 μk v, 0 among them, leaves −½ v (2 μs Î)^⅓ (1 + μk/2μs)."""
    mu_k = random.uniform(0.1, 1.0)
    mu_s = mu_k * float(random.choice([1.0, random.uniform(1.0, 1.5)]))
    height, way = random.uniform(0.1, 0.3), float(random.choice([-1.0, 1.0]))
    speed = math.sqrt(2.0 * height)
    drift = float(random.choice([0.0, random.uniform(-0.6, 0.6)])) * 2.0 * mu_k * speed
    theta, off = way * math.acos(height - 1.0), []
    require(abs(math.tan(0.5 * theta)) > 1.05 * mu_s)
    for size in (1e-3, 3e-5):
        body = Body(mass_ratio=0.0, offset=1.0, inertia=size, mu_s=mu_s, mu_k=mu_k)
        walked = body.follow(theta, 0.0, drift, until=1.5 * speed)
        require(walked.ended == "time_limit")
        end = walked.state
        left = end.slip - (1.0 + math.cos(end.theta)) * end.rate
        law = -0.5 * speed * (2.0 * mu_s * size) ** (1 / 3) * (1.0 + 0.5 * mu_k / mu_s)
        off.append(abs(left / (way * law) - 1.0))
    # θ′ at the bottom has the sign of θ.
    good = off[1] < 0.15 and off[1] < 0.6 * off[0] + 0.01
    return "" if good else f"μs {mu_s}, μk {mu_k}, V {drift}, b {height}: off by {off}"


def leaves_out_of_rolling(random: Random) -> str:
    """With P > 0 and e = 0 no motion leaves the plane straight out of rolling."""
    body = any_body(random, slope=random.uniform(0.05, 1.2))
    require(least_p(body, body.mu_s) > 0.0)
    walked = body.follow(random.uniform(-3.1, 3.1), random.normal() / math.sqrt(body.h))
    require(walked.first[0] == "rolling" and len(walked.events) > 0)
    bad = [one for one in walked.events if one.cause == "slip" and one.to == "flight"]
    return f"{body} leaves at {bad[0].state}" if bad else ""


def highest_climb(random: Random) -> str:
    """Released from rest a hoop that rolls climbs by less than Φ∗h."""
    from .slip_before_jump import best_turn, climb

    ratio, offset = sized(random, 0.01, 10.0), float(random.choice([1.0, random.uniform(0.1, 1.0)]))
    h, best = offset / (1.0 + ratio), climb(best_turn()) / best_turn()
    sine = h * float(random.choice([best, random.uniform(0.02, 0.99)]))
    slope = math.asin(sine)
    body = Body(
        mass_ratio=ratio,
        offset=offset,
        inertia=ratio * random.uniform(0.2, 1.0),
        mu_s=1e3,
        mu_k=1e3,
        # The independent program looks for turning points only where something resists.
        chi=1e-13,
        slope=slope,
    )
    # Below the unstable equilibrium downhill.
    theta = 2.0 * math.pi - math.asin(sine / h) - slope - sized(random, 1e-3, 2.0)
    walked = body.follow(theta, 0.0, until=1e3, most=1)
    require(walked.first[0] == "rolling")
    require([one.cause for one in walked.events] == ["turning_point"])
    height = (theta - walked.events[0].state.theta) * sine
    require(height > 0.0)
    return "" if height < climb(best_turn()) * h else f"{body} from {theta} climbs {height / h} h"


def thrown(body: Body, theta: float, rate: float, e: float) -> tuple[float, float, float, float]:
    """Return w, a, b and the ratio of two small bounces out of rolling: flight and impact."""
    hoop, u = body.hoop, rate * rate
    w = hoop.down - body.h * math.cos(theta) * u
    push = -body.h * math.sin(theta) * u - hoop.along
    require(w > 1e-3)
    small = 1e-7
    before = balances.State(0.0, theta, rate, 2.0 * push * small / w, 0.0, -small)
    # The rate is much greater than the bounce, so that it keeps its sign.
    _, slip, opening, _ = impact.impact(hoop, before, e, "energetic")
    require(abs(slip) < 1e-9 * small)
    lever, arm = 1.0 + body.h * math.cos(theta), body.h * math.sin(theta)
    stick = abs(arm) * lever / (body.rho + lever**2)
    return w, push * arm, stick, opening / small


def bounces_grow(random: Random) -> str:
    """Bounces that stick grow only on slopes, with aB > 0 and 2bϱ > 1/e − 1."""
    level = random.random() < 0.3
    body = any_body(random, slope=0.0 if level else random.uniform(-1.2, 1.2))
    theta, e = random.uniform(-3.1, 3.1), random.uniform(0.3, 0.99)
    rate = float(random.choice([0.0, random.normal()]))
    try:
        w, product, stick, ratio = thrown(body, theta, rate, e)
    except balances.Tie as error:
        raise OffTopicError from error
    push = abs(product) / (body.h * abs(math.sin(theta)))
    most = e * (1.0 + 2.0 * stick * push / w) if product > 0.0 and not level else e
    return "" if ratio <= most * (1.0 + 1e-6) else f"{body} at {theta}, {rate}: {ratio} > {most}"


def slip_begins(random: Random) -> str:
    """A slide that begins has |η″| of at least (μs − μk) D Î w/(Pk Ps)."""
    body = any_body(random)
    require(body.mu_s > body.mu_k and least_p(body, body.mu_s) > 0.0)
    theta, rate = random.uniform(-3.1, 3.1), random.normal() / math.sqrt(body.h)
    state = balances.State(0.0, theta, rate, 0.0, 0.0)
    hoop, arm = body.hoop, body.h * math.sin(theta)
    w, lever = 1.0 - body.h * math.cos(theta) * rate**2, 1.0 + body.h * math.cos(theta)
    require(w > 0.0)
    modes = [one for one in choice.possible(hoop, state) if one.name == "sliding"]
    require(len(modes) == 1)
    x2, turn, *_ = balances.solved(hoop, modes[0], state)
    static, kinetic = (
        hoop.i + hoop.m * arm * (arm - modes[0].slips * mu * lever) for mu in (body.mu_s, body.mu_k)
    )
    d = hoop.i + hoop.m * (arm**2 + lever**2)
    least = (body.mu_s - body.mu_k) * d * hoop.i * w / (static * kinetic)
    good = abs(x2 + turn) >= least * (1.0 - 1e-9) or static <= 0.0
    return "" if good else f"{body} at {theta}, {rate}: {abs(x2 + turn)} < {least}"


def slips_fade(random: Random) -> str:
    """Just above the limit slips with μs = μk do not end, and take c ε² off the distance ε."""
    from .contact import Contact
    from .grazing import grazing_orbits

    h, mu = random.uniform(0.1, 0.9), sized(random, 0.05, 1.0)
    ratio = 1.0 / h - 1.0
    inertia = ratio * random.uniform(0.2, 1.0)
    body = Body(mass_ratio=ratio, offset=1.0, inertia=inertia, mu_s=mu, mu_k=mu)
    require(least_p(body, mu) > 0.0)
    contact = Contact(body.hoop.m, body.h, body.hoop.i)
    orbits = grazing_orbits(contact, mu)
    require(bool(orbits))
    orbit, off = orbits[0], []
    law = orbit.loss(mu)
    for small in (2e-4, 1e-5):
        begin = orbit.energy + small / law
        rate = math.sqrt(2.0 * (begin + contact.m * contact.h) / contact.denominator(math.pi))
        walked = body.follow(math.pi, rate, until=1e3, most=5)
        if walked.ended == "time_limit":
            return f"{body} with the energy {begin} slips no more"
        require([one.cause for one in walked.events] == ["slip", "stick", "slip", "stick", "slip"])
        slips = [one.state for one in walked.events if one.cause == "slip"]
        # Farther above the limit it slips elsewhere, too.
        width = orbit.rate * math.sqrt(2.0 * orbit.rise * small / law / orbit.fall)
        angles = [abs(math.remainder(one.theta, 2.0 * math.pi)) for one in slips]
        at = abs(math.remainder(orbit.theta, 2.0 * math.pi))
        require(all(abs(angle - at) < 3.0 * width for angle in angles))
        left = [contact.energy(one.theta, one.rate**2) - orbit.energy for one in slips]
        off.append(max(abs((1.0 / b - 1.0 / a) / law - 1.0) for a, b in pairwise(left)))
    # The law leaves terms of the root of ε, which is smaller by the factor 4.5.
    good = off[1] < 0.4 * off[0] + 0.003
    return "" if good else f"{body}: off by {off}"


def band(random: Random) -> str:
    """A start in the band has one motion, a slide against sign sin θ."""
    body = any_body(random)
    theta, rate = random.uniform(-3.1, 3.1), random.normal() * 2.0 / math.sqrt(body.h)
    state = balances.State(0.0, theta, rate, 0.0, 0.0)
    w = 1.0 - body.h * math.cos(theta) * rate**2
    turns = 1 if rate > 0.0 else -1
    normal = balances.solved(body.hoop, balances.contact(0, turns, False), state)[2]
    require(w > 0.0 > normal)
    modes = choice.possible(body.hoop, state)
    side = -1 if math.sin(theta) > 0.0 else 1
    good = [(one.name, one.slips) for one in modes] == [("sliding", side)]
    return "" if good else f"{body} at {theta}, {rate}: {modes}"


def turns_for_ever(random: Random) -> str:
    """The rough family returns: flights over the top and under the bottom in turn."""
    h = random.uniform(0.05, 0.95)
    rho, angle = (1.0 - h * h) * random.uniform(0.1, 1.0), random.uniform(0.3, 2.8)
    a, lever = h * math.sin(angle), 1.0 + h * math.cos(angle)
    j = 2.0 * a / (rho + a * a + lever**2)
    alpha = 1.0 - j * a
    require(alpha > 0.05)
    first, middle, last = (
        a * alpha * (1.0 + alpha),
        math.pi - 2.0 * alpha**2 * angle,
        -alpha * j * angle**2,
    )
    u = (-middle + math.sqrt(middle**2 - 4.0 * first * last)) / (2.0 * first)
    rate = math.sqrt(u)
    v = angle / rate - a * rate
    require(v > 1e-3 and angle / rate > 2.0 * math.sqrt(h) * math.sin(0.5 * angle))
    # Any body with this h and Î/m: m = 1/(1 − part), the rest of the inertia in I_zz.
    ratio = 1.0 / h - 1.0
    inertia = rho / h - ratio * h * h - (1.0 - h) ** 2
    require(inertia > 0.0)
    body = Body(mass_ratio=ratio, offset=1.0, inertia=inertia, mu_s=50.0, mu_k=50.0)
    walked = body.follow(angle, rate + j * v, 0.0, v, e=1.0, until=1e3, most=4)
    require(len(walked.events) >= 4)
    off = max(
        abs(abs(math.remainder(one.state.theta, 2.0 * math.pi)) - angle)
        + abs(abs(one.state.opening) - v)
        for one in walked.events
    )
    return "" if off < 1e-6 * (1.0 + v) else f"h {h}, ϱ {rho}, φ {angle}: off by {off:.1e}"


def best_hop(random: Random) -> str:
    """With its energy a slide lifts off within an angle from the top."""
    body = any_body(random)
    theta, rate = random.uniform(-3.0, 3.0), random.normal() * 1.5 / math.sqrt(body.h)
    slip, h, rho = random.normal() * float(random.choice([0.0, 1.0])), body.h, body.rho
    walked = body.follow(theta, rate, slip, most=20)
    off = [one.state for one in walked.events if one.cause == "lift_off"][:1]
    require(bool(off))
    along = slip - (1.0 + h * math.cos(theta)) * rate
    energy = 0.5 * along**2 + 0.5 * (rho + (h * math.sin(theta)) ** 2) * rate**2
    energy += h * math.cos(theta)
    least = energy - math.sqrt(max(0.0, energy**2 - rho - h * h))
    good = h * math.cos(off[0].theta) >= least - 1e-9
    return "" if good else f"{body} from {theta}, {rate}, {slip} lifts off at {off[0].theta}"


def resisted(random: Random, low: float, high: float) -> Body:
    """Draw a hoop with rolling resistance."""
    return any_body(random, chi=sized(random, low, high))


def rests(random: Random) -> str:
    """With P > 0 everywhere a level motion that keeps contact rests."""
    body = resisted(random, 0.02, 1.0)
    require(least_p(body, body.mu_k) > 0.0)
    start = (random.uniform(-math.pi, math.pi), random.normal(), random.normal())
    walked = body.follow(*start, until=2000.0, most=2000)
    require(walked.ended in ("rests", "time_limit", "most"))
    return "" if walked.ended == "rests" else f"{body} from {start} does not rest: {walked.ended}"


def dead_stop(random: Random) -> str:
    """Where D_χ < 0 a contact that yields takes m|aθ′| and mdθ′, and stops the hoop."""
    from .compliant import Yielding

    ratio, chi = sized(random, 3e-4, 1e-2), random.uniform(0.3, 1.0)
    body = Body(mass_ratio=ratio, offset=1.0, inertia=ratio, mu_s=1.0, mu_k=1.0, chi=chi)
    theta, rate = math.pi - random.uniform(0.05, 1.2), random.uniform(0.2, 2.0)
    a, d, u = body.h * math.sin(theta), 1.0 + body.h * math.cos(theta), rate**2
    j = body.rho + d * d
    require(j + a * (a - chi) < -0.2 * j)
    require(j * (1.0 - body.h * math.cos(theta) * u) > 1.2 * a * a * d * u)
    need = d * abs(a - chi) / j
    require(need < 5.0)
    hoop = body.hoop
    model = Yielding(
        mass=hoop.m,
        h=body.h,
        inertia=hoop.i,
        mu=1.2 * need,
        chi=chi,
        stiffness=1e9,
        damping=float(random.choice([0.0, 0.5, 1.0])),
    )
    end = model.jam(theta, rate)[:, -1]
    off = (
        abs(end[5] / (hoop.m * a * rate) - 1.0),
        abs(end[6] / (hoop.m * d * rate) - 1.0),
        abs(end[3] / rate),
    )
    return "" if max(off) < 0.02 else f"{body} at {theta}, {rate}: off by {off}"


def has_a_motion(random: Random) -> str:
    """With χ < 2 √(Î/m) a level state without slip has a motion."""
    body = resisted(random, 0.01, 3.0)
    mu = sized(random, 0.01, 20.0)
    body = Body(**{**vars(body), "mu_s": mu * random.choice([1.0, 1.3]), "mu_k": mu})
    require(body.chi < 2.0 * math.sqrt(body.rho))
    theta, rate = random.uniform(-math.pi, math.pi), random.normal() * sized(random, 0.1, 5.0)
    state = balances.State(0.0, theta, rate, 0.0, 0.0)
    modes = choice.possible(body.hoop, state)
    return "" if modes else f"{body} at {theta}, {rate} has no motion"


def resisted_jam(random: Random) -> str:
    """With χ < 2 √(Î/m) no slide of a rim hoop that begins without slip was seen to jam."""
    body = thin(random, 0.3, 30.0)
    chi = 2.0 * math.sqrt(body.rho) * random.uniform(0.0, 1.0)
    body = Body(**{**vars(body), "chi": chi})
    walked = body.follow(random.uniform(-math.pi, math.pi), random.normal() * sized(random, 0.1, 3))
    bad = jams(body, walked) or walked.ended == "inconsistent"
    return f"{body} {walked.ended}" if bad else ""


def half_swings(random: Random) -> str:
    """The half swings to rest are S/χ − ½, rounded up, but for O(χ)."""
    from .contact import Contact
    from .rolling_resistance import Swings

    body = any_body(random, mu_s=50.0, mu_k=50.0, chi=sized(random, 0.01, 0.05))
    amplitude = random.uniform(0.3, 2.8)
    walked = body.follow(math.pi - amplitude, 0.0, until=1e5, most=400)
    require(walked.ended == "rests" and {one.cause for one in walked.events} == {"turning_point"})
    law = Swings(Contact(body.hoop.m, body.h, body.hoop.i)).number(amplitude) / body.chi - 0.5
    missed = len(walked.events) - law
    require(body.chi < 0.3 * body.h)
    good = -4.0 * body.chi < missed < 1.0 + 4.0 * body.chi
    return "" if good else f"{body} from {amplitude}: {len(walked.events)} for {law}"


def creep_of_a_cone(random: Random) -> str:
    """By one cone for friction and resistance a ball that rolls tends to slip by κ."""
    from .mujoco_cone import creep, forces

    mu, chi, rho = sized(random, 0.05, 2.0), sized(random, 0.02, 1.0), random.uniform(0.2, 1.0)
    slip, spin = 0.0, 1.0
    for _ in range(200_000):
        friction, couple = forces(mu, chi, slip, spin)
        # A step is a thousandth of the spin that is left.
        step = 1e-3 * abs(spin) * rho / (chi + mu)
        turn = (friction + couple) / rho
        slip, spin = slip + step * (friction + turn), spin + step * turn
        if spin < 1e-6:
            break
    off = slip / spin - creep(mu, chi, rho)
    return "" if abs(off) < 5e-3 else f"μ {mu}, χ {chi}, ϱ {rho}: off by {off}"


@dataclass(frozen=True)
class Attack:
    """A theorem of a study, and a try against it: it returns a counterexample or nothing."""

    study: str
    theorem: str
    tries: int
    attempt: Callable[[Random], str]


ATTACKS = (
    Attack("one-angle", "angle", 5_000, one_angle),
    Attack("jam", "bounds", 4_000, jam_bounds),
    Attack("jam", "without slip", 1_200, jam_without_slip),
    Attack("massless-limit", "bounce", 300, bounce_of_light_hoops),
    Attack("best-hop", "angle", 1_500, best_hop),
    Attack("bouncing-for-ever", "turning", 3_000, turns_for_ever),
    Attack("slip-before-jump", "leaves", 2_000, leaves_out_of_rolling),
    Attack("slip-before-jump", "climb", 3_000, highest_climb),
    Attack("bounces-out-of-nothing", "ratio", 20_000, bounces_grow),
    Attack("how-many-slips", "begins", 15_000, slip_begins),
    Attack("how-many-slips", "fades", 2_000, slips_fade),
    Attack("band", "motion", 15_000, band),
    Attack("rolling-resistance", "rest", 2_000, rests),
    Attack("rolling-resistance", "dead stop", 300, dead_stop),
    Attack("rolling-resistance", "motion", 40_000, has_a_motion),
    Attack("rolling-resistance", "jam", 2_500, resisted_jam),
    Attack("rolling-resistance", "swings", 500, half_swings),
    Attack("mujoco-cone", "creep", 200, creep_of_a_cone),
)
"""All attacks; `tries` is how many draws the long search makes."""


def search(attack: Attack, tries: int, seed: int = SEED) -> tuple[int, list[str]]:
    """Return how many draws the theorem speaks of, and what contradicts it."""
    tried, found = 0, []
    for k in range(tries):
        try:
            answer = attack.attempt(np.random.default_rng([seed, k]))
        except (OffTopicError, balances.Tie, balances.Singular):
            continue
        tried += 1
        if answer:
            found.append(answer)
    return tried, found


@cache
def results() -> dict[tuple[str, str], tuple[int, int]]:
    """Return tries and counterexamples of the long search."""
    if not TABLE.exists():
        return {}
    with TABLE.open(encoding="utf-8") as file:
        return {
            (row["study"], row["theorem"]): (int(row["tried"]), int(row["contradict"]))
            for row in csv.DictReader(file)
        }


def said(study: str, theorem: str) -> str:
    """Return the words of a page: how many tries there were, and what they found."""
    tried, contradict = results()[study, theorem]
    return f"{contradict} of {tried} tries"


def main() -> int:
    """Search, and write the table; 1 if something is found."""
    parser = argparse.ArgumentParser(prog="python -m evidence.studies.attacks", description=__doc__)
    parser.add_argument(
        "names", nargs="*", metavar="NAME", help="STUDY or STUDY/THEOREM; all, if none is given"
    )
    parser.add_argument("--tries", type=int, help="draws of each attack; nothing is written")
    arguments = parser.parse_args()
    rows = {key: [*key, *map(str, value)] for key, value in results().items()}
    for attack in ATTACKS:
        both = f"{attack.study}/{attack.theorem}"
        if arguments.names and not {attack.study, both} & {*arguments.names}:
            continue
        begin = time.perf_counter()
        tried, found = search(attack, arguments.tries or attack.tries)
        print(
            f"{attack.study}, {attack.theorem}: {len(found)} of {tried}, "
            f"{time.perf_counter() - begin:.0f} s",
            *found[:3],
            sep="\n  ",
            flush=True,
        )
        rows[attack.study, attack.theorem] = [
            attack.study,
            attack.theorem,
            str(tried),
            str(len(found)),
        ]
        if not arguments.tries:
            with TABLE.open("w", encoding="utf-8", newline="") as file:
                writer = csv.writer(file, lineterminator="\n")
                writer.writerow(["study", "theorem", "tried", "contradict"])
                writer.writerows(
                    rows[one.study, one.theorem]
                    for one in ATTACKS
                    if (one.study, one.theorem) in rows
                )
    return int(any(row[3] != "0" for row in rows.values()))


if __name__ == "__main__":
    sys.exit(main())
