"""Where the massless hoop comes from: motions of light hoops against the rolling and gliding of the paper."""

from __future__ import annotations

import math
from collections import Counter
from functools import cache

import littlewood as lw
import numpy as np
from littlewood.style import FAINT, INK
from matplotlib.figure import Figure

from .axes import COLOURS, DASHES, DEGREE, panels, styled
from .page import table
from .study import Study

FAMILIES = {"thin hoop": 1.0, "no mass, only inertia": 0.0}
"""Light hoops by their m1/m2 over I_zz."""

SPEED = math.sqrt(89.0) / 5.0
"""Speed at which the particle of Figure 7 reaches the plane."""

ARRIVAL = math.log(5.0) + (math.sqrt(89.0) - 3.0) / 5.0
"""Time at which it does."""

SIZES = tuple(10.0**-k for k in range(2, 8))


def light(size: float, family: str, mu_k: float = 0.4, mu_s: float = 0.5, restitution: float | None = None) -> lw.Hoop:
    """Return a hoop with the particle on its rim, and I_zz = `size`."""
    return lw.Hoop(
        mass_ratio=FAMILIES[family] * size, offset=1.0, inertia=size, mu_s=mu_s, mu_k=mu_k, restitution=restitution
    )


@cache
def figure_7(hoop: lw.Hoop) -> lw.Trajectory:
    """Return the motion of Figure 7, from the top with θ′ = 1/2."""
    return hoop.simulate(theta=0.0, theta_rate=0.5, until=3.2, max_transitions=40)


def massless(mu_k: float = 0.4) -> lw.Trajectory:
    """Return that of the massless hoop."""
    return figure_7(lw.Hoop(mass_ratio=0.0, offset=1.0, inertia=0.0, mu_s=0.5, mu_k=mu_k))


def slip_shift(mu: float, rate: float) -> float:
    """Return dθ_s/dÎ of hoops without mass that roll from the top, at Î = 0."""
    k = 4.0 * (1.0 + rate**2)
    b = 2.0 / (1.0 + mu**2)
    return mu * k / (b * (4.0 * b - k))


def regular() -> list[str]:
    """Differences from the massless hoop, over Î."""
    rows = []
    for family in FAMILIES:
        for size in SIZES[::2]:
            hoop = light(size, family)
            inertia = hoop.inertia_about_mass_centre
            motion, limit = figure_7(hoop), massless()
            angle = motion.transitions[0].state.theta - limit.transitions[0].state.theta
            times = [motion.transitions[i].time - limit.transitions[i].time for i in (0, 1)]
            here, there = motion(2.5), limit(2.5)
            pairs = ((here.theta, there.theta), (here.theta_rate, there.theta_rate), (here.slip, there.slip))
            numbers = [angle, *times, *(float(a - b) for a, b in pairs)]
            rows.append([family, f"{inertia:.3g}", *(f"{number / inertia:.4f}" for number in numbers)])
    heads = ["hoop", "Î", "θ of the slip", "τ of the slip", "τ of the reversal", "θ", "θ′", "η′ at τ = 2.5"]
    return table(heads, rows)


def slip_law() -> str:
    """The derived coefficient of the angle of slip."""
    return f"{slip_shift(0.5, 0.5):.4f}"


def thin_slip_law() -> str:
    """The same for thin hoops, whose mass centre moves off the rim."""
    return f"{slip_shift(0.5, 0.5) + 0.25:.4f}"


def log_factor(mu: float, rate: float, time: float) -> float:
    """Return Δθ over Î ln(1/Î) at a time, for μs = μk and a start at the top."""
    motion = lw.Hoop(mass_ratio=0.0, offset=1.0, inertia=0.0, mu_s=mu, mu_k=mu).simulate(
        theta=0.0, theta_rate=rate, until=time, max_transitions=40
    )
    slip, now = motion.transitions[0], motion(time)
    angle, pace = slip.state.theta, slip.state.theta_rate
    pressure = 1.0 - math.cos(angle) * pace**2
    return -pressure * (time - slip.time) / (math.sin(angle) * pace * math.sin(float(now.theta)))


