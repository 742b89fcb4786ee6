"""The jam of a loaded hoop: a slide that runs into P = 0 with slip left."""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import dataclass, replace
from functools import cache
from itertools import pairwise
from typing import Any

import littlewood as lw
import numpy as np
import numpy.typing as npt
from littlewood.plot.canvas import key, of_curve
from littlewood.plot.sheet import panels
from littlewood.style import ACCENTS, BOLD, FAINT, FINE, HATCH, INK, LIST_DASHES, PAPER
from matplotlib.figure import Figure

from .attacks import said
from .hoops import DEGREE, random_hoops, thin_hoop
from .page import table
from .roots import zero
from .study import Study

Array = npt.NDArray[np.float64]

COMSOL = 0.75
"""Part of the total mass that is in the particle, in the example "Dynamics of a Hopping Hoop" of
COMSOL, with μ = 1."""


SHALLOW = 0.15
"""Least λ of the sample. Below it w, which falls as ξ^λ, is not near zero at the least distance of
a double."""


@dataclass(frozen=True)
class Body:
    """What a jam knows of a hoop.

    Parameters
    ----------
    h : float
        Distance of the mass centre from the geometric centre.
    k2 : float
        Square of the radius of gyration about the mass centre, I/m.
    """

    h: float
    k2: float

    @classmethod
    def rim(cls, gamma: float) -> Body:
        """Return the thin hoop whose particle, on its rim, has the part `gamma` of the mass."""
        return cls(gamma, 1.0 - gamma**2)

    @classmethod
    def of(cls, hoop: lw.Hoop) -> Body:
        """Return that of a hoop."""
        return cls(hoop.h, hoop.inertia_about_mass_centre / hoop.mass)

    def friction_at(self, cosine: float) -> float:
        """Return the friction at which P vanishes at an angle of this cosine.

        σ = +1 and s > 0.
        """
        s2 = (1.0 - cosine) * (1.0 + cosine)
        return (self.k2 + self.h**2 * s2) / (self.h * math.sqrt(s2) * (1.0 + self.h * cosine))

    def growth(self, cosine: float) -> float:
        """Return the sign function of d μ_P/dθ: h² s² (h + c) − k² (c + h cos 2θ)."""
        c, h = cosine, self.h
        return h**2 * (1.0 - c) * (1.0 + c) * (h + c) - self.k2 * (c + h * (2.0 * c * c - 1.0))

    def exponent(self, cosine: float) -> float:
        """Return λ where P vanishes at an angle with this cosine."""
        return 2.0 * self.k2 * cosine * (1.0 + self.h * cosine) / self.growth(cosine)

    @property
    def least(self) -> float:
        """Cosine of the angle at which P first vanishes as friction grows.

        The only zero of `growth` on (0, 1).
        """
        return zero(self.growth, 0.0, 1.0)

    @property
    def one(self) -> float:
        """Cosine of the angle at which λ = 1: the only zero on (0, 1) of a cubic."""

        def cubic(cosine: float) -> float:
            return self.growth(cosine) - 2.0 * self.k2 * cosine * (1.0 + self.h * cosine)

        return zero(cubic, 0.0, 1.0)

    @property
    def painleve(self) -> float:
        """Least friction with P ≤ 0 somewhere."""
        return self.friction_at(self.least)

    @property
    def lower(self) -> float:
        """Friction above which a slide can jam."""
        return self.friction_at(self.one)

    @property
    def upper(self) -> float:
        """Friction below which a slide can jam."""
        return self.h + self.k2 / self.h

    def angle(self, mu: float) -> float:
        """Return the angle in (0, 90°) at which P vanishes and grows.

        For a friction between the bounds.
        """
        return math.acos(zero(lambda cosine: self.friction_at(cosine) - mu, 0.0, self.least))

    def friction_of(self, exponent: float) -> float:
        """Return the friction with this λ between 0 and 1."""
        return self.friction_at(
            zero(lambda cosine: self.exponent(cosine) - exponent, 0.0, self.one)
        )


