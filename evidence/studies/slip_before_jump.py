"""Whether the hoop slips before it jumps on a ramp.

Lift-off out of rolling, the slip before others, and the highest climb.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, NamedTuple

import littlewood as lw
import numpy as np
import numpy.typing as npt
from littlewood.plot.canvas import key
from littlewood.plot.sheet import listed, panels
from littlewood.style import FAINT, FINE, INK

from .attacks import said
from .hoops import DEGREE
from .page import table
from .roots import zero
from .study import Study

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = npt.NDArray[np.float64]

RADIUS, GRAVITY, FRAMES = 0.05, 9.81, 480.0
"""Of the films: m, m/s² and 1/s."""

SLOPES = (15.0, 30.0, 45.0)

LIKE_FILMS = "disc with a rod"
"""m1 = 2 m2, ℓ = 0.8 R."""


@dataclass(frozen=True)
class Body:
    """A hoop per unit of its mass: h and ϱ = Î/m."""

    h: float
    kappa: float

    @classmethod
    def of(cls, hoop: lw.Hoop) -> Body:
        """Return that of a hoop."""
        return cls(hoop.h, hoop.inertia_about_mass_centre / hoop.mass)

    def denominator(self, theta: Array | float) -> Array:
        """D/m."""
        result: Array = self.kappa + 1.0 + self.h**2 + 2.0 * self.h * np.cos(theta)
        return result

    def potential(self, psi: Array | float, slope: float) -> Array:
        """Energy of a hoop at rest, ψ = θ + α."""
        result: Array = self.h * np.cos(psi) - (np.asarray(psi) - slope) * math.sin(slope)
        return result

    def forces(
        self, theta: Array | float, u: Array | float, slope: Array | float
    ) -> tuple[Array, Array]:
        """N and F of rolling."""
        s, c, h = np.sin(theta), np.cos(theta), self.h
        down, along = np.cos(slope), np.sin(slope)
        spin = (h * s * (u + down) + (1.0 + h * c) * along) / self.denominator(theta)
        return down - h * s * spin - h * c * u, h * s * u + along - (1.0 + h * c) * spin

    def level(self, slope: float) -> float:
        """Energy of the orbit through θ = −α, u = 1/h."""
        return float(self.denominator(slope)) / (2.0 * self.h) + float(self.potential(0.0, slope))

    def least_friction(self, slope: float) -> float:
        """|F|/N of that orbit in the limit at its end: friction below it slips first."""
        s, c = math.sin(slope), math.cos(slope)
        return abs(self.kappa * c - self.h * s * s) / (s * (self.kappa + 1.0 + self.h * c))

    def painleve(self, slope: float) -> float:
        """Friction at which P vanishes at the end of that orbit."""
        arm = self.h * math.sin(slope)
        return (self.kappa + arm * arm) / (arm * (1.0 + self.h * math.cos(slope)))

    def releases(self, slope: float) -> list[float]:
        """The ψ at which the hoop released from rest is on that orbit, downhill.

        In the last few turns.
        """

        def excess(psi: float) -> float:
            return float(self.potential(psi, slope)) - self.level(slope)

        grid = np.linspace(0.0, -6.0 * math.pi, 4001)
        signs = [excess(float(psi)) > 0.0 for psi in grid]
        return [
            zero(excess, float(grid[i]), float(grid[i + 1]))
            for i in range(len(grid) - 1)
            if signs[i] != signs[i + 1]
        ]

    def slip_law(self, slope: float, mu: float, delta: float) -> float:
        """Slip before the jump of an orbit whose D u is greater by a small m δ.

        To leading order δ³ (μs = μk = μ).
        """
        s, c, h = math.sin(slope), math.cos(slope), self.h
        d, lever = float(self.denominator(slope)), 1.0 + h * c
        # N and F of rolling and w as constant + slope φ, φ = θ + α.
        normal = (-h * delta / d * (c + h * s * s / d), -s * (self.kappa + lever) / d)
        friction = (
            -h * s * delta / d**2 * (self.kappa + h * (c + h)),
            (self.kappa * c - h * s * s) / d,
        )
        leaves = -h * c * delta / (d * s)
        begins, direction = min(
            (-(friction[0] + way * mu * normal[0]) / (friction[1] + way * mu * normal[1]), way)
            for way in (1.0, -1.0)
        )
        solvability = self.kappa + h * s * (h * s + mu * direction * lever)
        growth = -d * (friction[1] + direction * mu * normal[1]) / solvability
        return abs(growth) * h * (leaves - begins) ** 3 / 6.0


def hoops() -> dict[str, lw.Hoop]:
    """Return the discs and hoops of the tables, μ = 1 on a level plane."""

    def rough(mass_ratio: float, offset: float, inertia: float) -> lw.Hoop:
        return lw.Hoop(mass_ratio=mass_ratio, offset=offset, inertia=inertia, mu_s=1.0, mu_k=1.0)

    return {
        LIKE_FILMS: rough(2.0, 0.8, 1.0),
        "loaded disc": rough(0.5, 0.8, 0.25),
        "rim hoop, h = 0.5": rough(1.0, 1.0, 1.0),
        "rim hoop, h = 0.8": rough(0.25, 1.0, 0.25),
    }


def on(hoop: lw.Hoop, slope: float, mu: float | None = None) -> lw.Hoop:
    """Return the same hoop on a slope, with this friction."""
    mu = hoop.mu_k if mu is None else mu
    return lw.Hoop(
        mass_ratio=hoop.mass_ratio,
        offset=hoop.offset,
        inertia=hoop.inertia,
        mu_s=mu,
        mu_k=mu,
        slope=slope,
    )


class Jump(NamedTuple):
    """The last slide before a jump: its slip, its time, ψ at the lift-off.

    And whether the hoop slipped before, too.
    """

    slip: float
    time: float
    psi: float
    slides: int
    unloaded: float
    """ψ at which N of rolling vanishes on the orbit on which the hoop rolled last."""


def jump(hoop: lw.Hoop, psi: float, rate: float = 0.0) -> Jump | None:
    """Return the first jump of a hoop released at ψ, if it jumps."""
    motion = hoop.simulate(theta=psi - hoop.slope, theta_rate=rate, max_transitions=60)
    slides, rolled = 0, None
    for phase, event in zip(motion.phases, motion.transitions, strict=False):
        begin, end = phase.start, event.state
        if phase.mode == "rolling":
            rolled = end
        if phase.mode == "sliding":
            slides += 1
        if event.to_mode == "flight":
            if phase.mode == "rolling":
                return Jump(0.0, 0.0, end.theta + hoop.slope, slides, end.theta + hoop.slope)
            slip = abs((end.x + end.theta) - (begin.x + begin.theta))
            unloaded = (
                math.nan
                if rolled is None
                else vanishing(hoop, rolled.theta, rolled.theta_rate) + hoop.slope
            )
            return Jump(slip, end.time - begin.time, end.theta + hoop.slope, slides, unloaded)
    return None


def vanishing(hoop: lw.Hoop, theta: float, rate: float) -> float:
    """Return the next θ at which N of rolling vanishes on an orbit, as if friction held it."""
    body, slope = Body.of(hoop), hoop.slope
    way = math.copysign(1.0, rate)
    energy = 0.5 * float(body.denominator(theta)) * rate * rate + float(
        body.potential(theta + slope, slope)
    )
    angles = theta + way * np.linspace(0.0, 2.0, 4001)

    def normal(angle: Array | float) -> Array:
        u = (
            2.0
            * (energy - body.potential(np.asarray(angle) + slope, slope))
            / body.denominator(angle)
        )
        return body.forces(angle, u, slope)[0]

    found = np.flatnonzero(normal(angles) < 0.0)
    if len(found) == 0 or found[0] == 0:
        return math.nan
    k = int(found[0])
    return zero(lambda angle: float(normal(angle)), float(angles[k - 1]), float(angles[k]))


@cache
def released(name: str, degrees: float) -> tuple[Jump, ...]:
    """Return the jumps of a body released from rest at each degree of a turn."""
    hoop = on(hoops()[name], degrees * DEGREE)
    found = (jump(hoop, psi * DEGREE) for psi in range(360))
    return tuple(one for one in found if one is not None)


def slips() -> list[str]:
    """Slip before a jump, over all angles of release."""
    rows = []
    clock = math.sqrt(RADIUS / GRAVITY)
    for name in hoops():
        for degrees in SLOPES if name == LIKE_FILMS else (30.0,):
            jumps = released(name, degrees)
            slip = np.array([one.slip for one in jumps]) * RADIUS * 1e3
            time = np.array([one.time for one in jumps]) * clock
            apart = np.array([one.psi - one.unloaded for one in jumps]) / DEGREE
            cells = [f"{np.median(slip):.2g}", f"{slip.max():.2g}", f"{time.max() * FRAMES:.1f}"]
            rows.append(
                [name, f"{degrees:g}", f"{len(jumps)}", *cells, f"{np.nanmax(np.abs(apart)):.1f}"]
            )
    heads = ["", "slope, °", "jump", "median, mm", "most, mm", "frames", "off by, °"]
    return table(heads, rows)


def critical() -> str:
    """The least friction of the jump without slip, and how far the hoop rolls to it from rest."""
    body = Body.of(hoops()[LIKE_FILMS])
    mus = ", ".join(f"{body.least_friction(degrees * DEGREE):.3f}" for degrees in SLOPES)
    angles = ", ".join(
        f"{-psi / DEGREE:.0f}°" for degrees in SLOPES for psi in body.releases(degrees * DEGREE)
    )
    slopes = ", ".join(f"{degrees:g}°" for degrees in SLOPES)
    return (
        f"$\\mu_c$ = {mus} on slopes of {slopes}, and the release from rest rolls through {angles}"
    )


def beside(hoop: lw.Hoop, delta: float) -> float:
    """Return the slip before the jump of an orbit with D u greater by m δ.

    From a place before its end.
    """
    body, slope = Body.of(hoop), hoop.slope
    psi = -0.15
    kinetic = body.level(slope) - float(body.potential(psi, slope))
    u = (2.0 * kinetic + delta) / float(body.denominator(psi - slope))
    found = jump(hoop, psi, math.sqrt(u))
    assert found is not None
    assert found.slides == 1
    return found.slip


# The highest climb.


def climb(turn: float) -> float:
    """Return Φ, the height over h R that a hoop climbs.

    From its unstable equilibrium, when it turns by an angle.
    """
    half = 0.5 * turn
    s = math.sin(half)
    return 2.0 * half * s * s / math.sqrt(half * half - half * math.sin(turn) + s * s)


def slope_of(turn: float) -> float:
    """Return sin α/h of the slope on which it turns by this angle."""
    return climb(turn) / turn


def logarithmic_slope(half: float) -> float:
    """Return d ln Φ/dy, y half the turn."""
    s = math.sin(half)
    return (
        1.0 / half
        + 2.0 / math.tan(half)
        - 2.0 * half * s * s / (half * half - half * math.sin(2.0 * half) + s * s)
    )


def best_turn() -> float:
    """Return the turn of the highest climb."""
    return 2.0 * zero(logarithmic_slope, 0.5, 3.0)


class Climb(NamedTuple):
    """A hoop released from rest that rolls uphill without slip, and the height gained over R."""

    height: float
    h: float
    slope: float
    psi: float


def friction_for(body: Body, slopes: Array, count: int) -> tuple[Array, Array, Array]:
    """Return ψ of each release on each slope, the height gained, and the friction needed.

    Rolling needs it on the way.
    """
    sine = np.sin(slopes)[:, None]
    turned = np.arcsin(sine / body.h)
    top, bottom = 2.0 * math.pi - turned, math.pi + turned
    psi = top - (top - bottom) * np.linspace(0.0, 1.0, count + 1)[None, :-1] ** 2
    energy = body.h * np.cos(psi) - psi * sine
    low, high = bottom - 2.0 * math.pi + 0.0 * psi, bottom + 0.0 * psi
    for _ in range(40):
        middle = 0.5 * (low + high)
        above = body.h * np.cos(middle) - middle * sine > energy
        low, high = np.where(above, middle, low), np.where(above, high, middle)
    most = np.zeros_like(psi)
    for share in 0.5 - 0.5 * np.cos(np.linspace(0.0, math.pi, 121)):
        here = high + (psi - high) * share
        kinetic = np.maximum(energy - body.h * np.cos(here) + here * sine, 0.0)
        theta = here - slopes[:, None]
        normal, friction = body.forces(
            theta, 2.0 * kinetic / body.denominator(theta), slopes[:, None]
        )
        most = np.maximum(
            most, np.where(normal > 0.0, np.abs(friction) / np.maximum(normal, 1e-300), np.inf)
        )
    return psi, (psi - high) * sine, most


FRICTIONS = (0.3, 0.5, 0.8, 1.2)


@cache
def climbs() -> dict[float, list[Climb]]:
    """Return the highest climbs of thin rim hoops without slip over h, on a grid.

    One for each friction.
    """
    found: dict[float, list[Climb]] = {mu: [] for mu in FRICTIONS}
    slopes = np.linspace(0.01, 1.25, 125)
    for h in map(float, np.linspace(0.04, 0.98, 48)):
        usable = slopes[np.sin(slopes) < h]
        psi, height, most = friction_for(Body(h, 1.0 - h * h), usable, 100)
        for mu in FRICTIONS:
            allowed = np.where(most <= mu, height, 0.0)
            i, k = np.unravel_index(int(np.argmax(allowed)), allowed.shape)
            found[mu].append(Climb(float(allowed[i, k]), h, float(usable[i]), float(psi[i, k])))
    return found


def best_numbers() -> str:
    """The optimum of the theorem."""
    turn = best_turn()
    return (
        f"$\\chi = {turn / DEGREE:.2f}°$, $\\sin\\alpha = {slope_of(turn):.4f}\\,h$, and the "
        "height is "
        f"${climb(turn):.4f}\\,hR$"
    )


def picture() -> Figure:
    """Slip before the jump over the release, and friction along orbits."""
    figure, axes = panels(2)
    left, right = axes
    for degrees, look in listed(SLOPES):
        hoop = on(hoops()[LIKE_FILMS], degrees * DEGREE)
        psi = np.linspace(-330.0, 30.0, 721)
        found = [jump(hoop, one * DEGREE) for one in psi]
        slip = [math.nan if one is None else max(one.slip, 1e-9) for one in found]
        left.semilogy(psi, slip, **look, label=f"slope {degrees:g}°")
        body = Body.of(hoop)
        for release in body.releases(hoop.slope):
            left.plot(
                (release / DEGREE + 330.0) % 360.0 - 330.0,
                1.5e-9,
                "^",
                color=look["color"],
                markersize=6,
            )
    left.plot([], [], "^", color=INK, markersize=6, label="no slip")
    left.axhline(1e-4 / RADIUS, color=INK, linewidth=FINE, label="0.1 mm")
    left.set(
        ylim=(1e-9, 2e-2),
        xlim=(-330, 30),
        xlabel="released at *ψ*, degrees",
        ylabel="slip before the jump, *R*",
    )
    left.set_xticks(range(-330, 31, 60))
    key(left, columns=3)
    hoop = on(hoops()[LIKE_FILMS], 30.0 * DEGREE)
    body, slope = Body.of(hoop), hoop.slope
    psi = np.linspace(-60.0, 20.0, 801) * DEGREE
    for delta, look in listed([-0.4, -0.1, 0.0, 0.1]):
        u = (2.0 * (body.level(slope) - body.potential(psi, slope)) + delta) / body.denominator(
            psi - slope
        )
        normal, friction = body.forces(psi - slope, u, slope)
        demand = np.where(normal > 1e-4, friction / normal, np.nan)
        right.plot(psi / DEGREE, demand, **look, label=f"*δ* = {delta:g}".replace("-", "−"))
    for limit in (1.0, -1.0):
        right.axhline(limit, color=FAINT, linewidth=FINE, label="±*μ*")
    right.set(xlim=(-60, 20), ylim=(-1.6, 1.6), xlabel="*ψ*, degrees", ylabel="*F*/*N* in rolling")
    key(right, columns=3)
    return figure


def heights() -> Figure:
    """Φ over the slope, and the climbs that friction allows."""
    figure, axes = panels(2)
    left, right = axes
    turns = np.linspace(0.02, 2.0 * math.pi - 0.02, 400)
    left.plot([slope_of(float(t)) for t in turns], [climb(float(t)) for t in turns], color=INK)
    best = best_turn()
    left.plot(slope_of(best), climb(best), "o", color=INK, label="*Φ*∗, the highest")
    left.set(xlim=(0, 1), ylim=(0, 2), xlabel="sin *α*/*h*", ylabel="height over *h*, *R*")
    key(left)
    for mu, look in listed(FRICTIONS):
        found = climbs()[mu]
        heights = [one.height for one in found]
        right.plot([one.h for one in found], heights, **look, label=f"*μ* = {mu:g}")
    line = np.array([0.0, 1.0])
    right.plot(line, climb(best) * line, color=FAINT, linewidth=FINE, label="*Φ*∗*h*")
    right.set(xlim=(0, 1), ylim=(0, 1.8), xlabel="*h* of a rim hoop", ylabel="highest climb, *R*")
    key(right, columns=3)
    return figure


STUDY = Study(
    name="slip-before-jump",
    texts={
        "attack": lambda: said("slip-before-jump", "leaves"),
        "attack climb": lambda: said("slip-before-jump", "climb"),
        "critical": critical,
        "slips": slips,
        "best": best_numbers,
    },
    pictures={"slip": picture, "heights": heights},
)