def log_law() -> str:
    """The factor of the logarithm in the motion of Figure 7 with equal coefficients."""
    return f"{log_factor(0.5, 0.5, 2.2):.4f}"


def friction_at_bottom(family: str, mu: float) -> float:
    """Return (θ′ √Î − v)/√Î at the bottom of Figure 7, as Î → 0; there the slip is to the left and θ′ > 0."""
    return (2.0 if FAMILIES[family] else 1.0) * mu * math.pi * SPEED / 8.0


def passage_law() -> str:
    """The limit of the last column of the passages."""
    return " and ".join(f"{friction_at_bottom(family, 0.4):.4f} ({family})" for family in FAMILIES)


def bottom(hoop: lw.Hoop) -> tuple[float, float]:
    """Return time and rate at which the particle of a light hoop passes its lowest place."""
    motion = figure_7(hoop)
    low, high = 2.4, 3.15
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if motion(middle).theta < math.pi else (low, middle)
    return low, float(motion(low).theta_rate)


def passages() -> list[str]:
    """The passage of the bottom."""
    rows = []
    for family in FAMILIES:
        for size in SIZES[::2]:
            hoop = light(size, family)
            inertia = hoop.inertia_about_mass_centre
            time, rate = bottom(hoop)
            late, log = (time - ARRIVAL) / inertia, math.log(1.0 / inertia) / (4.0 * SPEED)
            rows.append(
                [
                    family,
                    f"{inertia:.3g}",
                    f"{late:.4f}",
                    f"{log:.4f}",
                    f"{late - log:.4f}",
                    f"{rate * math.sqrt(inertia):.5f}",
                    f"{(rate * math.sqrt(inertia) - SPEED) / math.sqrt(inertia):.3f}",
                ]
            )
    heads = ["hoop", "Î", "late, over Î", "ln(1/Î)/(4v)", "difference", "θ′ √Î", "(θ′ √Î − v)/√Î"]
    return table(heads, rows)


def speed() -> str:
    """Return the speed v of Figure 7."""
    return f"{SPEED:.5f}"


def equal() -> list[str]:
    """Equal coefficients: the distance at τ = 2.2 over Î, and its growth with the logarithm."""
    off = []
    for size in SIZES:
        motion, limit = figure_7(light(size, "no mass, only inertia", 0.5)), massless(0.5)
        off.append(float(motion(2.2).theta - limit(2.2).theta) / size)
    rows = [
        [f"{size:.0e}", f"{here:.4f}", f"{(here - before) / math.log(10.0):.4f}"]
        for size, before, here in zip(SIZES[1:], off, off[1:], strict=False)
    ]
    return table(["Î", "Δθ/Î", "its growth with ln(1/Î)"], rows)


def starts(seed: int, count: int) -> list[tuple[float, float, float, float]]:
    """Return starts μ, θ, θ′, η′ at which gliding is no limit and the plane presses: σ s > 0, tan|θ/2| < μk."""
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
def jams(seed: int = 4, count: int = 2000, size: float = 1e-6) -> list[tuple[str, str, float, float]]:
    """Return what is expected to follow and what does, and the errors of θ′ and of the energy lost, over Î."""
    result = []
    for mu, theta, rate, slip in starts(seed, count):
        hoop = light(size, "no mass, only inertia", mu, mu, 0.0)
        jam = hoop.simulate(theta=theta, theta_rate=rate, slip=slip, max_transitions=1).transitions[0]
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


def jam_table() -> list[str]:
    """What follows the jams."""
    count = Counter((expected, found) for expected, found, _, _ in jams())
    kinds = ("rolling", "sliding", "flight")
    return table(
        ["expected", *kinds], [[expected, *(str(count[expected, found]) for found in kinds)] for expected in kinds]
    )