@dataclass(frozen=True)
class Slides:
    """Many slides with σ = +1 towards their P = 0, by the linear equation in ln ξ.

    ξ is the distance from there.

    Parameters
    ----------
    h, k2, mu, theta : ndarray
        Bodies, friction, and the angles of P = 0.
    """

    h: Array
    k2: Array
    mu: Array
    theta: Array

    def solvability(self, xi: Array) -> Array:
        """Return P/m, without cancellation for small ξ."""
        turn = np.sin(2.0 * self.theta + xi) - self.mu * np.cos(2.0 * self.theta + xi)
        lift = 2.0 * self.mu * self.h * np.cos(self.theta + 0.5 * xi) * np.sin(0.5 * xi)
        result: Array = self.h**2 * np.sin(xi) * turn - lift
        return result

    def slope(self, log: Array, u: Array) -> Array:
        """Return du/d(ln ξ)."""
        xi = np.exp(log)
        s, c = np.sin(self.theta + xi), np.cos(self.theta + xi)
        q = self.h * s - self.mu * (1.0 + self.h * c)
        result: Array = 2.0 * q * (1.0 - self.h * c * u) * xi / self.solvability(xi)
        return result

    def path(self, start: Array, end: Array, u: Array, steps: int = 600) -> tuple[Array, Array]:
        """Return ξ and u from `start` to `end`, a row for each of equal steps in ln ξ.

        By Runge–Kutta.
        """
        log, step = np.log(start), (np.log(end) - np.log(start)) / steps
        logs, values = [log], [u]
        for _ in range(steps):
            one = self.slope(log, u)
            two = self.slope(log + 0.5 * step, u + 0.5 * step * one)
            three = self.slope(log + 0.5 * step, u + 0.5 * step * two)
            four = self.slope(log + step, u + step * three)
            log, u = log + step, u + step * (one + 2.0 * two + 2.0 * three + four) / 6.0
            logs.append(log)
            values.append(u)
        return np.exp(np.array(logs)), np.array(values)

    def boundary(self, end: Array) -> tuple[Array, Array]:
        """Return ξ and u* of the slide that passes through P = 0 smoothly, up to a distance `end`.

        Negative values continue the equation beyond the turning point of that slide.
        """
        c, s = np.cos(self.theta), np.sin(self.theta)
        exponent = self.exponent
        near = np.full_like(self.h, 1e-7) * np.minimum(1.0, end)
        w = s / c * near / (1.0 - exponent)
        return self.path(near, end, (1.0 - w) / (self.h * np.cos(self.theta + near)))

    def beyond(self, end: Array, steps: int = 4000) -> tuple[Array, Array]:
        """Return ξ and u* on to a distance `end` beyond the bottom.

        There a light hoop is fast within an angle of the root of its inertia, which steps in ln ξ
        would pass over.
        """
        first = np.full_like(self.h, 0.05)
        _, levels = self.boundary(first)
        bottom, width = math.pi - self.theta, np.sqrt(self.k2)
        low, high = (np.arcsinh((xi - bottom) / width) for xi in (first, end))
        xi = bottom + width * np.sinh(
            low + (high - low) * np.linspace(0.0, 1.0, steps + 1)[:, None]
        )
        u = [levels[-1]]
        for one, two in pairwise(xi):
            u.append(self.path(one, two, u[-1], 1)[1][-1])
        return xi, np.array(u)

    @property
    def exponent(self) -> Array:
        """λ."""
        bodies = zip(self.h, self.k2, np.cos(self.theta), strict=True)
        return np.array([Body(float(h), float(k2)).exponent(float(c)) for h, k2, c in bodies])


def rim_one(gamma: float) -> float:
    """Return the cosine at which λ = 1 of a rim hoop, in closed form."""
    k2 = 1.0 - gamma**2
    return 2.0 * gamma / (3.0 * k2 + math.sqrt(9.0 * k2**2 + 4.0 * gamma**2))


