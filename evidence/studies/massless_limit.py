"""Where the massless hoop comes from.

Motions of light hoops against the rolling and gliding of the paper.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache
from typing import Any

import littlewood as lw
import numpy as np
from littlewood.plot.canvas import START, key
from littlewood.plot.sheet import panels
from littlewood.style import (
    ARROW_COLOURS,
    BOLD,
    FINE,
    INK,
    LINE,
    MODE_COLOURS,
    MODE_DASHES,
)
from matplotlib.figure import Figure

from .attacks import said
from .hoops import DEGREE
from .limit_system import LimitSystem, Piece, State
from .study import Study

FAMILIES = {"thin hoop": 1.0, "no mass, only inertia": 0.0}
"""Light hoops by their m1/m2 over I_zz."""

SPEED = math.sqrt(89.0) / 5.0
"""Speed at which the particle of Figure 7 reaches the plane."""

ARRIVAL = math.log(5.0) + (math.sqrt(89.0) - 3.0) / 5.0
"""Time at which it does."""

SIZES = tuple(10.0**-k for k in range(2, 8))


def light(
    size: float, family: str, mu_k: float = 0.4, mu_s: float = 0.5, restitution: float | None = None
) -> lw.Hoop:
    """Return a hoop with the particle on its rim, and I_zz = `size`."""
    return lw.Hoop(
        mass_ratio=FAMILIES[family] * size,
        offset=1.0,
        inertia=size,
        mu_s=mu_s,
        mu_k=mu_k,
        restitution=restitution,
    )


@cache
def figure_7(hoop: lw.Hoop) -> lw.Trajectory:
    """Return the motion of Figure 7, from the top with θ′ = 1/2."""
    return hoop.simulate(theta=0.0, theta_rate=0.5, until=3.2, max_transitions=40)


def massless(mu_k: float = 0.4) -> lw.Trajectory:
    """Return that of the massless hoop."""
    return figure_7(lw.Hoop(mass_ratio=0.0, offset=1.0, inertia=0.0, mu_s=0.5, mu_k=mu_k))


def log_factor(mu: float, rate: float, time: float) -> float:
    """Return Δθ over Î ln(1/Î) at a time, for μs = μk and a start at the top."""
    motion = lw.Hoop(mass_ratio=0.0, offset=1.0, inertia=0.0, mu_s=mu, mu_k=mu).simulate(
        theta=0.0, theta_rate=rate, until=time, max_transitions=40
    )
    slip, now = motion.transitions[0], motion(time)
    angle, pace = slip.state.theta, slip.state.theta_rate
    pressure = 1.0 - math.cos(angle) * pace**2
    return -pressure * (time - slip.time) / (math.sin(angle) * pace * math.sin(float(now.theta)))


def friction_at_bottom(family: str, mu: float) -> float:
    """Return (θ′ √Î − v)/√Î at the bottom of Figure 7, as Î → 0.

    There the slip is to the left and θ′ > 0.
    """
    return (2.0 if FAMILIES[family] else 1.0) * mu * math.pi * SPEED / 8.0


def bottom(hoop: lw.Hoop) -> tuple[float, float]:
    """Return time and rate at which the particle of a light hoop passes its lowest place."""
    motion = figure_7(hoop)
    low, high = 2.4, 3.15
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if motion(middle).theta < math.pi else (low, middle)
    return low, float(motion(low).theta_rate)


def starts(seed: int, count: int) -> list[tuple[float, float, float, float]]:
    """Return starts μ, θ, θ′, η′ at which gliding is no limit and the plane presses.

    σ s > 0, tan|θ/2| < μk.
    """
    random = np.random.default_rng(seed)
    found: list[tuple[float, float, float, float]] = []
    while len(found) < count:
        mu = random.uniform(0.1, 2.0)
        theta = 2.0 * math.atan(mu) * random.uniform(0.02, 0.95) * random.choice([-1.0, 1.0])
        rate, slip = random.normal(), math.copysign(random.uniform(0.05, 3.0), theta)
        if math.cos(theta) * rate**2 < 1.0:
            found.append((mu, theta, rate, slip))
    return found


def after(theta: float, rate: float, slip: float) -> str:
    """Return what follows the jam of a hoop without mass, by its rate then."""
    turned = rate - 0.5 * slip
    if math.cos(theta) * turned**2 > 1.0:
        return "flight"
    return "sliding" if abs(turned) > 1.0 else "rolling"


@cache
def jams(
    seed: int = 4, count: int = 2000, size: float = 1e-6
) -> list[tuple[str, str, float, float]]:
    """Return what is expected to follow and what does, and errors over Î.

    They are those of θ′ and of the energy lost.
    """
    result = []
    for mu, theta, rate, slip in starts(seed, count):
        hoop = light(size, "no mass, only inertia", mu, mu, 0.0)
        jam = hoop.simulate(theta=theta, theta_rate=rate, slip=slip, max_transitions=1).transitions[
            0
        ]
        lost = 0.5 * slip**2 * math.sin(0.5 * theta) ** 2
        if jam.impact is None or jam.cause != "jam":
            continue
        result.append(
            (
                after(theta, rate, slip),
                jam.to_mode or "",
                abs(jam.after.theta_rate - (rate - 0.5 * slip)) / size,
                abs(jam.impact.energy_lost - lost) / size,
            )
        )
    return result


def jam_errors() -> str:
    """How close a light hoop is to the limit of the jam."""
    middle = [float(np.median([one[place] for one in jams()])) for place in (2, 3)]
    return (
        f"{len(jams())} of 2000 starts jam; the median differences are {middle[0]:.2f} Î in θ′ "
        f"and {middle[1]:.2f} Î in the energy"
    )


@dataclass(frozen=True)
class Comparison:
    """A start of the limit system, the theorem's order of the difference, and the measured one."""

    power: float
    measured: float