def jam_errors() -> str:
    """How close a light hoop is to the limit of the jam."""
    middle = [float(np.median([one[place] for one in jams()])) for place in (2, 3)]
    return (
        f"{len(jams())} of 2000 starts jam; the median differences are {middle[0]:.2f} Î in θ′ "
        f"and {middle[1]:.2f} Î in the energy"
    )


def orders_picture() -> Figure:
    """Differences against Î; where gliding is no limit; the passage of the bottom."""
    figure, (left, middle, right) = panels(3, width=3.9, height=3.5)
    sizes = np.logspace(-7.0, -1.5, 23)
    rows = []
    for size in sizes:
        motion, limit = figure_7(light(float(size), "thin hoop")), massless()
        equal_motion = figure_7(light(float(size), "no mass, only inertia", 0.5))
        passing = light(float(size), "no mass, only inertia")
        time, rate = bottom(passing)
        rows.append(
            (
                abs(motion(2.5).theta - limit(2.5).theta),
                abs(equal_motion(2.2).theta - massless(0.5)(2.2).theta),
                time - ARRIVAL,
                abs(rate * math.sqrt(size) - SPEED),
            )
        )
    labels = ("θ in the glide", "θ, μs = μk", "time of the bottom", "θ′ √Î at the bottom")
    for (values, label), colour, dash in styled(list(zip(zip(*rows, strict=True), labels, strict=True))):
        left.loglog(sizes, values, color=colour, dashes=dash, label=label)
    left.set(xlabel="I_zz of the hoop, m2 R²", ylabel="distance from the massless hoop")
    left.legend(frameon=False, fontsize=8)
    angles = np.linspace(0.5, 150.0, 400) * DEGREE
    middle.fill_between(angles / DEGREE, np.tan(0.5 * angles), 3.0, color=COLOURS[0], alpha=0.15, linewidth=0)
    middle.plot(angles / DEGREE, np.tan(0.5 * angles), color=INK, label="massless: tan(θ/2)")
    for gamma, colour, dash in zip((0.99, 0.9, 0.75), COLOURS, DASHES[1:], strict=False):
        edge = (1.0 - gamma * np.cos(angles)) / (gamma * np.sin(angles))
        middle.plot(angles / DEGREE, edge, color=colour, dashes=dash, label=f"thin hoop, γ = {gamma:g}")
    middle.set(xlim=(0, 150), ylim=(0, 2.5), xlabel="angle θ, degrees (slip to the right)", ylabel="friction μk")
    middle.text(30, 2.2, "no slide", fontsize=9, color=INK)
    middle.legend(frameon=True, framealpha=0.9, edgecolor="none", fontsize=8, loc="lower right")
    for size, colour, dash in styled((1e-2, 1e-3, 1e-4)):
        times = np.linspace(2.75, 3.05, 1500)
        seen = figure_7(light(size, "no mass, only inertia"))(times)
        right.plot(
            times,
            1.0 + np.cos(seen.theta),
            color=colour,
            dashes=dash,
            label=f"Î = {size:g}",
            linewidth=1.3,
        )
    times = np.linspace(2.75, ARRIVAL, 200)
    right.plot(times, 1.0 + np.cos(massless()(times).theta), color=FAINT, linewidth=2.5, zorder=1, label="massless")
    right.set(xlabel="time τ, √(R/g)", ylabel="height of the particle, R", ylim=(0, None))
    right.legend(frameon=False, fontsize=8)
    return figure


STUDY = Study(
    name="massless-limit",
    texts={
        "regular": regular,
        "slip law": slip_law,
        "thin slip law": thin_slip_law,
        "log law": log_law,
        "passage law": passage_law,
        "speed": speed,
        "passages": passages,
        "equal": equal,
        "jam errors": jam_errors,
        "jams": jam_table,
    },
    pictures={"orders": orders_picture},
)