def rim_bounds() -> list[str]:
    """Bounds of friction of rim hoops."""
    rows = []
    for gamma in (0.1, 0.25, 0.5, 0.75, 0.9, 0.97, 0.99):
        body, c = Body.rim(gamma), rim_one(gamma)
        lower = (1.0 - gamma * c) / (gamma * math.sqrt(1.0 - c * c))
        widest = 1.0 / gamma
        rows.append(
            [
                f"{gamma:g}",
                f"{body.painleve:.4f}",
                f"{lower:.4f}",
                f"{widest:.4f}",
                f"{math.acos(gamma) / DEGREE:.2f}",
                f"{math.acos(c) / DEGREE:.2f}",
                f"{(widest - lower) / (widest - body.painleve):.3f}",
            ]
        )
    heads = [
        "γ",
        "P = 0 from μ",
        "jams from μ",
        "to μ = 1/γ",
        "θ_P first, °",
        "θ_P at λ = 1, °",
        "fraction",
    ]
    return table(heads, rows)


def one_slide(body: Body, mu: float, theta: float) -> Slides:
    """Return the slides of one body."""
    return Slides(*(np.array([value]) for value in (body.h, body.k2, mu, theta)))


@dataclass(frozen=True)
class Trial:
    """A start of a random hoop with what it should come to, and what it comes to."""

    hoop: lw.Hoop
    theta: float
    rate: float
    slip: float
    expected: str
    exponent: float

    @property
    def found(self) -> str:
        """Return what ends the slide in the simulation."""
        motion = self.hoop.simulate(
            theta=self.theta, theta_rate=self.rate, slip=self.slip, max_transitions=1
        )
        cause = motion.transitions[0].cause if motion.transitions else motion.outcome.kind
        if motion.outcome.kind == "singular" and len(motion.phases) == 1:
            return "jam"
        return {"lift_off": "lift-off", "stick": "end of slip", "reversal": "end of slip"}.get(
            cause, cause
        )


def trials(seed: int, count: int) -> list[Trial]:
    """Return slides of random hoops towards their P = 0, with what the theory expects of them."""
    drawn: list[tuple[lw.Hoop, Body, float]] = []
    random = np.random.default_rng(seed)
    for base, _ in random_hoops(seed, count):
        body = Body.of(base)
        low = body.painleve
        mu = low + (body.upper - low) * random.uniform(0.02, 0.98)
        if body.k2 < 1e-4 or mu > 100.0:
            continue
        hoop = replace(base, mu_s=mu, mu_k=mu, restitution=0.0)
        drawn.append((hoop, body, body.angle(mu)))
    slides = Slides(
        np.array([body.h for _, body, _ in drawn]),
        np.array([body.k2 for _, body, _ in drawn]),
        np.array([hoop.mu_k for hoop, _, _ in drawn]),
        np.array([theta for _, _, theta in drawn]),
    )
    exponent, n = slides.exponent, len(drawn)
    # The boundary falls to zero within about (1 − λ) cot θ.
    reach = np.where(
        exponent < 1.0, np.minimum(0.5, np.abs(1.0 - exponent) / np.tan(slides.theta)), 0.5
    )
    start = reach * 10.0 ** random.uniform(-3.0, 0.0, n)
    _, levels = slides.boundary(start)
    limit = np.where(exponent < 1.0, levels[-1], 0.0)
    c0 = np.cos(slides.theta + start)
    free = np.where(c0 > 0.0, 1.0 / (slides.h * np.maximum(c0, 1e-300)), np.inf)
    u0 = np.where(
        limit > 0.0, limit * random.uniform(0.2, 1.3, n), random.uniform(0.0, 1.0, n) / slides.h
    )
    near = start * 1e-9
    xi, u = slides.path(start, near, u0)
    loss, first = spent(slides, xi, u)
    positive = np.all(slides.solvability(xi) > 0.0, axis=0)
    result = []
    for i, (hoop, _, theta) in enumerate(drawn):
        # Only slides that run to P = 0 or to a lift-off without a turn, and no starts next to a
        # boundary.
        holds = u0[i] < 0.98 * free[i] and positive[i]
        runs = np.all(u[: first[i] + 1, i] > 0.0)
        clear = limit[i] <= 0.0 or abs(u0[i] / limit[i] - 1.0) > 0.01
        if not (holds and runs and clear and 1e-6 < loss[i] < 1e3 and exponent[i] > SHALLOW):
            continue
        factor = random.choice([0.7, 1.4])
        if factor < 1.0:
            expected = "end of slip"
        else:
            expected = "jam" if u0[i] < limit[i] else "lift-off"
        rate = -math.sqrt(u0[i])
        result.append(
            Trial(
                hoop,
                theta + float(start[i]),
                rate,
                factor * float(loss[i]),
                expected,
                float(exponent[i]),
            )
        )
    return result