def order_of(pieces: list[Piece], system: LimitSystem) -> float:
    """Return the power of Î of the theorem at the end of a motion; logarithms count as nothing."""
    power = 1.0
    for piece in pieces[:-1]:
        if piece.ended_by == "bounce":
            last = piece.at(0.999999 * (piece.end - piece.begin))
            drift = abs(last.slip - (1.0 + math.cos(last.theta)) * last.rate)
            speed = abs(math.sin(last.theta) * last.rate)
            power = min(power, 0.5 if drift > 2.0 * system.mu_k * speed else 1.0 / 3.0)
    return power


def difference(hoop: lw.Hoop, start: State, time: float, limit: State) -> float:
    """Return the largest difference of a light hoop from the limit at a time, in θ, θ′ and η′."""
    found = hoop.simulate(
        theta=start.theta,
        theta_rate=start.rate,
        slip=start.slip,
        until=time,
        max_transitions=500,
        proof="none",
    )(time)
    turned = math.remainder(float(found.theta) - limit.theta, 2.0 * math.pi)
    return max(
        abs(turned), abs(float(found.theta_rate) - limit.rate), abs(float(found.slip) - limit.slip)
    )


@cache
def comparisons(seed: int, count: int) -> tuple[Comparison, ...]:
    """Return random motions of the limit system against light hoops of 1e-5 and 1e-7.

    They have up to six events.
    """
    random = np.random.default_rng(seed)
    result: list[Comparison] = []
    while len(result) < count:
        mu_k = random.uniform(0.1, 1.2)
        system = LimitSystem(mu_k * random.choice([1.0, 1.3]), mu_k)
        start = State(
            random.uniform(-3.0, 3.0), random.normal(), random.choice([0.0, 1.5]) * random.normal()
        )
        if math.cos(start.theta) * start.rate**2 > 0.95:
            continue
        pieces = system.follow(start, 5.0)[: int(random.integers(1, 7))]
        if not pieces or pieces[-1].end - pieces[-1].begin < 0.3:
            continue
        time = pieces[-1].begin + 0.6 * (pieces[-1].end - pieces[-1].begin)
        limit = pieces[-1].at(time - pieces[-1].begin)
        if abs(math.sin(limit.theta)) < 0.2:
            continue
        family = random.choice(list(FAMILIES))
        off = [
            difference(light(size, family, system.mu_k, system.mu_s, 0.0), start, time, limit)
            for size in (1e-5, 1e-7)
        ]
        result.append(Comparison(order_of(pieces, system), math.log10(off[0] / off[1]) / 2.0))
    return tuple(result)


def orders() -> str:
    """How the differences of random motions fall with the inertia."""
    found = comparisons(8, 200)
    words = []
    for exponent, name in ((1.0, "1"), (0.5, "1/2"), (1.0 / 3.0, "1/3")):
        measured = np.array([one.measured for one in found if one.power == exponent])
        low, middle, high = np.quantile(measured, (0.1, 0.5, 0.9))
        words.append(
            f"{len(measured)} of the order {name} have {middle:.2f} ({low:.2f} to {high:.2f})"
        )
    return (
        f"{len(found)} random motions with up to six events the power of Î with which the "
        "difference falls from "
        f"I_zz = 1e-5 to 1e-7 is the following, median and middle four fifths: {'; '.join(words)}"
    )