def spent(slides: Slides, xi: Array, u: Array) -> tuple[Array, npt.NDArray[np.int64]]:
    """Return the slip that a slide needs on its way to P = 0 or to its lift-off.

    And the step at which it is there.
    """
    s, c = np.sin(slides.theta + xi), np.cos(slides.theta + xi)
    w = 1.0 - slides.h * c * u
    first = np.where((w <= 0.0).any(axis=0), (w <= 0.0).argmax(axis=0), len(xi) - 1)
    # Until the end of the path, and from there to P = 0 with the rate of P = 0, if w has not
    # vanished before.
    speed = np.sqrt(np.maximum(u, 1e-300))
    pieces = 0.5 * (1.0 / speed[1:] + 1.0 / speed[:-1]) * -np.diff(xi, axis=0)
    time = np.vstack([np.zeros(xi.shape[1]), np.cumsum(pieces, axis=0)])
    arm = 1.0 + slides.h * c + slides.mu * slides.h * s
    # η′ − θ′ (1 + h c + μ h s) + μ τ is constant, with θ′ < 0.
    lost = speed * arm - (speed * arm)[0] + slides.mu * time
    rows = np.arange(len(xi))[:, None]
    lost = np.where(rows <= first, lost, -np.inf)
    jams = first == len(xi) - 1
    s1, c1 = np.sin(slides.theta), np.cos(slides.theta)
    last = np.sqrt(1.0 / (slides.h * c1)) * (1.0 + slides.h * c1 + slides.mu * slides.h * s1)
    total = last - (speed * arm)[0] + slides.mu * time[-1]
    return np.where(jams, np.maximum(lost.max(axis=0), total), lost.max(axis=0)), first


@cache
def sample() -> list[tuple[Trial, str]]:
    """Return the trials of the page, and what they come to."""
    return [(trial, trial.found) for trial in trials(2026, 2000)]


def fates() -> list[str]:
    """What is expected of random slides against what becomes of them."""
    kinds = ("jam", "lift-off", "end of slip")
    count = Counter((trial.exponent < 1.0, trial.expected, found) for trial, found in sample())
    rows = []
    for below, words in ((True, "λ < 1"), (False, "λ > 1")):
        for expected in kinds:
            numbers = [count[below, expected, found] for found in kinds]
            if sum(numbers):
                rows.append([words, expected, *map(str, numbers)])
    return table(["", "expected", *kinds], rows)


def after_jam(body: Body, cosine: float, rate: float, slip: float) -> tuple[float, float]:
    """Return θ′ after a jam at P = 0 without a rebound, and the energy over m that it takes."""
    d = body.k2 + 1.0 + body.h**2 + 2.0 * body.h * cosine
    lost = 0.5 * slip**2 * (body.k2 + body.h**2 * (1.0 - cosine**2)) / d
    return rate - slip * (1.0 + body.h * cosine) / d, lost


def thrown() -> str:
    """How many of the jams of the sample throw the hoop off the plane.

    And how far θ′ is from the closed form.
    """
    worst, flights, jams = 0.0, 0, 0
    for trial, found in sample():
        if found != "jam":
            continue
        body = Body.of(trial.hoop)
        motion = trial.hoop.simulate(
            theta=trial.theta, theta_rate=trial.rate, slip=trial.slip, max_transitions=3
        )
        jam = motion.transitions[0]
        rate, _ = after_jam(
            body, math.cos(body.angle(trial.hoop.mu_k)), jam.state.theta_rate, jam.state.slip
        )
        jams += 1
        flights += jam.to_mode == "flight"
        worst = max(worst, abs(jam.after.theta_rate / rate - 1.0))
    return (
        f"{flights} of {jams} jams of the sample are followed by a flight, and θ′ differs by "
        f"{worst:.0e} at most"
    )


SPENT = (
    lw.Hoop(mass_ratio=0.0, offset=1.0, inertia=1e-3, mu_s=0.5, mu_k=0.5, restitution=0.0),
    (1.2, -0.9, 0.5),
)
"""A slide, θ, θ′ and η′, that still slips where doubles do not resolve its distance from P = 0, and
does not jam."""


def slip_left(hoop: lw.Hoop, start: tuple[float, float, float], time: float) -> float:
    """Return η′ that the first integral leaves at P = 0 and θ′ = −1/√(h cos θ).

    From θ, θ′ and η′ before that time.
    """
    body, mu = Body.of(hoop), hoop.mu_k
    theta, rate, slip = start
    cosine = math.cos(body.angle(mu))

    def lever(cosine: float) -> float:
        return 1.0 + body.h * (cosine + mu * math.sqrt((1.0 - cosine) * (1.0 + cosine)))

    return (
        slip
        - rate * lever(math.cos(theta))
        - lever(cosine) / math.sqrt(body.h * cosine)
        - mu * time
    )


def seeming() -> str:
    """What is left of the slip of that slide, and how it ends."""
    hoop, (theta, rate, slip) = SPENT
    body = Body.of(hoop)
    end = hoop.simulate(theta=theta, theta_rate=rate, slip=slip, max_transitions=1).transitions[0]
    left = slip_left(hoop, (theta, rate, slip), end.state.time)
    exponent = body.exponent(math.cos(body.angle(hoop.mu_k)))
    return f"λ = {exponent:.3f} and η′_P = {left:.3f}: a {end.cause}, and no jam"


def zone(body: Body, mu: float) -> float:
    """Return the distance from P = 0 at which the boundary turns.

    Infinite if beyond the bottom.
    """
    theta = body.angle(mu)
    xi, level = one_slide(body, mu, theta).boundary(np.array([math.pi - theta]))
    below = np.flatnonzero(level[:, 0] <= 0.0)
    if not len(below):
        return math.inf
    i = int(below[0])
    x, y = xi[i - 1 : i + 1, 0], level[i - 1 : i + 1, 0]
    return float(x[0] + (x[1] - x[0]) * y[0] / (y[0] - y[1]))


def comsol() -> str:
    """Angles of the published example."""
    body = Body.rim(COMSOL)
    theta = body.angle(1.0)
    first, last = lower_angle(body, 1.0) / DEGREE, theta / DEGREE
    return (
        f"P < 0 between {first:.4f}° and {last:.4f}°, λ is "
        f"{body.exponent(math.cos(theta)):.5f} at the latter, and "
        f"slides that jam begin between {last:.3f}° and "
        f"{(theta + zone(body, 1.0)) / DEGREE:.3f}°"
    )


def comsol_zone() -> str:
    """Width of the zone in which slides of the published example jam."""
    return f"{zone(Body.rim(COMSOL), 1.0) / DEGREE:.1f}°"


def comsol_margin() -> str:
    """How far the friction of the published example is above the lower bound."""
    return f"{100.0 * (1.0 / Body.rim(COMSOL).lower - 1.0):.1f} %"


def lower_angle(body: Body, mu: float) -> float:
    """Return the angle at which P vanishes and falls."""
    return math.acos(zero(lambda cosine: body.friction_at(cosine) - mu, body.least, 1.0 - 1e-15))


def comsol_motions() -> str:
    """How often the published example jams when it begins at the top."""
    rates = np.linspace(0.002, 1.15, 600)
    slides = impacts = landings = 0
    for restitution in (0.0, 0.5):
        hoop = thin_hoop(COMSOL, mu_k=1.0, restitution=restitution)
        for rate in rates:
            motion = hoop.simulate(
                theta=0.0, theta_rate=-float(rate), until=60.0, max_transitions=200
            )
            slides += sum(one.cause == "jam" for one in motion.transitions)
            hits = [one.impact.case for one in motion.transitions if one.impact is not None]
            landings += len(hits)
            impacts += hits.count("jams")
    return (
        f"{2 * len(rates)} motions, half of them with e = 0 and half with e = 0.5, jam {slides} "
        "times out of a slide; "
        f"of their {landings} impacts {impacts} are at an angle with P ≤ 0 and a slip towards it"
    )