BOUNCE = State(math.pi - 1.0, 0.8, 0.4 + 0.8 * (1.0 + math.cos(math.pi - 1.0)))
"""A glide whose bounce is at the speed v of `bounce_speed`, with V = 0.4."""


def bounce_speed() -> tuple[float, float]:
    """Return v of that bounce and its time."""
    fall = math.sin(BOUNCE.theta) * BOUNCE.rate
    speed = math.sqrt(fall**2 + 2.0 * (1.0 + math.cos(BOUNCE.theta)))
    return speed, speed - fall


def drift_left(hoop: lw.Hoop) -> float:
    """Return V of a light hoop half a unit of time after that bounce, over Î^(1/3)."""
    _, time = bounce_speed()
    motion = hoop.simulate(
        theta=BOUNCE.theta,
        theta_rate=BOUNCE.rate,
        slip=BOUNCE.slip,
        until=time + 0.5,
        max_transitions=60,
    )
    seen = motion(time + 0.5)
    drift = float(seen.slip) - (1.0 + hoop.h * math.cos(float(seen.theta))) * float(seen.theta_rate)
    return drift / math.pow(hoop.inertia_about_mass_centre, 1.0 / 3.0)


def stopped_law(mu_s: float, mu_k: float) -> float:
    """Return its limit."""
    return -0.5 * bounce_speed()[0] * math.pow(2.0 * mu_s, 1.0 / 3.0) * (1.0 + 0.5 * mu_k / mu_s)


def stopped() -> str:
    """V after a bounce that stops the slip."""
    seen = [
        drift_left(light(size, "no mass, only inertia", 0.6, 0.72)) for size in (1e-4, 1e-6, 1e-8)
    ]
    numbers = ", ".join(f"{one:.4f}" for one in seen)
    return (
        f"for v = {bounce_speed()[0]:.4f}, μs = 0.72 and μk = 0.6 it is "
        f"{stopped_law(0.72, 0.6):.4f} Î^⅓, "
        f"and simulated {numbers} with Î = 1e-4, 1e-6, 1e-8"
    )


@cache
def bounces_in_turn(seed: int, count: int) -> tuple[int, int]:
    """Return bounces of the limit system that follow one which stops the slip, and with V = 0."""
    random = np.random.default_rng(seed)
    following = still = 0
    for _ in range(count):
        mu_k = random.uniform(0.1, 1.2)
        system = LimitSystem(mu_k * random.choice([1.0, 1.3]), mu_k)
        start = State(random.uniform(-3.0, 3.0), random.normal(), 1.5 * random.normal())
        if math.cos(start.theta) * start.rate**2 > 0.95:
            continue
        stopped = False
        for piece in system.follow(start, 6.0):
            if piece.ended_by == "bounce":
                last = piece.at(0.999999 * (piece.end - piece.begin))
                drift = abs(last.slip - (1.0 + math.cos(last.theta)) * last.rate)
                following += stopped
                still += stopped and drift < 1e-9
                speed = abs(math.sin(last.theta) * last.rate)
                stopped = drift < 2.0 * mu_k * speed
    return following, still


def share() -> str:
    """How many bounces after one that stops the slip have V = 0."""
    following, still = bounces_in_turn(10, 60)
    return f"{still} of {following}"


LOW = State(math.acos(-0.8), 0.0, 0.0)
"""A particle at rest at b = 0.2, which bounces with V = 0 and comes back."""


def drifts(hoop: lw.Hoop, bounces: int) -> list[float]:
    """Return V after each bounce of that particle, over the law of `stopped_law`."""
    speed = math.sqrt(0.4)
    law = math.pow(2.0 * hoop.mu_s * hoop.inertia_about_mass_centre, 1.0 / 3.0)
    law *= -0.5 * speed * (1.0 + 0.5 * hoop.mu_k / hoop.mu_s)
    motion = hoop.simulate(
        theta=LOW.theta,
        theta_rate=0.0,
        slip=0.0,
        until=2.0 * bounces * speed,
        max_transitions=400,
        proof="none",
    )
    found = []
    for k in range(bounces):
        seen = motion((2.0 * k + 1.5) * speed)
        level = 1.0 + hoop.h * math.cos(float(seen.theta))
        # θ′ has the sign of the side from which the particle has come.
        side = -math.copysign(1.0, math.sin(float(seen.theta)))
        found.append((float(seen.slip) - level * float(seen.theta_rate)) / (side * law))
    return found