@cache
def rolling(seed: int, count: int) -> tuple[int, int, int, int]:
    """Return how many of random starts without slip jam.

    Of general hoops and of rim hoops, each with its number.
    """
    random = np.random.default_rng(seed)
    numbers = []
    for rim in (False, True):
        ratio = 10.0 ** random.uniform(-2.0, 1.0, count)
        offset = np.ones(count) if rim else random.uniform(0.05, 1.0, count)
        inertia = ratio * (1.0 if rim else random.uniform(0.02, 1.0, count))
        h = offset / (1.0 + ratio)
        k2 = (inertia + ratio * offset**2 / (1.0 + ratio)) / (1.0 + ratio)
        angles = np.linspace(0.01, 0.5 * math.pi, 300)[:, None]
        over = (k2 + (h * np.sin(angles)) ** 2) / (h * np.sin(angles) * (1.0 + h * np.cos(angles)))
        low, high = over.min(axis=0), h + k2 / h
        mu = low + (high - low) * random.uniform(0.0, 1.0, count)
        found = lw.simulate_many(
            mass_ratio=ratio,
            offset=offset,
            inertia=inertia,
            mu_s=mu * random.choice([1.0, 1.5], count),
            mu_k=mu,
            theta=random.uniform(-math.pi, math.pi, count),
            theta_rate=random.normal(size=count) / np.sqrt(h),
            max_transitions=50,
            threads=1,
        )
        names = np.array([lw.tables.OUTCOMES[int(code)] for code in found.outcome.values])
        numbers += [int((names == "singular").sum()), count]
    return numbers[0], numbers[1], numbers[2], numbers[3]


def rolling_starts() -> str:
    """How many of random starts without slip jam."""
    general, of_general, rim, of_rim = rolling(3, 12_000)
    return (
        f"{general} of {of_general} such starts of hoops of all kinds jam, and {rim} of {of_rim} "
        "of thin hoops with "
        "the particle on the rim"
    )


@cache
def shares(seed: int, count: int) -> tuple[tuple[float, float], ...]:
    """Return, for rim hoops that can jam, the largest part of the needed rate, and its bound.

    Starts are at s < 0.

    The slide that is smooth at P = 0 is above all that jam; hoops are left out in which it does not
    come past the bottom.
    """
    random = np.random.default_rng(seed)
    drawn = []
    for _ in range(count):
        body = Body.rim(1.0 - 10.0 ** random.uniform(-5.0, 0.0))
        low, high = 1.01 * body.lower, 0.99 * body.upper
        if low < high:
            mu = low * (high / low) ** random.uniform()
            drawn.append((body.h, body.k2, mu, body.angle(mu)))
    slides = Slides(*np.array(drawn).T)
    xi, u = slides.beyond(2.0 * math.pi - slides.theta)
    angles = slides.theta + xi
    arm = 1.0 + slides.h * (np.cos(angles) + slides.mu * np.sin(angles))
    # Until the slide has turned back or left the plane, backwards in time.
    held = np.cumsum((u < 0.0) | (1.0 - slides.h * np.cos(angles) * u < 0.0), axis=0) == 0
    g = slides.h * np.cos(slides.theta)
    part = 0.5 * np.sqrt(g * np.maximum(u, 0.0)) * arm
    most = np.where(held & (angles > math.pi), part, -1.0).max(axis=0)
    return tuple(
        (float(a), float(b)) for a, b in zip(most, 0.5 * (1.0 + g), strict=True) if a > -1.0
    )


def near() -> str:
    """How much of the rate needed for a jam the slides of a sample have."""
    found = shares(7, 400)
    most, bound = max(found)
    return (
        f"{len(found)} random rim hoops whose slides come from beyond the bottom, the largest part "
        f"is {most:.3f}, "
        f"where the bound is {bound:.4f}"
    )


def turned(body: Body, mu: float, theta: float, xi: Array) -> Array:
    """Return the level below which slides turn back before P = 0.

    There u has a minimum where q = 0.
    """
    ratio = mu / (body.h * math.hypot(1.0, mu))
    result = np.zeros_like(xi)
    if ratio < 1.0:
        least = math.atan(mu) + math.asin(ratio) - theta
        if least < xi[-1]:
            ends = (np.array([least]), np.array([xi[-1]]))
            path, level = one_slide(body, mu, theta).path(*ends, np.array([0.0]))
            result = np.where(xi > least, np.interp(xi, path[:, 0], level[:, 0]), 0.0)
    return np.maximum(result, 0.0)


def phase_picture() -> Figure:
    """Slides next to P = 0 in the phase plane, one that jams and one that does not."""
    figure, axes = panels(2, height=400.0)
    for axis, (gamma, mu) in zip(axes, ((0.9, 0.75), (COMSOL, 1.0)), strict=True):
        body = Body.rim(gamma)
        theta, h = body.angle(mu), gamma
        span = math.radians(100.0) if math.isinf(zone(body, mu)) else min(2.2 * zone(body, mu), 1.0)
        slides = one_slide(body, mu, theta)
        xi, level = slides.boundary(np.array([span]))
        shown = level[:, 0] >= 0.0
        angles = (theta + xi[:, 0]) / DEGREE
        axis.fill_between(
            angles[shown],
            -np.sqrt(level[shown, 0]),
            -np.sqrt(turned(body, mu, theta, xi[shown, 0])),
            color=(ACCENTS["violet"], 0.2),
            linewidth=0,
            label="jams",
        )
        turning = np.linspace(theta - 0.35 * span, min(theta + span, 0.499 * math.pi), 300)
        off = -1.0 / np.sqrt(h * np.cos(turning))
        axis.plot(turning / DEGREE, off, **of_curve("lift_off"), label="*w* = 0: lift-off")
        axis.plot(
            angles[shown],
            -np.sqrt(level[shown, 0]),
            color=ACCENTS["violet"],
            linewidth=BOLD,
            label="*u*∗",
        )
        thin: dict[str, Any] = {"color": FAINT, "linewidth": FINE, "zorder": 1, "label": "slides"}
        for rate in np.linspace(0.1, 2.9, 15) / math.sqrt(h):
            ends = (np.array([span]), np.array([span * 1e-6]))
            paths, values = slides.path(*ends, np.array([rate**2]), 1000)
            w = 1.0 - h * np.cos(theta + paths[:, 0]) * values[:, 0]
            # Until the slide turns or lifts off.
            good = np.cumsum((values[:, 0] < 0.0) | (w < 0.0)) == 0
            axis.plot((theta + paths[good, 0]) / DEGREE, -np.sqrt(values[good, 0]), **thin)
        for part in np.linspace(0.1, 0.9, 5):
            ends = (np.array([min(zone(body, mu), span) * part]), np.array([span * 1e-6]))
            paths, values = slides.path(*ends, np.array([1e-6]), 1000)
            good = values[:, 0] >= 0.0
            axis.plot((theta + paths[good, 0]) / DEGREE, -np.sqrt(values[good, 0]), **thin)
        axis.axvline(theta / DEGREE, color=INK)
        left = (theta - 0.35 * span) / DEGREE
        axis.axvspan(
            left,
            theta / DEGREE,
            facecolor=PAPER,
            edgecolor=HATCH,
            hatch="////",
            linewidth=0,
            label="*P* < 0",
        )
        axis.plot(
            [theta / DEGREE],
            [-1.0 / math.sqrt(h * math.cos(theta))],
            "o",
            color=INK,
            label="*P* = *w* = 0",
        )
        axis.set(
            xlim=((theta - 0.35 * span) / DEGREE, (theta + span) / DEGREE),
            ylim=(-1.6 / math.sqrt(h * math.cos(theta)), 0.0),
            xlabel="angle *θ*, degrees",
            ylabel="rate *θ*′, √(*g*/*R*)",
        )
        heading = f"*γ* = {gamma:g}, *μ* = {mu:g}, *λ* = {body.exponent(math.cos(theta)):.3f}"
        key(axis, heading, columns=3)
    return figure