def again() -> str:
    """V after bounces one after the other, over the law."""
    parts = []
    for size in (1e-4, 1e-6, 1e-8):
        hoop = light(size, "no mass, only inertia", 0.6, 0.72)
        parts.append(" and ".join(f"{one:.4f}" for one in drifts(hoop, 2)) + f" for Î = {size:.0e}")
    return ", ".join(parts)


def system_picture() -> Figure:
    """Two motions of the limit system, and a light hoop, over θ and θ′."""
    figure, axes = panels(2, height=400.0)
    examples = (
        (0.5, 0.4, State(0.0, 0.5, 0.0), 7.5),
        (0.8, 0.6, State(1.9, -1.5, 0.7), 5.5),
    )
    for axis, (mu_s, mu_k, start, until) in zip(axes, examples, strict=True):
        system = LimitSystem(mu_s, mu_k)
        hoop = light(1e-4, "no mass, only inertia", mu_k, mu_s, 0.0)
        times = np.linspace(0.0, until, 40_000)
        seen = hoop.simulate(
            theta=start.theta,
            theta_rate=start.rate,
            slip=start.slip,
            until=until,
            max_transitions=200,
        )(times)
        angles = np.remainder(np.asarray(seen.theta), 2.0 * math.pi) / DEGREE
        if start.rate < 0.0:
            angles = np.where(angles > 270.0, angles - 360.0, angles)
            angles = np.where(angles > 180.0, angles - 360.0, angles)
        rates = np.where(np.abs(np.diff(angles, append=angles[-1])) > 90.0, np.nan, seen.theta_rate)
        axis.plot(
            angles,
            rates,
            color=LINE,
            linewidth=3.0 * BOLD,
            zorder=1,
            label="light hoop, *Î* = 10^{−4}",
        )
        for piece in system.follow(start, until):
            states = [
                piece.at(float(t))
                for t in np.linspace(0.0, 0.99999, 600) * (piece.end - piece.begin)
            ]
            x = np.array([one.theta for one in states]) / DEGREE
            x = x if start.rate < 0.0 else np.remainder(x, 360.0)
            mode = "rolling" if piece.kind == "roll" else "gliding"
            look: dict[str, Any] = {"color": MODE_COLOURS[mode], "linestyle": MODE_DASHES[mode]}
            axis.plot(x, [one.rate for one in states], **look, label=mode)
            if piece.ended_by == "set":
                before = piece.at(piece.end - piece.begin)
                place = before.theta / DEGREE
                axis.annotate(
                    "",
                    (place, before.rate - 0.5 * before.slip),
                    (place, before.rate),
                    arrowprops={
                        "arrowstyle": "->",
                        "color": ARROW_COLOURS["impulse"],
                        "linewidth": BOLD,
                    },
                )
        edge, limit = 2.0 * math.atan(mu_k) / DEGREE, 2.0 * math.atan(mu_s) / DEGREE
        for shift in (0.0,) if start.rate < 0.0 else (0.0, 360.0):
            axis.plot(
                np.array([-1, 1, 1, -1, -1]) * limit + shift,
                [-1, -1, 1, 1, -1],
                color=INK,
                linewidth=FINE,
                zorder=0,
                label="can roll",
            )
        for angle in (0.0, edge):
            axis.plot(
                [angle] * 2, [-8.0, 8.0], color=INK, linestyle="dotted", zorder=0, label="edge of 𝓢"
            )
        axis.plot([start.theta / DEGREE], [start.rate], **START, label="start", clip_on=False)
        axis.plot([], [], color=ARROW_COLOURS["impulse"], linewidth=BOLD, label="loses its slip")
        axis.set_yscale("symlog", linthresh=1.0)
        axis.set(ylim=(-8.0, 8.0), xlabel="angle *θ*, degrees", ylabel="rate *θ*′, √(*g*/*R*)")
        axis.set(xlim=(-180.0, 180.0) if start.rate < 0.0 else (0.0, 360.0))
        axis.set_xticks(np.arange(-180, 181, 90) if start.rate < 0.0 else np.arange(0, 361, 90))
        axis.set_yticks([-5, -2, -1, 0, 1, 2, 5], ["−5", "−2", "−1", "0", "1", "2", "5"])
        key(axis, f"*μ*ₛ = {mu_s:g}, *μ*ₖ = {mu_k:g}", columns=3)
    return figure


STUDY = Study(
    name="massless-limit",
    texts={
        "orders": orders,
        "stopped": stopped,
        "share": share,
        "again": again,
        "jam errors": jam_errors,
        "attack": lambda: said("massless-limit", "bounce"),
    },
    pictures={"system": system_picture},
)