def hoops_picture() -> Figure:
    """Which rim hoops and which hoops of all kinds can jam."""
    figure, (left, right) = panels(2, height=400.0)
    gammas = np.linspace(0.15, 0.999, 300)
    painleve = np.sqrt(1.0 - gammas**2) / gammas
    cosines = np.array([rim_one(float(gamma)) for gamma in gammas])
    lower = (1.0 - gammas * cosines) / (gammas * np.sqrt(1.0 - cosines**2))
    left.fill_between(
        gammas, lower, 1.0 / gammas, color=(ACCENTS["violet"], 0.2), linewidth=0, label="jam"
    )
    left.fill_between(
        gammas,
        painleve,
        lower,
        facecolor="none",
        edgecolor=HATCH,
        hatch="////",
        linewidth=0,
        label="lift off",
    )
    left.plot(gammas, 1.0 / gammas, color=INK, label="1/*γ*: *λ* = 0")
    left.plot(gammas, lower, color=INK, linestyle=LIST_DASHES[1], label="*λ* = 1")
    left.plot(
        gammas,
        painleve,
        color=INK,
        linestyle=LIST_DASHES[2],
        label="√(1 − *γ*²)/*γ*: first *P* = 0",
    )
    left.plot([COMSOL], [1.0], "o", color=INK, label="COMSOL")
    g, mu = np.meshgrid(np.linspace(0.01, 0.999, 400), np.linspace(0.01, 2.4, 300))
    # γ (c + μ s) = 1 with c = g/γ: the larger root of (1 − g)² = μ² (γ² − g²).
    gamma = np.hypot(g, (1.0 - g) / mu)
    cosine = g / gamma
    jam = cosine < 2.0 * gamma / (
        3.0 * (1.0 - gamma**2) + np.sqrt(9.0 * (1.0 - gamma**2) ** 2 + 4.0 * gamma**2)
    )
    part = np.where(jam & (gamma < 1.0), 0.5 * (1.0 + g), np.nan)
    parts = (0.6, 0.7, 0.8, 0.9)
    left.contour(gamma, mu, part, levels=parts, colors=[INK], linewidths=FINE)
    for level in parts:
        at = 2.0 * level - 1.0
        height = (1.0 - at) / math.sqrt(0.96**2 - at**2)
        left.text(0.96, height, f"{level:g}", size="small", ha="center", va="bottom")
    left.set(
        xlim=(0.3, 1.0),
        ylim=(0.0, 2.4),
        xlabel="part of the mass in the particle *γ*",
        ylabel="friction *μ*ₖ",
    )
    key(left)
    hs = np.linspace(0.01, 1.0, 80)
    k2s = np.linspace(0.0, 1.0, 80)[1:]
    grid = np.array(
        [
            [Body(float(h), float(k2)).lower if k2 < 1.0 - h * h else math.nan for h in hs]
            for k2 in k2s
        ]
    )
    levels = [0.1, 0.2, 0.3, 0.5, 0.7, 1.0, 1.5, 2.0, 4.0]
    lines = right.contour(hs, k2s, grid, levels=levels, colors=[INK])
    right.clabel(lines)
    right.plot(hs, 1.0 - hs**2, color=INK, linewidth=BOLD, label="thin hoop, particle on its rim")
    right.set(xlim=(0, 1), ylim=(0, 1), xlabel="*h*", ylabel="*ϱ* = *Î*/*m*")
    key(right, "least *μ*ₖ that can jam")
    return figure


STUDY = Study(
    name="jam",
    texts={
        "rim bounds": rim_bounds,
        "fates": fates,
        "spent": seeming,
        "thrown": thrown,
        "comsol": comsol,
        "comsol zone": comsol_zone,
        "comsol margin": comsol_margin,
        "comsol motions": comsol_motions,
        "near": near,
        "rolling": rolling_starts,
        "attack bounds": lambda: said("jam", "bounds"),
        "attack slip": lambda: said("jam", "without slip"),
    },
    pictures={"phase": phase_picture, "hoops": hoops_picture},
)
